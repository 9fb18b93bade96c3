// The panel of motion: on demand, plots with limits, a player, and a cursor that picture and plots share.
import { expect, type Page, test } from "@playwright/test";
import { G41Page } from "./page";

// Planning takes seconds on a machine that is busy with much else.
test.describe.configure({ timeout: 120_000 });

/** Opens the panel and waits for the plots. */
async function opened(page: Page, example?: string): Promise<G41Page> {
  const g41 = new G41Page(page);
  await g41.open(example);
  await page.getByRole("button", { name: "Motion" }).click();
  await expect(page.locator(".motion-plot canvas")).toHaveCount(3, { timeout: 60_000 });
  await planned(page);
  return g41;
}

async function planned(page: Page): Promise<void> {
  const timeout = 60_000;
  await expect(page.locator("#motion")).toHaveAttribute("aria-busy", "false", { timeout });
  await expect(page.locator(".motion-times .stale")).toHaveCount(0, { timeout });
}

/** A time of the list [s]. */
async function time(page: Page, name: string): Promise<number> {
  const item = page.locator(".motion-times li", { hasText: name });
  const text = (await item.locator("strong").textContent()) ?? "";
  const [whole, rest] = text.replace(/ .*/, "").split(":").map(Number) as [number, number?];
  return rest === undefined ? whole : 60 * whole + rest;
}

async function enter(page: Page, field: string, value: string): Promise<void> {
  const input = page.getByLabel(field, { exact: true });
  await input.fill(value);
  await input.press("Enter");
  await page.waitForTimeout(200);
  await planned(page);
}

/** What the live layer of the picture shows. */
function drawn(g41: G41Page): Promise<string> {
  return g41.canvas.evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
}

test("the plots are loaded when they are wanted, and not before", async ({ page }) => {
  const loaded: string[] = [];
  page.on("request", (request) => loaded.push(request.url()));
  const g41 = new G41Page(page);
  await g41.open();
  await page.waitForLoadState("networkidle");
  expect(loaded.filter((url) => /motion-panel|motion\.worker/.test(url))).toEqual([]);
  await expect(page.locator("#motion")).toBeHidden();
  const button = page.getByRole("button", { name: "Motion" });
  await button.click();
  await expect(button).toHaveAttribute("aria-expanded", "true");
  await expect(page.locator(".motion-plot canvas")).toHaveCount(3, { timeout: 60_000 });
  expect(loaded.some((url) => url.includes("motion-panel"))).toBe(true);
  await button.click();
  await expect(page.locator("#motion")).toBeHidden();
  expect(g41.errors).toEqual([]);
});

test("the times of the plan, of full stops and of the textbook stand beside each other", async ({
  page,
}) => {
  const g41 = await opened(page, "star");
  const own = await time(page, "Cycle time");
  expect(own).toBeGreaterThan(0);
  expect(await time(page, "Full stops")).toBeGreaterThan(0.97 * own);
  expect(await time(page, "Textbook")).toBeGreaterThan(0);
  await expect(page.locator(".motion-times .inside")).toHaveText("keeps every limit");
  for (const [title, unit] of [
    ["Feed", "mm/min"],
    ["Acceleration", "mm/s²"],
    ["Jerk", "mm/s³"],
  ] as const) {
    const plot = page.getByRole("img", {
      name: new RegExp(`^${title}: at most .* ${unit}, limit`),
    });
    await expect(plot).toBeVisible();
  }
  expect(g41.errors).toEqual([]);
});

test("limits, override and method change the time, and are kept over a reload", async ({
  page,
}) => {
  const g41 = await opened(page, "star");
  await page.getByRole("radio", { name: "Fastest" }).check();
  await page.waitForTimeout(200);
  await planned(page);
  const before = await time(page, "Cycle time");
  await enter(page, "Jerk in mm/s³", "5000");
  const slow = await time(page, "Cycle time");
  expect(slow).toBeGreaterThan(1.2 * before);
  await expect(page.getByRole("img", { name: /^Jerk: .*limit 5,000 mm/ })).toBeVisible();
  await page.getByRole("combobox", { name: "Machine" }).selectOption("Fast machine");
  await page.waitForTimeout(200);
  await planned(page);
  expect(await time(page, "Cycle time")).toBeLessThan(before);
  await expect(page.getByLabel("Velocity in mm/min")).toHaveValue("30000");
  await page.reload();
  await page.getByRole("button", { name: "Motion" }).click();
  await expect(page.getByLabel("Velocity in mm/min")).toHaveValue("30000");
  await expect(page.getByRole("combobox", { name: "Machine" })).toHaveValue("Fast machine");
  expect(g41.errors).toEqual([]);
});

