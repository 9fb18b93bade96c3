// npm test: builds what npm start builds, then runs every check and every test, and counts them.
import { mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";

import { browserFlags, provideBrowser } from "./browser.mjs";
import { main, observe, root, script } from "./command.mjs";
import { buildPackage } from "./package.mjs";
import { buildPage } from "./page.mjs";
import { locked, setup, wasmTarget } from "./setup.mjs";
import { record, recordCheck, report } from "./tally.mjs";

const node = process.execPath;
const strict = { RUSTDOCFLAGS: "-D warnings" };
const cargoTest = ["test", ...locked, "--no-fail-fast"];
// All but the comparisons with other libraries, which take a while to compile.
const core = ["--workspace", "--exclude", "peers"];
const onWasm = ["--target", wasmTarget, "--features", "js"];

main(async () => {
  await setup();
  const { browser, driver } = await provideBrowser();
  const wasm = await buildPackage();
  recordCheck("checks", wasm.fits);
  await buildPage();

  await check("formatting (rustfmt)", "cargo", ["fmt", "--all", "--check"]);
  await check("lints (clippy, native)", "cargo", clippy(...core, "--all-targets"));
  await check("lints (clippy, wasm)", "cargo", clippy("--all-targets", ...onWasm));
  const contours = ["--lib", "--target", wasmTarget, "--features", "contour-js"];
  await check("lints (clippy, contours alone)", "cargo", clippy(...contours));
  await check("documentation", "cargo", ["doc", ...locked, "--quiet", "--no-deps"], strict);
  await check("formatting and lints (Biome)", node, [
    script("@biomejs/biome", "biome"),
    "ci",
    "--error-on-warnings",
    ".",
  ]);

  await tests("native", "cargo", "cargo", [...cargoTest, "--features", "js"]);
  // After the native tests, which write samples of what crosses the boundary for it to check.
  await check("types of page and samples (tsc)", node, [script("typescript", "tsc")]);
  await check("types of the face (tsc)", node, [script("typescript", "tsc"), "-p", "src/js"]);
  const command = [script("typescript", "tsc"), "-p", "src/js/cli"];
  await check("types of the command line (tsc)", node, command);
  const inWasm = [...cargoTest, ...onWasm, "--test", "*"];
  await tests("wasm in Node", "cargo", "cargo", inWasm);
  await tests("wasm in browser", "cargo", "cargo", inWasm, {
    WASM_BINDGEN_USE_BROWSER: "1",
    // Seconds: a busy machine is slow to start a browser, and seeded tests run for long.
    WASM_BINDGEN_TEST_DRIVER_TIMEOUT: "60",
    WASM_BINDGEN_TEST_TIMEOUT: "600",
    WASM_BINDGEN_TEST_WEBDRIVER_JSON: webdriverOptions(browser),
    CHROMEDRIVER: driver,
  });
  const apiTests = ["--test", "--test-reporter=spec", ...filesIn("tests/api", ".test.mjs")];
  await tests("public face", "node", node, apiTests);
  const packageTests = ["--test", "--test-reporter=spec", ...filesIn("tests/package", ".test.mjs")];
  await tests("package", "node", node, packageTests, { CHROME_PATH: browser });
  const cliTests = ["--test", "--test-reporter=spec", ...filesIn("tests/cli", ".test.mjs")];
  await tests("command line", "node", node, cliTests);
  const pageTests = [script("@playwright/test", "playwright"), "test"];
  const port = String(await freePort());
  await tests("page", "playwright", node, pageTests, { CHROME_PATH: browser, G41_TEST_PORT: port });

  if (report([["wasm, gzipped", wasm.size.padStart(8)]]) > 0) {
    process.exitCode = 1;
  }
});

function clippy(...what) {
  return ["clippy", ...locked, "--quiet", ...what, "--", "-D", "warnings"];
}

async function check(title, program, args, env) {
  console.log(`\n--- ${title}`);
  const { code } = await observe(program, args, { env });
  recordCheck("checks", code === 0);
}

async function tests(row, counter, program, args, env) {
  console.log(`\n--- tests: ${row}`);
  record(row, counter, await observe(program, args, { env }));
}

/** A port that nobody uses, so that two runs on one machine do not meet. */
function freePort() {
  const server = createServer();
  return new Promise((resolve) => {
    server.listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/** Named one by one, since Node's versions differ in what they take a folder to mean. */
function filesIn(folder, ending) {
  const names = readdirSync(join(root, folder)).filter((name) => name.endsWith(ending));
  return names.map((name) => `${folder}/${name}`);
}

/** Tells the driver which browser to start, and how; returns the path of the file. */
function webdriverOptions(browser) {
  const file = join(root, "target/webdriver.json");
  mkdirSync(join(root, "target"), { recursive: true });
  const args = ["--headless=new", ...browserFlags];
  writeFileSync(file, JSON.stringify({ "goog:chromeOptions": { binary: browser, args } }));
  return file;
}
