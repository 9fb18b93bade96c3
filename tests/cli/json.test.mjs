// g41 convert --json: the shapes of the package's types, everything in program order.
import assert from "node:assert/strict";
import { test } from "node:test";

import { compensate, parseProgram } from "../../dist/node.js";
import { script } from "../../scripts/command.mjs";
import { runNode } from "../package/consumer.mjs";
import { corner, installed, sample } from "./command.mjs";

const text = sample("cam.ngc");

const { g41, write, home } = installed({
  "cam.ngc": text,
  "tsconfig.json": JSON.stringify({
    compilerOptions: {
      ...{ target: "es2022", lib: ["es2022"], types: [], strict: true, noEmit: true },
      ...{ module: "nodenext", moduleResolution: "nodenext" },
    },
    include: ["*.ts"],
  }),
});

test("it has the moves, transitions and diagnostics that the package gives, and nothing else", async () => {
  const { code, out } = await g41(["convert", "cam.ngc", "--tool", "3=2", "--json"]);
  assert.equal(code, 0);
  const path = compensate(parseProgram(text), { tools: { 3: { radius: 2 } } });
  const { moves, transitions, diagnostics } = path;
  assert.ok(moves.length > 10 && transitions.length > 0);
  assert.deepEqual(JSON.parse(out), { moves, transitions, diagnostics });
});

test("rapids are among the moves, in program order, in mm", async () => {
  const { out } = await g41(["convert", "-", "--radius", "3", "--json"], { input: corner });
  const { moves } = JSON.parse(out);
  assert.deepEqual(
    moves.map(({ kind, role, to, feed, origin }) => [kind, role, ...to, feed, origin.block]),
    [
      ["rapid", "free", -20, 0, 0, undefined, 1],
      ["line", "lead-in", -3, 0, 0, 300, 2],
      ["line", "segment", -3, 43, 0, 300, 3],
      ["line", "segment", 30, 43, 0, 300, 4],
      ["line", "lead-out", 30, 60, 0, 300, 5],
    ],
  );
});

test("a feed has the digits that the program gives it", async () => {
  const input = "G21 G1 X5 F500\nX6 F7\nX7 F0.3\nG20 X8 F17\n";
  const { out } = await g41(["convert", "-", "--json"], { input });
  assert.deepEqual(
    JSON.parse(out).moves.map(({ feed }) => feed),
    [500, 7, 0.3, 431.8],
  );
});

test("its shape is that of the types", async () => {
  const shapes = [];
  for (const [name, args] of [
    ["cam", ["cam.ngc", "--tool", "3=2"]],
    ["gouges", ["cam.ngc", "--radius", "60"]],
    ["arcs", ["cam.ngc", "--radius", "2", "--corner", "arc"]],
    ["unread", ["-"]],
  ]) {
    const { out } = await g41(["convert", ...args, "--json"], {
      input: "G1 X5 Q\nG41 D2 X9\nN7 Y4 B\n",
    });
    shapes.push(`export const ${name}: Result = ${out};`);
  }
  write(
    "shapes.ts",
    `import type { Diagnostic, Move, Transition } from "g41";
interface Result { moves: Move[]; transitions: Transition[]; diagnostics: Diagnostic[] }
${shapes.join("\n")}`,
  );
  await runNode(home(), script("typescript", "tsc"));
});

test("a path without moves is JSON too", async () => {
  const { code, out } = await g41(["convert", "-", "--json"], { input: "M30\n" });
  assert.deepEqual([code, JSON.parse(out)], [0, { moves: [], transitions: [], diagnostics: [] }]);
});
