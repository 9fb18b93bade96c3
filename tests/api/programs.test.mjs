// Reading, compensating and writing programs.
import assert from "node:assert/strict";
import { test } from "node:test";

import { compensate, parseProgram, part, program } from "./sample.mjs";

const tools = { tools: { 1: { radius: 3 } } };

test("a program holds its contours as they could be given from code", () => {
  const read = parseProgram(program);
  assert.deepEqual(read.diagnostics, []);
  assert.equal(read.contours.length, 1);
  const [contour] = read.contours;
  const { start, segments, closed, side, tool, leadIn, leadOut, blocks } = contour;
  assert.deepEqual(
    [start, closed, side, tool, leadIn, leadOut, blocks],
    [[0, 0], false, "left", 1, [-20, 0], [-20, 22], [3, 9]],
  );
  const plain = segments.map(({ origin: _, ...segment }) => segment);
  assert.deepEqual(plain, part.segments);
  assert.deepEqual(segments[0].origin.block, 4);
  assert.deepEqual(segments[0].origin.number, 40);
});

test("a program tells the language in which it was read", () => {
  for (const [text, options, dialect] of [
    ["G0 X5\nM30\n", {}, "auto"],
    ["o<a> sub\no<a> endsub\n", {}, "linuxcnc"],
    ["%\nO1234\nM30\n", {}, "fanuc"],
    ["R1=5\nG0 X=R1\n", {}, "sinumerik"],
    ["R1=5\nG0 X=R1\n", { dialect: "fanuc" }, "fanuc"],
    ["G0 X5\nM30\n", { profile: "sinumerik" }, "sinumerik"],
    ["%\nO1234\nM30\n", { profile: "linuxcnc" }, "linuxcnc"],
  ]) {
    assert.equal(parseProgram(text, options).dialect, dialect, text);
  }
});

test("a programmed contour is compensated from code as in its program", () => {
  const read = parseProgram(program);
  const whole = compensate(read, tools);
  const alone = compensate(read.contours[0], { radius: 3 });
  const ends = (path) =>
    path.moves.filter(({ role }) => role !== "free").map(({ kind, role, to }) => [kind, role, to]);
  assert.deepEqual(ends(alone), ends(whole));
});

test("spline blocks are contours as they could be given from code", () => {
  const text = `G0 X-20 Y0
G41 D1 G1 X0 F600
G5 I10 J0 P-10 Q0 X30 Y10
G5.2 P1 L3
X40 Y10 P0.5
X50 Y25
G5.3
G40 G1 X80`;
  const read = parseProgram(text);
  assert.deepEqual(
    read.diagnostics.map(({ code, severity }) => [code, severity]),
    [["approximated", "info"]],
  );
  const [{ segments }] = read.contours;
  assert.deepEqual(segments[0].controls, [
    [10, 0],
    [20, 10],
    [30, 10],
  ]);
  assert.equal(segments[1].kind, "bezier");
  const finer = parseProgram(text, { curveTolerance: 1e-6 });
  assert.ok(finer.contours[0].segments[1].controls.length > segments[1].controls.length);
  // Numbers of a report have 15 digits, of which a spline is made anew.
  const ends = (path) =>
    path.moves
      .filter((move) => move.role !== "free")
      .map(({ to }) => to.map((value) => value.toFixed(9)).join(" "));
  const alone = compensate(read.contours[0], { radius: 3 });
  assert.deepEqual(ends(alone), ends(compensate(read, tools)));
  const through = "G0 X0 Y0\nG05 X1 Y0 F600\nX10 Y6\nX12 Y0\n";
  const moves = (options) => compensate(parseProgram(through, options), tools).records();
  assert.deepEqual(moves({ splineParameter: "chord" }), moves());
  assert.notDeepEqual(moves({ splineParameter: "centripetal" }), moves());
});

test("a program is compensated again with another tool, without reading it again", () => {
  const read = parseProgram(program);
  const first = compensate(read, tools).records();
  assert.notDeepEqual(compensate(read, { radius: 2 }).records(), first);
  assert.deepEqual(compensate(read, { radius: 3 }).records(), first);
  assert.deepEqual(compensate(read, { radius: 2, ...tools }).records(), first, "tools win");
});

test("moves of a program carry blocks, feeds in mm/min, and free moves", () => {
  const { moves } = compensate(parseProgram(program), tools);
  assert.equal(moves[0].kind, "rapid");
  assert.equal(moves[0].role, "free");
  const cut = moves.find(({ role }) => role === "segment");
  assert.equal(cut.feed, 300);
  assert.deepEqual([cut.origin.block, cut.origin.number], [4, 40]);
});

