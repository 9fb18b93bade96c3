// Adds up what the test programs report, and prints the table at the end.

/** How each test program's output says what passed and what failed. */
const counters = {
  cargo: { passed: /^test result: .*?(\d+) passed/gm, failed: /^test result: .*?(\d+) failed/gm },
  node: { passed: /^ℹ pass (\d+)$/gm, failed: /^ℹ (?:fail|cancelled) (\d+)$/gm },
  playwright: { passed: /^ +(\d+) passed/gm, failed: /^ +(\d+) (?:failed|did not run)/gm },
};

const rows = new Map();

/** Records a run of a test program by what it printed. A failure without a count is one, and so is
 * a run without tests. */
export function record(row, program, { code, output }) {
  const { passed, failed } = counters[program];
  const count = { passed: sum(output, passed), failed: sum(output, failed) };
  if (count.failed === 0 && (code !== 0 || count.passed === 0)) {
    count.failed = 1;
  }
  add(row, count);
}

/** Records a check that either holds or does not. */
export function recordCheck(row, holds) {
  add(row, holds ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 });
}

/** Prints the table, then the line with the totals; returns how many failed. */
export function report(notes) {
  const table = [["", "passed", "failed"]];
  for (const [row, { passed, failed }] of rows) {
    table.push([row, String(passed), String(failed)]);
  }
  console.log("");
  for (const [name, passed, failed] of table) {
    console.log(`${name.padEnd(16)}${passed.padStart(8)}${failed.padStart(8)}`);
  }
  for (const [name, value] of notes) {
    console.log(`${name.padEnd(16)}${value}`);
  }
  const totals = [...rows.values()];
  const passed = totals.reduce((total, row) => total + row.passed, 0);
  const failed = totals.reduce((total, row) => total + row.failed, 0);
  console.log(`\n${passed} passed, ${failed} failed`);
  return failed;
}

function add(row, { passed, failed }) {
  const before = rows.get(row) ?? { passed: 0, failed: 0 };
  rows.set(row, { passed: before.passed + passed, failed: before.failed + failed });
}

function sum(output, pattern) {
  return [...output.matchAll(pattern)].reduce((total, [, count]) => total + Number(count), 0);
}
