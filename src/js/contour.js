// The entry for browsers and bundlers that want contours alone: the WebAssembly that it fetches is
// half of the whole.
import * as glue from "./g41_contour.js";
import { initialiser } from "./lifecycle.js";

export {
  check,
  compensate,
  flatten,
  LiveContour,
  RECORD_STRIDE,
  ToolPath,
  version,
} from "./api.js";
export default initialiser(glue, (source) =>
  glue.default({ module_or_path: source ?? new URL("./g41_contour_bg.wasm", import.meta.url) }),
);
