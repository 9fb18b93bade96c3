// The functions of the package, the same for every way of loading it.
import { call } from "./lifecycle.js";

/** The version of the package. */
export function version() {
  return call((glue) => glue.version());
}
