// Gouges: reported, avoided or refused, judged independently, and what is left uncut.
import assert from "node:assert/strict";
import { test } from "node:test";

import { check, compensate, distance, parseProgram, throwsCode } from "./sample.mjs";

/** A wall along x with a round groove of radius 4 mm, and a tool above it that does not fit in. */
const groove = {
  start: [0, 0],
  segments: [
    { kind: "line", to: [16, 0] },
    { kind: "arc", to: [24, 0], center: [20, 0], clockwise: false },
    { kind: "line", to: [40, 0] },
  ],
};
const tool = { side: "left", radius: 5 };

/** The same wall in a program, with a tool that sinks along it, then a wall without a groove. */
const program = `G0 X-10 Y10 Z5
Z-1
G1 G41 D1 X0 Y0 F300
X16
G3 X24 Y0 I4 J0
G1 X40
G40 Y20
G0 Z5
X-10 Y40
Z-1
G1 G41 X0 Y30 F200
X40
G40 Y50
G0 Z5
M30
`;

/** Two rooms with a corridor 6 mm wide between them. */
const rooms = {
  start: [0, 0],
  closed: true,
  segments: [
    ...[
      [20, 0],
      [20, 7],
      [30, 7],
      [30, 0],
      [50, 0],
    ],
    ...[
      [50, 20],
      [30, 20],
      [30, 13],
      [20, 13],
      [20, 20],
      [0, 20],
      [0, 0],
    ],
  ].map((to) => ({ kind: "line", to })),
};

/** Area inside an outline, positive counter-clockwise. */
function area(outline) {
  let twice = 0;
  for (let i = 0; i < outline.length; i += 2) {
    const j = (i + 2) % outline.length;
    twice += outline[i] * outline[j + 1] - outline[j] * outline[i + 1];
  }
  return twice / 2;
}

test("a gouge is reported by default, with both the judge and the path", () => {
  const path = compensate(groove, tool);
  assert.ok(path.moves.length > 0, "the path is there");
  assert.equal(path.gouges.length, 1);
  const [gouge] = path.gouges;
  assert.equal(gouge.kind, "curvature");
  assert.deepEqual(path.uncut, [], "nothing is left out");
  const found = check(groove, path, { radius: 5 });
  assert.ok(found.length > 0, "the judge sees it too");
  const deepest = Math.max(...found.map(({ depth }) => depth));
  assert.ok(Math.abs(deepest - gouge.depth) < 1e-6, `${deepest} and ${gouge.depth}`);
  for (const { kind, at, depth, segments } of found) {
    assert.ok(["curvature", "bottleneck"].includes(kind));
    assert.ok(at.length === 2 && depth > 0.001 && segments.length > 0);
  }
});

test("avoided, the path keeps clear of the groove and tells what it does not reach", () => {
  const path = compensate(groove, { ...tool, corner: "arc", gouge: "avoid" });
  assert.deepEqual(check(groove, path, { radius: 5 }), []);
  assert.deepEqual(path.gouges, []);
  assert.equal(path.uncut.length, 1);
  const [region] = path.uncut;
  // The tool dips in until it touches both edges, 4 mm beside its centre and so 3 mm below it.
  const cap = 25 * Math.asin(4 / 5) - 4 * 3;
  const expected = 8 * Math.PI - cap;
  assert.ok(Math.abs(region.area - expected) < 0.02, `${region.area}, not ${expected} mm²`);
  assert.ok(Math.abs(Math.abs(area(region.outline)) - region.area) < 1e-9, "area of its outline");
  assert.ok(region.outline instanceof Float64Array);
  assert.ok(region.segments.some(({ segment }) => segment === 1));
  assert.equal(path.uncut, path.uncut, "unpacked once");
  const { moves, transitions, diagnostics, gouges, uncut, loops } = path;
  const outlines = uncut.map((one) => ({ ...one, outline: Array.from(one.outline) }));
  assert.deepEqual(
    JSON.parse(JSON.stringify(path)),
    { moves, transitions, diagnostics, gouges, uncut: outlines, loops },
    "all of it is written as JSON",
  );
});

test("stopped, there is no path but every reason", () => {
  const path = compensate(groove, { ...tool, gouge: "stop" });
  assert.deepEqual(path.moves, []);
  assert.equal(path.polyline().length, 0);
  assert.equal(path.gouges.length, 1);
  const { code, severity, depth, at, origin } = path.diagnostics.at(-1);
  assert.deepEqual([code, severity, depth], ["stopped", "error", path.gouges[0].depth]);
  assert.deepEqual([at, origin], [path.gouges[0].at, { segment: 1 }]);
  const fits = compensate(groove, { ...tool, radius: 3, gouge: "stop" });
  assert.deepEqual(fits.moves, compensate(groove, { ...tool, radius: 3 }).moves);
});

test("pieces of an avoided path are told apart, and it stays closed where it was", () => {
  const path = compensate(rooms, { side: "left", radius: 4, corner: "arc", gouge: "avoid" });
  assert.deepEqual(check(rooms, path, { radius: 4 }), []);
  const { points, starts } = path.polylines();
  assert.equal(starts.length, 2, "a piece for each room");
  throwsCode(() => path.polyline(), "several-pieces");
  for (const [i, start] of starts.entries()) {
    const last = (starts[i + 1] ?? points.length / 2) - 1;
    const vertex = (k) => [points[2 * k], points[2 * k + 1]];
    assert.ok(distance(vertex(start), vertex(last)) < 1e-6, `piece ${i} is closed`);
  }
  assert.ok(path.uncut.length > 0 && path.uncut.every((region) => region.area > 0));
});

