// The text is edited, and the picture follows; what is wrong with it is said with its place.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

test("a change of the text redraws the part and its tool path", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = [await g41.picture(), await g41.output.inputValue()];
  const text = await g41.program.inputValue();
  await g41.program.fill(text.replace("N100 X70 Y57", "N100 X72 Y62"));
  await g41.settled();
  expect(await g41.output.inputValue()).not.toBe(before[1]);
  expect(await g41.picture()).not.toBe(before[0]);
  const place = await g41.locator();
  await g41.drag(place([72, 62]), place([72, 60]));
  await expect(g41.program).toHaveValue(/^N100 X72 Y60$/m);
});

test("lines around a contour, comments, numbers and feeds stay as they are", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = [
    "(MADE BY HAND)  ",
    "G17 G21 G90 T1 M6",
    "S8000 M3",
    "G0 X-10 Y-10",
    "G1 G41 D1 X0 Y0 F250",
    "(left side)",
    "N2 Y30 F500 ; slowly",
    "M8",
    "N3 X40",
    "N4 Y0",
    "N5 X0",
    "G40 X-10 Y-10",
    "G0 Z50   (up)",
    "M30",
  ].join("\n");
  await g41.program.fill(text);
  await g41.settled();
  await page.getByRole("button", { name: "Fit" }).click();
  const place = await g41.locator();
  await g41.drag(place([40, 30]), place([50, 35]));
  expect(await g41.program.inputValue()).toBe(
    text.replace("N3 X40", "N3 X50 Y35").replace("N4 Y0", "N4 X40 Y0"),
  );
});

test("inches and relative coordinates are written as they were", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = [
    "G17 G20 G90",
    "G0 X-1 Y-1",
    "G1 G41 D1 X0 Y0 F10",
    "G91 Y2",
    "X2",
    "Y-2",
    "X-2",
    "G90 G40 X-1 Y-1",
    "M30",
  ].join("\n");
  await g41.program.fill(text);
  await g41.settled();
  await page.getByRole("button", { name: "Fit" }).click();
  const place = await g41.locator();
  await g41.drag(place([50.8, 50.8]), place([63.5, 50.8]));
  const after = (await g41.program.inputValue()).split("\n");
  expect(Number(/^X(.*)$/.exec(after[4] ?? "")?.[1])).toBeCloseTo(2.5, 1);
  expect(Number(/^X([-.\d]+) Y-2$/.exec(after[5] ?? "")?.[1])).toBeCloseTo(-0.5, 1);
  expect(after[6]).toBe("X-2");
});

test("a bad program is answered with diagnostics and their lines", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = await g41.program.inputValue();
  await g41.program.fill(text.replace("N60 G1 X26", "N60 G1 X26 Q?7"));
  const list = page.locator("#diagnostics li");
  await expect(list.first()).toBeVisible();
  await expect(page.locator("#diagnostics")).toContainText("line 8");
  await list.first().getByRole("button").click();
  await expect(page.locator(".copy .current")).toContainText("Q?7");
  await page.keyboard.press("Control+z");
  await expect(list).toHaveCount(0);
  expect(g41.errors).toEqual([]);
});

test("nonsense, nothing and a program without a contour are no failure", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const good = await g41.program.inputValue();
  for (const text of ["", "%", "hello world\n#@!", "G0 X1 Y1\nM30", "G41 D1", "G1 G41 D1 XNaN"]) {
    await g41.program.fill(text);
    await g41.settled();
    await expect(page.locator("#diagnostics .summary")).not.toContainText("Error:");
  }
  await g41.program.fill(good);
  await expect(g41.output).toHaveValue(/G1/);
  expect(g41.errors).toEqual([]);
});

test("a loop without end that is typed does not hold up the text that ends it", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  // As many moves as a program may make, which takes seconds at least.
  await g41.program.fill("o1 while [1]\nG1 X1 F100\nX2\no1 endwhile\nM30\n");
  await page.waitForTimeout(2500);
  await g41.program.fill("G1 X1 F100\nX42\nM30\n");
  await expect(g41.output).toHaveValue(/X42/, { timeout: 10_000 });
  await g41.settled();
  expect(g41.errors).toEqual([]);
});

test("the caret in the text and the point in the picture are linked", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const place = await g41.locator();
  await page.mouse.click(...place([35, 40]));
  await expect(page.locator(".copy .current")).toHaveText("N70 X35 Y40");
  const before = await g41.canvas.evaluate((c) => (c as HTMLCanvasElement).toDataURL());
  await g41.program.focus();
  await page.keyboard.press("Control+Home");
  for (let i = 0; i < 16; i += 1) await page.keyboard.press("ArrowDown");
  await expect(page.locator(".copy .current")).toContainText("N150 G3");
  await g41.frames(2);
  expect(await g41.canvas.evaluate((c) => (c as HTMLCanvasElement).toDataURL())).not.toBe(before);
});

test("a rapid move there and back many times is drawn once, and stays dotted", async ({ page }) => {
  await page.addInitScript(() => {
    const drawn = { lines: 0 };
    Object.assign(window, { drawn });
    const { lineTo } = Path2D.prototype;
    Path2D.prototype.lineTo = function (this: Path2D, x: number, y: number) {
      if (x === 50 || x === 10) drawn.lines += 1;
      return lineTo.call(this, x, y);
    };
  });
  const g41 = new G41Page(page);
  await g41.open();
  await g41.program.fill(`G21 G90\nG0 X10 Y0 Z5\n${"G0 X50\nG0 X10\n".repeat(200)}G1 X20 F300\n`);
  await g41.settled();
  const lines = await page.evaluate(
    () => (window as unknown as { drawn: { lines: number } }).drawn.lines,
  );
  expect(lines, "lines to the ends of the way").toBeGreaterThan(0);
  expect(lines, "lines to the ends of the way").toBeLessThan(20);
});
