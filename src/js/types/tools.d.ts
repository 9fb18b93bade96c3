// Tools and their tables.
import type { Diagnostic } from "./reports.js";

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
