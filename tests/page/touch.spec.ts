// Fingers on a phone: they drag points, pinch the picture, and do not scroll the page.
import { expect, test } from "@playwright/test";
import { G41Page, type Point } from "./page";

/** A type point of the first example, where it is dragged to, and its block. */
const TYPE_POINT: Point = [56, 64];
const TARGET: Point = [58, 72];

test("a finger drags a type point", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  const before = [await g41.program.inputValue(), await g41.output.inputValue()];
  const client = await page.context().newCDPSession(page);
  const touch = (type: string, at?: Point) =>
    client.send("Input.dispatchTouchEvent", {
      type: type as "touchStart",
      touchPoints: at ? [{ x: at[0], y: at[1], id: 1 }] : [],
    });
  const [from, to] = [place(TYPE_POINT), place(TARGET)];
  const scrolled = await page.evaluate(() => scrollY);
  // Fingers are not precise: ten pixels beside the point is on it.
  await touch("touchStart", [from[0] + 8, from[1] - 6]);
  for (let i = 1; i <= 10; i += 1) {
    const t = i / 10;
    const at: Point = [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
    await touch("touchMove", [at[0] + 8, at[1] - 6]);
    await g41.frames(1);
  }
  await touch("touchEnd");
  await g41.settled();
  expect(await g41.program.inputValue()).toMatch(/^N90 G05 X5[789].* Y7[123]/m);
  expect(await g41.output.inputValue()).not.toBe(before[1]);
  expect(await page.evaluate(() => scrollY)).toBe(scrolled);
  await page.getByRole("button", { name: "Undo" }).tap();
  await expect(g41.program).toHaveValue(before[0] as string);
  await expect(g41.output).toHaveValue(before[1] as string);
});

test("two fingers zoom the picture and leave the program alone", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  const before = await g41.program.inputValue();
  const gap = place([10, 0])[0] - place([0, 0])[0];
  const client = await page.context().newCDPSession(page);
  const middle = place([40, 30]);
  const pinch = (type: string, half: number) =>
    client.send("Input.dispatchTouchEvent", {
      type: type as "touchStart",
      touchPoints: half
        ? [
            { x: middle[0] - half, y: middle[1], id: 1 },
            { x: middle[0] + half, y: middle[1], id: 2 },
          ]
        : [],
    });
  await pinch("touchStart", 40);
  for (let half = 45; half <= 80; half += 5) {
    await pinch("touchMove", half);
    await g41.frames(1);
  }
  await pinch("touchEnd", 0);
  const after = await g41.locator();
  const ratio = (after([10, 0])[0] - after([0, 0])[0]) / gap;
  expect(ratio).toBeGreaterThan(1.7);
  expect(ratio).toBeLessThan(2.3);
  expect(await g41.program.inputValue()).toBe(before);
});

test("on a small phone all buttons above the picture stand in one row, wide enough", async ({
  page,
}) => {
  await page.setViewportSize({ width: 360, height: 740 });
  const g41 = new G41Page(page);
  await g41.open();
  const boxes = await page
    .locator(".view-buttons button")
    .evaluateAll((all) => all.map((e) => e.getBoundingClientRect().toJSON()));
  expect(boxes.length, "the buttons").toBe(8);
  for (const { top, width, right } of boxes) {
    expect(top, "all begin at one height").toBe(boxes[0].top);
    expect(width, "room for a finger").toBeGreaterThanOrEqual(36);
    expect(right, "none is cut off").toBeLessThanOrEqual(360);
  }
  for (const name of ["Open", /^Save/]) {
    const box = await page.getByRole("button", { name }).first().boundingBox();
    expect(box?.height, `the height of ${name}`).toBeGreaterThanOrEqual(44);
  }
  const scroll = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(scroll, "the page does not scroll sideways").toBeLessThanOrEqual(360);
});

test("one finger turns the picture in space, two go nearer", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await page.getByRole("button", { name: "3D view" }).tap();
  const canvas = page.locator("canvas.space");
  const picture = () => canvas.evaluate((e) => (e as HTMLCanvasElement).toDataURL());
  await g41.frames(3);
  const first = await picture();
  const box = await canvas.boundingBox();
  if (!box) throw new Error("the picture in space is not shown");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const client = await page.context().newCDPSession(page);
  const touch = (type: string, ...touchPoints: { x: number; y: number; id: number }[]) =>
    client.send("Input.dispatchTouchEvent", { type: type as "touchStart", touchPoints });
  await touch("touchStart", { x, y, id: 1 });
  for (let i = 1; i <= 6; i += 1) await touch("touchMove", { x: x + 10 * i, y, id: 1 });
  await touch("touchEnd");
  await g41.frames(3);
  const second = await picture();
  expect(second, "one finger turns it").not.toBe(first);
  await expect(page.getByRole("radio", { name: "Iso" }), "no view by name").not.toBeChecked();
  const both = (half: number) => [
    { x: x - half, y, id: 1 },
    { x: x + half, y, id: 2 },
  ];
  await touch("touchStart", ...both(30));
  for (let half = 35; half <= 60; half += 5) await touch("touchMove", ...both(half));
  await touch("touchEnd");
  await g41.frames(3);
  expect(await picture(), "two go nearer").not.toBe(second);
  expect(g41.errors, "errors of the page").toEqual([]);
});

test("as the tool runs in space, its place covers no view, and nothing else", async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  const g41 = new G41Page(page);
  await g41.open();
  await page.getByRole("button", { name: "3D view" }).tap();
  await page.getByRole("button", { name: "Motion" }).tap();
  await expect(page.locator("#motion")).toHaveAttribute("aria-busy", "false");
  await page.getByRole("slider", { name: "Time" }).fill("400");
  await expect(page.locator("#readout")).toHaveText(/X.*Y.*Z/);
  const box = async (selector: string) => {
    const found = await page.locator(selector).boundingBox();
    if (!found) throw new Error(`${selector} is not shown`);
    return found;
  };
  const readout = await box("#readout");
  for (const selector of [".space-views .choice-row", ".space-extents"]) {
    const other = await box(selector);
    const isBeside =
      readout.y >= other.y + other.height ||
      other.y >= readout.y + readout.height ||
      readout.x >= other.x + other.width ||
      other.x >= readout.x + readout.width;
    expect(isBeside, `the place of the tool beside ${selector}`).toBe(true);
  }
  expect(g41.errors, "errors of the page").toEqual([]);
});

test("a hundred diagnostics make the page no longer than a few screens", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const lines = Array.from({ length: 120 }, (_, i) => `G1 X${i} Y${i % 2} Q${i} Q1`);
  await g41.drop({ name: "wrong.nc", text: `G21 G90\n${lines.join("\n")}\nM30\n` });
  const rows = page.locator(".diagnostic");
  await expect.poll(() => rows.count(), "rows of the list").toBeGreaterThanOrEqual(100);
  const [height, screen] = await page.evaluate(() => [
    document.documentElement.scrollHeight,
    innerHeight,
  ]);
  expect(height, "the page is a few screens long [px]").toBeLessThan(4 * (screen ?? 0));
  // The last of them is reached all the same.
  await rows.last().scrollIntoViewIfNeeded();
  await expect(rows.last()).toBeInViewport();
});
