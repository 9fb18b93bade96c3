/// <reference lib="esnext.disposable" />

// The public face of the package. Lengths are in mm, angles in rad and counter-clockwise positive,
// feeds in mm/min. Coordinates are those of the program, with y up. Tolerances are at least 1e-6 mm,
// those of paths (`compensate`, `LiveContour`) at least 1e-9 mm.

// --- Loading -----------------------------------------------------------------------------------

/**
 * Loads the WebAssembly, once; in Node it is loaded already and this does nothing. Called after a
 * `"trapped"` error it starts afresh.
 *
 * @param source where the `.wasm` file is (an address or a `Response`) or what it is (its bytes or
 *   a `WebAssembly.Module`); by default it is found beside the package
 */
export default function init(source?: string | object): Promise<void>;

/**
 * What every function here throws: wrong use, never wrong geometry. Mistakes in a program or a
 * contour are diagnostics.
 */
export interface G41Error extends Error {
  /**
   * - `"not-initialised"`: `await init()` was not called yet
   * - `"bad-argument"`: an argument has the wrong shape, is not finite, or is unknown; see `path`
   * - `"not-supported"`: an option that this version does not have
   * - `"several-pieces"`: `polyline` of a path that is not in one piece; use `polylines`
   * - `"disposed"`: the handle was given back by `using` or `[Symbol.dispose]()`
   * - `"trapped"`: an earlier call ended in an internal error; `await init()` starts afresh, and
   *   handles made before are lost
   */
  code:
    | "not-initialised"
    | "bad-argument"
    | "not-supported"
    | "several-pieces"
    | "disposed"
    | "trapped";
  /** For `"bad-argument"`: the place in the arguments, as in `segments[3].to[0]`. */
  path?: string;
}

// --- Contours ----------------------------------------------------------------------------------

/** A point in the plane, `[x, y]` [mm]. */
export type Point = readonly [x: number, y: number];

/** A point in space, `[x, y, z]` [mm]. */
export type Point3 = readonly [x: number, y: number, z: number];

/** The side of the contour on which the tool runs, seen along the motion: G41 left, G42 right. */
export type Side = "left" | "right";

/** A straight line from the end of the segment before. */
export interface LineSegment {
  kind: "line";
  to: Point;
}

/** A circular arc; a full circle where its end is its start. */
export interface ArcSegment {
  kind: "arc";
  to: Point;
  center: Point;
  /** `true` as G2, `false` as G3. */
  clockwise: boolean;
}

/** The C2 cubic spline through the end of the segment before and these type points. */
export interface SplineSegment {
  kind: "spline";
  /** The type points after the start, the last of which is the end; or `x0, y0, x1, y1, …`. */
  points: readonly Point[] | Float64Array;
  /** Tangent at the start, of any length but zero; without it, see `smooth`. */
  startTangent?: Point;
  /** Tangent at the end, of any length but zero; without it, see `smooth`. */
  endTangent?: Point;
  /**
   * Whether an end without a given tangent is tangent to a neighbouring line or arc; an end that
   * has neither is natural (curvature zero). Default `false`.
   */
  smooth?: boolean;
  /**
   * Whether the end is smoothly the start. Default: `true` where the spline is all of a closed
   * contour.
   */
  periodic?: boolean;
  /** How the parameter is spaced between type points. Default `"chord"`. */
  parameter?: "chord" | "centripetal";
}

/**
 * Cubic Bézier curves, each from the end of the one before: what spline blocks of a program make
 * that are no spline through type points. A corner between two of them is one of the contour.
 */
export interface BezierSegment {
  kind: "bezier";
  /** Of each curve both inner control points and its end; or `x0, y0, x1, y1, …`. */
  controls: readonly Point[] | Float64Array;
}

/** One segment of a contour; it starts where the one before it ends. */
export type Segment = LineSegment | ArcSegment | SplineSegment | BezierSegment;

/** The programmed boundary of a part. */
export interface Contour {
  start: Point;
  segments: readonly Segment[];
  /** Whether its end, which must be its start, is a corner or joint too. Default `false`. */
  closed?: boolean;
  /** Where a move that switches compensation on comes from; without it there is none. */
  leadIn?: Point;
  /** Where a move that switches compensation off goes to; without it there is none. */
  leadOut?: Point;
  /** The side, where the options name none. */
  side?: Side;
  /** The tool radius [mm], where the options name none. */
  radius?: number;
}

