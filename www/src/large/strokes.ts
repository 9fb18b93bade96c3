// What is drawn of a program: polylines by what they are there for, made by the worker that computes.

import { type Program, RECORD_STRIDE, type ToolPath, type Way } from "g41";
import { FIELD, MoveRole, RAPID } from "../result";
import { waysInPlane } from "./ways";

/** What a line of the picture is: part of a contour, or a move and what it is there for. */
export type StrokeKind = "rapid" | "free" | "contour" | "lead" | "cut";

/** Polylines of one kind. */
export interface Strokes {
  readonly kind: StrokeKind;
  /** x0, y0, x1, y1, … as they are seen [mm]; NaN between two pieces. */
  readonly points: Float64Array;
  /** For each vertex, the line of the text that the chord ending there comes from; 0 for none. */
  readonly lines: Uint32Array;
}

/** The two axes of x, y, z that are seen: to the right, and up. */
export type Axes = readonly [right: 0 | 1 | 2, up: 0 | 1 | 2];

/** The axes of the planes, as records number them. */
const PLANE_AXES: readonly Axes[] = [
  [0, 1],
  [2, 0],
  [1, 2],
];

/** Moves that are looked at in one go, for the sake of memory. */
const SLICE = 50_000;

/** How far chords may be from their curves [mm]; the next where that takes too many of them. */
const TOLERANCES = [0.01, 0.1, 1];

/** What the moves of a path are, as far as the picture asks for it. */
export interface Moves {
  /** The line of the text of each, 0 for none. */
  readonly lines: Uint32Array;
  readonly roles: Uint8Array;
  /** From and to of each rapid move: x, y, z, x, y, z. */
  readonly rapids: Float64Array;
  /** The line of each rapid move. */
  readonly rapidLines: Uint32Array;
  /** The ways between the pieces of the path. */
  readonly ways: readonly Way[];
  /** The axes of the plane that it is programmed in: where it is compensated, else where it cuts. */
  readonly axes: Axes;
}

/** Looks at the moves of a path. */
export function movesOf(path: ToolPath): Moves {
  const { count } = path;
  const lines = new Uint32Array(count);
  const roles = new Uint8Array(count);
  const rapids: number[] = [];
  const rapidLines: number[] = [];
  const cutting = [0, 0, 0];
  const compensated = [0, 0, 0];
  for (let from = 0; from < count; from += SLICE) {
    const records = path.records(from, from + SLICE);
    for (let at = 0, i = from; at < records.length; at += RECORD_STRIDE, i += 1) {
      const line = records[at + FIELD.block] as number;
      const role = records[at + FIELD.role] as MoveRole;
      lines[i] = Number.isNaN(line) ? 0 : line;
      roles[i] = role;
      const plane = records[at + FIELD.plane] as number;
      if (records[at] === RAPID) {
        for (let k = FIELD.from; k < FIELD.to + 3; k += 1) rapids.push(records[at + k] as number);
        rapidLines.push(lines[i] as number);
      } else cutting[plane] = (cutting[plane] ?? 0) + 1;
      if (role !== MoveRole.Free) compensated[plane] = (compensated[plane] ?? 0) + 1;
    }
  }
  const counts = compensated.some((number) => number > 0) ? compensated : cutting;
  const plane = counts.indexOf(Math.max(...counts));
  const axes = PLANE_AXES[plane] ?? [0, 1];
  return {
    lines,
    roles,
    rapids: Float64Array.from(rapids),
    rapidLines: Uint32Array.from(rapidLines),
    ways: path.ways,
    axes,
  };
}

/** Vertices of x, y, z as they are seen. */
export function seen(points3: Float64Array, [right, up]: Axes): Float64Array {
  const points = new Float64Array((points3.length / 3) * 2);
  for (let i = 0, k = 0; i < points3.length; i += 3, k += 2) {
    points[k] = points3[i + right] as number;
    points[k + 1] = points3[i + up] as number;
  }
  return points;
}

