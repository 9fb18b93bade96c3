// The static layer: grid, material, swept area, contour and tool path.

import { findingsOf } from "../findings";
import type { PictureClient } from "../large/picture-client";
import type { LivePicture } from "../live/picture";
import { isLeft, type Result, radiusOn } from "../result";
import { type Box, type Size, sightOf, toScreen, type View } from "../view";
import { type Context, inMillimetres, mark, strokeLine } from "./canvas";
import { drawFindings } from "./findings";
import { drawAxisNames, drawGrid, drawScale } from "./grid";
import type { Palette } from "./palette";
import { drawPlunges } from "./plunges";
import { type ClosedShape, type Shapes, shapesOf } from "./shapes";
import { followedTransitions, type Marked, transitionLine } from "./transition";

/** Half of what the mark of a transition measures [px]. */
const MARK_SIZE = 4.5;
/** More marks than these in sight lie upon each other, and take longer to draw than a frame. */
const MOST_MARKS = 1000;

/** What the static layer shows. */
export interface BaseScene {
  readonly view: View;
  readonly size: Size;
  readonly palette: Palette;
  readonly result: Result | undefined;
  /** The contour that is dragged, where the result is behind it. */
  readonly live: LivePicture | undefined;
  /** Draws a very long program. */
  readonly drawing: PictureClient;
}

/** Draws the static layer. */
export function drawBase(
  context: Context,
  { view, size, palette, result, live, drawing }: BaseScene,
): void {
  drawGrid(context, view, size, palette);
  if (result?.long) {
    drawing.draw(context, view, size, palette.strokes);
  } else if (result) {
    const shapes = shapesOf(result, { view, size, live });
    // One contour may cross the wall of another, at another height: where nothing is found, nothing is red.
    const isGouged = live !== undefined || findingsOf(result).some(({ kind }) => kind !== "uncut");
    inMillimetres(context, view, (px) => {
      drawMaterial(context, shapes, result, palette, px, sightOf(view, size, 1), isGouged);
    });
    drawFindings(context, { view, size, palette }, result, shapes.closed.length > 0);
    inMillimetres(context, view, (px) => {
      context.lineJoin = "round";
      context.lineCap = "round";
      context.lineWidth = 2.25 * px;
      context.strokeStyle = palette.contour;
      for (const outline of shapes.outlines) context.stroke(outline);
      drawPath(context, shapes, palette, px);
    });
    drawPlunges(context, view, result, palette);
    drawTransitions(context, view, size, result, palette);
  }
  drawScale(context, view, size, palette);
  const [right, up] = result?.axes ?? [0, 1];
  if (right !== 0 || up !== 1) drawAxisNames(context, size, palette, [right, up]);
}

/** Fills what should stay, and over it what the tool sweeps: red where it cuts what should stay. */
function drawMaterial(
  context: Context,
  shapes: Shapes,
  result: Result,
  palette: Palette,
  px: number,
  sight: Box,
  isGouged: boolean,
): void {
  const material = new Path2D();
  // Pockets without an outline around them are cut into a plate without end.
  const isPlate = !shapes.closed.some((closed) => liesInside(closed, result));
  // Beside open contours nobody knows where the plate ends.
  const isKnown = shapes.closed.length > 0 && !(isPlate && shapes.closed.length < countOf(result));
  const { min, max } = sight;
  if (isPlate && isKnown) material.rect(min[0], min[1], max[0] - min[0], max[1] - min[1]);
  if (isKnown) for (const { path } of shapes.closed) material.addPath(path);
  context.fillStyle = palette.material;
  context.fill(material, "evenodd");
  context.lineJoin = "round";
  context.lineCap = "round";
  shapes.cuts.forEach((cut, contour) => {
    const width = 2 * Math.abs(radiusOn(result, contour));
    if (width === 0) return;
    context.strokeStyle = palette.swept;
    context.lineWidth = width;
    context.stroke(cut);
    // A pixel and a half less than the tool, or every edge that is cut right would show red.
    if (!isGouged || !isKnown || width < 6 * px) return;
    context.save();
    context.clip(material, "evenodd");
    context.strokeStyle = palette.gouged;
    context.lineWidth = width - 3 * px;
    context.stroke(cut);
    context.restore();
  });
}

/** The number of contours that there is anything of. */
function countOf({ contours }: Result): number {
  return contours.filter(({ segments }) => segments.length > 0).length;
}

/** Whether the workpiece is what a closed contour encloses. */
function liesInside({ area, contour }: ClosedShape, result: Result): boolean {
  return isLeft(result, contour) ? area < 0 : area > 0;
}

function drawPath(context: Context, shapes: Shapes, palette: Palette, px: number): void {
  context.lineWidth = px;
  context.strokeStyle = palette.rapid;
  context.setLineDash([2 * px, 4 * px]);
  context.stroke(shapes.rapids);
  context.setLineDash([]);
  context.lineWidth = 1.25 * px;
  context.strokeStyle = palette.free;
  context.stroke(shapes.free);
  context.lineWidth = 1.5 * px;
  context.strokeStyle = palette.path;
  context.setLineDash([6 * px, 4 * px]);
  context.stroke(shapes.leads);
  context.setLineDash([]);
  context.lineWidth = 1.75 * px;
  for (const cut of shapes.cuts) context.stroke(cut);
}

function drawTransitions(
  context: Context,
  view: View,
  size: Size,
  result: Result,
  palette: Palette,
): void {
  context.save();
  context.lineCap = "butt";
  const shown = toldApart(followedTransitions(result), view, size);
  for (const { transition } of shown) {
    const style = palette.kinds[transition.kind];
    const line = transitionLine(transition, result).map((point) => toScreen(view, point));
    if (transition.kind === "shortened") strokeLine(context, line, style.color, 1.25, [2, 3]);
    else strokeLine(context, line, style.color, 4, style.dash);
  }
  for (const { transition, place } of shown) {
    const style = palette.kinds[transition.kind];
    mark(context, style, toScreen(view, place), MARK_SIZE, palette.paper);
  }
  context.restore();
}

/** Those in sight; where there are very many, one of those whose marks would lie upon each other. */
function toldApart(all: readonly Marked[], view: View, size: Size): readonly Marked[] {
  const inSight = all.filter(({ place, reach }) => {
    const [x, y] = toScreen(view, place);
    const room = reach * view.scale + 2 * MARK_SIZE;
    return x > -room && y > -room && x < size.width + room && y < size.height + room;
  });
  if (inSight.length <= MOST_MARKS) return inSight;
  const taken = new Set<string>();
  return inSight.filter(({ transition: { kind }, place }) => {
    const [x, y] = toScreen(view, place);
    const cell = `${kind} ${Math.round(x / MARK_SIZE)} ${Math.round(y / MARK_SIZE)}`;
    if (taken.has(cell)) return false;
    taken.add(cell);
    return true;
  });
}
