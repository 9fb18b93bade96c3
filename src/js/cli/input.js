// Reads programs: files and standard input.
import { readFile } from "node:fs/promises";
import { buffer } from "node:stream/consumers";

import { Failure, fileTrouble } from "./failure.js";

/** What stands for standard input, and as a place to write to for standard output. */
export const standard = "-";

/** @typedef {"utf8" | "latin1"} Encoding */

/** Encodings by the mark that a text in them begins with. */
const wides = new Map([
  ["fffe", "utf-16le"],
  ["feff", "utf-16be"],
]);

/** Ctrl+Z. */
const endOfText = 0x1a;

/**
 * A program: a text in which there is something. Of an empty one, as a transfer that failed leaves it,
 * nothing would be wrong.
 *
 * @param {string} path
 * @returns {ReturnType<typeof readText>}
 */
export async function readProgram(path) {
  const read = await readText(path);
  if (read.text.trim() === "") {
    fileTrouble(nameOf(path), "there is nothing in it");
  }
  return read;
}

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
    const text = withoutLeader(bytes);
    if (text.includes(0)) {
      fileTrouble(nameOf(path), "this is no text; if an editor shows one, save it as UTF-8");
    }
    try {
      return { text: new TextDecoder("utf-8", { fatal: true }).decode(text), encoding: "utf8" };
    } catch (error) {
      if (!(error instanceof TypeError)) {
        throw error;
      }
      return { text: text.toString("latin1"), encoding: "latin1" };
    }
  } catch (error) {
    if (error instanceof Failure) {
      throw error;
    }
    fileTrouble(nameOf(path), error);
  }
}

/**
 * Bytes without the zeros before and behind them, which are blank tape to some controls and serial lines,
 * and without the mark that DOS ends a text with.
 *
 * @param {Buffer} bytes
 */
function withoutLeader(bytes) {
  let [from, to] = [0, bytes.length];
  while (from < to && bytes[from] === 0) {
    from += 1;
  }
  while (from < to && (bytes[to - 1] === 0 || bytes[to - 1] === endOfText)) {
    to -= 1;
  }
  return bytes.subarray(from, to);
}

/**
 * What a file is called in messages.
 *
 * @param {string} path
 */
export function nameOf(path) {
  return path === standard ? "<stdin>" : path;
}
