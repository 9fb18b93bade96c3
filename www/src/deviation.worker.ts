// The worker behind the plot of deviations: both spline methods on one program.

import init, { compensate, parseProgram, RECORD_STRIDE } from "g41";
import { modeAt } from "./contour-writer";
import { type Deviation, deviationOf, measureOf } from "./deviation";
import { compensationOptions, parseOptions, radiusOfTool, type Settings } from "./parameters";

/** What is asked of it. */
export interface DeviationRequest {
  readonly text: string;
  readonly settings: Settings;
}

/** What it answers. */
export interface Deviations {
  readonly exact: Deviation;
  readonly typePoints: Deviation;
  /** Arc length of all contours, and where their segments meet [mm]. */
  readonly length: number;
  readonly ends: readonly number[];
  /** [mm] */
  readonly tolerance: number;
}

let ready = init();

self.addEventListener("message", async ({ data }: MessageEvent<DeviationRequest>) => {
  try {
    await ready;
    self.postMessage(deviations(data));
  } catch (error) {
    // After an internal error the package asks to be loaded afresh.
    ready = init();
    self.postMessage(String(error));
  }
});

function deviations({ text, settings }: DeviationRequest): Deviations {
  const { tolerance } = settings;
  const program = parseProgram(text, parseOptions(settings));
  try {
    const { contours } = program;
    const radiusAt = (line: number) => {
      const own = contours.find(({ blocks }) => line >= blocks[0] && line <= blocks[1]);
      const unit = () => modeAt(text.split("\n"), own?.blocks[0] ?? 1).unit;
      return Math.abs(own?.radius ?? radiusOfTool(settings, own?.tool, unit));
    };
    // A tool without a radius follows the contours themselves.
    const programmed = compensate(contours, { radius: 0 });
    const measure = measureOf(
      { numbers: programmed.records(), stride: RECORD_STRIDE },
      (contour, segment) => contours[contour]?.segments[segment]?.origin.block ?? Number.NaN,
    );
    programmed[Symbol.dispose]();
    const along = (spline: Settings["spline"]) => {
      const path = compensate(
        program,
        compensationOptions({ ...settings, spline, gouge: "report" }),
      );
      const records = { numbers: path.records(), stride: RECORD_STRIDE };
      path[Symbol.dispose]();
      return deviationOf(records, measure, radiusAt);
    };
    const { length, ends } = measure;
    return {
      exact: along("exact"),
      typePoints: along("type-points"),
      length,
      ends,
      tolerance,
    };
  } finally {
    program[Symbol.dispose]();
  }
}
