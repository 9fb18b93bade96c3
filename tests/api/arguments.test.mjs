// Every wrong argument is refused with a code, and with the path of what is wrong.
import { test } from "node:test";

import {
  check,
  compensate,
  flatten,
  left,
  parseProgram,
  part,
  program,
  throwsCode,
} from "./sample.mjs";

const withSegment = (segment) => ({ start: [0, 0], segments: [...part.segments, segment] });
const line = { kind: "line", to: [1, 1] };
const arc = { kind: "arc", to: [1, 1], center: [0, 1], clockwise: true };
const spline = { kind: "spline", points: part.segments[2].points };
const sparse = [[1, 1]];
sparse[2] = [3, 3];

test("contours", () => {
  for (const [contour, path] of [
    [undefined, "contour"],
    ["line", "contour"],
    [new Float32Array(4), "contour"],
    [{ ...part, start: undefined }, "start"],
    [{ ...part, start: [0, 0, 0] }, "start"],
    [{ ...part, start: [0, "0"] }, "start[1]"],
    [{ ...part, start: [Number.NaN, 0] }, "start[0]"],
    [{ ...part, segments: undefined }, "segments"],
    [{ ...part, closed: 1 }, "closed"],
    [{ ...part, side: "inside" }, "side"],
    [{ ...part, radius: Number.POSITIVE_INFINITY }, "radius"],
    [{ ...part, leadIn: [0] }, "leadIn"],
    [{ ...part, leadOut: null }, "leadOut"],
    [{ ...part, tolerance: 1 }, "tolerance"],
    [[part, { ...part, start: [0, Number.NaN] }], "[1].start[1]"],
    [[part, null], "[1]"],
  ]) {
    throwsCode(() => compensate(contour, left), "bad-argument", path);
    throwsCode(() => flatten(contour), "bad-argument", path);
  }
});

test("segments", () => {
  for (const [segment, path] of [
    [null, ""],
    [5, ""],
    [{}, ".kind"],
    [{ kind: "circle" }, ".kind"],
    [{ ...line, to: undefined }, ".to"],
    [{ ...line, to: [Number.NaN, 0] }, ".to[0]"],
    [{ ...line, to: [0, Number.NEGATIVE_INFINITY] }, ".to[1]"],
    [{ ...line, center: [0, 0] }, ".center"],
    [{ ...arc, center: undefined }, ".center"],
    [{ ...arc, clockwise: "yes" }, ".clockwise"],
    [{ ...arc, radius: 5 }, ".radius"],
    [{ ...spline, points: undefined }, ".points"],
    [{ ...spline, points: [[0, 0], [1]] }, ".points[1]"],
    [
      {
        ...spline,
        points: [
          [0, 0],
          [1, "1"],
        ],
      },
      ".points[1][1]",
    ],
    [{ ...spline, points: sparse }, ".points[1]"],
    [{ ...spline, points: new Float64Array(3) }, ".points"],
    [{ ...spline, points: Float64Array.of(0, Number.NaN) }, ".points[1]"],
    [{ ...spline, startTangent: [0, 0] }, ".startTangent"],
    [{ ...spline, endTangent: [0] }, ".endTangent"],
    [{ ...spline, smooth: 1 }, ".smooth"],
    [{ ...spline, periodic: 0 }, ".periodic"],
    [{ ...spline, parameter: "uniform" }, ".parameter"],
    [{ ...spline, tension: 1 }, ".tension"],
  ]) {
    throwsCode(() => compensate(withSegment(segment), left), "bad-argument", `segments[3]${path}`);
  }
  const involute = { kind: "involute", to: [1, 1], center: [0, 0], baseRadius: 1, clockwise: true };
  for (const [segment, path] of [
    [{ ...involute, to: [1] }, ".to"],
    [{ ...involute, center: undefined }, ".center"],
    [{ ...involute, baseRadius: "1" }, ".baseRadius"],
    [{ ...involute, clockwise: 1 }, ".clockwise"],
    [{ ...involute, radius: 1 }, ".radius"],
  ]) {
    throwsCode(() => compensate(withSegment(segment), left), "bad-argument", `segments[3]${path}`);
  }
});