/**
 * One or more contours as numbers, one record after the other:
 *
 * | record | numbers |
 * | --- | --- |
 * | start of a contour | `0, x, y, closed` |
 * | line | `1, x, y` |
 * | arc | `2, x, y, center x, center y, clockwise` |
 * | spline | `3, flags, start tangent x, y, end tangent x, y, count, x0, y0, x1, y1, …` |
 * | lead-in | `4, x, y` |
 * | lead-out | `5, x, y` |
 * | side | `6, right` |
 * | tool radius | `7, radius` |
 * | Bézier curves | `8, count, x0, y0, x1, y1, …` |
 *
 * `closed`, `clockwise` and `right` are 0 or 1. `flags` is a sum of: 1 the start tangent is given, 2 the end
 * tangent is given, 4 smooth, 8 periodic, 16 not periodic, 32 centripetal; a tangent that is not
 * given still takes its two numbers.
 */
export type ContourRecords = Float64Array;

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

/** Polylines within a tolerance of curves. */
export interface Polylines {
  /** All vertices of all pieces: `x0, y0, x1, y1, …`. */
  points: Float64Array;
  /** The same vertices with their height: `x0, y0, z0, x1, …`. */
  points3: Float64Array;
  /**
   * Index of the first vertex of each piece; a piece ends where the next one begins, or at the last
   * vertex. A closed piece repeats its first point as its last.
   */
  starts: Uint32Array;
  /**
   * For each vertex, what the chord that ends there belongs to (for the first vertex of a piece:
   * the chord that begins there): an index into `moves` of a path, or the index of a segment,
   * counted through all contours.
   */
  owners: Uint32Array;
}

/** The polylines of contours: piece i is contour i, empty where it could not be made. */
export interface FlattenedContours extends Polylines {
  /** What is wrong with the contours. */
  diagnostics: Diagnostic[];
}

/**
 * Polylines of contours as they are understood, splines included: for drawing what is programmed
 * and for finding the segment under the pointer. Leads are not part of them.
 *
 * @param tolerance largest distance of a chord from its curve [mm]; default 0.001
 * @throws {G41Error} `"bad-argument"`, `"not-supported"` (a segment of a later version)
 */
export function flatten(
  contour: Contour | readonly Contour[] | ContourRecords,
  tolerance?: number,
): FlattenedContours;

// --- Programs ----------------------------------------------------------------------------------

/** How a program is read. */
export interface ParseOptions {
  /** How the text is to be understood. Default `"auto"`: the dialect that it shows signs of. */
  dialect?: Dialect;
  /**
   * The control that the program is written for: it decides what the words of compensation may ask
   * for, and is the profile of `compensate` unless that names another. Default `"g41"`.
   */
  profile?: Profile;
  /** Whether blocks that begin with `/` are left out. Default `false`. */
  blockDelete?: boolean;
  /** How the parameter of splines through points (G05, G06.1, CSPLINE) is spaced. Default `"chord"`. */
  splineParameter?: "chord" | "centripetal";
  /**
   * How near curves that are no cubics, such as NURBS with weights, are read as cubics [mm].
   * Default 0.0001; a diagnostic tells where.
   */
  curveTolerance?: number;
}

/** The language that a program is written in. */
export type Dialect = "auto" | "linuxcnc" | "fanuc" | "sinumerik";

/**
 * Whose rules of compensation are followed: a named set of the options of `compensate`, and of how
 * a program is read. `"g41"` is the textbook's.
 *
 * `"linuxcnc"` agrees with LinuxCNC in the planes G17 and G18: each move ends where the next one tells
 * it to, arcs go round outside corners, an arc may lead in, and the tip of a lathe tool is where its
 * orientation puts it. Where LinuxCNC stops, the path ends with an error that says why. A tool is
 * called by D, or is the one that the last M6 has put into the spindle.
 */
export type Profile = "g41" | "linuxcnc" | "fanuc" | "isg" | "sinumerik";

/**
 * Reads a program. This never fails as a whole: what was not understood is a diagnostic with its
 * block and column.
 *
 * @throws {G41Error} `"bad-argument"`
 */
export function parseProgram(text: string, options?: ParseOptions): Program;

/**
 * Reads a program as `parseProgram` does, but a slice at a time, for a progress bar and for stopping
 * on the way: a million blocks take seconds.
 *
 * ```js
 * const reader = new ProgramReader(text);
 * while (reader.step(20_000)) show(reader.progress);
 * const program = reader.finish();
 * ```
 *
 * A handle into the WebAssembly's memory: it frees itself when it is no longer reachable, or at the
 * end of the block that declares it with `using`.
 */
