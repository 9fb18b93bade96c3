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

import { root, run, script } from "./command.mjs";
import { namedInOrder } from "./order.mjs";
import { locked, wasmTarget, xtask } from "./setup.mjs";
import { unlessFresh } from "./stamp.mjs";

const compiled = `target/${wasmTarget}/wasm/g41.wasm`;
const shipped = "dist/g41_bg.wasm";

/** What tsc must know of the generated files to check the hand-written ones; not shipped. */
const glueTypes = "target/glue";

/** The largest gzipped wasm that may be shipped [bytes]: what it has; 160 KB is what it should have. */
const sizeLimit = 262 * 1024;

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

/** Builds `dist/` and returns whether the wasm fits, and its gzipped size for people to read. */
export async function buildPackage() {
  await run("cargo", [
    ...["build", ...locked, "--quiet", "--profile", "wasm", "--lib"],
    ...["--target", wasmTarget, "--features", "js"],
  ]);
  const inputs = [
    compiled,
    "src/js",
    "scripts/package.mjs",
    "scripts/order.mjs",
    "scripts/trim.mjs",
    "scripts/wasm.mjs",
    "package-lock.json",
  ];
  await unlessFresh("target/package.stamp", { inputs, outputs: [shipped] }, assemble);
  return measure();
}

async function assemble() {
  console.log("Assembling the package …");
  const fresh = join(root, "target/dist");
  rmSync(fresh, { recursive: true, force: true });
  mkdirSync(fresh, { recursive: true });
  rmSync(join(root, glueTypes), { recursive: true, force: true });
  mkdirSync(join(root, glueTypes), { recursive: true });
  // The reset function lets init() start afresh after the instance has trapped.
  await run(xtask, [
    ...["bindgen", "--target", "web", "--experimental-reset-state-function"],
    ...["--out-name", "g41", "--out-dir", fresh, join(root, compiled)],
  ]);
  for (const name of readdirSync(fresh).filter((name) => name.endsWith(".d.ts"))) {
    renameSync(join(fresh, name), join(root, glueTypes, name));
  }
  const wasm = join(fresh, "g41_bg.wasm");
  // It needs an npm package, which a fresh clone does not have before its setup.
  const { withoutPanicMessages } = await import("./trim.mjs");
  writeFileSync(wasm, withoutPanicMessages(readFileSync(wasm)));
  await optimize(wasm, optimizations);
  writeFileSync(wasm, namedInOrder(readFileSync(wasm)));
  await optimize(wasm, layout);
  const base64 = readFileSync(wasm).toString("base64");
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
  cpSync(join(root, "src/js/types"), join(fresh, "types"), { recursive: true });
  // Put in place at once, so that a failed build leaves the last good one.
  rmSync(join(root, "dist"), { recursive: true, force: true });
  renameSync(fresh, join(root, "dist"));
}

async function optimize(wasm, passes) {
  await run(process.execPath, [
    ...[script("binaryen", "wasm-opt"), ...passes, wasm, "--output", wasm],
    ...wasmFeatures.map((feature) => `--enable-${feature}`),
  ]);
}

function measure() {
  const bytes = gzipSync(readFileSync(join(root, shipped)), { level: 9 }).length;
  const size = kilobytes(bytes);
  console.log(`${shipped}: ${size} gzipped, at most ${kilobytes(sizeLimit)} allowed`);
  return { fits: bytes <= sizeLimit, size };
}

function kilobytes(bytes) {
  return `${(bytes / 1024).toFixed(1)} KB`;
}
