// The one table of parameters that the controls are made of.

import type { Dialect, ParseOptions, Profile, ProgramOptions, Target, ToolSize } from "g41";

/** The values of all parameters that are not part of the program. */
export interface Settings {
  /** The control that the program is written for. */
  readonly profile: Profile;
  readonly dialect: Dialect;
  /** The control that the compensated program is written for. */
  readonly target: Target;
  /** Radius of every tool that `tools` does not list [mm]. */
  readonly radius: number;
  /** Tools by their number. */
  readonly tools: Readonly<Record<number, ToolSize>>;
  readonly corner: "profile" | "linear" | "arc";
  readonly spline: "exact" | "type-points";
  /** How far the path may be from the true equidistant [mm]. */
  readonly tolerance: number;
  /** What becomes of places where the tool does not fit. */
  readonly gouge: "report" | "avoid" | "stop";
  /** Along the contour only, or as many beside each other as a pocket has room for. */
  readonly passes: "one" | "all";
  /** Distance from one pass to the next [mm]. */
  readonly stepover: number;
}

/** A parameter that is a number. */
export interface NumberParameter {
  readonly kind: "number";
  readonly key: "radius" | "stepover" | "tolerance";
  readonly label: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  /** What to do where less than `min` is meant. */
  readonly instead?: string;
  readonly step: number;
  /** The range of the slider; without it there is none. */
  readonly slider?: { readonly min: number; readonly max: number; readonly step: number };
  readonly hint: string;
  /** Whether it matters; it does where this is left out. */
  readonly matters?: (settings: Settings) => boolean;
}

/** A parameter that is one of a few words. */
export interface ChoiceParameter {
  readonly kind: "choice";
  /** The side is a word of the program, all else are settings. */
  readonly key: "side" | "corner" | "spline" | "gouge" | "passes";
  readonly label: string;
  /** What each value is called. */
  readonly choices: Readonly<Record<string, string>>;
  /** What some of them are besides. */
  readonly details?: Readonly<Record<string, string>>;
  readonly hint: string;
  readonly matters?: (settings: Settings) => boolean;
}

/** One row of the table. */
export type Parameter = NumberParameter | ChoiceParameter;

/** Where everything begins. */
export const INITIAL_SETTINGS: Settings = {
  profile: "g41",
  dialect: "auto",
  target: "grbl",
  radius: 3,
  tools: {},
  corner: "profile",
  spline: "exact",
  tolerance: 0.001,
  gouge: "report",
  passes: "one",
  stepover: 2,
};

/** The table of parameters. */
export const PARAMETERS: readonly Parameter[] = [
  {
    kind: "number",
    key: "radius",
    label: "Tool radius",
    unit: "mm",
    min: 0,
    max: 1000,
    instead: "for the other side choose G41 or G42",
    step: 0.001,
    slider: { min: 0, max: 20, step: 0.1 },
    hint: "Radius of the cutter",
  },
  {
    kind: "choice",
    key: "side",
    label: "Side",
    choices: { left: "Left", right: "Right" },
    details: { left: "G41", right: "G42" },
    hint: "The side of the contour on which the tool runs, seen along its motion",
  },
  {
    kind: "choice",
    key: "corner",
    label: "Outside corners",
    choices: { profile: "Profile", linear: "Linear", arc: "Arc" },
    hint: "What is inserted at an outside corner: what the profile inserts, straight moves, or an arc",
  },
  {
    kind: "choice",
    key: "spline",
    label: "Splines",
    choices: { exact: "Exact", "type-points": "Type points" },
    hint: "Exact: the equidistant within the tolerance. Type points: the spline through the moved type points",
  },
  {
    kind: "choice",
    key: "gouge",
    label: "Gouges",
    choices: { report: "Report", avoid: "Avoid", stop: "Stop" },
    hint: "Where the tool does not fit. Report: it cuts too deep, and that is said. Avoid: it keeps clear, and what it leaves is shown. Stop: there is no path",
  },
  {
    kind: "choice",
    key: "passes",
    label: "Passes",
    choices: { one: "One", all: "Clear the pocket" },
    hint: "One: along the contour. Clear the pocket: more of them inside, until there is no room left",
    matters: ({ gouge }) => gouge === "avoid",
  },
  {
    kind: "number",
    key: "stepover",
    label: "Stepover",
    unit: "mm",
    min: 0.01,
    max: 1000,
    step: 0.01,
    slider: { min: 0.1, max: 20, step: 0.1 },
    hint: "Distance from one pass to the next",
    matters: ({ gouge, passes }) => gouge === "avoid" && passes === "all",
  },
  {
    kind: "number",
    key: "tolerance",
    label: "Tolerance",
    unit: "mm",
    min: 0.0001,
    max: 1,
    step: 0.0001,
    hint: "How far the tool path may be from the true equidistant",
  },
];

/** The settings as `parseProgram` takes them. */
export function parseOptions({ dialect, profile }: Settings): ParseOptions {
  return { dialect, profile };
}

/** The settings as `compensate` takes them for a program. */
export function compensationOptions(settings: Settings): ProgramOptions {
  const { profile, radius, tools, corner, spline, tolerance, gouge, passes, stepover } = settings;
  const options: ProgramOptions = { profile, radius, tools, spline, tolerance, gouge };
  if (corner !== "profile") options.corner = corner;
  return gouge === "avoid" && passes === "all" ? { ...options, passes, stepover } : options;
}

/** The signed radius of a tool by its number [mm]; `unit` tells that of the program there [mm]. */
export function radiusOfTool(
  settings: Settings,
  tool: number | undefined,
  unit: () => number,
): number {
  const size = tool === undefined ? undefined : settings.tools[tool];
  if (!size) return settings.radius;
  return "radius" in size ? size.radius : (size.diameter / 2) * unit();
}

/** A number within the range of its parameter; undefined for what is not a number. */
export function clampParameter(parameter: NumberParameter, value: number): number | undefined {
  if (!Number.isFinite(value)) return undefined;
  return Math.min(parameter.max, Math.max(parameter.min, value));
}