export class ProgramReader {
  /** @throws {G41Error} `"bad-argument"` */
  constructor(text: string, options?: ParseOptions);
  /** How much of the text was reached, from 0 to 1. */
  readonly progress: number;
  /**
   * Reads up to so many blocks, those of loops and subprograms as often as they are run.
   *
   * @returns whether there are any left
   * @throws {G41Error} `"bad-argument"`, `"disposed"`
   */
  step(blocks: number): boolean;
  /** Reads what is left, and gives the program; the reader cannot be used after it. */
  finish(): Program;
  /** Gives the memory back now, also on the way; the handle cannot be used after it. */
  [Symbol.dispose](): void;
}

/** A segment of a program. */
export type ProgrammedSegment = Segment & {
  /** The block it comes from, the first where there are several. */
  origin: BlockOrigin;
};

/** A contour as it is programmed: usable as a contour, so it can be edited and compensated. */
export interface ProgrammedContour extends Contour {
  segments: ProgrammedSegment[];
  closed: boolean;
  side: Side;
  /** The tool: the D word, else the T word, if there is one. */
  tool?: number;
  /** The radius, where the program itself states it [mm]. */
  radius?: number;
  /** Lines of the text from the first to the last block of the contour, counted from 1. */
  blocks: [first: number, last: number];
}

/**
 * A program that was read; compensating it again with other options needs no second reading.
 *
 * A handle into the WebAssembly's memory: it frees itself when it is no longer reachable, or at the
 * end of the block that declares it with `using`.
 */
export class Program {
  private constructor();
  /** What was found while reading. */
  readonly diagnostics: Diagnostic[];
  /** The contours between G41 or G42 and G40, in order. */
  readonly contours: ProgrammedContour[];
  /** Numbers of the tools that its contours call, in the order in which they first do. */
  readonly tools: number[];
  /**
   * The programmed contours as polylines: piece i is `contours[i]`.
   *
   * @param tolerance largest distance of a chord from its curve [mm]; default 0.001
   */
  polylines(tolerance?: number): Polylines;
  /**
   * The program as it is programmed, G41 and G42 with their D words kept: for a control that is to
   * compensate itself (`"fanuc-0m"`, `"fanuc-6m"`, `"linuxcnc"`).
   *
   * @throws {G41Error} `"bad-argument"`
   */
  gcode(options?: GcodeOptions): string;
  /** The same with what was found while writing it. */
  emit(options?: GcodeOptions): Emitted;
  /** Gives the memory back now; the handle cannot be used after it. */
  [Symbol.dispose](): void;
}

// --- Compensation ------------------------------------------------------------------------------

/** Options of `compensate` that do not depend on what is compensated. */
export interface CompensationOptions {
  /**
   * A named set of the options below; one that is given explicitly wins. Default: what the program
   * was read with, and `"g41"` for contours.
   */
  profile?: Profile;
  /**
   * How far the path may be from the true equidistant [mm]. Default 0.001. It is at least 1e-11 of the
   * largest coordinate, whose digits keep no more.
   */
  tolerance?: number;
  /**
   * How splines are compensated: `"exact"` is the equidistant curve within the tolerance,
   * `"type-points"` the spline through the moved type points. Default `"exact"`.
   */
  spline?: "exact" | "type-points";
  /**
   * What the paths of splines are made of: cubics, or arcs and lines alone, which takes about twice
   * as many. Either is within the tolerance. Default `"cubics"`.
   */
  output?: "cubics" | "arcs";
  /**
   * How an outside corner is joined: by straight moves, by an arc, or, as SINUMERIK's G451, at the
   * intersection of the offsets, where lines run on straight and arcs on their circles; there by an
   * arc where it is sharper than 100° or beside a spline. Default `"linear"`. A program's own words
   * for corners come first: G39, G25, G26, G450 with DISC, G451, as its `profile` has them.
   */
  corner?: "linear" | "arc" | "intersection";
  /**
   * How compensation is switched on and off: `"textbook"` joins the lead to the contour as any
   * corner, `"perpendicular"` goes straight to the end of the first offset (FANUC type A),
   * `"intersection"` round an outside corner beside the end of the lead and by the intersection of the
   * offsets (FANUC type B, the same as the textbook's), `"extra-move"` to the contour's start itself and
   * off it at right angles (FANUC type C), `"linuxcnc"` to beside the end of the lead-in, from where the
   * first corner is one like any other. Default `"textbook"`.
   */
  lead?: "textbook" | "perpendicular" | "intersection" | "extra-move" | "linuxcnc";
  /**
   * What becomes of places where the tool does not fit. Default `"report"`.
   *
   * - `"report"`: the path is as a control without a look-ahead would cut it, and `gouges` tells
   *   where it cuts too deep, looked at the whole contour; contours given together, with the same
   *   radius, are one part
   * - `"avoid"`: the path leaves out what would gouge, looked at the whole contour: its distance
   *   from every point of it is at least the radius − `tolerance`, leads apart; `uncut` tells what it
   *   does not reach. Contours given together, with the same radius, are one part, as a pocket and
   *   its islands. The path may fall into several pieces. Splines are offset exactly, whatever
   *   `spline` says, and an outside corner is gone round by an arc where straight moves have no room
   * - `"stop"`: as `"report"`, but a path that gouges is empty
   */
  gouge?: "report" | "avoid" | "stop";
  /**
   * How many paths beside each other, with `gouge: "avoid"`: each is farther from the contour by
   * `stepover`, as far as there is room; `"all"` clears a pocket, a closed contour round the tool, with
   * its islands. `loops` tells how the passes lie in each other. Default 1.
   */
  passes?: number | "all";
  /**
   * Distance from one pass to the next [mm]; required where there are several. Up to the radius,
   * nothing within reach is left between them.
   */
  stepover?: number;
  /**
   * Turns that are not a corner, up to this angle [rad]; `"auto"` takes those whose gap is at most
   * a tenth of the tolerance. Default `"auto"`.
   */
  tangentBand?: number | "auto";
}

