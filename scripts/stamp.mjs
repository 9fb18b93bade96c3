// Skips a step of the build while its inputs and outputs are what they were when it last succeeded.
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { root } from "./command.mjs";

const ignored = new Set(["node_modules", "dist", "target", ".git"]);

/** Runs `work` unless the files under `inputs` are unchanged and all `outputs` exist. */
export async function unlessFresh(stamp, { inputs, outputs }, work) {
  const file = join(root, stamp);
  const digest = digestOf(inputs);
  const recorded = existsSync(file) ? readFileSync(file, "utf8") : "";
  if (recorded === digest && outputs.every((output) => existsSync(join(root, output)))) {
    return;
  }
  await work();
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, digest);
}

function digestOf(inputs) {
  const hash = createHash("sha256").update(process.version);
  for (const input of inputs) {
    for (const path of filesUnder(input)) {
      hash.update(`\0${path}\0`).update(readFileSync(join(root, path)));
    }
  }
  return hash.digest("hex");
}

function filesUnder(path) {
  if (!statSync(join(root, path)).isDirectory()) {
    return [path];
  }
  return readdirSync(join(root, path))
    .filter((name) => !ignored.has(name))
    .sort()
    .flatMap((name) => filesUnder(`${path}/${name}`));
}
