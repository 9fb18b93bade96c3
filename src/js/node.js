// The entry for Node: the WebAssembly is loaded when the package is imported.
import { readFileSync } from "node:fs";

import * as glue from "./g41.js";
import { initialiser } from "./lifecycle.js";

const init = initialiser(glue, () =>
  glue.initSync({ module: readFileSync(new URL("./g41_bg.wasm", import.meta.url)) }),
);
init();

export * from "./api.js";
export default init;
