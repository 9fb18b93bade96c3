// Time per block and per sample of planning motions, as WebAssembly in Node, with the package as it was
// last built: `node benches/motion.mjs`. `cargo bench --package peers --bench motion` has the same
// natively, and memory.
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { main, root } from "../scripts/command.mjs";

const limits = { velocity: 200, acceleration: 2000, jerk: 5e4 };
const shapes = [
  ["waves, points 0.2 mm apart", waves, [10_000, 100_000]],
  ["blocks of 3 to 8 mm", corners, [1000]],
  ["stairs", stairs, [1000]],
];

/** Prints a table. */
export async function benchMotion() {
  const { compensate, parseProgram } = await import(pathToFileURL(join(root, "dist/node.js")).href);
  console.log("| path | blocks | motion, s | samples | µs a block (of processor time) |");
  console.log("| --- | --- | --- | --- | --- |");
  for (const [name, shape, counts] of shapes) {
    for (const count of counts) {
      const path = compensate(parseProgram(program(shape, count)), { radius: 1 });
      const begun = process.cpuUsage();
      const motion = path.plan(limits);
      const each = process.cpuUsage(begun).user / count;
      console.log(
        `| ${name} | ${count} | ${motion.duration.toFixed(1)} | ${motion.count} | ${each.toFixed(1)} |`,
      );
      motion.free?.();
      path.free?.();
    }
  }
  console.log("\n| path | millions of samples a second |\n| --- | --- |");
  rate(compensate(parseProgram("G0 X0 Y0\nG1 X4000 F100000\n"), { radius: 1 }), "a line");
  for (const [name, shape] of shapes) {
    rate(compensate(parseProgram(program(shape, 100)), { radius: 1 }), name);
  }
}

/** Samples in a second: what fifty times as many samples of the same law take longer. */
function rate(path, name) {
  const found = [1e-3, 2e-5].map((period) => {
    let best = Number.POSITIVE_INFINITY;
    let count = 0;
    for (let round = 0; round < 3; round += 1) {
      const begun = process.cpuUsage();
      const motion = path.plan({ ...limits, period, snap: 1e7, chordError: 1 });
      best = Math.min(best, process.cpuUsage(begun).user);
      count = motion.count;
      motion.free?.();
    }
    return [count, best];
  });
  const [[few, short], [many, long]] = found;
  console.log(`| ${name} | ${((many - few) / (long - short)).toFixed(1)} |`);
}

function program(shape, count) {
  const lines = ["G0 X0 Y0"];
  for (let k = 0; k <= count; k += 1) {
    const [x, y] = shape(k);
    lines.push(`G1 X${x.toFixed(4)} Y${y.toFixed(4)} F100000`);
  }
  return lines.join("\n");
}

/** Lines of waves beside each other. */
function waves(k) {
  const row = Math.floor(k / 500);
  const on = row % 2 === 0 ? k % 500 : 499 - (k % 500);
  return [0.2 * on, (row % 500) * 0.5 + 2 * Math.sin((Math.PI * on) / 100)];
}

/** Corners of all angles. */
function corners(k) {
  const spread = (n) => (Math.imul(n, 2_654_435_761) >>> 8) / 2 ** 24;
  const [angle, length] = [2 * Math.PI * spread(k), 1 + spread(k + 7)];
  return [
    (k % 100) * 4 + length * Math.cos(angle),
    Math.floor(k / 100) * 0.3 + length * Math.sin(angle),
  ];
}

/** Right angles, 5 mm apart. */
function stairs(k) {
  return [5 * Math.ceil(k / 2), 5 * Math.floor(k / 2)];
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  main(benchMotion);
}
