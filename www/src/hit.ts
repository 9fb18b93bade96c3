// What lies under the pointer: segments of contours, places on the tool path, corners.

import { type Track, trackOf } from "./draw/track";
import { followedTransitions, transitionPlace } from "./draw/transition";
import { distance, type Point } from "./geometry";
import type { Part } from "./part";
import type { Lines, Result } from "./result";

/** The nearest place on polylines. */
export interface Nearest {
  readonly point: Point;
  /** The move or segment it belongs to. */
  readonly owner: number;
  readonly distance: number;
  /** Index of the vertex at the end of the chord it lies on, and the place on that chord. */
  readonly vertex: number;
  readonly t: number;
}

/** The place on polylines that is nearest to a point, if any is nearer than `within` [mm]. */
export function nearestOn(lines: Lines, p: Point, within = Infinity): Nearest | undefined {
  const near = nearestOnTrack(trackOf(lines.points), lines.starts, p, within);
  return near && { ...near, owner: lines.owners[near.vertex] as number };
}

/** The same for polylines that nobody owns. */
export function nearestOnTrack(
  track: Track,
  first: Uint32Array,
  p: Point,
  within: number,
): Omit<Nearest, "owner"> | undefined {
  let best: Omit<Nearest, "owner"> | undefined;
  const reach = () => best?.distance ?? within;
  track.nearChords(p, new Set(first), reach, (near, vertex) => {
    const d = distance(near.point, p);
    if (d < reach()) best = { ...near, distance: d, vertex };
  });
  return best;
}

/** The contour and segment of an index that counts through all contours. */
export function segmentAt(
  part: Part,
  index: number,
): { contour: number; segment: number } | undefined {
  let rest = index;
  for (const [contour, { segments }] of part.contours.entries()) {
    if (rest < segments.length) return { contour, segment: rest };
    rest -= segments.length;
  }
  return undefined;
}

/** The index of a segment, counted through all contours. */
export function indexOf(part: Part, contour: number, segment: number): number {
  return part.contours
    .slice(0, contour)
    .reduce((sum, { segments }) => sum + segments.length, segment);
}

/** Before which type point of a spline a place on it lies. */
export function typePointAfter(lines: Lines, near: Nearest, points: readonly Point[]): number {
  // Each type point is a place on the spline: those before the vertex are passed.
  let from = near.vertex;
  while (from > 1 && lines.owners[from - 1] === near.owner) from -= 1;
  let at = from;
  for (const [k, point] of points.entries()) {
    while (lines.owners[at] === near.owner && distance(vertexOf(lines, at), point) > 1e-3) at += 1;
    if (lines.owners[at] !== near.owner) return k;
    if (at >= near.vertex) return k;
  }
  return Math.max(0, points.length - 1);
}

/** The index of the transition nearest to a point, by its corner or its place on the tool path. */
export function nearestCorner(result: Result, p: Point, within: number): number | undefined {
  let best: number | undefined;
  let least = within;
  result.transitions.forEach((transition, i) => {
    const place = transitionPlace(transition, result);
    const d = Math.min(distance(transition.corner, p), distance(place, p));
    if (d < least) {
      least = d;
      best = i;
    }
  });
  return best;
}

/** The transition that is most worth showing first: an inserted one, else an elongated one. */
export function showpiece(result: Result): number | undefined {
  for (const kind of ["inserted", "elongated", "shortened"]) {
    const found = followedTransitions(result).find(({ transition }) => transition.kind === kind);
    if (found) return result.transitions.indexOf(found.transition);
  }
  return undefined;
}

function vertexOf(lines: Lines, i: number): Point {
  return [lines.points[2 * i] as number, lines.points[2 * i + 1] as number];
}
