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

/** Makes a file of the program in the page and drops it, without sending it there each time. */
async function drop(page: Page, text: string): Promise<void> {
  await page.evaluate((content) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], "relief.nc", { type: "text/plain" }));
    // How long the page is too busy to answer: the longest time between two ticks of its clock. What
    // it is while nothing happens is what else the machine is busy with.
    const meter = { idle: 0, longest: 0 };
    Object.assign(window, { meter });
    let last = performance.now();
    let key: keyof typeof meter = "idle";
    setInterval(() => {
      const now = performance.now();
      meter[key] = Math.max(meter[key], now - last);
      last = now;
    }, 5);
    setTimeout(() => {
      key = "longest";
      const options = { dataTransfer, bubbles: true, cancelable: true };
      document.body.dispatchEvent(new DragEvent("drop", options));
    }, 2000);
  }, text);
}

/** The longest time that the page was too busy to answer, before the drop and since [ms]. */
async function busy(page: Page): Promise<{ idle: number; longest: number }> {
  return page.evaluate(
    () => (window as unknown as { meter: { idle: number; longest: number } }).meter,
  );
}

test.describe.configure({ timeout: 240_000 });

test("it opens with progress while the page answers, and is shown with all its lines", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = program(BLOCKS);
  const began = Date.now();
  await drop(page, text);
  const bar = page.getByRole("progressbar", { name: "Progress" });
  await expect(bar).toBeVisible();
  const seen: number[] = [];
  while (await bar.isVisible()) {
    seen.push(Number(await bar.evaluate((element) => (element as HTMLProgressElement).value)));
    await page.waitForTimeout(50);
  }
  const opened = Date.now() - began;
  expect(
    seen.every((value, i) => i === 0 || value === 0 || value >= (seen[i - 1] ?? 0)),
    `progress only rises: ${seen}`,
  ).toBe(true);
  expect(new Set(seen).size, "progress was seen to rise").toBeGreaterThan(5);
  const { idle, longest } = await busy(page);
  expect(longest, "longest time without an answer [ms]").toBeLessThan(100 + idle);

  const list = page.getByRole("listbox", { name: "Program of the part" });
  await expect(list.getByRole("option").first()).toHaveText(/%/);
  expect(await list.getByRole("option").count(), "only lines that are seen").toBeLessThan(120);
  await list.focus();
  await page.keyboard.press("End");
  await expect(list.getByRole("option", { selected: true })).toHaveText(String(BLOCKS + 1));
  await page.keyboard.press("Home");
  for (let i = 0; i < 4; i += 1) await page.keyboard.press("ArrowDown");
  await expect(list.getByRole("option", { selected: true })).toContainText("G0 X0 Y0.00");

  // The line of the move under the pointer.
  await expect.poll(() => inked(g41)).toBeGreaterThan(1000);
  const place = await g41.locator();
  await page.mouse.move(...place([-15, 305]));
  await page.mouse.move(...place([-33, 5]));
  await expect(list.locator(".row.hovered")).toHaveCount(1);

  const { name, text: code } = await g41.saved(page.getByRole("button", { name: /^Save / }));
  expect(name).toBe("relief.grbl.nc");
  expect(code).not.toContain("G41");
  expect(code.split("\n").length).toBeGreaterThan(BLOCKS * 0.9);

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
      `longest ${longest.toFixed(0)} ms (idle ${idle.toFixed(0)} ms); frames ${median.toFixed(1)} and ${p95.toFixed(1)} ms`,
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

test("it is cancelled at once, and what was shown stays", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.program.inputValue();
  await drop(page, program(300_000));
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
