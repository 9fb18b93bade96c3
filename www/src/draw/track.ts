// Polylines of very many vertices, of which only as many are drawn as the view can show.

import { nearestOnLine, type Point } from "../geometry";
import type { Box } from "../view";

/** Vertices that share a box. */
const CHUNK = 256;

/** What a view shows of polylines. */
export interface Window extends Box {
  /** Vertices nearer than this to the one before are left out [mm]. */
  readonly step: number;
  /** Whether what lies outside is drawn too, roughly, since an area is filled. */
  readonly whole: boolean;
  /** The chords that are drawn already, and not once more; a loop may pass one a million times. */
  readonly drawn?: Set<number>;
}

/** Places across a window that are told apart: four of them make a number without loss. */
const PLACES = 8192;

/** The vertices `x0, y0, x1, y1, …`, some of which may change. */
export class Track {
  readonly points: Float64Array;
  /** For each chunk its least and largest x and y. */
  #boxes: Float64Array;

  constructor(points: Float64Array) {
    this.points = points;
    this.#boxes = new Float64Array(4 * Math.ceil(points.length / 2 / CHUNK));
    this.touch(0, points.length / 2);
  }

  /** Takes note that vertices have changed. */
  touch(from: number, to: number): void {
    const { points } = this;
    const count = points.length / 2;
    // The box of a chunk holds the chord to the next one too.
    const first = Math.max(0, Math.floor((from - 1) / CHUNK));
    for (let chunk = first; chunk * CHUNK < to; chunk += 1) {
      let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
      const end = Math.min(count, (chunk + 1) * CHUNK + 1);
      for (let i = chunk * CHUNK; i < end; i += 1) {
        const x = points[2 * i] as number;
        const y = points[2 * i + 1] as number;
        if (x < x0) x0 = x;
        if (x > x1) x1 = x;
        if (y < y0) y0 = y;
        if (y > y1) y1 = y;
      }
      this.#boxes.set([x0, y0, x1, y1], 4 * chunk);
    }
  }

  /** Calls `visit` for the chords of each chunk whose box is near a point, by their first vertices. */
  near([x, y]: Point, reach: () => number, visit: (first: number, end: number) => void): void {
    const count = this.points.length / 2;
    const boxes = this.#boxes;
    for (let chunk = 0; chunk * CHUNK < count; chunk += 1) {
      const at = 4 * chunk;
      const dx = Math.max((boxes[at] as number) - x, x - (boxes[at + 2] as number), 0);
      const dy = Math.max((boxes[at + 1] as number) - y, y - (boxes[at + 3] as number), 0);
      if (dx <= reach() && dy <= reach()) {
        visit(chunk * CHUNK, Math.min(count - 1, (chunk + 1) * CHUNK));
      }
    }
  }

  /**
   * Calls `visit` with the nearest place of each chord whose chunk is near a point, and the vertex at the
   * end of the chord; from the end of one polyline to the start of the next there is none.
   */
  nearChords(
    p: Point,
    starts: ReadonlySet<number>,
    reach: () => number,
    visit: (place: { point: Point; t: number }, vertex: number) => void,
  ): void {
    const vertex = (i: number): Point => [
      this.points[2 * i] as number,
      this.points[2 * i + 1] as number,
    ];
    this.near(p, reach, (first, end) => {
      for (let i = first + 1; i <= end; i += 1) {
        if (!starts.has(i)) visit(nearestOnLine(p, vertex(i - 1), vertex(i)), i);
      }
    });
  }

  /** Adds the polyline from vertex `first` to vertex `last` to a path. */
  trace(path: Path2D, first: number, last: number, window: Window): void {
    const { points } = this;
    const { min, max, step, whole } = window;
    let down = false;
    let isLifted = false;
    let [lastX, lastY] = [Number.NaN, Number.NaN];
    const add = (i: number): void => {
      const x = points[2 * i] as number;
      const y = points[2 * i + 1] as number;
      if (down && Math.abs(x - lastX) < step && Math.abs(y - lastY) < step) return;
      if (down && window.drawn && isDrawn(window.drawn, window, [lastX, lastY], [x, y])) {
        isLifted = true;
      } else if (down) {
        if (isLifted) path.moveTo(lastX, lastY);
        isLifted = false;
        path.lineTo(x, y);
      } else path.moveTo(x, y);
      down = true;
      lastX = x;
      lastY = y;
    };
    for (let i = first; i <= last; ) {
      const chunk = Math.floor(i / CHUNK);
      const end = Math.min(last, (chunk + 1) * CHUNK - 1);
      const at = 4 * chunk;
      const [x0, y0] = [this.#boxes[at] as number, this.#boxes[at + 1] as number];
      const [x1, y1] = [this.#boxes[at + 2] as number, this.#boxes[at + 3] as number];
      const outside = x1 < min[0] || x0 > max[0] || y1 < min[1] || y0 > max[1];
      if (outside && !whole) {
        // Its last vertex is where the next chunk is entered from.
        if (down) add(i);
        down = false;
        add(end);
      } else if (outside || (x1 - x0 < step && y1 - y0 < step)) {
        add(i);
        add(end);
      } else {
        for (let k = i; k <= end; k += 1) add(k);
      }
      i = end + 1;
    }
    if (down && !isLifted) {
      path.lineTo(points[2 * last] as number, points[2 * last + 1] as number);
    }
  }
}

/** Whether a chord was drawn before, either way; if not, it is from now on. */
function isDrawn(drawn: Set<number>, { min, step }: Window, a: Point, b: Point): boolean {
  const place = (p: Point, axis: 0 | 1) => Math.round((p[axis] - min[axis]) / step);
  const [x0, y0, x1, y1] = [place(a, 0), place(a, 1), place(b, 0), place(b, 1)];
  if (Math.min(x0, y0, x1, y1) < 0 || Math.max(x0, y0, x1, y1) >= PLACES) return false;
  const [from, to] = [x0 * PLACES + y0, x1 * PLACES + y1];
  const key = Math.min(from, to) * PLACES * PLACES + Math.max(from, to);
  if (drawn.has(key)) return true;
  drawn.add(key);
  return false;
}

const known = new WeakMap<Float64Array, Track>();

/** The track of vertices that do not change. */
export function trackOf(points: Float64Array): Track {
  const before = known.get(points);
  if (before) return before;
  const track = new Track(points);
  known.set(points, track);
  return track;
}
