// The ways between the pieces of a path that avoiding gouges has cut apart. They are none of its moves,
// but are written and planned: up to the height of the program's own rapid moves, across, and down.

import type { Point } from "../geometry";
import { FIELD, MoveRole, RAPID, type Result } from "../result";
import type { Point3 } from "../space/strokes";

/** Nearer than this a move begins where the one before it ends [mm]. */
export const GAP = 1e-6;

/** The place that a field names in the record that begins at an index. */
export function placeOf(records: Float64Array, index: number, field: number): Point3 {
  const at = index + field;
  return [records[at] as number, records[at + 1] as number, records[at + 2] as number];
}

/** How far one place is from another [mm]. */
export function away(a: Point3, b: Point3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** A way above the part. */
export interface Way {
  readonly from: Point3;
  readonly to: Point3;
  /** At which it goes across [mm]. */
  readonly height: number;
  /** The line of the move that it leads to, 0 for none. */
  readonly line: number;
}

/** Finds the ways among the moves of a path, which it is shown one by one. */
export class WayFinder {
  #found: Omit<Way, "height">[] = [];
  #at: Point3 | undefined;
  /** Until the height first changes it is only assumed. */
  #isStated = false;
  /** The highest rapid move [mm]. */
  #clear = -Infinity;

  /** Looks at the move whose record begins at an index. */
  look(records: Float64Array, index: number): void {
    const from = placeOf(records, index, FIELD.from);
    const to = placeOf(records, index, FIELD.to);
    this.#isStated ||= from[2] !== to[2];
    if (this.#isStated && records[index + FIELD.kind] === RAPID) {
      this.#clear = Math.max(this.#clear, to[2]);
    }
    const at = this.#at;
    this.#at = to;
    // Between moves that are not compensated no way is made: words gave the coordinates other numbers.
    if (!at || records[index + FIELD.role] === MoveRole.Free) return;
    if (away(from, at) <= GAP) return;
    const line = records[index + FIELD.block] as number;
    this.#found.push({ from: at, to: from, line: Number.isNaN(line) ? 0 : line });
  }

  /** All of them, once every move was looked at. */
  get ways(): Way[] {
    return this.#found.map((way) => {
      return { ...way, height: Math.max(this.#clear, way.from[2], way.to[2]) };
    });
  }
}

/** The ways as the plane shows them: where each begins and ends. */
export function waysInPlane({ ways, axes: [right, up] }: Pick<Result, "ways" | "axes">) {
  const chords = ways.map(({ from, to }): [Point, Point] => [
    [from[right], from[up]],
    [to[right], to[up]],
  ]);
  return chords.filter(([from, to]) => from[0] !== to[0] || from[1] !== to[1]);
}
