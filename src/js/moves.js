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

/** @type {readonly Role[]} */
const roles = ["segment", "transition", "lead-in", "lead-out", "free"];

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
 * @param {Float64Array} record
 * @returns {Move}
 */
function unpackMove(record) {
  const [kind, role, , feed, block, number, column, contour, segment, ...geometry] =
    /** @type {number[] & { length: 19 }} */ (/** @type {unknown} */ (record));
  const [x0, y0, z0, x1, y1, z1, a, b, c, d] = geometry;
  const base = {
    plane: /** @type {const} */ ("xy"),
    from: /** @type {Point3} */ ([x0, y0, z0]),
    to: /** @type {Point3} */ ([x1, y1, z1]),
    ...(Number.isNaN(feed) ? {} : { feed }),
    role: roles[role],
    origin: origin(block, number, column, contour, segment),
  };
  switch (kind) {
    case RAPID:
      return { kind: "rapid", ...base };
    case ARC:
      return { kind: "arc", ...base, center: [a, b, z0], clockwise: d === 1, radius: c };
    case CUBIC: {
      // The height changes evenly along the curve.
      const rise = (z1 - z0) / 3;
      return { kind: "cubic", ...base, control1: [a, b, z0 + rise], control2: [c, d, z1 - rise] };
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
