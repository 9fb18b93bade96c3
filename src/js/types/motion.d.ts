/// <reference lib="esnext.disposable" />

import type { Contour, ContourRecords } from "./contours.js";

// Motion: what a machine can do, and how it then runs a path.

/** Limits of the axes x, y and z one by one, beside those of the vector. */
export interface AxisLimits {
  /** [mm/s] */
  velocity: ArrayLike<number>;
  /** [mm/s²] */
  acceleration: ArrayLike<number>;
  /** [mm/s³] */
  jerk: ArrayLike<number>;
}

/** What a machine can do, and how far its path may leave the programmed one. */
export interface Limits {
  /** Largest velocity, that of rapid moves and of moves without a feed [mm/s]. */
  velocity: number;
  /** Largest size of the acceleration vector [mm/s²]. */
  acceleration: number;
  /** Largest size of the jerk vector [mm/s³]. */
  jerk: number;
  /** How far rounding may leave a corner [mm]; 0 stops at each. Default 0.05. */
  cornerDeviation?: number;
  /** Largest gap between the path and the chord of a period [mm]. Default 0.001. */
  chordError?: number;
  /** Interpolation period [s], which is that of the samples too. Default 0.001. */
  period?: number;
  /** Largest rate of the jerk [mm/s⁴]. Default: the jerk reaches its limit in five periods. */
  snap?: number;
  /**
   * How speed is planned: as fast as the limits allow, or as the textbook has it, which breaks limits and
   * reports which. Default `"fast"`.
   */
  mode?: "fast" | "textbook";
  /** Limits of single axes. */
  axes?: AxisLimits;
  /** Factor on programmed feeds, rapid moves excepted. Default 1. */
  feedOverride?: number;
  /**
   * What becomes of steps of the curvature, as where a line runs into an arc: they are rounded within the
   * corner deviation, or the path is kept and the tool slows down, or stops. Default `"round"`.
   */
  curvatureSteps?: "round" | "slow" | "stop";
  /**
   * The curve that rounds corners: one that is passed in the least time, or a Pythagorean-hodograph curve by
   * its degree, `"ph13"` the textbook's. `"ph5"` has continuous curvature only, the others a continuous rate
   * of it too. Default `"eased"`.
   */
  corner?: "eased" | "ph13" | "ph11" | "ph9" | "ph5";
  /** Whether the tool stops at the end of each block, as after G61.1. Default `false`. */
  exactStop?: boolean;
}

/** The time that a tool is in the spindle. */
export interface ToolTime {
  /** Its T word; there is none before the first. */
  tool?: number;
  /** [s] */
  time: number;
}

/** A limit that motion breaks, where it breaks it most. */
export interface Violation {
  /**
   * Which limit: one of `Limits`, the programmed `"feed"`, one of an axis, or the `"end"` of the path, which
   * motion misses. That of `"snap"` is told as the change of the jerk over a period [mm/s³].
   */
  limit:
    | "velocity"
    | "feed"
    | "acceleration"
    | "jerk"
    | "snap"
    | "axes.velocity"
    | "axes.acceleration"
    | "axes.jerk"
    | "cornerDeviation"
    | "chordError"
    | "end";
  /** The value there, in the unit of the limit; a feed in mm/s. */
  value: number;
  /** What is allowed there. */
  allowed: number;
  /** When [s]. */
  time: number;
}

/**
 * Motion along a path: samples at multiples of the period from 0 on, and at the end.
 *
 * A handle into the WebAssembly's memory: it frees itself when it is no longer reachable, or at the
 * end of the block that declares it with `using`. Channels are copies, made when they are first read, so
 * they outlive the handle; all have the same length.
 */
export class Motion {
  private constructor();
  /** Time of the whole motion [s]. */
  readonly duration: number;
  /** The number of samples. */
  readonly count: number;
  /** Time of each sample [s]. */
  readonly time: Float64Array;
  /** Position of the tool centre [mm]. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  /** Speed along the path [mm/s]. */
  readonly velocity: Float64Array;
  /** Acceleration along the path [mm/s²]. */
  readonly tangentialAcceleration: Float64Array;
  /** Size of the acceleration across the path [mm/s²]. */
  readonly normalAcceleration: Float64Array;
  /** Size of the jerk vector [mm/s³]. */
  readonly jerk: Float64Array;
  /** The move that each sample is on or on the way to, an index into `moves` of the path. */
  readonly block: Uint32Array;
  /** The same with the `ways` of the path counted among its moves, each before the one that it leads to. */
  readonly step: Uint32Array;
  /**
   * The limits that the samples break, each once: found when they are first asked for, by code that shares
   * none with the planner, from the samples and the moves alone.
   */
  readonly violations: Violation[];
  /**
   * The time that each move takes, to within a period [s]; a dwell counts to the move before it. Their sum
   * is the duration.
   */
  blockTimes(): Float64Array;
  /** The time of each tool, in the order in which they come. */
  toolTimes(): ToolTime[];
  /** The samples as comma-separated values: a line of names, then one for each sample. */
  toCsv(): string;
  /** Gives the memory back now; the handle cannot be used after it. */
  [Symbol.dispose](): void;
}

/**
 * A rule by which a control finds its next point on a spline, one period's way further: one or two terms of
 * Taylor's series, the method of Runge and Kutta of order 4, extrapolation with corrections of the chord, or
 * of the arc length. The planner uses none of them: it measures the length of curves.
 */
export type StepRule =
  | "taylor-1"
  | "taylor-2"
  | "runge-kutta"
  | "predictor-corrector"
  | "arc-length";

/** Points along a spline. */
export interface Steps {
  /** x0, y0, x1, y1, … [mm] */
  points: Float64Array;
  /** Arc length from the start of the spline to each point [mm]. */
  lengths: Float64Array;
}

/**
 * Steps of `step` mm along the first spline of a contour, as a rule finds them: for teaching, and to compare
 * how evenly rules keep a feed. It ends where the next point is beyond the spline, or where a rule has lost
 * its way at a sharp bend. A spline may be a million steps long.
 *
 * @param corrections of `"predictor-corrector"` and `"arc-length"`, steps of Newton's method; from 0 to 20,
 *   by default 2
 */
export function interpolate(
  contour: Contour | ContourRecords,
  step: number,
  rule: StepRule,
  corrections?: number,
): Steps;
