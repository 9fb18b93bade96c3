// Path2D objects of a result in millimetres, made once and kept as long as the result.

import type { Point } from "../geometry";
import { kindOf } from "../large/strokes";
import { waysInPlane } from "../large/ways";
import type { LivePicture } from "../live/picture";
import {
  contourAt,
  FIELD,
  forRuns,
  type Lines,
  lineOfMove,
  RAPID,
  type Result,
  roleOf,
} from "../result";
import { type Size, toWorld, type View } from "../view";
import { trackOf, type Window } from "./track";

/** A contour that encloses an area. */
export interface ClosedShape {
  readonly path: Path2D;
  /** [mm²], positive counter-clockwise. */
  readonly area: number;
  /** Index of the contour. */
  readonly contour: number;
}

/** What the static layer strokes and fills. */
export interface Shapes {
  /** The programmed contours. */
  readonly outlines: readonly Path2D[];
  readonly closed: readonly ClosedShape[];
  /** The tool path where it is compensated, one for each contour. */
  readonly cuts: readonly Path2D[];
  /** Lead-ins and lead-outs. */
  readonly leads: Path2D;
  /** Moves that cut without being compensated. */
  readonly free: Path2D;
  readonly rapids: Path2D;
}

/** What is seen of a result. */
export interface Seen {
  readonly view: View;
  readonly size: Size;
  /** The contour that is dragged, if the result does not know yet where to. */
  readonly live: LivePicture | undefined;
}

/** Vertices from which on only those are drawn that the view can show. */
const MANY = 40_000;

const known = new WeakMap<Result, Shapes>();
const traced = new WeakMap<Result, Seen & { shapes: Shapes }>();

/** The shapes of a result. */
export function shapesOf(result: Result, seen: Seen): Shapes {
  const shapes = isLarge(result) ? tracedShapes(result, seen) : allShapes(result);
  return seen.live ? withLive(shapes, seen.live, result, seen) : shapes;
}

/** Whether a result has too many vertices to draw them all. */
export function isLarge({ programmed, path }: Result): boolean {
  return programmed.points.length + path.points.length > 2 * MANY;
}

function allShapes(result: Result): Shapes {
  const before = known.get(result);
  if (before) return before;
  const everything = { min: [-Infinity, -Infinity], max: [Infinity, Infinity], step: 0 } as const;
  const shapes = makeShapes(result, { ...everything, whole: true }, undefined);
  known.set(result, shapes);
  return shapes;
}

function tracedShapes(result: Result, { view, size, live }: Seen): Shapes {
  const before = traced.get(result);
  const same = before?.view === view && before.size === size;
  if (same && before.live?.contour === live?.contour) return before.shapes;
  const shapes = makeShapes(result, windowOf(result, view, size), live?.contour);
  traced.set(result, { view, size, live, shapes });
  return shapes;
}

/** What a view shows, with room for the tool beside it. */
function windowOf({ settings, contours }: Result, view: View, size: Size): Window {
  const radii = contours.map(({ radius }) => Math.abs(radius ?? 0));
  const room = Math.max(Math.abs(settings.radius), ...radii) + 4 / view.scale;
  const [x0, y1] = toWorld(view, [0, 0]);
  const [x1, y0] = toWorld(view, [size.width, size.height]);
  return {
    min: [x0 - room, y0 - room],
    max: [x1 + room, y1 + room],
    step: 0.5 / view.scale,
    whole: false,
  };
}

function makeShapes(result: Result, window: Window, without: number | undefined): Shapes {
  return {
    ...contourShapes(result, window, without),
    ...pathShapes(result, window, without),
    rapids: rapidShape(result),
  };
}

/** The shapes with one contour as it is while it is dragged. */
function withLive(shapes: Shapes, live: LivePicture, result: Result, seen: Seen): Shapes {
  const { contour: index, path, starts, outline } = live;
  const window = windowOf(result, seen.view, seen.size);
  const cut = new Path2D();
  const leads = new Path2D(shapes.leads);
  const count = path.points.length / 2;
  starts.forEach((start, piece) => {
    const next = starts[piece + 1];
    let [first, last] = [start, (next ?? count) - 1];
    // A lead is one straight move.
    const same = (i: number, k: number) =>
      path.points[2 * i] === path.points[2 * k] &&
      path.points[2 * i + 1] === path.points[2 * k + 1];
    const lead = (from: number, to: number) => {
      leads.moveTo(path.points[2 * from] as number, path.points[2 * from + 1] as number);
      leads.lineTo(path.points[2 * to] as number, path.points[2 * to + 1] as number);
    };
    if (piece === 0 && live.leads[0] && first < last) {
      lead(first, first + 1);
      first += 1;
    }
    if (next === undefined && live.leads[1]) {
      while (last > first + 1 && same(last, last - 1)) last -= 1;
      const comesBack = live.leads[0] && same(start, last) && same(start + 1, last - 1);
      if (!comesBack) lead(last - 1, last);
      last -= 1;
    }
    if (last > first) path.trace(cut, first, last, window);
  });
  const edge = new Path2D();
  const end = outline.points.length / 2 - 1;
  outline.trace(edge, 0, end, window);
  const replaced = (list: readonly Path2D[], own: Path2D) =>
    list.map((other, i) => (i === index ? own : other));
  const closed = shapes.closed.map((shape) => {
    if (shape.contour !== index) return shape;
    const area = new Path2D();
    outline.trace(area, 0, end, { ...window, whole: true });
    area.closePath();
    return { ...shape, path: area };
  });
  return {
    ...shapes,
    outlines: replaced(shapes.outlines, edge),
    closed,
    cuts: replaced(shapes.cuts, cut),
    leads,
  };
}

