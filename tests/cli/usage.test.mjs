// How the command is called: help, versions, wrong options with a hint, messages, the bar.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { Bar } from "../../dist/cli/bar.js";
import { root } from "../../scripts/command.mjs";
import { corner, installed } from "./command.mjs";

const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));

const { g41, path, write } = installed({
  "part.ngc": corner,
  "wrong.ngc": "G1 X5 F100 Q\n(\u001b[31mred)\nG1 X9 \u001b\n",
});

test("--help tells the commands, the options and the exit codes, on standard output", async () => {
  for (const args of [["--help"], ["-h"]]) {
    const { code, out } = await g41(args);
    assert.equal(code, 0);
    assert.match(out, /^Usage: g41 COMMAND/);
    assert.match(out, /^ {2}convert .*\n.*\n? {2}check/ms);
  }
  for (const command of ["convert", "check", "plan"]) {
    const { code, out, err } = await g41([command, "--help"]);
    assert.deepEqual([code, err], [0, ""]);
    for (const option of ["--from", "--radius", "--tool", "--tool-table", "--profile", "--gouge"]) {
      assert.ok(out.includes(`  ${option} `), `${command} ${option}`);
    }
    for (const code of [0, 1, 2, 3, 4]) {
      assert.match(out, new RegExp(`^ {2}${code} {2}\\w`, "m"));
    }
    assert.ok(
      out.split("\n").every((line) => line.length <= 88),
      "no line is too long to read",
    );
  }
  assert.match((await g41(["convert", "--help"])).out, /--json.*\n.*-o, --output OUT/s);
});

test("--version prints the version", async () => {
  for (const args of [["--version"], ["-V"], ["check", "--version"]]) {
    assert.deepEqual(await g41(args), { code: 0, out: `${version}\n`, err: "" });
  }
});

test("wrong use ends with exit code 2, says what is wrong, and guesses what was meant", async () => {
  for (const [args, says, hint] of [
    [[], /a command is missing/, /g41 convert FILE/],
    [["conver", "part.ngc"], /conver: there is no such command/, /did you mean g41 convert\?/],
    [["convert"], /the program is missing/, /standard input/],
    [["convert", "part.ngc", "other.ngc"], /other\.ngc: one program at a time/, /g41 convert FILE/],
    [["check"], /the program is missing/, /g41 check FILE/],
    [["convert", "part.ngc", "--raduis", "3"], /--raduis: there is no such option/, /--radius\?/],
    [["convert", "part.ngc", "--tooltable=x"], /--tooltable: there/, /--tool-table\?/],
    [["convert", "part.ngc", "--zzzzzz"], /--zzzzzz: there/, /g41 convert --help/],
    [["check", "part.ngc", "--explain"], /--explain: there is no such option/, /--help/],
    [["convert", "part.ngc", "-x"], /-x: there is no such option/, /--help/],
    [["convert", "part.ngc", "--radius"], /--radius needs a value: --radius R/],
    [["convert", "part.ngc", "--radius", "--json"], /--radius needs a value/],
    [["convert", "part.ngc", "-o", "--json"], /-o needs a value/],
    [["convert", "part.ngc", "--radius", "3mm"], /--radius must be a number, not "3mm"/],
    [["convert", "part.ngc", "--radius", "0x10"], /--radius must be a number/],
    [["convert", "part.ngc", "--json=yes"], /--json takes no value/],
    [
      ["convert", "part.ngc", "--corner", "arcs"],
      /--corner must be one of linear, arc/,
      /mean arc\?/,
    ],
    [
      ["convert", "part.ngc", "--profile", "linux"],
      /--profile must be one of g41,/,
      /mean linuxcnc\?/,
    ],
    [["convert", "part.ngc", "--passes", "some"], /--passes must be a number or all, not "some"/],
    [["convert", "part.ngc", "--passes", "2"], /--gouge must be "avoid"/],
    [["convert", "part.ngc", "--passes=all", "--gouge=avoid"], /--stepover must be given/],
    [["convert", "part.ngc", "--tangent-band", "4"], /--tangent-band must be "auto", or/],
    [["convert", "part.ngc", "--curves", "lines"], /--curves must be one of cubics, arcs/],
    [["convert", "part.ngc", "--curve-tolerance", "0"], /--curve-tolerance must be at least/],
    [["convert", "part.ngc", "--keep-compensation", "--radius", "3"], /--radius is for a path/],
    [["convert", "part.ngc", "--keep-compensation", "--json"], /--json is for a path/],
    [["convert", "part.ngc", "--json", "--explain"], /--explain is for a program, which --json/],
    [["convert", "part.ngc", "--json", "--to", "marlin"], /--to is for a program/],
    [
      ["plan", "part.ngc", "--limits=velocity=9,acceleration=9,jerk=9", "--csv=-"],
      /--csv needs a file/,
    ],
    [["convert", "part.ngc", "--to", "gbrl"], /--to must be one of/, /mean grbl\?/],
    [["convert", "part.ngc", "--tool", "3"], /--tool must be D=R/],
    [["convert", "part.ngc", "--tool", "1=3,5"], /--tool must be D=R/],
    [["convert", "part.ngc", "--tolerance", "0"], /--tolerance must be at least/],
    [["convert", "part.ngc", "--feed", "-5"], /--feed must be greater than 0/],
    [["convert", "part.ngc", "--radius", "1e9"], /--radius must be at most 1e7 mm/],
  ]) {
    const { code, out, err } = await g41(args);
    assert.deepEqual([code, out], [2, ""], `${args.join(" ")}\n${err}`);
    assert.match(err, /^g41: error: /);
    assert.match(err, says);
    if (hint) {
      assert.match(err, hint);
    }
  }
});

