// Level of detail: polylines of very many vertices, thinned for each zoom to what can be told apart.
//
// For a level the plane is laid out in cells. Vertices that follow each other in one cell become one,
// and a chord between two cells is kept once, however many chords lie there: a million blocks that
// hatch an area become as many chords as there are cells to see. The finest level has 8192 cells
// across the drawing, and each coarser one half as many; beyond the finest the view shows so little
// of the drawing that all vertices in it can be drawn.

import type { Box } from "../view";

/** Vertices that share a box. */
const CHUNK = 256;
/** Cells across the drawing, of the finest level and of the coarsest. */
const FINEST = 8192;
const COARSEST = 512;
/** Fewer vertices than this are drawn as they are. */
const FEW = 20_000;

/** Polylines, thinned or not. */
export interface Level {
  /** Size of its cells [mm]; 0 where nothing was thinned. */
  readonly step: number;
  /** x0, y0, x1, y1, …; NaN between two pieces. */
  readonly points: Float64Array;
  /** Least and largest x and y of each chunk of vertices, and of the chord to the next chunk. */
  readonly boxes: Float64Array;
}

/** All levels of polylines, the coarsest first. */
export function levelsOf(points: Float64Array): Level[] {
  const all = level(points, 0);
  const levels = [all];
  // Their own box, outside of which there are no cells: rapid moves go far beyond all others.
  const box = boxOfBoxes(all.boxes);
  const extent = Math.max(box.max[0] - box.min[0], box.max[1] - box.min[1]);
  if (points.length < 2 * FEW || !(extent > 0)) return levels;
  let finer = points;
  for (let cells = FINEST; cells >= COARSEST; cells /= 2) {
    // A little larger, so that the far edge belongs to the last cell.
    const step = (extent * (1 + 1e-9)) / cells;
    finer = thinned(finer, step, box);
    levels.unshift(level(finer, step));
  }
  return levels;
}

/** The coarsest level whose cells are at most so large [mm]. */
export function levelFor(levels: readonly Level[], step: number): Level | undefined {
  return levels.find((each) => each.step <= step);
}

/** Calls `visit` with the first and the last vertex of each chunk that a box shows some of. */
export function forChunks(
  { points, boxes }: Level,
  { min, max }: Box,
  visit: (first: number, last: number) => void,
): void {
  const count = points.length / 2;
  for (let chunk = 0, at = 0; at < boxes.length; chunk += 1, at += 4) {
    const [x0, y0] = [boxes[at] as number, boxes[at + 1] as number];
    const [x1, y1] = [boxes[at + 2] as number, boxes[at + 3] as number];
    if (x1 < min[0] || x0 > max[0] || y1 < min[1] || y0 > max[1]) continue;
    visit(chunk * CHUNK, Math.min(count - 1, (chunk + 1) * CHUNK));
  }
}

function level(points: Float64Array, step: number): Level {
  const count = points.length / 2;
  const boxes = new Float64Array(4 * Math.ceil(count / CHUNK));
  for (let at = 0, from = 0; at < boxes.length; at += 4, from += CHUNK) {
    let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
    const end = Math.min(count, from + CHUNK + 1);
    for (let i = 2 * from; i < 2 * end; i += 2) {
      const x = points[i] as number;
      const y = points[i + 1] as number;
      if (x < x0) x0 = x;
      if (x > x1) x1 = x;
      if (y < y0) y0 = y;
      if (y > y1) y1 = y;
    }
    boxes.set([x0, y0, x1, y1], at);
  }
  return { step, points, boxes };
}

function boxOfBoxes(boxes: Float64Array): Box {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let at = 0; at < boxes.length; at += 4) {
    x0 = Math.min(x0, boxes[at] as number);
    y0 = Math.min(y0, boxes[at + 1] as number);
    x1 = Math.max(x1, boxes[at + 2] as number);
    y1 = Math.max(y1, boxes[at + 3] as number);
  }
  return { min: [x0, y0], max: [x1, y1] };
}

function thinned(points: Float64Array, step: number, { min: [x0, y0] }: Box): Float64Array {
  const chords = new Chords(points.length / 2);
  const kept = new Kept(points.length / 2);
  let [last, lastX, lastY] = [-1, 0, 0];
  // Whether what is kept ends at the last cell, and whether the piece has left its first cell.
  let [follows, leaves] = [false, true];
  const end = () => {
    if (!leaves && chords.add(last, last)) kept.chord(false, lastX, lastY, lastX + step / 4, lastY);
  };
  for (let i = 0; i < points.length; i += 2) {
    const x = points[i] as number;
    const y = points[i + 1] as number;
    if (Number.isNaN(x)) {
      end();
      last = -1;
      leaves = true;
      continue;
    }
    const cell = Math.floor((x - x0) / step) * FINEST + Math.floor((y - y0) / step);
    if (cell === last) continue;
    if (last < 0) {
      follows = false;
      leaves = false;
    } else {
      leaves = true;
      const isNew = chords.add(Math.min(cell, last), Math.max(cell, last));
      if (isNew) kept.chord(follows, lastX, lastY, x, y);
      follows = isNew;
    }
    [last, lastX, lastY] = [cell, x, y];
  }
  end();
  return kept.points();
}

/** The vertices that are kept. */
class Kept {
  #points: Float64Array;
  #length = 0;

  constructor(count: number) {
    this.#points = new Float64Array(count + 64);
  }

  /** Keeps a chord, which may go on from where the last one ended. */
  chord(follows: boolean, x0: number, y0: number, x1: number, y1: number): void {
    if (this.#length + 6 > this.#points.length) {
      const larger = new Float64Array(2 * this.#points.length);
      larger.set(this.#points);
      this.#points = larger;
    }
    if (!follows) {
      if (this.#length > 0) this.#add(Number.NaN, Number.NaN);
      this.#add(x0, y0);
    }
    this.#add(x1, y1);
  }

  #add(x: number, y: number): void {
    this.#points[this.#length] = x;
    this.#points[this.#length + 1] = y;
    this.#length += 2;
  }

  points(): Float64Array {
    return this.#points.slice(0, this.#length);
  }
}

/** A set of chords, each by the two cells that it joins. */
class Chords {
  #table: Float64Array;
  #mask: number;

  constructor(most: number) {
    const size = 2 ** Math.ceil(Math.log2(2 * most + 2));
    this.#table = new Float64Array(size).fill(-1);
    this.#mask = size - 1;
  }

  /** Adds a chord; false where it is there already. */
  add(a: number, b: number): boolean {
    // Both are less than 8192², so that the key is a whole number that a double can hold.
    const key = a * FINEST * FINEST + b;
    let at = (Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca77)) & this.#mask;
    at = (at ^ (at >>> 15)) & this.#mask;
    for (;;) {
      const found = this.#table[at];
      if (found === key) return false;
      if (found === -1) {
        this.#table[at] = key;
        return true;
      }
      at = (at + 1) & this.#mask;
    }
  }
}
