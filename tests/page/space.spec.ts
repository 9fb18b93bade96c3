// The picture in space: how far the moves go, turned by mouse and keys, and what is found in it.
import { expect, type Page, test } from "@playwright/test";
import { G41Page, violations } from "./page";

/** From (0, 0) at the height 5 down to -2, and from there along one line to (40, 20, -6). */
const RAMP = "G21 G90 G94 G17\nG0 X0 Y0 Z5\nG1 Z-2 F300\nX40 Y20 Z-6\nM30\n";

/** A square of 40 beside which the tool goes round at the height -3. */
const SQUARE =
  "G21 G90 G17\nG0 X-20 Y-10 Z5\nG1 Z-3 F100\nG41 D1 X0 Y0 F300\nY40\nX40\nY0\nX0\nG40 X-10 Y-20\nM30\n";

/** The page in space, with a program. */
async function inSpace(page: Page, text: string): Promise<G41Page> {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "part.nc", text });
  await expect(g41.program).toHaveValue(text);
  await g41.settled();
  await page.getByRole("button", { name: "3D view" }).click();
  await g41.frames(3);
  return g41;
}

/** What the canvas shows, as a short string to compare. */
function picture(page: Page): Promise<string> {
  return page.locator("canvas.space").evaluate(async (e) => {
    const text = new TextEncoder().encode((e as HTMLCanvasElement).toDataURL());
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", text));
    return [...digest].map((byte) => byte.toString(16)).join(" ");
  });
}

test("it tells how far what is cut goes along each axis", async ({ page }) => {
  const g41 = await inSpace(page, RAMP);
  const extents = page.locator(".space-extents");
  await expect(extents).toHaveText("X 0 … 40  40 mm\nY 0 … 20  20 mm\nZ -6 … 5  11 mm");
  // Compensated it is the tool that goes so far: 5 mm beside the square on three sides.
  await g41.program.fill(SQUARE);
  await g41.settled();
  await expect(extents).toHaveText(/X -20 … 45\s+65 mm\nY -20 … 45\s+65 mm\nZ -3 … 5\s+8 mm/);
  await page.getByRole("button", { name: "3D view" }).click();
  await expect(extents).toBeHidden();
  await expect(g41.canvas).toBeVisible();
  expect(g41.errors, "errors of the page").toEqual([]);
});

test("the extents of arcs are those of the circle, and not of its chords", async ({ page }) => {
  // Below the line from (0, 0) to (20, 0) about (10, 0), in the plane of z and x.
  const arc = "G21 G90 G18\nG0 X0 Y0 Z5\nG1 Z0 F200\nG2 X20 Z0 I10 K0\nG1 Z5\nM30\n";
  await inSpace(page, arc);
  await expect(page.locator(".space-extents")).toHaveText(
    "X 0 … 20   20 mm\nY 0        0 mm\nZ -10 … 5  15 mm",
  );
});

