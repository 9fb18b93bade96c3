// Text and picture point at each other; diagnostics stand beside their lines.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

/** A contour between free moves, the third of which is not understood. */
const PROGRAM = `G21 G90
G0 X-20 Y0 Z5
G1 Z-2 F100
G1 X-20 Y40 F300 Q
G1 X-20 Y-20
G1 G41 D1 X0 Y0
Y30
X30
G40 X30 Y50
G0 Z5
M30
`;

test("a diagnostic stands beside its line, and its mark shows the place", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "part.nc", text: PROGRAM });
  const line = page.locator(".copy > div").nth(3);
  await expect(line).toHaveAttribute("data-remark", /Q/);
  const number = page.locator(".gutter > div").nth(3);
  await expect(number).toHaveClass(/has-(error|warning)/);
  const before = await g41.canvas.evaluate((c) => (c as HTMLCanvasElement).toDataURL());
  await number.click();
  await expect(line).toHaveClass(/current/);
  await expect(page.locator("#diagnostics [aria-pressed=true]")).toHaveCount(1);
  await g41.frames(2);
  expect(await g41.canvas.evaluate((c) => (c as HTMLCanvasElement).toDataURL())).not.toBe(before);
});

test("the line of the move under the pointer is marked, compensated or not", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "part.nc", text: PROGRAM });
  await g41.settled();
  const place = await g41.locator();
  await page.mouse.move(...place([-20, 10]));
  await expect(page.locator(".copy .hovered")).toHaveText("G1 X-20 Y40 F300 Q");
  await page.mouse.click(...place([-20, 10]));
  await expect(page.locator(".copy .current")).toHaveText("G1 X-20 Y40 F300 Q");
  await page.mouse.move(...place([15, 35]));
  await expect(page.locator(".copy .hovered")).toHaveText("X30");
});

test("lathe programs are shown in z and x", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = `G18 G21 G90
G0 X30 Z5
G1 G42.1 D2 X20 Z0 F100
Z-40
G2 X30 Z-50 R10
G40 X40
M30
`;
  await g41.drop({ name: "shaft.ngc", text });
  await g41.settled();
  const box = await g41.canvas.boundingBox();
  if (!box) throw new Error("the canvas is not shown");
  await page.mouse.move(box.x + 60, box.y + 60);
  await expect(page.locator("#readout")).toHaveText(/^Z -?[\d.]+ {2}X [\d.]+$/);
  // The shaft lies along z, at x = 20 and one radius above.
  const place = await g41.locator();
  await page.mouse.move(...place([-20, 21]));
  await expect(page.locator(".copy .hovered")).toHaveText("Z-40");
  expect(g41.errors).toEqual([]);
});

test("where the lead-out goes back along the lead-in, both are dashed", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("rooms");
  await g41.frames(3);
  const where = await g41.locator();
  const box = await g41.canvas.boundingBox();
  const [[x, top], [, bottom]] = [where([22, 24]), where([22, 8])];
  const gaps = await g41.base.evaluate(
    (element, [left, from, to]) => {
      const canvas = element as HTMLCanvasElement;
      const scale = canvas.width / canvas.clientWidth;
      const height = Math.round((to - from) * scale);
      const data = canvas
        .getContext("2d")
        ?.getImageData(Math.round(left * scale), Math.round(from * scale), 1, height).data;
      const green = Array.from({ length: height }, (_, i) => data?.[4 * i + 1] ?? 0);
      const [light, dark] = [Math.max(...green), Math.min(...green)];
      return green.filter((value) => value > (light + dark) / 2).length / height;
    },
    [x - (box?.x ?? 0), top - (box?.y ?? 0), bottom - (box?.y ?? 0)] as const,
  );
  expect(gaps, "four of ten parts of it are gaps").toBeGreaterThan(0.33);
});
