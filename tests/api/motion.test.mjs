// Motion of the public face: channels, closed forms of simple paths, words that concern it, faults, memory.
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  compensate,
  interpolate,
  left,
  Motion,
  parseProgram,
  part,
  throwsCode,
} from "./sample.mjs";

const mill = { velocity: 200, acceleration: 2000, jerk: 5e4 };

const channels = [
  ...["time", "x", "y", "z", "velocity", "tangentialAcceleration", "normalAcceleration", "jerk"],
];

/** The path of a program. */
const pathOf = (text) => compensate(parseProgram(text));

const planOf = (text, limits = {}) => pathOf(text).plan({ ...mill, ...limits });

const near = (value, expected, within, what) =>
  assert.ok(Math.abs(value - expected) <= within, `${what}: ${value}, not ${expected}`);

test("all channels have a number for each sample, at multiples of the period and at the end", () => {
  const path = compensate(part, left);
  const motion = path.plan({ ...mill, period: 0.002 });
  assert.ok(motion instanceof Motion);
  for (const name of channels) {
    assert.ok(motion[name] instanceof Float64Array, name);
    assert.equal(motion[name].length, motion.count, name);
    assert.equal(motion[name], motion[name], "the copy is made once");
  }
  assert.ok(motion.block instanceof Uint32Array);
  assert.equal(motion.block.length, motion.count);
  const last = motion.count - 1;
  motion.time.slice(0, last).forEach((time, i) => {
    near(time, i * 0.002, 1e-12, `time ${i}`);
  });
  near(motion.time[last], motion.duration, 1e-12, "the end");
  assert.deepEqual([motion.velocity[0], motion.velocity[last]], [0, 0], "at rest");
  const { to } = path.moves.at(-1);
  near(Math.hypot(motion.x[last] - to[0], motion.y[last] - to[1]), 0, 1e-9, "end point");
  assert.equal(motion.block[0], 0);
  assert.equal(motion.block[last], path.count - 1);
});

test("a straight line takes as long as its ramps and its feed", () => {
  // With jerk J, acceleration A and velocity V: V/A + A/J + S/V, by one more period or so for a jerk
  // that has no steps.
  const text = "G0 X0 Y0\nG1 X100 F12000\n";
  const motion = planOf(text);
  near(motion.duration, 0.1 + 0.04 + 0.5, 0.03, "duration");
  assert.ok(motion.duration >= 0.64, `no faster than bounded jerk allows: ${motion.duration}`);
  assert.ok(Math.max(...motion.velocity) <= 200 * (1 + 1e-9), "velocity");
  assert.ok(Math.max(...motion.tangentialAcceleration) <= 2000 * (1 + 1e-9), "acceleration");
  assert.ok(Math.max(...motion.jerk) <= 5e4 * (1 + 1e-9), "jerk");
  assert.deepEqual(motion.violations, []);
});

test("a programmed feed is kept, and the override changes it", () => {
  const text = "G0 X0 Y0\nG1 X20 F600\n";
  /** The most of it is reached, and no more. */
  const kept = ({ velocity }, feed, what) => {
    const most = Math.max(...velocity);
    assert.ok(most <= feed * (1 + 1e-9) && most > 0.99 * feed, `${what}: ${most} of ${feed}`);
  };
  kept(planOf(text), 10, "F600");
  kept(planOf(text, { feedOverride: 1.5 }), 15, "at 150 %");
  kept(planOf("G0 X0 Y0\nG0 X200\n", { feedOverride: 0.5 }), 200, "rapid moves are not overridden");
});

test("a dwell waits as long as it says, at rest", () => {
  const apart = 2 * planOf("G0 X0 Y0\nG1 X30 F6000\n").duration;
  const waited = planOf("G0 X0 Y0\nG1 X30 F6000\nG4 P0.75\nX60\n");
  near(waited.duration, apart + 0.75, 1e-6, "duration");
  const still = waited.velocity.filter((v, i) => v === 0 && Math.abs(waited.x[i] - 30) < 1e-9);
  near(still.length, 750, 3, "samples at rest");
});

test("G61.1 stops at each block, G64 P rounds within its deviation, as the limits would", () => {
  const corner = "X30\nY30\nX60\n";
  const exact = planOf(`G0 X0 Y0\nG61.1\nG1 F6000\n${corner}`);
  const option = planOf(`G0 X0 Y0\nG1 F6000\n${corner}`, { exactStop: true });
  assert.equal(exact.duration, option.duration, "G61.1 is exactStop");
  const wide = planOf(`G0 X0 Y0\nG64 P0.5\nG1 F6000\n${corner}`);
  const given = planOf(`G0 X0 Y0\nG1 F6000\n${corner}`, { cornerDeviation: 0.5 });
  assert.equal(wide.duration, given.duration, "G64 P is cornerDeviation");
  assert.ok(wide.duration < exact.duration, "rounding is faster than stops");
  const away = Array.from(exact.x, (x, i) => Math.hypot(x - 30, exact.y[i]));
  const nearest = away.indexOf(Math.min(...away));
  assert.ok(exact.velocity[nearest] < 0.1, `it rests at the corner: ${exact.velocity[nearest]}`);
});

