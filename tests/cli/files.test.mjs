// What is read and written: results that appear whole or not at all, inputs that stay as they are.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import {
  chmodSync,
  closeSync,
  existsSync,
  linkSync,
  openSync,
  readdirSync,
  readFileSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { test } from "node:test";

import { centres, corner, installed, pointsOf } from "./command.mjs";

const { g41, read, write, path, home } = installed({
  "part.ngc": corner,
  "tools.tbl": "T1 P1 D6\n",
});

const radius = ["--radius", "3"];

const command = () => path("node_modules/g41/dist/cli.js");

/** A program whose JSON takes a while. */
const long = Array.from({ length: 20_000 }, (_, i) => `G1 X${i} Y${i % 7} F100\n`).join("");

/** How a process ends, and what it says to that. */
async function ended(child) {
  let errors = "";
  child.stderr.setEncoding("utf8").on("data", (text) => {
    errors += text;
  });
  const code = await new Promise((resolve) => child.on("close", resolve));
  return { code, errors };
}

test("-o writes the file, and leaves nothing else behind", async () => {
  const before = readdirSync(home());
  const { code, out } = await g41(["convert", "part.ngc", ...radius, "-o", "out.nc"]);
  assert.deepEqual([code, out], [0, ""]);
  assert.deepEqual(pointsOf(read("out.nc")), centres(3));
  assert.deepEqual(readdirSync(home()).sort(), [...before, "out.nc"].sort());
});

test("a file that is there is replaced, keeps its rights, and a link stays a link", async () => {
  write("old.nc", "old");
  chmodSync(path("old.nc"), 0o640);
  symlinkSync("old.nc", path("link.nc"));
  const { code } = await g41(["convert", "part.ngc", ...radius, "--output", "link.nc"]);
  assert.equal(code, 0);
  assert.deepEqual(pointsOf(read("old.nc")), centres(3), "through the link");
  if (process.platform !== "win32") {
    assert.equal(statSync(path("old.nc")).mode & 0o777, 0o640);
  }
});

test("what is read is never overwritten, by whatever name", async () => {
  linkSync(path("part.ngc"), path("hard.ngc"));
  symlinkSync("part.ngc", path("soft.ngc"));
  for (const output of ["part.ngc", "./part.ngc", path("part.ngc"), "hard.ngc", "soft.ngc"]) {
    const { code, err } = await g41(["convert", "part.ngc", ...radius, "-o", output]);
    assert.equal(code, 2, output);
    assert.match(err, /is what is read/);
  }
  assert.equal(read("part.ngc"), corner);
  const table = await g41(["convert", "part.ngc", "--tool-table", "tools.tbl", "-o", "tools.tbl"]);
  assert.equal(table.code, 2);
  assert.equal(read("tools.tbl"), "T1 P1 D6\n");
});

test("a file that cannot be read or written ends with exit code 3 and says why", async () => {
  for (const [args, says] of [
    [["convert", "absent.ngc"], /^g41: error: absent\.ngc: there is no such file/],
    [["check", "absent.ngc"], /absent\.ngc: there is no such file/],
    [["convert", "."], /\.: this is a folder/],
    [
      ["convert", "part.ngc", ...radius, "-o", "absent/out.nc"],
      /absent\/out\.nc: there is no such/,
    ],
    [["convert", "part.ngc", "--tool-table", "absent.tbl"], /absent\.tbl: there is no such file/],
  ]) {
    const { code, out, err } = await g41(args);
    assert.deepEqual([code, out], [3, ""], args.join(" "));
    assert.match(err, says);
  }
});

test("a text that is not UTF-8 comes out as it went in", async () => {
  const bytes = Buffer.from(`(Fr\u00e4ser)\n${corner}`, "latin1");
  writeFileSync(path("latin.ngc"), bytes);
  const { code } = await g41(["convert", "latin.ngc", ...radius, "-o", "latin.nc"]);
  assert.equal(code, 0);
  assert.ok(readFileSync(path("latin.nc")).includes(Buffer.from("Fr\u00e4ser", "latin1")));
  const utf8 = await g41(["convert", "-", ...radius], { input: `\ufeff(Fr\u00e4ser)\n${corner}` });
  assert.deepEqual([utf8.code, utf8.err], [0, ""]);
  assert.match(utf8.out, /\(Fr\u00e4ser\)/);
  const wide = Buffer.from(`\ufeff(Fr\u00e4ser)\n${corner}`, "utf16le");
  writeFileSync(path("wide.ngc"), wide);
  const utf16 = await g41(["convert", "wide.ngc", ...radius]);
  assert.deepEqual([utf16.code, utf16.out], [0, utf8.out]);
  writeFileSync(path("swapped.ngc"), wide.swap16());
  assert.equal((await g41(["convert", "swapped.ngc", ...radius])).out, utf8.out);
});

