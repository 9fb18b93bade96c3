// g41 plan: cycle times by tool and by block, what limits cost, samples, and how it is called.
import assert from "node:assert/strict";
import { test } from "node:test";

import { changed, costsOf, inThreads } from "../../dist/cli/costs.js";
import { compensate, parseProgram } from "../../dist/node.js";
import { corner, installed, sample } from "./command.mjs";

const text = sample("two_tools.ngc");
const { g41, read } = installed({
  "part.ngc": corner,
  "tools.ngc": text,
  "wrong.ngc": "G0 X0 Y0\nG1 X10 F100 Q\nM30\n",
});

const limits = ["--limits", "velocity=200,acceleration=2000,jerk=5e4"];
const mill = { velocity: 200, acceleration: 2000, jerk: 5e4 };

test("it tells the time in all, by tool, by block, and what limits cost", async () => {
  const { code, out, err } = await g41(["plan", "part.ngc", "--radius", "3", ...limits]);
  assert.deepEqual([code, err], [0, ""]);
  const path = compensate(parseProgram(corner), { radius: 3 });
  const { duration } = path.plan(mill);
  assert.ok(out.startsWith(`part.ngc: ${duration.toFixed(2)} s, 5 moves, `), out);
  assert.match(out, /^ {2}tool +time +share\n {2}T?\w+ +[\d.]+ s +100\.0 %$/m);
  assert.match(out, /^ {2}line +N +time +share +moves +mm +mm\/min\n {2}3 +[\d.]+ s +/m);
  assert.match(out, /^ {2}twice the jerk +[\d.]+ s +-[\d.]+ %$/m);
  assert.match(out, /^ {2}a stop at each block +[\d.]+ s +\+[\d.]+ %$/m);
  assert.ok(
    out.split("\n").every((line) => line.length <= 88),
    "no line is too long to read",
  );
});

test("tools are told apart, and all blocks are listed where that is asked for", async () => {
  const args = ["plan", "tools.ngc", "--radius", "2", ...limits];
  const { out } = await g41([...args, "--all-blocks"]);
  const tools = [...out.matchAll(/^ {2}T(\d+) /gm)].map(([, number]) => Number(number));
  const motion = compensate(parseProgram(text), { radius: 2 }).plan(mill);
  assert.deepEqual(
    tools,
    motion.toolTimes().flatMap(({ tool }) => tool ?? []),
  );
  assert.ok(tools.length >= 2);
  // Inside a full circle of 7 mm the tool of 2 mm goes round one of 5 mm: its way is no chord.
  const ways = [...out.matchAll(/^ {2}\d.* ([\d.,]+) +[\d,]+$/gm)].map(([, way]) => Number(way));
  assert.ok(
    ways.some((way) => Math.abs(way - 10 * Math.PI) < 0.1),
    `${ways}`,
  );
  assert.doesNotMatch(out, /--all-blocks/);
  assert.match((await g41(args)).out, /and \d+ blocks that take less \(--all-blocks lists them\)/);
});

test("--json has the numbers of the tables", async () => {
  const { code, out } = await g41(["plan", "tools.ngc", "--radius", "2", "--json", ...limits]);
  assert.equal(code, 0);
  const { duration, tools, blocks, costs, violations } = JSON.parse(out);
  const path = compensate(parseProgram(text), { radius: 2 });
  const motion = path.plan(mill);
  assert.deepEqual([duration, tools, violations], [motion.duration, motion.toolTimes(), []]);
  const sum = blocks.reduce((total, { time }) => total + time, 0);
  assert.ok(Math.abs(sum - duration) < 1e-9, `${sum} ${duration}`);
  assert.equal(
    blocks.reduce((total, { moves }) => total + moves, 0),
    path.count,
  );
  assert.deepEqual(
    costs.map(({ duration: other }) => other > 0),
    [true, true, true, true, true],
  );
});

