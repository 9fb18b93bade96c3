// Programs that are written.
import type { Diagnostic } from "./reports.js";

/**
 * For whom a program is written. What one of them does not know is written as what it knows instead,
 * or left out with a diagnostic.
 *
 * `"grbl"` is read by every controller of plain G-code in millimetres; `"smoothieware"` is its CNC
 * build, `"marlin"` Marlin 2 with its options as delivered. Of these `"fanuc-30i"` alone knows involutes
 * (G2.2, G3.2); elsewhere they become arcs and lines. `"heidenhain"` is the conversational language of the
 * iTNC.
 */
export type Target =
  | "grbl"
  | "grblhal"
  | "linuxcnc"
  | "smoothieware"
  | "marlin"
  | "fanuc-0m"
  | "fanuc-6m"
  | "fanuc-30i"
  | "heidenhain";

/** How code is written. */
export interface GcodeOptions {
  /** For whom. Default `"grbl"`. */
  target?: Target;
  /**
   * How far arcs and lines in the place of cubics and involutes may be from them, rounded as they are written
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
