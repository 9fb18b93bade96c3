// Makes empty projects outside the repository that use the packed package as anybody would.
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before } from "node:test";

import { chromium } from "@playwright/test";

import { browserFlags, findBrowser } from "../../scripts/browser.mjs";
import { npm, observe, root } from "../../scripts/command.mjs";
import { serve } from "../../scripts/page.mjs";

const manifest = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));

/** What a project says with the package: the tool cuts a corner short on its inside. */
export const program = `await init();
const path = compensate(
  { start: [0, 0], segments: [{ kind: "line", to: [10, 0] }, { kind: "line", to: [10, 10] }] },
  { side: "left", radius: 2 },
);
const answer = path.polyline().join(" ");`;
export const answer = "0 2 8 2 8 10";

/** Packs the package once for a test file; the function returned makes a project with it. */
export function packed() {
  let folder;
  before(async () => {
    folder = mkdtempSync(join(tmpdir(), "g41-"));
    write(folder, { "package.json": "{}" });
    // What is in dist/ is packed as it is: it was built before the tests.
    await npm(["pack", "--silent", "--ignore-scripts", "--pack-destination", folder]);
    await npm(["install", "--silent", "--offline", `./g41-${manifest.version}.tgz`], {
      cwd: folder,
    });
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  return function project(name, files) {
    const home = join(folder, name);
    // The link of the package's command stays as it is: it points to within what is copied.
    const options = { recursive: true, verbatimSymlinks: true };
    cpSync(join(folder, "node_modules"), join(home, "node_modules"), options);
    write(home, { "package.json": "{}", ...files });
    return home;
  };
}

/** Runs a file of a project with Node and returns what it printed. */
export async function runNode(home, ...args) {
  const { code, output } = await observe(process.execPath, args, { cwd: home });
  if (code !== 0) {
    throw new Error(`node ${args.join(" ")} ended with exit code ${code}:\n${output}`);
  }
  return output.trim();
}

/** Opens a folder of static files in the browser and returns the text that it comes to show. */
export async function shownBy(folder) {
  const { url, close } = await serve(folder, 0);
  const browser = await chromium.launch({ executablePath: findBrowser(), args: browserFlags });
  try {
    const page = await browser.newPage();
    const problems = [];
    page.on("pageerror", (error) => problems.push(error.message));
    page.on("requestfailed", (request) => problems.push(`failed: ${request.url()}`));
    await page.goto(url);
    const text = page.locator("output:not(:empty)");
    await text.waitFor({ timeout: 10_000 }).catch(() => {
      throw new Error(`nothing shown: ${problems.join("; ")}`);
    });
    return await text.textContent();
  } finally {
    await browser.close();
    await close();
  }
}

/** A page with a module script, and `head` before it. */
export function page(scriptTag, head = "") {
  return `<!doctype html><title>g41</title>${head}<output></output>${scriptTag}`;
}

function write(home, files) {
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(dirname(join(home, name)), { recursive: true });
    writeFileSync(join(home, name), text);
  }
}