test("what is found is told as FILE:LINE:COLUMN, without what would steer a terminal", async () => {
  const { code, err } = await g41(["convert", "wrong.ngc"], { env: { FORCE_COLOR: "1" } });
  assert.equal(code, 1);
  assert.match(err, /^wrong\.ngc:1:12: error: .+ \([a-z-]+\)$/m);
  assert.match(err, /^wrong\.ngc:3:\d+: /m);
  // biome-ignore lint/suspicious/noControlCharactersInRegex: they are what is looked for
  assert.doesNotMatch(err, /[\x00-\x09\x0b-\x1f]/);
});

test("the bar tells the part of all steps that is done, guesses, and is taken away at the end", () => {
  const written = [];
  const steps = [
    ["reading", 1],
    ["writing", 3],
  ];
  const bar = new Bar((text) => written.push(text), steps);
  bar.next();
  bar.next();
  bar.part(0.5);
  bar.part(0.5);
  bar.guess(3 * Math.LN2);
  bar.guess(1e9);
  bar.end();
  assert.deepEqual(
    written.map((text) => text.match(/\[(#*)\.*\] (\d+) % (\w+)$/)?.slice(1)),
    [
      ["", "0", "reading"],
      ["########", "25", "writing"],
      ["###################", "62", "writing"],
      ["##############################", "100", "writing"],
      undefined,
    ],
  );
  assert.equal(written.at(-1), "\r\u001b[K");
});

const terminal = spawnSync("script", ["--version"]).error === undefined;

test("the bar is drawn while long work goes on, on a terminal only", {
  skip: !terminal,
}, async () => {
  const lines = Array.from({ length: 60_000 }, (_, i) => `G1 X${i} Y${i % 7} F100`);
  write("long.ngc", lines.join("\n"));
  const node = `"${process.execPath}" "${path("node_modules/g41/dist/cli.js")}"`;
  const run = `${node} convert "${path("long.ngc")}" --output "${path("long.nc")}"`;
  const { stdout } = spawnSync("script", ["-qec", run, "/dev/null"], { encoding: "utf8" });
  assert.match(stdout, /\[#*\.*\] \d+ % writing/);
  assert.ok(stdout.endsWith("\r\u001b[K"), JSON.stringify(stdout.slice(-80)));
  const plain = await g41(["convert", "long.ngc", "-o", "long.nc"]);
  assert.deepEqual(plain, { code: 0, out: "", err: "" });
});
