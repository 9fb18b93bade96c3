// The public face of the package. Lengths are in mm, angles in rad and counter-clockwise positive,
// feeds in mm/min. Coordinates are those of the program, with y up. Tolerances are at least 1e-6 mm,
// those of paths (`compensate`, `LiveContour`) at least 1e-9 mm.

export * from "./contour.js";
export {
  type CompensationOptions,
  ProgramCompensation,
  type ProgramOptions,
} from "./types/compensation.js";
export {
  type Emitted,
  type GcodeOptions,
  type Target,
} from "./types/gcode.js";
export { type ProgramCheckOptions } from "./types/judge.js";
export { default } from "./types/loading.js";
export {
  type AxisLimits,
  interpolate,
  type Limits,
  Motion,
  type StepRule,
  type Steps,
  type ToolTime,
  type Violation,
} from "./types/motion.js";
export {
  type Dialect,
  type ParseOptions,
  type Profile,
  Program,
  type ProgrammedContour,
  type ProgrammedSegment,
  ProgramReader,
  parseProgram,
} from "./types/programs.js";
export { type BlockOrigin } from "./types/reports.js";
export {
  readToolTable,
  type ToolSize,
  type ToolTable,
} from "./types/tools.js";
