/// <reference lib="esnext.disposable" />

// The path of the tool centre.
import type { Polylines } from "./contours.js";
import type { Emitted, GcodeOptions } from "./gcode.js";
import type { Limits, Motion } from "./motion.js";
import type { Move } from "./moves.js";
import type { Diagnostic, Gouge, Transition, Uncut } from "./reports.js";

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

/** A path as plain data. */
export interface ToolPathData
  extends Pick<ToolPath, "moves" | "transitions" | "diagnostics" | "gouges" | "loops"> {
  uncut: (Omit<Uncut, "outline"> & { outline: number[] })[];
}

/** A straight move that takes the tool from one piece of a path to the next; it is none of its moves. */
export interface Way {
  /** Index of the move that it leads to. */
  before: number;
  /** The move itself. */
  move: Move;
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
   * How the tool gets from one piece of the path to the next, as it is planned: up to the height of the
   * path's rapid moves, across, and down at the feed of the program's own way down; straight where no
   * such height is known. Not by `g41/contour`.
   *
   * @throws {G41Error} `"not-supported"`
   */
  readonly ways: Way[];
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
   * | 0 | kind: 0 rapid, 1 line, 2 arc, 3 cubic, 4 involute |
   * | 1 | role: 0 segment, 1 transition, 2 lead-in, 3 lead-out, 4 free, 5 link |
   * | 2 | plane: 0 xy, 1 xz, 2 yz; its two axes are x y, z x and y z |
   * | 3 | feed [mm/min], NaN where none is programmed |
   * | 4, 5, 6 | block, N word, column of the origin; NaN where there is none |
   * | 7, 8 | contour, segment of the origin; NaN where there is none |
   * | 9, 10, 11 | from x, y, z |
   * | 12, 13, 14 | to x, y, z |
   * | 15, 16, 17, 18 | arc: center, radius, clockwise (0 or 1); involute: center, baseRadius, clockwise; cubic: control1, control2; points by the two axes of the plane; else 0 |
   *
   * @param from index of the first move; default 0
   * @param to index behind the last; default all
   * @throws {G41Error} `"bad-argument"`
   */
  records(from?: number, to?: number): Float64Array;
  /**
   * Plans how a machine runs the path, from rest to rest: corners rounded within a deviation, feeds kept
   * where the limits allow it, dwells (G4) waited, G61, G61.1 and G64 with P obeyed, and `ways` run from one
   * piece of the path to the next.
   *
   * @throws {G41Error} `"bad-argument"` (also where the period makes more than 8 million samples)
   */
  plan(limits: Limits): Motion;
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
  /** All that the path has as plain data, as `JSON.stringify(path)` writes it. */
  toJSON(): ToolPathData;
  /** Gives the memory back now; the handle cannot be used after it. */
  [Symbol.dispose](): void;
}

/** `Path2D` where the environment has it, so that the types need no DOM elsewhere. */
type Path2DOfEnvironment = typeof globalThis extends { Path2D: { prototype: infer Path } }
  ? Path
  : never;
