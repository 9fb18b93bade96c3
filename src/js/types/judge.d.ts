// The independent judge.
import type { Contour, ContourRecords } from "./contours.js";
import type { Program } from "./programs.js";
import type { Gouge } from "./reports.js";
import type { ToolPath } from "./tool_path.js";
import type { ToolSize } from "./tools.js";

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
 * Several contours are one part: the whole path is held against each, and all of each is wall. In a
 * program each contour is held against the moves of its own blocks, and one whose tool has no radius
 * against none; there what only runs in and out, up to three segments at each end, is air and no wall.
 *
 * @throws {G41Error} `"bad-argument"` (also for a radius that nothing names), `"disposed"`
 */
export function check(program: Program, path: ToolPath, options?: ProgramCheckOptions): Gouge[];
export function check(
  contour: Contour | readonly Contour[] | ContourRecords,
  path: ToolPath,
  options?: ContourCheckOptions,
): Gouge[];
