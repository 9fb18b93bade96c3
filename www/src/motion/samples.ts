// Motion as plots and player read it: where the tool is at a time, and what a plot shows of many samples.

import type { MotionData } from "./protocol";

/** Points of one curve of a plot; more samples than these become their least and largest. */
const MOST_POINTS = 4000;

/** Samples that are looked at when the nearest to a place is sought. */
const MOST_SOUGHT = 40_000;

/** A place on the way, between two samples. */
export interface Place {
  /** Index of the sample at or before it. */
  readonly index: number;
  readonly point: readonly [x: number, y: number, z: number];
  /** The move, and the line of the text that it comes from, if one does. */
  readonly move: number;
  readonly line: number | undefined;
}

/** Index of the last sample at which a channel that never falls is at most `value`. */
export function indexAt(channel: Float64Array, value: number): number {
  let [low, high] = [0, channel.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((channel[middle] as number) <= value) low = middle;
    else high = middle;
  }
  return low;
}

/** Where the tool is at a time [s]. */
export function placeAt(data: MotionData, time: number): Place | undefined {
  const index = indexAt(data.time, time);
  const next = Math.min(index + 1, data.time.length - 1);
  const [from, to] = [data.time[index], data.time[next]];
  if (from === undefined || to === undefined) return undefined;
  const part = to > from ? Math.min(1, Math.max(0, (time - from) / (to - from))) : 0;
  const between = (of: Float64Array) => {
    const [a, b] = [of[index] as number, of[next] as number];
    return a + (b - a) * part;
  };
  const move = data.step[index] as number;
  const line = data.lines[move] || undefined;
  return { index, point: [between(data.x), between(data.y), between(data.z)], move, line };
}

/** The sample nearest to a point as it is seen, within a distance [mm]. */
export function nearestSample(
  data: MotionData,
  axes: readonly [0 | 1 | 2, 0 | 1 | 2],
  [x, y]: readonly [number, number],
  within: number,
): number | undefined {
  const [right, up] = axes.map((axis) => [data.x, data.y, data.z][axis]) as [
    Float64Array,
    Float64Array,
  ];
  const count = right.length;
  const step = Math.max(1, Math.ceil(count / MOST_SOUGHT));
  let [best, least] = [-1, Infinity];
  const look = (i: number) => {
    const away = Math.hypot((right[i] as number) - x, (up[i] as number) - y);
    if (away < least) [best, least] = [i, away];
  };
  for (let i = 0; i < count; i += step) look(i);
  const near = best;
  for (let i = Math.max(0, near - step); i < Math.min(count, near + step); i += 1) look(i);
  return least <= within ? best : undefined;
}

/** Curves over a window of samples, as a plot takes them: the first is across. */
export function curves(
  across: Float64Array,
  channels: readonly ((index: number) => number)[],
  from: number,
  to: number,
): number[][] {
  const count = to - from;
  const size = Math.max(1, Math.ceil((2 * count) / MOST_POINTS));
  if (size === 1) {
    const indices = Array.from({ length: count }, (_, i) => from + i);
    return [indices.map((i) => across[i] as number), ...channels.map((of) => indices.map(of))];
  }
  // Of each few samples the least and the largest, in their order, at the places of first and last.
  const result: number[][] = [[], ...channels.map(() => [])];
  for (let first = from; first < to; first += size) {
    const last = Math.min(to, first + size) - 1;
    result[0]?.push(across[first] as number, across[last] as number);
    channels.forEach((of, c) => {
      let [low, high] = [first, first];
      let [least, most] = [of(first), of(first)];
      for (let i = first + 1; i <= last; i += 1) {
        const value = of(i);
        if (value < least) [low, least] = [i, value];
        if (value > most) [high, most] = [i, value];
      }
      result[c + 1]?.push(...(low <= high ? [least, most] : [most, least]));
    });
  }
  return result;
}
