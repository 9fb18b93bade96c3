// The picture in space, in two layers: the box around the moves, the axes and the moves, which change
// with the camera; and above them what changes more often, the line that is marked and the tool.

import { type Context, labels } from "../draw/canvas";
import type { Palette } from "../draw/palette";
import type { Point } from "../geometry";
import type { StrokeKind } from "../large/strokes";
import type { Size } from "../view";
import { axesOf, type Camera, cornersOf, projection } from "./camera";
import type { Box3, Point3, SpaceStrokes } from "./strokes";

/** How both layers are seen. */
interface Sight {
  readonly camera: Camera;
  readonly size: Size;
  readonly palette: Palette;
  readonly strokes: readonly SpaceStrokes[];
}

/** What the lower layer shows. */
export interface Moves extends Sight {
  /** Around what the tool cuts, without rapid moves. */
  readonly box: Box3 | undefined;
  /** Heights that part the moves that cut into bands, each of another strength [mm]; rising. */
  readonly depths: readonly number[];
  /** Of the vertices of a piece, one in so many is drawn. */
  readonly thin: number;
}

/** What the upper layer shows. */
export interface Marks extends Sight {
  /** The line of the text whose moves are marked. */
  readonly line: number | undefined;
  /** The tool as it runs, with its radius [mm], and the axis that it turns about. */
  readonly tool:
    | { readonly at: Point3; readonly radius: number; readonly axis: 0 | 1 | 2 }
    | undefined;
}

/** How faint the highest moves are. */
const FAINTEST = 0.3;
/** The axes from the origin [px]. */
const AXIS = 54;
/** The tool is drawn so many radii long. */
const TOOL_LENGTH = 6;
/** Chords of a circle of the tool. */
const CHORDS = 40;

const WIDTHS: Readonly<Record<StrokeKind, number>> = {
  rapid: 1,
  free: 1.25,
  contour: 1.75,
  lead: 1.5,
  cut: 1.75,
};

const DASHES: Partial<Readonly<Record<StrokeKind, readonly number[]>>> = {
  rapid: [2, 4],
  lead: [6, 4],
};

/** Draws the lower layer. */
export function drawMoves(context: Context, moves: Moves): void {
  const { size, palette, strokes, camera, box } = moves;
  const toScreen = projection(camera, size);
  context.fillStyle = palette.paper;
  context.fillRect(0, 0, size.width, size.height);
  context.lineJoin = "round";
  context.lineCap = "round";
  if (box) drawBox(context, box, toScreen, palette);
  const names = drawAxes(context, camera, toScreen, palette);
  for (const each of strokes) drawStrokes(context, each, moves, toScreen);
  labels(context, names, palette.ink, palette.paper);
}

/** Draws the upper layer. */
export function drawMarks(context: Context, marks: Marks): void {
  const { size, palette, strokes, camera, line, tool } = marks;
  const toScreen = projection(camera, size);
  context.lineJoin = "round";
  context.lineCap = "round";
  if (line !== undefined) drawLine(context, strokes, line, toScreen, palette.accent);
  if (tool) drawTool(context, camera, tool, toScreen, palette);
}

function drawStrokes(
  context: Context,
  { kind, points }: SpaceStrokes,
  { palette, depths, thin }: Moves,
  toScreen: (p: Point3) => Point,
): void {
  // What lies deeper is stronger; contours and rapid moves are the same at all heights.
  const isBanded = kind === "free" || kind === "cut";
  const steps = isBanded ? depths : [];
  const bands = Array.from({ length: steps.length + 1 }, () => new Path2D());
  const bandOf = (z: number) => {
    let band = 0;
    while (band < steps.length && z > (steps[band] as number)) band += 1;
    return band;
  };
  let before: { at: Point; band: number } | undefined;
  const count = points.length / 3;
  for (let i = 0; i < count; i += 1) {
    const [x, y, z] = [points[3 * i], points[3 * i + 1], points[3 * i + 2]] as [
      number,
      number,
      number,
    ];
    if (Number.isNaN(x)) {
      before = undefined;
      continue;
    }
    const isLast = i + 1 === count || Number.isNaN(points[3 * i + 3] as number);
    if (before && !isLast && i % thin !== 0) continue;
    const at = toScreen([x, y, z]);
    const band = bandOf(z);
    const pen = bands[band];
    if (before?.band !== band) pen?.moveTo(...(before?.at ?? at));
    if (before) pen?.lineTo(...at);
    before = { at, band };
  }
  context.save();
  context.strokeStyle = palette.strokes[kind];
  context.lineWidth = WIDTHS[kind];
  context.setLineDash([...(DASHES[kind] ?? [])]);
  bands.forEach((path, band) => {
    context.globalAlpha = 1 - ((1 - FAINTEST) * band) / Math.max(1, bands.length - 1);
    context.stroke(path);
  });
  context.restore();
}

