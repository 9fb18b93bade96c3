// Draws moves from their records, on a canvas or as SVG path data.
import { ARC, axes, CUBIC, INVOLUTE, RAPID, RECORD_STRIDE } from "./moves.js";

/**
 * Distance from which on two moves do not follow each other [mm]: a nanometre, which no machine
 * resolves, and which rounding of coordinates does not reach.
 */
const gap = 1e-6;

/**
 * The arc of a move: its ends, its centre, and the angles of both ends seen from there, of which
 * the second is reached in the sense of the arc.
 *
 * @typedef {object} Arc
 * @property {readonly [number, number]} to
 * @property {readonly [number, number]} center
 * @property {number} radius
 * @property {boolean} clockwise
 * @property {number} startAngle
 * @property {number} endAngle
 */

/**
 * What moves are drawn with.
 *
 * @typedef {object} Pen
 * @property {(x: number, y: number) => void} begin begins a piece
 * @property {(x: number, y: number) => void} line
 * @property {(arc: Arc) => void} arc
 * @property {(x1: number, y1: number, x2: number, y2: number, x: number, y: number) => void} cubic
 */

/**
 * Draws all moves but rapid ones, each by the two axes of its plane.
 *
 * @param {Float64Array} records
 * @param {Pen} pen
 */
function draw(records, pen) {
  let [x, y, z] = [Number.NaN, Number.NaN, Number.NaN];
  for (let i = 0; i < records.length; i += RECORD_STRIDE) {
    const kind = records[i];
    const [first, second, normal] = axes[records[i + 2]];
    const from = records.subarray(i + 9, i + 12);
    const to = records.subarray(i + 12, i + 15);
    const [a, b, c, d] = records.subarray(i + 15, i + RECORD_STRIDE);
    const [x0, y0, z0] = [from[first], from[second], from[normal]];
    const [x1, y1, z1] = [to[first], to[second], to[normal]];
    if (kind === RAPID) {
      x = Number.NaN;
      continue;
    }
    // NaN is no distance from anything, so a piece begins after a rapid move too.
    if (!(Math.hypot(x0 - x, y0 - y) <= gap && Math.abs(z0 - z) <= gap)) {
      pen.begin(x0, y0);
    }
    if (kind === ARC) {
      pen.arc(arc([x0, y0], [x1, y1], [a, b], c, d === 1));
    } else if (kind === CUBIC) {
      pen.cubic(a, b, c, d, x1, y1);
    } else if (kind === INVOLUTE) {
      involute(pen, [x0, y0], [x1, y1], [a, b], c, d === 1);
    } else {
      pen.line(x1, y1);
    }
    [x, y, z] = [x1, y1, z1];
  }
}

/**
 * @param {readonly [number, number]} from
 * @param {readonly [number, number]} to
 * @param {readonly [number, number]} center
 * @param {number} radius
 * @param {boolean} clockwise
 * @returns {Arc}
 */
function arc(from, to, center, radius, clockwise) {
  const startAngle = Math.atan2(from[1] - center[1], from[0] - center[0]);
  let endAngle = Math.atan2(to[1] - center[1], to[0] - center[0]);
  const turn = 2 * Math.PI;
  // An arc whose ends are less than 1e-9 mm apart is a full circle.
  if (Math.hypot(to[0] - from[0], to[1] - from[1]) < 1e-9) {
    endAngle = startAngle + (clockwise ? -turn : turn);
  } else if (clockwise && endAngle > startAngle) {
    endAngle -= turn;
  } else if (!clockwise && endAngle < startAngle) {
    endAngle += turn;
  }
  return { to, center, radius, clockwise, startAngle, endAngle };
}

/** Angle over which one cubic follows an involute to a millionth of its base radius [rad]. */
const step = 0.1;

/**
 * Draws an involute by cubics with its points and derivatives.
 *
 * @param {Pen} pen
 * @param {readonly [number, number]} from
 * @param {readonly [number, number]} to
 * @param {readonly [number, number]} center
 * @param {number} radius
 * @param {boolean} clockwise
 */
function involute(pen, from, to, [cx, cy], radius, clockwise) {
  /** @type {(point: readonly [number, number]) => number} */
  const roll = ([x, y]) => Math.sqrt(Math.max(0, (Math.hypot(x - cx, y - cy) / radius) ** 2 - 1));
  const [start, end] = [roll(from), roll(to)];
  const hand = end > start === clockwise ? -1 : 1;
  const first = Math.atan2(from[1] - cy, from[0] - cx) + hand * Math.atan(start);
  /** Where the thread ends, and how fast it does. @type {(turned: number) => number[]} */
  const at = (turned) => {
    const [angle, thread] = [first + hand * (turned - start), radius * turned];
    const [x, y] = [Math.cos(angle), Math.sin(angle)];
    return [
      cx + radius * x + hand * thread * y,
      cy + radius * y - hand * thread * x,
      thread * x,
      thread * y,
    ];
  };
  const steps = Math.max(1, Math.ceil(Math.abs(end - start) / step));
  const third = (end - start) / steps / 3;
  let [x0, y0, dx0, dy0] = at(start);
  for (let i = 1; i <= steps; i++) {
    const [x1, y1, dx1, dy1] = at(start + ((end - start) * i) / steps);
    pen.cubic(
      x0 + third * dx0,
      y0 + third * dy0,
      x1 - third * dx1,
      y1 - third * dy1,
      ...(i < steps ? /** @type {const} */ ([x1, y1]) : to),
    );
    [x0, y0, dx0, dy0] = [x1, y1, dx1, dy1];
  }
}

/**
 * Draws on a canvas context or a `Path2D`, whose y is to be turned up by its user.
 *
 * @template {CanvasPath} T
 * @param {Float64Array} records
 * @param {T} context
 */
export function drawOn(context, records) {
  draw(records, {
    begin: (x, y) => context.moveTo(x, y),
    line: (x, y) => context.lineTo(x, y),
    // A canvas takes its y to be down, so its "counterclockwise" is our clockwise.
    arc: ({ center: [x, y], radius, startAngle, endAngle, clockwise }) =>
      context.arc(x, y, radius, startAngle, endAngle, clockwise),
    cubic: (x1, y1, x2, y2, x, y) => context.bezierCurveTo(x1, y1, x2, y2, x, y),
  });
  return context;
}

/**
 * SVG path data.
 *
 * @param {Float64Array} records
 */
export function svgData(records) {
  /** @type {string[]} */
  const data = [];
  draw(records, {
    begin: (x, y) => data.push(`M${x} ${y}`),
    line: (x, y) => data.push(`L${x} ${y}`),
    arc: ({ to, center: [x, y], radius, clockwise, startAngle, endAngle }) => {
      // In two halves, since SVG has no full circle.
      const middle = (startAngle + endAngle) / 2;
      const half = `A${radius} ${radius} 0 0 ${Number(!clockwise)}`;
      data.push(`${half} ${x + radius * Math.cos(middle)} ${y + radius * Math.sin(middle)}`);
      data.push(`${half} ${to[0]} ${to[1]}`);
    },
    cubic: (x1, y1, x2, y2, x, y) => data.push(`C${x1} ${y1} ${x2} ${y2} ${x} ${y}`),
  });
  return data.join("");
}
