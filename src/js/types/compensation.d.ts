/// <reference lib="esnext.disposable" />

// Compensation and its options.
import type { Contour, ContourRecords, Side } from "./contours.js";
import type { Profile, Program } from "./programs.js";
import type { ToolPath } from "./tool_path.js";
import type { ToolSize } from "./tools.js";

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
   * What becomes of places where the tool does not fit. Default `"report"`. Of a contour given as such
   * all is wall; of one in a program, up to three segments at each end that only run in and out are air.
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
   * its islands, room by room. `loops` tells how the passes lie in each other. Default 1.
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

/** Options for programs. */
export interface ProgramOptions extends CompensationOptions {
  /** Tools by their number, the D word or else the T word. */
  tools?: Readonly<Record<number, ToolSize>>;
  /** Radius of every tool that `tools` does not list [mm]. */
  radius?: number;
}

/**
 * The path of the tool centre. Nothing reachable gives an empty path and diagnostics, never an
 * exception.
 *
 * @throws {G41Error} `"bad-argument"`
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
  /** @throws {G41Error} `"bad-argument"`, `"disposed"` */
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
