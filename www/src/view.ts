// The view: how millimetres, y up, become pixels, y down.

import type { Point } from "./geometry";

/** Place and scale of the picture. */
export interface View {
  /** [px/mm] */
  readonly scale: number;
  /** Where the origin of the program lies [px]. */
  readonly x: number;
  readonly y: number;
}

/** The size of the canvas [px]. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A rectangle [mm]. */
export interface Box {
  readonly min: Point;
  readonly max: Point;
}

/** Room that is left free on each side [px]. */
export interface Margins {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

const MIN_SCALE = 0.001;
const MAX_SCALE = 20000;

/** A point of the program on the canvas. */
export function toScreen(view: View, p: Point): Point {
  return [view.x + p[0] * view.scale, view.y - p[1] * view.scale];
}

/** A point of the canvas in the program. */
export function toWorld(view: View, p: Point): Point {
  return [(p[0] - view.x) / view.scale, (view.y - p[1]) / view.scale];
}

/** What is in sight, and some pixels around it. */
export function sightOf(view: View, { width, height }: Size, around: number): Box {
  const [left, top] = toWorld(view, [-around, -around]);
  const [right, bottom] = toWorld(view, [width + around, height + around]);
  return { min: [left, bottom], max: [right, top] };
}

/** The view moved by pixels. */
export function panned(view: View, dx: number, dy: number): View {
  return { ...view, x: view.x + dx, y: view.y + dy };
}

/** The view scaled about a point of the canvas, which stays where it is. */
export function zoomed(view: View, at: Point, factor: number): View {
  const scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, view.scale * factor));
  const ratio = scale / view.scale;
  return { scale, x: at[0] + (view.x - at[0]) * ratio, y: at[1] + (view.y - at[1]) * ratio };
}

/** The view that shows a box as large as fits between margins. */
export function fitted(box: Box, size: Size, margins: Margins): View {
  const width = Math.max(size.width - margins.left - margins.right, 40);
  const height = Math.max(size.height - margins.top - margins.bottom, 40);
  const [w, h] = [box.max[0] - box.min[0], box.max[1] - box.min[1]];
  const fit = Math.min(width / Math.max(w, 1e-6), height / Math.max(h, 1e-6));
  const scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, Number.isFinite(fit) ? fit : 1));
  const center: Point = [(box.min[0] + box.max[0]) / 2, (box.min[1] + box.max[1]) / 2];
  return {
    scale,
    x: margins.left + width / 2 - center[0] * scale,
    y: margins.top + height / 2 + center[1] * scale,
  };
}

/** The box around points given as x0, y0, x1, y1, …, with room around it; undefined for none. */
export function boxOf(room: number, ...arrays: ArrayLike<number>[]): Box | undefined {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const points of arrays) {
    for (let i = 0; i + 1 < points.length; i += 2) {
      const [x, y] = [points[i] as number, points[i + 1] as number];
      x0 = Math.min(x0, x);
      x1 = Math.max(x1, x);
      y0 = Math.min(y0, y);
      y1 = Math.max(y1, y);
    }
  }
  if (x0 > x1) return undefined;
  return { min: [x0 - room, y0 - room], max: [x1 + room, y1 + room] };
}

/** The distance of grid lines [mm]: 1, 2 or 5 times a power of ten, at least `pixels` apart. */
export function gridStep(scale: number, pixels: number): number {
  const least = pixels / scale;
  const power = 10 ** Math.floor(Math.log10(least));
  const factor = [1, 2, 5, 10].find((f) => f * power >= least * (1 - 1e-9)) ?? 10;
  return factor * power;
}

/** The step to which a dragged point is rounded [mm]: a power of ten of about a pixel. */
export function dragStep(scale: number): number {
  const step = 10 ** Math.floor(Math.log10(1.5 / scale));
  return Math.min(1, Math.max(0.001, step));
}
