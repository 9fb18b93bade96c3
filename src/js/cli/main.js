// The command g41: finds the command meant, runs it, and tells how it ended.
import { readArguments } from "./arguments.js";
import { exit, Failure, misused } from "./failure.js";
import { commands, flagsOf, withoutCommand } from "./flags.js";
import { helpOf, overview } from "./help.js";
import { nearest } from "./nearest.js";
import { write } from "./output.js";
import { complain } from "./report.js";

/** @typedef {import("./arguments.js").Values} Values */

// Loaded when they run, since the help needs no WebAssembly.
/** @type {Readonly<Record<string, () => Promise<(files: string[], values: Values) => Promise<number>>>>} */
const runs = {
  convert: async () => (await import("./convert.js")).convert,
  check: async () => (await import("./check.js")).check,
  plan: async () => (await import("./plan.js")).plan,
};

/**
 * @param {readonly string[]} args
 * @returns {Promise<number>} the exit code
 */
export async function main(args) {
  try {
    return await run(args);
  } catch (error) {
    const { code, message, hint } = failureOf(error);
    complain(message, hint);
    return code;
  }
}

/** @param {readonly string[]} args */
async function run([first, ...rest]) {
  const command =
    first === undefined || !Object.hasOwn(commands, first) ? undefined : commands[first];
  if (first === undefined || first.startsWith("-")) {
    return await general(first === undefined ? [] : [first, ...rest]);
  }
  if (!command) {
    const meant = nearest(first, Object.keys(commands)) ?? "convert";
    misused(
      `${first}: there is no such command`,
      `did you mean g41 ${meant}? g41 --help lists them`,
    );
  }
  const { values, files } = readArguments(rest, flagsOf(command.groups), `g41 ${first}`);
  if (values.help) {
    return await say(helpOf(command));
  }
  if (values.version) {
    return await sayVersion();
  }
  const work = await runs[first]?.();
  return work ? await work(files, values) : exit.internal;
}

/**
 * What is asked for without a command.
 *
 * @param {readonly string[]} args
 */
async function general(args) {
  const { values } = readArguments(args, flagsOf(withoutCommand), "g41");
  if (values.help) {
    return await say(overview());
  }
  if (values.version) {
    return await sayVersion();
  }
  const names = Object.keys(commands).map((name) => `g41 ${name} FILE`);
  misused("a command is missing", `${names.join(", ")}, or g41 --help`);
}

/** @param {string} text */
async function say(text) {
  await write(undefined, [`${text}\n`], "utf8");
  return exit.fine;
}

async function sayVersion() {
  const { version } = await import("../node.js");
  return await say(version());
}

/**
 * @param {unknown} error
 * @returns {{ code: number, message: string, hint?: string | undefined }}
 */
function failureOf(error) {
  if (error instanceof Failure) {
    return error;
  }
  const { code, path, message, stack } = /** @type {Error & { code?: string, path?: string }} */ (
    error
  );
  if (code === "bad-argument") {
    // The package names its own options.
    const flag = (/** @type {string} */ name) =>
      `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
    return {
      code: exit.usage,
      message: message
        .replace(/^options\.(\w+)/, (_, name) => flag(name))
        .replace(/^limits\./, "--limits: "),
    };
  }
  if (path !== undefined) {
    return { code: exit.file, message };
  }
  if (code === "out-of-memory") {
    const hint = "look for a loop without end, or cut the program into parts";
    return { code: exit.internal, message, hint };
  }
  return {
    code: exit.internal,
    message: stack ?? message,
    hint: "this is a fault of g41: please report it",
  };
}
