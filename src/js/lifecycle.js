// Loads the WebAssembly once, refuses calls before that, and starts afresh after a trap.
//
// There are two: that of "g41", and that of "g41/contour", which knows contours alone. Where both are
// loaded, as by a page and a package that it uses, what is new is made by the whole, and what was made
// stays with the one that made it.

/** @typedef {typeof import("./g41.js")} Glue */

/**
 * One of the two.
 *
 * @typedef {object} Instance
 * @property {Glue} glue
 * @property {boolean} isWhole - whether it knows programs, G-code and motion
 * @property {"absent" | "ready" | "trapped"} state
 * @property {unknown} loading
 * @property {number} generation - fresh starts, which no handle outlives
 */

/** @type {{ whole?: Instance, part?: Instance }} */
const instances = {};
/** @type {Instance | undefined} whose call runs now: what is made in it belongs to it */
let running;

/** @typedef {import("./types.d.ts").G41Error["code"]} Code */

/**
 * An `Error` with a `code` that programs can match on.
 *
 * @param {Code} code
 * @param {string} message
 * @param {{ path?: string, cause?: unknown }} [more]
 */
export function coded(code, message, { path, cause } = {}) {
  const error = new Error(message, cause === undefined ? undefined : { cause });
  return Object.assign(error, path === undefined ? { code } : { code, path });
}

/**
 * Makes `init` from the glue of a WebAssembly and what loads it, which may return a promise or be done
 * when it returns.
 *
 * @param {Glue | typeof import("./g41_contour.js")} glue - of the part, it has what contours need
 * @param {(source?: any) => unknown} load
 * @returns {(source?: string | object) => Promise<void>}
 */
export function initialiser(glue, load) {
  const instance = instanceOf(/** @type {Glue} */ (glue));
  const begin = () => {
    instance.state = "ready";
  };
  return function init(source) {
    for (const one of Object.values(instances)) {
      if (one.state === "trapped") {
        one.glue.__wbg_reset_state();
        one.generation += 1;
        one.state = "ready";
      }
    }
    // The whole knows all that the part does.
    if (instance.state === "ready" || instances.whole?.state === "ready") {
      return Promise.resolve();
    }
    try {
      instance.loading ??= load(source);
    } catch (cause) {
      throw notLoaded(cause);
    }
    if (!(instance.loading instanceof Promise)) {
      begin();
      return Promise.resolve();
    }
    return instance.loading.then(begin, (cause) => {
      // A failed download may be tried again.
      instance.loading = undefined;
      throw notLoaded(cause);
    });
  };
}

/**
 * The instance of a glue, which several entries may load.
 *
 * @param {Glue} glue
 */
function instanceOf(glue) {
  const isWhole = "planMotion" in glue;
  const name = isWhole ? "whole" : "part";
  instances[name] ??= { glue, isWhole, state: "absent", loading: undefined, generation: 0 };
  return instances[name];
}

/** What a call that no handle belongs to goes to: one that is loaded, the whole rather than the part. */
function current() {
  const { whole, part } = instances;
  const loaded = [running, whole, part].find((one) => one && one.state !== "absent");
  if (!loaded) {
    throw coded("not-initialised", "g41 is not initialised: await init() first");
  }
  return loaded;
}

/**
 * Tells what to do, since most often a bundler has left the file behind, and what is found in its place
 * is a page or nothing.
 *
 * @param {unknown} cause
 */
function notLoaded(cause) {
  const reason = cause instanceof Error ? cause.message : String(cause);
  const advice = 'import "g41/inline" where a bundler leaves it behind, or give init its address';
  return coded("not-loaded", `the WebAssembly of g41 was not loaded (${reason}): ${advice}`, {
    cause,
  });
}

/** Refuses what the WebAssembly of `g41/contour` leaves out. */
export function needWhole() {
  mustBeWhole(current());
}

/** @param {Instance} instance */
function mustBeWhole(instance) {
  run(instance, () => {
    if (!instance.isWhole) {
      throw coded(
        "not-supported",
        'programs, G-code and motion: import "g41" for "g41/contour", of which this is',
      );
    }
  });
}

