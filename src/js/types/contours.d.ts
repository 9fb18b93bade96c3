// Contours given from code, and their polylines.
import type { Diagnostic } from "./reports.js";

/** A point in the plane, `[x, y]` [mm]. */
export type Point = readonly [x: number, y: number];

/** The side of the contour on which the tool runs, seen along the motion: G41 left, G42 right. */
export type Side = "left" | "right";

/** A straight line from the end of the segment before. */
export interface LineSegment {
  kind: "line";
  to: Point;
}

/** A circular arc; a full circle where its end is its start. */
export interface ArcSegment {
  kind: "arc";
  to: Point;
  center: Point;
  /** `true` as G2, `false` as G3. */
  clockwise: boolean;
}

/** The C2 cubic spline through the end of the segment before and these type points. */
export interface SplineSegment {
  kind: "spline";
  /** The type points after the start, the last of which is the end; or `x0, y0, x1, y1, …`. */
  points: readonly Point[] | Float64Array;
  /** Tangent at the start, of any length but zero; without it, see `smooth`. */
  startTangent?: Point;
  /** Tangent at the end, of any length but zero; without it, see `smooth`. */
  endTangent?: Point;
  /**
   * Whether an end without a given tangent is tangent to a neighbouring line, arc or involute; an end that
   * has neither is natural (curvature zero). Default `false`.
   */
  smooth?: boolean;
  /**
   * Whether the end is smoothly the start. Default: `true` where the spline is all of a closed
   * contour.
   */
  periodic?: boolean;
  /** How the parameter is spaced between type points. Default `"chord"`. */
  parameter?: "chord" | "centripetal";
}

/**
 * Cubic Bézier curves, each from the end of the one before: what spline blocks of a program make
 * that are no spline through type points. A corner between two of them is one of the contour.
 */
export interface BezierSegment {
  kind: "bezier";
  /** Of each curve both inner control points and its end; or `x0, y0, x1, y1, …`. */
  controls: readonly Point[] | Float64Array;
}

/**
 * An involute of a circle, as the flanks of gears are: away from the circle where its end is farther
 * from the centre than its start, else towards it.
 */
export interface InvoluteSegment {
  kind: "involute";
  /** Its end, at most 0.028 mm off the involute through the start. */
  to: Point;
  /** Centre of the base circle, inside of which neither end lies. */
  center: Point;
  /** Radius of the base circle [mm]. */
  baseRadius: number;
  /** `true` as G2.2, `false` as G3.2. */
  clockwise: boolean;
}

/** One segment of a contour; it starts where the one before it ends. */
export type Segment = LineSegment | ArcSegment | SplineSegment | BezierSegment | InvoluteSegment;

/** The programmed boundary of a part. */
export interface Contour {
  start: Point;
  segments: readonly Segment[];
  /** Whether its end, which must be its start, is a corner or joint too. Default `false`. */
  closed?: boolean;
  /** Where a move that switches compensation on comes from; without it there is none. */
  leadIn?: Point;
  /** Where a move that switches compensation off goes to; without it there is none. */
  leadOut?: Point;
  /** The side, where the options name none. */
  side?: Side;
  /** The tool radius [mm], where the options name none. */
  radius?: number;
}

/**
 * One or more contours as numbers, one record after the other:
 *
 * | record | numbers |
 * | --- | --- |
 * | start of a contour | `0, x, y, closed` |
 * | line | `1, x, y` |
 * | arc | `2, x, y, center x, center y, clockwise` |
 * | spline | `3, flags, start tangent x, y, end tangent x, y, count, x0, y0, x1, y1, …` |
 * | lead-in | `4, x, y` |
 * | lead-out | `5, x, y` |
 * | side | `6, right` |
 * | tool radius | `7, radius` |
 * | Bézier curves | `8, count, x0, y0, x1, y1, …` |
 * | involute | `9, x, y, center x, center y, base radius, clockwise` |
 *
 * `closed`, `clockwise` and `right` are 0 or 1. `flags` is a sum of: 1 the start tangent is given, 2 the end
 * tangent is given, 4 smooth, 8 periodic, 16 not periodic, 32 centripetal; a tangent that is not
 * given still takes its two numbers.
 */
export type ContourRecords = Float64Array;

/** Polylines within a tolerance of curves. */
export interface Polylines {
  /** All vertices of all pieces: `x0, y0, x1, y1, …`. */
  points: Float64Array;
  /** The same vertices with their height: `x0, y0, z0, x1, …`. */
  points3: Float64Array;
  /**
   * Index of the first vertex of each piece; a piece ends where the next one begins, or at the last
   * vertex. A closed piece repeats its first point as its last.
   */
  starts: Uint32Array;
  /**
   * For each vertex, what the chord that ends there belongs to (for the first vertex of a piece:
   * the chord that begins there): an index into `moves` of a path, or the index of a segment,
   * counted through all contours.
   */
  owners: Uint32Array;
}

/** The polylines of contours: piece i is contour i, empty where it could not be made. */
export interface FlattenedContours extends Polylines {
  /** What is wrong with the contours. */
  diagnostics: Diagnostic[];
}

/**
 * Polylines of contours as they are understood, splines included: for drawing what is programmed
 * and for finding the segment under the pointer. Leads are not part of them.
 *
 * @param tolerance largest distance of a chord from its curve [mm]; default 0.001
 * @throws {G41Error} `"bad-argument"`
 */
export function flatten(
  contour: Contour | readonly Contour[] | ContourRecords,
  tolerance?: number,
): FlattenedContours;
