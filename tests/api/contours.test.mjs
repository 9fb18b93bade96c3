// Compensating contours given from code.
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  check,
  compensate,
  distance,
  flatten,
  LiveContour,
  left,
  parseProgram,
  part,
  RECORD_STRIDE,
  throwsCode,
} from "./sample.mjs";

const square = {
  start: [0, 0],
  segments: [
    { kind: "line", to: [20, 0] },
    { kind: "line", to: [20, 20] },
    { kind: "line", to: [0, 20] },
    { kind: "line", to: [0, 0] },
  ],
  closed: true,
};

test("the inside of a square is a smaller square", () => {
  const path = compensate(square, left);
  assert.deepEqual(
    path.moves.map(({ kind, to }) => [kind, ...to]),
    [
      ["line", 17, 3, 0],
      ["line", 17, 17, 0],
      ["line", 3, 17, 0],
      ["line", 3, 3, 0],
    ],
  );
  assert.deepEqual([...path.polyline()], [3, 3, 17, 3, 17, 17, 3, 17, 3, 3]);
  assert.deepEqual(path.diagnostics, []);
  assert.deepEqual(path.gouges, []);
  assert.deepEqual(
    path.transitions.map(({ kind, angle, corner, origin }) => [kind, angle, corner, origin]),
    [
      ["shortened", 4.712388980385, [20, 0], { segment: 1 }],
      ["shortened", 4.712388980385, [20, 20], { segment: 2 }],
      ["shortened", 4.712388980385, [0, 20], { segment: 3 }],
      ["shortened", 4.712388980385, [0, 0], { segment: 0 }],
    ],
  );
  assert.deepEqual(path.transitions[0].construction.V, [17, 3]);
});

test("moves carry kind, ends, role and origin", () => {
  const path = compensate(part, left);
  const [line, arc] = path.moves;
  assert.deepEqual(line, {
    kind: "line",
    plane: "xy",
    from: [0, 3, 0],
    to: [10, 3, 0],
    role: "segment",
    origin: { segment: 0 },
  });
  assert.deepEqual(arc, {
    kind: "arc",
    plane: "xy",
    from: [10, 3, 0],
    to: [17, 10, 0],
    center: [10, 10, 0],
    clockwise: false,
    radius: 7,
    role: "segment",
    origin: { segment: 1 },
  });
  const cubics = path.moves.filter((move) => move.kind === "cubic");
  assert.ok(cubics.length > 0, "a spline gives cubics");
  assert.ok(cubics.every((move) => move.control1.length === 3 && move.control2.length === 3));
  assert.equal(path.moves, path.moves, "unpacked once");
});

test("records hold the moves as numbers", () => {
  const path = compensate(part, left);
  const records = path.records();
  assert.equal(records.length, path.moves.length * RECORD_STRIDE);
  const nan = Number.NaN;
  assert.deepEqual(
    [...records.subarray(RECORD_STRIDE, 2 * RECORD_STRIDE)],
    [2, 0, 0, nan, nan, nan, nan, nan, 1, 10, 3, 0, 17, 10, 0, 10, 10, 7, 0],
  );
});

test("records of a contour give the same path as objects", () => {
  const spline = {
    kind: "spline",
    points: Float64Array.of(22, 14, 18, 20, 10, 22),
    startTangent: [0, 2],
    endTangent: [-1, 0],
    smooth: true,
    parameter: "centripetal",
  };
  const objects = { ...part, leadIn: [-9, 0], leadOut: [-9, 22], side: "right", radius: 2 };
  objects.segments = [...part.segments.slice(0, 2), spline];
  const records = Float64Array.of(
    ...[0, 0, 0, 0, 6, 1, 7, 2, 4, -9, 0, 5, -9, 22, 1, 10, 0, 2, 20, 10, 10, 10, 0],
    ...[3, 1 + 2 + 4 + 32, 0, 2, -1, 0, 3, 22, 14, 18, 20, 10, 22],
  );
  const path = compensate(objects);
  assert.deepEqual(compensate(records).records(), path.records());
  assert.equal(path.moves[0].role, "lead-in");
  assert.equal(path.moves.at(-1).role, "lead-out");
});