test("the times of blocks and tools add up to the duration", () => {
  const text = "T1 M6\nG0 X0 Y0 Z5\nG1 Z0 F600\nX30\nT7 M6\nG0 Z5\nG1 X0 F1200\nM30\n";
  const path = pathOf(text);
  const motion = path.plan(mill);
  const times = motion.blockTimes();
  assert.equal(times.length, path.count);
  const sum = (values) => values.reduce((total, value) => total + value, 0);
  near(sum([...times]), motion.duration, 1e-9, "blocks");
  const tools = motion.toolTimes();
  assert.deepEqual(
    tools.map(({ tool }) => tool),
    [1, 7],
  );
  near(sum(tools.map(({ time }) => time)), motion.duration, 1e-9, "tools");
  // 30 mm at 10 mm/s, and 30 mm at 20 mm/s, each with its ramps.
  near(times[path.moves.findIndex(({ to }) => to[0] === 30)], 3, 0.3, "the third block");
  assert.deepEqual(
    pathOf("G0 X0 Y0\nG1 X5 F60\n")
      .plan(mill)
      .toolTimes()
      .map(({ tool }) => tool),
    [undefined],
  );
});

test("between two pieces of a path it goes straight", () => {
  const line = (y) => ({ start: [0, y], segments: [{ kind: "line", to: [10, y] }] });
  const path = compensate([line(0), line(50)], { side: "left", radius: 0 });
  const motion = path.plan(mill);
  const steps = Array.from(motion.x, (x, i) =>
    i === 0 ? 0 : Math.hypot(x - motion.x[i - 1], motion.y[i] - motion.y[i - 1]),
  );
  assert.ok(Math.max(...steps) <= 200 * 0.001 * (1 + 1e-6), "no jump");
  assert.ok(motion.block.every((block) => block < path.count));
});

test("the ways between pieces are told, and the samples that run them", () => {
  // A room, a corridor that the tool is too wide for, and another room; then home, far above.
  const text = `G21 G90
G0 X10 Y10 Z5
G1 Z-2 F120
G41 Y0 F400
X30
Y12
X40
Y0
X70
Y30
X40
Y18
X30
Y30
X0
Y0
X10
G40 Y10
G0 Z5
G28 Z90
`;
  const path = compensate(parseProgram(text), { radius: 5, gouge: "avoid" });
  const { ways } = path;
  assert.deepEqual(
    ways.map(({ move: { kind, role, feed } }) => [kind, role, feed]),
    [
      ["rapid", "free", undefined],
      ["rapid", "free", undefined],
      ["line", "free", 120],
      ["rapid", "free", undefined],
      ["rapid", "free", undefined],
      ["line", "free", 120],
    ],
  );
  assert.deepEqual(
    ways.map(({ move: { from, to } }) => [from[2], to[2]]),
    [
      [-2, 5],
      [5, 5],
      [5, -2],
      [-2, 5],
      [5, 5],
      [5, -2],
    ],
  );
  for (const [i, { before, move }] of ways.entries()) {
    const next = ways[i + 1];
    const to = i % 3 === 2 ? path.moves[before].from : next.move.from;
    assert.deepEqual(move.to, to, `way ${i} leads on`);
    assert.equal(move.origin.block, path.moves[before].origin.block, `line of way ${i}`);
  }
  const motion = path.plan(mill);
  const befores = ways.map(({ before }, k) => before + k);
  motion.step.forEach((step, i) => {
    const passed = befores.filter((number) => number < step).length;
    assert.equal(motion.block[i], step - passed, `sample ${i}`);
    const way = befores.indexOf(step);
    if (way % 3 === 1) {
      assert.ok(Math.abs(motion.z[i] - 5) < 0.1, `sample ${i} goes across`);
    }
  });
  const seen = new Set(motion.step);
  assert.ok(
    befores.every((number) => seen.has(number)),
    "each has samples",
  );
});

test("samples are written as comma-separated values", () => {
  const motion = planOf("G0 X0 Y0\nG1 X-3.5 Y2 F600\n", { period: 0.01 });
  const lines = motion.toCsv().trimEnd().split("\n");
  assert.equal(lines[0], [...channels, "block"].join(","));
  assert.equal(lines.length, motion.count + 1);
  lines.slice(1).forEach((line, i) => {
    const values = line.split(",").map(Number);
    [...channels, "block"].forEach((name, k) => {
      near(values[k], motion[name][i], 1e-9, `${name} ${i}`);
    });
  });
  assert.doesNotMatch(motion.toCsv(), /-0[,\n]|e-/);
});

