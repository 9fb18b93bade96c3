// Handles free themselves, and survive neither disposal nor a trap.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";

import { initSync } from "../../dist/g41.js";
import { call } from "../../dist/lifecycle.js";
import init, {
  compensate,
  flatten,
  left,
  Program,
  parseProgram,
  part,
  program,
  ToolPath,
  throwsCode,
} from "./sample.mjs";

const many = 100_000;

setFlagsFromString("--expose-gc");
const collect = runInNewContext("gc");

/** Bytes of the WebAssembly's memory, which never shrinks. */
function wasmBytes() {
  return initSync().memory.buffer.byteLength;
}

/** Lets the engine collect what is not reachable, and run what it has registered for that. */
async function settle() {
  for (let i = 0; i < 3; i++) {
    collect();
    await new Promise((resolve) => setTimeout(resolve));
  }
}

/** Memory in use [bytes] once everything unreachable is gone. */
async function settled() {
  await settle();
  return { wasm: wasmBytes(), heap: process.memoryUsage().heapUsed };
}

/** Makes paths as a page does that redraws itself, and drops them, each after `use`. */
async function drop(count, use) {
  for (let i = 0; i < count; i++) {
    use(compensate(part, { side: "left", radius: 1 + (i % 100) / 50 }), i);
    if (i % 1000 === 999) {
      await settle();
    }
  }
}

/** Asserts that paths leave less than `slack` bytes behind in the WebAssembly's memory. */
async function doesNotGrow(use, slack) {
  await drop(many / 20, use);
  const before = await settled();
  await drop(many, use);
  const after = await settled();
  const grown = after.wasm - before.wasm;
  assert.ok(grown <= slack, `memory of the WebAssembly grew by ${grown} bytes`);
  assert.ok(after.heap - before.heap < 2e6, `heap: ${before.heap} to ${after.heap} bytes`);
}

test("a hundred thousand paths that are disposed of leave nothing behind", async () => {
  await doesNotGrow((path) => path[Symbol.dispose](), 0);
});

test("a hundred thousand paths that are forgotten leave nothing behind", async () => {
  // How many are forgotten but not collected yet is the engine's choice, and the memory keeps the
  // most there ever were; ten bytes left behind by each would be as much as this.
  await doesNotGrow((path, i) => {
    if (i % 100 === 0) {
      assert.ok(path.moves.length > 0 && path.transitions.length > 0);
    }
  }, 10 * many);
});

test("flattening and reading programs leave nothing behind", async () => {
  const use = () => {
    flatten(part, 0.1);
    const read = parseProgram(program);
    const path = compensate(read, { radius: 2 });
    path.gcode();
    read.polylines(0.1);
    path[Symbol.dispose]();
    read[Symbol.dispose]();
    assert.throws(() => compensate(part, {}), { code: "bad-argument" });
  };
  const round = async () => {
    for (let i = 0; i < 5000; i++) {
      use();
      if (i % 500 === 499) {
        await settle();
      }
    }
  };
  await round();
  const before = await settled();
  await round();
  const after = await settled();
  assert.equal(after.wasm, before.wasm, "memory of the WebAssembly");
});

test("a handle that was disposed of says so, and may be disposed of again", () => {
  const path = compensate(part, left);
  path[Symbol.dispose]();
  path[Symbol.dispose]();
  throwsCode(() => path.moves, "disposed");
  throwsCode(() => path.polyline(), "disposed");
  throwsCode(() => path.gcode(), "disposed");
  const read = parseProgram(program);
  read[Symbol.dispose]();
  throwsCode(() => read.contours, "disposed");
  throwsCode(() => compensate(read), "disposed");
});

test("handles are made by functions alone", () => {
  assert.throws(() => new ToolPath(), TypeError);
  assert.throws(() => new Program(), TypeError);
  assert.ok(compensate(part, left) instanceof ToolPath);
  assert.ok(parseProgram("") instanceof Program);
});

test("after a trap every call says so, until init() starts afresh", async () => {
  const path = compensate(part, left);
  const { moves } = path;
  const read = parseProgram(program);
  const outOfBounds = () => initSync().toolpathhandle_records(0xfffffff0);
  assert.throws(
    () => call(outOfBounds),
    (error) => error.code === "trapped" && error.cause instanceof WebAssembly.RuntimeError,
  );
  for (const use of [
    () => compensate(part, left),
    () => compensate(part, {}),
    () => flatten(part),
    () => parseProgram(program),
    () => path.polyline(),
    () => read.contours,
  ]) {
    throwsCode(use, "trapped");
  }
  await init();
  assert.deepEqual(compensate(part, left).moves, moves);
  throwsCode(() => path.polyline(), "disposed");
  throwsCode(() => compensate(read), "disposed");
  path[Symbol.dispose]();
  read[Symbol.dispose]();
  await settle();
  assert.deepEqual(compensate(part, left).moves, moves);
});

test("where memory has run out that is said", async () => {
  const outOfBounds = () => {
    const wasm = initSync();
    wasm.memory.grow(2 ** 14 + 1);
    wasm.toolpathhandle_records(0xfffffff0);
  };
  assert.throws(
    () => call(outOfBounds),
    (error) => error.code === "out-of-memory" && /^g41 .*memory: 1\d{3} MB/.test(error.message),
  );
  throwsCode(() => compensate(part, left), "trapped");
  await init();
  assert.ok(compensate(part, left).moves.length > 0, "afresh");
});
