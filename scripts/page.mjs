// Builds the page in www/ with the package from dist/, and serves folders of static files.
import { readdirSync } from "node:fs";
import { join } from "node:path";

import { root, run, script } from "./command.mjs";
import { unlessFresh } from "./stamp.mjs";

/** Builds `www/dist/` if anything it is made of has changed. */
export async function buildPage() {
  const built = readdirSync(join(root, "dist")).map((name) => `dist/${name}`);
  const inputs = ["www", ...built, "vite.config.js", "package.json", "package-lock.json"];
  await unlessFresh("target/page.stamp", { inputs, outputs: ["www/dist/index.html"] }, async () => {
    console.log("Building the page …");
    await run(process.execPath, [script("vite"), "build", "--logLevel", "warn"]);
  });
}

/** Serves a folder on a port (0: any free one) of this machine; returns its address and `close`. */
export async function serve(folder, port) {
  const { preview } = await import("vite");
  const server = await preview({
    configFile: false,
    logLevel: "error",
    appType: "mpa",
    root: folder,
    build: { outDir: "." },
    preview: { host: "127.0.0.1", port, strictPort: port !== 0 },
  });
  const address = server.httpServer.address();
  return { url: `http://127.0.0.1:${address.port}/`, close: () => server.close() };
}
