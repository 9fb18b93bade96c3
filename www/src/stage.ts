// The stage: two canvases, one above the other, that show the state in the current view.

import { drawBase } from "./draw/base";
import { drawOverlay, type Tool } from "./draw/overlay";
import { DARK, LIGHT, type Palette } from "./draw/palette";
import { isLarge } from "./draw/shapes";
import { transitionPlace } from "./draw/transition";
import { findingAt, findingsOf } from "./findings";
import { distance, type Point } from "./geometry";
import { indexOf, nearestCorner, nearestOn, nearestOnTrack } from "./hit";
import type { PictureClient, TracedLine } from "./large/picture-client";
import {
  type Handle,
  handles,
  linesOf,
  locate,
  type PointRef,
  samePoint,
  segmentAtLine,
} from "./part";
import { contourAt, forRuns, isResultOf, lineOf, lineOfMove, radiusOn } from "./result";
import type { State, Store } from "./state";
import { fitted, panned, type Size, sightOf, toScreen, toWorld, type View, zoomed } from "./view";

/** How near the pointer must be to the tool path for the tool to follow it [px]. */
const TOOL_REACH = 70;
/** How near the pointer must be to a corner to show its construction [px]. */
const CORNER_REACH = 44;
/** How near the pointer must be to a move for its line to be marked [px]. */
const LINE_REACH = 9;
/** How near to the edge a point is hard to see [px]. */
const EDGE = 16;
/** How near the pointer must be to the mark of a gouge to show it [px]. */
const FINDING_REACH = 14;
/** Room around the part [px]. */
const MARGIN = 40;
/** More points than this are a smear; then only those that are taken hold of show. */
const MOST_HANDLES = 500;

/** Shows the state on a pair of canvases. */
export class Stage {
  readonly overlay: HTMLCanvasElement;
  #base: HTMLCanvasElement;
  #store: Store;
  #view: View = { scale: 4, x: 100, y: 300 };
  #size: Size = { width: 1, height: 1 };
  #palette: Palette = LIGHT;
  #baseStale = true;
  #frame = 0;
  #fitWanted = true;
  /** Whether the whole part is shown, and not what someone has moved or scaled to. */
  #isFitted = true;
  #pointer: Point | undefined;
  #hover: PointRef | undefined;
  #hoverSegment: number | undefined;
  #touch = false;
  #onView: (view: View, pointer: Point | undefined) => void;
  #viewListeners: (() => void)[] = [];
  #drawing: PictureClient;
  #traced: TracedLine | undefined;
  /** The line whose moves are to be brought into sight once they are found. */
  #revealing: number | undefined;

