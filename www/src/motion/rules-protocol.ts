// The rules of interpolation that are compared, what goes to the worker that does so, and what comes back.

import type { Settings } from "../parameters";

/** The rules, from the plainest on. */
export const RULES = [
  { name: "Taylor, first order", rule: "taylor-1", corrections: 0 },
  { name: "Taylor, second order", rule: "taylor-2", corrections: 0 },
  { name: "Runge and Kutta, fourth order", rule: "runge-kutta", corrections: 0 },
  { name: "Predictor, one correction", rule: "predictor-corrector", corrections: 1 },
  { name: "Predictor, two corrections", rule: "predictor-corrector", corrections: 2 },
  { name: "Arc length, one step of Newton's", rule: "arc-length", corrections: 1 },
  { name: "Arc length, two steps", rule: "arc-length", corrections: 2 },
] as const;

/** What is asked. */
export interface RulesRequest {
  readonly text: string;
  readonly settings: Settings;
  /** Lengths of a step [mm]. */
  readonly steps: readonly number[];
}

/** What the worker answers: a text says why it could not. */
export type RulesReply = RulesErrors | string;

/** How evenly the rules step. */
export interface RulesErrors {
  /** How many splines the program has. */
  readonly splines: number;
  /** For each length of a step the largest error of each rule, as a part of the step. */
  readonly columns: readonly (readonly (number | undefined)[])[];
}
