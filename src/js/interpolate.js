// Rules by which controls step along a spline at constant feed, to compare and to teach them.
import { bad, finite, oneOf, positive } from "./check.js";
import { call, needWhole } from "./lifecycle.js";
import { packContours } from "./pack.js";

/** The rules, in the order of the core. */
const rules = /** @type {const} */ ([
  ...["taylor-1", "taylor-2", "runge-kutta", "predictor-corrector", "arc-length"],
]);

/** More corrections than these change nothing. */
const most = 20;

/** @type {typeof import("./types.d.ts").interpolate} */
export function interpolate(contour, step, rule, corrections = 2) {
  needWhole();
  const length = positive(step, () => "step");
  const index = rules.indexOf(oneOf(rule, rules, () => "rule"));
  const count = finite(corrections, () => "corrections");
  if (!Number.isInteger(count) || count < 0 || count > most) {
    bad(() => "corrections", `be a whole number from 0 to ${most}`);
  }
  const records = packContours(contour);
  const found = call((glue) => glue.stepSpline(records, length, index, count));
  const points = new Float64Array((found.length / 3) * 2);
  const lengths = new Float64Array(found.length / 3);
  for (let i = 0; i < lengths.length; i++) {
    points.set(found.subarray(3 * i, 3 * i + 2), 2 * i);
    lengths[i] = /** @type {number} */ (found[3 * i + 2]);
  }
  return { points, lengths };
}
