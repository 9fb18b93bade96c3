/// <reference types="node" />
// A very long program opens without holding the page up, is shown in full, and can be cancelled.
import { expect, type Page, test } from "@playwright/test";
import { G41Page } from "./page";

/** Blocks of the long program; a million by hand, with G41_LONG=1000000. */
const BLOCKS = Number(process.env.G41_LONG ?? 300_000);

/** Rows of a relief, with a compensated square now and then. */
function program(blocks: number): string {
  const lines = ["%", "G17 G21 G90 G94", "T1 M6", "G0 Z5"];
  for (let row = 0; lines.length < blocks - 20; row += 1) {
    const y = 0.1 * (row % 3000);
    lines.push(`G0 X0 Y${y.toFixed(2)}`, "G1 Z-1 F800");
    for (let i = 1; i <= 900; i += 1) {
      const z = -1 - 0.5 * Math.sin(i / 40) * Math.cos(row / 25);
      lines.push(`X${(i * 0.3).toFixed(3)} Z${z.toFixed(3)}`);
    }
    lines.push("G0 Z5");
    if (row % 10 === 0) {
      lines.push(`G0 X-40 Y${y.toFixed(2)}`, `G1 G41 D1 X-30 F600`, `Y${(y + 10).toFixed(2)}`);
      lines.push("X-20", `Y${y.toFixed(2)}`, "X-30", "G40 X-40");
    }
  }
  while (lines.length < blocks - 2) lines.push(`G1 X300 Y${lines.length % 300}`);
  return [...lines, "M30", "%", ""].join("\n");
}

/** Makes a file of the program in the page, and returns what drops it. */
async function dropper(page: Page, text: string): Promise<() => Promise<void>> {
  await page.evaluate((content) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], "relief.nc", { type: "text/plain" }));
    const options = { dataTransfer, bubbles: true, cancelable: true };
    Object.assign(window, { dropping: new DragEvent("drop", options) });
  }, text);
  return () =>
    page.evaluate(() => {
      document.body.dispatchEvent((window as unknown as { dropping: DragEvent }).dropping);
    });
}

/** What a trace of the browser tells of a task. */
interface Task {
  readonly name: string;
  readonly pid: number;
  readonly tid: number;
  /** Time that the processor was at it [µs]. */
  readonly tdur?: number;
  readonly args?: { readonly name?: string };
}

/**
 * The time of the longest task on the main thread of the page [ms]. What counts is the time that the
 * processor was at it: what else the machine is busy with is no matter of the page.
 */
function longestTask(trace: Buffer): number {
  const { traceEvents } = JSON.parse(trace.toString()) as { traceEvents: Task[] };
  const main = traceEvents.filter(
    ({ name, args }) => name === "thread_name" && args?.name === "CrRendererMain",
  );
  const isMain = (task: Task) => main.some(({ pid, tid }) => pid === task.pid && tid === task.tid);
  const tasks = traceEvents.filter(({ name, tdur }) => tdur && name.endsWith("RunTask"));
  expect(tasks.length, "tasks in the trace").toBeGreaterThan(100);
  return Math.max(...tasks.filter(isMain).map(({ tdur }) => (tdur ?? 0) / 1000));
}

test.describe.configure({ timeout: 240_000 });

test("it opens with progress while the page answers, and is shown with all its lines", async ({
  browser,
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = program(BLOCKS);
  const drop = await dropper(page, text);
  await browser.startTracing(page, { categories: ["toplevel", "__metadata"] });
  const began = Date.now();
  await drop();
  const bar = page.getByRole("progressbar", { name: "Progress" });
  await expect(bar).toBeVisible();
  const seen: number[] = [];
  // By its place, since it has no role any more once it is hidden.
  const value = () =>
    page.locator("#work").evaluate((panel) => {
      return panel.matches("[hidden]") ? undefined : panel.querySelector("progress")?.value;
    });
  for (let now = await value(); now !== undefined; now = await value()) {
    seen.push(now);
    await page.waitForTimeout(50);
  }
  const opened = Date.now() - began;
  expect(
    seen.every((value, i) => i === 0 || value === 0 || value >= (seen[i - 1] ?? 0)),
    `progress only rises: ${seen}`,
  ).toBe(true);
  expect(new Set(seen).size, "progress was seen to rise").toBeGreaterThan(5);
  const longest = longestTask(await browser.stopTracing());
  expect(longest, "longest time without an answer [ms]").toBeLessThan(100);

  const list = page.getByRole("listbox", { name: "Program of the part" });
  await expect(list.getByRole("option").first()).toHaveText(/%/);
  expect(await list.getByRole("option").count(), "only lines that are seen").toBeLessThan(120);
  await list.focus();
  await page.keyboard.press("End");
  await expect(list.getByRole("option", { selected: true })).toHaveText(
    new RegExp(`^${text.split("\n").length}`),
  );
  await page.keyboard.press("Home");
  for (let i = 0; i < 4; i += 1) await page.keyboard.press("ArrowDown");
  await expect(list.getByRole("option", { selected: true })).toContainText("G0 X0 Y0.00");

  // The line of the move under the pointer.
  await expect.poll(() => inked(g41)).toBeGreaterThan(1000);
  const place = await g41.locator();
  const marked = list.locator(".row.current");
  await expect(async () => {
    await page.mouse.move(...place([-35, 6]));
    await page.mouse.move(...place([-35, 5]));
    await page.waitForTimeout(200);
    await page.mouse.click(...place([-35, 5]));
    // Its line is shown, which was far away.
    await expect(marked).toHaveText(/^\d+Y[\d.]+$/, { timeout: 500 });
  }).toPass({ timeout: 20_000 });

  const { name, text: code } = await g41.saved(page.getByRole("button", { name: /^Save / }));
  expect(name).toBe("relief.grbl.nc");
  expect(code).not.toContain("G41");
  expect(code.split("\n").length).toBeGreaterThan(BLOCKS * 0.9);
  expect(code).toMatch(/^M30$/m);

  // Frames while it is moved and zoomed.
  const frames = await page.evaluate(async () => {
    const canvas = document.querySelector("canvas.overlay") as HTMLCanvasElement;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const at = { clientX: left + width / 2, clientY: top + height / 2, cancelable: true };
    const times: number[] = [];
    let last = performance.now();
    for (let i = 0; i < 120; i += 1) {
      const deltaY = i < 60 ? -60 : 60;
      canvas.dispatchEvent(new WheelEvent("wheel", { ...at, deltaY }));
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const now = performance.now();
      times.push(now - last);
      last = now;
    }
    return times.sort((a, b) => a - b);
  });
  const [median, p95] = [frames[60] ?? 0, frames[114] ?? 0];
  console.log(
    `${BLOCKS} blocks, ${(text.length / 1e6).toFixed(1)} MB: open ${opened} ms, ` +
      `longest task ${longest.toFixed(0)} ms; frames ${median.toFixed(1)} and ${p95.toFixed(1)} ms`,
  );
  expect(median, "median frame while zooming [ms]").toBeLessThan(50);
  expect(g41.errors).toEqual([]);
});

/** How many pixels of the picture are not paper. */
function inked(g41: G41Page): Promise<number> {
  return g41.base.evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let i = 0; data && i < data.length; i += 4) {
      // The grid is much paler than any line.
      if ((data[i] ?? 255) + (data[i + 1] ?? 255) + (data[i + 2] ?? 255) < 480) count += 1;
    }
    return count;
  });
}