/**
 * Runs a call into the WebAssembly, or says why it cannot.
 *
 * @template T
 * @param {(glue: Glue) => T} work
 * @returns {T}
 */
export function call(work) {
  return run(current(), work);
}

/**
 * What ends a call for which more is taken than this most likely ends it for want of memory [bytes]: what
 * grows is doubled, and there are 4 GB at most.
 */
const MOST_TAKEN = 2 ** 30;

/**
 * The memory of one of the two [bytes].
 *
 * @param {Instance} instance
 */
function takenBy({ glue }) {
  // What is loaded already is not loaded again.
  return glue.initSync(/** @type {any} */ (undefined)).memory.buffer.byteLength;
}

/**
 * Runs a call into one of the two.
 *
 * @template T
 * @param {Instance} instance
 * @param {(glue: Glue) => T} work
 * @returns {T}
 */
function run(instance, work) {
  if (instance.state === "trapped") {
    throw coded("trapped", "g41 has stopped after an internal error: await init() to start afresh");
  }
  if (running && running !== instance) {
    throw coded("not-supported", 'this needs both of one origin, "g41" or "g41/contour"');
  }
  const outer = running;
  running = instance;
  try {
    return work(instance.glue);
  } catch (cause) {
    if (typeof cause === "string") {
      // What the core says of a bad argument: where it is, and what it must be.
      const [path, must] = cause.split("\n");
      throw coded("bad-argument", `${path} must ${must}`, { path });
    }
    if (cause instanceof Error && "code" in cause) {
      throw cause;
    }
    // Whatever else ends a call (a trap, a full stack, no memory) leaves the instance in a state
    // that nobody knows.
    instance.state = "trapped";
    const taken = takenBy(instance);
    if (taken > MOST_TAKEN) {
      const message = `g41 has stopped for want of memory: ${Math.round(taken / 1e6)} MB are taken`;
      throw coded("out-of-memory", message, { cause });
    }
    throw coded("trapped", `g41 has stopped after an internal error: ${cause}`, { cause });
  } finally {
    running = outer;
  }
}

/**
 * Something that lives in the WebAssembly's memory. It is freed when the handle is no longer
 * reachable, or by `dispose`.
 *
 * @template {{ free(): void }} T
 */
export class Handle {
  /** @type {T | undefined} */
  #raw;
  #instance;
  #generation;

  /** @param {(glue: Glue) => T} make */
  constructor(make) {
    if (typeof make !== "function") {
      throw new TypeError("handles are made by the functions of g41, not by new");
    }
    this.#instance = current();
    this.#generation = this.#instance.generation;
    this.#raw = run(this.#instance, make);
  }

  /** Refuses what the WebAssembly of `g41/contour` leaves out, where this was made by it. */
  needWhole() {
    mustBeWhole(this.#instance);
  }

  /**
   * Runs a call with what is held.
   *
   * @template R
   * @param {(raw: T, glue: Glue) => R} work
   * @returns {R}
   */
  use(work) {
    return run(this.#instance, (glue) => {
      if (this.#generation !== this.#instance.generation) {
        throw coded("disposed", "this was lost when g41 stopped after an internal error");
      }
      if (!this.#raw) {
        throw coded("disposed", "this was disposed of and cannot be used any more");
      }
      return work(this.#raw, glue);
    });
  }

  /**
   * Runs a call that uses up what is held.
   *
   * @template R
   * @param {(raw: T, glue: Glue) => R} work
   * @returns {R}
   */
  take(work) {
    return this.use((raw, glue) => {
      this.#raw = undefined;
      return work(raw, glue);
    });
  }

  /** Frees what is held, once. */
  dispose() {
    const raw = this.#raw;
    this.#raw = undefined;
    const { state, generation } = this.#instance;
    if (raw && state === "ready" && this.#generation === generation) {
      run(this.#instance, () => raw.free());
    }
  }
}
