// What goes to the worker and what comes back: plain data, with geometry in typed arrays.

import type { Diagnostic, Dialect, Gouge, ProgrammedContour, Transition, Uncut, Way } from "g41";
import type { Axes, Strokes } from "./large/strokes";
import type { LongText } from "./long-text";
import type { Settings } from "./parameters";
import type { Space } from "./space/strokes";
import type { Box } from "./view";

/** Polylines in one piece of memory; see `Polylines` of the package. */
export interface Lines {
  /** x0, y0, x1, y1, … [mm] */
  readonly points: Float64Array;
  /** Index of the first vertex of each piece. */
  readonly starts: Uint32Array;
  /** For each vertex, the move or segment that the chord ending there belongs to. */
  readonly owners: Uint32Array;
}

/** Letters from which on a program is very long: it is not edited, and drawn by what a view can tell. */
export const VERY_LONG = 1_500_000;

/** Letters from which on it takes long enough to be told how far it is. */
export const LONG = 200_000;

/** One request to the worker. */
export interface Request {
  readonly id: number;
  readonly text: string;
  /** The file of a very long program, which the worker reads by itself. */
  readonly file: File | undefined;
  readonly settings: Settings;
}

/** What a very long program has instead of lists, which would be as long as it. */
export interface Long {
  readonly file: File;
  readonly text: LongText;
  /** The compensated program. */
  readonly code: LongText;
  readonly moves: number;
}

/** What a request gave. */
export interface Result {
  readonly id: number;
  /** The text that was compensated; that of a very long program is in `long`. */
  readonly text: string;
  readonly settings: Settings;
  /** The axes of the plane that is shown. */
  readonly axes: Axes;
  /** The box around what is shown [mm]. */
  readonly box: Box | undefined;
  /** The language in which the text was read. */
  readonly dialect: Dialect;
  /** Numbers of the tools that contours call. */
  readonly tools: readonly number[];
  /** Of a very long program, whose contours, moves, transitions and findings are not listed. */
  readonly long: Long | undefined;
  readonly contours: readonly ProgrammedContour[];
  /** The signed tool radius on each contour [mm]. */
  readonly radii: readonly number[];
  /** The programmed contours; owners count segments through all contours. */
  readonly programmed: Lines;
  /** The tool path; owners are moves. */
  readonly path: Lines;
  /** The same in space, with rapid moves; of a very long program a part of its vertices. */
  readonly space: Space;
  /** The ways between the pieces of the path. */
  readonly ways: readonly Way[];
  /** The moves, `stride` numbers each. */
  readonly records: Float64Array;
  readonly stride: number;
  readonly transitions: readonly Transition[];
  /** The gravest first. */
  readonly diagnostics: readonly Diagnostic[];
  /** How many diagnostics there are, also those that are not listed. */
  readonly counts: Readonly<Record<Diagnostic["severity"], number>>;
  readonly gouges: readonly Gouge[];
  readonly uncut: readonly Uncut[];
  /** The tool path as a program for a controller; that of a very long one is in `long`. */
  readonly gcode: string;
  /** How long reading and compensating took [ms]. */
  readonly milliseconds: number;
}

/** What the worker answers. */
export type Reply =
  | {
      readonly kind: "result";
      readonly result: Result;
      /** What is drawn of a very long program. */
      readonly strokes: readonly Strokes[];
    }
  | { readonly kind: "progress"; readonly id: number; readonly step: string; readonly part: number }
  | { readonly kind: "failure"; readonly id: number; readonly message: string };

/** What a move is there for, as `records()` numbers it. */
export enum MoveRole {
  Segment = 0,
  Transition = 1,
  LeadIn = 2,
  LeadOut = 3,
  Free = 4,
  Link = 5,
}

/** Places of numbers in one record. */
export const FIELD = { kind: 0, role: 1, plane: 2, block: 4, from: 9, to: 12 } as const;

/** The kind of a rapid move in a record. */
export const RAPID = 0;

/** Whether a result is that of a document. */
export function isResultOf(
  result: Result | undefined,
  { text, file }: { readonly text: string; readonly file: File | undefined },
): boolean {
  return result?.text === text && result.long?.file === file;
}

/** The role of a move. */
export function roleOf(result: Result, move: number): MoveRole {
  return result.records[move * result.stride + FIELD.role] as MoveRole;
}

/** The index of the contour that a line of the text belongs to; the first where it is none's. */
export function contourAt({ contours }: Result, line: number | undefined): number {
  const found = contours.findIndex(
    ({ blocks }) => line !== undefined && line >= blocks[0] && line <= blocks[1],
  );
  return Math.max(0, found);
}

/** The signed tool radius on a contour [mm]. */
export function radiusOn({ radii, settings }: Result, contour: number): number {
  return radii[contour] ?? settings.radius;
}

/** Whether the tool runs to the left of a contour; a negative radius swaps the side. */
export function isLeft(result: Result, contour: number): boolean {
  return (result.contours[contour]?.side !== "right") === radiusOn(result, contour) >= 0;
}

/** The line of the text that a move comes from. */
export function lineOfMove(result: Result, move: number): number | undefined {
  const block = result.records[move * result.stride + FIELD.block];
  return block === undefined || Number.isNaN(block) ? undefined : block;
}

/** Calls `visit` for each run of vertices with one owner, first vertex included. */
export function forRuns(
  lines: Lines,
  visit: (owner: number, first: number, last: number) => void,
): void {
  const count = lines.points.length / 2;
  lines.starts.forEach((start, piece) => {
    const end = lines.starts[piece + 1] ?? count;
    let first = start;
    for (let i = start + 1; i < end; i += 1) {
      const owner = lines.owners[i] as number;
      if (i + 1 === end || lines.owners[i + 1] !== owner) {
        visit(owner, first, i);
        first = i;
      }
    }
  });
}

/** What tells a diagnostic from the others, also when it is found again. */
export function keyOf({ code, message, origin }: Diagnostic): string {
  return `${code} ${message} ${JSON.stringify(origin)}`;
}

/** The line of the text that a diagnostic or a transition is about. */
export function lineOf({ origin }: Pick<Diagnostic, "origin">): number | undefined {
  return origin && "block" in origin ? origin.block : undefined;
}
