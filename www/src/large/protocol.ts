// What goes to the worker that draws very long programs, and what comes back.

import type { Point } from "../geometry";
import type { Size, View } from "../view";
import type { StrokeKind, Strokes } from "./strokes";

/** Colours of the kinds of lines. */
export type Colors = Readonly<Record<StrokeKind, string>>;

/** Takes a drawing in. */
export interface Load {
  readonly kind: "load";
  readonly id: number;
  readonly strokes: readonly Strokes[];
}

/** Draws a view. */
export interface Draw {
  readonly kind: "draw";
  readonly id: number;
  readonly view: View;
  readonly size: Size;
  /** Room that is drawn around the view, for when it is moved [px]. */
  readonly margin: number;
  /** Pixels of the screen in one of the page. */
  readonly ratio: number;
  readonly colors: Colors;
}

/** Looks for the move nearest to a point. */
export interface Seek {
  readonly kind: "seek";
  readonly id: number;
  readonly at: Point;
  /** [mm] */
  readonly within: number;
}

/** Asks for the moves of a line of the text. */
export interface Trace {
  readonly kind: "trace";
  readonly id: number;
  readonly line: number;
}

/** What is asked of the worker; `id` names the drawing. */
export type Task = Load | Draw | Seek | Trace;

/** A view as it was drawn. */
export interface Drawn {
  readonly kind: "drawn";
  readonly id: number;
  readonly bitmap: ImageBitmap;
  readonly view: View;
  readonly size: Size;
  readonly margin: number;
  readonly colors: Colors;
  /** Vertices that it took, and the time [ms]. */
  readonly vertices: number;
  readonly milliseconds: number;
}

/** What was found near a point. */
export interface Found {
  readonly kind: "found";
  readonly id: number;
  readonly line: number | undefined;
}

/** The moves of a line: x0, y0, x1, y1, …, NaN between two pieces. */
export interface Traced {
  readonly kind: "traced";
  readonly id: number;
  readonly line: number;
  readonly points: Float64Array;
}

/** What the worker answers. */
export type Answer = Drawn | Found | Traced;