test("Bézier curves are segments, one for each stretch without a corner", () => {
  const controls = [
    ...[
      [10, 0],
      [20, 0],
      [30, 0],
    ],
    ...[
      [40, 0],
      [50, 10],
      [50, 20],
    ],
    ...[
      [60, 20],
      [70, 20],
      [80, 20],
    ],
  ];
  const contour = { start: [0, 0], segments: [{ kind: "bezier", controls }] };
  const path = compensate(contour, left);
  assert.deepEqual(path.diagnostics, []);
  assert.equal(path.transitions.length, 1, "the corner at the third");
  assert.deepEqual(path.transitions[0].corner, [50, 20]);
  const flat = { kind: "bezier", controls: Float64Array.from(controls.flat()) };
  const same = compensate({ start: [0, 0], segments: [flat] }, left);
  assert.deepEqual(same.records(), path.records());
  const records = Float64Array.of(0, 0, 0, 0, 8, 9, ...controls.flat());
  assert.deepEqual(compensate(records, left).records(), path.records());
  const short = { kind: "bezier", controls: controls.slice(0, 2) };
  const { diagnostics } = compensate({ start: [0, 0], segments: [short] }, left);
  assert.equal(diagnostics[0].code, "too-few-points");
});

test("what the options say wins over what the contour says", () => {
  const contour = { ...square, side: "right", radius: 1 };
  assert.deepEqual(compensate(contour, left).records(), compensate(square, left).records());
  assert.notDeepEqual(compensate(contour).records(), compensate(square, left).records());
});

test("several contours give one path, whose origins tell them apart", () => {
  const far = {
    start: [50, 0],
    segments: [
      { kind: "line", to: [60, 0] },
      { kind: "line", to: [60, 9] },
    ],
  };
  const path = compensate([square, far], left);
  assert.deepEqual(
    path.moves.map((move) => move.origin),
    [
      ...[0, 1, 2, 3].map((segment) => ({ segment, contour: 0 })),
      ...[0, 1].map((segment) => ({ segment, contour: 1 })),
    ],
  );
  const { points, points3, starts, owners } = path.polylines();
  assert.deepEqual([...starts], [0, 5]);
  assert.deepEqual([...owners], [0, 0, 1, 2, 3, 4, 4, 5]);
  assert.deepEqual([points.length, points3.length], [16, 24]);
  assert.throws(() => path.polyline(), { code: "several-pieces" });
});

test("polylines keep within their tolerance", () => {
  const path = compensate(part, left);
  const lengths = [1, 0.1, 0.01].map((tolerance) => path.polyline(tolerance).length);
  assert.ok(lengths[0] < lengths[1] && lengths[1] < lengths[2], `${lengths}`);
  const { points, owners } = path.polylines(0.01);
  for (let i = 2; i < owners.length; i++) {
    if (owners[i] === 1 && owners[i - 1] === 1) {
      const [a, b] = [points.subarray(2 * i - 2, 2 * i), points.subarray(2 * i, 2 * i + 2)];
      const middle = distance([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], [10, 10]);
      assert.ok(middle <= 7 && middle > 7 - 0.01, `the arc's chord is at ${middle}`);
    }
  }
});

test("flattened contours pass through their type points, segment by segment", () => {
  const { points, starts, owners, diagnostics } = flatten([square, part], 0.01);
  assert.deepEqual(diagnostics, []);
  assert.deepEqual([...starts], [0, 5]);
  assert.deepEqual([...new Set(owners)], [0, 1, 2, 3, 4, 5, 6]);
  for (const point of part.segments[2].points) {
    const on = owners.some((_, i) => points[2 * i] === point[0] && points[2 * i + 1] === point[1]);
    assert.ok(on, `${point}`);
  }
});

test("a contour that cannot be made is reported and leaves its piece empty", () => {
  const nothing = { start: [5, 5], segments: [] };
  const { starts, diagnostics } = flatten([nothing, square]);
  assert.deepEqual([...starts], [0, 0]);
  assert.deepEqual(
    diagnostics.map(({ severity, code, at }) => [severity, code, at]),
    [["error", "empty-contour", [5, 5]]],
  );
  const path = compensate(nothing, left);
  assert.deepEqual([path.moves, path.polyline().length], [[], 0]);
  assert.equal(path.diagnostics[0].code, "empty-contour");
});

test("wrong geometry is a diagnostic with its place, never an exception", () => {
  const far = [1e10, 0];
  const contour = {
    start: [0, 0],
    segments: [
      { kind: "line", to: [0, 0] },
      { kind: "arc", to: [10, 0], center: [2, 0], clockwise: true },
      { kind: "line", to: far },
      { kind: "spline", points: [[12, 0]] },
      {
        kind: "spline",
        points: [
          [14, 2],
          [14, 2],
          [16, 0],
        ],
      },
      { kind: "spline", points: [] },
    ],
    closed: true,
  };
  const { diagnostics } = compensate(contour, left);
  const found = diagnostics.map(({ code, origin }) => `${code} ${origin?.segment}`);
  for (const expected of [
    "zero-length 0",
    "radii-disagree 1",
    "out-of-range 2",
    "too-few-points 3",
    "coincident-points 4",
    "too-few-points 5",
    "not-closed 4",
  ]) {
    assert.ok(found.includes(expected), `${expected} in ${found}`);
  }
});

