// Checks the options of every function; what is left out stays undefined, and the core decides.
import { bad, finite, object, oneOf, optional, positive, truth } from "./check.js";
import { parameters, sides } from "./pack.js";
import { packTools, radius } from "./tools.js";

/** @typedef {import("./check.js").Where} Where */

export const dialects = /** @type {const} */ (["auto", "linuxcnc", "fanuc", "sinumerik"]);
export const profiles = /** @type {const} */ (["g41", "linuxcnc", "fanuc", "isg", "sinumerik"]);
export const splines = /** @type {const} */ (["exact", "type-points"]);
export const outputs = /** @type {const} */ (["cubics", "arcs"]);
export const corners = /** @type {const} */ (["linear", "arc", "intersection"]);
export const leads = /** @type {const} */ ([
  ...["textbook", "perpendicular", "intersection", "extra-move", "linuxcnc"],
]);
export const targets = /** @type {const} */ ([
  ...["grbl", "grblhal", "linuxcnc", "smoothieware", "marlin", "fanuc-0m", "fanuc-6m", "fanuc-30i"],
  "heidenhain",
]);
const written = /** @type {const} */ (["arcs", "native"]);
export const gouges = /** @type {const} */ (["report", "avoid", "stop"]);

const settingKeys = [
  ...["profile", "tolerance", "spline", "corner", "lead", "tangentBand"],
  ...["gouge", "passes", "stepover"],
];
const contourKeys = new Set(["side", "radius", "output", ...settingKeys]);
const liveKeys = new Set(["chordTolerance", "side", "radius", ...settingKeys]);
const programKeys = new Set(["tools", "radius", "output", ...settingKeys]);
const contourCheckKeys = new Set(["radius", "tolerance"]);
const programCheckKeys = new Set(["tools", ...contourCheckKeys]);
const parseKeys = new Set([
  ...["dialect", "profile", "blockDelete", "splineParameter", "curveTolerance"],
]);
const gcodeKeys = new Set(["target", "tolerance", "splines", "feed", "clearance", "explain"]);

/** @type {(key: string) => Where} */
const at = (key) => () => `options.${key}`;
/** @type {Where} */
const here = () => "options";

/**
 * What is meant by a tolerance that is left out [mm]; the same as the core's for compensation.
 */
const defaultTolerance = 0.001;
const defaultCurveTolerance = 0.0001;

/**
 * Finest tolerance of polylines, of programs and of the judge [mm]: a nanometre, below which any
 * work takes long and nothing is gained.
 */
const finestTolerance = 1e-6;

/**
 * Finest tolerance of paths [mm]; the core's. What the digits of the coordinates cannot keep is less
 * exact all the same.
 */
const finestPath = 1e-9;

/**
 * @param {unknown} value
 * @param {Where} where
 * @param {number} [finest]
 */
function toleranceAt(value, where, finest = finestTolerance) {
  const number = finite(value, where);
  return number >= finest ? number : bad(where, `be at least ${finest} mm`);
}

/**
 * A tolerance that is an argument of its own.
 *
 * @param {unknown} value
 */
export function tolerance(value) {
  return optional(value, toleranceAt, () => "tolerance") ?? defaultTolerance;
}

/** @param {unknown} given */
export function contourOptions(given = {}) {
  const options = object(given, contourKeys, here);
  return settings(options);
}

/** @param {unknown} given */
export function liveOptions(given = {}) {
  const { chordTolerance, ...options } = object(given, liveKeys, here);
  const chord = optional(chordTolerance, toleranceAt, at("chordTolerance")) ?? defaultTolerance;
  return { settings: contourOptions(options), chord };
}

/** @param {unknown} given */
export function programOptions(given = {}) {
  const options = object(given, programKeys, here);
  return {
    tools: optional(options.tools, packTools) ?? new Float64Array(),
    settings: settings(options),
  };
}

/** @param {unknown} given */
export function contourCheckOptions(given = {}) {
  return checkOptions(object(given, contourCheckKeys, here));
}

/** @param {unknown} given */
export function programCheckOptions(given = {}) {
  const options = object(given, programCheckKeys, here);
  return {
    tools: optional(options.tools, packTools) ?? new Float64Array(),
    ...checkOptions(options),
  };
}

