// How far a tool path is from the true equidistant: measured from the moves alone, by geometry of its
// own.
//
// A point of the path belongs to a segment. Its distance from that segment, less the tool radius, is
// how far it is off the equidistant, along the normal; the foot of the normal tells where along the
// contour. Transitions and leads belong to no segment and are not measured.

import type { Point } from "./geometry";

/** The deviation along a path; NaN parts stretches that do not follow each other. */
export interface Deviation {
  /** Arc length of the contours up to the foot [mm]. */
  readonly s: Float64Array;
  /** [mm], positive where material is left, negative where the path cuts too deep. */
  readonly d: Float64Array;
  /** Where the tool stands: x0, y0, x1, y1, … [mm] */
  readonly places: Float64Array;
  /** The largest deviation either way [mm]. */
  readonly worst: number;
}

/** Moves as `records()` gives them, and the count of numbers of each. */
export interface Records {
  readonly numbers: Float64Array;
  readonly stride: number;
}

/** A stretch of a contour: a line, an arc or a cubic, with its place along all contours. */
interface Piece {
  /** The line of the text that its segment begins with. */
  readonly line: number;
  /** Arc length before it, and its own [mm]. */
  readonly before: number;
  readonly length: number;
  at(t: number): Point;
  /** First and second derivative. */
  rates(t: number): readonly [Point, Point];
}

/** The contours that deviations are measured from. */
export interface Measure {
  readonly pieces: readonly Piece[];
  /** Arc length of all contours [mm]. */
  readonly length: number;
  /** Arc length at each end of a segment [mm]. */
  readonly ends: readonly number[];
}

const KIND = 0;
const ROLE = 1;
const BLOCK = 4;
const FROM = 9;
const TO = 12;
const SHAPE = 15;
const [RAPID, ARC, CUBIC, INVOLUTE] = [0, 2, 3, 4];

/** Samples of one cubic: its error has a few waves. */
const MOST_SAMPLES = 24;

/** About as many samples are taken of a path: more than a plot has pixels. */
const SAMPLES = 12_000;

/**
 * The pieces of contours, from the moves of a tool without a radius along them.
 *
 * @param lineOf the line of the text that a contour's segment begins with
 */
export function measureOf(
  { numbers, stride }: Records,
  lineOf: (contour: number, segment: number) => number,
): Measure {
  const pieces: Piece[] = [];
  const ends: number[] = [];
  let length = 0;
  let last = "";
  for (let i = 0; i < numbers.length; i += stride) {
    const record = numbers.subarray(i, i + stride);
    if (record[ROLE] !== 0) continue;
    const [contour, segment] = [record[7] as number, record[8] as number];
    const name = `${contour} ${segment}`;
    if (last !== "" && name !== last) ends.push(length);
    last = name;
    const line = lineOf(Number.isNaN(contour) ? 0 : contour, segment);
    const curve = curveOf(record);
    const piece = { line, before: length, length: lengthTo(curve, 1), ...curve };
    length += piece.length;
    pieces.push(piece);
  }
  return { pieces, length, ends };
}

