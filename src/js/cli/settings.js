// Turns the options that were given into those of the package's functions.
import { decimal } from "../decimal.js";
import { readToolTable } from "../tool_table.js";
import { fileTrouble, misused } from "./failure.js";
import { readText } from "./input.js";

/** @typedef {import("./arguments.js").Values} Values */
/** @typedef {import("../types.d.ts").ToolSize} ToolSize */

/**
 * The options of `parseProgram`.
 *
 * @param {Values} values
 * @returns {import("../types.d.ts").ParseOptions}
 */
export function parseOptions(values) {
  return picked({
    dialect: values.from,
    profile: values.profile,
    blockDelete: values["block-delete"],
    splineParameter: values["spline-parameter"],
    curveTolerance: values["curve-tolerance"],
  });
}

/**
 * The options of `compensate`.
 *
 * @param {Values} values
 * @param {Record<number, ToolSize>} tools
 * @returns {import("../types.d.ts").ProgramOptions}
 */
export function programOptions(values, tools) {
  const { profile, gouge, tolerance, corner, lead, spline, radius, passes, stepover } = values;
  const [tangentBand, output] = [values["tangent-band"], values.curves];
  return picked({
    ...{ tools, profile, gouge, tolerance, corner, lead, spline, radius },
    ...{ passes, stepover, tangentBand, output },
  });
}

/**
 * The options of `check`.
 *
 * @param {Values} values
 * @param {Record<number, ToolSize>} tools
 * @returns {import("../types.d.ts").ProgramCheckOptions}
 */
export function checkOptions({ radius, tolerance }, tools) {
  return picked({ tools, radius, tolerance });
}

/**
 * The options of `emit`.
 *
 * @param {Values} values
 * @returns {import("../types.d.ts").GcodeOptions}
 */
export function gcodeOptions({ to, tolerance, feed, clearance, explain, ...others }) {
  const splines = others["native-splines"] ? "native" : undefined;
  return picked({ target: to, tolerance, splines, feed, clearance, explain });
}

/**
 * The tools of --tool-table and --tool, of which the latter win.
 *
 * @param {Values} values
 * @returns {Promise<Record<number, ToolSize>>}
 */
export async function toolsOf(values) {
  const table = values["tool-table"];
  const tools = typeof table === "string" ? await listedTools(table) : {};
  for (const given of /** @type {string[]} */ (values.tool ?? [])) {
    const [, name = "", size = ""] = given.match(/^([^=]*)=(.*)$/) ?? [];
    const radius = decimal(size);
    if (!/^\d{1,9}$/.test(name) || radius === undefined) {
      misused(`--tool must be D=R, a number of a tool and its radius [mm], not "${given}"`);
    }
    tools[Number(name)] = { radius };
  }
  return tools;
}

/**
 * The tools of a table, all of whose lines must be understood.
 *
 * @param {string} path
 */
async function listedTools(path) {
  const { tools, diagnostics } = readToolTable((await readText(path)).text);
  const [first] = diagnostics;
  if (first?.origin && "block" in first.origin) {
    fileTrouble(`${path}:${first.origin.block}`, first.message);
  }
  return tools;
}

/**
 * The options that were given. What each must be has been seen to by the table of options, and the
 * package looks at them once more.
 *
 * @param {Record<string, unknown>} options
 * @returns {object}
 */
function picked(options) {
  return Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
}
