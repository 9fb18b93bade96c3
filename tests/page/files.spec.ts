/// <reference types="node" />
// A file is opened, read by the rules that are chosen, and saved for the target that is chosen.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

/** A square of 30 mm, left of which the tool runs, as a control without G41 must be told. */
const SQUARE = `G21 G90 G17
T1 M6
G0 X-20 Y0 Z5
G1 Z-2 F100
G1 G41 D1 X0 F300
Y30
X30
Y0
X0
G40 X-20
G0 Z5
M30
`;

/** Two of them, with a tool each. */
const TWO_TOOLS = `G21 G90
G0 X-20 Y0
G1 G41 D1 X0 F300
Y30
G40 X-20
G0 X-20 Y60
G1 G41 D7 X0 F300
Y90
G40 X-20
M30
`;

test("what was typed is there after a reload at once", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.program.fill("G1 G41 X10 Y0 F100\nX20\nY20\nG40 X40\nM30");
  // Saving waits for a pause, which a reload does not leave.
  await page.reload();
  await expect(g41.program).toHaveValue(/^G1 G41 X10 Y0/);
});

test("a dropped file is shown with its name, and saved by it and the target", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "square.ngc", text: SQUARE });
  await expect(g41.program).toHaveValue(SQUARE);
  await expect(page.locator(".file-name")).toHaveText("square.ngc");
  await g41.settled();
  const radius = page.getByLabel("Tool radius in mm");
  await radius.fill("4");
  await radius.press("Enter");
  await g41.settled();
  const grbl = await g41.saved(page.getByRole("button", { name: "Save square.grbl.nc" }));
  expect(grbl.name).toBe("square.grbl.nc");
  expect(grbl.text).not.toMatch(/G4[012]/);
  const lines = grbl.text.split("\n");
  expect(lines).toContain("X-4 F300");
  expect(lines).toContain("Y34");
  expect(lines).toContain("X34");
  await page.getByLabel("Write for").selectOption("fanuc-0m");
  await g41.settled();
  const fanuc = await g41.saved(page.getByRole("button", { name: "Save square.fanuc-0m.nc" }));
  expect(fanuc.name).toBe("square.fanuc-0m.nc");
  expect(fanuc.text).toMatch(/^%\n/);
  expect(fanuc.text).not.toBe(grbl.text);
  expect(g41.errors).toEqual([]);
});

test("a file is opened by the button, and that is one step of undo", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.program.inputValue();
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open", exact: true }).click();
  const buffer = Buffer.from(SQUARE);
  await (await chooser).setFiles({ name: "part.nc", mimeType: "text/plain", buffer });
  await expect(g41.program).toHaveValue(SQUARE);
  await page.locator("body").click({ position: { x: 5, y: 5 } });
  await page.keyboard.press("Control+z");
  await expect(g41.program).toHaveValue(before);
});

test("what is no text is refused with its name", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const before = await g41.program.inputValue();
  await g41.drop({ name: "photo.nc", text: "PNG\0\0\0IHDR" });
  await expect(page.locator(".notice")).toHaveText("photo.nc is not a text.");
  expect(await g41.program.inputValue()).toBe(before);
});

test("blank tape and DOS's mark at the ends of a program are left out", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "tape.nc", text: `\0\0\0${SQUARE}\x1a\0\0` });
  await expect(g41.program).toHaveValue(SQUARE);
});

for (const [width, height] of [
  [1280, 800],
  [1280, 720],
  [1024, 700],
] as const) {
  test(`beside a program with errors, the side fits into ${width} × ${height}`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height });
    const g41 = new G41Page(page);
    await g41.open();
    // Of FANUC's by its signs, which takes a row more for what it seems to be written for.
    await g41.drop({ name: "part.nc", text: `%\nO1000\n${SQUARE}G999\nG998\nM98 P1\n%\n` });
    const first = page.locator(".diagnostics li").first();
    await expect(first).toBeVisible();
    await expect(page.getByRole("button", { name: /Use FANUC/ })).toBeVisible();
    const bottom = (selector: string) =>
      page.locator(selector).evaluate((e) => e.getBoundingClientRect().bottom);
    const end = await bottom(".diagnostics");
    expect(end, "the diagnostics end within the window").toBeLessThanOrEqual(height);
    const row = await first.evaluate((e) => e.getBoundingClientRect().bottom);
    expect(row, "one of them is in sight as a whole").toBeLessThanOrEqual(end);
    const lines = await page.locator("#panel-program").evaluate((e) => e.clientHeight / 20);
    expect(lines, "lines of the program that are in sight").toBeGreaterThan(4);
  });
}

