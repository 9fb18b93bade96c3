// g41 convert: a program becomes the path of the tool centre, as a program or as JSON.
import { compensate, parseProgram } from "../node.js";
import { useToolPath } from "../tool_path.js";
import { exit, misused } from "./failure.js";
import { ofPaths } from "./flags.js";
import { nameOf, readText } from "./input.js";
import { jsonPieces } from "./json.js";
import { keepInputs, write } from "./output.js";
import { Progress } from "./progress.js";
import { report } from "./report.js";
import { gcodeOptions, parseOptions, programOptions, toolsOf } from "./settings.js";

/** @typedef {import("./arguments.js").Values} Values */

/** @type {import("./progress.js").Steps} */
const steps = [
  ["reading", 0.2],
  ["compensating", 0.9],
  ["writing", 0.2],
];

/**
 * @param {readonly string[]} files
 * @param {Values} values
 * @returns {Promise<number>} the exit code
 */
export async function convert(files, values) {
  const [file, another] = files;
  if (file === undefined || another !== undefined) {
    const what =
      file === undefined ? "the program is missing" : `${another}: one program at a time`;
    misused(what, "g41 convert FILE, or g41 convert - for standard input");
  }
  const { output, json } = /** @type {{ output?: string, json?: true }} */ (values);
  const keeps = values["keep-compensation"] === true;
  const idle = keeps ? [...ofPaths, "json"].find((name) => values[name] !== undefined) : undefined;
  if (idle) {
    misused(
      `--${idle} is for a path of the tool's centre, which --keep-compensation does not make`,
    );
  }
  const table = /** @type {string | undefined} */ (values["tool-table"]);
  if (output !== undefined) {
    await keepInputs(output, table === undefined ? [file] : [file, table]);
  }
  const tools = await toolsOf(values);
  const { text, encoding } = await readText(file);
  const progress = new Progress(text.length, steps);
  /** @type {import("../types.d.ts").Diagnostic[]} */
  let found;
  try {
    progress.next();
    const program = parseProgram(text, parseOptions(values));
    progress.next();
    const path = keeps ? undefined : compensate(program, programOptions(values, tools));
    found = (path ?? program).diagnostics;
    if (path) {
      program[Symbol.dispose]?.();
    }
    progress.next();
    if (path && json) {
      const total = useToolPath(path, (raw) => raw.count());
      const pieces = jsonPieces(path, (done) => progress.part(done / total));
      await write(output, pieces, "utf8");
    } else {
      const emitted = (path ?? program).emit(gcodeOptions(values));
      found = [...found, ...emitted.diagnostics];
      await write(output, [emitted.text], encoding);
    }
  } finally {
    await progress.end();
  }
  report(nameOf(file), found);
  return found.some(({ severity }) => severity === "error") ? exit.faults : exit.fine;
}