/** Options for contours. */
export interface ContourOptions extends CompensationOptions {
  /** The side on which the tool runs; required unless the contour names it. */
  side?: Side;
  /**
   * Tool radius [mm]; required unless the contour names it. A negative one swaps the side, zero
   * gives the contour itself.
   */
  radius?: number;
}

/**
 * How large a tool is: its radius [mm], or its diameter as a table without units has it, which counts
 * in the unit (G20 or G21) that is in effect where compensation is switched on. A negative one swaps
 * the side.
 */
export type ToolSize = ({ radius: number } | { diameter: number }) & {
  /** Which way the tip of a lathe tool points, 1 to 9; 0, the default, for a tool that turns. */
  orientation?: number;
};

/** The tools of a table, and what is wrong with it. */
export interface ToolTable {
  /** Tools by their number; one that has no diameter has no size, and is left out. */
  tools: Record<number, ToolSize>;
  /** Errors with their line, in `origin`; what such a line says is left out. */
  diagnostics: Diagnostic[];
}

/**
 * Reads a tool table in LinuxCNC's format: a tool in each line, `T1 P1 D6.0 Z+0.5 Q0 ;remark`, its
 * words in any order. Needs no `init`.
 *
 * @throws {G41Error} `"bad-argument"`
 */
export function readToolTable(text: string): ToolTable;

/** Options for programs. */
export interface ProgramOptions extends CompensationOptions {
  /** Tools by their number, the D word or else the T word. */
  tools?: Readonly<Record<number, ToolSize>>;
  /** Radius of every tool that `tools` does not list [mm]. */
  radius?: number;
}

/** Options of `check` for contours. */
export interface ContourCheckOptions {
  /** Tool radius [mm]; required unless the contours name it, all the same one. */
  radius?: number;
  /** Cuts of at most this depth are none [mm]. Default 0.001. */
  tolerance?: number;
}

/** Options of `check` for programs. */
export interface ProgramCheckOptions {
  /** Tools by their number, the D word or else the T word. */
  tools?: Readonly<Record<number, ToolSize>>;
  /** Radius of every tool that `tools` does not list [mm]. */
  radius?: number;
  /** Cuts of at most this depth are none [mm]. Default 0.001. */
  tolerance?: number;
}

/**
 * The independent judge: where a path comes nearer than radius − tolerance to any point of the
 * contours that it is of. It shares no code with `compensate`, and asks nothing but distances; free
 * moves and moves along z are not judged, leads are.
 *
 * Several contours are one part: the whole path is held against each. In a program each contour is
 * held against the moves of its own blocks, and one whose tool has no radius against none.
 *
 * @throws {G41Error} `"bad-argument"` (also for a radius that nothing names), `"disposed"`
 */