test("the radius of the judge may come from the contours, and its tolerance counts", () => {
  const path = compensate(groove, { ...tool, radius: 4.5 });
  assert.ok(check({ ...groove, radius: 4.5 }, path).length > 0);
  // It passes 3.5 mm from both edges of the groove.
  assert.deepEqual(check({ ...groove, radius: 3.4 }, path), [], "a smaller tool does not cut");
  assert.ok(check({ ...groove, radius: 3.4 }, path, { radius: 4.5 }).length > 0, "options win");
  const [{ depth }] = path.gouges;
  assert.deepEqual(check(groove, path, { radius: 4.5, tolerance: depth + 0.01 }), []);
});

test("several contours are one part to the judge", () => {
  const wall = { start: [0, 8], segments: [{ kind: "line", to: [40, 8] }] };
  const line = { start: [0, 0], segments: [{ kind: "line", to: [40, 0] }] };
  const path = compensate([line, wall], tool);
  const found = check([line, wall], path, { radius: 5 });
  // The path along the first runs 3 mm beside the second, that along the second 13 mm from the first.
  assert.equal(found.length, 1);
  assert.ok(Math.abs(found[0].depth - 2) < 1e-9, String(found[0].depth));
  assert.equal(found[0].kind, "bottleneck");
  assert.deepEqual(found[0].segments, [
    { segment: 0, contour: 1 },
    { segment: 0, contour: 0 },
  ]);
});

test("in a program each stretch is avoided by itself, and its feeds and heights stay", () => {
  const read = parseProgram(program);
  const options = { tools: { 1: { radius: 5 } } };
  const reported = compensate(read, options);
  assert.ok(check(read, reported, options).length > 0);
  const path = compensate(read, { ...options, gouge: "avoid" });
  assert.deepEqual(check(read, path, options), []);
  assert.deepEqual(check(read, path), [], "a tool that nobody knows judges nothing");
  assert.equal(path.uncut.length, 1);
  assert.ok(path.uncut[0].segments.some(({ block }) => block === 5));
  const count = (moves, role) => moves.filter((move) => move.role === role).length;
  for (const role of ["lead-in", "lead-out", "free"]) {
    assert.equal(count(path.moves, role), count(reported.moves, role), role);
  }
  for (const { role, from, to, feed, origin } of path.moves) {
    if (role !== "free") {
      assert.deepEqual([from[2], to[2]], [-1, -1], "at its height");
      assert.equal(feed, origin.block < 11 ? 300 : 200, "at its feed");
    }
  }
  const stopped = compensate(read, { ...options, gouge: "stop" });
  assert.deepEqual(stopped.moves, []);
  assert.equal(stopped.diagnostics.at(-1).code, "stopped");
});

test("between pieces the tool rises to a height that is known, and else does not cross", () => {
  const path = compensate(rooms, { side: "left", radius: 4, corner: "arc", gouge: "avoid" });
  const crossed = path.emit({ feed: 300, clearance: 5 });
  assert.deepEqual(crossed.diagnostics, []);
  const blocks = crossed.text.split("\n");
  assert.deepEqual(blocks.slice(0, 5), ["G21 G90 G17 G94", "G0 Z5", "X4 Y4", "G1 Z0 F300", "X16"]);
  assert.equal(blocks.filter((block) => block === "G0 Z5").length, 2, crossed.text);
  const { text, diagnostics } = path.emit({ feed: 300 });
  assert.deepEqual(
    diagnostics.map(({ code, severity }) => [code, severity]),
    [["no-clearance", "error"]],
  );
  assert.ok(crossed.text.length > text.length && !text.includes("X46"), "the first room only");
});

test("a pocket is cleared in passes, one loop in the other", () => {
  const pocket = {
    start: [0, 0],
    closed: true,
    segments: [
      { kind: "line", to: [40, 0] },
      { kind: "line", to: [40, 40] },
      { kind: "line", to: [0, 40] },
      { kind: "line", to: [0, 0] },
    ],
  };
  const options = { side: "left", radius: 3, gouge: "avoid", stepover: 4 };
  const all = compensate(pocket, { ...options, passes: "all" });
  // 3, 7, 11, 15 and 19 mm from the walls.
  assert.deepEqual(
    all.loops.map(({ pass, parent }) => [pass, parent]),
    [
      [0, undefined],
      [1, 0],
      [2, 1],
      [3, 2],
      [4, 3],
    ],
  );
  const innermost = all.moves.slice(all.loops[4].from, all.loops[4].to);
  for (const { from } of innermost) {
    assert.ok(Math.abs(Math.abs(from[0] - 20) - 1) < 1e-9, `${from}`);
  }
  assert.equal(compensate(pocket, { ...options, passes: 2 }).loops.length, 2);
  assert.deepEqual(compensate(pocket, { ...options, passes: 1 }).loops, []);
});
