// Everything that the pointer does can be done by keys, and is told in words.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

test("Tab walks the points and leaves the picture behind the last", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("letter");
  await g41.canvas.focus();
  const names: string[] = [];
  for (let i = 0; i < 40; i += 1) {
    await page.keyboard.press("Tab");
    if (!(await g41.canvas.evaluate((canvas) => canvas === document.activeElement))) break;
    names.push((await page.locator(".point-name").textContent()) ?? "");
  }
  expect(names[0]).toBe("Start of the lead-in");
  expect(names).toContain("Type point 5 of spline 2");
  expect(names.at(-1)).toBe("End of the lead-out");
  expect(new Set(names).size).toBe(names.length);
  await page.keyboard.press("Shift+Tab");
  await expect(g41.canvas).toBeFocused();
});

test("arrow keys move the selected point by 1, 10 and 0.1 mm", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.canvas.focus();
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("Tab");
  const before = await g41.program.inputValue();
  await page.keyboard.press("ArrowRight");
  await expect(g41.program).toHaveValue(/^N40 X1 Y42$/m);
  await page.keyboard.press("Shift+ArrowUp");
  await expect(g41.program).toHaveValue(/^N40 X1 Y52$/m);
  await page.keyboard.press("Alt+ArrowDown");
  await expect(g41.program).toHaveValue(/^N40 X1 Y51\.9$/m);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("Control+z");
  await expect(g41.program).toHaveValue(before);
  await page.keyboard.press("Control+y");
  await expect(g41.program).toHaveValue(/^N40 X1 Y42$/m);
});

test("a point that is moved out of the picture stays in sight", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.canvas.focus();
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("Tab");
  for (let i = 0; i < 12; i += 1) await page.keyboard.press("Shift+ArrowUp");
  await g41.settled();
  const y = Number(await page.getByLabel("Y in mm").or(page.getByLabel("Y")).first().inputValue());
  const x = Number(await page.getByLabel("X in mm").or(page.getByLabel("X")).first().inputValue());
  const box = await g41.canvas.boundingBox();
  const [, at] = (await g41.locator())([x, y]);
  expect(at).toBeGreaterThan(box?.y ?? 0);
});

test("the selected point and the state are told in words", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const words = page.locator("#description");
  await expect(words).toContainText("1 spline");
  await expect(words).toContainText("Tool radius 5 mm");
  await g41.canvas.focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await expect(words).toContainText("Start of the contour: x 0, y 18");
});

test("one thing of a kind is told as one", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "part.nc", text: "G0 X-20 Y0\nG1 G41 D1 X0 F300\nY40\nG999\nG40 X-20\n" });
  const words = page.locator("#description");
  await expect(words, "of several, the first").toContainText("1 diagnostic: the word G999");
});

test("tabs of the programs are chosen by arrow keys", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await page.getByRole("tab", { name: "Program" }).focus();
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("tab", { name: "Compensated" })).toBeFocused();
  await expect(g41.output).toBeVisible();
  await expect(g41.program).toBeHidden();
});
