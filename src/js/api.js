// The functions of the package, the same for every way of loading it.
import { call, coded } from "./lifecycle.js";
import { contourOptions, tolerance } from "./options.js";
import { packContours } from "./pack.js";
import { unpackPolylines } from "./polylines.js";
import { ToolPath } from "./tool_path.js";

/** @typedef {typeof import("./types.d.ts")} Face */

export { RECORD_STRIDE } from "./moves.js";
export { ToolPath };

/** @returns {never} */
export function parseProgram() {
  throw coded("not-supported", "parseProgram() is not in this version of g41");
}

/**
 * @param {unknown} contours
 * @param {unknown} [options]
 */
export function compensate(contours, options) {
  // Says that g41 is not ready before it finds fault with anything else.
  call(() => {});
  const { side, radius, settings } = contourOptions(options);
  const records = packContours(contours);
  return new ToolPath((glue) =>
    glue.compensateContours(records, side, radius, new glue.Settings(...settings)),
  );
}

/**
 * @param {unknown} contours
 * @param {number} [within]
 */
export function flatten(contours, within) {
  call(() => {});
  const chord = tolerance(within);
  const records = packContours(contours);
  return call((glue) => {
    const flattened = glue.flattenContours(records, chord);
    const diagnostics = JSON.parse(flattened.diagnostics());
    return { ...unpackPolylines(flattened.intoPolylines()), diagnostics };
  });
}

/** The version of the package. */
export function version() {
  return call((glue) => glue.version());
}
