// Runs the programs that building and testing need, and says which one failed.
import { spawn, spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("..", import.meta.url));

// The scripts look for what cargo builds, so its place must not depend on the user's settings.
process.env.CARGO_TARGET_DIR = join(root, "target");

/** A failure that the user can act on: printed without a stack trace. */
export class Failure extends Error {}

/** Runs a program to its end with its output shown; throws a `Failure` unless it succeeds. */
export async function run(program, args, options = {}) {
  const { code } = await observe(program, args, options);
  if (code !== 0) {
    throw new Failure(`${[program, ...args].join(" ")}\nended with exit code ${code}`);
  }
}

/** Runs a program to its end; its output is shown and returned. */
export function observe(program, args, { env = {}, cwd = root } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: ["ignore", "pipe", "pipe"],
    });
    let output = "";
    for (const [stream, sink] of [
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ]) {
      stream.setEncoding("utf8").on("data", (text) => {
        output += text;
        sink.write(text);
      });
    }
    child.on("error", (error) => reject(new Failure(`cannot run ${program}: ${error.message}`)));
    child.on("close", (code) => resolve({ code, output }));
  });
}

/** The output of a program, or undefined where it is missing or fails. */
export function ask(program, args) {
  const { status, stdout } = spawnSync(program, args, { cwd: root, encoding: "utf8" });
  return status === 0 ? stdout.trim() : undefined;
}

/** The path of the script behind a command of an installed package, to be run by Node: the shims
 * in `node_modules/.bin` differ from system to system. */
export function script(packageName, command = packageName) {
  const folder = join(root, "node_modules", packageName);
  const { bin } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  return join(folder, typeof bin === "string" ? bin : bin[command]);
}

/** Runs npm with the arguments given. */
export function npm(args, options) {
  const beside = join(dirname(process.execPath), "node_modules", "npm", "bin", "npm-cli.js");
  // npm names itself to the scripts it runs; a script that is run by hand asks the shell instead.
  const cli = process.env.npm_execpath ?? (existsSync(beside) ? beside : undefined);
  return cli ? run(process.execPath, [cli, ...args], options) : run("npm", args, options);
}

/** Runs the main function of a script; a `Failure` is printed plainly and ends with exit code 1. */
export async function main(work) {
  try {
    await work();
  } catch (error) {
    console.error(`\n${error instanceof Failure ? error.message : error.stack}`);
    process.exitCode = 1;
  }
}