test("what is opened while it is read stays, and it is given up", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const drop = await dropper(page, program(BLOCKS));
  await drop();
  await expect(page.locator("#work")).toContainText(/Reading|Compensating/);
  await page.getByLabel("Example").selectOption("pocket");
  await expect(page.locator("#work")).toBeHidden();
  await g41.settled();
  // The name of the long program, had it been read to its end, would stand here.
  await expect(page.locator(".file-name")).toHaveText("pocket.nc");
  await expect(g41.output).toHaveValue(/G1/);
  expect(g41.errors).toEqual([]);
});

test("a program of half a megabyte shows how far it is read, and is cancelled", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.program.inputValue();
  const text = program(30_000);
  expect(text.length, "one that is shown with its moves").toBeLessThan(1_500_000);
  const work = page.locator("#work");
  // At once, as no hand could before it has been read.
  await work.evaluate((panel) => {
    const cancel = panel.querySelector("button") as HTMLButtonElement;
    new MutationObserver((_, observer) => {
      if (panel.matches("[hidden]")) return;
      observer.disconnect();
      cancel.click();
    }).observe(panel, { attributes: true, attributeFilter: ["hidden"] });
  });
  await (await dropper(page, text))();
  await expect(page.locator(".notice")).toHaveText("relief.nc: cancelled.");
  await expect(work).toBeHidden();
  await expect(g41.program, "what was shown stays").toHaveValue(before);
  // And read to its end it is there.
  const list = page.getByRole("listbox", { name: "Program of the part" });
  for (const _ of ["once", "and again as it is"]) {
    await (await dropper(page, text))();
    await expect(page.locator(".file-name")).toHaveText("relief.nc", { timeout: 20_000 });
    await expect(work).toBeHidden();
    await expect(list.getByRole("option").first(), "its first line").toHaveText(/%/);
  }
  await g41.settled();
  // Opened twice, undone twice.
  for (let i = 0; i < 2; i += 1) await page.getByRole("button", { name: "Undo" }).click();
  await expect(page.locator(".file-name")).not.toHaveText("relief.nc");
  expect(g41.errors).toEqual([]);
});

test("a panel that cannot show it is closed", async ({ page }) => {
  test.setTimeout(120_000);
  const g41 = new G41Page(page);
  await g41.open();
  const button = page.getByRole("button", { name: "Motion" });
  await button.click();
  await expect(page.locator(".motion-times")).toContainText(" s");
  const drop = await dropper(page, program(120_000));
  await drop();
  await expect(page.locator(".file-name")).toHaveText("relief.nc", { timeout: 90_000 });
  await expect(button).toBeDisabled();
  await expect(button, "it says why").toHaveAttribute("title", /too long/);
  await expect(page.locator("#motion")).toBeHidden();
  expect(g41.errors).toEqual([]);
});

test("it is cancelled at once, and what was shown stays", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.program.inputValue();
  const drop = await dropper(page, program(300_000));
  await drop();
  const cancel = page.getByRole("button", { name: "Cancel" });
  await expect(page.locator("#work")).toContainText(/Reading|Compensating/);
  await cancel.click();
  await expect(page.locator("#work")).toBeHidden();
  await expect(page.locator(".notice")).toHaveText("relief.nc: cancelled.");
  expect(await g41.program.inputValue()).toBe(before);
  // And the page still computes.
  const field = page.getByLabel("Tool radius in mm");
  const output = await g41.output.inputValue();
  await field.fill("2");
  await field.press("Enter");
  await expect(g41.output).not.toHaveValue(output);
  expect(g41.errors).toEqual([]);
});
