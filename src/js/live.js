// A contour that is edited: its polylines are looked at where they lie in the WebAssembly's memory.
import { bad, finite, isPlain } from "./check.js";
import { call, Handle } from "./lifecycle.js";
import { liveOptions } from "./options.js";
import { packContours, packOneSegment } from "./pack.js";
import { ToolPath } from "./tool_path.js";

/** @typedef {import("./types.d.ts").LiveContour} Face */
/** @typedef {import("./types.d.ts").LiveOptions} Options */
/** @typedef {import("./g41.js").LiveHandle} Raw */

/** @implements {Face} */
export class LiveContour {
  /** @type {Handle<Raw>} */
  #handle;
  /** @type {Record<string, unknown>} */
  #options;

  /**
   * @param {unknown} contour
   * @param {unknown} [options]
   */
  constructor(contour, options = {}) {
    call(() => {});
    const { settings, chord } = liveOptions(options);
    const records = packContours(contour);
    this.#options = { .../** @type {object} */ (options) };
    this.#handle = new Handle(
      (glue) => new glue.LiveHandle(records, new glue.Settings(...settings), chord),
    );
  }

  /**
   * @param {number} segment
   * @param {number} index
   * @param {number} x
   * @param {number} y
   */
  movePoint(segment, index, x, y) {
    const isStart = segment === -1 && index === 0;
    this.#edit(isStart ? "MoveStart" : "MovePoint", isStart ? 0 : segment, index, x, y);
  }

  /**
   * @param {number} segment
   * @param {number} index
   * @param {number} x
   * @param {number} y
   */
  insertPoint(segment, index, x, y) {
    this.#edit("InsertPoint", segment, index, x, y);
  }

  /**
   * @param {number} segment
   * @param {number} index
   */
  removePoint(segment, index) {
    this.#edit("RemovePoint", segment, index, 0, 0);
  }

  /**
   * @param {number} index
   * @param {unknown} segment
   */
  setSegment(index, segment) {
    whole(index, "segment");
    const record = packOneSegment(segment);
    this.#handle.use((raw) => raw.setSegment(index, record));
  }

  /** @param {unknown} [given] */
  set(given = {}) {
    const options = isPlain(given) ? { ...this.#options, ...given } : given;
    const { settings, chord } = liveOptions(options);
    this.#handle.use((raw, glue) => raw.set(new glue.Settings(...settings), chord));
    this.#options = /** @type {Record<string, unknown>} */ (options);
  }

  update() {
    return this.#handle.use((raw, glue) => {
      const [points, count, starts, pieces, from, to, outline, length, first, last] =
        /** @type {[number, number, number, number, number, number, number, number, number, number]} */ (
          /** @type {unknown} */ (raw.update())
        );
      // What is loaded already is not loaded again. Views are made anew each time: where the memory
      // has grown, those made before it show nothing.
      const { buffer } = glue.initSync(/** @type {any} */ (undefined)).memory;
      return {
        points: new Float64Array(buffer, points, 2 * count),
        starts: new Uint32Array(buffer, starts, pieces),
        from,
        to,
        contour: { points: new Float64Array(buffer, outline, 2 * length), from: first, to: last },
      };
    });
  }

  /**
   * @param {keyof typeof import("./g41.js").Edit} what
   * @param {number} segment
   * @param {number} index
   * @param {number} x
   * @param {number} y
   */
  #edit(what, segment, index, x, y) {
    whole(segment, "segment");
    whole(index, "index");
    finite(x, () => "x");
    finite(y, () => "y");
    this.#handle.use((raw, { Edit }) => raw.edit(Edit[what], segment, index, x, y));
  }

  path() {
    return this.#handle.use((raw) => new ToolPath(() => raw.path()));
  }

  // Where the environment has no Symbol.dispose yet, this only has a name that nobody calls.
  [Symbol.dispose]() {
    this.#handle.dispose();
  }
}

/**
 * @param {unknown} value
 * @param {string} name
 */
function whole(value, name) {
  if (!Number.isInteger(value) || Number(value) < 0 || Number(value) > 0xffffffff) {
    bad(() => name, "be a whole number that is not negative");
  }
}
