// The grid, whose step follows the zoom, with its scale along the edges.

import type { Point } from "../geometry";
import type { Axes } from "../large/strokes";
import { gridStep, type Size, toWorld, type View } from "../view";
import { type Context, label } from "./canvas";
import type { Palette } from "./palette";

/** Draws paper, grid lines and the axes. */
export function drawGrid(context: Context, view: View, size: Size, palette: Palette): void {
  context.fillStyle = palette.paper;
  context.fillRect(0, 0, size.width, size.height);
  const minor = gridStep(view.scale, 12);
  const major = gridStep(view.scale, 60);
  lines(context, view, size, minor, palette.gridMinor);
  lines(context, view, size, major, palette.gridMajor);
  axes(context, view, size, palette.axis);
}

/** Draws the numbers of the grid along the left and the lower edge. */
export function drawScale(context: Context, view: View, size: Size, palette: Palette): void {
  const step = gridStep(view.scale, 60);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const [x0, y1] = toWorld(view, [0, 0]);
  const [x1, y0] = toWorld(view, [size.width, size.height]);
  context.textBaseline = "alphabetic";
  context.textAlign = "center";
  for (let i = Math.ceil(x0 / step); i * step <= x1; i += 1) {
    const x = view.x + i * step * view.scale;
    if (x < 44 || x > size.width - 16) continue;
    label(context, (i * step).toFixed(digits), [x, size.height - 7], palette.label, palette.paper);
  }
  context.textAlign = "left";
  context.textBaseline = "middle";
  for (let i = Math.ceil(y0 / step); i * step <= y1; i += 1) {
    const y = view.y - i * step * view.scale;
    if (y < 12 || y > size.height - 24) continue;
    label(context, (i * step).toFixed(digits), [7, y], palette.label, palette.paper);
  }
}

/** Names the axes of a plane that is not that of x and y. */
export function drawAxisNames(
  context: Context,
  size: Size,
  palette: Palette,
  [right, up]: Axes,
): void {
  const names = "XYZ";
  context.textBaseline = "alphabetic";
  context.textAlign = "right";
  const below: Point = [size.width - 8, size.height - 7];
  label(context, `${names[right]} →`, below, palette.label, palette.paper);
  context.textAlign = "left";
  label(context, `↑ ${names[up]}`, [7, 16], palette.label, palette.paper);
}

function lines(context: Context, view: View, size: Size, step: number, color: string): void {
  const [x0, y1] = toWorld(view, [0, 0]);
  const [x1, y0] = toWorld(view, [size.width, size.height]);
  context.beginPath();
  for (let i = Math.ceil(x0 / step); i * step <= x1; i += 1) {
    const x = Math.round(view.x + i * step * view.scale) + 0.5;
    context.moveTo(x, 0);
    context.lineTo(x, size.height);
  }
  for (let i = Math.ceil(y0 / step); i * step <= y1; i += 1) {
    const y = Math.round(view.y - i * step * view.scale) + 0.5;
    context.moveTo(0, y);
    context.lineTo(size.width, y);
  }
  context.lineWidth = 1;
  context.strokeStyle = color;
  context.stroke();
}

function axes(context: Context, view: View, size: Size, color: string): void {
  const [x, y] = [Math.round(view.x) + 0.5, Math.round(view.y) + 0.5];
  context.beginPath();
  context.moveTo(x, 0);
  context.lineTo(x, size.height);
  context.moveTo(0, y);
  context.lineTo(size.width, y);
  context.strokeStyle = color;
  context.lineWidth = 1;
  context.stroke();
}
