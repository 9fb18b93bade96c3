// Light and dark, wide and narrow: accessible, legible, and nothing is cut off.
import { expect, test } from "@playwright/test";
import { G41Page, violations } from "./page";

for (const scheme of ["light", "dark"] as const) {
  for (const [name, width, height] of [
    ["wide", 1440, 900],
    ["narrow", 390, 844],
  ] as const) {
    test(`${scheme}, ${name}: no violation, legible lines, no sideways scrolling`, async ({
      page,
    }, info) => {
      await page.emulateMedia({ colorScheme: scheme });
      await page.setViewportSize({ width, height });
      const g41 = new G41Page(page);
      await g41.open();
      await g41.canvas.focus();
      for (let i = 0; i < 6; i += 1) await page.keyboard.press("Tab");
      await g41.frames(3);
      await page.screenshot({ path: info.outputPath(`${scheme}-${name}.png`), fullPage: true });

      expect(await violations(page)).toEqual([]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
        width,
      );

      // What tools for accessibility cannot see: the lines on the canvas against its paper.
      const contrast = await g41.base.evaluate((element) => {
        const canvas = element as HTMLCanvasElement;
        const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data;
        if (!data) return 0;
        const luminance = (i: number) => {
          const linear = [0, 1, 2].map((k) => {
            const value = (data[i + k] ?? 0) / 255;
            return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
          }) as [number, number, number];
          return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
        };
        const paper = luminance(4 * (5 * canvas.width + 5));
        let most = 0;
        for (let i = 0; i < data.length; i += 4) {
          const [a, b] = [luminance(i), paper].sort((x, y) => y - x) as [number, number];
          most = Math.max(most, (a + 0.05) / (b + 0.05));
        }
        return most;
      });
      expect(contrast).toBeGreaterThan(7);
    });
  }
}

for (const scheme of ["light", "dark"] as const) {
  for (const [name, width, height] of [
    ["wide", 1440, 900],
    ["narrow", 390, 844],
  ] as const) {
    test(`${scheme}, ${name}: findings and plot without violation`, async ({ page }, info) => {
      await page.emulateMedia({ colorScheme: scheme });
      await page.setViewportSize({ width, height });
      const g41 = new G41Page(page);
      await g41.open("rooms");
      await page.getByRole("button", { name: "Deviation plot" }).click();
      await expect(page.locator(".deviation-plot")).toHaveCount(2);
      await page.locator(".diagnostic-uncut button").first().focus();
      await expect(page.locator(".callout")).toBeVisible();
      await page.screenshot({ path: info.outputPath(`findings-${name}.png`), fullPage: true });
      expect(await violations(page)).toEqual([]);
      const scroll = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(scroll).toBeLessThanOrEqual(width);
    });
  }
}

for (const scheme of ["light", "dark"] as const) {
  for (const [name, width, height] of [
    ["wide", 1440, 900],
    ["narrow", 390, 844],
  ] as const) {
    test(`${scheme}, ${name}: motion without violation`, async ({ page }, info) => {
      await page.emulateMedia({ colorScheme: scheme });
      await page.setViewportSize({ width, height });
      const g41 = new G41Page(page);
      await g41.open("star");
      await page.getByRole("button", { name: "Motion" }).click();
      const timeout = 60_000;
      test.setTimeout(2 * timeout);
      await expect(page.locator(".motion-plot canvas")).toHaveCount(3, { timeout });
      await expect(page.locator("#motion")).toHaveAttribute("aria-busy", "false", { timeout });
      await expect(page.locator(".motion-times .stale")).toHaveCount(0, { timeout });
      await page.getByText("More", { exact: true }).click();
      await page.getByRole("slider", { name: "Time" }).fill("300");
      await page.screenshot({ path: info.outputPath(`motion-${name}.png`), fullPage: true });
      expect(await violations(page)).toEqual([]);
      const scroll = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(scroll).toBeLessThanOrEqual(width);

      // What tools for accessibility cannot see: the letters and lines of the plots.
      const ink = await page
        .locator(".motion-plot canvas")
        .last()
        .evaluate((element) => {
          const canvas = element as HTMLCanvasElement;
          const { data } =
            canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height) ?? {};
          const paper = getComputedStyle(document.documentElement).getPropertyValue("--panel");
          const dark = Number.parseInt(paper.slice(1, 3), 16) < 128;
          let most = 0;
          for (let i = 0; data && i < data.length; i += 4) {
            const light = ((data[i] ?? 0) + (data[i + 1] ?? 0) + (data[i + 2] ?? 0)) / 3;
            if ((data[i + 3] ?? 0) > 200) most = Math.max(most, dark ? light : 255 - light);
          }
          return most;
        });
      expect(ink).toBeGreaterThan(110);
    });
  }
}

for (const scheme of ["light", "dark"] as const) {
  for (const [name, width, height] of [
    ["wide", 1440, 900],
    ["narrow", 390, 844],
  ] as const) {
    test(`${scheme}, ${name}: a very long program without violation`, async ({ page }, info) => {
      await page.emulateMedia({ colorScheme: scheme });
      await page.setViewportSize({ width, height });
      const g41 = new G41Page(page);
      await g41.open();
      const lines = ["G21 G90 G1 F500"];
      for (let i = 0; lines.length < 110_000; i += 1) {
        const [angle, radius] = [i / 150, 5 + i / 1600];
        const [x, y] = [radius * Math.cos(angle), radius * Math.sin(angle)];
        lines.push(i % 9000 === 5 ? "X?" : `X${x.toFixed(3)} Y${y.toFixed(3)}`);
      }
      await g41.drop({ name: "spiral.nc", text: [...lines, "M30", ""].join("\n") });
      const work = page.locator("#work");
      await expect(work).toBeVisible();
      expect(await violations(page)).toEqual([]);
      await expect(work).toBeHidden({ timeout: 60_000 });
      await g41.frames(10);
      await page.locator(".diagnostic button").first().click();
      await expect(page.locator(".row.current")).toHaveClass(/has-error/);
      await page.screenshot({ path: info.outputPath(`long-${name}.png`), fullPage: true });
      expect(await violations(page)).toEqual([]);
      const scroll = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(scroll).toBeLessThanOrEqual(width);
    });
  }
}

test("the button changes the scheme, and the choice stays", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "light" });
  const g41 = new G41Page(page);
  await g41.open();
  const light = await g41.picture();
  await page.getByRole("button", { name: "Dark scheme" }).click();
  await g41.frames(2);
  expect(await g41.picture()).not.toBe(light);
  await page.reload();
  await expect(page.getByRole("button", { name: "Dark scheme" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
});
