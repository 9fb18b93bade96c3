// The picture in space: a canvas over the plane, turned by mouse, fingers or keys.

import { DARK, LIGHT, type Palette } from "../draw/palette";
import { format } from "../expression";
import { distance, type Point } from "../geometry";
import { Choice, element, iconButton } from "../panels/elements";
import { contourAt, type Result, radiusOn } from "../result";
import type { Stage } from "../stage";
import type { State, Store } from "../state";
import type { Size } from "../view";
import { zoomByWheel } from "../wheel";
import {
  boxOfStrokes,
  type Camera,
  depthsOf,
  fitted,
  lineAt,
  panned,
  projection,
  turned,
  VIEWS,
  zoomed,
} from "./camera";
import { drawMarks, drawMoves } from "./draw";
import type { Box3 } from "./strokes";

const ICON = "M12 3l8 4.5v9L12 21l-8-4.5v-9zM12 12l8-4.5M12 12v9M12 12L4 7.5";
/** Room around the moves, for the axes [px]; and in a small picture. */
const MARGIN = 56;
const SMALL_MARGIN = 32;
/** A side that makes a picture small [px]. */
const SMALL = 480;
/** How far a pixel of dragging turns [rad]. */
const TURN = 0.01;
/** How far an arrow key turns [rad]. */
const KEY_TURN = Math.PI / 36;
/** How far an arrow key moves [px]. */
const KEY_PAN = 40;
/** How near the pointer must be to a move [px]. */
const REACH = 9;
/** Vertices that are drawn while the picture moves. */
const MOST_MOVING = 24_000;
/** After this without another move of the picture all of them are drawn [ms]. */
const SETTLED = 150;
/** Depths that are told from each other. */
const BANDS = 6;
/** How far a click may slip [px]. */
const SLIP = 4;

const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** What is derived of a result. */
interface Known {
  readonly of: Result;
  /** The box around what is to be in sight. */
  readonly seen: Box3 | undefined;
  readonly depths: readonly number[];
}

