/// <reference lib="esnext.disposable" />

// Programs that are read.
import type { Contour, Polylines, Segment, Side } from "./contours.js";
import type { Emitted, GcodeOptions } from "./gcode.js";
import type { BlockOrigin, Diagnostic } from "./reports.js";

/** How a program is read. */
export interface ParseOptions {
  /**
   * How the text is to be understood. Default `"auto"`: the dialect that it shows signs of, or else
   * that of the profile's control; with LinuxCNC's profile always its own.
   */
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
  /**
   * How the text was understood: as asked for, or else as `ParseOptions` tells; `"auto"` where it shows
   * signs of no dialect, and the profile asks for none.
   */
  readonly dialect: Dialect;
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
