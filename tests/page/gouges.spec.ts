// Gouges and what is left uncut: chosen, shaded, listed, and told with reason and numbers.
import { expect, type Page, test } from "@playwright/test";
import { G41Page, type Point } from "./page";

/** In the corridor between the two rooms. */
const CORRIDOR: Point = [53, 25.5];

const choose = (page: Page, name: string) =>
  page.getByRole("group", { name: "Gouges" }).getByRole("radio", { name }).check();

/** How many pixels of the static layer around a place have a colour that asks for attention. */
async function reddish(g41: G41Page, [x, y]: Point, reach: number): Promise<number> {
  const box = await g41.base.boundingBox();
  if (!box) throw new Error("the canvas is not shown");
  return g41.base.evaluate(
    (element, [px, py, r]) => {
      const canvas = element as HTMLCanvasElement;
      const scale = canvas.width / canvas.clientWidth;
      const data = canvas
        .getContext("2d")
        ?.getImageData((px - r) * scale, (py - r) * scale, 2 * r * scale, 2 * r * scale).data;
      let count = 0;
      for (let i = 0; data && i < data.length; i += 4) {
        const [red, green, blue] = [data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0];
        if (red > green + 40 && red > blue + 40) count += 1;
      }
      return count;
    },
    [x - box.x, y - box.y, reach] as const,
  );
}

test("contours that cross at other heights are not red where no gouge is found", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const name = `${"two_circles_of_two_tools_".repeat(3)}.ngc`;
  // From the middle onto the wall by an arc, once around, and back by an arc.
  const circle = (r: number, z: number) =>
    `G0 X50 Y50\nG1 Z${z} F250\nG41 D1 G3 X${50 + r} Y50 I${r / 2}\nG3 I${-r}\nG3 X50 Y50 I${-r / 2}\nG0 Z10\nG40\n`;
  await g41.drop({ name, text: `G21 G90 G17\nG0 Z10\n${circle(20, -1)}${circle(15, -2)}M2\n` });
  await expect(page.locator(".file-name")).toHaveText(name);
  await page.getByRole("combobox", { name: "Profile" }).selectOption("linuxcnc");
  await g41.settled();
  await expect(page.locator("#diagnostics .summary")).not.toContainText("gouge");
  const box = await g41.base.boundingBox();
  if (!box) throw new Error("the canvas is not shown");
  const middle: Point = [box.x + box.width / 2, box.y + box.height / 2];
  expect(await reddish(g41, middle, Math.min(box.width, box.height) / 2 - 40)).toBe(0);
  // The long name of the file pushes nothing out of sight.
  for (const width of [1280, 1024, 390]) {
    await page.setViewportSize({ width, height: 800 });
    const save = await page.locator(".file .button.main").boundingBox();
    expect(save ? save.x + save.width : Number.NaN).toBeLessThan(width - 12);
  }
});

test("avoided, the corridor is hatched, listed first, and told with its area", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("rooms");
  await expect(page.locator("#diagnostics .summary")).toHaveText(/mm² uncut in \d+ places/);
  const rows = page.locator(".diagnostic-uncut");
  await expect(rows.first()).toContainText(/^Uncut1\d\d\.\d+ mm² uncut: the tool \(radius 5 mm\)/);
  await expect(page.locator("#legend li", { hasText: "Uncut" })).toBeVisible();
  const callout = page.locator(".callout");
  await expect(callout).toBeHidden();
  const place = await g41.locator();
  await page.mouse.move(...place(CORRIDOR));
  await expect(callout).toBeVisible();
  await expect(callout).toContainText(/1\d\d\.\d+ mm² uncut/);
  await expect(callout).toContainText(/does not fit at lines \d+ to \d+/);
  await page.mouse.move(...place([20, 25]));
  await expect(callout).toBeHidden();
  expect(g41.errors).toEqual([]);
});

test("a row shows its region to the pointer and to the keyboard", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("rooms");
  const row = page.locator(".diagnostic-uncut button").first();
  await row.hover();
  await expect(page.locator(".callout")).toBeVisible();
  await g41.canvas.hover({ position: { x: 5, y: 5 } });
  await expect(page.locator(".callout")).toBeHidden();
  await row.focus();
  await expect(page.locator(".callout")).toBeVisible();
  await page.keyboard.press("Enter");
  await expect(row).toHaveAttribute("aria-pressed", "true");
});

test("reported, the walls of the corridor are red, and nothing is uncut", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("rooms");
  const wall: Point = [53, 30.3];
  expect(await reddish(g41, (await g41.locator())(wall), 4)).toBe(0);
  await choose(page, "Report");
  await expect(page.locator(".diagnostic-uncut")).toHaveCount(0);
  await g41.settled();
  expect(await reddish(g41, (await g41.locator())(wall), 4)).toBeGreaterThan(30);
});

test("a bend that is too tight is told with its depth, at its place", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("letter");
  const field = page.getByLabel("Tool radius in mm");
  await field.fill("9");
  await field.press("Enter");
  const row = page.locator(".diagnostic-error button").first();
  await expect(row).toContainText(/mm too deep.*line \d+/);
  const depth = /cuts ([\d.]+) mm too deep/.exec((await row.textContent()) ?? "")?.[1];
  await row.hover();
  await expect(page.locator(".callout strong")).toContainText("mm too deep");
  const told = /([\d.]+) mm too deep/.exec((await page.locator(".callout").textContent()) ?? "");
  // The picture says it in thousandths.
  expect(Math.abs(Number(told?.[1]) - Number(depth))).toBeLessThan(6e-4);
  await choose(page, "Avoid");
  await expect(page.locator(".diagnostic-uncut").first()).toBeVisible();
  await expect(row).not.toContainText("bends");
});