test("a profile is that of reading unless another is named, and an option wins over it", () => {
  const text = "G21 G0 X0 Y0 F100\nG41 D1 G1 X20\nY20\nX0\nG40 X-20\nM2\n";
  const kinds = (path) => path.moves.map(({ kind, role }) => `${kind} ${role}`);
  const linuxcnc = ["arc transition", "arc transition"];
  const read = parseProgram(text, { profile: "linuxcnc" });
  const inserted = (options) =>
    kinds(compensate(read, { ...tools, ...options })).filter((kind) => kind.endsWith("transition"));
  assert.deepEqual(inserted({}), []);
  assert.deepEqual(inserted({ profile: "g41" }), []);
  const right = parseProgram(text.replace("G41", "G42"), { profile: "linuxcnc" });
  const round = (options) =>
    kinds(compensate(right, { ...tools, ...options })).filter((kind) =>
      kind.endsWith("transition"),
    );
  assert.deepEqual(round({}), linuxcnc);
  assert.deepEqual(round({ profile: "linuxcnc" }), linuxcnc);
  assert.ok(!round({ corner: "linear" }).includes("arc transition"));
});

test("moves in other planes say x, y and z", () => {
  const text = "G21 G18 G0 X10 Y5 Z1 F100\nG2 X14 Z5 Y8 I4 K0\nG19 G1 Y9 Z7\nM2\n";
  const moves = compensate(parseProgram(text), { radius: 1 }).moves;
  assert.deepEqual(
    moves.map(({ plane, from, to }) => [plane, from, to]),
    [
      ["xz", [0, 0, 0], [10, 5, 1]],
      ["xz", [10, 5, 1], [14, 8, 5]],
      ["yz", [14, 8, 5], [14, 9, 7]],
    ],
  );
  assert.deepEqual([moves[1].center, moves[1].clockwise], [[14, 5, 1], true]);
});

test("what the control refuses ends the path", () => {
  const text = "G21 G0 X0 Y0 F100\nG41 D1 G1 X20\nX40\nG42 D1\nX60\nM2\n";
  const path = compensate(parseProgram(text, { profile: "linuxcnc" }), tools);
  const refused = path.diagnostics.filter(({ code }) => code === "refused");
  assert.deepEqual(
    refused.map(({ severity, origin }) => [severity, origin.block]),
    [["error", 4]],
  );
  assert.deepEqual(path.moves.at(-1)?.to, [20, 3, 0]);
});

test("a tool without radius is a diagnostic", () => {
  const path = compensate(parseProgram(program));
  assert.ok(path.diagnostics.some(({ code }) => code === "missing-radius"));
});

test("what was not understood is a diagnostic with block and column, and comes with the path", () => {
  const read = parseProgram("G21\nG1 X10 ?? F100\n");
  const [found] = read.diagnostics;
  assert.equal(found.severity, "error");
  assert.deepEqual(found.origin, { block: 2, column: 8 });
  assert.deepEqual(compensate(read).diagnostics.slice(0, 1), [found]);
});

test("the programmed contours are drawn as they are understood", () => {
  const { points, starts, owners } = parseProgram(program).polylines(0.1);
  assert.deepEqual([...starts], [0]);
  assert.deepEqual([...points.slice(0, 4)], [0, 0, 10, 0]);
  assert.deepEqual([...new Set(owners)], [0, 1, 2]);
});

test("the path is written as plain code, in which nothing is left to compensate", () => {
  const path = compensate(parseProgram(program), tools);
  const code = path.gcode();
  assert.doesNotMatch(code, /G4[12]|G0?5|D1/);
  assert.match(code, /F300/);
  assert.match(code, /M30/);
  const again = parseProgram(code);
  assert.deepEqual(again.diagnostics, []);
  assert.equal(path.emit().text, code);
  assert.deepEqual(path.emit().diagnostics, []);
});

test("a missing feed is said, or given", () => {
  const path = compensate(part, { side: "left", radius: 3 });
  assert.ok(path.emit().diagnostics.some(({ code }) => code === "no-feed"));
  const { text, diagnostics } = path.emit({ feed: 600, target: "grbl" });
  assert.match(text, /F600/);
  assert.deepEqual(diagnostics, []);
});

test("a coarser tolerance writes fewer blocks", () => {
  const path = compensate(parseProgram(program), tools);
  const lines = (tolerance) => path.gcode({ tolerance }).split("\n").length;
  assert.ok(lines(0.1) < lines(0.0001));
});

test("noise is read to its end", () => {
  let state = 1;
  const letters = Array.from({ length: 200_000 }, () => {
    state = (state * 48271) % 2147483647;
    return String.fromCharCode(10 + (state % 118));
  });
  const read = parseProgram(letters.join(""));
  assert.ok(read.diagnostics.length > 0);
  assert.ok(compensate(read, { radius: 3 }).diagnostics.length > 0);
});
