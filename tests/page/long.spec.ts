// A point of a very long program is dragged: the picture follows at once, the text when it rests.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

/** A wavy line of very many type points, 5 mm apart. */
function program(count: number): string {
  const lines = ["G17 G21 G90", "G0 X-20 Y-20", "G1 G41 D1 X0 Y0 F400"];
  for (let i = 1; i <= count; i += 1) {
    const y = (8 * Math.sin(i / 3)).toFixed(3);
    lines.push(`${i === 1 ? "G05 " : ""}X${5 * i} Y${y}`);
  }
  return [...lines, `G1 G40 X${5 * count + 20} Y-20`, "M30", ""].join("\n");
}

test("the picture follows a drag at once, and the long text when it rests", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = program(6000);
  await g41.drop({ name: "long.nc", text });
  await expect(g41.output).toHaveValue(/X29/, { timeout: 30_000 });
  await g41.settled();
  // Near enough to tell one point from the next, about the start.
  await g41.canvas.focus();
  for (let i = 0; i < 24; i += 1) {
    const [x, y] = (await g41.locator())([10, 0]);
    const box = await g41.canvas.boundingBox();
    if (!box) throw new Error("the canvas is not shown");
    const inside = (value: number, from: number, size: number) =>
      Math.min(from + size - 20, Math.max(from + 20, value));
    await page.mouse.move(inside(x, box.x, box.width), inside(y, box.y, box.height));
    const [nextX] = (await g41.locator())([15, 0]);
    if (nextX - x > 40) break;
    await page.mouse.move(inside(x, box.x, box.width), inside(y, box.y, box.height));
    await page.mouse.wheel(0, -500);
    await g41.frames(2);
  }
  const place = await g41.locator();
  const at: [number, number] = [10, Number((8 * Math.sin(2 / 3)).toFixed(3))];
  const before = await g41.program.inputValue();
  await page.mouse.move(...place(at));
  await page.mouse.down();
  await page.mouse.move(...place([11, at[1] + 1]));
  await g41.frames(12);
  const first = await g41.picture();
  for (const dx of [1.5, 2, 2.5]) {
    await page.mouse.move(...place([at[0] + dx, at[1] + dx]));
    await g41.frames(4);
  }
  expect(await g41.picture(), "the picture has followed").not.toBe(first);
  expect(await g41.program.inputValue(), "the text has not").toBe(before);
  await expect(g41.program, "it follows when the drag rests").toHaveValue(/^X12\.5 Y/m);
  await page.mouse.up();
  await g41.settled();
  await page.keyboard.press("Control+z");
  await expect(g41.program, "one drag is one step").toHaveValue(before);
  expect(g41.errors).toEqual([]);
});
