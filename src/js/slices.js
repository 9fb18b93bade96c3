// Long work in slices, so that whoever asks for it can tell how far it is, or stop it.
import { bad } from "./check.js";
import { call, Handle, needWhole } from "./lifecycle.js";
import { parseOptions, programOptions } from "./options.js";
import { Program, useProgram } from "./program.js";
import { ToolPath } from "./tool_path.js";

/** @typedef {import("./types.d.ts").ProgramReader} ReaderFace */
/** @typedef {import("./types.d.ts").ProgramCompensation} CompensationFace */

/** More than any program has. */
const all = 0xffffffff;

/** @implements {ReaderFace} */
export class ProgramReader {
  /** @type {Handle<import("./g41.js").ReaderHandle>} */
  #handle;

  /**
   * @param {string} text
   * @param {unknown} [options]
   */
  constructor(text, options) {
    needWhole();
    if (typeof text !== "string") {
      bad(() => "text", "be a string");
    }
    const given = parseOptions(options);
    this.#handle = new Handle((glue) => new glue.ReaderHandle(text, ...given));
  }

  get progress() {
    return this.#handle.use((raw) => raw.progress());
  }

  /** @param {number} blocks */
  step(blocks) {
    const count = slice(blocks);
    return this.#handle.use((raw) => raw.step(count));
  }

  finish() {
    while (this.step(all));
    return new Program(() => this.#handle.take((raw) => raw.finish()));
  }

  // Where the environment has no Symbol.dispose yet, this only has a name that nobody calls.
  [Symbol.dispose]() {
    this.#handle.dispose();
  }
}

/** @implements {CompensationFace} */
export class ProgramCompensation {
  /** @type {Handle<import("./g41.js").CompensationHandle>} */
  #handle;
  #program;

  /**
   * @param {Program} program
   * @param {unknown} [options]
   */
  constructor(program, options) {
    call(() => {});
    if (!(program instanceof Program)) {
      bad(() => "program", "be a program that parseProgram or a ProgramReader has made");
    }
    const { tools, settings } = programOptions(options);
    this.#program = program;
    this.#handle = new Handle((glue) =>
      useProgram(
        program,
        (raw) => new glue.CompensationHandle(raw, tools, new glue.Settings(...settings)),
      ),
    );
  }

  get progress() {
    return this.#handle.use((raw) => raw.progress());
  }

  /** @param {number} blocks */
  step(blocks) {
    const count = slice(blocks);
    return this.#handle.use((raw) =>
      useProgram(this.#program, (program) => raw.step(program, count)),
    );
  }

  finish() {
    while (this.step(all));
    return new ToolPath(() => this.#handle.take((raw) => raw.finish()));
  }

  // Where the environment has no Symbol.dispose yet, this only has a name that nobody calls.
  [Symbol.dispose]() {
    this.#handle.dispose();
  }
}

/** @param {unknown} blocks */
function slice(blocks) {
  const isCount = Number.isInteger(blocks) && Number(blocks) >= 1;
  return isCount ? Math.min(Number(blocks), all) : bad(() => "blocks", "be a whole number from 1");
}