test("a tool that does not fit is reported with depth and place", () => {
  const bend = {
    start: [0, 0],
    segments: [{ kind: "arc", to: [10, 0], center: [5, 0], clockwise: false }],
  };
  const path = compensate(bend, { side: "left", radius: 8 });
  assert.equal(path.gouges[0].kind, "curvature");
  assert.ok(path.gouges[0].depth > 0);
  assert.ok(path.diagnostics.some(({ depth, origin }) => depth > 0 && origin.segment === 0));
});

test("the path is drawn as SVG, full circles and both senses included", () => {
  const circle = (clockwise) => ({
    start: [10, 0],
    segments: [{ kind: "arc", to: [10, 0], center: [0, 0], clockwise }],
    closed: true,
  });
  const inside = compensate(circle(false), left).svg();
  assert.match(inside, /^M7 0A7 7 0 0 1 -7 \S+A7 7 0 0 1 7 0$/);
  const outside = compensate(circle(true), left).svg();
  assert.match(outside, /^M13 0A13 13 0 0 0 -13 \S+A13 13 0 0 0 13 0$/);
  assert.equal(compensate(square, left).svg(), "M3 3L17 3L17 17L3 17L3 3");
  assert.throws(() => compensate(square, left).toPath2D(), { code: "not-supported" });
});

test("the same calls draw on a Path2D", () => {
  const calls = [];
  globalThis.Path2D = class {
    moveTo(...args) {
      calls.push(["moveTo", ...args]);
    }
    lineTo(...args) {
      calls.push(["lineTo", ...args]);
    }
    arc(...args) {
      calls.push(["arc", ...args]);
    }
    bezierCurveTo(...args) {
      calls.push(["bezierCurveTo", ...args]);
    }
  };
  try {
    assert.ok(compensate(part, left).toPath2D() instanceof Path2D);
  } finally {
    delete globalThis.Path2D;
  }
  assert.deepEqual(calls.slice(0, 2), [
    ["moveTo", 0, 3],
    ["lineTo", 10, 3],
  ]);
  assert.deepEqual(calls[2], ["arc", 10, 10, 7, -Math.PI / 2, 0, false]);
  assert.ok(calls.some(([name]) => name === "bezierCurveTo"));
});

test("a tolerance of a millionth of a micrometre is kept", () => {
  const circle = (count) =>
    Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * (i + 1)) / count;
      return [40 * Math.cos(angle), 40 * Math.sin(angle)];
    });
  const ring = {
    start: [40, 0],
    segments: [{ kind: "spline", points: circle(24) }],
    closed: true,
  };
  const on = compensate(ring, { side: "left", radius: 0 }).moves;
  const path = compensate(ring, { side: "right", radius: 5, tolerance: 1e-9 });
  assert.ok(path.moves.length > 24, "more pieces than spans");
  // Each piece of the path begins on a normal of the spline, at the radius from it.
  const point = ({ from, to, control1, control2 }, t) =>
    [0, 1].map(
      (k) =>
        (1 - t) ** 3 * from[k] +
        3 * (1 - t) ** 2 * t * control1[k] +
        3 * (1 - t) * t * t * control2[k] +
        t ** 3 * to[k],
    );
  const nearest = (p, piece) => {
    let [low, high] = [0, 1];
    const away = (t) => distance(point(piece, t), p);
    for (let k = 0; k < 90; k++) {
      const [a, b] = [low + (high - low) / 3, high - (high - low) / 3];
      if (away(a) < away(b)) {
        high = b;
      } else {
        low = a;
      }
    }
    return away((low + high) / 2);
  };
  for (const move of path.moves) {
    for (const t of [0, 0.25, 0.5, 0.75]) {
      const least = Math.min(...on.map((piece) => nearest(point(move, t), piece)));
      assert.ok(Math.abs(least - 5) <= 1.01e-9, `${least - 5} mm off`);
    }
  }
});

