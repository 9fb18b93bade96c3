// g41 convert: what becomes of programs, with tools from every source.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { compensate, parseProgram } from "../../dist/node.js";
import { npm, root } from "../../scripts/command.mjs";
import { centres, corner, installed, pointsOf, sample } from "./command.mjs";

const programs = readdirSync(join(root, "tests/programs")).filter((name) => /\.\w+$/.test(name));

const { g41, read, home } = installed({
  "corner.ngc": corner,
  "inch.ngc": `G20\n${corner}`,
  "two.ngc": `${corner.replace("M30\n", "")}${corner.replace("D1", "D2")}`,
  // A slot of 4 mm between two walls.
  "slot.txt": "G0 X2 Y40\nG1 G41 D1 X0 Y20 F300\nY0\nX4\nY20\nG40 X2 Y40\nM30\n",
  // A square of 40 mm, with the tool inside.
  "square.ngc": "G0 X20 Y20\nG1 G41 D1 X0 Y20 F300\nY0\nX40\nY40\nX0\nY20\nG40 X20 Y20\nM30\n",
  "skipped.ngc": corner.replace("X30", "/X99\nX30"),
  "tools.tbl": "P3 T1 Z+10.5 D6.0 ;the left one\n\n; nothing here\nT2 P2 d8 Q0\nT3 P4\n",
  ...Object.fromEntries(programs.map((name) => [name, sample(name)])),
});

test("a corner becomes the path that the textbook's formulas give", async () => {
  const { code, out, err } = await g41(["convert", "corner.ngc", "--radius", "3"]);
  assert.deepEqual([code, err], [0, ""]);
  assert.deepEqual(pointsOf(out), centres(3));
  assert.doesNotMatch(out, /G4[12]/);
});

test("what a block has each time that it is run is told once, with how often", async () => {
  const lap = "G0 X-2 Y0\nG1 G41 D1 X0 F9\nY40\nG40 X-20 Y60\n";
  const input = `G0 Z5\no1 repeat [3]\n${lap}o1 endrepeat\nM2\n`;
  const { err } = await g41(["convert", "-", "--radius", "3"], { input });
  const short = err.split("\n").filter((line) => line.includes("short-lead-in"));
  assert.equal(short.length, 1, err);
  assert.match(short[0], /:4: warning: the lead-in is 2 mm long, .*\(short-lead-in\), 3 times$/);
});

test("npx runs it from an installed package", async () => {
  const args = [
    "exec",
    "--offline",
    "--",
    "g41",
    "convert",
    "corner.ngc",
    "--radius=3",
    "-o",
    "npx.nc",
  ];
  await npm(args, { cwd: home() });
  assert.deepEqual(pointsOf(read("npx.nc")), centres(3));
});

