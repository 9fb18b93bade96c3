// Loads the WebAssembly once, refuses calls before that, and starts afresh after a trap.
import * as glue from "./g41.js";

let state = "absent";
let loading;

/** An `Error` with a `code` that programs can match on. */
export function coded(code, message) {
  return Object.assign(new Error(message), { code });
}

/** Makes `init` from a loader, which may return a promise or be done when it returns. */
export function initialiser(load) {
  return function init(source) {
    if (state === "trapped") {
      glue.__wbg_reset_state();
      state = "ready";
    }
    if (state === "ready") {
      return Promise.resolve();
    }
    loading ??= load(source);
    if (!(loading instanceof Promise)) {
      state = "ready";
      return Promise.resolve();
    }
    return loading.then(
      () => {
        state = "ready";
      },
      (error) => {
        // A failed download may be tried again.
        loading = undefined;
        throw error;
      },
    );
  };
}

/** Runs a call into the WebAssembly, or says why it cannot. */
export function call(work) {
  if (state === "absent") {
    throw coded("not-initialised", "g41 is not initialised: await init() first");
  }
  if (state === "trapped") {
    throw coded("trapped", "g41 has stopped after an internal error: await init() to start afresh");
  }
  try {
    return work(glue);
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) {
      state = "trapped";
    }
    throw error;
  }
}
