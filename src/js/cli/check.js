// g41 check: programs are compensated and judged by distances.
import { compensate, check as judge, parseProgram } from "../node.js";
import { exit, Failure, misused } from "./failure.js";
import { nameOf, readProgram } from "./input.js";
import { write } from "./output.js";
import { Progress } from "./progress.js";
import { complain, report } from "./report.js";
import { checkOptions, parseOptions, programOptions, toolsOf } from "./settings.js";

/** @typedef {import("./arguments.js").Values} Values */
/** @typedef {import("../types.d.ts").Diagnostic} Diagnostic */
/** @typedef {import("../types.d.ts").Gouge} Gouge */
/** @typedef {import("../types.d.ts").Origin} Origin */

/** @type {import("./progress.js").Steps} */
const steps = [
  ["reading", 0.2],
  ["compensating", 0.9],
  ["judging", 0.9],
];

/**
 * @param {readonly string[]} files
 * @param {Values} values
 * @returns {Promise<number>} the exit code
 */
export async function check(files, values) {
  if (files.length === 0) {
    misused("the program is missing", "g41 check FILE…, or g41 check - for standard input");
  }
  const tools = await toolsOf(values);
  /** @type {string[]} */
  const results = [];
  /** @type {number} */
  let code = exit.fine;
  for (const file of files) {
    const text = await readOrComplain(file);
    if (text === undefined) {
      code = exit.file;
      continue;
    }
    const { told, gouges } = await judged(text, values, tools);
    const found = [...told, ...untold(gouges, told)];
    report(nameOf(file), found);
    const count = (/** @type {Diagnostic["severity"]} */ severity) =>
      found.filter((diagnostic) => diagnostic.severity === severity).length;
    const [errors, warnings] = [count("error"), count("warning")];
    const summary = [numbered(errors, "error"), numbered(warnings, "warning"), worst(gouges)];
    if (values.json) {
      results.push(JSON.stringify({ file: nameOf(file), diagnostics: told, gouges }));
    } else {
      await write(undefined, [`${nameOf(file)}: ${summary.join(", ")}\n`], "utf8");
    }
    if (errors > 0 || gouges.length > 0) {
      code = Math.max(code, exit.faults);
    }
  }
  if (values.json) {
    await write(undefined, [`[${results.join(",\n")}]\n`], "utf8");
  }
  return code;
}

/**
 * The text of a file; nothing where it cannot be read, which does not keep others from being judged.
 *
 * @param {string} file
 * @returns {Promise<string | undefined>}
 */
async function readOrComplain(file) {
  try {
    return (await readProgram(file)).text;
  } catch (error) {
    if (!(error instanceof Failure)) {
      throw error;
    }
    complain(error.message, error.hint);
    return undefined;
  }
}

/**
 * What is told of a program and its path, and the gouges that the judge finds.
 *
 * @param {string} text
 * @param {Values} values
 * @param {Awaited<ReturnType<typeof toolsOf>>} tools
 * @returns {Promise<{ told: Diagnostic[], gouges: Gouge[] }>}
 */
async function judged(text, values, tools) {
  const progress = new Progress(text.length, steps);
  try {
    progress.next();
    const program = parseProgram(text, parseOptions(values));
    progress.next();
    const path = compensate(program, programOptions(values, tools));
    progress.next();
    const gouges = judge(program, path, checkOptions(values, tools));
    const told = path.diagnostics;
    program[Symbol.dispose]?.();
    path[Symbol.dispose]?.();
    return { told, gouges };
  } finally {
    await progress.end();
  }
}

/**
 * The gouges that the judge alone has found, as diagnostics.
 *
 * @param {readonly Gouge[]} gouges
 * @param {readonly Diagnostic[]} told
 * @returns {Diagnostic[]}
 */
function untold(gouges, told) {
  const known = new Set();
  for (const { depth, origin, segments } of told) {
    for (const one of depth === undefined ? [] : [origin, ...(segments ?? [])]) {
      known.add(line(one));
    }
  }
  return gouges
    .filter(({ segments }) => !segments.some((one) => known.has(line(one))))
    .map(({ at, depth, segments: [origin] }) => ({
      severity: "error",
      code: "gouge",
      message: `the tool cuts ${rounded(depth)} mm too deep at X${rounded(at[0])} Y${rounded(at[1])}`,
      hint: "use a smaller tool, or --gouge avoid",
      ...(origin ? { origin } : {}),
    }));
}

/** @param {Origin | undefined} origin */
function line(origin) {
  return origin && "block" in origin ? origin.block : undefined;
}

/** @param {readonly Gouge[]} gouges */
function worst(gouges) {
  const deepest = gouges.reduce((most, { depth }) => Math.max(most, depth), 0);
  const rest = gouges.length > 0 ? ` of up to ${rounded(deepest)} mm` : "";
  return numbered(gouges.length, "gouge") + rest;
}

/**
 * @param {number} count
 * @param {string} noun
 */
function numbered(count, noun) {
  return `${count === 0 ? "no" : count} ${noun}${count === 1 ? "" : "s"}`;
}

/** @param {number} length [mm] */
function rounded(length) {
  return Number(length.toPrecision(4));
}
