// Long programs are converted in time, and their JSON does not have to fit into one text.
import assert from "node:assert/strict";
import { test } from "node:test";

import { installed, pointsOf } from "./command.mjs";

const blocks = 100_000;

/** A zigzag, in which the tool always fits. */
function zigzag() {
  const lines = ["G0 X0 Y-10", "G1 G42 D1 X0 Y0 F600"];
  for (let i = 1; i < blocks; i++) {
    lines.push(`X${i % 2 === 0 ? i : i + 0.5} Y${i % 2}`);
  }
  lines.push(`G40 Y-10`, "M30", "");
  return lines.join("\n");
}

const { g41 } = installed({ "long.ngc": zigzag() });

test("a program of 100,000 blocks is converted within 30 s", async () => {
  const start = performance.now();
  const { code, out } = await g41(["convert", "long.ngc", "--radius", "0.1"]);
  const seconds = (performance.now() - start) / 1000;
  assert.equal(code, 0);
  assert.ok(pointsOf(out).length >= blocks);
  assert.ok(seconds < 30, `it took ${seconds.toFixed(1)} s`);
});

test("its JSON has every move", async () => {
  const { code, out } = await g41(["convert", "long.ngc", "--radius", "0.1", "--json"]);
  assert.equal(code, 0);
  const { moves, transitions } = JSON.parse(out);
  assert.ok(moves.length >= blocks && transitions.length >= blocks - 2);
  const lines = moves.map(({ origin }) => origin.block);
  assert.ok(
    lines.every((line, i) => i === 0 || line >= lines[i - 1]),
    "in program order",
  );
});