test("what limits cost is the same found by threads or without", async () => {
  const source = { text, parse: {}, compensate: { radius: 2 } };
  const path = compensate(parseProgram(text), { radius: 2 });
  const others = changed(mill);
  const costs = await costsOf(path, source, mill, { seconds: 0, samples: 1000 });
  assert.deepEqual(
    costs.map(({ name }) => name),
    [...others.keys()],
  );
  for (const threads of [2, 3, 5]) {
    assert.deepEqual(
      await inThreads(source, [...others.values()], threads),
      costs.map(({ duration }) => duration),
      `by ${threads} threads`,
    );
  }
});

test("--csv writes the samples to a file", async () => {
  const args = ["plan", "-", "--radius", "3", "--csv", "samples.csv"];
  const { code } = await g41([...args, ...limits], { input: corner });
  assert.equal(code, 0);
  const motion = compensate(parseProgram(corner), { radius: 3 }).plan(mill);
  assert.equal(read("samples.csv"), motion.toCsv());
});

test("all limits can be given, also in several options", async () => {
  const more =
    "cornerDeviation=0.1,chordError=0.01,period=0.002,snap=1e7,feedOverride=2,mode=fast,curvatureSteps=stop,corner=ph11,exactStop=true";
  const axes = "axes.velocity=50/50/20,axes.acceleration=500/500/200,axes.jerk=5e3/5e3/2e3";
  const { out, err } = await g41([
    ...["plan", "part.ngc", "--radius", "3", ...limits],
    ...["--limits", more, "--limits", axes, "--json"],
  ]);
  assert.equal(err, "");
  const motion = compensate(parseProgram(corner), { radius: 3 }).plan({
    ...{ ...mill, cornerDeviation: 0.1, chordError: 0.01, period: 0.002, snap: 1e7 },
    ...{ feedOverride: 2, mode: "fast", curvatureSteps: "stop", corner: "ph11", exactStop: true },
    axes: { velocity: [50, 50, 20], acceleration: [500, 500, 200], jerk: [5e3, 5e3, 2e3] },
  });
  assert.equal(JSON.parse(out).duration, motion.duration);
});

test("an error in the program ends with exit code 1, and what is there is planned", async () => {
  const { code, out, err } = await g41(["plan", "wrong.ngc", ...limits]);
  assert.equal(code, 1);
  assert.match(out, /^wrong\.ngc: [\d.]+ s, \d moves?, /);
  assert.match(err, /^wrong\.ngc:2:\d+: error: /m);
});

test("wrong use ends with exit code 2 and says what is meant", async () => {
  for (const [args, says, hint] of [
    [[], /the program is missing/, /g41 plan FILE/],
    [["part.ngc", "tools.ngc"], /tools\.ngc: one program at a time/],
    [["part.ngc"], /--limits must give the machine's velocity/, /--limits velocity=200/],
    [["part.ngc", "--limits", "velocity=200"], /must give the machine's acceleration/],
    [["part.ngc", "--limits", "velocty=200"], /there is no limit velocty/, /mean velocity\?/],
    [["part.ngc", "--limits", "fast"], /--limits must be NAME=VALUE, not "fast"/],
    [["part.ngc", "--limits", "jerk=much"], /jerk must be a number, not "much"/],
    [["part.ngc", ...limits, "--limits", "velocity=-1"], /velocity must be greater than 0/],
    [["part.ngc", ...limits, "--limits", "mode=quick"], /mode must be "fast" or "textbook"/],
    [["part.ngc", ...limits, "--limits", "exactStop=yes"], /exactStop must be true or false/],
    [["part.ngc", ...limits, "--limits", "axes.jerk=1/2"], /axes\.\w+ must be three numbers/],
    [["part.ngc", ...limits, "--csv", "part.ngc"], /part\.ngc is what is read/],
  ]) {
    const { code, out, err } = await g41(["plan", ...args]);
    assert.deepEqual([code, out], [2, ""], `${args.join(" ")}\n${err}`);
    assert.match(err, says);
    if (hint) {
      assert.match(err, hint);
    }
  }
});
