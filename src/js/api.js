// The functions of the package, the same for every way of loading it.
import { bad } from "./check.js";
import { call } from "./lifecycle.js";
import { LiveContour } from "./live.js";
import { Motion } from "./motion.js";
import { contourCheckOptions, contourOptions, programCheckOptions, tolerance } from "./options.js";
import { packContours } from "./pack.js";
import { unpackPolylines } from "./polylines.js";
import { Program, useProgram } from "./program.js";
import { ProgramCompensation, ProgramReader } from "./slices.js";
import { ToolPath, useToolPath } from "./tool_path.js";

export { interpolate } from "./interpolate.js";
export { RECORD_STRIDE } from "./moves.js";
export { readToolTable } from "./tool_table.js";
export { LiveContour, Motion, Program, ProgramCompensation, ProgramReader, ToolPath };

/**
 * @param {string} text
 * @param {unknown} [options]
 */
export function parseProgram(text, options) {
  return new ProgramReader(text, options).finish();
}

/**
 * @param {unknown} contours a program, or contours
 * @param {unknown} [options]
 */
export function compensate(contours, options) {
  ready();
  if (contours instanceof Program) {
    return new ProgramCompensation(contours, options).finish();
  }
  const settings = contourOptions(options);
  const records = packContours(contours);
  return new ToolPath((glue) => glue.compensateContours(records, new glue.Settings(...settings)));
}

/**
 * @param {unknown} contours a program, or contours
 * @param {unknown} path
 * @param {unknown} [options]
 */
export function check(contours, path, options) {
  ready();
  if (!(path instanceof ToolPath)) {
    bad(() => "path", "be a tool path that compensate has made");
  }
  if (contours instanceof Program) {
    const { tools, radius, tolerance } = programCheckOptions(options);
    const gouges = useProgram(contours, (program) =>
      useToolPath(path, (raw) => program.check(raw, tools, radius, tolerance)),
    );
    return JSON.parse(gouges);
  }
  const { radius, tolerance } = contourCheckOptions(options);
  const records = packContours(contours);
  return JSON.parse(
    useToolPath(path, (raw, glue) => glue.checkContours(records, raw, radius, tolerance)),
  );
}

/**
 * @param {unknown} contours
 * @param {number} [within]
 */
export function flatten(contours, within) {
  ready();
  const chord = tolerance(within);
  const records = packContours(contours);
  return call((glue) => unpackPolylines(glue.flattenContours(records, chord)));
}

/** The version of the package. */
export function version() {
  return call((glue) => glue.version());
}

/** Throws where g41 is not ready, before any fault is found with arguments. */
function ready() {
  call(() => {});
}
