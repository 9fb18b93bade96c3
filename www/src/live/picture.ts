// The polylines of the contour that is dragged, kept up to date by patches.

import { Track } from "../draw/track";
import type { Point } from "../geometry";
import type { PointRef } from "../part";
import type { Changed, Patch } from "./protocol";

/** A contour while one of its points is dragged. */
export interface LivePicture {
  /** Index of the contour. */
  readonly contour: number;
  /** The point that is dragged, and where it is. */
  readonly ref: PointRef;
  readonly at: Point;
  readonly path: Track;
  readonly starts: Uint32Array;
  readonly outline: Track;
  /** Whether the path begins with a lead-in and ends with a lead-out. */
  readonly leads: readonly [boolean, boolean];
}

/** The picture after a change. */
export function patched(
  before: LivePicture | undefined,
  now: Pick<LivePicture, "contour" | "ref" | "at" | "leads">,
  changed: Changed,
): LivePicture | undefined {
  const path = apply(before?.path, changed.path);
  const outline = apply(before?.outline, changed.outline);
  return path && outline && { ...now, path, outline, starts: changed.starts };
}

/** Copies what has changed to its place; the rest stays where it is. */
function apply(before: Track | undefined, { from, count, points }: Patch): Track | undefined {
  const to = from + points.length / 2;
  if (before && before.points.length === 2 * count) {
    before.points.set(points, 2 * from);
    if (to > from) before.touch(from, to);
    return before;
  }
  if (from === 0 && to === count) return new Track(points);
  if (!before) return undefined;
  // The memory has been laid out anew behind what was known.
  const all = new Float64Array(2 * count);
  all.set(before.points.subarray(0, Math.min(before.points.length, all.length)));
  all.set(points, 2 * from);
  return new Track(all);
}