function pathShapes(
  result: Result,
  window: Window,
  without: number | undefined,
): Pick<Shapes, "cuts" | "leads" | "free"> {
  const cuts = result.contours.map(() => new Path2D());
  const leads = new Path2D();
  const free = new Path2D();
  const track = trackOf(result.path.points);
  const windows = new Map<Path2D, Window>();
  // Dashes of a lead-out back along the lead-in would fill the gaps of the other's.
  const leadsBefore = new Set<string>();
  for (const { contour, first, last } of cutRuns(result)) {
    const path = contour === FREE ? free : contour === LEAD ? leads : cuts[contour];
    if (!path || contour === without) continue;
    if (contour === LEAD && last === first + 1) {
      if (leadsBefore.has(chord(result.path.points, last, first))) continue;
      leadsBefore.add(chord(result.path.points, first, last));
    }
    const own = windows.get(path) ?? (window.whole ? window : { ...window, drawn: new Set() });
    windows.set(path, own);
    track.trace(path, first, last, own);
  }
  return { cuts, leads, free };
}

/** A chord from one vertex to another, by name. */
function chord(points: Float64Array, from: number, to: number): string {
  return [from, to].map((i) => points.subarray(2 * i, 2 * i + 2).join()).join(" ");
}

/** Vertices of the path that are drawn in one stroke. */
interface CutRun {
  /** Index of the contour, or what it is instead of a part of one. */
  readonly contour: number;
  readonly first: number;
  readonly last: number;
}

const LEAD = -1;
const FREE = -2;

const runs = new WeakMap<Result, readonly CutRun[]>();

function cutRuns(result: Result): readonly CutRun[] {
  const before = runs.get(result);
  if (before) return before;
  const list: CutRun[] = [];
  let [line, at] = [undefined as number | undefined, 0];
  forRuns(result.path, (move, first, last) => {
    const kind = kindOf(roleOf(result, move));
    const own = lineOfMove(result, move);
    if (own !== line) [line, at] = [own, contourAt(result, own)];
    const contour = kind === "cut" ? at : kind === "free" ? FREE : LEAD;
    const end = list.at(-1);
    // A run that goes on where the one before it ended is joined to it, for the sake of line joins.
    if (contour !== LEAD && end?.contour === contour && end.last === first) {
      list[list.length - 1] = { ...end, last };
    } else {
      list.push({ contour, first, last });
    }
  });
  runs.set(result, list);
  return list;
}

const rapidShapes = new WeakMap<Result, Path2D>();

/** Rapid moves, each place once: a loop may go one way a hundred thousand times. */
function rapidShape(result: Result): Path2D {
  const before = rapidShapes.get(result);
  if (before) return before;
  const { records, stride, axes } = result;
  const [right, up] = axes;
  const rapids = new Path2D();
  // Dashes of a way back would fill the gaps of the way there.
  const drawn = new Set<string>();
  const add = (from: Point, to: Point) => {
    if (drawn.has(`${from} ${to}`) || drawn.has(`${to} ${from}`)) return;
    drawn.add(`${from} ${to}`);
    rapids.moveTo(...from);
    rapids.lineTo(...to);
  };
  // The first rapid is left out: it comes from where the tool stood before, which nobody knows.
  const first = records[FIELD.kind] === RAPID ? stride : 0;
  for (let at = first; at + stride <= records.length; at += stride) {
    if (records[at + FIELD.kind] !== RAPID) continue;
    const seen = (field: number): Point => [
      records[at + field + right] as number,
      records[at + field + up] as number,
    ];
    add(seen(FIELD.from), seen(FIELD.to));
  }
  for (const [from, to] of waysInPlane(result)) add(from, to);
  rapidShapes.set(result, rapids);
  return rapids;
}

function contourShapes(
  { programmed }: Result,
  window: Window,
  without: number | undefined,
): Pick<Shapes, "outlines" | "closed"> {
  const outlines: Path2D[] = [];
  const closed: ClosedShape[] = [];
  const count = programmed.points.length / 2;
  const track = trackOf(programmed.points);
  programmed.starts.forEach((first, index) => {
    const last = (programmed.starts[index + 1] ?? count) - 1;
    const outline = new Path2D();
    outlines.push(outline);
    if (last <= first) return;
    const [x0, y0] = vertex(programmed, first);
    const [x1, y1] = vertex(programmed, last);
    const isClosed = Math.hypot(x1 - x0, y1 - y0) < 1e-3;
    const path = new Path2D();
    if (index !== without) {
      track.trace(outline, first, last, window);
      if (isClosed) {
        if (window.whole) outline.closePath();
        track.trace(path, first, last, { ...window, whole: true });
        path.closePath();
      }
    }
    if (isClosed) closed.push({ path, area: area(programmed, first, last), contour: index });
  });
  return { outlines, closed };
}

function area(lines: Lines, first: number, last: number): number {
  let sum = 0;
  for (let i = first; i < last; i += 1) {
    const [x0, y0] = vertex(lines, i);
    const [x1, y1] = vertex(lines, i + 1);
    sum += x0 * y1 - x1 * y0;
  }
  return sum / 2;
}

/** Adds a run of vertices to a path. */
export function addRun(
  path: Path2D,
  lines: Lines,
  first: number,
  last: number,
  goesOn = false,
): void {
  for (let i = first; i <= last; i += 1) {
    const [x, y] = vertex(lines, i);
    if (i > first) path.lineTo(x, y);
    else if (!goesOn) path.moveTo(x, y);
  }
}

function vertex(lines: Lines, i: number): [x: number, y: number] {
  return [lines.points[2 * i] as number, lines.points[2 * i + 1] as number];
}
