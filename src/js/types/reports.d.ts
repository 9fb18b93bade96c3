// What is told about a path or a program, and where that was programmed.
import type { Point } from "./contours.js";

/** Where something was programmed. */
export type Origin = BlockOrigin | SegmentOrigin;

/** A block of a program. */
export interface BlockOrigin {
  /** Line of the text, counted from 1. */
  block: number;
  /** The N word, if the block has one. */
  number?: number;
  /** Column of the word concerned, counted from 1 in characters. */
  column?: number;
}

/** A segment of a contour given from code. */
export interface SegmentOrigin {
  /** Index of the segment in its contour. */
  segment: number;
  /** Index of the contour, where several were given. */
  contour?: number;
}

/** Something found on the way that the user should know. */
export interface Diagnostic {
  /** `"info"`: the path is what was asked for; `"error"`: it is wrong or missing at this place. */
  severity: "info" | "warning" | "error";
  /** Stable name in kebab-case, for programs to match on. */
  code: string;
  /** One sentence with the values, for people to read. */
  message: string;
  /** What to do about it. */
  hint?: string;
  /** The point concerned. */
  at?: Point;
  /** The block or segment concerned. */
  origin?: Origin;
  /** How deep the tool cuts into material that should stay [mm]. */
  depth?: number;
  /** All blocks or segments concerned, where there is more than one. */
  segments?: Origin[];
}

/** How the offsets of two segments are joined at a corner. */
export interface Transition {
  kind: "shortened" | "elongated" | "inserted";
  /** Angle between the segments on the workpiece side, α in [0, 2π] [rad]. */
  angle: number;
  /** The programmed corner. */
  corner: Point;
  /**
   * The points of its construction by name, in the order in which they are found: `P` the corner,
   * `N1` and `N2` the tool centres at the ends of both offsets, `V` the vertex of the transition
   * vector, `A1` and `A2` the ends of the inserted straight move.
   */
  construction: Record<string, Point>;
  /** The block or segment that leads out of the corner. */
  origin: Origin;
}

/** Where the tool cuts into material that should stay. */
export interface Gouge {
  /** `"curvature"`: local, at a bend or corner; `"bottleneck"`: between distant segments. */
  kind: "curvature" | "bottleneck";
  /** The point of the contour that is cut deepest. */
  at: Point;
  /** How deep [mm]. */
  depth: number;
  /** The blocks or segments concerned. */
  segments: Origin[];
}

/** Material that should go but that the tool cannot reach. */
export interface Uncut {
  /**
   * The vertices of its outline: `x0, y0, x1, y1, …`, along the contour, and back along the tool
   * where it comes nearest; the last is followed by the first.
   */
  outline: Float64Array;
  /** [mm²] */
  area: number;
  /** The blocks or segments that the tool does not reach all of. */
  segments: Origin[];
}