/** The deviation of a path, made by a tool of a radius [mm] that may depend on the line. */
export function deviationOf(
  { numbers, stride }: Records,
  { pieces }: Measure,
  radiusAt: (line: number) => number,
): Deviation {
  const byLine = new Map<number, Piece[]>();
  for (const piece of pieces) {
    const same = byLine.get(piece.line);
    if (same) same.push(piece);
    else byLine.set(piece.line, [piece]);
  }
  const moves = numbers.length / stride;
  const each = Math.max(2, Math.min(MOST_SAMPLES, Math.floor(SAMPLES / Math.max(1, moves))));
  const [s, d, places]: [number[], number[], number[]] = [[], [], []];
  const part = () => {
    s.push(Number.NaN);
    d.push(Number.NaN);
    places.push(Number.NaN, Number.NaN);
  };
  let worst = 0;
  let own: Piece[] = [];
  let place = 0;
  for (let i = 0; i < numbers.length; i += stride) {
    const record = numbers.subarray(i, i + stride);
    if (record[ROLE] !== 0 || record[KIND] === RAPID) continue;
    const line = record[BLOCK] as number;
    const found = startedBy(byLine, line);
    if (!found) continue;
    const curve = curveOf(record);
    if (found !== own) {
      own = found;
      place = nearestPiece(own, curve.at(0));
      part();
    }
    const radius = radiusAt(line);
    for (let k = 0; k <= each; k += 1) {
      const p = curve.at(k / each);
      let foot = footOn(own[place] as Piece, p);
      // Along a path the foot moves along the segment: from piece to piece, where that is nearer.
      for (const step of [1, -1]) {
        for (let next = own[place + step]; next; next = own[place + step]) {
          const other = footOn(next, p);
          if (other.distance > foot.distance) break;
          foot = other;
          place += step;
        }
      }
      const piece = own[place] as Piece;
      if (isBeyond(piece, foot, p)) {
        part();
        continue;
      }
      const off = foot.distance - radius;
      s.push(piece.before + lengthTo(piece, foot.t));
      d.push(off);
      places.push(...p);
      if (Math.abs(off) > Math.abs(worst)) worst = off;
    }
  }
  const [arcs, offs, points] = [s, d, places].map((numbers) => Float64Array.from(numbers));
  return {
    s: arcs as Float64Array,
    d: offs as Float64Array,
    places: points as Float64Array,
    worst,
  };
}

/** What the last line up to one has begun: the type points of a spline have lines of their own. */
function startedBy(byLine: Map<number, Piece[]>, line: number): Piece[] | undefined {
  let at = line;
  while (at > 0 && !byLine.has(at)) at -= 1;
  const found = byLine.get(at);
  // The next line is looked for from here.
  if (found) byLine.set(line, found);
  return found;
}

type Curve = Pick<Piece, "at" | "rates">;

function curveOf(record: Float64Array): Curve {
  const a: Point = [record[FROM] as number, record[FROM + 1] as number];
  const b: Point = [record[TO] as number, record[TO + 1] as number];
  const [p, q, r, w] = record.subarray(SHAPE, SHAPE + 4) as unknown as [
    number,
    number,
    number,
    number,
  ];
  if (record[KIND] === ARC) return arc(a, b, [p, q], r, w === 1);
  if (record[KIND] === CUBIC) return cubic(a, [p, q], [r, w], b);
  if (record[KIND] === INVOLUTE) return involute(a, b, [p, q], r, w === 1);
  const v: Point = [b[0] - a[0], b[1] - a[1]];
  return {
    at: (t) => [a[0] + v[0] * t, a[1] + v[1] * t],
    rates: () => [v, [0, 0]],
  };
}

/** An involute by the angle that its thread has come off the circle by. */
function involute(a: Point, b: Point, [cx, cy]: Point, radius: number, clockwise: boolean): Curve {
  const roll = ([x, y]: Point) =>
    Math.sqrt(Math.max(0, (Math.hypot(x - cx, y - cy) / radius) ** 2 - 1));
  const [start, end] = [roll(a), roll(b)];
  const hand = end > start === clockwise ? -1 : 1;
  const first = Math.atan2(a[1] - cy, a[0] - cx) + hand * Math.atan(start);
  const span = end - start;
  /** The unit vector to where the thread leaves the circle. */
  const on = (t: number): Point => {
    const angle = first + hand * span * t;
    return [Math.cos(angle), Math.sin(angle)];
  };
  return {
    at: (t) => {
      const [x, y] = on(t);
      const thread = hand * radius * (start + span * t);
      return [cx + radius * x + thread * y, cy + radius * y - thread * x];
    },
    rates: (t) => {
      const [x, y] = on(t);
      const turned = start + span * t;
      const [speed, change] = [radius * turned * span, radius * span * span];
      const bend = hand * radius * turned * span * span;
      return [
        [speed * x, speed * y],
        [change * x - bend * y, change * y + bend * x],
      ];
    },
  };
}

