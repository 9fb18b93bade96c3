// The live worker: edits one contour and sends back what has changed of its tool path.

import init, { LiveContour, type LiveOptions } from "g41";
import type { Changed, Grab, Lost, Patch, Step } from "./protocol";

/** How far polylines on the screen may be from their curves [mm]. */
const DRAWING_TOLERANCE = 0.002;
/** The same where there are very many of them. */
const COARSE_TOLERANCE = 0.01;
/** Type points from which on there are very many. */
const MANY = 20_000;

let ready = init();
let live: LiveContour | undefined;

self.addEventListener("message", async ({ data }: MessageEvent<Grab | Step>) => {
  try {
    await ready;
    answer(data);
  } catch {
    // After an internal error the package asks to be loaded afresh.
    ready = init();
    live?.[Symbol.dispose]();
    live = undefined;
    self.postMessage({ id: data.id, lost: true } satisfies Lost);
  }
});

function answer(data: Grab | Step): void {
  const began = performance.now();
  if (data.kind === "grab") grab(data);
  else if (live) edit(live, data);
  if (!live) return;
  const { points, starts, from, to, contour } = live.update();
  const milliseconds = performance.now() - began;
  const changed: Changed = {
    id: data.id,
    path: patch(points, from, to),
    starts: starts.slice(),
    outline: patch(contour.points, contour.from, contour.to),
    milliseconds,
  };
  const buffers = [changed.path.points, changed.starts, changed.outline.points];
  self.postMessage(changed, { transfer: buffers.map((array) => array.buffer as ArrayBuffer) });
}

function grab({ contour, settings, radius }: Grab): void {
  live?.[Symbol.dispose]();
  live = undefined;
  const points = contour.segments.reduce(
    (sum, segment) => sum + (segment.kind === "spline" ? segment.points.length : 1),
    0,
  );
  const many = points > MANY;
  const chordTolerance = many ? COARSE_TOLERANCE : DRAWING_TOLERANCE;
  const { corner, profile, spline, tolerance, gouge } = settings;
  // What depends on the whole contour would be computed at every step.
  const local = {
    gouge: settings.gouge === "avoid" ? "avoid" : "report",
    spline: "exact",
  } as const;
  const options: LiveOptions = { profile, radius, spline, tolerance, gouge, chordTolerance };
  if (corner !== "profile") options.corner = corner;
  live = new LiveContour(contour, many ? { ...options, ...local } : options);
}

function edit(contour: LiveContour, { edits }: Step): void {
  for (const change of edits) {
    if (change.kind === "move") {
      contour.movePoint(change.segment, change.index, change.to[0], change.to[1]);
    } else {
      contour.setSegment(change.segment, change.shape);
    }
  }
}

/** A copy of the vertices that have changed: the memory itself cannot be sent. */
function patch(points: Float64Array, from: number, to: number): Patch {
  return { from, count: points.length / 2, points: points.slice(2 * from, 2 * to) };
}
