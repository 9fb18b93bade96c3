// The text of --help, from the table of options.
import { commands } from "./flags.js";

/** @typedef {import("./flags.js").Flag} Flag */

const files =
  "FILE is the program; - reads standard input. Diagnostics go to standard error, as " +
  "FILE:LINE:COLUMN: error: message (code).";

const exitCodes = `Exit codes:
  0  all is well
  1  a program has errors or gouges, or its motion breaks a limit; what could be made
     of it is written all the same
  2  the command was used wrongly
  3  a file cannot be read or written
  4  no memory left, or an internal error: please report it`;

/** What `g41 --help` prints. */
export function overview() {
  const list = Object.entries(commands).map(
    ([name, { purpose }]) => `  ${name.padEnd(9)}${wrapped(purpose, 11)}`,
  );
  return [
    "Usage: g41 COMMAND FILE [OPTIONS]",
    "Tool radius compensation of programs for machine tools.",
    `Commands:\n${list.join("\n")}`,
    "g41 COMMAND --help tells the options of a command, g41 --version the version.",
    exitCodes,
  ].join("\n\n");
}

/**
 * What `g41 COMMAND --help` prints.
 *
 * @param {import("./flags.js").Command} command
 */
export function helpOf({ usage, purpose, groups }) {
  const blocks = groups.map(({ title, flags }) => {
    const lines = Object.entries(flags).map(([name, flag]) => line(name, flag));
    return `${title}:\n${lines.join("\n")}`;
  });
  return [`Usage: ${usage}`, wrapped(purpose, 0), wrapped(files, 0), ...blocks, exitCodes].join(
    "\n\n",
  );
}

/** Where the explanations begin. */
const column = 26;

/** Where lines end at the latest. */
const width = 88;

/**
 * @param {string} name
 * @param {Flag} flag
 */
function line(name, { short, value, names, kind, help }) {
  const left = `  ${short ? `-${short}, ` : ""}--${name}${value ? ` ${value}` : ""}`;
  const gap =
    left.length + 2 > column ? `\n${" ".repeat(column)}` : " ".repeat(column - left.length);
  const values = names ? `: ${kind ? "a number, or " : ""}${names.join(", ")}` : "";
  return `${left}${gap}${wrapped(help + values, column)}`;
}

/**
 * A text in lines that are not too long, all but the first of which are indented.
 *
 * @param {string} text
 * @param {number} indent
 */
function wrapped(text, indent) {
  const lines = [];
  let line = "";
  for (const word of text.split(" ")) {
    if (line && indent + line.length + 1 + word.length > width) {
      lines.push(line);
      line = word;
    } else {
      line = line ? `${line} ${word}` : word;
    }
  }
  return [...lines, line].join(`\n${" ".repeat(indent)}`);
}