export function check(program: Program, path: ToolPath, options?: ProgramCheckOptions): Gouge[];
export function check(
  contour: Contour | readonly Contour[] | ContourRecords,
  path: ToolPath,
  options?: ContourCheckOptions,
): Gouge[];

/**
 * The path of the tool centre. Nothing reachable gives an empty path and diagnostics, never an
 * exception.
 *
 * @throws {G41Error} `"bad-argument"`, `"not-supported"` (an option value of a later version)
 */
export function compensate(program: Program, options?: ProgramOptions): ToolPath;
export function compensate(
  contour: Contour | readonly Contour[] | ContourRecords,
  options?: ContourOptions,
): ToolPath;

/**
 * Compensates a program as `compensate` does, but a slice at a time. A contour is compensated as a
 * whole, however long it is.
 *
 * A handle into the WebAssembly's memory: it frees itself when it is no longer reachable, or at the
 * end of the block that declares it with `using`. The program must not be disposed of meanwhile.
 */
export class ProgramCompensation {
  /** @throws {G41Error} `"bad-argument"`, `"not-supported"`, `"disposed"` */
  constructor(program: Program, options?: ProgramOptions);
  /** How much of the program was compensated, from 0 to 1. */
  readonly progress: number;
  /**
   * Compensates about so many blocks.
   *
   * @returns whether there are any left
   * @throws {G41Error} `"bad-argument"`, `"disposed"`
   */
  step(blocks: number): boolean;
  /** Compensates what is left, and gives the path; the handle cannot be used after it. */
  finish(): ToolPath;
  /** Gives the memory back now, also on the way; the handle cannot be used after it. */
  [Symbol.dispose](): void;
}

/** What a move is there for; `"free"` moves are not compensated. */
export type Role = "segment" | "transition" | "lead-in" | "lead-out" | "free";

/** What every move has. */
export interface MoveBase {
  /**
   * The plane in which it is programmed, that of an arc or a cubic: G17, G18 or G19. An arc is
   * clockwise or not as seen from the positive side of the third axis.
   */
  plane: "xy" | "xz" | "yz";
  from: Point3;
  to: Point3;
  /** Feed [mm/min], where one is programmed. */
  feed?: number;
  role: Role;
  /** The block or segment it comes from. */
  origin: Origin;
}

/** A straight move at rapid speed (G0). */
export interface RapidMove extends MoveBase {
  kind: "rapid";
}

/** A straight move. */
export interface LineMove extends MoveBase {
  kind: "line";
}

/** A circular move, a full circle where it ends at its start; a helix where the heights differ. */
export interface ArcMove extends MoveBase {
  kind: "arc";
  /** The centre, at the height of `from`. */
  center: Point3;
  /** `true` as G2, `false` as G3, seen from above. */
  clockwise: boolean;
  /** [mm] */
  radius: number;
}

/** A cubic Bézier curve. */
export interface CubicMove extends MoveBase {
  kind: "cubic";
  control1: Point3;
  control2: Point3;
}

/** One move of the tool centre. */
export type Move = RapidMove | LineMove | ArcMove | CubicMove;

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

/**
 * For whom a program is written. What one of them does not know is written as what it knows instead,
 * or left out with a diagnostic.
 *
 * `"grbl"` is read by every controller of plain G-code in millimetres; `"smoothieware"` is its CNC
 * build, `"marlin"` Marlin 2 with its options as delivered.
 */
export type Target =
  | "grbl"
  | "grblhal"
  | "linuxcnc"
  | "smoothieware"
  | "marlin"
  | "fanuc-0m"
  | "fanuc-6m";

/** How code is written. */
export interface GcodeOptions {
  /** For whom. Default `"grbl"`. */
  target?: Target;
  /**
   * How far arcs and lines in the place of cubics may be from them, rounded as they are written
   * [mm]. Default 0.001. Where it is less than three units of the target's last digit, rounding may
   * add as much.
   */
  tolerance?: number;
  /**
   * What cubics become: arcs and lines within the tolerance, or G5 blocks where the target knows
   * them, which it cuts up as finely as it likes. Default `"arcs"`.
   */
  splines?: "arcs" | "native";
  /** Whether a comment before each move that was not programmed says why it is there. */
  explain?: boolean;
  /** Feed of moves for which none is programmed [mm/min]. */
  feed?: number;
  /**
   * Height at which the tool crosses from one piece of the path to the next, and comes to the first
   * piece of contours [mm]: it rises to it, crosses at rapid speed, and goes down at the feed at
   * which the program last went straight down, else at that of the move. At the height of the
   * pieces it crosses straight, as a laser may.
   *
   * Default: the highest at which the path itself has rapid moves. Where that is not above both
   * pieces, the written program ends before the crossing, with the error `"no-clearance"`.
   */
  clearance?: number;
}

