// The ways between the pieces of a path that avoiding gouges has cut apart, as a plane shows them.

import type { Point } from "../geometry";
import { FIELD, MoveRole, type Result, roleOf } from "../result";

/** Nearer than this a move begins where the one before it ends [mm]. */
const GAP = 1e-6;

/** A way above the part, and down where it ends. */
export interface Way {
  readonly from: Point;
  readonly to: Point;
}

const known = new WeakMap<Result, readonly Way[]>();

/** The ways of a path; they are in what is written and planned, but are none of its moves. */
export function waysOf(result: Result): readonly Way[] {
  const before = known.get(result);
  if (before) return before;
  const { records, stride, axes, settings } = result;
  const list: Way[] = [];
  // Elsewhere a path is in one piece; where it is not, words gave the coordinates other numbers.
  const count = settings.gouge === "avoid" ? records.length / stride : 0;
  for (let move = 1; move < count; move += 1) {
    if (roleOf(result, move) === MoveRole.Free) continue;
    const at = (index: number, field: number): Point => {
      const [x, y] = axes.map((axis) => records[index * stride + field + axis]);
      return [x as number, y as number];
    };
    const [from, to] = [at(move - 1, FIELD.to), at(move, FIELD.from)];
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) > GAP) list.push({ from, to });
  }
  known.set(result, list);
  return list;
}
