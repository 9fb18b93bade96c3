// Tells people what was found, on standard error.

/** @typedef {import("../types.d.ts").Diagnostic} Diagnostic */

const bold = "1";
/** @type {Readonly<Record<Diagnostic["severity"], string>>} */
const colours = { error: "1;31", warning: "1;33", info: "1;36" };

/**
 * Writes `FILE:LINE:COLUMN: error: message (code)`, and the hint below it; what a block that is run several
 * times has several times, once and how often.
 *
 * @param {string} name of the file
 * @param {readonly Diagnostic[]} diagnostics
 */
export function report(name, diagnostics) {
  const { stderr } = process;
  const paint = painter(stderr);
  /** @type {Map<string, { first: Diagnostic, times: number }>} */
  const told = new Map();
  for (const first of diagnostics) {
    const key = JSON.stringify([
      first.severity,
      first.code,
      first.message,
      first.hint,
      first.origin,
    ]);
    const same = told.get(key);
    if (same) same.times += 1;
    else told.set(key, { first, times: 1 });
  }
  for (const { first, times } of told.values()) {
    const { severity, code, message, hint, origin } = first;
    const block = origin && "block" in origin ? origin : undefined;
    const place = [name, block?.block, block?.column].filter((part) => part !== undefined);
    const where = paint(bold, printable(`${place.join(":")}:`));
    const what = printable(`${message} (${code})${times > 1 ? `, ${times} times` : ""}`);
    stderr.write(`${where} ${paint(colours[severity], `${severity}:`)} ${what}\n`);
    if (hint) {
      stderr.write(`  hint: ${printable(hint)}\n`);
    }
  }
}

/**
 * Says why the command ends.
 *
 * @param {string} message
 * @param {string | undefined} hint
 */
export function complain(message, hint) {
  const { stderr } = process;
  const paint = painter(stderr);
  const rest = hint ? `\n  hint: ${hint}` : "";
  stderr.write(
    `${paint(bold, "g41:")} ${paint(colours.error, "error:")} ${printable(message)}${rest}\n`,
  );
}

/**
 * Colours text where a terminal shows it and nobody objects.
 *
 * @param {NodeJS.WriteStream} stream
 * @returns {(style: string, text: string) => string}
 */
function painter({ isTTY }) {
  const { NO_COLOR, TERM } = process.env;
  const plain = !isTTY || NO_COLOR || TERM === "dumb";
  return (style, text) => (plain ? text : `\x1b[${style}m${text}\x1b[0m`);
}

/**
 * Text of a program must not steer the terminal; lines may be several.
 *
 * @param {string} text
 */
function printable(text) {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: they are what is looked for
  return text.replace(/[\x00-\x09\x0b-\x1f\x7f-\x9f]/g, "\ufffd");
}
