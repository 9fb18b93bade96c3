// The live layer: highlighted segment, construction, tool, handles and diagnostics.

import type { Finding } from "../findings";
import type { Point } from "../geometry";
import { type Handle, type PointRef, samePoint } from "../part";
import { forRuns, keyOf, lineOfMove, type Result } from "../result";
import { type Size, toScreen, type View } from "../view";
import { type Context, dot, inMillimetres, label, strokeLine } from "./canvas";
import { drawFinding } from "./findings";
import type { Palette } from "./palette";
import { addRun } from "./shapes";
import { drawConstruction } from "./transition";

/** Room that one mark of a diagnostic takes [px]. */
const MARK_ROOM = 44;

/** The tool at a place. */
export interface Tool {
  readonly at: Point;
  /** [mm] */
  readonly radius: number;
  /** Whether it is on its way, and cuts nothing: then its edge is dashed. */
  readonly isRapid?: boolean;
}

/** What the live layer shows. */
export interface OverlayScene {
  readonly view: View;
  readonly size: Size;
  readonly palette: Palette;
  readonly result: Result | undefined;
  readonly handles: readonly Handle[];
  readonly selection: PointRef | undefined;
  readonly hover: PointRef | undefined;
  /** Whether the keyboard is on the canvas, so that the selected point shows a focus ring. */
  readonly focused: boolean;
  /** Whether handles are sized for fingers. */
  readonly touch: boolean;
  /** Index of the transition whose construction is shown. */
  readonly corner: number | undefined;
  /** Where the tool stands, and its radius [mm]. */
  readonly tool: Tool | undefined;
  /** Index of the highlighted segment, counted through all contours. */
  readonly segment: number | undefined;
  /** Lines of the text whose moves are highlighted. */
  readonly lines: readonly number[];
  /** The moves of a line of a very long program: x0, y0, x1, y1, …; NaN between two pieces. */
  readonly traced: Float64Array | undefined;
  /** The key of the diagnostic that was chosen in the list. */
  readonly chosen: string | undefined;
  /** The gouge or uncut region that is looked at. */
  readonly finding: Finding | undefined;
}

/** Draws the live layer. */
export function drawOverlay(context: Context, scene: OverlayScene): void {
  const { size, result, view, palette, corner, tool } = scene;
  context.clearRect(0, 0, size.width, size.height);
  context.lineJoin = "round";
  if (result) {
    drawHighlight(context, scene, result);
    if (tool) drawTool(context, view, palette, tool);
    if (scene.finding) drawFinding(context, view, palette, scene.finding);
  }
  drawHandles(context, scene);
  const transition = corner === undefined ? undefined : result?.transitions[corner];
  if (result && transition) drawConstruction(context, view, palette, transition, result);
  if (result) drawDiagnostics(context, scene, result);
}

function drawHighlight(context: Context, scene: OverlayScene, result: Result): void {
  const { view, palette, segment, lines, traced } = scene;
  if (result.long) {
    if (traced) drawTraced(context, view, palette, traced);
    return;
  }
  if (segment === undefined && lines.length === 0) return;
  const programmed = new Path2D();
  forRuns(result.programmed, (owner, first, last) => {
    if (owner === segment) addRun(programmed, result.programmed, first, last);
  });
  const path = new Path2D();
  forRuns(result.path, (move, first, last) => {
    const line = lineOfMove(result, move);
    if (line !== undefined && lines.includes(line)) addRun(path, result.path, first, last);
  });
  inMillimetres(context, view, (px) => {
    context.lineCap = "round";
    context.strokeStyle = palette.accent;
    context.globalAlpha = 0.28;
    context.lineWidth = 8 * px;
    context.stroke(path);
    context.globalAlpha = 1;
    context.lineWidth = 3.5 * px;
    context.stroke(programmed);
  });
  context.lineCap = "butt";
}

function drawTraced(context: Context, view: View, palette: Palette, points: Float64Array): void {
  context.beginPath();
  let down = false;
  for (let i = 0; i < points.length; i += 2) {
    const at: Point = [points[i] as number, points[i + 1] as number];
    const [x, y] = toScreen(view, at);
    if (down) context.lineTo(x, y);
    else context.moveTo(x, y);
    down = !Number.isNaN(at[0]);
  }
  context.lineCap = "round";
  context.strokeStyle = palette.accent;
  context.globalAlpha = 0.28;
  context.lineWidth = 10;
  context.stroke();
  context.globalAlpha = 1;
  context.lineWidth = 3.5;
  context.stroke();
  context.lineCap = "butt";
}

function drawTool(context: Context, view: View, palette: Palette, tool: Tool): void {
  const { at, radius, isRapid = false } = tool;
  const [x, y] = toScreen(view, at);
  const r = radius * view.scale;
  context.beginPath();
  context.arc(x, y, r, 0, 2 * Math.PI);
  context.fillStyle = palette.toolFill;
  if (!isRapid) context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = palette.tool;
  context.setLineDash(isRapid ? [3, 4] : []);
  context.stroke();
  context.setLineDash([]);
  const cross = Math.min(6, Math.max(3, r * 0.3));
  strokeLine(
    context,
    [
      [x - cross, y],
      [x + cross, y],
    ],
    palette.tool,
    1.25,
  );
  strokeLine(
    context,
    [
      [x, y - cross],
      [x, y + cross],
    ],
    palette.tool,
    1.25,
  );
}

