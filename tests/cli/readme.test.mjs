// What README.md shows of the command line is what the command does.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { root } from "../../scripts/command.mjs";
import { installed } from "./command.mjs";

const { g41, home, write } = installed();

test("every command in README.md prints what stands below it", async () => {
  const [, section = ""] = readFileSync(join(root, "README.md"), "utf8").match(
    /\n## On the command line\n(.*?)\n## /s,
  );
  const blocks = [...section.matchAll(/```console\n(.*?)```/gs)].map(([, block]) => block);
  const steps = blocks.flatMap((block) => block.split(/^\$ /m).slice(1));
  let commands = 0;
  for (const step of steps) {
    const [command, ...lines] = step.split("\n");
    const shown = lines.join("\n");
    const [program, ...args] = command.split(" ");
    if (program === "cat") {
      write(args[0], shown);
      continue;
    }
    assert.deepEqual([program, args[0]], ["npx", "g41"], command);
    const { out, err } = await g41(args.slice(1));
    assert.equal(err + out, shown, command);
    commands += 1;
  }
  assert.ok(commands >= 3, "there are commands");
});

test("the examples of README.md run as they stand there, to what they say", async () => {
  const text = readFileSync(join(root, "README.md"), "utf8");
  const blocks = [...text.matchAll(/```js\n(.*?)```/gs)].map(([, block]) => block);
  assert.equal(blocks.length, 3, "examples");
  write(
    "example.mjs",
    `${blocks.join("")}
import assert from "node:assert/strict";
assert.deepEqual(path.polyline().constructor, Float64Array);
assert.ok(path.transitions.length > 0 && Array.isArray(path.diagnostics));
assert.match(path.gcode({ feed: 300 }), /^G2 .+^G3 |^G3 .+^G2 |^G3 /ms);
assert.ok(safe.uncut.every(({ outline, area, segments }) => outline && area && segments));
assert.deepEqual(check(part, safe, { radius: 12 }), []);
assert.ok(to > from);
assert.deepEqual(motion.violations, []);
assert.equal(motion.velocity.length, motion.count);
assert.equal(motion.time[1], 0.001);
assert.ok(path.plan({ ...machine, exactStop: true }).duration > motion.duration);
assert.ok(path.plan({ ...machine, mode: "textbook" }).violations.length > 0);
assert.equal(motion.toCsv().trim().split("\\n").length, motion.count + 1);
console.log("all");
`,
  );
  const { status, stdout, stderr } = spawnSync(process.execPath, ["example.mjs"], {
    cwd: home(),
    encoding: "utf8",
  });
  assert.deepEqual([status, stdout, stderr], [0, "all\n", ""]);
});