test("by the textbook's method the plan is held beside the fast one", async ({ page }) => {
  await opened(page, "star");
  const fast = await time(page, "Cycle time");
  const textbook = await time(page, "Textbook");
  await page.getByRole("radio", { name: "Textbook" }).check();
  await page.waitForTimeout(200);
  await planned(page);
  expect(await time(page, "Cycle time")).toBe(textbook);
  expect(await time(page, "Fast")).toBe(fast);
});

test("what has no motion shows none, and leaves none of another program", async ({ page }) => {
  const g41 = await opened(page, "star");
  await g41.drop({ name: "empty.nc", text: "(nothing)\n" });
  await expect(page.locator(".motion-failure")).toContainText("moves nothing");
  await expect(page.locator(".motion-plots")).toBeHidden();
  await expect(page.locator(".motion-times")).toBeHidden();
  await expect(page.getByLabel("Velocity in mm/min")).toBeVisible();
  await g41.drop({ name: "line.nc", text: "G1 X10 F300\n" });
  await expect(page.locator(".motion-plots")).toBeVisible();
  await expect(page.locator(".motion-failure")).toBeEmpty();
  expect(g41.errors).toEqual([]);
});

test("on a phone a time of minutes stays on one line", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const g41 = await opened(page, "star");
  await g41.drop({ name: "slow.nc", text: "G1 X100 F60\nX0\n" });
  const time = page.locator(".motion-times strong").first();
  await expect(time).toHaveText(/min/);
  const { height, size } = await time.evaluate((e) => ({
    height: e.getBoundingClientRect().height,
    size: Number.parseFloat(getComputedStyle(e).fontSize),
  }));
  expect(height, "one line").toBeLessThan(2 * size);
});

test("the picture keeps the part in sight beside the panel, also where there is little room", async ({
  page,
}) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  const g41 = await opened(page, "star");
  const box = await g41.canvas.boundingBox();
  expect(box?.height).toBeGreaterThan(220);
  const where = await g41.locator();
  const [, top] = where([0, 36]);
  const [, bottom] = where([0, -38]);
  expect(top).toBeGreaterThan(box?.y ?? 0);
  expect(bottom).toBeLessThan((box?.y ?? 0) + (box?.height ?? 0));
  expect(bottom - top).toBeGreaterThan(100);
});

test("the rules of interpolation are compared along the splines of the program", async ({
  page,
}) => {
  const g41 = await opened(page, "cam");
  const rules = page.locator(".motion-rules");
  await expect(rules.getByRole("table")).toHaveCount(0);
  await rules.getByText("Interpolation rules compared").click();
  await expect(rules.getByRole("row")).toHaveCount(8, { timeout: 30_000 });
  const errors = async (name: string) => {
    const cells = rules.getByRole("row", { name }).getByRole("cell");
    return (await cells.allTextContents()).map((text) =>
      Number(text.replace("−", "-").replace("< ", "")),
    );
  };
  const first = await errors("Taylor, first order");
  const second = await errors("Taylor, second order");
  // At the feed of the program and at that of the machine; half the order, half the digits.
  expect(first).toHaveLength(2);
  expect(first[0]).toBeLessThan(first[1] as number);
  expect(second[1]).toBeLessThan((first[1] as number) / 3);
  expect(first[1]).toBeGreaterThan(1e-4);
  await g41.drop({ name: "line.nc", text: "G1 X10 F300\n" });
  await expect(rules).toContainText("compensates no spline");
  expect(g41.errors).toEqual([]);
});

test("one panel is open below the picture", async ({ page }) => {
  await opened(page);
  await page.getByRole("button", { name: "Deviation plot" }).click();
  await expect(page.locator("#deviation")).toBeVisible();
  await expect(page.locator("#motion")).toBeHidden();
  await page.getByRole("button", { name: "Motion" }).click();
  await expect(page.locator("#deviation")).toBeHidden();
  await expect(page.locator("#motion")).toBeVisible();
});

test("the motion follows the program", async ({ page }) => {
  const g41 = await opened(page, "star");
  const before = await time(page, "Cycle time");
  const text = await g41.program.inputValue();
  await g41.program.fill(text.replace(/F\d+/g, "F60"));
  await page.waitForTimeout(300);
  await planned(page);
  expect(await time(page, "Cycle time")).toBeGreaterThan(2 * before);
});

test("a shorter motion takes the player to its end", async ({ page }) => {
  const g41 = await opened(page, "star");
  const slider = page.getByRole("slider", { name: "Time" });
  await slider.focus();
  await page.keyboard.press("End");
  const before = await time(page, "Cycle time");
  await enter(page, "Tool radius in mm", "1");
  await page.getByLabel("Fastest").check({ force: true });
  await page.waitForTimeout(300);
  await planned(page);
  expect(await time(page, "Cycle time")).toBeLessThan(before);
  await expect(page.locator(".motion-said").first()).toContainText("mm/min");
  expect(g41.errors).toEqual([]);
});