  constructor(
    element: HTMLElement,
    store: Store,
    drawing: PictureClient,
    onView: (view: View, pointer: Point | undefined) => void,
  ) {
    this.#base = element.querySelector<HTMLCanvasElement>("canvas.base") as HTMLCanvasElement;
    this.overlay = element.querySelector<HTMLCanvasElement>("canvas.overlay") as HTMLCanvasElement;
    // Keys go to the drawing, not to the reading cursor of a screen reader.
    this.overlay.setAttribute("role", "application");
    this.overlay.setAttribute("aria-roledescription", "drawing");
    this.#store = store;
    this.#drawing = drawing;
    this.#onView = onView;
    new ResizeObserver(() => this.#resize()).observe(element);
    window.addEventListener("resize", () => {
      this.#fitWanted ||= this.#isFitted;
    });
    store.subscribe((state, before) => this.#changed(state, before));
    for (const name of ["focus", "blur"]) this.overlay.addEventListener(name, () => this.redraw());
  }

  /** The view as it is. */
  get view(): View {
    return this.#view;
  }

  /** The size of the canvas [px]. */
  get size(): Size {
    return this.#size;
  }

  /** Tells `listener` when the picture was moved or scaled. */
  onViewChange(listener: () => void): void {
    this.#viewListeners.push(listener);
  }

  /** Chooses the light or the dark palette. */
  setScheme(scheme: "light" | "dark"): void {
    this.#palette = scheme === "dark" ? DARK : LIGHT;
    this.#redrawAll();
  }

  /** Shows the whole part, as soon as it is known. */
  fit(): void {
    const { result } = this.#store.state;
    const box = result?.box;
    if (!box || this.#size.width < 2) {
      this.#fitWanted = true;
      return;
    }
    this.#fitWanted = false;
    this.#isFitted = true;
    const small = Math.min(this.#size.width, this.#size.height) < 480;
    const margin = small ? 32 : MARGIN;
    this.#setView(
      fitted(box, this.#size, {
        left: margin + 16,
        right: margin,
        top: margin,
        bottom: margin + 16,
      }),
    );
  }

  /** Shows the part as a whole with the next result or the next size. */
  fitNext(): void {
    this.#fitWanted = true;
  }

  /** Shows the whole part in the room that there is now, if it was shown before. */
  keepFit(): void {
    if (this.#isFitted) this.fit();
  }

  /** Moves the picture [px]. */
  pan(dx: number, dy: number): void {
    this.#isFitted = false;
    this.#setView(panned(this.#view, dx, dy));
  }

  /** Scales the picture about a point of the canvas, by default its middle. */
  zoom(factor: number, at: Point = [this.#size.width / 2, this.#size.height / 2]): void {
    this.#isFitted = false;
    this.#setView(zoomed(this.#view, at, factor));
  }

  /** Brings a point into sight that is at the edge of the picture or beyond it. */
  reveal(point: Point): void {
    const [x, y] = toScreen(this.#view, point);
    const { width, height } = this.#size;
    const isSeen = (at: number, size: number) => at >= EDGE && at <= size - EDGE;
    if (isSeen(x, width) && isSeen(y, height)) return;
    const [mx, my] = [width * 0.12, height * 0.12];
    const dx = x < mx ? mx - x : x > width - mx ? width - mx - x : 0;
    const dy = y < my ? my - y : y > height - my ? height - my - y : 0;
    if (dx !== 0 || dy !== 0) this.pan(dx, dy);
  }

  /** Brings the moves of a line of the text into sight. */
  revealLine(line: number): void {
    const { result } = this.#store.state;
    if (!result) return;
    if (result.long) {
      this.#revealing = line;
      this.#drawing.trace(line);
      return;
    }
    const { points } = result.path;
    let at: Point | undefined;
    forRuns(result.path, (move, _, last) => {
      if (!at && lineOfMove(result, move) === line) {
        at = [points[2 * last] as number, points[2 * last + 1] as number];
      }
    });
    if (at) this.reveal(at);
  }

  /** Takes the moves of a line that was asked for. */
  showTraced(traced: TracedLine): void {
    this.#traced = traced;
    const [x, y] = traced.points.subarray(-2);
    if (this.#revealing === traced.line && x !== undefined && y !== undefined) this.reveal([x, y]);
    this.#revealing = undefined;
    this.redraw();
  }

  /** Draws the static layer anew with the next frame. */
  refresh(): void {
    this.#redrawAll();
  }

  /** Tells where the pointer is, and what it is over. */
  point(
    pointer: Point | undefined,
    hover: PointRef | undefined,
    segment: number | undefined,
    touch: boolean,
  ): void {
    this.#pointer = pointer;
    this.#hover = hover;
    this.#hoverSegment = segment;
    this.#touch = touch;
    const { result, corner } = this.#store.state;
    if (result && pointer) {
      const reach = CORNER_REACH / this.#view.scale;
      const near = nearestCorner(result, toWorld(this.#view, pointer), reach);
      if (near !== undefined && near !== corner) this.#store.set({ corner: near });
    }
    const world = pointer && toWorld(this.#view, pointer);
    const found = result && world && findingAt(result, world, FINDING_REACH / this.#view.scale);
    if (found?.key !== this.#store.state.finding) this.#store.set({ finding: found?.key });
    this.#pointAtLine(world);
    this.#onView(this.#view, pointer);
    this.redraw();
  }

  #pointAtLine(at: Point | undefined): void {
    const { result, hover } = this.#store.state;
    const reach = LINE_REACH / this.#view.scale;
    if (at && result?.long) {
      this.#drawing.seek(at, reach);
      return;
    }
    const near = at && result && nearestOn(result.path, at, reach);
    const line = near && result ? lineOfMove(result, near.owner) : undefined;
    if (line !== hover) this.#store.set({ hover: line });
  }

  /** The points that can be moved now. */
  handles(): readonly Handle[] {
    const { text, part, partText } = this.#store.document;
    return text === partText ? handles(part) : [];
  }

  /** The points that can be moved and seen, where they are now; too many of them say nothing. */
  #visibleHandles(): readonly Handle[] {
    const { live, selection } = this.#store.state;
    const { min, max } = sightOf(this.#view, this.#size, MARGIN);
    const seen: Handle[] = [];
    for (const handle of this.handles()) {
      const [x, y] = handle.at;
      if (x < min[0] || x > max[0] || y < min[1] || y > max[1]) continue;
      seen.push(live && samePoint(handle.ref, live.ref) ? live : handle);
    }
    if (seen.length <= MOST_HANDLES) return seen;
    return seen.filter(({ ref }) => samePoint(ref, selection) || samePoint(ref, this.#hover));
  }

  /** Draws the live layer with the next frame. */
  redraw(): void {
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  #changed(state: State, before: State): void {
    if (state.live !== before.live) this.#baseStale = true;
    const line = lineShown(state);
    if (state.result?.long && line !== this.#traced?.line) {
      if (line !== undefined) this.#drawing.trace(line);
      else this.#traced = undefined;
    }
    if (state.result !== before.result) {
      this.#baseStale = true;
      if (this.#fitWanted && isResultOf(state.result, this.#store.document)) {
        this.fit();
      }
    }
    this.redraw();
  }

  #redrawAll(): void {
    this.#baseStale = true;
    this.redraw();
  }

  #setView(view: View): void {
    this.#view = view;
    this.#onView(view, this.#pointer);
    for (const listener of this.#viewListeners) listener();
    this.#redrawAll();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.overlay;
    const before = this.#size;
    this.#size = { width, height };
    const ratio = devicePixelRatio || 1;
    for (const canvas of [this.#base, this.overlay]) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    if (before.width < 2 || this.#fitWanted) this.fit();
    else
      this.#setView(panned(this.#view, (width - before.width) / 2, (height - before.height) / 2));
    this.#baseStale = true;
    cancelAnimationFrame(this.#frame);
    this.#draw();
  }

  #draw(): void {
    this.#frame = 0;
    const { result, live } = this.#store.state;
    const common = { view: this.#view, size: this.#size, palette: this.#palette, result };
    if (this.#baseStale) {
      this.#baseStale = false;
      drawBase(context(this.#base), { ...common, live, drawing: this.#drawing });
    }
    drawOverlay(context(this.overlay), {
      ...common,
      handles: this.#visibleHandles(),
      selection: this.#store.state.selection,
      hover: this.#hover,
      focused: document.activeElement === this.overlay,
      touch: this.#touch,
      corner: this.#store.state.corner,
      tool: this.#toolPlace(),
      ...this.#highlight(),
      traced: this.#traced?.points,
      chosen: this.#store.state.chosen,
      finding: result && findingsOf(result).find(({ key }) => key === this.#store.state.finding),
    });
  }

  /** The tool stands at the corner that is shown, or follows the pointer along its path. */
  #toolPlace(): Tool | undefined {
    const { result, corner, probe, played } = this.#store.state;
    if (!result) return undefined;
    const tool = (at: Point, line: number | undefined) => {
      return { at, radius: Math.abs(radiusOn(result, contourAt(result, line))) };
    };
    if (played) return { ...tool(played.at, played.line), isRapid: played.isRapid };
    if (probe) return tool(probe, lineOfMove(result, nearestOn(result.path, probe)?.owner ?? 0));
    const transition = corner === undefined ? undefined : result.transitions[corner];
    const there = transition && tool(transitionPlace(transition, result), lineOf(transition));
    if (!this.#pointer) return there;
    const pointer = toWorld(this.#view, this.#pointer);
    if (there && distance(there.at, pointer) * this.#view.scale < 16) return there;
    const reach = TOOL_REACH / this.#view.scale;
    const { live } = this.#store.state;
    const dragged = live && nearestOnTrack(live.path, live.starts, pointer, reach);
    if (dragged) return { at: dragged.point, radius: Math.abs(radiusOn(result, live.contour)) };
    const near = nearestOn(result.path, pointer, reach);
    if (!near) return there;
    return tool(near.point, lineOfMove(result, near.owner));
  }

  #highlight(): { segment: number | undefined; lines: readonly number[] } {
    const { part } = this.#store.document;
    const { selection, caret, result, hover, pointed } = this.#store.state;
    // A segment of very many spans would take longer to highlight than to draw.
    if (result && isLarge(result)) return { segment: undefined, lines: [] };
    const own = (contour: number, segment: number) => ({
      segment: indexOf(part, contour, segment),
      lines: linesOf(part.contours[contour]?.segments[segment] ?? { kind: "spline", points: [] }),
    });
    if (caret !== undefined) {
      const found = segmentAtLine(part, caret);
      return found ? own(found.contour, found.segment) : { segment: undefined, lines: [caret] };
    }
    if (this.#hoverSegment !== undefined) return { segment: this.#hoverSegment, lines: [] };
    if (selection && selection.segment >= 0 && locate(part, selection)) {
      return own(selection.contour, selection.segment);
    }
    const line = hover ?? pointed;
    return { segment: undefined, lines: line === undefined ? [] : [line] };
  }
}

/** The line whose moves are highlighted in a very long program. */
function lineShown({ caret, hover, pointed }: State): number | undefined {
  return hover ?? caret ?? pointed;
}

function context(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const found = canvas.getContext("2d");
  if (!found) throw new Error("this browser cannot draw on a canvas");
  const ratio = canvas.width / Math.max(1, canvas.clientWidth);
  found.setTransform(ratio, 0, 0, ratio, 0, 0);
  return found;
}
