// Gouges and uncut regions: shaded, and the one that is looked at with its measure.

import { type Finding, findingsOf, type GougePlace } from "../findings";
import { along, direction, type Point } from "../geometry";
import type { Result } from "../result";
import { type Box, type Size, sightOf, toScreen, type View } from "../view";
import { type Context, dot, inMillimetres, strokeLine } from "./canvas";
import type { Palette } from "./palette";

/** Distance of hatch lines [px]. */
const HATCH = 7;
/** Thinner than this nothing of what is cut too deep is seen [px]. */
const LEAST_DEPTH = 0.3;

const patterns = new Map<string, HTMLCanvasElement>();

/** Hatches what is not reached, and fills what is cut too deep where the walls are open. */
export function drawFindings(
  context: Context,
  { view, size, palette }: { view: View; size: Size; palette: Palette },
  result: Result,
  hasMaterial: boolean,
): void {
  const sight = sightOf(view, size, 1);
  const uncut = new Path2D();
  const lenses = new Path2D();
  for (const finding of findingsOf(result)) {
    if (finding.kind === "uncut") addOutline(uncut, view, finding.outline);
    else if (!hasMaterial && finding.depth * view.scale > LEAST_DEPTH && isSeen(sight, finding)) {
      addLens(lenses, view, finding);
    }
  }
  context.save();
  context.fillStyle = palette.uncutFill;
  context.fill(uncut);
  context.fillStyle = context.createPattern(hatch(palette.uncut), "repeat") ?? palette.uncutFill;
  context.fill(uncut);
  context.lineWidth = 1;
  context.strokeStyle = palette.uncut;
  context.stroke(uncut);
  context.fillStyle = palette.gouged;
  context.fill(lenses);
  context.restore();
}

/** Draws the finding that is looked at: its outline, or the tool where it cuts deepest. */
export function drawFinding(
  context: Context,
  view: View,
  palette: Palette,
  finding: Finding,
): void {
  if (finding.kind === "uncut") {
    const outline = new Path2D();
    addOutline(outline, view, finding.outline);
    context.fillStyle = palette.uncutFill;
    context.fill(outline);
    context.lineWidth = 2.25;
    context.strokeStyle = palette.uncut;
    context.stroke(outline);
    return;
  }
  const { at, depth, center, radius } = finding;
  inMillimetres(context, view, (px) => {
    context.beginPath();
    context.arc(...center, radius, 0, 2 * Math.PI);
    context.lineWidth = 1.5 * px;
    context.strokeStyle = palette.error;
    context.stroke();
  });
  // The measure runs from the contour to the farthest that the tool cuts.
  const bottom = along(at, direction(center, at), depth);
  const ends: [Point, Point] = [toScreen(view, at), toScreen(view, bottom)];
  strokeLine(context, ends, palette.paper, 5);
  strokeLine(context, ends, palette.error, 2.25);
  for (const end of ends) {
    context.lineWidth = 1.5;
    dot(context, end, 3, palette.error, palette.paper);
  }
}

function addOutline(path: Path2D, view: View, outline: Float64Array): void {
  // The last corner leads back to the first. Browsers measure the whole path where one closes it, which
  // with thousands of outlines in it takes a second.
  for (let i = 0; i + 1 < outline.length + 2; i += 2) {
    const at = i % outline.length;
    const [x, y] = toScreen(view, [outline[at] as number, outline[at + 1] as number]);
    if (i === 0) path.moveTo(x, y);
    else path.lineTo(x, y);
  }
}

/** Whether anything of the tool at a gouge may lie in what is in sight. */
function isSeen({ min, max }: Box, { at: [x, y], radius }: GougePlace): boolean {
  const reach = 2 * radius;
  return x + reach > min[0] && x - reach < max[0] && y + reach > min[1] && y - reach < max[1];
}

/** The part of the tool beyond a straight wall that it cuts `depth` deep. */
function addLens(path: Path2D, view: View, { at, center, radius, depth }: GougePlace): void {
  const [x, y] = toScreen(view, center);
  const towards = direction(center, at);
  const middle = Math.atan2(-towards[1], towards[0]);
  const half = Math.acos(Math.max(-1, Math.min(1, (radius - depth) / radius)));
  path.moveTo(
    x + radius * view.scale * Math.cos(middle - half),
    y + radius * view.scale * Math.sin(middle - half),
  );
  // Filled, it closes by itself.
  path.arc(x, y, radius * view.scale, middle - half, middle + half);
}

/** A tile of lines that rise to the right. */
function hatch(color: string): HTMLCanvasElement {
  const made = patterns.get(color);
  if (made) return made;
  const tile = document.createElement("canvas");
  tile.width = HATCH;
  tile.height = HATCH;
  const context = tile.getContext("2d");
  if (context) {
    context.strokeStyle = color;
    context.lineWidth = 1;
    context.globalAlpha = 0.75;
    // The corners of the tile belong to the lines of its neighbours.
    for (const shift of [-HATCH, 0, HATCH]) {
      context.beginPath();
      context.moveTo(shift - 1, HATCH + 1);
      context.lineTo(shift + HATCH + 1, -1);
      context.stroke();
    }
  }
  patterns.set(color, tile);
  return tile;
}