test("the tool plays, pauses, and is taken along by mouse and keys", async ({ page }) => {
  const g41 = await opened(page, "star");
  const slider = page.getByRole("slider", { name: "Time" });
  const still = await drawn(g41);
  await page.getByRole("button", { name: "Play" }).click();
  await expect.poll(async () => Number(await slider.inputValue())).toBeGreaterThan(5);
  expect(await drawn(g41)).not.toBe(still);
  await page.getByRole("button", { name: "Pause" }).click();
  const paused = await slider.inputValue();
  await page.waitForTimeout(200);
  expect(await slider.inputValue()).toBe(paused);
  await slider.focus();
  await page.keyboard.press("End");
  const total = await time(page, "Cycle time");
  await expect(slider).toHaveAttribute(
    "aria-valuetext",
    `${total.toFixed(2)} s of ${total.toFixed(2)} s`,
  );
  await page.keyboard.press("Home");
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("Shift+ArrowRight");
  await expect(slider).toHaveAttribute("aria-valuetext", /^0\.03 s of/);
  await page.keyboard.press("Space");
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  expect(g41.errors).toEqual([]);
});

test("time passes as fast as it is asked to", async ({ page }) => {
  await opened(page, "star");
  for (const speed of [1, 0.1]) {
    await page.getByLabel("Speed").selectOption(String(speed));
    await page.getByRole("slider", { name: "Time" }).fill("0");
    const began = Date.now();
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForTimeout(1000);
    await page.getByRole("button", { name: "Pause" }).click();
    // A busy machine takes its time to click.
    const passed = (Date.now() - began) / 1000;
    const text = await page.locator(".motion-time").textContent();
    const reached = Number.parseFloat(text ?? "") / speed;
    expect(reached).toBeGreaterThan(0.7);
    expect(reached).toBeLessThan(passed + 0.1);
  }
  await page.getByLabel("Speed").selectOption("100");
  await page.getByRole("slider", { name: "Time" }).fill("0");
  await page.getByRole("button", { name: "Play" }).click();
  // At a hundred times its speed it is soon at its end, where it pauses.
  await expect(page.getByRole("button", { name: "Play" })).toBeVisible();
  await expect(page.getByRole("slider", { name: "Time" })).toHaveValue("1000");
});

test("while it plays the line of the program is marked", async ({ page }) => {
  await opened(page, "star");
  await page.getByLabel("Speed").selectOption("10");
  await page.getByRole("button", { name: "Play" }).click();
  await expect(page.locator("#panel-program .gutter .current")).toHaveCount(1);
  const first = await page.locator("#panel-program .gutter .current").textContent();
  await expect(page.locator("#panel-program .gutter .current")).not.toHaveText(first ?? "");
});

test("who wants less motion sees the tool in steps", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await opened(page, "star");
  const slider = page.getByRole("slider", { name: "Time" });
  await page.evaluate(() => {
    const seen = new Set<string>();
    (window as unknown as { seen: Set<string> }).seen = seen;
    const output = document.querySelector(".motion-time") as HTMLElement;
    new MutationObserver(() => seen.add(output.textContent ?? "")).observe(output, {
      childList: true,
    });
  });
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForTimeout(1600);
  const steps = await page.evaluate(() => (window as unknown as { seen: Set<string> }).seen.size);
  expect(steps).toBeGreaterThanOrEqual(2);
  expect(steps).toBeLessThanOrEqual(4);
  expect(Number(await slider.inputValue())).toBeGreaterThan(0);
});

test("on a low screen all plots are in sight", async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 700 });
  await opened(page, "star");
  const last = page.locator(".motion-plot").last();
  const bottom = await last.evaluate((e) => e.getBoundingClientRect().bottom);
  expect(bottom, "the last plot ends within the window").toBeLessThanOrEqual(700);
});

test("title and lines of a plot are named at one height", async ({ page }) => {
  await opened(page, "star");
  const bottoms = await page
    .locator(".motion-plot figcaption")
    .first()
    .locator("strong, .motion-key")
    .evaluateAll((all) =>
      all.map((e) => {
        const range = document.createRange();
        range.selectNodeContents(e.lastChild as Node);
        return range.getBoundingClientRect().bottom;
      }),
    );
  expect(bottoms.length, "the title, and two lines").toBe(3);
  for (const bottom of bottoms) {
    expect(bottom, "where a name ends").toBeCloseTo(bottoms[0] as number, 0);
  }
});