test("records", () => {
  for (const [records, path] of [
    [[1, 2, 3], "[0]"],
    [[0, 0, 0, 2], "[3]"],
    [[0, 0, 0, 0, 1, 2], "[6]"],
    [[0, 0, 0, 0, 1, Number.NaN, 0], "[5]"],
    [[0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 9e9, 1], "[10]"],
    [[0, 0, 0, 0, 10], "[4]"],
  ]) {
    throwsCode(() => compensate(Float64Array.from(records), left), "bad-argument", path);
  }
});

test("options for contours", () => {
  for (const [options, path] of [
    [null, "options"],
    [undefined, "options.side"],
    [{ radius: 3 }, "options.side"],
    [{ side: "left" }, "options.radius"],
    [{ ...left, side: "Left" }, "options.side"],
    [{ ...left, radius: "3" }, "options.radius"],
    [{ ...left, radius: Number.NaN }, "options.radius"],
    [{ ...left, radius: 2e9 }, "options.radius"],
    [{ ...left, tolerance: 0 }, "options.tolerance"],
    [{ ...left, tolerance: -1 }, "options.tolerance"],
    [{ ...left, tolerance: 9e-10 }, "options.tolerance"],
    [{ ...left, tolerance: Number.POSITIVE_INFINITY }, "options.tolerance"],
    [{ ...left, spline: "fast" }, "options.spline"],
    [{ ...left, corner: "round" }, "options.corner"],
    [{ ...left, lead: "arc" }, "options.lead"],
    [{ ...left, gouge: "ignore" }, "options.gouge"],
    [{ ...left, tangentBand: -0.1 }, "options.tangentBand"],
    [{ ...left, tangentBand: 4 }, "options.tangentBand"],
    [{ ...left, tangentBand: "wide" }, "options.tangentBand"],
    [{ ...left, profile: "iso" }, "options.profile"],
    [{ ...left, passes: 0 }, "options.passes"],
    [{ ...left, passes: 1.5 }, "options.passes"],
    [{ ...left, passes: 1e7 }, "options.passes"],
    [{ ...left, passes: "many" }, "options.passes"],
    [{ ...left, stepover: 0 }, "options.stepover"],
    [{ ...left, stepover: "1" }, "options.stepover"],
    [{ ...left, gouge: "avoid", passes: 2 }, "options.stepover"],
    [{ ...left, passes: 2, stepover: 1 }, "options.gouge"],
    [{ ...left, gouge: "stop", passes: "all", stepover: 1 }, "options.gouge"],
    [{ ...left, tools: {} }, "options.tools"],
    [{ ...left, Radius: 3 }, "options.Radius"],
  ]) {
    throwsCode(() => compensate(part, options), "bad-argument", path);
  }
});

test("options for programs", () => {
  const read = parseProgram(program);
  for (const [options, path] of [
    [{ side: "left" }, "options.side"],
    [{ tools: 3 }, "options.tools"],
    // None of whose keys would be seen.
    [{ tools: new Map([[1, { radius: 3 }]]) }, "options.tools"],
    [{ tools: [{ radius: 3 }] }, "options.tools"],
    [new Map([["radius", 3]]), "options"],
    [{ tools: { 1: 3 } }, "options.tools[1]"],
    [{ tools: { one: { radius: 3 } } }, "options.tools[one]"],
    [{ tools: { 1: { radius: Number.NaN } } }, "options.tools[1].radius"],
    [{ tools: { 1: { width: 6 } } }, "options.tools[1].width"],
    [{ tools: { 1: { diameter: "6" } } }, "options.tools[1].diameter"],
    [{ tools: { 1: { diameter: 6, radius: 3 } } }, "options.tools[1]"],
    [{ tools: { 1: { diameter: 6, orientation: 10 } } }, "options.tools[1].orientation"],
    [{ tools: { 1: { radius: 6, orientation: 1.5 } } }, "options.tools[1].orientation"],
    [{ radius: "3" }, "options.radius"],
  ]) {
    throwsCode(() => compensate(read, options), "bad-argument", path);
  }
  throwsCode(() => parseProgram(5), "bad-argument", "text");
  throwsCode(() => parseProgram("", { Dialect: "auto" }), "bad-argument", "options.Dialect");
  throwsCode(() => parseProgram("", { dialect: 1 }), "bad-argument", "options.dialect");
  const finest = { curveTolerance: 0 };
  throwsCode(() => parseProgram("", finest), "bad-argument", "options.curveTolerance");
  const spaced = { splineParameter: "uniform" };
  throwsCode(() => parseProgram("", spaced), "bad-argument", "options.splineParameter");
});