test("what other editors write is read, with the letters of its language", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = `(Fr\u00e4ser)\n${SQUARE}`;
  const wide = Buffer.from(text, "utf16le");
  for (const [name, bytes] of [
    ["little.nc", [0xff, 0xfe, ...wide]],
    ["big.nc", [0xfe, 0xff, ...Buffer.from(wide).swap16()]],
    ["latin.nc", [...Buffer.from(text, "latin1")]],
  ] as const) {
    await g41.drop({ name, bytes });
    await expect(page.locator(".file-name")).toHaveText(name);
    await expect(g41.program).toHaveValue(text);
  }
});

test("what compensates nothing says so, and shows where the tool goes down", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const item = (name: string) => page.locator("#legend li", { hasText: name });
  await expect(item("Plunge")).toBeHidden();
  await expect(item("Contour")).toBeVisible();
  await g41.drop({
    name: "holes.nc",
    text: "G21 G90\nG0 X0 Y0 Z5\nG81 X10 Y10 Z-5 R2 F80\nX20\nG80\nM30\n",
  });
  await expect(page.locator(".summary")).toContainText("there is no G41 or G42");
  await expect(page.locator(".hint")).toContainText("there is no G41 or G42");
  await expect(item("Plunge")).toBeVisible();
  await expect(item("Contour")).toBeHidden();
  await expect(page.getByRole("radio", { name: "Left G41" })).toBeDisabled();
  await g41.settled();
  const holes = await g41.picture();
  await g41.drop({ name: "above.nc", text: "G21 G90\nG0 X0 Y0 Z5\nX10 Y10\nX20\nM30\n" });
  await g41.settled();
  await expect(item("Plunge")).toBeHidden();
  expect(await g41.picture()).not.toBe(holes);
  await g41.drop({ name: "empty.nc", text: "" });
  await expect(page.locator(".summary")).toHaveText("The program is empty.");
});

test("each tool that the program calls may have its own radius", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await expect(page.locator("#tools")).toBeHidden();
  await g41.drop({ name: "two.nc", text: TWO_TOOLS });
  const second = page.getByLabel("Radius of tool 7 in mm");
  await expect(second).toBeVisible();
  await expect(second).toHaveValue("");
  await second.fill("2.5");
  await second.press("Enter");
  await g41.settled();
  const radius = await page.getByLabel("Tool radius in mm").inputValue();
  await expect(g41.output).toHaveValue(new RegExp(`X-${radius}\\b`));
  await expect(g41.output).toHaveValue(/X-2\.5\b/);
  await page.locator("body").click({ position: { x: 5, y: 5 } });
  await page.keyboard.press("Control+z");
  await expect(second).toHaveValue("");
});

test("a tool table gives diameters, and tells what it cannot read", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop(
    { name: "mill.tbl", text: "T1 P1 D6 ;end mill\nnonsense\nT7 P2 D3\n" },
    { name: "two.nc", text: TWO_TOOLS },
  );
  await expect(page.getByLabel("Diameter of tool 7 in the unit of the program")).toHaveValue("3");
  await g41.settled();
  await expect(g41.output).toHaveValue(/X-3\b/);
  await expect(g41.output).toHaveValue(/X-1\.5\b/);
  await g41.drop({ name: "mill.tbl", text: "T1 P1 D6 ;end mill\nnonsense\nT7 P2 D3\n" });
  await expect(page.locator(".notice")).toContainText("mill.tbl: 2 tools read. Line 2:");
  // Inches, where the program counts in them.
  await g41.drop({ name: "inch.nc", text: TWO_TOOLS.replace("G21", "G20") });
  await g41.settled();
  await expect(g41.output).toHaveValue(/X-76\.2\b/);
  expect(g41.errors).toEqual([]);
});

