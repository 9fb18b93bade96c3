// Checks for Rust, Node and npm, and installs what else the build needs, all of it without root.
import { existsSync } from "node:fs";
import { join } from "node:path";

import { ask, Failure, npm, root, run } from "./command.mjs";
import { unlessFresh } from "./stamp.mjs";

export const wasmTarget = "wasm32-unknown-unknown";

/** The program that holds the pinned wasm-bindgen. */
export const xtask = join(
  root,
  "target/debug",
  process.platform === "win32" ? "xtask.exe" : "xtask",
);

/** In continuous integration a lock file that does not fit is an error, elsewhere it is updated. */
export const locked = process.env.CI ? ["--locked"] : [];

/** Makes the tools ready: the wasm target, the npm packages and the pinned wasm-bindgen. */
export async function setup() {
  checkNode();
  checkRust();
  await installWasmTarget();
  await installPackages();
  await run("cargo", ["build", ...locked, "--quiet", "--package", "xtask"]);
}

function checkNode() {
  const [major, minor] = process.versions.node.split(".").map(Number);
  if (major < 20 || (major === 20 && minor < 19)) {
    throw new Failure(`Node ${process.versions.node} is too old: 20.19 or newer is needed.`);
  }
}

function checkRust() {
  const version = ask("cargo", ["--version"]);
  if (!version) {
    throw new Failure("cargo was not found: install stable Rust with rustup, https://rustup.rs.");
  }
  const [, major, minor] = version.match(/(\d+)\.(\d+)/).map(Number);
  if (major === 1 && minor < 88) {
    throw new Failure(`${version} is too old: 1.88 or newer is needed (rustup update stable).`);
  }
}

async function installWasmTarget() {
  const sysroot = ask("rustc", ["--print", "sysroot"]);
  if (existsSync(join(sysroot, "lib/rustlib", wasmTarget))) {
    return;
  }
  if (!ask("rustup", ["--version"])) {
    throw new Failure(
      `Rust's target ${wasmTarget} is missing, and so is rustup, which installs it.`,
    );
  }
  await run("rustup", ["target", "add", wasmTarget]);
}

async function installPackages() {
  const stamp = "node_modules/.g41-installed";
  const inputs = ["package.json", "package-lock.json"];
  await unlessFresh(stamp, { inputs, outputs: ["node_modules"] }, async () => {
    console.log("Installing the npm packages …");
    await npm(["ci", "--no-audit", "--no-fund"]);
  });
}
