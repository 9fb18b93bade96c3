// Small drawing helpers that all layers share: transforms, dots, marks and labels.

import type { Point } from "../geometry";
import type { View } from "../view";
import type { KindStyle } from "./palette";

/** A canvas context, on the screen or off it. */
export type Context = CanvasRenderingContext2D;

/** The height of a label with the room around it [px]. */
const LABEL_HEIGHT = 14;

/** The letters of labels on the canvas. */
const LABEL_FONT = '500 11px "IBM Plex Mono", ui-monospace, monospace';

/** Calls `draw` with millimetres as units, y up; `px` is the size of a pixel in millimetres. */
export function inMillimetres(context: Context, view: View, draw: (px: number) => void): void {
  context.save();
  context.transform(view.scale, 0, 0, -view.scale, view.x, view.y);
  draw(1 / view.scale);
  context.restore();
}

/** A filled dot with a rim. */
export function dot(
  context: Context,
  [x, y]: Point,
  radius: number,
  fill: string,
  rim?: string,
): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  if (rim) {
    context.strokeStyle = rim;
    context.stroke();
  }
}

/** Strokes a line through points. */
export function strokeLine(
  context: Context,
  points: readonly Point[],
  color: string,
  width: number,
  dash: readonly number[] = [],
): void {
  context.beginPath();
  points.forEach(([x, y], i) => {
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.setLineDash([...dash]);
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
  context.setLineDash([]);
}

/** Text with a halo of paper, so that lines below it do not disturb. */
export function label(
  context: Context,
  text: string,
  [x, y]: Point,
  color: string,
  paper: string,
): void {
  context.font = LABEL_FONT;
  context.lineJoin = "round";
  context.lineWidth = 4;
  context.strokeStyle = paper;
  context.strokeText(text, x, y);
  context.fillStyle = color;
  context.fillText(text, x, y);
}

/** A text and the place of its middle [px]. */
export interface Caption {
  readonly text: string;
  readonly at: Point;
}

/** Writes texts over the picture; one that would lie over another before it gives way. */
export function labels(
  context: Context,
  captions: readonly Caption[],
  color: string,
  paper: string,
): void {
  context.font = LABEL_FONT;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const taken: { x: number; y: number; width: number }[] = [];
  for (const { text, at } of captions) {
    const [x, y] = at;
    const { width } = context.measureText(text);
    const covers = (other: (typeof taken)[number]) =>
      Math.abs(other.x - x) < (other.width + width) / 2 + 2 && Math.abs(other.y - y) < LABEL_HEIGHT;
    if (taken.some(covers)) continue;
    taken.push({ x, y, width });
    label(context, text, at, color, paper);
  }
}

/** The mark of a kind of transition about a point. */
export function mark(
  context: Context,
  { shape, color }: KindStyle,
  [x, y]: Point,
  size: number,
  rim: string,
): void {
  context.beginPath();
  if (shape === "square") {
    context.rect(x - size * 0.85, y - size * 0.85, size * 1.7, size * 1.7);
  } else if (shape === "diamond") {
    context.moveTo(x, y - size * 1.2);
    context.lineTo(x + size * 1.2, y);
    context.lineTo(x, y + size * 1.2);
    context.lineTo(x - size * 1.2, y);
    context.closePath();
  } else {
    context.moveTo(x, y - size * 1.2);
    context.lineTo(x + size * 1.15, y + size * 0.85);
    context.lineTo(x - size * 1.15, y + size * 0.85);
    context.closePath();
  }
  context.lineWidth = 3;
  context.lineJoin = "round";
  context.strokeStyle = rim;
  context.stroke();
  context.fillStyle = color;
  context.fill();
}