test("options and path of the judge", () => {
  const path = compensate(part, left);
  const read = parseProgram(program);
  for (const [what, options, place] of [
    [part, undefined, "options.radius"],
    [part, null, "options"],
    [part, { radius: "3" }, "options.radius"],
    [part, { radius: 3, tolerance: 0 }, "options.tolerance"],
    [part, { radius: 3, tolerance: 9e-7 }, "options.tolerance"],
    [part, { radius: 3, side: "left" }, "options.side"],
    [part, { radius: 3, tools: {} }, "options.tools"],
    [
      [
        { ...part, radius: 3 },
        { ...part, radius: 4 },
      ],
      {},
      "options.radius",
    ],
    [[{ ...part, radius: 3 }, part], {}, "options.radius"],
    [{ ...part, start: [0] }, { radius: 3 }, "start"],
    [read, { side: "left" }, "options.side"],
    [read, { tools: { 1: 3 } }, "options.tools[1]"],
    [read, { tolerance: "fine" }, "options.tolerance"],
  ]) {
    throwsCode(() => check(what, path, options), "bad-argument", place);
  }
  for (const wrong of [undefined, read, path.moves, path.records()]) {
    throwsCode(() => check(part, wrong, { radius: 3 }), "bad-argument", "path");
  }
});

test("names that no option has", () => {
  for (const option of [{ lead: "fast" }, { corner: "round" }, { lead: "intersection " }]) {
    const path = `options.${Object.keys(option)[0]}`;
    throwsCode(() => compensate(part, { ...left, ...option }), "bad-argument", path);
  }
  throwsCode(() => parseProgram("", { dialect: "basic" }), "bad-argument", "options.dialect");
  throwsCode(() => parseProgram("", { blockDelete: 1 }), "bad-argument", "options.blockDelete");
  throwsCode(() => parseProgram("", { profile: "iso" }), "bad-argument", "options.profile");
});

test("arguments of methods", () => {
  const path = compensate(part, left);
  throwsCode(() => path.polyline(0), "bad-argument", "tolerance");
  throwsCode(() => path.polylines("fine"), "bad-argument", "tolerance");
  throwsCode(() => flatten(part, Number.NaN), "bad-argument", "tolerance");
  throwsCode(() => flatten(part, 9e-7), "bad-argument", "tolerance");
  throwsCode(() => parseProgram(program).polylines(-1), "bad-argument", "tolerance");
  throwsCode(() => path.gcode({ tolerance: 0 }), "bad-argument", "options.tolerance");
  throwsCode(() => path.gcode({ feed: -5 }), "bad-argument", "options.feed");
  throwsCode(() => path.gcode({ clearance: "5" }), "bad-argument", "options.clearance");
  throwsCode(() => path.gcode({ clearance: Number.NaN }), "bad-argument", "options.clearance");
  throwsCode(() => path.gcode({ target: "fanuc" }), "bad-argument", "options.target");
  throwsCode(() => path.gcode({ splines: "nurbs" }), "bad-argument", "options.splines");
  throwsCode(() => path.gcode({ explain: 1 }), "bad-argument", "options.explain");
  throwsCode(() => path.gcode({ speed: 5 }), "bad-argument", "options.speed");
});

test("polylines that would not fit into memory are refused", () => {
  const circles = Array.from({ length: 20 }, () => ({
    start: [1e7, 0],
    segments: [{ kind: "arc", to: [1e7, 0], center: [0, 0], clockwise: true }],
  }));
  throwsCode(() => flatten(circles, 1e-6), "bad-argument", "tolerance");
});
