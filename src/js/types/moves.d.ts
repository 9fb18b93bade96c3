// Moves of the tool centre.
import type { Origin } from "./reports.js";

/** A point in space, `[x, y, z]` [mm]. */
export type Point3 = readonly [x: number, y: number, z: number];

/**
 * What a move is there for; `"free"` moves are not compensated, `"link"` leads from one pass to the next,
 * down as the tool is.
 */
export type Role = "segment" | "transition" | "lead-in" | "lead-out" | "free" | "link";

/** What every move has. */
export interface MoveBase {
  /**
   * The plane in which it is programmed, that of a curve: G17, G18 or G19. A curve is
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
  /** `true` as G2, `false` as G3, seen from the positive side of the third axis of its plane. */
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

/**
 * A move along an involute of a circle, away from the circle where `to` is farther from its centre
 * than `from`.
 */
export interface InvoluteMove extends MoveBase {
  kind: "involute";
  /** Centre of the base circle, at the height of `from`. */
  center: Point3;
  /** Radius of the base circle [mm]. */
  baseRadius: number;
  /** `true` as G2.2, `false` as G3.2, seen from above. */
  clockwise: boolean;
}

/** One move of the tool centre. */
export type Move = RapidMove | LineMove | ArcMove | CubicMove | InvoluteMove;
