// The entry that carries the WebAssembly in itself, for bundlers that leave the file behind.
import * as glue from "./g41.js";
import base64 from "./g41_base64.js";
import { initialiser } from "./lifecycle.js";

export * from "./api.js";
export default initialiser(glue, () =>
  glue.default({ module_or_path: Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)) }),
);