/** @param {Record<string, unknown>} options */
function checkOptions(options) {
  return {
    radius: optional(options.radius, radius, at("radius")),
    tolerance: optional(options.tolerance, toleranceAt, at("tolerance")) ?? defaultTolerance,
  };
}

/**
 * The options of reading a program, in the order of the core's arguments.
 *
 * @param {unknown} given
 */
export function parseOptions(given = {}) {
  const options = object(given, parseKeys, here);
  return /** @type {const} */ ([
    optional(options.dialect, (value) => oneOf(value, dialects, at("dialect"))),
    profile(options),
    optional(options.blockDelete, truth, at("blockDelete")) ?? false,
    optional(options.splineParameter, (value) => oneOf(value, parameters, at("splineParameter"))),
    optional(options.curveTolerance, toleranceAt, at("curveTolerance")) ?? defaultCurveTolerance,
  ]);
}

/**
 * The options that make up `EmitSettings` of the core, in the order of its constructor.
 *
 * @param {unknown} given
 */
export function gcodeOptions(given = {}) {
  const options = object(given, gcodeKeys, here);
  return /** @type {const} */ ([
    optional(options.target, (value) => oneOf(value, targets, at("target"))),
    optional(options.tolerance, toleranceAt, at("tolerance")) ?? defaultTolerance,
    optional(options.splines, (value) => oneOf(value, written, at("splines"))),
    optional(options.feed, positive, at("feed")),
    optional(options.clearance, finite, at("clearance")),
    optional(options.explain, (value) => truth(value, at("explain"))) ?? false,
  ]);
}

/**
 * The options that make up `Settings` of the core, in the order of its constructor.
 *
 * @param {Record<string, unknown>} options
 */
function settings(options) {
  const gouge = optional(options.gouge, (value) => oneOf(value, gouges, at("gouge")));
  return /** @type {const} */ ([
    // That of a program is no option, which has been seen to.
    optional(options.side, (value) => oneOf(value, sides, at("side"))),
    optional(options.radius, radius, at("radius")),
    profile(options),
    optional(options.tolerance, toleranceAt, at("tolerance"), finestPath),
    optional(options.spline, (value) => oneOf(value, splines, at("spline"))),
    optional(options.output, (value) => oneOf(value, outputs, at("output"))),
    optional(options.corner, (value) => oneOf(value, corners, at("corner"))),
    optional(options.lead, (value) => oneOf(value, leads, at("lead"))),
    optional(options.tangentBand, tangentBand),
    gouge,
    ...passes(options, gouge === "avoid"),
  ]);
}

/**
 * How many passes, nothing for all that there is room for, and their stepover, nothing for one.
 *
 * @param {Record<string, unknown>} options
 * @param {boolean} avoids
 * @returns {readonly [number | undefined, number | undefined]}
 */
function passes(options, avoids) {
  const count = optional(options.passes, passCount) ?? 1;
  const stepover = optional(options.stepover, positive, at("stepover"));
  if (count === 1) {
    return [undefined, undefined];
  }
  if (!avoids) {
    bad(at("gouge"), 'be "avoid" where there are several passes');
  }
  if (stepover === undefined) {
    bad(at("stepover"), "be given where there are several passes");
  }
  return [count === "all" ? undefined : count, stepover];
}

/** Most passes: more than any pocket has, and a count that the core can hold. */
const mostPasses = 1e6;

/**
 * @param {unknown} value
 * @returns {number | "all"}
 */
function passCount(value) {
  if (
    value === "all" ||
    (Number.isInteger(value) && Number(value) >= 1 && Number(value) <= mostPasses)
  ) {
    return /** @type {number | "all"} */ (value);
  }
  bad(at("passes"), `be "all", or a whole number from 1 to ${mostPasses}`);
}

/** @param {Record<string, unknown>} options */
function profile(options) {
  return optional(options.profile, (value) => oneOf(value, profiles, at("profile")));
}

/**
 * A number in rad, a negative one for "auto".
 *
 * @param {unknown} value
 */
function tangentBand(value) {
  if (value === "auto") {
    return -1;
  }
  const isBand = typeof value === "number" && value >= 0 && value < Math.PI;
  return isBand ? value : bad(at("tangentBand"), `be "auto", or at least 0 and below π`);
}