test("every program becomes what the package itself writes", async () => {
  assert.ok(programs.length >= 7, "there are programs");
  for (const name of programs) {
    const expected = compensate(parseProgram(sample(name)), { radius: 0.5 }).gcode();
    const { out } = await g41(["convert", name, "--radius", "0.5"]);
    assert.equal(out, expected, name);
    assert.doesNotMatch(out, /^[^(;]*\bG0*(4[12]|5)\b/m, name);
  }
});

test("standard input is read as a file is", async () => {
  const input = sample("cam.ngc");
  const piped = await g41(["convert", "-", "--radius", "2"], { input });
  const read = await g41(["convert", "cam.ngc", "--radius", "2"]);
  assert.deepEqual(piped, { ...read, err: read.err.replaceAll("cam.ngc:", "<stdin>:") });
});

test("a negative radius swaps the side", async () => {
  const { out } = await g41(["convert", "corner.ngc", "--radius", "-3"]);
  // On the right, that corner is inside: both offsets are cut back to where they meet.
  assert.ok(
    pointsOf(out).some(([x, y]) => x === 3 && y === 37),
    out,
  );
});

test("--tool, --tool-table and --radius each give radii, the nearest to the tool wins", async () => {
  const radii = async (...options) => {
    const { code, out, err } = await g41(["convert", "two.ngc", ...options]);
    assert.equal(code, 0, err);
    // The corner of each of the two contours is as far from it as the radius.
    return pointsOf(out)
      .filter(([x, y]) => x < 0 && y > 40)
      .map(([x]) => -x);
  };
  assert.deepEqual(await radii("--radius", "2"), [2, 2]);
  assert.deepEqual(await radii("--tool", "1=2.5", "--tool", "2=5"), [2.5, 5]);
  assert.deepEqual(await radii("--tool-table", "tools.tbl"), [3, 4]);
  assert.deepEqual(await radii("--tool-table", "tools.tbl", "--tool=2=1"), [3, 1]);
  assert.deepEqual(await radii("--tool", "2=1", "--radius", "7"), [7, 1]);
});

test("diameters of a table count in the unit in effect where compensation is switched on", async () => {
  const { out } = await g41(["convert", "inch.ngc", "--tool-table", "tools.tbl"]);
  const scaled = centres(3).map((point) => point.map((value) => Number((25.4 * value).toFixed(4))));
  assert.deepEqual(pointsOf(out), scaled);
});

test("a tool that nobody knows is an error at its word, and the program is written all the same", async () => {
  for (const tools of [[], ["--tool-table", "tools.tbl", "--from", "auto"]]) {
    const text = corner.replace("D1", "D3");
    const { code, out, err } = await g41(["convert", "-", ...tools], { input: text });
    assert.equal(code, 1);
    assert.match(err, /^<stdin>:2(:\d+)?: error: .*tool 3.* \(missing-radius\)\n {2}hint: /);
    const programmed = [
      [-20, 0],
      [0, 0],
      [0, 40],
      [30, 40],
      [30, 60],
    ];
    assert.deepEqual(pointsOf(out), programmed);
  }
});

test("options reach the path", async () => {
  const run = async (...args) => await g41(["convert", "corner.ngc", "--radius", "3", ...args]);
  assert.match((await run("--corner", "arc")).out, /^G0?2 .*I/m, "an arc round the corner");
  assert.doesNotMatch((await run("--corner", "linear")).out, /^G0?[23]\b/m);
  assert.match((await run("--profile", "linuxcnc")).out, /^G0?2 /m, "as LinuxCNC rounds it");
  const skipped = (...args) => g41(["convert", "skipped.ngc", "--radius", "3", ...args]);
  assert.deepEqual(pointsOf((await skipped("--block-delete")).out), centres(3));
  assert.ok(
    pointsOf((await skipped()).out).some(([x]) => x > 90),
    "the block is there",
  );
  const noFeed = { input: corner.replace("F300", "") };
  const given = await g41(["convert", "-", "--radius", "3", "--feed", "123"], noFeed);
  assert.match(given.out, /F123\b/);
  assert.equal(given.code, 0);
});

test("the control compensates with --keep-compensation, if it can", async () => {
  const { code, out, err } = await g41([
    ...["convert", "corner.ngc", "--keep-compensation", "--to", "linuxcnc"],
  ]);
  assert.deepEqual([code, err], [0, ""]);
  assert.match(out, /G41 D0?1\b/);
  assert.match(out, /G40\b/);
  const programmed = [
    [-20, 0],
    [0, 0],
    [0, 40],
    [30, 40],
    [30, 60],
  ];
  assert.deepEqual(pointsOf(out), programmed);
  // grbl knows no G41.
  const grbl = await g41(["convert", "corner.ngc", "--keep-compensation"]);
  assert.equal(grbl.code, 1);
  assert.match(grbl.err, /error: .*\(not-compensated\)/);
});

test("--passes and --stepover clear a pocket by paths beside each other", async () => {
  const run = (...args) =>
    g41(["convert", "square.ngc", "--radius=3", "--gouge=avoid", "--json", ...args]);
  const widths = ({ moves }) => {
    const ends = moves.filter(({ role }) => role === "segment").map(({ to: [x] }) => x - 20);
    return [...new Set(ends.map((x) => Math.round(Math.abs(x) * 1e6) / 1e6))];
  };
  // A square of 40 mm: passes run 3 mm, 5.5 mm, 8 mm, … from its walls, as long as there is room.
  const near = async (expected, ...args) => {
    const found = widths(JSON.parse((await run(...args)).out));
    assert.deepEqual(
      found.sort((a, b) => b - a),
      expected,
    );
  };
  await near([17]);
  await near([17, 14.5], "--passes", "2", "--stepover", "2.5");
  await near([17, 14.5, 12, 9.5, 7, 4.5, 2], "--passes", "all", "--stepover", "2.5");
});

test("--curves arcs writes no cubics, --tangent-band takes a small turn for none", async () => {
  const kinds = async (...args) => {
    const { out } = await g41(["convert", "cam.ngc", "--tool", "3=2", "--json", ...args]);
    return new Set(JSON.parse(out).moves.map(({ kind }) => kind));
  };
  assert.ok((await kinds()).has("cubic"));
  assert.ok(!(await kinds("--curves", "arcs")).has("cubic"));
  const turns = async (...args) => {
    // A turn of atan(0.1), nearly 0.1 rad.
    const input = corner.replace("X30\n", "").replace("Y40\n", "Y40\nX-4 Y80\n");
    const { out } = await g41(["convert", "-", "--radius=3", "--json", ...args], { input });
    return JSON.parse(out).transitions.filter(({ angle }) => Math.abs(angle - Math.PI) < 0.2);
  };
  assert.equal((await turns()).length, 1);
  assert.equal((await turns("--tangent-band", "0.11")).length, 0);
  assert.equal((await turns("--tangent-band", "auto")).length, 1);
});

test("--curve-tolerance and --spline-parameter reach the reader", async () => {
  const spline = "G0 X0 Y0\nG5 X10 Y0\nX11 Y3\nX30 Y0\nM30\n";
  const points = async (...args) =>
    (await g41(["convert", "-", ...args], { input: spline.replace("G5", "G05") })).out;
  assert.notEqual(await points("--spline-parameter", "centripetal"), await points());
  assert.equal(await points("--spline-parameter", "chord"), await points());
});

test("a gouge is told with its place; it is avoided, or nothing is written, as --gouge says", async () => {
  const run = async (...args) => await g41(["convert", "slot.txt", "--radius", "3", ...args]);
  const reported = await run();
  assert.equal(reported.code, 1);
  assert.match(reported.err, /^slot\.txt:\d+(:\d+)?: error: .* \([a-z-]+\)$/m);
  assert.ok(pointsOf(reported.out).length > 3, "the path as a control would cut it");
  const stopped = await run("--gouge", "stop");
  assert.equal(stopped.code, 1);
  assert.deepEqual(pointsOf(stopped.out), []);
  // Of an inside corner of 90° a round tool leaves (1 − π/4) r².
  const input = "G0 X-20 Y0\nG1 G42 D1 X0 Y0 F300\nY40\nX30\nG40 Y20\n";
  const avoided = await g41(["convert", "-", "--radius=3", "--gouge=avoid"], { input });
  assert.match(avoided.err, /: info: a place is not reached, 1\.93\d mm² in all \(uncut\)\n/);
  const mirrored = await g41(["convert", "corner.ngc", "--radius", "3", "--gouge", "avoid"]);
  assert.deepEqual([mirrored.code, pointsOf(mirrored.out)], [0, centres(3)]);
});
