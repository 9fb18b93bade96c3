// The tables of g41 plan, for people to read.

/** @typedef {import("./cycle_time.js").BlockTime} BlockTime */
/** @typedef {import("./costs.js").Cost} Cost */
/** @typedef {import("../types.d.ts").ToolTime} ToolTime */
/** @typedef {import("../types.d.ts").Violation} Violation */

/**
 * @typedef {object} Planned
 * @property {number} duration [s]
 * @property {ToolTime[]} tools
 * @property {BlockTime[]} blocks
 * @property {Cost[]} costs
 * @property {Violation[]} violations
 */

/** How many of the longest blocks are listed. */
const listed = 10;

/**
 * The text that tells of a motion.
 *
 * @param {string} name of the file
 * @param {Planned} planned
 * @param {boolean} all whether all blocks are listed, in the order of the program
 * @returns {Generator<string, void>}
 */
export function* planText(name, { duration, tools, blocks, costs, violations }, all) {
  const moves = blocks.reduce((sum, block) => sum + block.moves, 0);
  const length = blocks.reduce((sum, block) => sum + block.length, 0);
  yield `${name}: ${clock(duration)}, ${counted(moves, "move")}, ${fixed(length, 1)} mm\n`;
  yield table(
    ["tool", "time", "share"],
    tools.map(({ tool, time }) => [
      tool === undefined ? "none" : `T${tool}`,
      clock(time),
      share(time, duration),
    ]),
  );
  const longest = [...blocks].sort((a, b) => b.time - a.time);
  const some = all ? blocks : longest.slice(0, listed);
  const rest = blocks.length - some.length;
  yield table(
    ["line", "N", "time", "share", "moves", "mm", "mm/min"],
    some.map(({ block, number, time, length: on, moves: count }) => [
      Number.isNaN(block) ? "" : String(block),
      number === undefined ? "" : String(number),
      clock(time),
      share(time, duration),
      String(count),
      fixed(on, 2),
      time > 0 ? fixed((on / time) * 60, 0) : "",
    ]),
  );
  if (rest > 0) {
    yield `  and ${counted(rest, "block")} that take less (--all-blocks lists them)\n`;
  }
  if (costs.length > 0) {
    yield table(
      ["with", "time", "change"],
      costs.map(({ name: what, duration: other }) => {
        const change = other - duration;
        const percent = fixed(duration > 0 ? (100 * Math.abs(change)) / duration : 0, 1);
        const sign = percent === "0.0" ? "" : change < 0 ? "-" : "+";
        return [what, clock(other), `${sign}${percent} %`];
      }),
    );
  }
  if (violations.length > 0) {
    yield `\nlimits broken:\n`;
    yield table(
      ["limit", "reached", "allowed", "at"],
      violations.map(({ limit, value, allowed, time }) => [
        limit,
        String(Number(value.toPrecision(4))),
        String(Number(allowed.toPrecision(4))),
        clock(time),
      ]),
    ).slice(1);
  }
}

/**
 * Rows in columns, the first of which is to the left.
 *
 * @param {readonly string[]} head
 * @param {readonly (readonly string[])[]} rows
 */
function table(head, rows) {
  const widths = head.map((title, i) =>
    Math.max(title.length, ...rows.map((row) => (row[i] ?? "").length)),
  );
  const lines = [head, ...rows].map((row) =>
    row
      .map((cell, i) => (i === 0 ? cell.padEnd(widths[i] ?? 0) : cell.padStart(widths[i] ?? 0)))
      .join("  ")
      .trimEnd(),
  );
  return `\n${lines.map((line) => `  ${line}\n`).join("")}`;
}

/**
 * A time as people read it: seconds, from a minute on with minutes, from an hour on with hours.
 *
 * @param {number} time [s]
 */
function clock(time) {
  if (time < 59.995) {
    return `${fixed(time, 2)} s`;
  }
  const seconds = Math.round(time);
  const [hours, minutes] = [Math.floor(seconds / 3600), Math.floor(seconds / 60) % 60];
  const rest = String(seconds % 60).padStart(2, "0");
  return hours > 0
    ? `${hours}:${String(minutes).padStart(2, "0")}:${rest} h`
    : `${minutes}:${rest} min`;
}

/**
 * @param {number} part
 * @param {number} whole
 */
function share(part, whole) {
  return whole > 0 ? `${fixed((100 * part) / whole, 1)} %` : "";
}

/**
 * @param {number} count
 * @param {string} noun
 */
function counted(count, noun) {
  return `${fixed(count, 0)} ${noun}${count === 1 ? "" : "s"}`;
}

/**
 * A number with a comma at every thousand.
 *
 * @param {number} value
 * @param {number} decimals
 */
function fixed(value, decimals) {
  const [whole = "", fraction] = value.toFixed(decimals).split(".");
  const grouped = whole.replace(/\B(?=(\d{3})+$)/g, ",");
  return fraction === undefined ? grouped : `${grouped}.${fraction}`;
}
