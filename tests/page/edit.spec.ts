// Points and segments are edited in the picture, and the program is rewritten with them.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

test("a double-click inserts a point on a segment, Delete takes it away", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  const before = await g41.program.inputValue();
  await page.mouse.dblclick(...place([13, 0]));
  await g41.settled();
  const lines = (await g41.program.inputValue()).split("\n");
  expect(lines.length).toBe(before.split("\n").length + 1);
  expect(lines.join("\n")).toMatch(/^N155 G1 X13[.\d]*\nN160 X0$/m);
  await page.keyboard.press("Delete");
  await g41.settled();
  expect(await g41.program.inputValue()).toBe(before);
});

test("a double-click on a spline inserts a type point in its place", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("ellipse");
  const place = await g41.locator();
  // Between the type points at 22.5° and 45°.
  const at = [40 * Math.cos(0.6), 24 * Math.sin(0.6)] as const;
  await page.mouse.dblclick(...place(at));
  await g41.settled();
  const points = (await g41.program.inputValue()).split("\n").filter((line) => / Y/.test(line));
  const index = points.findIndex((line) => line.includes("X28.284 Y16.971"));
  const [x, y] = [...(points[index + 1] ?? "").matchAll(/[XY](-?[\d.]+)/g)].map((m) =>
    Number(m[1]),
  );
  expect(x).toBeCloseTo(at[0], 0);
  expect(y).toBeCloseTo(at[1], 0);
  expect(points[index + 2]).toContain("X36.955 Y9.184");
});

test("a segment changes between line, arc and spline", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  const before = await g41.program.inputValue();
  await page.mouse.click(...place([0, 0]));
  const kind = page.getByRole("group", { name: "Kind of segment" });
  await expect(kind.getByRole("radio", { name: "Line", exact: true })).toBeChecked();
  await kind.getByRole("radio", { name: "Arc" }).check();
  await g41.settled();
  expect(await g41.program.inputValue()).toMatch(/^N160 G[23] X0 Y0 I-13 J/m);
  await kind.getByRole("radio", { name: "Spline" }).check();
  await g41.settled();
  expect(await g41.program.inputValue()).toMatch(/G05 X[\d.-]+ Y[\d.-]+\n.*\n?N160 X0 Y0/m);
  await kind.getByRole("radio", { name: "Line", exact: true }).check();
  await g41.settled();
  expect(await g41.program.inputValue()).toBe(before);
  expect(g41.errors).toEqual([]);
});

test("the middle of an arc bends it, its centre slides on the bisector", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  const radius = Math.hypot(14, 4);
  await g41.drag(place([40, radius - 4]), place([40, 14]));
  // Through (54, 0), (40, 14), (26, 0): a half circle about (40, 0).
  expect(await g41.program.inputValue()).toMatch(/^N150 G3 X26 Y0 I-14 J0$/m);
  await g41.drag(place([40, 0]), place([47, -6]));
  expect(await g41.program.inputValue()).toMatch(/^N150 G3 X26 Y0 I-14 J-6$/m);
});

test("the start of a closed contour moves with its end", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  await g41.drag(place([0, 18]), place([-2, 24]));
  const text = await g41.program.inputValue();
  expect(text).toMatch(/^N30 G1 G41 D1 X-2 Y24 F400 \(LEAD-IN\)$/m);
  expect(text).toMatch(/^N170 X-2 Y24$/m);
});

test("lead-in and lead-out are dragged by their far ends", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  await g41.drag(place([-20, 8]), place([-18, 12]));
  await g41.drag(place([-20, 28]), place([-18, 25]));
  const text = await g41.program.inputValue();
  expect(text).toMatch(/^N20 G0 X-18 Y12$/m);
  expect(text).toMatch(/^N180 G40 X-18 Y25 \(LEAD-OUT\)$/m);
});

test("exact coordinates are entered, also as arithmetic", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  await page.mouse.click(...place([70, 57]));
  const x = page.getByLabel("X", { exact: true });
  await x.fill("10*7+1/8");
  await x.press("Enter");
  await expect(g41.program).toHaveValue(/^N100 X70\.125 Y57$/m);
  await x.fill("7o");
  await x.press("Enter");
  await expect(x).toHaveAttribute("aria-invalid", "true");
  await expect(g41.program).toHaveValue(/^N100 X70\.125 Y57$/m);
});

test("empty space drags the picture, the wheel zooms at the pointer, F fits", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.picture();
  const place = await g41.locator();
  const [x, y] = place([20, 25]);
  await g41.drag([x, y], [x + 40, y + 30]);
  const moved = await g41.locator();
  expect(moved([20, 25])[0]).toBeCloseTo(x + 40, -1);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -400);
  await g41.frames(3);
  const zoomed = await g41.locator();
  const under = (to: typeof place) => to([20 - 40 / 6, 25]);
  expect(zoomed([10, 0])[0] - zoomed([0, 0])[0]).toBeGreaterThan(
    1.5 * (moved([10, 0])[0] - moved([0, 0])[0]),
  );
  expect(under(zoomed)).not.toEqual(under(moved));
  await g41.canvas.focus();
  await page.keyboard.press("f");
  await page.mouse.move(1, 1);
  await g41.frames(3);
  expect(await g41.picture()).toBe(before);
});