test("stopped, there is no path, and the reason is said", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("letter");
  await choose(page, "Stop");
  await g41.settled();
  await expect(g41.output).toHaveValue(/^G1 /m);
  const field = page.getByLabel("Tool radius in mm");
  await field.fill("9");
  await field.press("Enter");
  await expect(g41.output).not.toHaveValue(/^G1 /m);
  await expect(page.locator(".diagnostic-error", { hasText: "would gouge" })).toHaveCount(1);
  expect(g41.errors).toEqual([]);
});

test("pieces are crossed above the part, or the program ends and says so", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("rooms");
  await expect(page.locator("#legend .swatch-rapid"), "the way is drawn").toBeVisible();
  await expect(page.locator("#legend .swatch-plunge"), "and where it ends").toBeVisible();
  await expect(g41.output).toHaveValue(/^G0 Z5\nX[\d.]+ Y[\d.]+\nG1 Z-2 F120$/m);
  await expect(page.locator(".diagnostic-error")).toHaveCount(0);
  const text = await g41.program.inputValue();
  await g41.program.fill(text.replace(" Z5\n", "\n").replace("G0 Z5\n", "M9\n"));
  await expect(page.locator(".diagnostic-error")).toContainText("no height is known");
  await expect(g41.output).not.toHaveValue(/X9\d/);
});

test("the choice is kept over a reload", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await choose(page, "Avoid");
  await g41.settled();
  await page.waitForTimeout(600);
  await page.reload();
  await expect(page.getByRole("radio", { name: "Avoid" })).toBeChecked();
});

test("a pocket is cleared in passes where gouges are avoided", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open("rooms");
  const passes = page.getByRole("group", { name: "Passes" });
  await choose(page, "Report");
  await expect(passes).toBeHidden();
  await choose(page, "Avoid");
  const once = (await g41.output.inputValue()).length;
  await passes.getByRole("radio", { name: "Clear the pocket" }).check();
  await expect.poll(async () => (await g41.output.inputValue()).length).toBeGreaterThan(2 * once);
  const many = (await g41.output.inputValue()).length;
  await page.getByLabel("Stepover").first().fill("6");
  await page.getByLabel("Stepover").first().press("Enter");
  await expect.poll(async () => (await g41.output.inputValue()).length).toBeLessThan(many);
  expect(g41.errors).toEqual([]);
});

/** Waves, row by row, in whose hollows the tool does not fit: a gouge for every few lines. */
function waves(count: number): string {
  const lines = ["G21 G90 G17", "G0 X-20 Y-20", "G41 D1 G1 X0 Y0 F600"];
  for (let i = 0; i < count; i += 1) {
    const [row, place] = [Math.floor(i / 300), i % 300];
    const x = row % 2 === 0 ? place / 2 : 150 - place / 2;
    const y = 12 * row + 2 * Math.sin(place / 10) + 0.5 * Math.sin(place / 3 + row);
    lines.push(`G1 X${x.toFixed(3)} Y${y.toFixed(4)}`);
  }
  return [...lines, "G40 X-20 Y-40", "M30", ""].join("\n");
}

test("a program with thousands of gouges is shown before anyone gives it up", async ({ page }) => {
  // What a frame strokes and closes; closing measures the whole path each time.
  await page.addInitScript(() => {
    const drawn = { strokes: 0, closed: 0 };
    Object.assign(window, { drawn });
    const { stroke } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.stroke = function (
      this: CanvasRenderingContext2D,
      ...all: unknown[]
    ) {
      drawn.strokes += 1;
      return Reflect.apply(stroke, this, all);
    } as typeof stroke;
    const { closePath } = Path2D.prototype;
    Path2D.prototype.closePath = function (this: Path2D) {
      drawn.closed += 1;
      return closePath.call(this);
    };
  });
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "waves.nc", text: waves(40_000) });
  const summary = page.locator("#diagnostics .summary");
  await expect(summary).toContainText(/\d,\d{3} gouges/, { timeout: 20_000 });
  const all = (await summary.textContent())?.match(/([\d,]+) gouges/)?.[1] ?? "";
  await expect(page.locator("#legend .swatch-gouge small"), "grouped alike").toHaveText(all);
  await expect(page.locator("#description"), "and told alike").toContainText(
    /\d,\d{3} diagnostics/,
  );
  for (const name of ["Zoom out", "Zoom in"]) {
    const button = page.getByRole("button", { name });
    const drawn = await button.evaluate(async (element) => {
      const { drawn } = window as unknown as { drawn: { strokes: number; closed: number } };
      Object.assign(drawn, { strokes: 0, closed: 0 });
      (element as HTMLElement).click();
      for (let i = 0; i < 2; i += 1) await new Promise((next) => requestAnimationFrame(next));
      return { ...drawn };
    });
    expect(drawn.strokes, `strokes of a frame, ${name}`).toBeLessThan(8000);
    expect(drawn.closed, `paths closed in a frame, ${name}`).toBeLessThan(10);
  }
  await page.locator(".diagnostic button").first().click();
  await expect(page.locator(".diagnostic button").first()).toHaveAttribute("aria-pressed", "true");
  expect(g41.errors, "errors of the page").toEqual([]);
});
