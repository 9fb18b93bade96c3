// g41 check: programs are judged, and the exit code tells.
import assert from "node:assert/strict";
import { test } from "node:test";

import { corner, installed } from "./command.mjs";

const { g41 } = installed({
  "good.ngc": corner,
  // A slot of 4 mm between two walls.
  "narrow.ngc": "G0 X2 Y40\nG1 G41 D1 X0 Y20 F300\nY0\nX4\nY20\nG40 X2 Y40\nM30\n",
  "wrong.ngc": "G0 X0 Y0\nG1 X10 Q\nM30\n",
});

test("a program that is right ends with exit code 0", async () => {
  const { code, out, err } = await g41(["check", "good.ngc", "--radius", "3"]);
  assert.deepEqual([code, err], [0, ""]);
  assert.equal(out, "good.ngc: no errors, no warnings, no gouges\n");
});

test("a gouge ends with exit code 1, and is told with place and depth", async () => {
  // A tool of 6 mm across is too wide for it; one of 3 mm is not.
  const { code, out, err } = await g41(["check", "narrow.ngc", "--radius", "3"]);
  assert.equal(code, 1);
  assert.match(out, /^narrow\.ngc: \d+ errors?, no warnings, \d+ gouges? of up to [\d.]+ mm\n$/);
  assert.match(err, /^narrow\.ngc:[345](:\d+)?: error: /m);
  const fits = await g41(["check", "narrow.ngc", "--radius", "1.5"]);
  assert.deepEqual([fits.code, fits.err], [0, ""], fits.out);
});

test("an error in a program ends with exit code 1", async () => {
  const { code, err } = await g41(["check", "wrong.ngc"]);
  assert.equal(code, 1);
  assert.match(err, /^wrong\.ngc:2:\d+: error: /m);
});

test("several programs are judged one after the other, and one that is wrong decides", async () => {
  const { code, out } = await g41(["check", "good.ngc", "wrong.ngc", "-", "--radius", "3"], {
    input: corner,
  });
  assert.equal(code, 1);
  assert.match(
    out,
    /^good\.ngc: .*\nwrong\.ngc: .*\n<stdin>: no errors, no warnings, no gouges\n$/,
  );
});

test("a file that cannot be read does not keep others from being judged", async () => {
  const args = ["check", "narrow.ngc", "absent.ngc", "good.ngc", "--radius", "3"];
  const { code, out, err } = await g41(args);
  assert.equal(code, 3);
  assert.match(err, /^g41: error: absent\.ngc: there is no such file/m);
  assert.match(out, /^narrow\.ngc: .+\ngood\.ngc: no errors/);
  const listed = JSON.parse((await g41([...args, "--json"])).out);
  assert.deepEqual(
    listed.map(({ file }) => file),
    ["narrow.ngc", "good.ngc"],
  );
});

test("many programs are judged without a word of Node.js", async () => {
  // Each of them is written to standard output, whose listeners once added up to a warning.
  const files = Array.from({ length: 12 }, () => "good.ngc");
  const { code, out, err } = await g41(["check", ...files, "--radius", "3"]);
  assert.deepEqual([code, err], [0, ""]);
  assert.equal(out.trimEnd().split("\n").length, 12);
});

test("--json writes what is found with each program, and the exit code stays", async () => {
  const args = ["check", "good.ngc", "narrow.ngc", "wrong.ngc", "--radius", "3", "--json"];
  const { code, out } = await g41(args);
  assert.equal(code, 1);
  const [good, narrow, wrong, ...others] = JSON.parse(out);
  assert.deepEqual(good, { file: "good.ngc", diagnostics: [], gouges: [] });
  assert.equal(narrow.file, "narrow.ngc");
  // The far wall of the slot is 4 mm away from one, where the tool needs 6.
  const deepest = Math.max(...narrow.gouges.map(({ depth }) => depth));
  assert.ok(Math.abs(deepest - 2) < 1e-3, `depth ${deepest}`);
  assert.deepEqual(
    wrong.diagnostics.map(({ severity, origin }) => [severity, origin.block]),
    [["error", 2]],
  );
  assert.deepEqual(others, []);
  assert.equal((await g41(["check", "good.ngc", "--radius=3", "--json"])).code, 0);
});
