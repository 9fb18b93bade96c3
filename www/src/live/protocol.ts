// What goes to the live worker and what comes back.

import type { Contour, Segment } from "g41";
import type { Settings } from "../parameters";

/** One change of the contour that is dragged. */
export type Edit =
  | {
      readonly kind: "move";
      readonly segment: number;
      readonly index: number;
      readonly to: readonly [number, number];
    }
  | { readonly kind: "set"; readonly segment: number; readonly shape: Segment };

/** Takes hold of a contour. */
export interface Grab {
  readonly kind: "grab";
  readonly id: number;
  readonly contour: Contour;
  readonly settings: Settings;
  /** The signed tool radius [mm]. */
  readonly radius: number;
}

/** Edits the contour that was taken hold of. */
export interface Step {
  readonly kind: "step";
  readonly id: number;
  readonly edits: readonly Edit[];
}

/** Vertices that have changed: those from `from` on are these, of `count` in all. */
export interface Patch {
  readonly from: number;
  readonly count: number;
  readonly points: Float64Array;
}

/** The contour is held no more: an edit of it was refused. */
export interface Lost {
  readonly id: number;
  readonly lost: true;
}

/** What has changed since the last answer. */
export interface Changed {
  readonly id: number;
  readonly path: Patch;
  readonly starts: Uint32Array;
  readonly outline: Patch;
  /** Time that the edits took in the package [ms]. */
  readonly milliseconds: number;
}
