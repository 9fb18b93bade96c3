// The worker that draws very long programs: bitmaps of views, and what lies where.

import { distance, nearestOnLine, type Point } from "../geometry";
import { type Box, toWorld } from "../view";
import { forChunks, type Level, levelFor, levelsOf } from "./levels";
import type { Answer, Draw, Load, Seek, Task, Trace } from "./protocol";
import type { StrokeKind, Strokes } from "./strokes";

/** Cells of the level that is drawn are at most so large [px]. */
const CELL = 0.5;
/** More dashed chords than this take longer than they say. */
const MOST_DASHED = 3000;
/** Chords of one path: very long ones are slow. */
const RUN = 2000;

const WIDTHS: Readonly<Record<StrokeKind, number>> = {
  rapid: 1,
  free: 1.25,
  contour: 1.5,
  lead: 1.5,
  cut: 1.5,
};
const DASHES: Partial<Record<StrokeKind, number[]>> = { rapid: [2, 4], lead: [6, 4] };

/** Lines of one kind. */
interface Layer {
  readonly strokes: Strokes;
  readonly levels: readonly Level[];
}

let layers: Layer[] = [];

self.addEventListener("message", ({ data }: MessageEvent<Task>) => {
  switch (data.kind) {
    case "load":
      load(data);
      break;
    case "draw":
      draw(data);
      break;
    case "seek":
      send({ kind: "found", id: data.id, line: seek(data) });
      break;
    case "trace":
      trace(data);
  }
});

function send(answer: Answer, transfer: Transferable[] = []): void {
  self.postMessage(answer, { transfer });
}

function load({ strokes }: Load): void {
  // What was drawn before must not take memory while this is made.
  layers = [];
  layers = strokes.map((each) => ({ strokes: each, levels: levelsOf(each.points) }));
}

function draw({ id, view, size, margin, ratio, colors }: Draw): void {
  const began = performance.now();
  const [width, height] = [size.width + 2 * margin, size.height + 2 * margin];
  const canvas = new OffscreenCanvas(Math.round(width * ratio), Math.round(height * ratio));
  const context = canvas.getContext("2d");
  if (!context) throw new Error("there is no canvas to draw on");
  context.setTransform(ratio, 0, 0, ratio, margin * ratio, margin * ratio);
  context.lineJoin = "round";
  context.lineCap = "round";
  const [x0, y1] = toWorld(view, [-margin, -margin]);
  const [x1, y0] = toWorld(view, [size.width + margin, size.height + margin]);
  const window: Box = { min: [x0, y0], max: [x1, y1] };
  let vertices = 0;
  for (const { strokes, levels } of layers) {
    const level = levelFor(levels, CELL / view.scale);
    if (!level || level.points.length === 0) continue;
    const runs: [number, number][] = [];
    let count = 0;
    forChunks(level, window, (first, last) => {
      runs.push([first, last]);
      count += last - first;
    });
    vertices += count;
    const dash = count <= MOST_DASHED ? DASHES[strokes.kind] : undefined;
    context.setLineDash(dash ?? []);
    context.lineWidth = WIDTHS[strokes.kind];
    context.strokeStyle = colors[strokes.kind];
    stroke(context, level.points, runs, view);
  }
  const bitmap = canvas.transferToImageBitmap();
  const milliseconds = performance.now() - began;
  send({ kind: "drawn", id, bitmap, view, size, margin, colors, vertices, milliseconds }, [bitmap]);
}

function stroke(
  context: OffscreenCanvasRenderingContext2D,
  points: Float64Array,
  runs: readonly [number, number][],
  { scale, x: left, y: top }: Draw["view"],
): void {
  context.beginPath();
  let length = 0;
  let before = -1;
  for (const [first, last] of runs) {
    // Where a chunk follows the one before, the pen is there already.
    let down = first === before;
    for (let i = down ? first + 1 : first; i <= last; i += 1) {
      const x = points[2 * i] as number;
      if (Number.isNaN(x)) {
        down = false;
        continue;
      }
      const px = left + x * scale;
      const py = top - (points[2 * i + 1] as number) * scale;
      if (!down) context.moveTo(px, py);
      else context.lineTo(px, py);
      down = true;
      length += 1;
      if (length === RUN) {
        context.stroke();
        context.beginPath();
        context.moveTo(px, py);
        length = 0;
      }
    }
    before = Number.isNaN(points[2 * last] as number) ? -1 : last;
  }
  context.stroke();
}

/** The line of the text of the move nearest to a point. */
function seek({ at, within }: Seek): number | undefined {
  let line: number | undefined;
  let least = within;
  // Rapid moves cross everything: one is meant where nothing else is near.
  const isRapid = (layer: Layer) => Number(layer.strokes.kind === "rapid");
  for (const layer of [...layers].sort((a, b) => isRapid(a) - isRapid(b))) {
    const { strokes, levels } = layer;
    const all = levels.at(-1);
    if (!all || strokes.kind === "contour" || (line && isRapid(layer))) continue;
    const { points, lines } = strokes;
    const near: Box = {
      min: [at[0] - within, at[1] - within],
      max: [at[0] + within, at[1] + within],
    };
    forChunks(all, near, (first, last) => {
      for (let i = first + 1; i <= last; i += 1) {
        const [a, b] = [vertex(points, i - 1), vertex(points, i)];
        if (Number.isNaN(a[0]) || Number.isNaN(b[0])) continue;
        const d = distance(nearestOnLine(at, a, b).point, at);
        if (d < least && lines[i]) {
          least = d;
          line = lines[i];
        }
      }
    });
  }
  return line;
}

function trace({ id, line }: Trace): void {
  const found: number[] = [];
  for (const { strokes } of layers) {
    const { points, lines } = strokes;
    for (let i = lines.indexOf(line); i >= 0; i = lines.indexOf(line, i + 1)) {
      const [a, b] = [vertex(points, i - 1), vertex(points, i)];
      // The first vertex of a piece has the line of its first chord, which follows.
      if (i === 0 || Number.isNaN(a[0])) continue;
      if (found.length > 0) found.push(Number.NaN, Number.NaN);
      found.push(...a, ...b);
    }
  }
  const points = Float64Array.from(found);
  send({ kind: "traced", id, line, points }, [points.buffer]);
}

function vertex(points: Float64Array, i: number): Point {
  return [points[2 * i] as number, points[2 * i + 1] as number];
}
