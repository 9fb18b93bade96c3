// A program as its user sees it: what the WebAssembly holds, unpacked when it is asked for.
import { emitted } from "./gcode.js";
import { Handle } from "./lifecycle.js";
import { dialects } from "./options.js";
import { polylinesOf } from "./polylines.js";

/** @typedef {import("./types.d.ts").Program} Face */
/** @typedef {import("./lifecycle.js").Glue} Glue */
/** @typedef {import("./g41.js").ProgramHandle} Raw */

/**
 * Runs a call with what a program holds, for those who compensate and judge it alone.
 *
 * @type {<R>(program: Program, work: (raw: Raw, glue: Glue) => R) => R}
 */
export let useProgram;

/** @implements {Face} */
export class Program {
  /** @type {Handle<Raw>} */
  #handle;
  /** @type {Face["diagnostics"] | undefined} */
  #diagnostics;
  /** @type {Face["contours"] | undefined} */
  #contours;
  /** @type {Face["tools"] | undefined} */
  #tools;

  static {
    useProgram = (program, work) => program.#handle.use(work);
  }

  /** @param {(glue: Glue) => Raw} make */
  constructor(make) {
    this.#handle = new Handle(make);
  }

  get dialect() {
    const index = this.#handle.use((raw) => raw.dialect());
    return /** @type {Face["dialect"]} */ (dialects[index]);
  }

  get diagnostics() {
    this.#diagnostics ??= JSON.parse(this.#handle.use((raw) => raw.diagnostics()));
    return /** @type {Face["diagnostics"]} */ (this.#diagnostics);
  }

  get contours() {
    this.#contours ??= JSON.parse(this.#handle.use((raw) => raw.contours()));
    return /** @type {Face["contours"]} */ (this.#contours);
  }

  get tools() {
    this.#tools ??= [...this.#handle.use((raw) => raw.tools())];
    return this.#tools;
  }

  /** @param {number} [within] */
  polylines(within) {
    return polylinesOf(this.#handle, within);
  }

  /** @param {import("./types.d.ts").GcodeOptions} [options] */
  emit(options) {
    return emitted(this.#handle, options);
  }

  /** @param {import("./types.d.ts").GcodeOptions} [options] */
  gcode(options) {
    return this.emit(options).text;
  }

  // Where the environment has no Symbol.dispose yet, this only has a name that nobody calls.
  [Symbol.dispose]() {
    this.#handle.dispose();
  }
}