/** Shows the moves in space while the state asks for it. */
export class SpaceView {
  #canvas = element("canvas", {
    class: "space",
    tabindex: 0,
    role: "application",
    "aria-roledescription": "drawing in space",
    "aria-label":
      "Tool path in space. Arrow keys turn it, with Shift they move it, plus and minus zoom.",
    "aria-describedby": "description",
  });
  #views: Choice;
  #store: Store;
  #camera: Camera = { ...VIEWS.iso, scale: 1, target: [0, 0, 0] };
  #size: Size = { width: 1, height: 1 };
  #palette: Palette = LIGHT;
  #frame = 0;
  /** Whether everything is shown, and not what someone has moved or scaled to. */
  #isFitted = true;
  /** All but what is marked and the tool, as it was last drawn. */
  #moves = element("canvas");
  #isStale = true;
  /** Set while the picture moves. */
  #settling = 0;
  /** Where mouse and fingers hold the picture. */
  #pointers = new Map<number, Point>();
  #extents = element("output", {
    class: "space-extents",
    "aria-label": "Extents of what is cut",
    "aria-live": "off",
  });
  #known: Known | undefined;

  constructor(parent: HTMLElement, buttons: HTMLElement, stage: Stage, store: Store) {
    this.#store = store;
    const names = { iso: "Iso", top: "Top", front: "Front", right: "Right" };
    this.#views = new Choice("space-view", "View", names, (name) => {
      this.#camera = { ...this.#camera, ...VIEWS[name as keyof typeof VIEWS] };
      this.fit();
    });
    this.#views.root.classList.add("space-views");
    parent.append(this.#canvas, this.#views.root, this.#extents);
    const keys = "the tool path in space, with its extents";
    const button = iconButton("3D view", ICON, keys, "3D");
    button.setAttribute("aria-pressed", "false");
    buttons.prepend(button);
    const show = (isShown: boolean) => {
      parent.classList.toggle("in-space", isShown);
      button.setAttribute("aria-pressed", String(isShown));
      // What the pointer showed in the plane is over.
      stage.point(undefined, undefined, undefined, false);
      if (isShown) this.#resize();
    };
    button.addEventListener("click", () => store.set({ space: !store.state.space }));
    store.subscribe((state, before) => {
      if (state.space !== before.space) show(state.space);
      else if (state.space) this.#changed(state, before);
    });
    new ResizeObserver(() => this.#resize()).observe(parent);
    this.#connect();
    this.#views.show("iso");
  }

  /** Chooses the light or the dark palette. */
  setScheme(scheme: "light" | "dark"): void {
    this.#palette = scheme === "dark" ? DARK : LIGHT;
    this.#isStale = true;
    this.#redraw();
  }

  /** Shows everything. */
  fit(): void {
    this.#isFitted = true;
    const box = this.#derived()?.seen;
    const { width, height } = this.#size;
    const margin = Math.min(width, height) < SMALL ? SMALL_MARGIN : MARGIN;
    if (box) this.#camera = fitted(this.#camera, box, this.#size, margin);
    this.#isStale = true;
    this.#redraw();
  }

  /** Goes nearer or farther, about a place of the canvas, by default its middle. */
  zoom(factor: number, at: Point = [this.#size.width / 2, this.#size.height / 2]): void {
    this.#isFitted = false;
    this.#look(zoomed(this.#camera, factor, at, this.#size));
  }

  #pan(dx: number, dy: number): void {
    this.#isFitted = false;
    this.#look(panned(this.#camera, dx, dy));
  }

  #turn(yaw: number, pitch: number): void {
    this.#views.show(undefined);
    this.#look(turned(this.#camera, yaw, pitch));
  }

  /** Looks from elsewhere: roughly as long as the picture moves, then at all there is. */
  #look(camera: Camera): void {
    this.#camera = camera;
    this.#isStale = true;
    this.#settle();
    this.#redraw();
  }

  /** Draws all there is once nothing holds or moves the picture any more. */
  #settle(): void {
    clearTimeout(this.#settling);
    this.#settling = window.setTimeout(() => {
      if (this.#pointers.size > 0) {
        this.#settle();
        return;
      }
      this.#settling = 0;
      if (this.#thinning() === 1) return;
      this.#isStale = true;
      this.#redraw();
    }, SETTLED);
  }

  /** Of how many vertices one is drawn while the picture moves. */
  #thinning(): number {
    const strokes = this.#store.state.result?.space.strokes ?? [];
    const vertices = strokes.reduce((sum, { lines }) => sum + lines.length, 0);
    return Math.max(1, Math.ceil(vertices / MOST_MOVING));
  }

  #changed(state: State, before: State): void {
    if (state.result !== before.result) this.#isStale = true;
    if (state.result !== before.result && this.#isFitted) this.fit();
    else this.#redraw();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    if (width === 0) return;
    this.#size = { width, height };
    const ratio = devicePixelRatio || 1;
    for (const canvas of [this.#canvas, this.#moves]) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    this.#isStale = true;
    if (this.#isFitted) this.fit();
    cancelAnimationFrame(this.#frame);
    this.#draw();
  }

  #redraw(): void {
    if (this.#store.state.space) this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  /** What is derived of the result, once for each. */
  #derived(): Known | undefined {
    const { result } = this.#store.state;
    if (!result || this.#known?.of === result) return result && this.#known;
    const { strokes, cut } = result.space;
    const depths = depthsOf(strokes, BANDS);
    this.#known = { of: result, seen: boxOfStrokes(strokes), depths };
    this.#extents.textContent = cut ? extentsOf(cut) : "";
    return this.#known;
  }

  #draw(): void {
    this.#frame = 0;
    const context = this.#canvas.getContext("2d");
    const below = this.#moves.getContext("2d");
    if (!context || !below) return;
    const { result, hover, caret, pointed, played } = this.#store.state;
    const ratio = this.#canvas.width / Math.max(1, this.#size.width);
    const known = this.#derived();
    const strokes = result?.space.strokes ?? [];
    const sight = { camera: this.#camera, size: this.#size, palette: this.#palette, strokes };
    if (this.#isStale) {
      below.setTransform(ratio, 0, 0, ratio, 0, 0);
      const depths = known?.depths ?? [];
      const thin = this.#settling ? this.#thinning() : 1;
      drawMoves(below, { ...sight, box: result?.space.cut, depths, thin });
      this.#isStale = false;
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.#moves, 0, 0);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawMarks(context, {
      ...sight,
      line: hover ?? caret ?? pointed,
      tool: result &&
        played && {
          at: played.point,
          radius: Math.abs(radiusOn(result, contourAt(result, played.line))),
          axis: spindleOf(result),
        },
    });
  }

  /** Chooses the line of the move at a place. */
  #pick(at: Point): void {
    const toScreen = projection(this.#camera, this.#size);
    const line = lineAt(this.#store.state.result?.space.strokes ?? [], toScreen, at, REACH);
    this.#store.set({ pointed: line, caret: undefined, selection: undefined, chosen: undefined });
  }

  #connect(): void {
    const canvas = this.#canvas;
    const pointers = this.#pointers;
    let pressed: Point | undefined;
    const place = (event: MouseEvent): Point => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, place(event));
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add("by-pointer");
      canvas.focus({ preventScroll: true });
      pressed = pointers.size === 1 ? place(event) : undefined;
      event.preventDefault();
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const at = place(event);
      pointers.set(event.pointerId, at);
      if (pressed && distance(pressed, at) < SLIP) return;
      pressed = undefined;
      const [dx, dy] = [at[0] - before[0], at[1] - before[1]];
      const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        this.zoom(Math.max(1, distance(at, other)) / Math.max(1, distance(before, other)), other);
        this.#pan(dx / 2, dy / 2);
      } else if (event.shiftKey || event.buttons !== 1) this.#pan(dx, dy);
      else this.#turn(-dx * TURN, dy * TURN);
    });
    const finish = (event: PointerEvent) => {
      if (!pointers.delete(event.pointerId)) return;
      if (pressed && event.type === "pointerup") this.#pick(pressed);
      pressed = undefined;
    };
    canvas.addEventListener("pointerup", finish);
    canvas.addEventListener("pointercancel", finish);
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    zoomByWheel(canvas, (factor, event) => this.zoom(factor, place(event)));
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    this.#canvas.classList.remove("by-pointer");
    const arrow = ARROWS[event.key];
    if (arrow && event.shiftKey) this.#pan(-KEY_PAN * arrow[0], -KEY_PAN * arrow[1]);
    else if (arrow) this.#turn(-KEY_TURN * arrow[0], KEY_TURN * arrow[1]);
    else if (event.key === "f" || event.key === "F") this.fit();
    else if (event.key === "+" || event.key === "=") this.zoom(1.25);
    else if (event.key === "-") this.zoom(1 / 1.25);
    else return;
    event.preventDefault();
  }
}

/** The axis that the tool turns about: across the plane that it is compensated in, else z. */
function spindleOf({ axes, contours }: Result): 0 | 1 | 2 {
  return contours.length > 0 ? ((3 - axes[0] - axes[1]) as 0 | 1 | 2) : 2;
}

/** How far a box goes along each axis, a line for each. */
function extentsOf({ min, max }: Box3): string {
  // Arcs are chords here: a third decimal would be theirs.
  const said = (value: number) => format(value, 2);
  const rows = [0, 1, 2].map((axis) => {
    const [from, to] = [said(min[axis] as number), said(max[axis] as number)];
    const length = said((max[axis] as number) - (min[axis] as number));
    return { name: "XYZ"[axis], range: from === to ? from : `${from} … ${to}`, length };
  });
  const width = Math.max(...rows.map(({ range }) => range.length));
  return rows.map((row) => `${row.name} ${row.range.padEnd(width)}  ${row.length} mm`).join("\n");
}
