// The packed package works in an empty project of every kind that it is made for.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { script } from "../../scripts/command.mjs";
import { answer, packed, page, program, runNode, shownBy } from "./consumer.mjs";

const project = packed();
const show = `document.querySelector("output").textContent = answer;`;

/** Of each entry its file, and the WebAssembly that is carried along beside it. */
const entries = {
  g41: { file: "web.js", wasm: ["g41_bg"] },
  "g41/inline": { file: "inline.js", wasm: [] },
  "g41/contour": { file: "contour.js", wasm: ["g41_contour_bg"] },
};

for (const [entry, { file, wasm }] of Object.entries(entries)) {
  const imports = `import init, { compensate } from "${entry}";`;

  test(`${entry} is imported by Node`, async () => {
    const source = `${imports}\n${program}\nconsole.log(answer);`;
    assert.equal(await runNode(project("esm", { "main.mjs": source }), "main.mjs"), answer);
  });

  test(`${entry} is required by Node`, async () => {
    const source = `const { default: init, compensate } = require("${entry}");
(async () => { ${program} console.log(answer); })();`;
    const home = project("cjs", { "main.cjs": source });
    // Node 20 warns that it is experimental.
    assert.equal(await runNode(home, "--no-warnings", "main.cjs"), answer);
  });

  test(`${entry} is built by Vite without configuration`, async () => {
    const home = project("vite", {
      "index.html": page(`<script type="module" src="./main.js"></script>`),
      "main.js": `${imports}\n${program}\n${show}`,
    });
    await runNode(home, script("vite"), "build", "--logLevel", "warn");
    assert.equal(await shownBy(join(home, "dist")), answer);
    const carried = readdirSync(join(home, "dist/assets")).filter((name) => name.endsWith(".wasm"));
    const names = carried.map((name) => name.replace(/-.*/, ""));
    assert.deepEqual(names, wasm, "what is built carries the WebAssembly that it loads alone");
  });

  test(`${entry} is imported by a browser through an import map`, async () => {
    const map = { imports: { [entry]: `./node_modules/g41/dist/${file}` } };
    const home = project("browser", {
      "index.html": page(
        `<script type="module">${imports}\n${program}\n${show}</script>`,
        `<script type="importmap">${JSON.stringify(map)}</script>`,
      ),
    });
    assert.equal(await shownBy(home), answer);
  });
}

test("g41/contour says where what it leaves out is to be had", async () => {
  const map = { imports: { "g41/contour": "./node_modules/g41/dist/contour.js" } };
  const leftOut = ["path.gcode()", "path.plan({})", "path.emit()"].map(
    (call) => `try { ${call}; } catch ({ code }) { codes.push(code); }`,
  );
  const home = project("contour", {
    "index.html": page(
      `<script type="module">import init, { check, compensate } from "g41/contour";
${program}
const codes = [];
${leftOut.join("\n")}
const wall = { start: [0, 0], segments: [{ kind: "line", to: [10, 0] }] };
const gouges = check(wall, compensate(wall, { side: "left", radius: 2 }), { radius: 2 });
document.querySelector("output").textContent = [...codes, gouges.length].join(" ");</script>`,
      `<script type="importmap">${JSON.stringify(map)}</script>`,
    ),
  });
  assert.equal(await shownBy(home), "not-supported not-supported not-supported 0");
});

test("g41/contour and g41 serve one page, in either order", async () => {
  const map = {
    imports: {
      g41: "./node_modules/g41/dist/web.js",
      "g41/contour": "./node_modules/g41/dist/contour.js",
    },
  };
  const home = project("both", {
    "index.html": page(
      `<script type="module">import initContour, { check, compensate, LiveContour } from "g41/contour";
import init, { parseProgram } from "g41";
const wall = { start: [0, 0], segments: [{ kind: "line", to: [10, 0] }] };
const options = { side: "left", radius: 2 };
const said = [];
const tell = (call) => { try { said.push(call()); } catch ({ code }) { said.push(code); } };
tell(() => compensate(wall, options));
await initContour();
const early = compensate(wall, options);
const live = new LiveContour(wall, options);
tell(() => parseProgram("G0 X1"));
await init();
await initContour();
const program = parseProgram("G41 D1 G1 X10 F100");
for (const path of [early, live.path(), compensate(wall, options)]) {
  tell(() => path.moves.length);
  tell(() => check(wall, path, { radius: 2 }).length);
  tell(() => typeof path.emit().text);
  tell(() => typeof check(program, path, { radius: 2 }).length);
  path[Symbol.dispose]?.();
}
tell(() => compensate(program, { radius: 2 }).moves.length);
document.querySelector("output").textContent = said.join(" ");</script>`,
      `<script type="importmap">${JSON.stringify(map)}</script>`,
    ),
  });
  // What was made before the whole was there lives on, and is refused what only the whole can do.
  const early = "1 0 not-supported not-supported";
  const expected = ["not-initialised", "not-supported", early, early, "1 0 string number", "1"];
  assert.equal(await shownBy(home), expected.join(" "));
});