test("a path may be of arcs and lines alone, as near to the spline as one of cubics", () => {
  const spline = {
    start: [0, 0],
    segments: [
      {
        kind: "spline",
        points: [
          [20, 8],
          [40, 0],
          [60, 9],
        ],
      },
    ],
  };
  const options = { side: "left", radius: 3, tolerance: 0.01 };
  const cubics = compensate(spline, options);
  const arcs = compensate(spline, { ...options, output: "arcs" });
  assert.ok(cubics.moves.every((move) => move.kind === "cubic"));
  assert.ok(arcs.moves.every((move) => move.kind === "arc" || move.kind === "line"));
  assert.ok(arcs.moves.length >= cubics.moves.length, `${arcs.moves.length} arcs`);
  assert.deepEqual(check(spline, arcs, { radius: 3, tolerance: 0.011 }), []);
  throwsCode(
    () => compensate(spline, { ...options, output: "lines" }),
    "bad-argument",
    "options.output",
  );
});

test("a lead-in as LinuxCNC makes it ends beside its own end", () => {
  const angle = {
    start: [10, 0],
    leadIn: [0, 0],
    leadOut: [40, 40],
    segments: [
      { kind: "line", to: [20, -10] },
      { kind: "line", to: [40, -10] },
    ],
  };
  const moves = (options) => compensate(angle, { side: "left", radius: 2, ...options }).moves;
  const [leadIn, around] = moves({ profile: "linuxcnc" });
  assert.deepEqual([leadIn?.role, leadIn?.to], ["lead-in", [10, 2, 0]]);
  assert.deepEqual([around?.kind, around?.role], ["arc", "transition"]);
  const live = new LiveContour(angle, { side: "left", radius: 2, profile: "linuxcnc" });
  assert.deepEqual([...live.update().points.slice(0, 4)], [0, 0, 10, 2]);
});

test("involutes come back as involutes of the same circle", () => {
  // A thread that comes off a circle of 10 mm: where it ends after so many radians.
  const at = (roll) => [
    10 * (Math.cos(roll) + roll * Math.sin(roll)),
    10 * (Math.sin(roll) - roll * Math.cos(roll)),
  ];
  const involute = {
    ...{ kind: "involute", to: at(1.2), center: [0, 0], baseRadius: 10, clockwise: false },
  };
  const contour = { start: at(0.5), segments: [involute] };
  const path = compensate(contour, { side: "right", radius: 2 });
  assert.deepEqual(path.diagnostics, []);
  const [move] = path.moves;
  assert.equal(path.moves.length, 1);
  assert.equal(move.kind, "involute");
  assert.deepEqual(move.center.map(Math.round), [0, 0, 0]);
  assert.ok(Math.abs(move.baseRadius - 10) < 1e-9, `${move.baseRadius}`);
  assert.equal(move.clockwise, false);
  // Its thread is longer by the radius.
  const thread = ([x, y]) => Math.sqrt(x * x + y * y - 100);
  assert.ok(Math.abs(thread(move.from) - 7) < 1e-9, "at the start");
  assert.ok(Math.abs(thread(move.to) - 14) < 1e-9, "at the end");
  const records = Float64Array.of(0, ...at(0.5), 0, 9, ...at(1.2), 0, 0, 10, 0);
  const same = compensate(records, { side: "right", radius: 2 });
  assert.deepEqual(same.records(), path.records());
  // Drawn by cubics that end where it does, and by chords near it.
  const [data] = /C[^C]*$/.exec(path.svg()) ?? [""];
  assert.ok(data.includes(`${move.to[0]} ${move.to[1]}`), data);
  for (let i = 0, { points } = path.polylines(1e-4); i < points.length; i += 2) {
    const [x, y] = [points[i], points[i + 1]];
    const roll = Math.sqrt(x * x + y * y - 100) / 10;
    const off = 10 * (Math.atan2(y, x) + Math.atan(roll) - roll) + 2;
    assert.ok(Math.abs(off) < 1e-9, `${off} mm off`);
  }
  assert.match(path.gcode({ target: "fanuc-30i", feed: 300 }), /G3\.2 X.* I.* J.* R10\./);
  assert.doesNotMatch(path.gcode({ feed: 300 }), /G3\.2/);
  const wrong = compensate(
    { ...contour, segments: [{ ...involute, to: [14, 9] }] },
    { side: "right", radius: 2 },
  );
  assert.deepEqual(
    wrong.diagnostics.map(({ code }) => code),
    ["off-involute"],
  );
  const text = "G0 X11.173 Y.407\nG3.2 X13.818 Y3.012 I-11.173 J-.407 R10 F300\n";
  const program = parseProgram(`G41 D1\nG1 X0 Y0\n${text.replace("G0", "G1")}G40 X0\n`);
  assert.equal(program.contours[0].segments.at(-1).kind, "involute");
  assert.equal(program.contours[0].segments.at(-1).baseRadius.toFixed(2), "10.00");
});
