// npm run bench: nanoseconds per type point beside other libraries, natively and as WebAssembly in
// Node, and bytes per type point. `npm run bench -- 1000` leaves out curves of more type points.
import { benchDrag } from "../benches/drag.mjs";
import { main, run } from "./command.mjs";
import { buildPackage } from "./package.mjs";
import { locked, setup, wasmTarget } from "./setup.mjs";

const offset = [...locked, "--quiet", "--bench", "offset"];
const peers = [...locked, "--quiet", "--package", "peers"];
const largest = process.argv.slice(2);

main(async () => {
  await setup();
  console.log("\nnative:");
  await run("cargo", ["bench", ...offset]);
  await run("cargo", ["bench", ...peers, "--bench", "race", "--", ...largest]);
  await run("cargo", ["bench", ...peers, "--bench", "memory"]);
  await run("cargo", ["bench", ...peers, "--bench", "convert"]);
  console.log("\nWebAssembly in Node:");
  // As tests, since the runner has no clock of its own to benchmark with.
  const asTest = ["--target", wasmTarget, "--", "--nocapture"];
  await run("cargo", ["test", "--release", ...offset, ...asTest]);
  await run("cargo", ["test", "--release", ...peers, "--bench", "race", ...asTest]);
  await run("cargo", ["test", "--release", ...peers, "--bench", "convert", ...asTest]);
  await buildPackage();
  await benchDrag();
});