function drawHandles(context: Context, scene: OverlayScene): void {
  const { view, palette, handles, selection, hover } = scene;
  const big = scene.touch ? 1.35 : 1;
  drawSpokes(context, scene);
  for (const { ref, at } of handles) {
    const place = toScreen(view, at);
    const selected = samePoint(ref, selection);
    const active = selected || samePoint(ref, hover);
    const fill = selected ? palette.accent : palette.handleFill;
    const rim = active ? palette.accent : palette.ink;
    context.lineWidth = active ? 2.25 : 1.5;
    if (selected && scene.focused) {
      context.beginPath();
      context.arc(...place, 11 * big, 0, 2 * Math.PI);
      context.strokeStyle = palette.accent;
      context.stroke();
    }
    drawHandle(context, ref, place, (active ? 1.25 : 1) * big, fill, rim);
  }
}

/** Type points are round, ends are square, points of shape are small, leads are hollow rings. */
function drawHandle(
  context: Context,
  { role }: PointRef,
  [x, y]: Point,
  scale: number,
  fill: string,
  rim: string,
): void {
  if (role === "type") dot(context, [x, y], 4.5 * scale, fill, rim);
  else if (role === "lead-in" || role === "lead-out") dot(context, [x, y], 3.75 * scale, fill, rim);
  else if (role === "middle" || role === "center") {
    const s = (role === "middle" ? 3.75 : 3.25) * scale;
    context.beginPath();
    context.moveTo(x, y - s);
    context.lineTo(x + s, y);
    context.lineTo(x, y + s);
    context.lineTo(x - s, y);
    context.closePath();
    context.fillStyle = fill;
    context.fill();
    context.strokeStyle = rim;
    context.stroke();
  } else {
    const s = 3.9 * scale;
    context.beginPath();
    context.rect(x - s, y - s, 2 * s, 2 * s);
    context.fillStyle = fill;
    context.fill();
    context.strokeStyle = rim;
    context.stroke();
  }
}

/** Lines that say which arc a centre belongs to, for the point that is taken hold of. */
function drawSpokes(context: Context, { view, palette, handles, selection, hover }: OverlayScene) {
  for (const ref of [selection, hover]) {
    if (ref?.role !== "center") continue;
    const own = (role: string, segment: number) =>
      handles.find(
        ({ ref: r }) => r.contour === ref.contour && r.role === role && r.segment === segment,
      );
    const center = own("center", ref.segment);
    for (const other of [own("middle", ref.segment), own("end", ref.segment)]) {
      if (center && other) {
        const ends = [toScreen(view, center.at), toScreen(view, other.at)];
        strokeLine(context, ends, palette.muted, 1, [3, 3]);
      }
    }
  }
}

function drawDiagnostics(context: Context, scene: OverlayScene, result: Result): void {
  const { view, palette, chosen } = scene;
  const taken = new Set<string>();
  for (const diagnostic of result.diagnostics) {
    if (!diagnostic.at || diagnostic.severity === "info") continue;
    const [x, y] = toScreen(view, diagnostic.at);
    if (x < -40 || y < -40 || x > scene.size.width + 40 || y > scene.size.height + 40) continue;
    // Of many that stand on each other one is enough; zoomed in, each is seen.
    const cell = `${Math.round(x / MARK_ROOM)} ${Math.round(y / MARK_ROOM)}`;
    if (taken.has(cell) && keyOf(diagnostic) !== chosen) continue;
    taken.add(cell);
    const color = diagnostic.severity === "error" ? palette.error : palette.warning;
    const isChosen = keyOf(diagnostic) === chosen;
    if (isChosen) {
      context.beginPath();
      context.arc(x, y, 17, 0, 2 * Math.PI);
      context.strokeStyle = color;
      context.lineWidth = 2;
      context.stroke();
    }
    // A filled disc with an exclamation mark, above the point and pointing at it.
    context.beginPath();
    context.moveTo(x, y - 3);
    context.lineTo(x - 5, y - 12);
    context.lineTo(x + 5, y - 12);
    context.closePath();
    context.fillStyle = color;
    context.fill();
    context.lineWidth = 1.5;
    dot(context, [x, y - 18], 8.5, color, palette.paper);
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.font = "700 12px system-ui, sans-serif";
    context.fillStyle = palette.paper;
    context.fillText("!", x, y - 17.5);
    if (isChosen && diagnostic.depth !== undefined) {
      context.textAlign = "left";
      label(context, `${diagnostic.depth.toFixed(3)} mm`, [x + 14, y - 18], color, palette.paper);
    }
  }
}