test("the radii that comments tell are offered, and taken by one click", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const offer = page.locator(".named-tools");
  const radius = page.getByLabel("Tool radius in mm");
  await expect(offer, "an example names no tool").toBeHidden();
  const square = (tool: number) => SQUARE.replaceAll("D1", `D${tool}`);
  for (const [comment, unit, diameter] of [
    ["(TOOL 1: END MILL D6)", "G21", "6"],
    ["(T1 D=0.5 CR=0. - ZMIN=-1 - FLAT END MILL)", "G20", "12.7"],
    ['(T01 = 3/8"  END MILL)', "G20", "9.525"],
    ['(Tool 1: 3/4" 19.05mm Flat Endmill, 3 flutes)', "G21", "19.05"],
    ["; T1 dia. 8 mm", "G20", "8"],
  ] as const) {
    const text = `${comment}\n${square(1).replace("G21", unit)}`;
    await g41.drop({ name: "part.nc", text });
    await expect(offer, comment).toContainText(`T1 ⌀ ${diameter} mm`);
    await offer.getByRole("button").click();
    await expect(radius, comment).toHaveValue(String(Number(diameter) / 2).slice(0, 6));
    await expect(radius, "the focus stays").toBeFocused();
    await expect(offer, comment).toBeHidden();
    await page.keyboard.press("Control+z");
    await expect(offer, "after undo").toBeVisible();
  }
  for (const comment of [
    "(T2 D=6)",
    "(T1 CHANGED AT D STREET)",
    "(T1 D6)\n(T1 D8)",
    "(DEPTH 6MM)",
  ]) {
    await g41.drop({ name: "part.nc", text: `${comment}\n${square(1)}` });
    await expect(g41.program).toHaveValue(`${comment}\n${square(1)}`);
    await g41.settled();
    await expect(offer, comment).toBeHidden();
  }
});

test("of several tools each is given the radius that its comment tells", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  const text = `(T1 D=6.)\n(T7 D=11.)\n${TWO_TOOLS}`;
  await g41.drop({ name: "two.nc", text });
  await expect(page.locator(".named-tools")).toContainText("T1 ⌀ 6, T7 ⌀ 11 mm");
  await page.getByRole("button", { name: "Use their radii" }).click();
  await expect(page.getByLabel("Radius of tool 1 in mm")).toHaveValue("3");
  await expect(page.getByLabel("Radius of tool 7 in mm")).toHaveValue("5.5");
  await expect(page.locator(".named-tools")).toBeHidden();
});

test("the profile decides what is inserted at corners, unless that is chosen", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "square.nc", text: SQUARE });
  await g41.settled();
  await expect(g41.output).not.toHaveValue(/^G2 /m);
  await page.getByRole("combobox", { name: "Profile" }).selectOption("linuxcnc");
  await g41.settled();
  await expect(g41.output).toHaveValue(/^G2 /m);
  const corners = page.getByRole("group", { name: "Outside corners" });
  await corners.getByRole("radio", { name: "Linear" }).check();
  await g41.settled();
  await expect(g41.output).not.toHaveValue(/^G2 /m);
});

test("file, rules and target are kept over a reload", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  await g41.drop({ name: "square.ngc", text: SQUARE });
  await page.getByLabel("Write for").selectOption("marlin");
  await page.getByLabel("Read as").selectOption("fanuc");
  await page.waitForTimeout(600);
  await page.reload();
  await expect(g41.program).toHaveValue(SQUARE);
  await expect(page.getByRole("button", { name: "Save square.marlin.gcode" })).toBeVisible();
  await expect(page.getByLabel("Read as")).toHaveValue("fanuc");
});

test("the rules of the control whose words a program has are offered, and taken by one click", async ({
  page,
}) => {
  const g41 = new G41Page(page);
  await g41.open();
  const offer = page.locator(".offer");
  const profile = page.locator(".file-profile select");
  // Those of the gallery are written for everyone.
  for (const option of await page.locator("#example option").all()) {
    const value = await option.getAttribute("value");
    if (!value) continue;
    await page.getByLabel("Example").selectOption(value);
    await expect(offer).toBeHidden();
  }
  for (const [text, control] of [
    ["N10 R1=20\nG41 D1 G1 X0 Y0 F100\n", "SINUMERIK"],
    ["#1=5\nIF [#1 GT 2] GOTO 20\nN20 M30\n", "FANUC"],
    ["o100 sub\no100 endsub\nM2\n", "LinuxCNC"],
  ] as const) {
    await g41.drop({ name: "own.nc", text });
    await expect(offer).toContainText(`written for ${control}`);
    await page.getByRole("button", { name: `Use ${control}'s rules` }).click();
    await expect(profile.locator("option:checked")).toHaveText(control);
    await expect(offer).toBeHidden();
    await expect(profile).toBeFocused();
    await page.keyboard.press("Control+z");
    await expect(offer).toBeVisible();
  }
  // In a comment it is no word of the program.
  await g41.drop({ name: "own.nc", text: "G1 X1 F100 (R1=5 CR=3)\n; GOTOF\nM30\n" });
  await expect(offer).toBeHidden();
  expect(g41.errors).toEqual([]);
});
