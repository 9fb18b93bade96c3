// Plane geometry for handles and hit tests: what the page needs before the package has answered.

/** A point in the plane [mm], or on the canvas [px] where a name says so. */
export type Point = readonly [x: number, y: number];

/** A circle of which an arc is a part. */
export interface Circle {
  readonly center: Point;
  readonly radius: number;
}

const TURN = 2 * Math.PI;

/** The distance of two points. */
export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** Whether two points are the same to within what a program can write. */
export function coincide(a: Point, b: Point): boolean {
  return distance(a, b) < 5e-4;
}

/** The point at `t` between two points. */
export function between(a: Point, b: Point, t: number): Point {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
}

/** The sum of a point and a multiple of a direction. */
export function along(p: Point, direction: Point, length: number): Point {
  return [p[0] + direction[0] * length, p[1] + direction[1] * length];
}

/** The unit vector from `a` to `b`; zero where they coincide. */
export function direction(a: Point, b: Point): Point {
  const length = distance(a, b);
  return length === 0 ? [0, 0] : [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
}

/** A vector turned left by 90°. */
export function perp(v: Point): Point {
  return [-v[1], v[0]];
}

/** The angle of `p` seen from `center` [rad]. */
export function angleOf(center: Point, p: Point): number {
  return Math.atan2(p[1] - center[1], p[0] - center[0]);
}

/** The point of a circle at an angle. */
export function onCircle(center: Point, radius: number, angle: number): Point {
  return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
}

/** The signed sweep of an arc [rad], positive counter-clockwise; a full turn where ends coincide. */
export function arcSweep(from: Point, to: Point, center: Point, clockwise: boolean): number {
  if (coincide(from, to)) return clockwise ? -TURN : TURN;
  const turn = angleOf(center, to) - angleOf(center, from);
  const positive = ((turn % TURN) + TURN) % TURN;
  return clockwise ? positive - TURN : positive;
}

/** The point half way along an arc. */
export function arcMiddle(from: Point, to: Point, center: Point, clockwise: boolean): Point {
  const middle = angleOf(center, from) + arcSweep(from, to, center, clockwise) / 2;
  return onCircle(center, distance(center, from), middle);
}

/** The centre of the arc between two points with a signed sweep [rad]. */
export function centerOfSweep(from: Point, to: Point, sweep: number): Point {
  const half = between(from, to, 0.5);
  const height = distance(from, to) / 2 / Math.tan(sweep / 2);
  return along(half, perp(direction(from, to)), height);
}

/** The circle through three points; undefined where they are in line. */
export function circleThrough(a: Point, b: Point, c: Point): Circle | undefined {
  const [bx, by] = [b[0] - a[0], b[1] - a[1]];
  const [cx, cy] = [c[0] - a[0], c[1] - a[1]];
  const cross = 2 * (bx * cy - by * cx);
  if (Math.abs(cross) < 1e-9 * (bx * bx + by * by + cx * cx + cy * cy)) return undefined;
  const [bb, cc] = [bx * bx + by * by, cx * cx + cy * cy];
  const x = (cy * bb - by * cc) / cross;
  const y = (bx * cc - cx * bb) / cross;
  return { center: [a[0] + x, a[1] + y], radius: Math.hypot(x, y) };
}

/** Whether the turn from `a` over `b` to `c` is to the right. */
export function turnsRight(a: Point, b: Point, c: Point): boolean {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0;
}

/** The nearest point to `p` on the straight line between two points, and its place in [0, 1]. */
export function nearestOnLine(p: Point, a: Point, b: Point): { point: Point; t: number } {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  const raw = square === 0 ? 0 : ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square;
  const t = Math.min(1, Math.max(0, raw));
  return { point: between(a, b, t), t };
}

/** A coordinate rounded to a multiple of `step`, without a trail of binary digits. */
export function roundTo(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toFixed(6));
}