test("mouse and keys turn, move and scale it, and a view brings it back", async ({ page }) => {
  const g41 = await inSpace(page, SQUARE);
  const first = await picture(page);
  const canvas = page.locator("canvas.space");
  const box = await canvas.boundingBox();
  if (!box) throw new Error("the picture in space is not shown");
  const middle = [box.x + box.width / 2, box.y + box.height / 2] as const;
  const back = async (what: string) => {
    await g41.frames(3);
    expect(await picture(page), what).not.toBe(first);
    await page.getByRole("radio", { name: "Top", exact: true }).check({ force: true });
    await page.getByRole("radio", { name: "Iso" }).check({ force: true });
    await g41.frames(3);
    expect(await picture(page), `the view after one who ${what}`).toBe(first);
  };
  await g41.drag(middle, [middle[0] + 80, middle[1] + 30]);
  await back("drags");
  await page.keyboard.down("Shift");
  await g41.drag(middle, [middle[0] + 80, middle[1] + 30]);
  await page.keyboard.up("Shift");
  await back("drags with Shift");
  await page.mouse.move(...middle);
  await page.mouse.wheel(0, -300);
  await back("turns the wheel");
  await page.getByRole("button", { name: "Zoom in" }).click();
  await back("presses the button");
  for (const key of ["ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "-"]) {
    await canvas.press(key);
    await back(`presses ${key}`);
  }
  await canvas.press("+");
  await canvas.press("f");
  await g41.frames(3);
  expect(await picture(page), "everything fits again").toBe(first);
});

test("a click on a move finds its line, and the picture of the plane takes no keys", async ({
  page,
}) => {
  const g41 = await inSpace(page, RAMP);
  for (const view of ["Top", "Front"]) {
    await page.getByRole("radio", { name: view, exact: true }).check({ force: true });
    await g41.frames(3);
    const box = await page.locator("canvas.space").boundingBox();
    if (!box) throw new Error("the picture in space is not shown");
    // The middle of the box: from above on the ramp, and from the front beside it, where nothing is.
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    const current = page.locator(".gutter .current");
    if (view === "Top") await expect(current).toHaveText("4");
    else await expect(current).toHaveCount(0);
  }
  await page.getByRole("button", { name: "Zoom in" }).focus();
  await page.keyboard.press("Tab");
  await expect(page.locator("canvas.space")).toBeFocused();
  await page.keyboard.press("Tab");
  await expect(g41.canvas).not.toBeFocused();
});

test("contours show below the origin too, in both schemes", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "light" });
  await inSpace(page, SQUARE);
  const inked = (ink: string) =>
    page.locator("canvas.space").evaluate((element, wanted) => {
      const canvas = element as HTMLCanvasElement;
      const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data;
      const rgb = [1, 3, 5].map((i) => Number.parseInt(wanted.slice(i, i + 2), 16));
      let count = 0;
      for (let i = 0; data && i < data.length; i += 4) {
        if (rgb.every((value, k) => Math.abs(value - (data[i + k] ?? 0)) < 12)) count += 1;
      }
      return count;
    }, ink);
  // 160 mm of lines at several pixels a millimetre, beside which names of axes are little.
  expect(await inked("#1b2430"), "dark on paper").toBeGreaterThan(600);
  await page.getByRole("button", { name: "Dark scheme" }).click();
  await expect.poll(() => inked("#eef2f6"), { message: "light on dark" }).toBeGreaterThan(600);
});

test("the tool runs in space, and says where it is", async ({ page }) => {
  const g41 = await inSpace(page, RAMP);
  await page.getByRole("button", { name: "Motion" }).click();
  await expect(page.locator("#motion")).toHaveAttribute("aria-busy", "false", { timeout: 30_000 });
  const slider = page.getByRole("slider", { name: "Time" });
  await slider.fill("500");
  await g41.frames(3);
  const before = await picture(page);
  await slider.fill("1000");
  await g41.frames(3);
  expect(await picture(page), "the tool is elsewhere").not.toBe(before);
  await expect(page.locator("#readout")).toHaveText("X 40.000  Y 20.000  Z -6.000");
});

for (const [scheme, width, height] of [
  ["light", 1440, 900],
  ["dark", 1024, 700],
  ["light", 390, 844],
] as const) {
  test(`${scheme}, ${width} × ${height}: no violation, no sideways scrolling`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize({ width, height });
    const g41 = await inSpace(page, SQUARE);
    expect(await violations(page), "what axe finds").toEqual([]);
    const scroll = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(scroll, "the width of the page").toBeLessThanOrEqual(width);
    expect(g41.errors, "errors of the page").toEqual([]);
  });
}

