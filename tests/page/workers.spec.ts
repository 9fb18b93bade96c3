// Workers that do not load, that throw, and that never answer: the page says so, and goes on.
import { expect, type Page, type Route, test } from "@playwright/test";
import { G41Page } from "./page";

const SQUARE = "G0 X-20 Y0\nG1 G41 D1 X0 F300\nY40\nX30\nG40 Y60\nM30\n";
const COMPUTE = /compute\.worker.*\.js/;

/** Answers for the script of a worker; returns how often it was asked for. */
async function instead(
  page: Page,
  script: RegExp,
  answer: (route: Route, count: number) => Promise<void>,
): Promise<() => number> {
  let count = 0;
  await page.route(script, (route) => {
    count += 1;
    return answer(route, count);
  });
  return () => count;
}

const lost = (route: Route) => route.abort();
const written = (body: string) => (route: Route) =>
  route.fulfill({ contentType: "text/javascript", body });

/** A worker that throws once it is asked for something. */
const throws = written('addEventListener("message", () => { throw new Error("out of memory"); });');
/** A worker that never answers. */
const silent = written('addEventListener("message", () => {});');

test("a worker that does not load is told, and tried again once something is asked", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  const asked = await instead(page, COMPUTE, (route, count) =>
    count === 1 ? lost(route) : route.continue(),
  );
  await page.goto("./");
  await expect(page.locator("#diagnostics .summary")).toHaveText(/could not be started/);
  await expect(page.locator("#stage")).toHaveAttribute("aria-busy", "false");
  await expect(page.locator("#description")).toHaveText(/could not be started/);
  await page.waitForTimeout(500);
  expect(asked(), "not tried again and again").toBe(1);
  await g41.program.fill(SQUARE);
  await expect(g41.output).toHaveValue(/X-5/);
  await expect(page.locator("#diagnostics .summary")).toHaveText(/Nothing found/);
});

test("a worker that throws is told, and another takes what is asked next", async ({ page }) => {
  const g41 = new G41Page(page);
  const asked = await instead(page, COMPUTE, (route, count) =>
    count === 1 ? throws(route) : route.continue(),
  );
  await page.goto("./");
  await expect(page.locator("#diagnostics .summary")).toHaveText(/out of memory/);
  expect(asked(), "another is started when it is needed").toBe(1);
  await g41.program.fill(SQUARE);
  await expect(g41.output).toHaveValue(/X-5/);
});

test("what waits for a worker that throws is given to another", async ({ page }) => {
  const g41 = new G41Page(page);
  const slow = written(
    'addEventListener("message", () => setTimeout(() => { throw new Error("late"); }, 800));',
  );
  await instead(page, COMPUTE, (route, count) => (count === 1 ? slow(route) : route.continue()));
  await page.goto("./");
  await page.waitForTimeout(300);
  await g41.program.fill(SQUARE);
  await expect(g41.output).toHaveValue(/X-5/);
  // The failure was of a program that is gone.
  await expect(page.locator("#diagnostics .summary")).toHaveText(/Nothing found/);
  await expect(page.locator("#stage")).toHaveAttribute("aria-busy", "false");
});

test("a worker that never answers is given up for what is asked next", async ({ page }) => {
  const g41 = new G41Page(page);
  const asked = await instead(page, COMPUTE, (route, count) =>
    count === 1 ? silent(route) : route.continue(),
  );
  await page.goto("./");
  await expect(page.locator("#stage")).toHaveAttribute("aria-busy", "true");
  // As long as it may take before it is given up.
  await page.waitForTimeout(1700);
  await g41.program.fill(SQUARE);
  await expect(g41.output).toHaveValue(/X-5/);
  expect(asked(), "workers").toBe(2);
});

test("long work that never ends is cancelled, also twice", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.output.inputValue();
  await instead(page, COMPUTE, silent);
  const text = `${"G1 X1 Y2 F100\n".repeat(120_000)}M30\n`;
  for (let i = 0; i < 2; i += 1) {
    await g41.drop({ name: "relief.nc", text });
    // Of the first time the worker is one that answers.
    await page.getByRole("button", { name: "Cancel" }).click();
    await expect(page.locator("#work")).toBeHidden();
    await expect(page.locator(".notice")).toHaveText("relief.nc: cancelled.");
  }
  await page.unroute(COMPUTE);
  await page.waitForTimeout(1700);
  await page.getByLabel("Tool radius in mm").fill("2");
  await page.getByLabel("Tool radius in mm").press("Enter");
  await expect(g41.output).not.toHaveValue(before);
});

test("a long program that cannot be drawn says so, and can be saved", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await instead(page, /picture\.worker.*\.js/, lost);
  await g41.drop({ name: "relief.nc", text: `${"G1 X1 Y2 F100\n".repeat(120_000)}M30\n` });
  await expect(page.locator(".notice")).toHaveText(/could not be drawn/, { timeout: 30_000 });
  await expect(page.locator("#work")).toBeHidden();
  await expect(page.getByRole("button", { name: "Save relief.grbl.nc" })).toBeEnabled();
});

test("without the worker of live edits the text is dragged all the same", async ({ page }) => {
  const g41 = new G41Page(page);
  await instead(page, /live\.worker.*\.js/, lost);
  await g41.open();
  const before = await g41.program.inputValue();
  const place = await g41.locator();
  await g41.drag(place([44, 56]), place([46, 54]));
  await expect(g41.program).not.toHaveValue(before);
  const after = await g41.program.inputValue();
  await page.keyboard.press("Control+z");
  await expect(g41.program).toHaveValue(before);
  await page.keyboard.press("Control+y");
  await expect(g41.program).toHaveValue(after);
});

for (const [panel, button, script, failure] of [
  ["deviation", "Deviation plot", /deviation\.worker.*\.js/, ".deviation-failure"],
  ["motion", "Motion", /motion\.worker.*\.js/, ".motion-failure"],
] as const) {
  test(`the worker of the panel of ${panel}: not loaded, throwing, and well again`, async ({
    page,
  }) => {
    const g41 = new G41Page(page);
    await instead(page, script, (route, count) =>
      count === 1 ? lost(route) : count === 2 ? throws(route) : route.continue(),
    );
    await g41.open();
    await page.getByRole("button", { name: button }).click();
    const said = page.locator(`#${panel} ${failure}`).first();
    await expect(said).toHaveText(/could not be started/);
    await expect(page.locator(`#${panel}`)).toHaveAttribute("aria-busy", "false");
    const radius = page.getByLabel("Tool radius in mm");
    await radius.fill("2");
    await radius.press("Enter");
    await expect(said).toHaveText(/out of memory/);
    await radius.fill("3");
    await radius.press("Enter");
    await expect(said).toHaveText("");
    await expect(page.locator(`#${panel} figure`).first()).toBeVisible();
  });
}
