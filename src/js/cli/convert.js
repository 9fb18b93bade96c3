// g41 convert: a program becomes the path of the tool centre, as a program or as JSON.
import { compensate, parseProgram } from "../node.js";
import { useToolPath } from "../tool_path.js";
import { exit, misused } from "./failure.js";
import { ofPaths, ofPrograms } from "./flags.js";
import { nameOf, readProgram, standard } from "./input.js";
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
  const { output: place, json } = /** @type {{ output?: string, json?: true }} */ (values);
  const output = place === standard ? undefined : place;
  const keeps = values["keep-compensation"] === true;
  const given = (/** @type {readonly string[]} */ names) =>
    names.find((name) => values[name] !== undefined);
  const ofPath = keeps ? given([...ofPaths, "json"]) : undefined;
  if (ofPath) {
    misused(
      `--${ofPath} is for a path of the tool's centre, which --keep-compensation does not make`,
    );
  }
  const ofProgram = json ? given(ofPrograms) : undefined;
  if (ofProgram) {
    misused(`--${ofProgram} is for a program, which --json does not write`);
  }
  const table = /** @type {string | undefined} */ (values["tool-table"]);
  if (output !== undefined) {
    await keepInputs(output, table === undefined ? [file] : [file, table]);
  }
  const tools = await toolsOf(values);
  const { text, encoding } = await readProgram(file);
  const progress = new Progress(text.length, steps);
  /** @type {import("../types.d.ts").Diagnostic[]} */
  let found;
  /** @type {typeof found} */
  let uncut = [];
  try {
    progress.next();
    const program = parseProgram(text, parseOptions(values));
    progress.next();
    const path = keeps ? undefined : compensate(program, programOptions(values, tools));
    found = (path ?? program).diagnostics;
    if (path) {
      uncut = notReached(path.uncut);
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
  report(nameOf(file), [...found, ...uncut]);
  return found.some(({ severity }) => severity === "error") ? exit.faults : exit.fine;
}

/**
 * Where gouges are avoided: what the tool does not reach, in one note at the largest of it.
 *
 * @param {readonly import("../types.d.ts").Uncut[]} regions
 * @returns {import("../types.d.ts").Diagnostic[]}
 */
function notReached(regions) {
  const [first, ...others] = regions;
  if (!first) {
    return [];
  }
  const largest = others.reduce((most, region) => (region.area > most.area ? region : most), first);
  const area = regions.reduce((sum, region) => sum + region.area, 0);
  const places = others.length > 0 ? `${regions.length} places are` : "a place is";
  const origin = largest.segments[0];
  return [
    {
      severity: "info",
      code: "uncut",
      message: `${places} not reached, ${Number(area.toPrecision(4))} mm² in all`,
      hint: "a smaller tool reaches more; the page shows where",
      ...(origin ? { origin } : {}),
    },
  ];
}
