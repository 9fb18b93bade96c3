// Writes what a handle holds as a program.
import { gcodeOptions } from "./options.js";

/** @typedef {import("./g41.js").ProgramHandle | import("./g41.js").ToolPathHandle} Raw */

/**
 * @param {import("./lifecycle.js").Handle<Raw>} handle
 * @param {import("./types.d.ts").GcodeOptions} [options]
 * @returns {import("./types.d.ts").Emitted}
 */
export function emitted(handle, options) {
  handle.needWhole();
  const given = gcodeOptions(options);
  const [text, diagnostics] = /** @type {[string, string]} */ (
    handle.use((raw, glue) => raw.emit(new glue.EmitSettings(...given)))
  );
  return { text, diagnostics: JSON.parse(diagnostics) };
}