/** A program as written. */
export interface Emitted {
  text: string;
  /** What was found while writing it. */
  diagnostics: Diagnostic[];
}

/** One loop of a path in several passes. */
export interface PathLoop {
  /** Index of its first move. */
  from: number;
  /** Index behind its last move. */
  to: number;
  /** Which pass it is part of; the one along the contour is 0. */
  pass: number;
  /**
   * Index of the loop of the pass before that lies round it; none in the first pass, and where no
   * single loop does.
   */
  parent?: number;
}

/** Numbers of one move in `ToolPath.records()`. */
export const RECORD_STRIDE: 19;

/**
 * The path of the tool centre.
 *
 * A handle into the WebAssembly's memory: it frees itself when it is no longer reachable, or at the
 * end of the block that declares it with `using`. Lists are unpacked when they are first read.
 */
export class ToolPath {
  private constructor();
  /** The moves, in order. */
  readonly moves: Move[];
  /** The number of moves. */
  readonly count: number;
  /** The transitions at corners, in order. */
  readonly transitions: Transition[];
  /** What was found on the way; for a program, what was found while reading it comes first. */
  readonly diagnostics: Diagnostic[];
  /** Where the path cuts too deep; with `gouge: "stop"` where it would. */
  readonly gouges: Gouge[];
  /** What the tool cannot reach, with `gouge: "avoid"`. */
  readonly uncut: Uncut[];
  /** The loops of a path in several passes; empty for one pass. */
  readonly loops: PathLoop[];
  /**
   * The vertices `x0, y0, x1, y1, …` of a path in one piece, rapid moves apart; empty for an empty
   * path.
   *
   * @param tolerance largest distance of a chord from its move [mm]; default 0.001
   * @throws {G41Error} `"several-pieces"`, `"bad-argument"`
   */
  polyline(tolerance?: number): Float64Array;
  /**
   * The vertices of all pieces: moves that follow each other without a gap or a rapid move.
   *
   * @param tolerance largest distance of a chord from its move [mm]; default 0.001
   */
  polylines(tolerance?: number): Polylines;
  /**
   * The moves as numbers, `RECORD_STRIDE` for each:
   *
   * | index | number |
   * | --- | --- |
   * | 0 | kind: 0 rapid, 1 line, 2 arc, 3 cubic |
   * | 1 | role: 0 segment, 1 transition, 2 lead-in, 3 lead-out, 4 free |
   * | 2 | plane: 0 xy, 1 xz, 2 yz; its two axes are x y, z x and y z |
   * | 3 | feed [mm/min], NaN where none is programmed |
   * | 4, 5, 6 | block, N word, column of the origin; NaN where there is none |
   * | 7, 8 | contour, segment of the origin; NaN where there is none |
   * | 9, 10, 11 | from x, y, z |
   * | 12, 13, 14 | to x, y, z |
   * | 15, 16, 17, 18 | arc: center, radius, clockwise (0 or 1); cubic: control1, control2; points by the two axes of the plane; else 0 |
   *
   * @param from index of the first move; default 0
   * @param to index behind the last; default all
   * @throws {G41Error} `"bad-argument"`
   */
  records(from?: number, to?: number): Float64Array;
  /** The path for a canvas, rapid moves apart; only where the environment has `Path2D`. */
  toPath2D(): Path2DOfEnvironment;
  /** The path as SVG path data (the `d` attribute), rapid moves apart, with y up. */
  svg(): string;
  /**
   * The path as a program for a controller.
   *
   * @throws {G41Error} `"bad-argument"`
   */
  gcode(options?: GcodeOptions): string;
  /**
   * The same with what was found on the way: feeds that are missing, and pieces between which no
   * height is known to cross at.
   */
  emit(options?: GcodeOptions): Emitted;
  /** Gives the memory back now; the handle cannot be used after it. */
  [Symbol.dispose](): void;
}

// --- Live edits --------------------------------------------------------------------------------

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
   * @throws {G41Error} `"bad-argument"` (also for several contours), `"not-supported"`
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

/** `Path2D` where the environment has it, so that the types need no DOM elsewhere. */
type Path2DOfEnvironment = typeof globalThis extends { Path2D: { prototype: infer Path } }
  ? Path
  : never;

/** The version of the package. */
export function version(): string;
