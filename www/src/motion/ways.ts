// The ways between the pieces of a path: the planner makes them itself, up, across and down, and counts
// their samples to the move that follows. Here they become moves of their own.

import { type Limits, RECORD_STRIDE } from "g41";
import { away, GAP, placeOf } from "../large/ways";
import { FIELD, RAPID } from "../result";
import type { Point3 } from "../space/strokes";
import type { MotionData } from "./protocol";

/** What is known of the moves of a plan. */
export type PlannedMoves = Pick<MotionData, "block" | "feeds" | "rapid" | "lines">;

/** The moves of a plan and the ways between them: rapid ones up and across, and those down at a feed. */
export function withWays(
  samples: Pick<MotionData, "x" | "y" | "z">,
  moves: PlannedMoves,
  records: Float64Array,
  limits: Limits,
): PlannedMoves {
  const block = moves.block.slice();
  const [feeds, rapid, lines] = [[...moves.feeds], [...moves.rapid], [...moves.lines]];
  const add = (first: number, end: number, feed: number, isRapid: boolean, line: number) => {
    block.fill(feeds.length, first, end);
    feeds.push(feed);
    rapid.push(isRapid ? 1 : 0);
    lines.push(line);
  };
  let plunge: number | undefined;
  let known = 0;
  for (let first = 0, end = 0; first < block.length; first = end) {
    const move = moves.block[first] as number;
    for (end = first + 1; moves.block[end] === move; ) end += 1;
    // The feed at which the program itself last went straight down.
    for (; known < move; known += 1) {
      if (goesDown(records, known)) plunge = moves.feeds[known];
    }
    const from = placeOf(records, move * RECORD_STRIDE, FIELD.from);
    if (move === 0 || away(from, placeOf(records, (move - 1) * RECORD_STRIDE, FIELD.to)) <= GAP)
      continue;
    const [down, last] = parts(samples, [first, end], from, limits);
    const line = moves.lines[move] as number;
    const feed = plunge ?? (moves.feeds[move] as number);
    if (down > first) add(first, down, limits.velocity, true, line);
    if (last > down) {
      const isRapid = moves.rapid[move] === 1;
      add(down, last, isRapid ? limits.velocity : feed, isRapid, line);
    }
  }
  return {
    block,
    feeds: Float64Array.from(feeds),
    rapid: Uint8Array.from(rapid),
    lines: Uint32Array.from(lines),
  };
}

/** The samples at which a way begins to go down, and at which it has come to where the move begins. */
function parts(
  { x, y, z }: Pick<MotionData, "x" | "y" | "z">,
  [first, end]: readonly [number, number],
  from: Point3,
  { cornerDeviation: deviation = 0, velocity, period }: Limits,
): [down: number, last: number] {
  // Corners are rounded, so that it comes by only as near as that, and as far as a sample may be off.
  const reach = deviation + velocity * (period ?? 0.001);
  let [last, least] = [first, Infinity];
  for (let i = first; i < end; i += 1) {
    const d = away([x[i] as number, y[i] as number, z[i] as number], from);
    if (d < least) [last, least] = [i, d];
    else if (least <= reach) break;
  }
  let down = last;
  const isAbove = (i: number) =>
    Math.hypot((x[i] as number) - from[0], (y[i] as number) - from[1]) <= deviation + GAP;
  while (down > first && isAbove(down - 1) && (z[down - 1] as number) > (z[down] as number)) {
    down -= 1;
  }
  return [down, last];
}

function goesDown(records: Float64Array, move: number): boolean {
  const index = move * RECORD_STRIDE;
  const [from, to] = [placeOf(records, index, FIELD.from), placeOf(records, index, FIELD.to)];
  const isRapid = records[index + FIELD.kind] === RAPID;
  return !isRapid && to[2] < from[2] && to[0] === from[0] && to[1] === from[1];
}
