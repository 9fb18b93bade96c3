/// <reference lib="esnext.disposable" />

// Loading the WebAssembly, and what is thrown.

/**
 * Loads the WebAssembly, once; in Node it is loaded already and this does nothing. Called after a
 * `"trapped"` error it starts afresh.
 *
 * @param source where the `.wasm` file is (an address or a `Response`) or what it is (its bytes or
 *   a `WebAssembly.Module`); by default it is found beside the package
 * @throws {G41Error} `"not-loaded"`
 */
export default function init(source?: string | object): Promise<void>;

/**
 * What every function here throws: wrong use, never wrong geometry. Mistakes in a program or a
 * contour are diagnostics.
 */
export interface G41Error extends Error {
  /**
   * - `"not-initialised"`: `await init()` was not called yet
   * - `"not-loaded"`: `init()` did not find the `.wasm` file, or found something else; see `cause`
   * - `"bad-argument"`: an argument has the wrong shape, is not finite, or is unknown; see `path`
   * - `"not-supported"`: what "g41/contour" leaves out, or `Path2D` where there is none
   * - `"several-pieces"`: `polyline` of a path that is not in one piece; use `polylines`
   * - `"disposed"`: the handle was given back by `using` or `[Symbol.dispose]()`
   * - `"trapped"`: an earlier call ended in an internal error; `await init()` starts afresh, and
   *   handles made before are lost
   * - `"out-of-memory"`: what was asked for takes more than the 4 GB that WebAssembly has, or than the
   *   machine gives; like `"trapped"` after that
   */
  code:
    | "not-initialised"
    | "not-loaded"
    | "bad-argument"
    | "not-supported"
    | "several-pieces"
    | "disposed"
    | "trapped"
    | "out-of-memory";
  /** For `"bad-argument"`: the place in the arguments, as in `segments[3].to[0]`. */
  path?: string;
}

/** The version of the package. */
export function version(): string;
