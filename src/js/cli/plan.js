// g41 plan: how long a machine takes for a program, and what that time goes into.

import { csvPieces } from "../motion.js";
import { compensate, parseProgram } from "../node.js";
import { costsOf } from "./costs.js";
import { blocksOf } from "./cycle_time.js";
import { exit, misused } from "./failure.js";
import { nameOf, readProgram, standard } from "./input.js";
import { limitsOf } from "./limits.js";
import { keepInputs, write } from "./output.js";
import { Progress } from "./progress.js";
import { report } from "./report.js";
import { parseOptions, programOptions, toolsOf } from "./settings.js";
import { planText } from "./tables.js";

/** @typedef {import("./arguments.js").Values} Values */

/** @type {import("./progress.js").Steps} */
const steps = [
  ["reading", 0.2],
  ["compensating", 0.9],
  ["planning", 4],
];

/**
 * @param {readonly string[]} files
 * @param {Values} values
 * @returns {Promise<number>} the exit code
 */
export async function plan(files, values) {
  const [file, another] = files;
  if (file === undefined || another !== undefined) {
    const what =
      file === undefined ? "the program is missing" : `${another}: one program at a time`;
    misused(what, "g41 plan FILE, or g41 plan - for standard input");
  }
  const { csv, json } = /** @type {{ csv?: string, json?: true }} */ (values);
  const table = /** @type {string | undefined} */ (values["tool-table"]);
  if (csv === standard) {
    misused("--csv needs a file: what is told of the motion goes to standard output");
  }
  if (csv !== undefined) {
    await keepInputs(csv, table === undefined ? [file] : [file, table]);
  }
  const limits = limitsOf(values.limits);
  const tools = await toolsOf(values);
  const { text } = await readProgram(file);
  const progress = new Progress(text.length, steps);
  /** @type {import("../types.d.ts").Diagnostic[]} */
  let found;
  let broken = 0;
  try {
    progress.next();
    const source = {
      text,
      parse: parseOptions(values),
      compensate: programOptions(values, tools),
    };
    const program = parseProgram(text, source.parse);
    progress.next();
    const path = compensate(program, source.compensate);
    program[Symbol.dispose]?.();
    progress.next();
    found = path.diagnostics;
    const began = performance.now();
    const motion = path.plan(limits);
    const seconds = (performance.now() - began) / 1000;
    const samples = motion.time.length;
    const costs = costsOf(path, source, limits, { seconds, samples });
    const { duration, violations } = motion;
    broken = violations.length;
    const planned = {
      duration,
      tools: motion.toolTimes(),
      blocks: blocksOf(path, motion),
      costs: await costs,
      violations,
    };
    if (csv !== undefined) {
      await write(csv, csvPieces(motion), "utf8");
    }
    const pieces = json
      ? [`${JSON.stringify(planned)}\n`]
      : planText(nameOf(file), planned, Boolean(values["all-blocks"]));
    await write(undefined, pieces, "utf8");
  } finally {
    await progress.end();
  }
  report(nameOf(file), found);
  const isFaulty = broken > 0 || found.some(({ severity }) => severity === "error");
  return isFaulty ? exit.faults : exit.fine;
}
