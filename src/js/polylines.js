// Unpacks polylines.
import { tolerance } from "./options.js";

/** @typedef {import("./g41.js").ProgramHandle | import("./g41.js").ToolPathHandle} Raw */

/**
 * The polylines of what a handle holds.
 *
 * @param {import("./lifecycle.js").Handle<Raw>} handle
 * @param {number} [within]
 * @returns {import("./types.d.ts").Polylines}
 */
export function polylinesOf(handle, within) {
  const chord = tolerance(within);
  const { diagnostics: _, ...polylines } = handle.use((raw) =>
    unpackPolylines(raw.polylines(chord)),
  );
  return polylines;
}

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
