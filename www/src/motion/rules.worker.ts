// The worker behind the table of interpolation rules: steps along a program's splines by each of them.

import init, { type Contour, interpolate, type ProgrammedContour, parseProgram } from "g41";
import { parseOptions } from "../parameters";
import { RULES, type RulesErrors, type RulesReply, type RulesRequest } from "./rules-protocol";

/** More steps than these take longer than anybody waits for a table. */
const MOST_STEPS = 40_000;

self.addEventListener("message", async ({ data }: MessageEvent<RulesRequest>) => {
  let reply: RulesReply;
  try {
    await init();
    reply = errorsOf(data);
  } catch (error) {
    // What an asynchronous listener throws is told to nobody.
    reply = error instanceof Error ? error.message : String(error);
  }
  self.postMessage(reply);
});

function errorsOf({ text, settings, steps }: RulesRequest): RulesErrors {
  const { contours } = parseProgram(text, parseOptions(settings));
  const splines = contours.flatMap(splinesOf);
  const columns = steps.map((step) => RULES.map((rule) => worst(splines, step, rule)));
  return { splines: splines.length, columns };
}

/** Each spline of a contour, as a contour of its own. */
function splinesOf({ start, segments }: ProgrammedContour): Contour[] {
  const found: Contour[] = [];
  let from = start;
  for (const segment of segments) {
    const { points } = segment.kind === "spline" ? segment : { points: undefined };
    if (points && segment.kind === "spline") found.push({ start: from, segments: [segment] });
    const end = endOf(segment);
    if (end) from = end;
  }
  return found;
}

function endOf(segment: ProgrammedContour["segments"][number]): Contour["start"] | undefined {
  if ("to" in segment) return segment.to;
  const list = segment.kind === "spline" ? segment.points : segment.controls;
  if (!(list instanceof Float64Array)) return list.at(-1);
  const [x, y] = list.subarray(-2);
  return x === undefined || y === undefined ? undefined : [x, y];
}

/** The largest part of a step that a rule errs by, over all splines; undefined for too many steps. */
function worst(
  splines: readonly Contour[],
  step: number,
  { rule, corrections }: (typeof RULES)[number],
): number | undefined {
  let most = 0;
  let count = 0;
  for (const spline of splines) {
    const { points, lengths } = interpolate(spline, step, rule, corrections);
    count += lengths.length;
    if (count > MOST_STEPS) return undefined;
    for (let i = 1; i < lengths.length; i += 1) {
      const at = (k: number) => (points[2 * i + k] as number) - (points[2 * i - 2 + k] as number);
      // Prediction and correction is made for chords, all else for arcs.
      const way =
        rule === "predictor-corrector"
          ? Math.hypot(at(0), at(1))
          : (lengths[i] as number) - (lengths[i - 1] as number);
      most = Math.max(most, Math.abs(way / step - 1));
    }
  }
  return most;
}
