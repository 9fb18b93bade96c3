// What goes to the worker that plans, and what comes back.

import type { Limits, Violation } from "g41";
import type { Settings } from "../parameters";

/** What is asked. */
export interface MotionRequest {
  readonly id: number;
  readonly text: string;
  readonly settings: Settings;
  readonly limits: Limits;
}

/** Motion as plain data: channels of one length, and what is known of the moves. */
export interface MotionData {
  /** [s] */
  readonly duration: number;
  /** Time of each sample [s]. */
  readonly time: Float64Array;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  /** [mm/s] */
  readonly velocity: Float64Array;
  /** [mm/s²] */
  readonly tangential: Float64Array;
  readonly normal: Float64Array;
  /** [mm/s³] */
  readonly jerk: Float64Array;
  /** The move of each sample, the ways between the pieces of the path counted among its moves. */
  readonly step: Uint32Array;
  /** Length of the way up to each sample [mm]. */
  readonly length: Float64Array;
  /** The feed that each move is to have at most [mm/s]. */
  readonly feeds: Float64Array;
  /** 1 for a rapid move. */
  readonly rapid: Uint8Array;
  /** The line of the text of each move, 0 for none. */
  readonly lines: Uint32Array;
  readonly violations: readonly Violation[];
  readonly limits: Limits;
  /** How long planning took [ms]. */
  readonly milliseconds: number;
}

/** How long the same path takes by another method, and what that breaks. */
export interface Other {
  /** [s] */
  readonly duration: number;
  readonly violations: readonly Violation[];
}

/** What the worker answers: the plan, then what it is held beside, or why there is none. */
export type MotionReply =
  | { readonly kind: "plan"; readonly id: number; readonly data: MotionData }
  | {
      readonly kind: "others";
      readonly id: number;
      readonly stops: Other | undefined;
      /** By the method that was not asked for. */
      readonly method: Other | undefined;
    }
  | { readonly kind: "failure"; readonly id: number; readonly message: string };

/** The method that a plan is held beside. */
export function otherMethod(mode: Limits["mode"]): "fast" | "textbook" {
  return mode === "textbook" ? "fast" : "textbook";
}
