// Reads --limits: names and values, as in velocity=200,acceleration=2000,jerk=5e4.
import { decimal } from "../decimal.js";
import { limitNames } from "../limits.js";
import { misused } from "./failure.js";
import { nearest } from "./nearest.js";

/** What is meant by each form of a value. */
const example = "--limits velocity=200,acceleration=2000,jerk=5e4";

/** The limits of single axes are given one by one: axes.jerk=5e4/5e4/2e4. */
const axisNames = ["axes.velocity", "axes.acceleration", "axes.jerk"];
const names = [...limitNames.filter((name) => name !== "axes"), ...axisNames];

/**
 * The limits as the package takes them, which looks at each value.
 *
 * @param {unknown} given the texts of all --limits
 * @returns {import("../types.d.ts").Limits}
 */
export function limitsOf(given) {
  /** @type {Record<string, unknown>} */
  const limits = {};
  /** @type {Record<string, unknown>} */
  const axes = {};
  for (const part of /** @type {string[]} */ (given ?? []).flatMap((text) => text.split(","))) {
    const [, name = "", value = ""] = part.match(/^\s*([^=]*?)\s*=\s*(.*?)\s*$/) ?? [];
    if (!names.includes(name)) {
      const meant = nearest(name, names);
      misused(
        name ? `--limits: there is no limit ${name}` : `--limits must be NAME=VALUE, not "${part}"`,
        meant ? `did you mean ${meant}?` : `there are ${names.join(", ")}`,
      );
    }
    if (axisNames.includes(name)) {
      axes[name.slice(5)] = value.split("/").map((one) => numberOf(name, one));
    } else if (name === "exactStop") {
      limits[name] = value === "true" ? true : value === "false" ? false : value;
    } else if (["mode", "curvatureSteps", "corner"].includes(name)) {
      limits[name] = value;
    } else {
      limits[name] = numberOf(name, value);
    }
  }
  for (const name of ["velocity", "acceleration", "jerk"]) {
    if (!(name in limits)) {
      misused(`--limits must give the machine's ${name}`, example);
    }
  }
  const all = Object.keys(axes).length > 0 ? { ...limits, axes } : limits;
  return /** @type {import("../types.d.ts").Limits} */ (/** @type {unknown} */ (all));
}

/**
 * @param {string} name
 * @param {string} text
 */
function numberOf(name, text) {
  return decimal(text) ?? misused(`--limits: ${name} must be a number, not "${text}"`, example);
}
