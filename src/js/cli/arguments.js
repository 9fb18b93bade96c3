// Reads the arguments of a command by its table of options, and says what is wrong with them.

import { parseArgs } from "node:util";
import { decimal } from "../decimal.js";

import { misused } from "./failure.js";
import { nearest } from "./nearest.js";

/** @typedef {import("./flags.js").Flag} Flag */
/** @typedef {Readonly<Record<string, Flag>>} Flags */

/**
 * What was given: an option that takes no value is `true`, one that may be repeated an array.
 *
 * @typedef {Record<string, string | number | true | string[]>} Values
 */

/**
 * @param {readonly string[]} args
 * @param {Flags} flags
 * @param {string} command what to say before --help
 * @returns {{ values: Values, files: string[] }}
 */
export function readArguments(args, flags, command) {
  // Not strict, so that what is wrong is said in the words of this command.
  const { tokens } = parseArgs({
    args: [...args],
    options: Object.fromEntries(
      Object.entries(flags).map(([name, { value, short }]) => [
        name,
        { type: value ? "string" : "boolean", ...(short ? { short } : {}) },
      ]),
    ),
    strict: false,
    allowPositionals: true,
    tokens: true,
  });
  /** @type {Values} */
  const values = {};
  /** @type {string[]} */
  const files = [];
  for (const token of tokens) {
    if (token.kind === "positional") {
      files.push(token.value);
    } else if (token.kind === "option") {
      const flag = Object.hasOwn(flags, token.name) ? flags[token.name] : undefined;
      if (!flag) {
        unknown(token.rawName, flags, command);
      }
      const value = read(token, flag);
      if (flag.several) {
        const before = values[token.name] ?? [];
        values[token.name] = [.../** @type {string[]} */ (before), String(value)];
      } else {
        values[token.name] = value;
      }
    }
  }
  return { values, files };
}

/**
 * @param {string} given
 * @param {Flags} flags
 * @param {string} command
 * @returns {never}
 */
function unknown(given, flags, command) {
  const meant = given.startsWith("--") ? nearest(given.slice(2), Object.keys(flags)) : undefined;
  const hint = meant ? `did you mean --${meant}?` : `${command} --help lists the options`;
  misused(`${given}: there is no such option`, hint);
}

/**
 * @param {{ rawName: string, value?: string | undefined, inlineValue?: boolean | undefined }} token
 * @param {Flag} flag
 * @returns {string | number | true}
 */
function read({ rawName, value, inlineValue }, flag) {
  if (!flag.value) {
    return value === undefined ? true : misused(`${rawName} takes no value, not "${value}" either`);
  }
  const isOption = value?.startsWith("-") && value.length > 1 && !/^-[\d.]/.test(value);
  if (value === undefined || value === "" || (isOption && !inlineValue)) {
    misused(`${rawName} needs a value: ${rawName} ${flag.value}`);
  }
  if (flag.names?.includes(value)) {
    return value;
  }
  if (flag.kind === "number") {
    const others = flag.names ? ` or ${flag.names.join(", ")}` : "";
    return decimal(value) ?? misused(`${rawName} must be a number${others}, not "${value}"`);
  }
  if (flag.names) {
    const meant = nearest(value, flag.names);
    misused(
      `${rawName} must be one of ${flag.names.join(", ")}, not "${value}"`,
      meant && `did you mean ${meant}?`,
    );
  }
  return value;
}
