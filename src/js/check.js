// Checks of arguments: each accepts a value, or says where and how it is wrong.
import { coded } from "./lifecycle.js";

/** @typedef {() => string} Where  names the place of a value; called only where it is wrong */

/**
 * @param {Where} where
 * @param {string} must what the value must be or do
 * @returns {never}
 */
export function bad(where, must) {
  const path = where();
  throw coded("bad-argument", `${path} must ${must}`, { path });
}

/**
 * Whether a value is an object with keys of its own, and no array of any type, map or set, of which
 * none of the keys would be seen.
 *
 * @param {unknown} value
 * @returns {value is Record<string, unknown>}
 */
export function isPlain(value) {
  return Object.prototype.toString.call(value) === "[object Object]";
}

/**
 * A plain object with none but the given keys.
 *
 * @param {unknown} value
 * @param {ReadonlySet<string>} keys
 * @param {Where} where
 * @returns {Record<string, unknown>}
 */
export function object(value, keys, where) {
  if (!isPlain(value)) {
    bad(where, "be an object");
  }
  for (const key in value) {
    if (!keys.has(key)) {
      bad(() => property(where, key), `not be there: known are ${[...keys].join(", ")}`);
    }
  }
  return value;
}

/**
 * The path of a property, which at the root is its name alone.
 *
 * @param {Where} where
 * @param {string} key
 */
export function property(where, key) {
  const parent = where();
  return parent === "" ? key : `${parent}.${key}`;
}

/**
 * @param {unknown} value
 * @param {Where} where
 * @returns {number}
 */
export function finite(value, where) {
  if (typeof value !== "number" || !Number.isFinite(value)) {
    bad(where, "be a finite number");
  }
  return value;
}

/**
 * A number that is positive.
 *
 * @param {unknown} value
 * @param {Where} where
 */
export function positive(value, where) {
  const number = finite(value, where);
  return number > 0 ? number : bad(where, "be greater than 0");
}

/**
 * @param {unknown} value
 * @param {Where} where
 * @returns {boolean}
 */
export function truth(value, where) {
  return typeof value === "boolean" ? value : bad(where, "be true or false");
}

/**
 * @param {unknown} value
 * @param {Where} where
 * @returns {readonly [number, number]}
 */
export function point(value, where) {
  const given = /** @type {ArrayLike<unknown>} */ (value);
  if ((!Array.isArray(value) && !ArrayBuffer.isView(value)) || given.length !== 2) {
    bad(where, "be a point [x, y]");
  }
  return [finite(given[0], () => `${where()}[0]`), finite(given[1], () => `${where()}[1]`)];
}

/**
 * One of several names.
 *
 * @template {string} Name
 * @param {unknown} value
 * @param {readonly Name[]} names
 * @param {Where} where
 * @returns {Name}
 */
export function oneOf(value, names, where) {
  if (names.includes(/** @type {Name} */ (value))) {
    return /** @type {Name} */ (value);
  }
  bad(where, `be ${names.map((name) => `"${name}"`).join(" or ")}`);
}

/**
 * The same check, but for a value that may be left out.
 *
 * @template T
 * @template {unknown[]} More
 * @param {unknown} value
 * @param {(value: unknown, ...more: More) => T} check
 * @param {More} more
 * @returns {T | undefined}
 */
export function optional(value, check, ...more) {
  return value === undefined ? undefined : check(value, ...more);
}