test("what is no text, or has nothing in it, is no program", async () => {
  const utf16 = Buffer.from(corner, "utf16le");
  for (const [bytes, says] of [
    [Buffer.from("\x7fELF\x02\x01\x01\0\0\0G1 X1\n", "latin1"), "this is no text"],
    [utf16, "this is no text; if an editor shows one, save it as UTF-8"],
    [Buffer.alloc(0), "there is nothing in it"],
    [Buffer.from("\r\n \r\n"), "there is nothing in it"],
    [Buffer.alloc(64), "there is nothing in it"],
  ]) {
    writeFileSync(path("odd.ngc"), bytes);
    for (const command of ["convert", "check"]) {
      const { code, out, err } = await g41([command, "odd.ngc", ...radius]);
      assert.deepEqual([code, out], [3, ""], `${command}: ${says}`);
      assert.ok(err.startsWith(`g41: error: odd.ngc: ${says}`), `${command}: ${err}`);
    }
  }
  const leader = Buffer.alloc(100);
  writeFileSync(path("tape.ngc"), Buffer.concat([leader, Buffer.from(`${corner}\x1a`), leader]));
  const tape = await g41(["convert", "tape.ngc", ...radius]);
  const plain = await g41(["convert", "part.ngc", ...radius]);
  assert.deepEqual([tape.code, tape.err, tape.out], [0, "", plain.out], "blank tape and Ctrl+Z");
});

test("what cannot be written whole is told, to a file and to standard output", {
  skip: !existsSync("/dev/full"),
}, async () => {
  const { code, err } = await g41(["convert", "part.ngc", ...radius, "-o", "/dev/full"]);
  assert.equal(code, 3);
  assert.match(err, /^g41: error: \/dev\/full: there is no space left/);
  const full = openSync("/dev/full", "w");
  for (const args of [
    ["convert", "part.ngc", ...radius],
    ["check", "part.ngc", ...radius],
  ]) {
    const child = spawn(process.execPath, [command(), ...args], {
      cwd: home(),
      stdio: ["ignore", full, "pipe"],
    });
    const { code, errors } = await ended(child);
    assert.deepEqual([code, errors], [3, "g41: error: <stdout>: there is no space left\n"]);
  }
  closeSync(full);
});

test("- is standard output", async () => {
  const { code, out } = await g41(["convert", "part.ngc", ...radius, "-o", "-"]);
  assert.equal(code, 0);
  assert.deepEqual(pointsOf(out), centres(3));
  assert.ok(!existsSync(path("-")), "no file");
});

test("what is ended from outside leaves nothing behind, and the exit code of that signal", {
  skip: process.platform === "win32",
}, async () => {
  write("long.ngc", long);
  for (const [signal, number] of [
    ["SIGINT", 2],
    ["SIGTERM", 15],
    ["SIGHUP", 1],
  ]) {
    const before = readdirSync(home());
    const args = [command(), "convert", "long.ngc", "--json", "-o", "out.json"];
    const child = spawn(process.execPath, args, { cwd: home() });
    const drafts = () => readdirSync(home()).filter((name) => name.startsWith(".out.json."));
    while (drafts().length === 0 && child.exitCode === null) {
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    child.kill(signal);
    const { code } = await ended(child);
    assert.equal(code, 128 + number, signal);
    assert.deepEqual(readdirSync(home()), before, signal);
  }
});

test("who reads standard output may stop reading", async () => {
  write("long.ngc", long);
  const child = spawn(process.execPath, [command(), "convert", path("long.ngc"), "--json"]);
  child.stdout.once("data", () => child.stdout.destroy());
  const { code, errors } = await ended(child);
  assert.deepEqual([code, errors], [0, ""]);
});

test("the table of tools is refused where it is not understood, with its line", async () => {
  for (const [table, says] of [
    [
      "POCKET FMS LEN DIAM COMMENT\n1 1 0.5 0.25\n",
      /:1: "POCKET" is not of LinuxCNC's present format/,
    ],
    ["; old\n  1   1   0.511  0.125  mill\n", /:2: "1" is not of LinuxCNC's present format/],
    ["T1 P1 D6\nP2 D3 ;no T\n", /:2: this line names no tool/],
    ["T1 P1 D6\nT1 P2 D8\n", /:2: there is a tool T1 already/],
    ["T1 D6 D8\n", /:1: there are two D words/],
    ["T1 P1 Dsix\n", /:1: "Dsix" is not/],
    ["T1 P1 K3\n", /:1: "K3" is not understood/],
    ["T1.5 P1 D3\n", /:1: T1\.5 is no number of a tool/],
    ["T1 P1 D3 Q12\n", /:1: Q12 is no orientation/],
  ]) {
    write("bad.tbl", table);
    const { code, out, err } = await g41(["convert", "part.ngc", "--tool-table", "bad.tbl"]);
    assert.deepEqual([code, out], [3, ""], table);
    assert.match(err, says);
  }
  write("lathe.tbl", "q3 i-85.0 J-5 D+6.000 X1.5 z-2 t1 p1;lathe\r\n");
  const { code, out } = await g41(["convert", "part.ngc", "--tool-table", "lathe.tbl"]);
  assert.deepEqual([code, pointsOf(out)], [0, centres(3)]);
});
