// The public face of "g41/contour": what "g41" has for contours, by a WebAssembly of half the size.
// Of a `ToolPath` here, `plan`, `emit` and `gcode` throw `"not-supported"`. In Node, where nothing is
// downloaded, it is the whole of "g41". Import the one or the other, not both.

export {
  type ContourOptions,
  compensate,
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
export { type ContourCheckOptions, check } from "./types/judge.js";
export { LiveContour, type LiveOptions, type LiveUpdate } from "./types/live.js";
export { default, type G41Error, version } from "./types/loading.js";
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
  type ToolPathData,
  type Way,
} from "./types/tool_path.js";
