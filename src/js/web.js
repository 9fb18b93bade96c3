// The entry for browsers and bundlers: fetches the WebAssembly that lies beside this file.
import load from "./g41.js";
import { initialiser } from "./lifecycle.js";

export * from "./api.js";
export default initialiser((source) =>
  load({ module_or_path: source ?? new URL("./g41_bg.wasm", import.meta.url) }),
);
