// Places where the tool goes straight down at a feed: holes, and ways into the material, of which the
// picture of a plane would show nothing.

import type { Point } from "../geometry";
import { waysInPlane } from "../large/ways";
import { FIELD, RAPID, type Result } from "../result";
import { toScreen, type View } from "../view";
import { type Context, dot } from "./canvas";
import type { Palette } from "./palette";

/** More of them than these are a smear. */
const MOST = 5000;

const known = new WeakMap<Result, readonly Point[]>();

/** Where a result goes down, each place once; where a lead-in begins there is a mark already. */
export function plungesOf(result: Result): readonly Point[] {
  const before = known.get(result);
  if (before) return before;
  const { records, stride, axes } = result;
  const [right, up] = axes;
  const down = 3 - right - up;
  const name = ([x, y]: Point) => `${x} ${y}`;
  const places = new Map<string, Point>();
  for (let at = 0; at < records.length && places.size <= MOST; at += stride) {
    const from = (axis: number) => records[at + FIELD.from + axis] as number;
    const to = (axis: number) => records[at + FIELD.to + axis] as number;
    if (records[at + FIELD.kind] === RAPID || !(to(down) < from(down))) continue;
    if (from(right) !== to(right) || from(up) !== to(up)) continue;
    const place: Point = [to(right), to(up)];
    places.set(name(place), place);
  }
  for (const [, to] of waysInPlane(result)) places.set(name(to), to);
  for (const { leadIn } of result.contours) if (leadIn) places.delete(name(leadIn));
  const list = places.size > MOST ? [] : [...places.values()];
  known.set(result, list);
  return list;
}

/** Draws a ring with a dot at each. */
export function drawPlunges(context: Context, view: View, result: Result, palette: Palette): void {
  context.lineWidth = 1.25;
  for (const place of plungesOf(result)) {
    const at = toScreen(view, place);
    dot(context, at, 4.5, palette.paper, palette.free);
    dot(context, at, 1.5, palette.free);
  }
}
