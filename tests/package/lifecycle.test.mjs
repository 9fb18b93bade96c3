// Loading: refused calls before it, one load however often it is asked for, a fresh start after a trap.
import assert from "node:assert/strict";
import { test } from "node:test";

import { packed, runNode } from "./consumer.mjs";

const project = packed();

/** Runs the body of a module in an empty project; it fails the test by throwing. */
async function runs(body) {
  const source = `import assert from "node:assert/strict";\n${body}\nconsole.log("done");`;
  assert.equal(await runNode(project("lifecycle", { "main.mjs": source }), "main.mjs"), "done");
}

test("a call before init() is refused, and works after it", async () => {
  await runs(`
    import init, { version } from "g41/inline";
    assert.throws(() => version(), { name: "Error", code: "not-initialised" });
    const loading = init();
    assert.throws(() => version(), { code: "not-initialised" });
    await Promise.all([loading, init()]);
    await init();
    assert.ok(version());`);
});

test("in Node the package is ready when it is imported, and init() does nothing", async () => {
  await runs(`
    import init, { version } from "g41";
    assert.ok(version());
    await init();
    assert.ok(version());`);
});

test("a load that failed may be tried again", async () => {
  await runs(`
    import init, { version } from "g41/web";
    const isTold = ({ name, code, message, cause }) =>
      name === "Error" &&
      code === "not-loaded" &&
      message.includes("g41/inline") &&
      cause instanceof Error;
    await assert.rejects(init(new Uint8Array([1, 2, 3])), isTold);
    assert.throws(() => version(), { code: "not-initialised" });
    const { readFileSync } = await import("node:fs");
    await init(readFileSync(new URL(import.meta.resolve("g41/g41_bg.wasm"))));
    assert.ok(version());`);
});

test("in Node a file that was left behind is told of", async () => {
  await runs(`
    import { rmSync } from "node:fs";
    rmSync("./node_modules/g41/dist/g41_bg.wasm");
    await assert.rejects(import("g41"), { code: "not-loaded", message: /ENOENT.*g41.inline/ });`);
});

test("after a trap the next call says so, and init() starts afresh", async () => {
  await runs(`
    import init, { version } from "g41";
    import { initSync } from "./node_modules/g41/dist/g41.js";
    import { call } from "./node_modules/g41/dist/lifecycle.js";
    const outOfBounds = () => initSync().__wbindgen_free(0xfffffff0, 16, 1);
    assert.throws(
      () => call(outOfBounds),
      (error) => error.code === "trapped" && error.cause instanceof WebAssembly.RuntimeError,
    );
    assert.throws(() => version(), { name: "Error", code: "trapped" });
    await init();
    assert.ok(version());`);
});
