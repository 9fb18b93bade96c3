// Long work in slices gives what it gives in one go, and tells how far it is.
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  compensate,
  ProgramCompensation,
  ProgramReader,
  parseProgram,
  program,
  readToolTable,
  throwsCode,
} from "./sample.mjs";

/** Squares beside each other, each with leads of its own. */
function squares(count) {
  const lines = ["G21 G90"];
  for (let i = 0; i < count; i++) {
    const x = 50 * i;
    lines.push(`G0 X${x - 10} Y0`, `T${(i % 3) + 1}`, `G1 G41 X${x} Y0 F300`);
    lines.push("Y20", `X${x + 20}`, "Y0", `X${x}`, `G40 X${x - 10}`);
  }
  return [...lines, "M2", ""].join("\n");
}

/** Steps until nothing is left; returns what progress was after each. */
function run(work, blocks) {
  const told = [work.progress];
  while (work.step(blocks)) {
    told.push(work.progress);
  }
  return [...told, work.progress];
}

function isRising(told) {
  assert.deepEqual(
    told,
    told.toSorted((a, b) => a - b),
  );
  assert.equal(told[0], 0);
  assert.equal(told.at(-1), 1);
}

test("a program that is read in slices is the one that is read in one go", () => {
  const text = squares(100);
  const reader = new ProgramReader(text);
  const told = run(reader, 50);
  assert.ok(told.length > 10, `${told.length} slices of 802 lines`);
  isRising(told);
  const read = reader.finish();
  const whole = parseProgram(text);
  assert.deepEqual(read.contours, whole.contours);
  assert.deepEqual(read.diagnostics, whole.diagnostics);
  assert.deepEqual(read.tools, [1, 2, 3]);
});

test("a program that is compensated in slices has the path of one go", () => {
  const read = parseProgram(squares(100));
  const options = { radius: 2, tools: { 3: { radius: 1 } } };
  const work = new ProgramCompensation(read, options);
  const told = run(work, 20);
  assert.ok(told.length > 10, `${told.length} slices of 100 contours`);
  isRising(told);
  const path = work.finish();
  const whole = compensate(read, options);
  assert.deepEqual(path.records(), whole.records());
  assert.deepEqual(path.diagnostics, whole.diagnostics);
  assert.equal(path.count, whole.moves.length);
});

test("finish does what is left", () => {
  const reader = new ProgramReader(squares(10));
  reader.step(5);
  const read = reader.finish();
  assert.equal(read.contours.length, 10);
  const work = new ProgramCompensation(read, { radius: 2 });
  assert.deepEqual(work.finish().records(), compensate(read, { radius: 2 }).records());
});

test("what was finished or stopped cannot be used any more", () => {
  const reader = new ProgramReader(program);
  const read = reader.finish();
  throwsCode(() => reader.step(1), "disposed");
  throwsCode(() => reader.finish(), "disposed");
  reader[Symbol.dispose]();
  const stopped = new ProgramReader(program);
  stopped.step(1);
  stopped[Symbol.dispose]();
  throwsCode(() => stopped.progress, "disposed");
  const work = new ProgramCompensation(read, { radius: 1 });
  read[Symbol.dispose]();
  throwsCode(() => work.step(1), "disposed");
});

test("slices say what they take", () => {
  throwsCode(() => new ProgramReader(5), "bad-argument", "text");
  throwsCode(() => new ProgramReader("", { dialect: "x" }), "bad-argument", "options.dialect");
  throwsCode(() => new ProgramReader("").step(0), "bad-argument", "blocks");
  throwsCode(() => new ProgramReader("").step("all"), "bad-argument", "blocks");
  throwsCode(() => new ProgramCompensation({}), "bad-argument", "program");
});

test("the records of some moves are those of all from one index to another", () => {
  const path = compensate(parseProgram(squares(3)), { radius: 2 });
  const all = path.records();
  assert.deepEqual(path.records(4, 7), all.slice(4 * 19, 7 * 19));
  assert.deepEqual(path.records(5), all.slice(5 * 19));
  assert.equal(path.records(path.count).length, 0);
  throwsCode(() => path.records(-1), "bad-argument", "from");
  throwsCode(() => path.records(0, 1.5), "bad-argument", "to");
});

test("a tool table gives its tools, and says which lines it cannot read", () => {
  assert.deepEqual(readToolTable("T1 P1 D6 ;mill\nT2 P2\nt3 q2 d+1.5\n"), {
    tools: { 1: { diameter: 6, orientation: 0 }, 3: { diameter: 1.5, orientation: 2 } },
    diagnostics: [],
  });
  const { tools, diagnostics } = readToolTable("T1 D6\nnonsense\r\nT1 D7\nT4 D2");
  assert.deepEqual(Object.keys(tools), ["1", "4"]);
  assert.deepEqual(
    diagnostics.map(({ severity, code, origin }) => [severity, code, origin.block]),
    [
      ["error", "bad-tool-table", 2],
      ["error", "bad-tool-table", 3],
    ],
  );
  throwsCode(() => readToolTable(5), "bad-argument", "text");
});
