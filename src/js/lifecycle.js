// Loads the WebAssembly once, refuses calls before that, and starts afresh after a trap.
import * as glue from "./g41.js";

/** @type {"absent" | "ready" | "trapped"} */
let state = "absent";
/** @type {unknown} */
let loading;
/** Counts the fresh starts, since a handle does not outlive the instance that it belongs to. */
let generation = 0;
/** Whether what was loaded knows programs, G-code and motion, or contours alone. */
let isWhole = true;

/** @typedef {typeof glue} Glue */
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
 * Makes `init` from a loader, which may return a promise or be done when it returns.
 *
 * @param {(source?: any) => unknown} load
 * @returns {(source?: string | object) => Promise<void>}
 */
export function initialiser(load) {
  return function init(source) {
    if (state === "trapped") {
      glue.__wbg_reset_state();
      generation += 1;
      state = "ready";
    }
    if (state === "ready") {
      return Promise.resolve();
    }
    try {
      loading ??= load(source);
    } catch (cause) {
      throw notLoaded(cause);
    }
    if (!(loading instanceof Promise)) {
      begin(loading);
      return Promise.resolve();
    }
    return loading.then(begin, (cause) => {
      // A failed download may be tried again.
      loading = undefined;
      throw notLoaded(cause);
    });
  };
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

/** @param {any} exported by the WebAssembly */
function begin(exported) {
  isWhole = "planMotion" in exported;
  state = "ready";
}

/** Refuses what the WebAssembly of `g41/contour` leaves out. */
export function needWhole() {
  call(() => {
    if (!isWhole) {
      throw coded("not-supported", 'programs, G-code and motion: import "g41" for "g41/contour"');
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
  if (state === "absent") {
    throw coded("not-initialised", "g41 is not initialised: await init() first");
  }
  if (state === "trapped") {
    throw coded("trapped", "g41 has stopped after an internal error: await init() to start afresh");
  }
  try {
    return work(glue);
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
    state = "trapped";
    throw coded("trapped", `g41 has stopped after an internal error: ${cause}`, { cause });
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
  #generation = generation;

  /** @param {(glue: Glue) => T} make */
  constructor(make) {
    if (typeof make !== "function") {
      throw new TypeError("handles are made by the functions of g41, not by new");
    }
    this.#raw = call(make);
  }

  /**
   * Runs a call with what is held.
   *
   * @template R
   * @param {(raw: T, glue: Glue) => R} work
   * @returns {R}
   */
  use(work) {
    return call((glue) => {
      if (this.#generation !== generation) {
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
    if (raw && state === "ready" && this.#generation === generation) {
      call(() => raw.free());
    }
  }
}
