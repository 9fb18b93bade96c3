// The public face of the package. Lengths are in mm, angles in rad and counter-clockwise positive,
// feeds in mm/min. Coordinates are those of the program, with y up. Tolerances are at least 1e-6 mm,
// those of paths (`compensate`, `LiveContour`) at least 1e-9 mm.

export {
  type CompensationOptions,
  type ContourOptions,
  compensate,
  ProgramCompensation,
  type ProgramOptions,
} from "./types/compensation.js";
export {
  type ArcSegment,
  type BezierSegment,
  type Contour,
  type ContourRecords,
  type FlattenedContours,
  flatten,
  type InvoluteSegment,
  type LineSegment,
  type Point,
  type Polylines,
  type Segment,
  type Side,
  type SplineSegment,
} from "./types/contours.js";
export {
  type Emitted,
  type GcodeOptions,
  type Target,
} from "./types/gcode.js";
export {
  type ContourCheckOptions,
  check,
  type ProgramCheckOptions,
} from "./types/judge.js";
export {
  LiveContour,
  type LiveOptions,
  type LiveUpdate,
} from "./types/live.js";
export {
  default,
  type G41Error,
  version,
} from "./types/loading.js";
export {
  type AxisLimits,
  type Limits,
  Motion,
  type ToolTime,
  type Violation,
} from "./types/motion.js";
export {
  type ArcMove,
  type CubicMove,
  type InvoluteMove,
  type LineMove,
  type Move,
  type MoveBase,
  type Point3,
  type RapidMove,
  type Role,
} from "./types/moves.js";
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
export {
  type BlockOrigin,
  type Diagnostic,
  type Gouge,
  type Origin,
  type SegmentOrigin,
  type Transition,
  type Uncut,
} from "./types/reports.js";
export {
  type PathLoop,
  RECORD_STRIDE,
  ToolPath,
} from "./types/tool_path.js";
export {
  readToolTable,
  type ToolSize,
  type ToolTable,
} from "./types/tools.js";
