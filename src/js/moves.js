// Unpacks moves from their records; the layout is that of `records()` in types.d.ts.

/** @typedef {import("./types.d.ts").Move} Move */
/** @typedef {import("./types.d.ts").Origin} Origin */
/** @typedef {import("./types.d.ts").Role} Role */
/** @typedef {import("./types.d.ts").Point3} Point3 */

/** @type {typeof import("./types.d.ts").RECORD_STRIDE} */
export const RECORD_STRIDE = 19;

export const RAPID = 0;
export const ARC = 2;
export const CUBIC = 3;
export const INVOLUTE = 4;

/** @type {readonly import("./types.d.ts").MoveBase["plane"][]} */
const planes = ["xy", "xz", "yz"];

/**
 * The indices, in x, y, z, of the two axes of each plane and of its normal.
 */
export const axes = /** @type {const} */ ([
  [0, 1, 2],
  [2, 0, 1],
  [1, 2, 0],
]);

/** @type {readonly Role[]} */
const roles = ["segment", "transition", "lead-in", "lead-out", "free", "link"];

/**
 * @param {Float64Array} records
 * @returns {Move[]}
 */
export function unpackMoves(records) {
  return Array.from({ length: records.length / RECORD_STRIDE }, (_, i) =>
    unpackMove(records.subarray(i * RECORD_STRIDE, (i + 1) * RECORD_STRIDE)),
  );
}

/**
 * Unpacks the ways between pieces: before each record stands the index of the move that it leads to.
 *
 * @param {Float64Array} numbers
 * @returns {import("./types.d.ts").Way[]}
 */
export function unpackWays(numbers) {
  const stride = 1 + RECORD_STRIDE;
  return Array.from({ length: numbers.length / stride }, (_, i) => {
    const at = i * stride;
    return {
      before: /** @type {number} */ (numbers[at]),
      move: unpackMove(numbers.subarray(at + 1, at + stride)),
    };
  });
}

/**
 * @param {Float64Array} record
 * @returns {Move}
 */
function unpackMove(record) {
  const [kind, role, plane, feed, block, number, column, contour, segment, ...geometry] =
    /** @type {number[] & { length: 19 }} */ (/** @type {unknown} */ (record));
  const [x0, y0, z0, x1, y1, z1, a, b, c, d] = geometry;
  const base = {
    plane: planes[plane],
    from: /** @type {Point3} */ ([x0, y0, z0]),
    to: /** @type {Point3} */ ([x1, y1, z1]),
    ...(Number.isNaN(feed) ? {} : { feed }),
    role: roles[role],
    origin: origin(block, number, column, contour, segment),
  };
  const [first, second, normal] = axes[plane];
  const [height, end] = [base.from[normal], base.to[normal]];
  /** @type {(x: number, y: number, z: number) => Point3} */
  const place = (...point) => {
    /** @type {[number, number, number]} */
    const placed = [0, 0, 0];
    [placed[first], placed[second], placed[normal]] = point;
    return placed;
  };
  switch (kind) {
    case RAPID:
      return { kind: "rapid", ...base };
    case ARC:
      return { kind: "arc", ...base, center: place(a, b, height), clockwise: d === 1, radius: c };
    case CUBIC: {
      // The height changes evenly along the curve.
      const rise = (end - height) / 3;
      const control1 = place(a, b, height + rise);
      return { kind: "cubic", ...base, control1, control2: place(c, d, end - rise) };
    }
    case INVOLUTE: {
      const center = place(a, b, height);
      return { kind: "involute", ...base, center, baseRadius: c, clockwise: d === 1 };
    }
    default:
      return { kind: "line", ...base };
  }
}

/**
 * @param {number} block
 * @param {number} number
 * @param {number} column
 * @param {number} contour
 * @param {number} segment
 * @returns {Origin}
 */
function origin(block, number, column, contour, segment) {
  if (Number.isNaN(block)) {
    return Number.isNaN(contour) ? { segment } : { segment, contour };
  }
  return {
    block,
    ...(Number.isNaN(number) ? {} : { number }),
    ...(Number.isNaN(column) ? {} : { column }),
  };
}
