// A type point is dragged: tool path and program follow, and undo brings both back.
import { expect, type Page, test } from "@playwright/test";
import { G41Page, type Point } from "./page";

/** A type point of the first example, where it is dragged to, and its block. */
const TYPE_POINT: Point = [56, 64];
const TARGET: Point = [58, 72];

/**
 * How many frames after the one of a pointer move program, compensated program and picture show it.
 */
async function watchFrames(page: Page, around: Point): Promise<() => Promise<number[][]>> {
  await page.evaluate(([x, y]) => {
    const output = document.querySelector<HTMLTextAreaElement>("#panel-output textarea");
    const program = document.querySelector<HTMLTextAreaElement>("#panel-program textarea");
    const base = document.querySelector<HTMLCanvasElement>("canvas.base");
    const overlay = document.querySelector<HTMLCanvasElement>("canvas.overlay");
    if (!output || !program || !base || !overlay) throw new Error("the page is not complete");
    const box = overlay.getBoundingClientRect();
    const scale = base.width / box.width;
    const pixels = () =>
      base
        .getContext("2d")
        ?.getImageData((x - box.left - 60) * scale, (y - box.top - 60) * scale, 120, 120)
        .data.reduce((sum, value, i) => (sum * 31 + value * i) % 1000003, 7) ?? 0;
    const seen = () => [program.value, output.value, pixels()];
    const latencies: number[][] = [];
    let frame = 0;
    let moved: { frame: number; before: unknown[]; after: number[] } | undefined;
    // Before this frame draws, the page is as the frame before has left it.
    const tick = () => {
      if (moved) {
        const { before, after, frame: first } = moved;
        seen().forEach((value, i) => {
          if (value !== before[i]) after[i] ??= Math.max(0, frame - first);
        });
        if (after.filter((value) => value !== undefined).length === before.length) {
          latencies.push(after);
          moved = undefined;
        }
      }
      frame += 1;
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
    overlay.addEventListener(
      "pointermove",
      (event) => {
        if (event.buttons && !moved) moved = { frame: frame + 1, before: seen(), after: [] };
      },
      { capture: true },
    );
    Object.assign(window, { latenciesOfThisTest: latencies });
  }, around);
  return () =>
    page.evaluate(
      () => (window as unknown as { latenciesOfThisTest: number[][] }).latenciesOfThisTest,
    );
}

function median(values: number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)] as number;
}

test.describe("how soon", () => {
  // When a frame comes depends on what else the machine does; what is too slow is so each time.
  test.describe.configure({ retries: 2 });

  test("dragging a type point moves tool path and programs within two frames", async ({ page }) => {
    const g41 = new G41Page(page);
    await g41.open();
    const place = await g41.locator();
    const latencies = await watchFrames(page, place(TYPE_POINT));
    const [from, to] = [place(TYPE_POINT), place(TARGET)];
    await page.mouse.move(...from);
    await page.mouse.down();
    for (let i = 1; i <= 12; i += 1) {
      const t = i / 12;
      await page.mouse.move(from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t);
      await g41.frames(4);
    }
    await page.mouse.up();
    const seen = await latencies();

    expect(seen.length).toBeGreaterThan(5);
    for (const [i, what] of ["program", "compensated program", "picture"].entries()) {
      expect(median(seen.map((each) => each[i] as number)), what).toBeLessThanOrEqual(2);
    }
  });
});

test("a drag by mouse is one step back and forth, to the same path", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  const before = [await g41.program.inputValue(), await g41.output.inputValue()];
  await g41.drag(place(TYPE_POINT), place(TARGET));
  const after = [await g41.program.inputValue(), await g41.output.inputValue()];
  expect(after[0]).toMatch(/^N90 G05 X58 Y72 \(TYPE POINTS\)$/m);
  expect(after[1]).not.toBe(before[1]);
  await page.keyboard.press("Control+z");
  await expect(g41.program).toHaveValue(before[0] as string);
  await expect(g41.output).toHaveValue(before[1] as string);
  await page.keyboard.press("Control+Shift+z");
  await expect(g41.program).toHaveValue(after[0] as string);
  await expect(g41.output).toHaveValue(after[1] as string);
  expect(g41.errors).toEqual([]);
});

test("only the block of the dragged point changes", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  const before = (await g41.program.inputValue()).split("\n");
  await g41.drag(place(TYPE_POINT), place(TARGET));
  const after = (await g41.program.inputValue()).split("\n");
  expect(after.length).toBe(before.length);
  expect(after.filter((line, i) => line !== before[i])).toEqual(["N90 G05 X58 Y72 (TYPE POINTS)"]);
});
