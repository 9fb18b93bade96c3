// Mouse, pen and touch on the canvas: drag points, pan, pinch, insert.

import { insert } from "./actions";
import { distance, type Point, roundTo } from "./geometry";
import { nearestOn, segmentAt, typePointAfter } from "./hit";
import type { Drag } from "./live/drag";
import { nearestHandle, type PointRef, pointAtLine } from "./part";
import type { Stage } from "./stage";
import type { Store } from "./state";
import { dragStep, toScreen, toWorld } from "./view";
import { zoomByWheel } from "./wheel";

/** How near a pointer must be to a point to take hold of it [px]: fingers need 44 px targets. */
const GRAB = { mouse: 11, pen: 16, touch: 26 } as const;
/** How near a segment must be for a double-click to insert a point on it [px]. */
const SEGMENT_REACH = { mouse: 9, pen: 14, touch: 24 } as const;
/** How far a pointer moves before a press is a drag [px]. */
const SLACK = { mouse: 2, pen: 4, touch: 7 } as const;
/** Two taps within this time are a double tap [ms]. */
const DOUBLE_TAP = 350;

type Device = keyof typeof GRAB;

/** What the first pointer is doing. */
type Gesture =
  | { kind: "point"; ref: PointRef; grip: Point; from: Point; name: string; moved: boolean }
  | { kind: "pan"; from: Point; moved: boolean }
  | { kind: "pinch" };

