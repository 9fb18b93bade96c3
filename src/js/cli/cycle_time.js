// What the time of a motion goes into, by blocks of the program.
import { RECORD_STRIDE } from "../moves.js";

/** @typedef {import("../types.d.ts").ToolPath} ToolPath */
/** @typedef {import("../types.d.ts").Motion} Motion */

/**
 * The time that goes into all moves of one block.
 *
 * @typedef {object} BlockTime
 * @property {number} block line of the text, counted from 1
 * @property {number} [number] its N word
 * @property {number} moves
 * @property {number} length of the way on these moves [mm]
 * @property {number} time [s]
 */

/** Moves that are looked at in one go, for the sake of memory. */
const slice = 50_000;

/** Places in a record. */
const [block, number] = [4, 5];

/**
 * The time of each block of the program, in the order in which they first come.
 *
 * @param {ToolPath} path
 * @param {Motion} motion
 * @returns {BlockTime[]}
 */
export function blocksOf(path, motion) {
  const times = motion.blockTimes();
  const ways = waysOf(motion, times.length);
  /** @type {Map<number, BlockTime>} */
  const blocks = new Map();
  for (let first = 0; first < times.length; first += slice) {
    const records = path.records(first, first + slice);
    /** @type {(index: number) => number} */
    const value = (index) => /** @type {number} */ (records[index]);
    for (let i = 0; i < records.length; i += RECORD_STRIDE) {
      const line = value(i + block);
      let known = blocks.get(line);
      if (!known) {
        known = { block: line, moves: 0, length: 0, time: 0 };
        if (!Number.isNaN(value(i + number))) {
          known.number = value(i + number);
        }
        blocks.set(line, known);
      }
      const move = first + i / RECORD_STRIDE;
      known.moves += 1;
      known.time += /** @type {number} */ (times[move]);
      known.length += /** @type {number} */ (ways[move]);
    }
  }
  return [...blocks.values()];
}

/**
 * The length of the way on each move, from sample to sample [mm].
 *
 * @param {Motion} motion
 * @param {number} count of the moves
 */
function waysOf({ x, y, z, block }, count) {
  const ways = new Float64Array(count);
  for (let i = 1; i < block.length; i++) {
    const [owner, ...away] = /** @type {[number, number, number, number]} */ ([
      block[i - 1],
      ...[x, y, z].map((of) => Number(of[i]) - Number(of[i - 1])),
    ]);
    ways[owner] = /** @type {number} */ (ways[owner]) + Math.hypot(...away);
  }
  return ways;
}
