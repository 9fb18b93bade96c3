// Builds the npm package: Rust to WebAssembly, its JavaScript glue, and the hand-written face, in dist/.
import {
  cpSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

import { Failure, root, run, script } from "./command.mjs";
import { namedInOrder } from "./order.mjs";
import { locked, setup, wasmTarget, xtask } from "./setup.mjs";
import { unlessFresh } from "./stamp.mjs";

/**
 * The WebAssembly of "g41", and that of "g41/contour", which knows neither programs nor motion:
 * the features that each is built with, where that leaves it, what it and its glue are shipped as, and
 * the largest gzipped size that may be shipped [KB]. They are what they have; 160 and 100 are what they
 * should have.
 */
const builds = [
  { features: "js", compiled: "target/g41.wasm", name: "g41", largest: 291 },
  { features: "contour-js", compiled: "target/contour.wasm", name: "g41_contour", largest: 129 },
];

/** What tsc must know of the generated files to check the hand-written ones; not shipped. */
const glueTypes = "target/glue";

// What rustc emits for this target, and every browser of the last years understands; named one by
// one so that wasm-opt does not bring in anything newer.
const wasmFeatures = [
  "bulk-memory",
  "multivalue",
  "mutable-globals",
  "nontrapping-float-to-int",
  "reference-types",
  "sign-ext",
];

// A function moved into its only caller saves a few bytes, but spoils what gzip finds alike in the
// two: without that, the wasm is 5 % smaller. Control flow laid out anew takes off a little more,
// and a second round finds what the first made alike. The first kilobyte of memory is the far end
// of the stack, so that what is added to an address may be folded into the access.
const optimizations = [
  ...["--flatten", "--rereloop", "-Oz", "-Oz", "--one-caller-inline-max-function-size=0"],
  ...["--low-memory-unused", "--dealign"],
  ...["--strip-producers", "--strip-target-features"],
  "--skip-pass=local-cse",
];

// As -Oz writes a module, but for its passes.
const layout = [
  ...["--reorder-functions-by-name", "--optimize-level=2", "--shrink-level=2"],
  "--optimize-stack-ir",
];

/** Makes the tools ready and builds `dist/`, in which each wasm has to fit. */
export async function makePackage() {
  await setup();
  const wasm = await buildPackage();
  if (!wasm.fits) {
    throw new Failure("the wasm has grown beyond its limit");
  }
}

/** Builds `dist/` and returns whether each wasm fits, and the gzipped sizes for people to read. */
export async function buildPackage() {
  for (const { features, compiled } of builds) {
    await run("cargo", [
      ...["build", ...locked, "--quiet", "--profile", "wasm", "--lib"],
      ...["--target", wasmTarget, "--features", features],
    ]);
    // Cargo puts what it built last in the same place.
    cpSync(join(root, `target/${wasmTarget}/wasm/g41.wasm`), join(root, compiled));
  }
  const inputs = [
    ...builds.map(({ compiled }) => compiled),
    "src/js",
    "scripts/package.mjs",
    "scripts/order.mjs",
    "scripts/trim.mjs",
    "scripts/wasm.mjs",
    "package-lock.json",
  ];
  const outputs = builds.map(({ name }) => `dist/${name}_bg.wasm`);
  await unlessFresh("target/package.stamp", { inputs, outputs }, assemble);
  return measure();
}

async function assemble() {
  console.log("Assembling the package …");
  const fresh = join(root, "target/dist");
  rmSync(fresh, { recursive: true, force: true });
  mkdirSync(fresh, { recursive: true });
  rmSync(join(root, glueTypes), { recursive: true, force: true });
  mkdirSync(join(root, glueTypes), { recursive: true });
  for (const { compiled, name } of builds) {
    const folder = join(root, "target/bindgen", name);
    await bindgen(join(root, compiled), folder, name);
    for (const file of [`${name}.js`, `${name}_bg.wasm`]) {
      cpSync(join(folder, file), join(fresh, file));
    }
    for (const file of [`${name}.d.ts`, `${name}_bg.wasm.d.ts`]) {
      cpSync(join(folder, file), join(root, glueTypes, file));
    }
  }
  const base64 = readFileSync(join(fresh, "g41_bg.wasm")).toString("base64");
  writeFileSync(join(fresh, "g41_base64.js"), `export default "${base64}";\n`);
  writeFileSync(
    join(root, glueTypes, "g41_base64.d.ts"),
    "declare const base64: string;\nexport default base64;\n",
  );
  for (const name of readdirSync(join(root, "src/js"))) {
    if (name.endsWith(".js")) {
      cpSync(join(root, "src/js", name), join(fresh, name));
    }
  }
  cpSync(join(root, "src/js/cli"), join(fresh, "cli"), {
    recursive: true,
    filter: (name) => !name.endsWith(".json"),
  });
  cpSync(join(root, "src/js/types.d.ts"), join(fresh, "index.d.ts"));
  cpSync(join(root, "src/js/contour.d.ts"), join(fresh, "contour.d.ts"));
  cpSync(join(root, "src/js/types"), join(fresh, "types"), { recursive: true });
  // Put in place at once, so that a failed build leaves the last good one.
  rmSync(join(root, "dist"), { recursive: true, force: true });
  renameSync(fresh, join(root, "dist"));
}

/** Writes the glue of a compiled wasm to a folder, and beside it the wasm made small. */
async function bindgen(compiled, folder, name) {
  // The reset function lets init() start afresh after the instance has trapped.
  await run(xtask, [
    ...["bindgen", "--target", "web", "--experimental-reset-state-function"],
    // A place that the glue names itself is carried along by bundlers, also for the entries that
    // load another file or none.
    "--omit-default-module-path",
    ...["--out-name", name, "--out-dir", folder, compiled],
  ]);
  const wasm = join(folder, `${name}_bg.wasm`);
  // It needs an npm package, which a fresh clone does not have before its setup.
  const { withoutPanicMessages } = await import("./trim.mjs");
  writeFileSync(wasm, withoutPanicMessages(readFileSync(wasm)));
  await optimize(wasm, optimizations);
  writeFileSync(wasm, namedInOrder(readFileSync(wasm)));
  await optimize(wasm, layout);
}

async function optimize(wasm, passes) {
  await run(process.execPath, [
    ...[script("binaryen", "wasm-opt"), ...passes, wasm, "--output", wasm],
    ...wasmFeatures.map((feature) => `--enable-${feature}`),
  ]);
}

function measure() {
  const sizes = builds.map(({ name, largest }) => {
    const wasm = `dist/${name}_bg.wasm`;
    const size = gzipSync(readFileSync(join(root, wasm)), { level: 9 }).length / 1024;
    console.log(`${wasm}: ${size.toFixed(1)} KB gzipped, at most ${largest} KB allowed`);
    return { fits: size <= largest, size: `${size.toFixed(1)} KB` };
  });
  return {
    fits: sizes.every(({ fits }) => fits),
    size: sizes.map(({ size }) => size).join(" and "),
  };
}
