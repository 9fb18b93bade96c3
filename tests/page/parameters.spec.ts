// Radius, side, corner, spline method and tolerance, and what they do to the tool path.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

test("radius by field and by slider, one step of undo each", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.output.inputValue();
  const field = page.getByLabel("Tool radius in mm");
  await field.fill("2.5");
  await field.press("Enter");
  await expect(g41.output).not.toHaveValue(before);
  const second = await g41.output.inputValue();
  const slider = page.getByRole("slider", { name: "Tool radius" });
  await expect(slider).toHaveValue("2.5");
  await slider.focus();
  for (let i = 0; i < 5; i += 1) await page.keyboard.press("ArrowRight");
  await expect(field).toHaveValue("3");
  await page.keyboard.press("Control+z");
  await expect(field).not.toHaveValue("3");
  for (let i = 0; i < 6 && (await field.inputValue()) !== "5"; i += 1) {
    await page.keyboard.press("Control+z");
  }
  await expect(g41.output).toHaveValue(before);
  expect(second).not.toBe(before);
});

test("a value entered once more is no step of undo, and Escape takes a wrong one back", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const undo = page.getByRole("button", { name: "Undo" });
  const field = page.getByLabel("Tool radius in mm");
  await field.focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await expect(undo).toBeDisabled();
  await field.fill("2 +");
  await field.press("Enter");
  await expect(field).toHaveAttribute("aria-invalid", "true");
  await expect(field).toHaveAccessibleDescription(/no number.* Esc brings .* back/);
  await field.press("Escape");
  await expect(field).toHaveValue("5");
  await expect(field).not.toHaveAttribute("aria-invalid");
  await expect(field).toHaveAccessibleDescription("");
});

test("a radius below zero, or beyond what is allowed, is refused with the reason", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.output.inputValue();
  const field = page.getByLabel("Tool radius in mm");
  for (const [radius, why] of [
    ["-3", /less than 0 mm; for the other side choose G41 or G42; Esc brings 5 back/],
    ["1001", /more than 1000 mm; Esc brings 5 back/],
  ] as const) {
    await field.fill(radius);
    await field.press("Enter");
    await expect(field).toHaveAttribute("aria-invalid", "true");
    await expect(field).toHaveAccessibleDescription(why);
    await expect(field).toHaveValue(radius);
  }
  await expect(g41.output).toHaveValue(before);
  await field.press("Escape");
  await expect(field).toHaveValue("5");
  await field.fill("4.5");
  await field.press("Enter");
  await expect(g41.output).not.toHaveValue(before);
});

test("a radius larger than the part is answered, not refused", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const field = page.getByLabel("Tool radius in mm");
  for (const radius of ["40", "400", "0"]) {
    await field.fill(radius);
    await field.press("Enter");
    await g41.settled();
    const diagnosed = await page.locator("#diagnostics li").count();
    if (radius === "0") expect(diagnosed).toBe(0);
    else expect(diagnosed).toBeGreaterThan(0);
  }
  await page.locator("body").click({ position: { x: 5, y: 5 } });
  expect(g41.errors).toEqual([]);
});

test("a radius that the program states is told", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await expect(page.locator(".stated")).toBeHidden();
  const text = await g41.program.inputValue();
  await g41.program.fill(text.replace("G41 D1", "G41.1 D4"));
  await expect(page.locator(".stated")).toHaveText("The program states its own: 2 mm");
  await page.getByRole("radio", { name: "Right G42" }).check();
  await expect(g41.program).toHaveValue(/^N30 G1 G42\.1 D4 X0 Y18/m);
});

test("the side is a word of the program", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.output.inputValue();
  await page.getByRole("radio", { name: "Right G42" }).check();
  await expect(g41.program).toHaveValue(/^N30 G1 G42 D1 X0 Y18 F400 \(LEAD-IN\)$/m);
  await expect(g41.output).not.toHaveValue(before);
  await page.getByRole("radio", { name: "Left G41" }).check();
  await expect(g41.output).toHaveValue(before);
});

test("outside corners are straight or arcs", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("star");
  expect(await g41.count("Inserted")).toBeGreaterThan(0);
  expect(await g41.count("Elongated")).toBeGreaterThan(0);
  expect(await g41.count("Shortened")).toBeGreaterThan(0);
  expect(await g41.output.inputValue()).not.toMatch(/^G2 /m);
  const corners = page.getByRole("group", { name: "Outside corners" });
  await corners.getByRole("radio", { name: "Arc" }).check();
  await expect(g41.output).toHaveValue(/^G2 /m);
});

test("both spline methods, and they differ", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("ellipse");
  const exact = await g41.output.inputValue();
  await page.getByRole("radio", { name: "Type points" }).check();
  await expect(g41.output).not.toHaveValue(exact);
});

test("every example of the gallery has a tool path without errors", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const ids = await page
    .locator("#example option")
    .evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value));
  for (const id of ids) {
    await page.getByLabel("Example").selectOption(id);
    await g41.settled();
    await expect(g41.output).toHaveValue(/G1/);
    await expect(page.locator(".diagnostic-error, .diagnostic-warning"), id).toHaveCount(0);
  }
  expect(g41.errors).toEqual([]);
});

test("the program is kept over a reload, and the gallery says when it is nobody's", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const menu = page.getByLabel("Example");
  await expect(menu).toHaveValue("rocker");
  const text = (await g41.program.inputValue()).replace("N100 X70 Y57", "N100 X71 Y58");
  await g41.program.fill(text);
  await expect(menu).toHaveValue("");
  await page.waitForTimeout(600);
  await page.reload();
  await expect(g41.program).toHaveValue(text);
  await expect(g41.output).toHaveValue(/G1/);
  await menu.selectOption("rocker");
  await expect(g41.program).not.toHaveValue(text);
  await page.keyboard.press("Control+z");
  await expect(g41.program).toHaveValue(text);
});
