// A tool path as JSON, piece by piece, so that a path of millions of moves needs no text as long.
import { unpackMoves } from "../moves.js";
import { useToolPath } from "../tool_path.js";

/** Items of one piece. */
const count = 4096;

/**
 * `{ "moves": […], "transitions": […], "diagnostics": […] }`, an item in each line.
 *
 * @param {import("../tool_path.js").ToolPath} path
 * @param {(done: number) => void} progress is told how many moves are done
 * @returns {Generator<string, void>}
 */
export function* jsonPieces(path, progress) {
  yield '{"moves":[';
  yield* items((from, to) => {
    progress(from);
    return unpackMoves(useToolPath(path, (raw) => raw.records(from, to)));
  });
  yield '],\n"transitions":[';
  yield* items((from, to) => JSON.parse(useToolPath(path, (raw) => raw.transitions(from, to))));
  yield '],\n"diagnostics":[';
  yield* items((from, to) => path.diagnostics.slice(from, to));
  yield "]}\n";
}

/**
 * @param {(from: number, to: number) => readonly unknown[]} read the items from one index to another
 * @returns {Generator<string, void>}
 */
function* items(read) {
  for (let from = 0; ; from += count) {
    const some = read(from, from + count);
    if (some.length > 0) {
      const separator = from === 0 ? "\n" : ",\n";
      yield separator + some.map((item) => JSON.stringify(item)).join(",\n");
    }
    if (some.length < count) {
      return;
    }
  }
}
