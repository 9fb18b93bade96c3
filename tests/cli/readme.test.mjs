// What README.md shows of the command line is what the command does.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { root } from "../../scripts/command.mjs";
import { installed } from "./command.mjs";

const { g41, write } = installed();

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
