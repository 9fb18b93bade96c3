// Writes the result: to standard output, or to a file that appears complete or not at all.
import { createWriteStream } from "node:fs";
import { realpath, rename, rm, stat } from "node:fs/promises";
import { basename, dirname, join } from "node:path";

import { fileTrouble, misused } from "./failure.js";
import { standard } from "./input.js";

/** @typedef {import("node:fs").Stats} Stats */

/** What ends a command from outside: Ctrl+C, kill, and a terminal that is closed. */
const signals = /** @type {const} */ (["SIGINT", "SIGTERM", "SIGHUP"]);

/**
 * Ends the command if writing a file would overwrite what is read.
 *
 * @param {string} output
 * @param {readonly string[]} inputs
 */
export async function keepInputs(output, inputs) {
  const there = await stats(output);
  for (const input of inputs.filter((path) => path !== standard)) {
    const read = await stats(input);
    if (there && read && there.isFile() && there.ino === read.ino && there.dev === read.dev) {
      misused(`${output} is what is read: it is not overwritten`, "write to another file");
    }
  }
}

/**
 * Writes pieces of text to standard output, or to a file.
 *
 * @param {string | undefined} path
 * @param {Iterable<string>} pieces
 * @param {import("./input.js").Encoding} encoding
 */
export async function write(path, pieces, encoding) {
  try {
    await (path === undefined
      ? pour(process.stdout, pieces, encoding)
      : writeFile(path, pieces, encoding));
  } catch (error) {
    fileTrouble(path ?? "<stdout>", error);
  }
}

/**
 * @param {string} path
 * @param {Iterable<string>} pieces
 * @param {import("./input.js").Encoding} encoding
 */
async function writeFile(path, pieces, encoding) {
  const there = await stats(path);
  if (there && !there.isFile()) {
    // A device or a pipe cannot be replaced.
    await pour(createWriteStream(path), pieces, encoding, true);
    return;
  }
  // A link stays a link to what it leads to.
  const place = there ? await realpath(path) : path;
  const draft = join(dirname(place), `.${basename(place)}.${process.pid}.tmp`);
  const interrupted = (/** @type {string} */ _, /** @type {number} */ signal) => {
    // The exit code that shells give to what a signal has ended.
    rm(draft, { force: true }).finally(() => process.exit(128 + signal));
  };
  for (const signal of signals) {
    process.once(signal, interrupted);
  }
  try {
    const mode = there ? there.mode & 0o777 : 0o666;
    await pour(
      createWriteStream(draft, { flags: "wx", mode, flush: true }),
      pieces,
      encoding,
      true,
    );
    await rename(draft, place);
  } catch (error) {
    await rm(draft, { force: true });
    throw error;
  } finally {
    for (const signal of signals) {
      process.off(signal, interrupted);
    }
  }
}

/**
 * @param {import("node:stream").Writable} stream
 * @param {Iterable<string>} pieces
 * @param {import("./input.js").Encoding} encoding
 * @param {boolean} [ends] whether the stream ends here
 */
async function pour(stream, pieces, encoding, ends = false) {
  const trouble = troubleOf(stream);
  for (const piece of pieces) {
    if (trouble.error) {
      break;
    }
    if (!stream.write(piece, encoding)) {
      await Promise.race([new Promise((resolve) => stream.once("drain", resolve)), trouble.came]);
    }
  }
  if (!trouble.error) {
    /** @type {Promise<void>} */
    const arrived = new Promise((resolve) => {
      // What failed is told here before there is an event of it.
      const told = (/** @type {Error | null | undefined} */ failed) => {
        trouble.error ??= failed ?? undefined;
        resolve();
      };
      if (ends) {
        stream.end(told);
      } else {
        stream.write("", told);
      }
    });
    await Promise.race([arrived, trouble.came]);
  }
  // Who reads standard output may have read enough.
  const { error } = trouble;
  if (error && /** @type {NodeJS.ErrnoException} */ (error).code !== "EPIPE") {
    throw error;
  }
}

/** @typedef {{ error: Error | undefined, came: Promise<void> }} Trouble */

/** @type {WeakMap<import("node:stream").Writable, Trouble>} */
const troubles = new WeakMap();

/**
 * What goes wrong with a stream. It is listened to once, and until the end: standard output is written
 * to for each program, and may fail after that.
 *
 * @param {import("node:stream").Writable} stream
 * @returns {Trouble}
 */
function troubleOf(stream) {
  const known = troubles.get(stream);
  if (known) {
    return known;
  }
  /** @type {Trouble} */
  const trouble = { error: undefined, came: Promise.resolve() };
  trouble.came = new Promise((resolve) => {
    stream.on("error", (error) => {
      trouble.error = error;
      resolve();
    });
  });
  troubles.set(stream, trouble);
  return trouble;
}

/**
 * What there is at a path, if anything.
 *
 * @param {string} path
 * @returns {Promise<Stats | undefined>}
 */
async function stats(path) {
  return stat(path).catch(() => undefined);
}
