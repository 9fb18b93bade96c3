// node scripts/linuxcnc.mjs RS274 FROM TO: programs by seed, what LinuxCNC's interpreter makes of them, and
// whether the profile makes the same.
//
// RS274 is the interpreter as a command of its own (`bin/rs274` of LinuxCNC 2.9; where its libraries lie
// LD_LIBRARY_PATH may say). The programs and the moves it prints go to target/linuxcnc/printed.txt, in the form
// of tests/linuxcnc/outputs.txt.
import { spawnSync } from "node:child_process";
import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { Failure, main, root, run } from "./command.mjs";
import { INCH, Writer } from "./linuxcnc_programs.mjs";

const folder = join(root, "target/linuxcnc");

main(async () => {
  const [interpreter, from, to] = process.argv.slice(2);
  if (to === undefined) throw new Failure("usage: node scripts/linuxcnc.mjs RS274 FROM TO");
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, "mm.ini"), "[TRAJ]\nLINEAR_UNITS=mm\n[RS274NGC]\n");
  const cases = [];
  for (let seed = Number(from); seed < Number(to); seed++) {
    const { lines, tools } = new Writer(seed).program();
    cases.push(fixture(lines, tools, printed(interpreter, lines, tools)));
  }
  const file = join(folder, "printed.txt");
  writeFileSync(file, cases.join("\n"));
  const test = "a_file_of_programs_gives_what_linuxcnc_printed";
  const options = ["--ignored", "--nocapture"];
  await run("cargo", ["test", "--release", "--test", "linuxcnc", test, "--", ...options], {
    env: { G41_PRINTED: file },
  });
});

/** What the interpreter prints for a program, its errors behind the calls. */
function printed(interpreter, lines, tools) {
  // Run alone it reads the diameters of its table in inches.
  const row = ([number, diameter, orientation]) =>
    `T${number} P${number} D${(diameter / INCH).toFixed(12)} Q${orientation}\n`;
  rmSync(join(folder, "v.var"), { force: true });
  writeFileSync(join(folder, "v.var"), "5161 0\n");
  writeFileSync(join(folder, "t.tbl"), tools.map(row).join(""));
  writeFileSync(join(folder, "p.ngc"), `${lines.join("\n")}\n`);
  const args = ["-g", "-i", "mm.ini", "-t", "t.tbl", "-v", "v.var", "p.ngc"];
  const { stdout, stderr, error } = spawnSync(interpreter, args, {
    cwd: folder,
    encoding: "utf8",
    input: "",
    timeout: 20_000,
  });
  if (error) throw new Failure(`${interpreter}: ${error.message}`);
  if (!stdout.includes("ON_RESET")) throw new Failure(`${interpreter} does not run:\n${stderr}`);
  return `${stdout}\n${stderr}`;
}

/** A program and the moves among the calls, as the tests read them. */
function fixture(lines, tools, output) {
  const text = ["program", ...tools.map((tool) => `tool ${tool.join(" ")}`), ...lines, "gives"];
  const number = (value) => String(Number(Number(value).toFixed(4)) + 0);
  let [feed, told, perMinute, stop, plane] = ["0", "", true, "", "XY"];
  for (const line of output.split("\n")) {
    const call = /^ *\d+ +N\S* +([A-Z_]+)\((.*)\)\s*$/.exec(line);
    const block = /^\/?N(\d+)/.exec(line);
    if (!call && block) stop = block[1];
    if (!call) continue;
    const [, name, words] = call;
    const values = words.split(/, */);
    if (name === "SET_FEED_RATE") feed = number(words);
    if (name === "SET_FEED_MODE") perMinute = values[1] !== "1";
    let move = "";
    if (name === "STRAIGHT_TRAVERSE") move = `0 ${values.slice(0, 3).map(number).join(" ")}`;
    if (name === "STRAIGHT_FEED") move = `1 ${values.slice(0, 3).map(number).join(" ")}`;
    if (name === "ARC_FEED") {
      const [a, b, center, other, turns, height] = values;
      const place = plane === "XZ" ? [b, height, a] : [a, b, height];
      const times = Math.abs(Number(turns));
      move = `${Number(turns) > 0 ? 3 : 2} ${[...place, center, other].map(number).join(" ")}`;
      if (times > 1) move += ` P${times}`;
    }
    if (name === "SELECT_PLANE") plane = words.slice(-2);
    if (move === "") continue;
    if (!move.startsWith("0") && perMinute && feed !== told) {
      move += ` F${feed}`;
      told = feed;
    }
    text.push(move);
  }
  return `${[...text, ...(stop ? [`stops ${stop}`] : [])].join("\n")}\n`;
}
