// Checks the tools that a program calls, and packs them into numbers.
import { bad, finite, isPlain, object, optional } from "./check.js";

/** @typedef {import("./check.js").Where} Where */

const keys = new Set(["radius", "diameter", "orientation"]);

/** @type {Where} */
const here = () => "options.tools";

/**
 * Four numbers for each tool: its own, 0 and the radius [mm], or 1 and the diameter in the unit of
 * the program, and the orientation.
 *
 * @param {unknown} given
 */
export function packTools(given) {
  if (!isPlain(given)) {
    bad(here, "be an object of tools by their number");
  }
  return Float64Array.from(
    Object.entries(given).flatMap(([number, tool]) => {
      /** @type {Where} */
      const where = () => `${here()}[${number}]`;
      if (!/^\d{1,9}$/.test(number)) {
        bad(where, "have a whole number for its name");
      }
      return [Number(number), ...size(object(tool, keys, where), where)];
    }),
  );
}

/**
 * A radius, which may be negative to swap the side.
 *
 * @param {unknown} value
 * @param {Where} where
 */
export function radius(value, where) {
  const number = finite(value, where);
  return Math.abs(number) <= 1e7 ? number : bad(where, "be at most 1e7 mm");
}

/**
 * @param {Record<string, unknown>} tool
 * @param {Where} where
 * @returns {[isDiameter: number, size: number, orientation: number]}
 */
function size(tool, where) {
  const turns = optional(tool.orientation, orientation, () => `${where()}.orientation`) ?? 0;
  if (tool.diameter === undefined) {
    return [0, radius(tool.radius, () => `${where()}.radius`), turns];
  }
  if (tool.radius !== undefined) {
    bad(where, "have a radius or a diameter, not both");
  }
  return [1, finite(tool.diameter, () => `${where()}.diameter`), turns];
}

/**
 * @param {unknown} value
 * @param {Where} where
 */
function orientation(value, where) {
  const number = Number.isInteger(value) ? Number(value) : -1;
  return number >= 0 && number <= 9 ? number : bad(where, "be a whole number from 0 to 9");
}