test("a limit that is missing or wrong is named", () => {
  const path = compensate(part, left);
  for (const [limits, place] of [
    [undefined, "limits"],
    [{ velocity: 1, acceleration: 1 }, "limits.jerk"],
    [{ ...mill, velocity: 0 }, "limits.velocity"],
    [{ ...mill, acceleration: Number.NaN }, "limits.acceleration"],
    [{ ...mill, cornerDeviation: -0.1 }, "limits.cornerDeviation"],
    [{ ...mill, chordError: "fine" }, "limits.chordError"],
    [{ ...mill, period: 1e-9 }, "limits.period"],
    [{ ...mill, snap: 0 }, "limits.snap"],
    [{ ...mill, mode: "slow" }, "limits.mode"],
    [{ ...mill, curvatureSteps: "jump" }, "limits.curvatureSteps"],
    [{ ...mill, corner: "ph7" }, "limits.corner"],
    [{ ...mill, exactStop: 1 }, "limits.exactStop"],
    [{ ...mill, feedOverride: 0 }, "limits.feedOverride"],
    [{ ...mill, axes: { velocity: [1, 1, 1] } }, "limits.axes.acceleration"],
    [
      { ...mill, axes: { velocity: [1, 0, 1], acceleration: [1, 1, 1], jerk: [1, 1, 1] } },
      "limits.axes.velocity[1]",
    ],
    [{ ...mill, speed: 3 }, "limits.speed"],
  ]) {
    throwsCode(() => path.plan(limits), "bad-argument", place);
  }
});

test("a motion of too many samples is refused, not begun", () => {
  const path = pathOf("G0 X0 Y0\nG1 X1000 F1\n");
  throwsCode(() => path.plan({ ...mill, period: 1e-5 }), "bad-argument", "limits.period");
  const waits = pathOf("G0 X0 Y0\nG1 X1 F100\nG4 P1000000\n");
  throwsCode(() => waits.plan(mill), "bad-argument", "limits.period");
});

test("a motion outlives its path, its channels outlive it, and nothing is left behind", () => {
  const path = compensate(part, left);
  const motion = path.plan(mill);
  path[Symbol.dispose]();
  const { velocity } = motion;
  const count = motion.count;
  assert.deepEqual(motion.violations, []);
  motion[Symbol.dispose]();
  motion[Symbol.dispose]();
  assert.equal(velocity.length, count);
  throwsCode(() => motion.x, "disposed");
  throwsCode(() => motion.duration, "disposed");
  throwsCode(() => path.plan(mill), "disposed");
  assert.throws(() => new Motion(), TypeError);
});

test("rules of interpolation step along a spline, the better the more evenly", () => {
  // Through points on a circle of radius 20, closed: the arc of a step is known to the spline's error.
  const points = Array.from({ length: 60 }, (_, i) => {
    const angle = ((i + 1) * Math.PI) / 30;
    return i === 59 ? [20, 0] : [20 * Math.cos(angle), 20 * Math.sin(angle)];
  });
  const circle = { start: [20, 0], closed: true, segments: [{ kind: "spline", points }] };
  const error = (rule, corrections) => {
    const { points, lengths } = interpolate(circle, 0.5, rule, corrections);
    assert.equal(points.length, 2 * lengths.length, rule);
    assert.deepEqual([points[0], points[1], lengths[0]], [20, 0, 0], rule);
    near(lengths.length, (40 * Math.PI) / 0.5, 2, rule);
    let most = 0;
    for (let i = 1; i < lengths.length; i++) {
      const angle = (other) => Math.atan2(points[2 * other + 1], points[2 * other]);
      const turn = ((angle(i) - angle(i - 1) + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
      near(lengths[i] - lengths[i - 1], 20 * turn, 1e-5, `${rule}: the arc of step ${i}`);
      most = Math.max(most, Math.abs((lengths[i] - lengths[i - 1]) / 0.5 - 1));
    }
    return most;
  };
  const errors = [error("taylor-1"), error("taylor-2"), error("runge-kutta"), error("arc-length")];
  for (const [i, each] of errors.entries()) {
    assert.ok(i === 0 || each < errors[i - 1] || each < 1e-12, `${errors}`);
  }
  assert.ok(errors[3] < 1e-12, `measured: ${errors[3]}`);
  // The chord of a step is shorter than its arc by s²/24R².
  near(error("predictor-corrector", 3), 0.25 / 24 / 400, 1e-7, "by the chord");
  assert.equal(error("arc-length", 0), errors[1], "without a correction it is Taylor's");
});

test("interpolation names the argument that is wrong", () => {
  const spline = {
    start: [0, 0],
    segments: [
      {
        kind: "spline",
        points: [
          [5, 1],
          [9, 0],
        ],
      },
    ],
  };
  const line = { start: [0, 0], segments: [{ kind: "line", to: [9, 0] }] };
  throwsCode(() => interpolate(spline, 0, "taylor-1"), "bad-argument", "step");
  throwsCode(() => interpolate(spline, 1e-9, "taylor-1"), "bad-argument", "step");
  throwsCode(() => interpolate(spline, 1, "euler"), "bad-argument", "rule");
  throwsCode(() => interpolate(spline, 1, "arc-length", 0.5), "bad-argument", "corrections");
  throwsCode(() => interpolate(line, 1, "taylor-1"), "bad-argument", "contour.segments");
});
