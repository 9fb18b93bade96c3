// The plot of deviations: on demand, both methods, in numbers that agree with what the core says.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

/** The largest deviation that a plot tells [µm]. */
async function worst(g41: G41Page, name: string): Promise<number> {
  const caption = g41.page.locator(".deviation-plot", { hasText: name }).locator("figcaption");
  const text = (await caption.textContent()) ?? "";
  return Number(/at most ([\d.]+) µm/.exec(text)?.[1]);
}

test("exact keeps its tolerance, type points are off by what the core reports", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open("ellipse");
  await expect(page.locator("#deviation")).toBeHidden();
  const button = page.getByRole("button", { name: "Deviation plot" });
  await button.click();
  await expect(button).toHaveAttribute("aria-expanded", "true");
  await expect(page.locator(".deviation-plot")).toHaveCount(2);
  expect(await worst(g41, "Exact")).toBeGreaterThan(0);
  expect(await worst(g41, "Exact")).toBeLessThanOrEqual(1);
  await page.getByRole("radio", { name: "Type points" }).check();
  const row = page.locator(".diagnostic-info", { hasText: "off the true equidistant" });
  const reported = /up to ([\d.]+) mm/.exec((await row.textContent()) ?? "")?.[1];
  const measured = await worst(g41, "Type points");
  expect(measured / 1000 / Number(reported)).toBeGreaterThan(0.97);
  expect(measured / 1000 / Number(reported)).toBeLessThan(1.03);
  await button.click();
  await expect(page.locator("#deviation")).toBeHidden();
  expect(g41.errors).toEqual([]);
});

test("a spline is measured from its first type point to its last", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.program.fill(
    "G0 X-20 Y0\nG1 G41 D1 X0 Y0 F300\nG05 X20 Y4\nX40 Y0\nX60 Y4\nX80 Y0\nG1 G40 X100\nM30\n",
  );
  await g41.settled();
  await page.getByRole("button", { name: "Deviation plot" }).click();
  await expect(page.locator(".deviation-plot")).toHaveCount(2);
  for (const plot of await page.locator(".deviation-plot svg").all()) {
    const [curve, whole] = await Promise.all(
      [".curve", ".band"].map((name) =>
        plot.locator(name).evaluate((shape) => (shape as SVGGraphicsElement).getBBox().width),
      ),
    );
    // The ends are cut off beside the leads.
    expect((curve ?? 0) / (whole ?? 0)).toBeGreaterThan(0.9);
  }
});

test("lines and arcs are not off at all, however their corners are joined", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("star");
  await page.getByRole("button", { name: "Deviation plot" }).click();
  await expect(page.locator(".deviation-plot")).toHaveCount(2);
  expect(await worst(g41, "Exact")).toBeLessThan(1e-6);
  expect(await worst(g41, "Type points")).toBeLessThan(1e-6);
});

test("the plot follows the settings, and the pointer on it moves the tool", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("cam");
  await page.getByRole("button", { name: "Deviation plot" }).click();
  const plot = page.locator(".deviation-plot svg").first();
  await expect(plot).toHaveAttribute(
    "aria-label",
    /Exact: at most .* within the tolerance of 1 µm/,
  );
  const tolerance = page.getByLabel("Tolerance in mm");
  await tolerance.fill("0.01");
  await tolerance.press("Enter");
  await expect(plot).toHaveAttribute("aria-label", /within the tolerance of 10 µm/);
  const tool = () => g41.canvas.evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  await plot.hover({ position: { x: 150, y: 30 } });
  await expect(page.locator(".deviation-at").first()).toHaveText(/^at [\d.]+ mm: [+−][\d.]+ µm$/);
  await g41.frames(2);
  const first = await tool();
  await plot.hover({ position: { x: 300, y: 30 } });
  await g41.frames(2);
  expect(await tool()).not.toBe(first);
});

test("the numbers of the axis stand near what the curve reaches", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("ellipse");
  await page.getByRole("button", { name: "Deviation plot" }).click();
  const plots = page.locator(".deviation-plot");
  await expect(plots).toHaveCount(2);
  // The spline through the moved type points is off by 118 µm.
  await expect(plots.last().locator("text", { hasText: /^\+100$/ })).toHaveCount(1);
  await expect(plots.last().locator("text", { hasText: /^−100$/ })).toHaveCount(1);
});

test("of a program without compensation it says so, and shows no plots", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.program.fill("G21 G90\nG0 X0 Y0\nG1 X20 Y4 F300\nX40 Y0\nM30\n");
  await page.getByRole("button", { name: "Deviation plot" }).click();
  const nothing = page.locator(".deviation-nothing");
  await expect(nothing, "it is said").toHaveText(/Nothing here is compensated/);
  await expect(nothing).toBeVisible();
  await expect(page.locator(".deviation-plot"), "no plot of nothing").toHaveCount(0);
  // And it is measured as soon as there is something.
  await g41.program.fill("G0 X-20 Y0\nG1 G41 D1 X0 Y0 F300\nX40 Y0\nG1 G40 X100\nM30\n");
  await expect(page.locator(".deviation-plot"), "two plots").toHaveCount(2);
  await expect(nothing).toBeHidden();
  expect(g41.errors).toEqual([]);
});
