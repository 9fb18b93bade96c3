// A tool path as JSON, piece by piece, so that a path of millions of moves needs no text as long.
import { unpackMoves } from "../moves.js";
import { useToolPath } from "../tool_path.js";

/** Items of one piece. */
const count = 4096;

/**
 * `{ "moves": […], "transitions": […], "diagnostics": […] }`.
 *
 * @param {import("../tool_path.js").ToolPath} path
 * @param {(done: number) => void} progress is told how many moves are done
 * @returns {Generator<string, void>}
 */
export function* jsonPieces(path, progress) {
  yield '{"moves":[';
  yield* list((from, to) => {
    progress(from);
    const moves = unpackMoves(useToolPath(path, (raw) => raw.records(from, to)));
    return moves.map((move) => JSON.stringify(move)).join(",\n");
  });
  yield '],\n"transitions":[';
  // The core writes them as JSON, of which all but the brackets is taken.
  yield* list((from, to) =>
    useToolPath(path, (raw, { List }) => raw.report(List.Transitions, from, to)).slice(1, -1),
  );
  yield '],\n"diagnostics":[';
  yield* list((from, to) => {
    const some = path.diagnostics.slice(from, to);
    return some.map((diagnostic) => JSON.stringify(diagnostic)).join(",\n");
  });
  yield "]}\n";
}

/**
 * What is between the brackets of a list.
 *
 * @param {(from: number, to: number) => string} write the items from one index to another; nothing
 *   where there are none
 * @returns {Generator<string, void>}
 */
function* list(write) {
  for (let from = 0; ; from += count) {
    const items = write(from, from + count);
    if (!items) {
      return;
    }
    yield (from === 0 ? "\n" : ",\n") + items;
  }
}
