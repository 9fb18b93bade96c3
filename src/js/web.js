// The entry for browsers and bundlers: fetches the WebAssembly that lies beside this file.
import * as glue from "./g41.js";
import { initialiser } from "./lifecycle.js";

export * from "./api.js";
export default initialiser(glue, (source) =>
  glue.default({ module_or_path: source ?? new URL("./g41_bg.wasm", import.meta.url) }),
);
