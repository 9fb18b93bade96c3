// The machine that motion is planned for: its limits, the table that their controls are made of, and
// where they are kept.

import type { Limits } from "g41";

/** What is planned with, in the units of the controls. */
export interface Machine {
  /** [mm/min] */
  readonly velocity: number;
  /** [mm/s²] */
  readonly acceleration: number;
  /** [mm/s³] */
  readonly jerk: number;
  /** [mm] */
  readonly cornerDeviation: number;
  /** [µm] */
  readonly chordError: number;
  /** [ms] */
  readonly period: number;
  /** [%] */
  readonly override: number;
  readonly feed: "programmed" | "free";
  readonly mode: "fast" | "textbook";
  readonly corner: "eased" | "ph13" | "ph11" | "ph9" | "ph5";
  readonly curvatureSteps: "round" | "slow" | "stop";
  readonly exactStop: "no" | "yes";
}

/** A limit that is a number. */
export interface NumberLimit {
  readonly kind: "number";
  readonly key: {
    [Key in keyof Machine]: Machine[Key] extends number ? Key : never;
  }[keyof Machine];
  readonly label: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly hint: string;
}

/** A rule that is one of a few words. */
export interface ChoiceLimit {
  readonly kind: "choice";
  readonly key: Exclude<keyof Machine, NumberLimit["key"]>;
  readonly label: string;
  readonly choices: Readonly<Record<string, string>>;
  readonly hint: string;
}

/** A small mill, as most figures of this package are for. */
export const SMALL: Machine = {
  velocity: 12_000,
  acceleration: 2000,
  jerk: 50_000,
  cornerDeviation: 0.05,
  chordError: 1,
  period: 1,
  override: 100,
  feed: "programmed",
  mode: "fast",
  corner: "eased",
  curvatureSteps: "round",
  exactStop: "no",
};

/** Machines by name, as far as they differ from the small one. */
export const MACHINES: Readonly<Record<string, Partial<Machine>>> = {
  "Small mill": {},
  "Fast machine": {
    velocity: 30_000,
    acceleration: 5000,
    jerk: 500_000,
    cornerDeviation: 0.02,
  },
};

/** The limits that a machine's name stands for. */
export const MACHINE_KEYS = ["velocity", "acceleration", "jerk", "cornerDeviation"] as const;

/** The table of limits: those that are always seen, then those that are asked for more rarely. */
export const LIMITS: readonly (readonly (NumberLimit | ChoiceLimit)[])[] = [
  [
    {
      kind: "number",
      key: "velocity",
      label: "Velocity",
      unit: "mm/min",
      min: 1,
      max: 600_000,
      step: 100,
      hint: "Largest velocity, that of rapid moves",
    },
    {
      kind: "number",
      key: "acceleration",
      label: "Acceleration",
      unit: "mm/s²",
      min: 1,
      max: 1e6,
      step: 100,
      hint: "Largest size of the acceleration vector",
    },
    {
      kind: "number",
      key: "jerk",
      label: "Jerk",
      unit: "mm/s³",
      min: 10,
      max: 1e9,
      step: 1000,
      hint: "Largest size of the jerk vector",
    },
    {
      kind: "number",
      key: "cornerDeviation",
      label: "Corner deviation",
      unit: "mm",
      min: 0,
      max: 10,
      step: 0.01,
      hint: "How far rounding may leave a corner; 0 stops at each",
    },
    {
      kind: "choice",
      key: "mode",
      label: "Method",
      choices: { fast: "Fast", textbook: "Textbook" },
      hint: "Fast: as fast as the limits allow. Textbook: one quintic of velocity from corner to corner, which breaks limits",
    },
    {
      kind: "choice",
      key: "feed",
      label: "Feed",
      choices: { programmed: "Programmed", free: "Fastest" },
      hint: "Programmed: the F words. Fastest: whatever the machine can",
    },
  ],
  [
    {
      kind: "number",
      key: "override",
      label: "Feed override",
      unit: "%",
      min: 1,
      max: 1000,
      step: 5,
      hint: "Factor on programmed feeds",
    },
    {
      kind: "number",
      key: "period",
      label: "Period",
      unit: "ms",
      min: 0.05,
      max: 100,
      step: 0.5,
      hint: "Interpolation period: a sample for each",
    },
    {
      kind: "number",
      key: "chordError",
      label: "Chord error",
      unit: "µm",
      min: 0.001,
      max: 1000,
      step: 0.5,
      hint: "Largest gap between the path and the chord of a period",
    },
    {
      kind: "choice",
      key: "corner",
      label: "Corner curve",
      choices: { eased: "Eased", ph13: "13", ph11: "11", ph9: "9", ph5: "5" },
      hint: "The curve that rounds corners: one that is passed in the least time, or a Pythagorean-hodograph curve by its degree, of which that of degree 5 has steps in its jerk",
    },
    {
      kind: "choice",
      key: "curvatureSteps",
      label: "Line to arc",
      choices: { round: "Round", slow: "Slow", stop: "Stop" },
      hint: "Where curvature has a step: rounded within the corner deviation, or passed slowly, or stopped at",
    },
    {
      kind: "choice",
      key: "exactStop",
      label: "Block ends",
      choices: { no: "Pass", yes: "Exact stop" },
      hint: "Exact stop: rest at the end of each block, as after G61.1",
    },
  ],
];

/** Faster than any programmed feed, and so cut down to what the machine can. */
const FREE_OVERRIDE = 100;

/** The limits as `plan` takes them. */
export function limitsOf(machine: Machine): Limits {
  return {
    velocity: machine.velocity / 60,
    acceleration: machine.acceleration,
    jerk: machine.jerk,
    cornerDeviation: machine.cornerDeviation,
    chordError: machine.chordError / 1000,
    period: machine.period / 1000,
    feedOverride: machine.feed === "free" ? FREE_OVERRIDE : machine.override / 100,
    mode: machine.mode,
    corner: machine.corner,
    curvatureSteps: machine.curvatureSteps,
    exactStop: machine.exactStop === "yes",
  };
}

const KEY = "g41.machine";

/** The machine as it was left. */
export function restoreMachine(): Machine {
  try {
    const saved: unknown = JSON.parse(localStorage.getItem(KEY) ?? "null");
    if (saved && typeof saved === "object") return valid(saved as Record<string, unknown>);
  } catch {
    // Where storage is forbidden or garbled, it is the small one.
  }
  return SMALL;
}

/** Keeps the machine over a reload. */
export function saveMachine(machine: Machine): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(machine));
  } catch {
    // Where storage is full or forbidden, it lasts as long as the page.
  }
}

/** A machine whose every value is one that the controls could have given. */
function valid(saved: Record<string, unknown>): Machine {
  const machine: Record<string, unknown> = { ...SMALL };
  for (const limit of LIMITS.flat()) {
    const value = saved[limit.key];
    const isRight =
      limit.kind === "number"
        ? typeof value === "number" && value >= limit.min && value <= limit.max
        : typeof value === "string" && Object.hasOwn(limit.choices, value);
    if (isRight) machine[limit.key] = value;
  }
  return machine as unknown as Machine;
}