function arc(a: Point, b: Point, [cx, cy]: Point, radius: number, clockwise: boolean): Curve {
  const first = Math.atan2(a[1] - cy, a[0] - cx);
  let sweep = Math.atan2(b[1] - cy, b[0] - cx) - first;
  const turn = 2 * Math.PI;
  if (Math.hypot(b[0] - a[0], b[1] - a[1]) < 1e-9) sweep = clockwise ? -turn : turn;
  else if (clockwise && sweep > 0) sweep -= turn;
  else if (!clockwise && sweep < 0) sweep += turn;
  const on = (t: number, size: number): Point => {
    const angle = first + sweep * t;
    return [size * Math.cos(angle), size * Math.sin(angle)];
  };
  return {
    at: (t) => {
      const [x, y] = on(t, radius);
      return [cx + x, cy + y];
    },
    rates: (t) => {
      const [x, y] = on(t, radius * sweep);
      const [ax, ay] = on(t, -radius * sweep * sweep);
      return [
        [-y, x],
        [ax, ay],
      ];
    },
  };
}

function cubic(a: Point, b: Point, c: Point, e: Point): Curve {
  const mix = (u: number, v: number, w: number, z: number): Point => [
    a[0] * u + b[0] * v + c[0] * w + e[0] * z,
    a[1] * u + b[1] * v + c[1] * w + e[1] * z,
  ];
  return {
    at: (t) => {
      const r = 1 - t;
      return mix(r * r * r, 3 * r * r * t, 3 * r * t * t, t * t * t);
    },
    rates: (t) => {
      const r = 1 - t;
      return [
        mix(-3 * r * r, 3 * r * r - 6 * r * t, 6 * r * t - 3 * t * t, 3 * t * t),
        mix(6 * r, 6 * t - 12 * r, 6 * r - 12 * t, 6 * t),
      ];
    },
  };
}

/** Places and weights of Gauss and Legendre's rule of eight points, on 0 to 1, one half. */
const GAUSS: readonly (readonly [place: number, weight: number])[] = [
  [0.1834346424956498, 0.362683783378362],
  [0.525532409916329, 0.3137066458778873],
  [0.7966664774136267, 0.2223810344533745],
  [0.9602898564975363, 0.1012285362903763],
];

/** Arc length of a curve up to a parameter [mm]. */
function lengthTo({ rates }: Curve, t: number): number {
  let sum = 0;
  for (const [place, weight] of GAUSS) {
    for (const x of [place, -place]) {
      const [[vx, vy]] = rates((t * (1 + x)) / 2);
      sum += weight * Math.hypot(vx, vy);
    }
  }
  return (sum * t) / 2;
}

interface Foot {
  readonly t: number;
  readonly distance: number;
}

/** The nearest point of a piece: the nearest of a few, then Newton's method on (C − p) · C' = 0. */
function footOn({ at, rates }: Curve, [x, y]: Point): Foot {
  const away = (t: number) => {
    const [cx, cy] = at(t);
    return Math.hypot(cx - x, cy - y);
  };
  let t = 0;
  for (let k = 1; k <= 8; k += 1) if (away(k / 8) < away(t)) t = k / 8;
  for (let k = 0; k < 12; k += 1) {
    const [cx, cy] = at(t);
    const [[vx, vy], [ax, ay]] = rates(t);
    const slope = vx * vx + vy * vy + (cx - x) * ax + (cy - y) * ay;
    if (!(slope > 0)) break;
    const next = Math.min(1, Math.max(0, t - ((cx - x) * vx + (cy - y) * vy) / slope));
    const done = Math.abs(next - t) < 1e-14;
    t = next;
    if (done) break;
  }
  return { t, distance: away(t) };
}

/**
 * Whether a point is past an end of its segment, where a move runs on to the next: it has no normal
 * there.
 */
function isBeyond({ at, rates }: Curve, { t, distance }: Foot, [x, y]: Point): boolean {
  if (t > 0 && t < 1) return false;
  const [cx, cy] = at(t);
  const [[vx, vy]] = rates(t);
  return Math.abs((x - cx) * vx + (y - cy) * vy) > 1e-6 * distance * Math.hypot(vx, vy);
}

function nearestPiece(pieces: readonly Piece[], p: Point): number {
  let best = 0;
  let least = Number.POSITIVE_INFINITY;
  pieces.forEach((piece, i) => {
    const { distance } = footOn(piece, p);
    if (distance < least) {
      least = distance;
      best = i;
    }
  });
  return best;
}