test("a very long program is shown in space as well", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const lines = ["G21 G90 G17", "G0 X0 Y0 Z5", "G1 Z0 F500"];
  for (let i = 0; lines.length < 110_000; i += 1) {
    const [x, y] = [i % 100, Math.floor(i / 100) * 0.1];
    lines.push(`X${x.toFixed(3)} Y${y.toFixed(3)} Z${(-x / 50).toFixed(3)}`);
  }
  await g41.drop({ name: "slope.nc", text: [...lines, "M30", ""].join("\n") });
  await expect(page.locator("#work")).toBeVisible();
  await expect(page.locator("#work")).toBeHidden({ timeout: 60_000 });
  await page.getByRole("button", { name: "3D view" }).click();
  await expect(page.locator(".space-extents")).toHaveText(/X 0 … 99 .*\nY .*\nZ -1.98 … 5 /);
  expect(g41.errors, "errors of the page").toEqual([]);
});

test("the legend names what shows in space alone, as plunges", async ({ page }) => {
  const g41 = await inSpace(page, SQUARE);
  const named = page.locator(".legend li:visible");
  await expect(named, "in space").toContainText([
    "Contour",
    "Tool path",
    "Not compensated",
    "Lead",
  ]);
  await page.getByRole("button", { name: "3D view" }).click();
  await expect(named.filter({ hasText: "Not compensated" }), "in the plane").toHaveCount(0);
  expect(g41.errors, "errors of the page").toEqual([]);
});

test("as the tool runs the moves are not drawn again", async ({ page }) => {
  const g41 = await inSpace(page, SQUARE);
  await page.getByRole("button", { name: "Motion" }).click();
  await expect(page.locator("#motion")).toHaveAttribute("aria-busy", "false");
  await g41.frames(5);
  await page.evaluate(() => {
    const strokes = { count: 0 };
    Object.assign(window, { strokes });
    const { stroke } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.stroke = function (...path: unknown[]) {
      // The dashes of leads are those of moves alone.
      if (this.getLineDash().length > 0) strokes.count += 1;
      Reflect.apply(stroke, this, path);
    };
  });
  const dashed = () =>
    page.evaluate(() => (window as unknown as { strokes: { count: number } }).strokes.count);
  const before = await picture(page);
  await page.getByRole("slider", { name: "Time" }).fill("400");
  await expect.poll(() => picture(page), { message: "the tool shows" }).not.toBe(before);
  expect(await dashed(), "dashed lines drawn as the tool moves").toBe(0);
  await page.locator("canvas.space").press("ArrowLeft");
  await expect.poll(dashed, { message: "turned, they are drawn again" }).toBeGreaterThan(0);
});

test("between two pieces the way is drawn up, across at the height of rapid moves, and down", async ({
  page,
}) => {
  // What is drawn in space, as the page has it from its worker.
  await page.addInitScript(() => {
    window.Worker = class extends Worker {
      constructor(...all: ConstructorParameters<typeof Worker>) {
        super(...all);
        this.addEventListener("message", ({ data }) => {
          const strokes = data?.result?.space?.strokes as { kind: string; points: Float32Array }[];
          const rapid = strokes?.find(({ kind }) => kind === "rapid");
          if (rapid) Object.assign(window, { rapid: [...rapid.points] });
        });
      }
    };
  });
  const g41 = new G41Page(page);
  await g41.open("rooms");
  const points = await page.evaluate(() => (window as unknown as { rapid: number[] }).rapid);
  const places = Array.from({ length: points.length / 3 }, (_, i) =>
    points.slice(3 * i, 3 * i + 3),
  );
  const across = places.findIndex(
    ([x, y, z], i) => x === 22 && y === 26 && z === 5 && (places[i + 1]?.[0] ?? 0) > 64,
  );
  expect(across, "one way leads to the other room").toBeGreaterThan(0);
  expect(places[across - 1], "up from where it was").toEqual([22, 26, -2]);
  expect(places[across + 1]?.[2], "across at the same height").toBe(5);
  // Where nothing is cut apart there is no way: the rapid move at the end alone.
  await page.getByRole("radio", { name: "Report" }).check();
  await g41.settled();
  const plain = await page.evaluate(() => (window as unknown as { rapid: number[] }).rapid);
  expect(plain.length / 3, "vertices of rapid moves").toBe(2);
  expect(g41.errors, "errors of the page").toEqual([]);
});
