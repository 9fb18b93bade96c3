// Unpacks polylines.

/**
 * @param {import("./g41.js").PolylinesHandle} raw is freed
 * @returns {import("./types.d.ts").FlattenedContours}
 */
export function unpackPolylines(raw) {
  const diagnostics = JSON.parse(raw.diagnostics());
  const [points3, starts, owners] = [raw.takePoints(), raw.takeStarts(), raw.takeOwners()];
  raw.free();
  const points = new Float64Array(owners.length * 2);
  for (let i = 0; i < owners.length; i++) {
    points[2 * i] = /** @type {number} */ (points3[3 * i]);
    points[2 * i + 1] = /** @type {number} */ (points3[3 * i + 1]);
  }
  return { points, points3, starts, owners, diagnostics };
}
