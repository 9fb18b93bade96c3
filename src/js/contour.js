// The entry for browsers and bundlers that want contours alone: the WebAssembly that it fetches is
// half of the whole.
import load from "./g41.js";
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
export default initialiser((source) =>
  load({ module_or_path: source ?? new URL("./g41_contour_bg.wasm", import.meta.url) }),
);
