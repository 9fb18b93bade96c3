// Unpacks polylines.

/**
 * @param {[points3: Float64Array, starts: Uint32Array, owners: Uint32Array]} arrays
 * @returns {import("./types.d.ts").Polylines}
 */
export function unpackPolylines([points3, starts, owners]) {
  const points = new Float64Array(owners.length * 2);
  for (let i = 0; i < owners.length; i++) {
    points[2 * i] = /** @type {number} */ (points3[3 * i]);
    points[2 * i + 1] = /** @type {number} */ (points3[3 * i + 1]);
  }
  return { points, points3, starts, owners };
}
