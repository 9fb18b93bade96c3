// npm run bench: nanoseconds per type point, natively and as WebAssembly in Node.
import { main, run } from "./command.mjs";
import { locked, setup, wasmTarget } from "./setup.mjs";

const bench = [...locked, "--quiet", "--bench", "offset"];

main(async () => {
  await setup();
  console.log("\nnative:");
  await run("cargo", ["bench", ...bench]);
  console.log("\nWebAssembly in Node:");
  // As a test, since the runner has no clock of its own to benchmark with.
  await run("cargo", ["test", "--release", ...bench, "--target", wasmTarget, "--", "--nocapture"]);
});
