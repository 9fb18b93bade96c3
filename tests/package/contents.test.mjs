// The packed package holds what it should, and its types fit every way of importing it.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { publint } from "publint";
import { formatMessage } from "publint/utils";

import { script } from "../../scripts/command.mjs";
import { packed, program, runNode } from "./consumer.mjs";

const project = packed();

const compilerOptions = {
  target: "es2022",
  lib: ["es2022"],
  types: [],
  strict: true,
  // The package must not lean on the libraries that its user happens to load.
  skipLibCheck: false,
  noEmit: true,
};

for (const [module, moduleResolution] of [
  ["nodenext", "nodenext"],
  ["esnext", "bundler"],
]) {
  test(`the types are sound for ${moduleResolution}`, async () => {
    const home = project(`types-${moduleResolution}`, {
      "package.json": `{ "type": "module" }`,
      "main.ts": `import init, { check, compensate, type ContourOptions, type Gouge } from "g41";
import same from "g41/inline";
import less, { flatten } from "g41/contour";
${program}
export const text: string = answer;
const options: ContourOptions = { side: "left", radius: 2, gouge: "avoid" };
const wall = { start: [0, 0], segments: [{ kind: "line", to: [10, 0] }] } as const;
const avoided = compensate(wall, options);
export const outlines: Float64Array[] = avoided.uncut.map(({ outline }) => outline);
export const gouges: Gouge[] = check(wall, avoided, { radius: 2 });
export const code: string = avoided.gcode({ feed: 300, clearance: 5 });
// @ts-expect-error: a policy that does not exist is found
compensate(wall, { ...options, gouge: "ignore" });
// @ts-expect-error: the judge wants a path, not its moves
check(wall, avoided.moves, { radius: 2 });
// @ts-expect-error: a misspelt function is found
init.nothing();
export const inits: (typeof init)[] = [init, same, less];
export const drawn: Float64Array = flatten(wall).points;`,
      "tsconfig.json": JSON.stringify({
        compilerOptions: { ...compilerOptions, module, moduleResolution },
      }),
    });
    await runNode(home, script("typescript", "tsc"));
  });
}

test("the types export all that their files declare", () => {
  const folder = join(project("exported", {}), "node_modules/g41/dist");
  const declared = readdirSync(join(folder, "types")).flatMap((name) => {
    const text = readFileSync(join(folder, "types", name), "utf8");
    return [...text.matchAll(/^export (?!default)\w+ (\w+)/gm)].map(([, found]) => found);
  });
  // What the whole has on top of contours, and contours.
  const faces = ["index.d.ts", "contour.d.ts"].map((name) =>
    readFileSync(join(folder, name), "utf8"),
  );
  const lists = [...faces.join("").matchAll(/export \{(.*?)\}/gs)].map(([, list]) =>
    list.split(","),
  );
  const exported = lists.flat().map((entry) => entry.trim().replace("type ", ""));
  assert.deepEqual(
    exported.filter((name) => name && name !== "default").sort(),
    [...new Set(declared)].sort(),
  );
});

test("tools that do not know exports find the same files", () => {
  const folder = join(project("fields", {}), "node_modules/g41");
  const manifest = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const { node, browser, types } = manifest.exports["."];
  const fields = [manifest.main, manifest.module, manifest.types];
  assert.deepEqual(fields, [node, browser, types], "main, module and types");
});

test("publint finds nothing to improve", async () => {
  const home = project("publint", {});
  const pkgDir = join(home, "node_modules/g41");
  const { messages, pkg } = await publint({ pkgDir, pack: false });
  assert.deepEqual(
    messages.map((message) => formatMessage(message, pkg)),
    [],
  );
});

test("the package holds its files and nothing of the workshop", () => {
  const home = project("contents", {});
  const names = readdirSync(join(home, "node_modules/g41"));
  assert.deepEqual(names.sort(), [
    "CHANGELOG.md",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "README.md",
    "dist",
    "package.json",
  ]);
});
