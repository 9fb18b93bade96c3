// Checks what a machine can do, and packs it for the core, which looks at the ranges.
import { bad, finite, object, oneOf, optional, positive, truth } from "./check.js";

export const modes = /** @type {const} */ (["fast", "textbook"]);
export const curvatureSteps = /** @type {const} */ (["round", "slow", "stop"]);
const cornerCurves = /** @type {const} */ (["eased", "ph13", "ph11", "ph9", "ph5"]);

/** The limits that are numbers, and what is meant where one is left out; without that it is required. */
export const numbers = /** @type {const} */ ({
  velocity: undefined,
  acceleration: undefined,
  jerk: undefined,
  cornerDeviation: 0.05,
  chordError: 0.001,
  period: 0.001,
  snap: Number.NaN,
  feedOverride: 1,
});

/** All limits there are, in the order in which they are listed. */
export const limitNames = /** @type {const} */ ([
  ...["velocity", "acceleration", "jerk", "cornerDeviation", "chordError", "period", "snap"],
  ...["feedOverride", "mode", "curvatureSteps", "corner", "exactStop", "axes"],
]);
const keys = new Set(limitNames);
const axisKeys = new Set(["velocity", "acceleration", "jerk"]);

/** @type {(key: string) => () => string} */
const at = (key) => () => `limits.${key}`;

/**
 * The limits as numbers, in the order of the core.
 *
 * @param {unknown} given
 * @returns {Float64Array}
 */
export function packLimits(given) {
  const limits = object(given, keys, () => "limits");
  const packed = Object.entries(numbers).map(([key, otherwise]) => {
    const check = key === "cornerDeviation" ? finite : positive;
    return optional(limits[key], check, at(key)) ?? otherwise ?? bad(at(key), "be given");
  });
  for (const [key, names] of /** @type {const} */ ([
    ["mode", modes],
    ["curvatureSteps", curvatureSteps],
    ["corner", cornerCurves],
  ])) {
    const name = optional(limits[key], (value) => oneOf(value, names, at(key)));
    packed.push(name === undefined ? 0 : /** @type {readonly string[]} */ (names).indexOf(name));
  }
  packed.push(Number(optional(limits.exactStop, truth, at("exactStop")) ?? false));
  return Float64Array.from([...packed, ...axes(limits.axes)]);
}

/**
 * @param {unknown} given
 * @returns {readonly number[]}
 */
function axes(given) {
  if (given === undefined) {
    return [];
  }
  const limits = object(given, axisKeys, at("axes"));
  return [...axisKeys].flatMap((key) => {
    const where = at(`axes.${key}`);
    const three = /** @type {ArrayLike<unknown>} */ (limits[key]);
    if ((!Array.isArray(three) && !ArrayBuffer.isView(three)) || three.length !== 3) {
      bad(where, "be three numbers, for x, y and z");
    }
    return Array.from(three, (value, i) => positive(value, () => `${where()}[${i}]`));
  });
}