/** All strokes of a program and its path. */
export function strokesOf(program: Program, path: ToolPath, moves: Moves): Strokes[] {
  const pens = { free: new Pen(), lead: new Pen(), cut: new Pen() };
  const { axes, roles, lines } = moves;
  const drawn = coarsePolylines(path);
  const points = seen(drawn.points3, axes);
  drawn.starts.forEach((start, piece) => {
    const end = drawn.starts[piece + 1] ?? drawn.owners.length;
    let pen: Pen | undefined;
    for (let i = start + 1; i < end; i += 1) {
      const owner = drawn.owners[i] as number;
      const own = pens[kindOf(roles[owner] as MoveRole)];
      if (own !== pen) {
        pen = own;
        pen.begin(points[2 * i - 2] as number, points[2 * i - 1] as number, lines[owner] ?? 0);
      }
      pen.add(points[2 * i] as number, points[2 * i + 1] as number, lines[owner] ?? 0);
    }
  });
  return [
    rapidStrokes(moves),
    { kind: "free", ...pens.free.drawn() },
    contourStrokes(program, axes),
    { kind: "lead", ...pens.lead.drawn() },
    { kind: "cut", ...pens.cut.drawn() },
  ];
}

/** What the line of a move is, by what it is there for. */
export function kindOf(role: MoveRole): "free" | "lead" | "cut" {
  if (role === MoveRole.Free) return "free";
  return role === MoveRole.LeadIn || role === MoveRole.LeadOut ? "lead" : "cut";
}

function rapidStrokes(moves: Moves): Strokes {
  const { rapids, rapidLines, axes } = moves;
  const pen = new Pen();
  const points = seen(rapids, axes);
  // The first comes from where the tool stood before, which nobody knows.
  for (let i = 1; i < rapidLines.length; i += 1) {
    const line = rapidLines[i] as number;
    pen.begin(points[4 * i] as number, points[4 * i + 1] as number, line);
    pen.add(points[4 * i + 2] as number, points[4 * i + 3] as number, line);
  }
  for (const [from, to] of waysInPlane(moves)) {
    pen.begin(...from, 0);
    pen.add(...to, 0);
  }
  return { kind: "rapid", ...pen.drawn() };
}

function contourStrokes(program: Program, axes: Axes): Strokes {
  const pen = new Pen();
  const { points3, starts, owners } = coarsePolylines(program);
  const points = seen(points3, axes);
  starts.forEach((start, piece) => {
    const end = starts[piece + 1] ?? owners.length;
    for (let i = start; i < end; i += 1) {
      const [x, y] = [points[2 * i] as number, points[2 * i + 1] as number];
      if (i === start) pen.begin(x, y, 0);
      else pen.add(x, y, 0);
    }
  });
  return { kind: "contour", ...pen.drawn() };
}

/** The polylines of a program or a path as fine as there is memory for. */
export function coarsePolylines(of: Program | ToolPath) {
  for (const tolerance of TOLERANCES) {
    try {
      return of.polylines(tolerance);
    } catch (error) {
      if ((error as { code?: string }).code !== "bad-argument") throw error;
    }
  }
  throw new Error("the program has too many curves to be drawn");
}

/** Collects polylines. */
class Pen {
  #points = new Float64Array(1 << 12);
  #lines = new Uint32Array(1 << 11);
  #count = 0;

  /** Begins a piece. */
  begin(x: number, y: number, line: number): void {
    if (this.#count > 0) this.add(Number.NaN, Number.NaN, 0);
    this.add(x, y, line);
  }

  add(x: number, y: number, line: number): void {
    const i = this.#count;
    if (i === this.#lines.length) {
      const [points, lines] = [new Float64Array(4 * i), new Uint32Array(2 * i)];
      points.set(this.#points);
      lines.set(this.#lines);
      this.#points = points;
      this.#lines = lines;
    }
    this.#points[2 * i] = x;
    this.#points[2 * i + 1] = y;
    this.#lines[i] = line;
    this.#count += 1;
  }

  drawn(): Pick<Strokes, "points" | "lines"> {
    const count = this.#count;
    return { points: this.#points.slice(0, 2 * count), lines: this.#lines.slice(0, count) };
  }
}

/** The box around strokes [mm]; undefined where there are none. */
export function boxOfStrokes(all: readonly Strokes[]) {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { kind, points } of all) {
    // Rapid moves go to where tools are changed; they count where there is nothing else.
    const isOther = (other: Strokes) => other.kind !== "rapid" && other.points.length > 0;
    if (kind === "rapid" && all.some(isOther)) continue;
    for (let i = 0; i < points.length; i += 2) {
      const [x, y] = [points[i] as number, points[i + 1] as number];
      if (x < x0) x0 = x;
      if (x > x1) x1 = x;
      if (y < y0) y0 = y;
      if (y > y1) y1 = y;
    }
  }
  if (x0 > x1) return undefined;
  return { min: [x0, y0] as const, max: [x1, y1] as const };
}
