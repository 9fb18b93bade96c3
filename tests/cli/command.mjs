// Runs the command g41 as somebody who has installed the packed package does.
import { spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { root } from "../../scripts/command.mjs";
import { packed } from "../package/consumer.mjs";

/** A lead-in along X, 40 mm up, a corner to the right, 30 mm along X, a lead-out up; the tool is left. */
export const corner = "G0 X-20 Y0\nG1 G41 D1 X0 Y0 F300\nY40\nX30\nG40 Y60\nM30\n";

/**
 * Where the tool centre goes at that corner: the lead-in and the lead-out are inside corners, cut
 * short beside the ends of the contour; the outside corner of 90° is where both offsets meet.
 */
export const centres = (r) => [
  [-20, 0],
  [-r, 0],
  [-r, 40 + r],
  [30, 40 + r],
  [30, 60],
];

/** A project with the package and some files, made once for a test file. */
export function installed(files = {}) {
  const project = packed();
  let made;
  const home = () => {
    made ??= project("cli", files);
    return made;
  };

  return {
    /** The path of a file of the project. */
    path: (name) => join(home(), name),
    read: (name) => readFileSync(join(home(), name), "utf8"),
    write: (name, text) => writeFileSync(join(home(), name), text),
    /** Runs the command and returns its exit code, and what it wrote where. */
    g41: (args, { input = "", env = {} } = {}) => {
      const command = join(home(), "node_modules/g41/dist/cli.js");
      return finished(
        spawn(process.execPath, [command, ...args], {
          cwd: home(),
          env: { ...process.env, ...env },
        }),
        input,
      );
    },
    home,
  };
}

/** A program of tests/programs. */
export function sample(name) {
  return readFileSync(join(root, "tests/programs", name), "utf8");
}

/** The points that a written program states by X and Y, one after the other. */
export function pointsOf(text) {
  const at = [0, 0];
  const points = [];
  for (const line of text.split("\n")) {
    const words = [...line.replace(/\(.*?\)|;.*/g, "").matchAll(/([XY])(-?[\d.]+)/g)];
    for (const [, letter, value] of words) {
      at["XY".indexOf(letter)] = Number(value);
    }
    if (words.length > 0) {
      points.push([...at]);
    }
  }
  return points;
}

function finished(child, input) {
  return new Promise((resolve, reject) => {
    const written = { out: "", err: "" };
    for (const [name, stream] of [
      ["out", child.stdout],
      ["err", child.stderr],
    ]) {
      stream.setEncoding("latin1").on("data", (text) => {
        written[name] += text;
      });
    }
    // What a command that ends early does not read is no matter.
    child.stdin.on("error", () => {});
    child.stdin.end(input);
    child.on("error", reject);
    child.on("close", (code) => {
      const [out, err] = [written.out, written.err].map((text) =>
        Buffer.from(text, "latin1").toString("utf8"),
      );
      resolve({ code, out, err });
    });
  });
}
