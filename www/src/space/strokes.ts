// What is drawn of a program in space: polylines of x, y and z by what they are there for, made by the
// worker that computes.

import { kindOf, type Moves, type StrokeKind } from "../large/strokes";
import { lineOfWay } from "../large/ways";
import type { MoveRole } from "../result";

/** Polylines of one kind. */
export interface SpaceStrokes {
  readonly kind: StrokeKind;
  /** x0, y0, z0, x1, y1, z1, … [mm]; NaN between two pieces. */
  readonly points: Float32Array;
  /** For each vertex, the line of the text that the chord ending there comes from; 0 for none. */
  readonly lines: Uint32Array;
}

/** A point [mm]. */
export type Point3 = readonly [x: number, y: number, z: number];

/** A box [mm]. */
export interface Box3 {
  readonly min: Point3;
  readonly max: Point3;
}

/** What is drawn in space. */
export interface Space {
  readonly strokes: readonly SpaceStrokes[];
  /** Around all moves that cut, also where the strokes are thinned; undefined where none does. */
  readonly cut: Box3 | undefined;
}

/** Polylines as the package gives them. */
interface Polylines {
  readonly points3: Float64Array;
  readonly starts: Uint32Array;
  readonly owners: Uint32Array;
}

/** More vertices than these could not be turned while one looks; of very long programs some are left out. */
const MOST_VERTICES = 200_000;

/** All strokes of a path and of the contours that it follows. */
export function spaceOf(contours: Polylines, path: Polylines, moves: Moves): Space {
  const { roles, lines, rapids, rapidLines, ways } = moves;
  const pens = { free: new Pen(), lead: new Pen(), cut: new Pen() };
  const thin = Math.ceil(path.owners.length / MOST_VERTICES);
  path.starts.forEach((start, piece) => {
    const end = path.starts[piece + 1] ?? path.owners.length;
    let pen: Pen | undefined;
    for (let i = start + 1; i < end; i += 1) {
      const owner = path.owners[i] as number;
      const own = pens[kindOf(roles[owner] as MoveRole)];
      if (own !== pen) {
        pen?.add(path.points3, i - 1, lines[path.owners[i - 1] as number] ?? 0);
        pen = own;
        pen.begin(path.points3, i - 1, lines[owner] ?? 0);
      }
      if (i === end - 1 || (i - start) % thin === 0) pen.add(path.points3, i, lines[owner] ?? 0);
    }
  });
  const contour = new Pen();
  contours.starts.forEach((start, piece) => {
    const end = contours.starts[piece + 1] ?? contours.owners.length;
    contour.begin(contours.points3, start, 0);
    for (let i = start + 1; i < end; i += 1) contour.add(contours.points3, i, 0);
  });
  const rapid = new Pen();
  // The first comes from where the tool stood before, which nobody knows.
  for (let i = 1; i < rapidLines.length; i += 1) {
    const line = rapidLines[i] as number;
    rapid.begin(rapids, 2 * i, line);
    rapid.add(rapids, 2 * i + 1, line);
  }
  ways.forEach((way, i) => {
    const { kind, from, to } = way.move;
    const last = ways[i - 1];
    const pen = kind === "rapid" ? rapid : pens.free;
    const chord = Float64Array.from([...from, ...to]);
    const goesOn = last?.before === way.before && last.move.kind === kind;
    if (!goesOn) pen.begin(chord, 0, lineOfWay(way));
    pen.add(chord, 1, lineOfWay(way));
  });
  const strokes: SpaceStrokes[] = [
    { kind: "rapid", ...rapid.drawn() },
    { kind: "free", ...pens.free.drawn() },
    { kind: "contour", ...contour.drawn() },
    { kind: "lead", ...pens.lead.drawn() },
    { kind: "cut", ...pens.cut.drawn() },
  ];
  return { strokes, cut: boxOf3([path.points3]) };
}

/** The box around points given as x0, y0, z0, x1, …; undefined for none. */
export function boxOf3(arrays: readonly ArrayLike<number>[]): Box3 | undefined {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const points of arrays) {
    for (let i = 0; i < points.length; i += 1) {
      const [value, axis] = [points[i] as number, (i % 3) as 0 | 1 | 2];
      // NaN, between two pieces, is neither less nor more.
      if (value < min[axis]) min[axis] = value;
      if (value > max[axis]) max[axis] = value;
    }
  }
  return min[0] > max[0] ? undefined : { min, max };
}

/** Collects polylines. */
class Pen {
  #points: number[] = [];
  #lines: number[] = [];

  /** Begins a piece at a vertex of x0, y0, z0, …. */
  begin(from: Float64Array, vertex: number, line: number): void {
    if (this.#lines.length > 0) {
      this.#points.push(Number.NaN, Number.NaN, Number.NaN);
      this.#lines.push(0);
    }
    this.add(from, vertex, line);
  }

  add(from: Float64Array, vertex: number, line: number): void {
    for (let k = 3 * vertex; k < 3 * vertex + 3; k += 1) this.#points.push(from[k] as number);
    this.#lines.push(line);
  }

  drawn(): Pick<SpaceStrokes, "points" | "lines"> {
    return { points: Float32Array.from(this.#points), lines: Uint32Array.from(this.#lines) };
  }
}
