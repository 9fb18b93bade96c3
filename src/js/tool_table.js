// Reads LinuxCNC's tool table: a tool in each line, `T1 P1 D6.0 Z+0.5 Q0 ;remark`, words in any order.
import { bad } from "./check.js";
import { decimal } from "./decimal.js";

/** @typedef {import("./types.d.ts").ToolTable} ToolTable */

/** Words of a line: number, pocket, offsets, diameter, angles of a lathe tool, its orientation. */
const letters = new Set("TPXYZABCUVWDIJQ");

/** The largest number of a tool that LinuxCNC takes. */
const largestNumber = 99999;

/** What is wrong with a line. */
class Fault extends Error {}

/**
 * @param {string} text
 * @returns {ToolTable}
 */
export function readToolTable(text) {
  if (typeof text !== "string") {
    bad(() => "text", "be a string");
  }
  /** @type {ToolTable} */
  const table = { tools: {}, diagnostics: [] };
  const seen = new Set();
  for (const [index, line] of text.split(/\r\n|\r|\n/).entries()) {
    try {
      readTool(wordsOf(line), seen, table.tools);
    } catch (error) {
      if (!(error instanceof Fault)) {
        throw error;
      }
      const origin = { block: index + 1 };
      const { message } = error;
      table.diagnostics.push({ severity: "error", code: "bad-tool-table", message, origin });
    }
  }
  return table;
}

/**
 * @param {Map<string, number>} words
 * @param {Set<number>} seen
 * @param {ToolTable["tools"]} tools
 */
function readTool(words, seen, tools) {
  if (words.size === 0) {
    return;
  }
  const tool = words.get("T") ?? wrong("this line names no tool: it has no T word");
  if (!Number.isInteger(tool) || tool < 0 || tool > largestNumber) {
    wrong(`T${tool} is no number of a tool: it must be whole, from 0 to ${largestNumber}`);
  }
  if (seen.has(tool)) {
    wrong(`there is a tool T${tool} already`);
  }
  seen.add(tool);
  const orientation = words.get("Q") ?? 0;
  if (!Number.isInteger(orientation) || orientation < 0 || orientation > 9) {
    wrong(`Q${orientation} is no orientation: it must be whole, from 0 to 9`);
  }
  const diameter = words.get("D");
  if (diameter !== undefined) {
    tools[tool] = { diameter, orientation };
  }
}

/**
 * The words of a line, its remark apart.
 *
 * @param {string} line
 */
function wordsOf(line) {
  /** @type {Map<string, number>} */
  const words = new Map();
  for (const word of line.replace(/;.*/, "").split(/\s+/).filter(Boolean)) {
    const letter = word.charAt(0).toUpperCase();
    const value = decimal(word.slice(1));
    if (/^[+-]?[\d.]/.test(word) || /^[A-Z]{2}/i.test(word)) {
      wrong(
        `"${word}" is not of LinuxCNC's present format but of an older one or none: each line must be of words as in T1 P1 D6.0 ;remark`,
      );
    }
    if (!letters.has(letter) || value === undefined) {
      wrong(
        `"${word}" is not understood: the words are ${[...letters].join(" ")}, each with a number`,
      );
    }
    if (words.has(letter)) {
      wrong(`there are two ${letter} words`);
    }
    words.set(letter, value);
  }
  return words;
}

/**
 * @param {string} what
 * @returns {never}
 */
function wrong(what) {
  throw new Fault(what);
}
