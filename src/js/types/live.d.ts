/// <reference lib="esnext.disposable" />

// Contours that are edited.
import type { ContourOptions } from "./compensation.js";
import type { Contour, ContourRecords, Segment } from "./contours.js";
import type { ToolPath } from "./tool_path.js";

/** Options of a `LiveContour`. */
export interface LiveOptions extends Omit<ContourOptions, "output"> {
  /** Largest distance of a chord of its polylines from their curves [mm]. Default 0.001. */
  chordTolerance?: number;
}

/** What `LiveContour.update` gives. */
export interface LiveUpdate {
  /**
   * All vertices of the tool path: `x0, y0, x1, y1, …`; a vertex may be repeated. This is a view of
   * the WebAssembly's memory: it holds until the next call of anything in this package, and must
   * not be transferred or written to.
   */
  points: Float64Array;
  /** Index of the first vertex of each piece of the path; a view too. */
  starts: Uint32Array;
  /** The first vertex of the path that may differ from the last update. */
  from: number;
  /** The vertex after the last that may differ; `from` where none does. */
  to: number;
  /** The contour itself, in one piece, in the same way. */
  contour: { points: Float64Array; from: number; to: number };
}

/**
 * A contour that is edited, and its tool path, of which every edit makes anew what it changes and
 * no more: moving one of a hundred thousand type points costs what moving one of a hundred does.
 * However many edits came before, the path is within a hundredth of the tolerance of what
 * `compensate` gives for the same contour; with `gouge: "avoid"`, within the tolerance beside places
 * where something is cut out. There a piece of one point, which is nothing to draw, may stand where
 * nothing of the path is left.
 *
 * With `gouge: "stop"`, with `spline: "type-points"` (unless gouges are avoided), and where something
 * is wrong with the contour, every update makes everything anew.
 *
 * A handle into the WebAssembly's memory: it frees itself when it is no longer reachable, or at the
 * end of the block that declares it with `using`.
 */
export class LiveContour {
  /**
   * @throws {G41Error} `"bad-argument"` (also for several contours)
   */
  constructor(contour: Contour | ContourRecords, options?: LiveOptions);
  /**
   * Moves a point: of a line or an arc the end (index 0), of an arc the centre (index 1), of a spline
   * a type point (its place in `points`); segment −1, index 0 is the start of the contour. The next
   * segment follows the end of the one before it, and the start of a closed contour its end.
   *
   * @throws {G41Error} `"bad-argument"` where there is no such point, `"disposed"`
   */
  movePoint(segment: number, index: number, x: number, y: number): void;
  /** Inserts a type point into a spline, before the one at `index` or behind the last. */
  insertPoint(segment: number, index: number, x: number, y: number): void;
  /** Removes a type point from a spline. */
  removePoint(segment: number, index: number): void;
  /** Puts another segment in the place of one; where a spline is one of the two, all is made anew. */
  setSegment(index: number, segment: Segment): void;
  /** Changes options, those that are not given stay as they are; makes everything anew. */
  set(options: LiveOptions): void;
  /** Takes in the edits since the last update, and tells what they have changed. */
  update(): LiveUpdate;
  /**
   * The tool path of the contour as it is now, with diagnostics, gouges and what is uncut; it is
   * computed afresh, which takes the time of `compensate`.
   */
  path(): ToolPath;
  /** Gives the memory back now; the handle cannot be used after it. */
  [Symbol.dispose](): void;
}
