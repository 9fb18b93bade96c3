// The ways between the pieces of a path: none of its moves, but written, planned and drawn.

import type { Way } from "g41";
import type { Point } from "../geometry";
import type { Result } from "../result";

/** The line of the text of the move that a way leads to, 0 for none. */
export function lineOfWay({ move: { origin } }: Way): number {
  return "block" in origin ? origin.block : 0;
}

/** The ways as the plane shows them: where each begins and ends. */
export function waysInPlane({ ways, axes: [right, up] }: Pick<Result, "ways" | "axes">) {
  const chords = ways.map(({ move: { from, to } }): [Point, Point] => [
    [from[right], from[up]],
    [to[right], to[up]],
  ]);
  return chords.filter(([from, to]) => from[0] !== to[0] || from[1] !== to[1]);
}