test("while the tool runs it is told where it is, on all three axes", async ({ page }) => {
  const g41 = await opened(page, "star");
  await g41.drop({
    name: "ramp.nc",
    text: "G21 G90 G94 G17\nG0 X0 Y0 Z5\nG1 Z-2 F300\nG1 G41 D1 X10 Y0 F300\nX20 Z-6\nG40 X30 Y10\nM30\n",
  });
  await g41.settled();
  const readout = page.locator("#readout");
  const slider = page.getByRole("slider", { name: "Time" });
  await expect(page.locator("#motion")).toHaveAttribute("aria-busy", "false");
  await expect(async () => {
    await slider.fill("999");
    await slider.fill("1000");
    await expect(readout).toHaveText("X 30.000  Y 10.000  Z -6.000", { timeout: 500 });
  }).toPass();
});

test("the pointer on a plot moves the tool, a click takes the player there", async ({ page }) => {
  const g41 = await opened(page, "star");
  const plot = page.getByRole("img", { name: /^Jerk/ });
  const box = await plot.boundingBox();
  if (!box) throw new Error("the plot is not shown");
  const at = async (part: number) => {
    await page.mouse.move(box.x + part * box.width, box.y + box.height / 2);
    await g41.frames(2);
    return drawn(g41);
  };
  const first = await at(0.3);
  await expect(page.locator(".motion-said").first()).toHaveText(
    /^[\d.]+ s: [\d.]+ of 400 mm\/min$/,
  );
  expect(await at(0.6)).not.toBe(first);
  await page.mouse.click(box.x + 0.6 * box.width, box.y + box.height / 2);
  const slider = page.getByRole("slider", { name: "Time" });
  expect(Number(await slider.inputValue())).toBeGreaterThan(590);
  expect(Number(await slider.inputValue())).toBeLessThan(610);
});

test("the pointer near the path shows on the plots where that is", async ({ page }) => {
  const g41 = await opened(page, "star");
  const box = await g41.canvas.boundingBox();
  if (!box) throw new Error("the canvas is not shown");
  const said = page.locator(".motion-said").first();
  const seen = new Set<string>();
  for (let i = 1; i < 12; i += 1) {
    await page.mouse.move(box.x + (i / 12) * box.width, box.y + box.height / 2);
    seen.add((await said.textContent()) ?? "");
  }
  expect(seen.size).toBeGreaterThan(3);
});

test("plots against the length of the way, and closer", async ({ page }) => {
  const g41 = await opened(page, "star");
  const plots = page.locator(".motion-plots");
  const whole = await plots.screenshot();
  await page.getByRole("radio", { name: "Length" }).check();
  await g41.frames(2);
  expect((await plots.screenshot()).equals(whole)).toBe(false);
  await page.getByRole("radio", { name: "Time" }).check();
  const closer = page.getByRole("button", { name: "Plots closer" });
  for (let i = 0; i < 3; i += 1) await closer.click();
  await g41.frames(2);
  expect((await plots.screenshot()).equals(whole)).toBe(false);
  const box = await page.getByRole("img", { name: /^Feed/ }).boundingBox();
  if (!box) throw new Error("the plot is not shown");
  await page.mouse.dblclick(box.x + 20, box.y + 20);
  expect(g41.errors).toEqual([]);
});

test("a limit that cannot be is brought into its range", async ({ page }) => {
  await opened(page);
  await enter(page, "Acceleration in mm/s²", "0");
  await expect(page.getByLabel("Acceleration in mm/s²")).toHaveValue("1");
});

test("between two pieces the tool flies, by the feed of a rapid move, and goes down by that of a plunge", async ({
  page,
}) => {
  const g41 = await opened(page, "rooms");
  const slider = page.getByRole("slider", { name: "Time" });
  const feed = page.locator(".motion-plot").first();
  const seen = new Map<string, string>();
  // The first way, by the heights and places that the program and its pieces have.
  for (let step = 55; step < 80; step += 1) {
    await slider.fill(String(step));
    const place = (await page.locator("#readout").textContent()) ?? "";
    const [x = 0, , z = 0] = (place.match(/-?[\d.]+/g) ?? []).map(Number);
    const limit = /of ([\d,]+) mm\/min/.exec((await feed.textContent()) ?? "")?.[1] ?? "";
    if (z > 4.99 && x > 30 && x < 60) seen.set("across", limit);
    if (z < 4.9 && x > 66) seen.set("down", limit);
  }
  expect(Object.fromEntries(seen)).toEqual({ across: "12,000", down: "120" });
  expect(g41.errors).toEqual([]);
});