/** Connects the pointers to the stage and the store. */
export function connectPointers(stage: Stage, store: Store, drag: Drag): void {
  const canvas = stage.overlay;
  const pointers = new Map<number, Point>();
  let gesture: Gesture | undefined;
  let spaceHeld = false;
  let count = 0;
  let lastTap: { time: number; at: Point } | undefined;

  const place = (event: PointerEvent | MouseEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const device = (event: PointerEvent): Device =>
    event.pointerType === "touch" || event.pointerType === "pen" ? event.pointerType : "mouse";
  const handleAt = (at: Point, reach: number) =>
    nearestHandle(stage.handles(), toWorld(stage.view, at), reach / stage.view.scale);
  const segmentNear = (at: Point, reach: number) => {
    const { result } = store.state;
    if (!result || result.text !== store.document.text) return undefined;
    const within = reach / stage.view.scale;
    return nearestOn(result.programmed, toWorld(stage.view, at), within * (1 + 1e-9));
  };

  const insertAt = (at: Point, reach: number): void => {
    const { result } = store.state;
    const near = segmentNear(at, reach);
    const found = near && segmentAt(store.document.part, near.owner);
    if (!result || !near || !found || handleAt(at, 6)) return;
    const contour = store.document.part.contours[found.contour];
    const segment = contour?.segments[found.segment];
    if (!contour?.editable || !segment) return;
    const points = segment.kind === "spline" ? segment.points.map((node) => node.at) : [];
    const before = typePointAfter(result.programmed, near, points);
    // Few digits, unless they would leave the line or the circle.
    const step = dragStep(stage.view.scale);
    const round: Point = [roundTo(near.point[0], step), roundTo(near.point[1], step)];
    const stays =
      segment.kind === "spline" ||
      (segment.kind === "line" && (nearestOn(result.programmed, round)?.distance ?? 1) < 1e-6);
    const point = stays ? round : near.point;
    insert(store, found.contour, found.segment, point, before);
  };

  canvas.addEventListener("pointerdown", (event) => {
    const at = place(event);
    pointers.set(event.pointerId, at);
    canvas.setPointerCapture(event.pointerId);
    // Who points sees where; the ring is for those who came by keys.
    canvas.classList.add("by-pointer");
    canvas.focus({ preventScroll: true });
    if (pointers.size > 1) {
      gesture = { kind: "pinch" };
      drag.end();
      store.settle();
      return;
    }
    const handle = handleAt(at, GRAB[device(event)]);
    const pans = event.button === 1 || spaceHeld || event.button === 2;
    if (handle && !pans) {
      const [x, y] = toScreen(stage.view, handle.at);
      count += 1;
      gesture = {
        kind: "point",
        ref: handle.ref,
        grip: [x - at[0], y - at[1]],
        from: at,
        name: `drag ${count}`,
        moved: false,
      };
      store.set({ selection: handle.ref, caret: undefined, chosen: undefined });
    } else {
      gesture = { kind: "pan", from: at, moved: false };
    }
    event.preventDefault();
  });

  canvas.addEventListener("pointermove", (event) => {
    const at = place(event);
    const before = pointers.get(event.pointerId);
    if (!before) {
      const handle = handleAt(at, GRAB[device(event)]);
      const segment = handle ? undefined : segmentNear(at, SEGMENT_REACH.mouse)?.owner;
      canvas.style.cursor = handle ? "grab" : segment !== undefined ? "copy" : "";
      stage.point(at, handle?.ref, segment, event.pointerType === "touch");
      return;
    }
    if (gesture?.kind === "pinch") {
      pinch(event.pointerId, before, at);
    } else if (gesture?.kind === "point") {
      if (!gesture.moved && distance(at, gesture.from) > SLACK[device(event)]) {
        gesture.moved = true;
        drag.begin(gesture.ref);
      }
      if (gesture.moved) {
        canvas.style.cursor = "grabbing";
        const to = toWorld(stage.view, [at[0] + gesture.grip[0], at[1] + gesture.grip[1]]);
        const step = event.altKey ? undefined : dragStep(stage.view.scale);
        drag.step(gesture.ref, to, gesture.name, step);
      }
      stage.point(at, gesture.ref, undefined, event.pointerType === "touch");
    } else if (gesture?.kind === "pan") {
      gesture.moved ||= distance(at, gesture.from) > SLACK[device(event)];
      if (gesture.moved) {
        canvas.style.cursor = "move";
        stage.pan(at[0] - before[0], at[1] - before[1]);
      }
    }
    pointers.set(event.pointerId, at);
  });

  /** Two pointers: the picture keeps both points below the fingers, as far as it can. */
  function pinch(id: number, before: Point, at: Point): void {
    const other = [...pointers].find(([key]) => key !== id)?.[1];
    if (!other) return;
    const factor = Math.max(1, distance(at, other)) / Math.max(1, distance(before, other));
    stage.zoom(factor, other);
    stage.pan((at[0] - before[0]) / 2, (at[1] - before[1]) / 2);
  }

  const finish = (event: PointerEvent): void => {
    if (!pointers.delete(event.pointerId)) return;
    const ended = gesture;
    if (pointers.size > 0) {
      gesture = { kind: "pinch" };
      return;
    }
    gesture = undefined;
    canvas.style.cursor = "";
    drag.end();
    store.settle();
    const at = place(event);
    if (ended?.kind === "pan" && !ended.moved && event.type === "pointerup") tap(event, at);
    else if (event.type === "pointerup") lastTap = undefined;
    if (event.pointerType === "touch") stage.point(undefined, undefined, undefined, true);
  };

  /** A tap beside all points clears the selection or chooses the segment; two insert a point. */
  function tap(event: PointerEvent, at: Point): void {
    const kind = device(event);
    const again =
      lastTap && event.timeStamp - lastTap.time < DOUBLE_TAP && distance(lastTap.at, at) < 20;
    lastTap = again ? undefined : { time: event.timeStamp, at };
    if (again) {
      insertAt(at, SEGMENT_REACH[kind]);
      return;
    }
    const near = segmentNear(at, SEGMENT_REACH[kind]);
    const found = near && segmentAt(store.document.part, near.owner);
    const contour = found && store.document.part.contours[found.contour];
    const segment = found && contour?.segments[found.segment];
    const line = segment?.kind === "spline" ? segment.points[0]?.line : segment?.end.line;
    const selection = line === undefined ? undefined : pointAtLine(store.document.part, line);
    const pointed = selection ? undefined : store.state.hover;
    store.set({ selection, caret: undefined, chosen: undefined, pointed });
  }

  canvas.addEventListener("pointerup", finish);
  canvas.addEventListener("pointercancel", finish);
  canvas.addEventListener("pointerleave", () => {
    if (pointers.size === 0) stage.point(undefined, undefined, undefined, false);
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  zoomByWheel(canvas, (factor, event) => stage.zoom(factor, place(event)));
  for (const [name, held] of [
    ["keydown", true],
    ["keyup", false],
  ] as const) {
    canvas.addEventListener(name, (event) => {
      if ((event as KeyboardEvent).code !== "Space") return;
      spaceHeld = held;
      event.preventDefault();
    });
  }
  canvas.addEventListener("blur", () => {
    spaceHeld = false;
    canvas.classList.remove("by-pointer");
  });
}