function drawLine(
  context: Context,
  all: readonly SpaceStrokes[],
  line: number,
  toScreen: (p: Point3) => Point,
  color: string,
): void {
  context.beginPath();
  for (const { points, lines } of all) {
    for (let i = 1; i < lines.length; i += 1) {
      if (lines[i] !== line || Number.isNaN(points[3 * i - 3] as number)) continue;
      const vertex = (k: number) =>
        toScreen([points[k] as number, points[k + 1] as number, points[k + 2] as number]);
      context.moveTo(...vertex(3 * i - 3));
      context.lineTo(...vertex(3 * i));
    }
  }
  context.lineWidth = 4;
  context.strokeStyle = color;
  context.stroke();
}

/** Draws the box around the moves. */
function drawBox(
  context: Context,
  box: Box3,
  toScreen: (p: Point3) => Point,
  palette: Palette,
): void {
  const at = cornersOf(box).map(toScreen) as Point[];
  const edges = [0, 1, 2, 3].flatMap((i): [number, number][] => [
    [i, (i + 1) % 4],
    [i + 4, ((i + 1) % 4) + 4],
    [i, i + 4],
  ]);
  context.beginPath();
  for (const [a, b] of edges) {
    context.moveTo(...(at[a] as Point));
    context.lineTo(...(at[b] as Point));
  }
  context.lineWidth = 1;
  context.strokeStyle = palette.axis;
  context.stroke();
}

/** Draws the axes from the origin of the program; returns their names. */
function drawAxes(
  context: Context,
  camera: Camera,
  toScreen: (p: Point3) => Point,
  palette: Palette,
) {
  const length = AXIS / camera.scale;
  const from = toScreen([0, 0, 0]);
  const ends: Point3[] = [
    [length, 0, 0],
    [0, length, 0],
    [0, 0, length],
  ];
  context.beginPath();
  const names = ends.map((end, axis) => {
    const to = toScreen(end);
    context.moveTo(...from);
    context.lineTo(...to);
    const at: Point = [to[0] + (to[0] - from[0]) * 0.2, to[1] + (to[1] - from[1]) * 0.2];
    return { text: "XYZ"[axis] as string, at, isSeen: Math.hypot(...minus(to, from)) > 8 };
  });
  context.lineWidth = 2;
  context.strokeStyle = palette.muted;
  context.stroke();
  return names.filter(({ isSeen }) => isSeen);
}

function drawTool(
  context: Context,
  camera: Camera,
  { at, radius, axis }: NonNullable<Marks["tool"]>,
  toScreen: (p: Point3) => Point,
  palette: Palette,
): void {
  const [a1, a2] = [(axis + 1) % 3, (axis + 2) % 3] as [0 | 1 | 2, 0 | 1 | 2];
  /** A point beside the axis of the tool, at a height above its end. */
  const place = (angle: number, height: number) => {
    const p = [...at] as [number, number, number];
    p[a1] = at[a1] + radius * Math.cos(angle);
    p[a2] = at[a2] + radius * Math.sin(angle);
    p[axis] += height;
    return toScreen(p);
  };
  const length = TOOL_LENGTH * Math.max(radius, 2 / camera.scale);
  // The edges that are seen lie where the circle is widest across the axis.
  const { right, up } = axesOf(camera);
  const [dx, dy] = [right[axis], up[axis]];
  const across = (k: 0 | 1 | 2) => right[k] * dy - up[k] * dx;
  const edge = Math.hypot(dx, dy) < 1e-9 ? 0 : Math.atan2(across(a2), across(a1));
  const circle = (height: number) => {
    const path = new Path2D();
    for (let i = 0; i <= CHORDS; i += 1) {
      const [px, py] = place((2 * Math.PI * i) / CHORDS, height);
      if (i === 0) path.moveTo(px, py);
      else path.lineTo(px, py);
    }
    return path;
  };
  const body = new Path2D();
  const [a, b] = [place(edge + Math.PI, 0), place(edge + Math.PI, length)];
  const [c, d] = [place(edge, length), place(edge, 0)];
  body.moveTo(...a);
  for (const point of [b, c, d]) body.lineTo(...point);
  body.closePath();
  context.fillStyle = palette.toolFill;
  context.strokeStyle = palette.tool;
  context.lineWidth = 1.5;
  context.fill(body);
  for (const path of [circle(0), circle(length)]) {
    context.fill(path);
    context.stroke(path);
  }
  context.beginPath();
  context.moveTo(...a);
  context.lineTo(...b);
  context.moveTo(...c);
  context.lineTo(...d);
  context.stroke();
}

function minus(a: Point, b: Point): [number, number] {
  return [a[0] - b[0], a[1] - b[1]];
}
