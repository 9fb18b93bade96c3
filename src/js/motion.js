// Motion as its user sees it: channels that are copied out of the WebAssembly when they are first read.
import { Handle } from "./lifecycle.js";

/** @typedef {import("./types.d.ts").Motion} Face */
/** @typedef {import("./lifecycle.js").Glue} Glue */
/** @typedef {import("./g41.js").MotionHandle} Raw */

/** The channels, in the order of the core. */
const channels = /** @type {const} */ ([
  ...["time", "x", "y", "z", "velocity", "tangentialAcceleration", "normalAcceleration", "jerk"],
]);

/** Lines of CSV that are written in one piece. */
const piece = 4096;

/** Digits after the point: a picometre, and more than a number of any channel needs. */
const digits = 9;

/** @implements {Face} */
export class Motion {
  /** @type {Handle<Raw>} */
  #handle;
  /** @type {Float64Array[]} */
  #channels = [];
  /** @type {Uint32Array | undefined} */
  #block;
  /** @type {Uint32Array | undefined} */
  #step;
  /** @type {Face["violations"] | undefined} */
  #violations;
  /** @type {number} */
  #moves;
  /** @type {Float64Array} */
  #tools;

  /**
   * @param {(glue: Glue) => Raw} make
   * @param {number} moves of the path
   * @param {Float64Array} tools as the core gives them
   */
  constructor(make, moves, tools) {
    this.#handle = new Handle(make);
    this.#moves = moves;
    this.#tools = tools;
  }

  /** @param {number} index */
  #channel(index) {
    this.#channels[index] ??= this.#handle.use((raw) => raw.channel(index));
    return /** @type {Float64Array} */ (this.#channels[index]);
  }

  get duration() {
    return this.#handle.use((raw) => raw.duration());
  }

  get count() {
    return this.#handle.use((raw) => raw.count());
  }

  get time() {
    return this.#channel(0);
  }

  get x() {
    return this.#channel(1);
  }

  get y() {
    return this.#channel(2);
  }

  get z() {
    return this.#channel(3);
  }

  get velocity() {
    return this.#channel(4);
  }

  get tangentialAcceleration() {
    return this.#channel(5);
  }

  get normalAcceleration() {
    return this.#channel(6);
  }

  get jerk() {
    return this.#channel(7);
  }

  get block() {
    this.#block ??= this.#handle.use((raw) => raw.block(false));
    return this.#block;
  }

  get step() {
    this.#step ??= this.#handle.use((raw) => raw.block(true));
    return this.#step;
  }

  get violations() {
    this.#violations ??= JSON.parse(this.#handle.use((raw) => raw.violations()));
    return /** @type {Face["violations"]} */ (this.#violations);
  }

  blockTimes() {
    const { block, time } = this;
    const times = new Float64Array(this.#moves);
    for (let i = 1; i < block.length; i++) {
      const [before, now] = /** @type {[number, number]} */ ([time[i - 1], time[i]]);
      // The interval is that of the move that it begins on.
      const owner = /** @type {number} */ (block[i - 1]);
      times[owner] = /** @type {number} */ (times[owner]) + now - before;
    }
    return times;
  }

  toolTimes() {
    const times = this.blockTimes();
    /** @type {Map<number | undefined, number>} */
    const sums = new Map();
    let next = 0;
    /** @type {number | undefined} */
    let tool;
    times.forEach((time, move) => {
      for (; /** @type {number} */ (this.#tools[next]) <= move; next += 2) {
        tool = this.#tools[next + 1];
      }
      sums.set(tool, (sums.get(tool) ?? 0) + time);
    });
    return Array.from(sums, ([number, time]) =>
      number === undefined ? { time } : { tool: number, time },
    );
  }

  toCsv() {
    return [...csvPieces(this)].join("");
  }

  // Where the environment has no Symbol.dispose yet, this only has a name that nobody calls.
  [Symbol.dispose]() {
    this.#handle.dispose();
  }
}

/**
 * The samples as comma-separated values, a line each, under a line of names; in pieces, since a text may
 * not be as long as all of them.
 *
 * @param {Face} motion
 * @returns {Generator<string, void>}
 */
export function* csvPieces(motion) {
  yield `${channels.join(",")},block\n`;
  const columns = channels.map((name) => motion[name]);
  const { block } = motion;
  for (let from = 0; from < block.length; from += piece) {
    let text = "";
    for (let i = from; i < Math.min(block.length, from + piece); i++) {
      for (const column of columns) {
        // Without trailing zeros, and without a negative zero.
        text += `${Number(/** @type {number} */ (column[i]).toFixed(digits)) + 0},`;
      }
      text += `${block[i]}\n`;
    }
    yield text;
  }
}
