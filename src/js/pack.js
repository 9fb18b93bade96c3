// Packs contours into numbers; the layout is that of `ContourRecords` in types.d.ts.
import { bad, finite, isPlain, object, oneOf, optional, point, property, truth } from "./check.js";

/** @typedef {import("./check.js").Where} Where */

const START = 0;
const LINE = 1;
const ARC = 2;
const SPLINE = 3;
const LEAD_IN = 4;
const LEAD_OUT = 5;
const SIDE = 6;
const RADIUS = 7;
const BEZIER = 8;
const INVOLUTE = 9;

const contourKeys = new Set([
  ...["start", "segments", "closed", "leadIn", "leadOut", "side", "radius"],
  // What a programmed contour says about itself.
  ...["tool", "blocks"],
]);
// `origin` is what a programmed segment says about itself.
const lineKeys = new Set(["kind", "to", "origin"]);
const arcKeys = new Set(["kind", "to", "center", "clockwise", "origin"]);
const splineKeys = new Set([
  ...["kind", "points", "startTangent", "endTangent", "smooth", "periodic", "parameter", "origin"],
]);

const bezierKeys = new Set(["kind", "controls", "origin"]);
const involuteKeys = new Set(["kind", "to", "center", "baseRadius", "clockwise", "origin"]);

/** @type {readonly ("left" | "right")[]} */
export const sides = ["left", "right"];

/** @type {readonly ("chord" | "centripetal")[]} */
export const parameters = ["chord", "centripetal"];

/**
 * One contour, several, or records as they are.
 *
 * @param {unknown} given
 * @returns {Float64Array}
 */
export function packContours(given) {
  if (given instanceof Float64Array) {
    return given;
  }
  /** @type {number[]} */
  const out = [];
  if (Array.isArray(given)) {
    for (const [i, contour] of given.entries()) {
      packContour(out, contour, () => `[${i}]`);
    }
  } else {
    packContour(out, given, () => "");
  }
  return Float64Array.from(out);
}

/**
 * @param {number[]} out
 * @param {unknown} given
 * @param {Where} where
 */
function packContour(out, given, where) {
  if (!isPlain(given)) {
    bad(() => where() || "contour", "be a contour, an array of contours or a Float64Array");
  }
  const contour = object(given, contourKeys, where);
  /** @type {(key: string) => Where} */
  const at = (key) => () => property(where, key);
  const closed = optional(contour.closed, truth, at("closed")) ?? false;
  out.push(START, ...point(contour.start, at("start")), Number(closed));
  const side = optional(contour.side, (value) => oneOf(value, sides, at("side")));
  if (side !== undefined) {
    out.push(SIDE, Number(side === "right"));
  }
  const radius = optional(contour.radius, finite, at("radius"));
  if (radius !== undefined) {
    out.push(RADIUS, radius);
  }
  if (!Array.isArray(contour.segments)) {
    bad(at("segments"), "be an array of segments");
  }
  for (const [i, segment] of contour.segments.entries()) {
    packSegment(out, segment, () => `${at("segments")()}[${i}]`);
  }
  const leadIn = optional(contour.leadIn, point, at("leadIn"));
  if (leadIn) {
    out.push(LEAD_IN, ...leadIn);
  }
  const leadOut = optional(contour.leadOut, point, at("leadOut"));
  if (leadOut) {
    out.push(LEAD_OUT, ...leadOut);
  }
}

/**
 * The record of one segment.
 *
 * @param {unknown} given
 */
export function packOneSegment(given) {
  /** @type {number[]} */
  const out = [];
  packSegment(out, given, () => "segment");
  return Float64Array.from(out);
}

/**
 * @param {number[]} out
 * @param {unknown} given
 * @param {Where} where
 */
function packSegment(out, given, where) {
  if (typeof given !== "object" || given === null) {
    bad(where, "be a segment");
  }
  const kind = "kind" in given ? given.kind : undefined;
  switch (kind) {
    case "line": {
      const { to } = object(given, lineKeys, where);
      out.push(LINE, ...point(to, () => `${where()}.to`));
      break;
    }
    case "arc": {
      const { to, center, clockwise } = object(given, arcKeys, where);
      out.push(ARC, ...point(to, () => `${where()}.to`));
      out.push(...point(center, () => `${where()}.center`));
      out.push(Number(truth(clockwise, () => `${where()}.clockwise`)));
      break;
    }
    case "spline":
      packSpline(out, object(given, splineKeys, where), where);
      break;
    case "bezier": {
      const { controls } = object(given, bezierKeys, where);
      out.push(BEZIER);
      packPoints(out, controls, () => `${where()}.controls`);
      break;
    }
    case "involute":
      packInvolute(out, object(given, involuteKeys, where), where);
      break;
    default:
      bad(() => `${where()}.kind`, `be "line", "arc", "spline", "bezier" or "involute"`);
  }
}

/**
 * @param {number[]} out
 * @param {Record<string, unknown>} involute
 * @param {Where} where
 */
function packInvolute(out, { to, center, baseRadius, clockwise }, where) {
  /** @type {(key: string) => Where} */
  const at = (key) => () => `${where()}.${key}`;
  out.push(INVOLUTE, ...point(to, at("to")), ...point(center, at("center")));
  out.push(finite(baseRadius, at("baseRadius")), Number(truth(clockwise, at("clockwise"))));
}

/**
 * @param {number[]} out
 * @param {Record<string, unknown>} spline
 * @param {Where} where
 */
function packSpline(out, spline, where) {
  /** @type {(key: string) => Where} */
  const at = (key) => () => `${where()}.${key}`;
  const start = optional(spline.startTangent, tangent, at("startTangent"));
  const end = optional(spline.endTangent, tangent, at("endTangent"));
  const smooth = optional(spline.smooth, truth, at("smooth"));
  const periodic = optional(spline.periodic, truth, at("periodic"));
  const parameter = optional(spline.parameter, (value) =>
    oneOf(value, parameters, at("parameter")),
  );
  const flags =
    (start ? 1 : 0) +
    (end ? 2 : 0) +
    (smooth ? 4 : 0) +
    (periodic === true ? 8 : 0) +
    (periodic === false ? 16 : 0) +
    (parameter === "centripetal" ? 32 : 0);
  out.push(SPLINE, flags, ...(start ?? [0, 0]), ...(end ?? [0, 0]));
  packPoints(out, spline.points, at("points"));
}

/**
 * @param {number[]} out
 * @param {unknown} points
 * @param {Where} where
 */
function packPoints(out, points, where) {
  if (points instanceof Float64Array) {
    if (points.length % 2 === 1) {
      bad(where, "have an even length: x0, y0, x1, y1, …");
    }
    out.push(points.length / 2);
    for (const [i, value] of points.entries()) {
      out.push(finite(value, () => `${where()}[${i}]`));
    }
  } else if (Array.isArray(points)) {
    out.push(points.length);
    for (const [i, value] of points.entries()) {
      const [x, y] = point(value, () => `${where()}[${i}]`);
      out.push(x, y);
    }
  } else {
    bad(where, "be an array of points or a Float64Array");
  }
}

/**
 * @param {unknown} value
 * @param {Where} where
 */
function tangent(value, where) {
  const [x, y] = point(value, where);
  return x === 0 && y === 0 ? bad(where, "have a length") : [x, y];
}
