// Reads programs: files and standard input.
import { readFile } from "node:fs/promises";
import { buffer } from "node:stream/consumers";

import { fileTrouble } from "./failure.js";

/** What stands for standard input, and as a place to write to for standard output. */
export const standard = "-";

/** @typedef {"utf8" | "latin1"} Encoding */

/** Encodings by the mark that a text in them begins with. */
const wides = new Map([
  ["fffe", "utf-16le"],
  ["feff", "utf-16be"],
]);

/**
 * A text, and how it is encoded. Old programs are often not in UTF-8: those are taken for Latin-1, in
 * which every byte is a letter, so that comments come out as they went in.
 *
 * @param {string} path
 * @returns {Promise<{ text: string, encoding: Encoding }>}
 */
export async function readText(path) {
  try {
    const bytes = await (path === standard ? buffer(process.stdin) : readFile(path));
    // Editors of Windows call this Unicode.
    const wide = wides.get(bytes.toString("hex", 0, 2));
    if (wide) {
      return { text: new TextDecoder(wide).decode(bytes), encoding: "utf8" };
    }
    try {
      return { text: new TextDecoder("utf-8", { fatal: true }).decode(bytes), encoding: "utf8" };
    } catch (error) {
      if (!(error instanceof TypeError)) {
        throw error;
      }
      return { text: bytes.toString("latin1"), encoding: "latin1" };
    }
  } catch (error) {
    fileTrouble(nameOf(path), error);
  }
}

/**
 * What a file is called in messages.
 *
 * @param {string} path
 */
export function nameOf(path) {
  return path === standard ? "<stdin>" : path;
}
