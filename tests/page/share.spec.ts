// A link holds the program and its settings: who opens it sees the same part.
import { expect, test } from "@playwright/test";
import { G41Page } from "./page";

test("a copied link opens the program with its settings, as one step of undo", async ({
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const g41 = new G41Page(page);
  await g41.open("cam");
  const radius = page.getByLabel("Tool radius in mm");
  await radius.fill("4.5");
  await radius.press("Enter");
  await page.getByLabel("Write for").selectOption("marlin");
  await g41.program.fill(`(\u00d8 9)\n${await g41.program.inputValue()}`);
  await g41.settled();
  const text = await g41.program.inputValue();
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect(page.locator(".notice")).toContainText("Copied");
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toMatch(/#p=[\w-]+$/);

  const other = await (await context.browser())?.newPage();
  if (!other) throw new Error("there is no other page");
  const opened = new G41Page(other);
  await other.goto(link);
  await expect(opened.program).toHaveValue(text);
  await expect(other.getByLabel("Tool radius in mm")).toHaveValue("4.5");
  await expect(other.getByLabel("Write for")).toHaveValue("marlin");
  await expect(other.locator(".file-name")).toHaveText("cam.nc");
  expect(new URL(other.url()).hash).toBe("");
  await other.getByRole("button", { name: "Undo" }).click();
  await expect(opened.program).not.toHaveValue(text);
  expect(opened.errors).toEqual([]);
  await other.close();
});

test("what is no link of ours leaves the page as it is", async ({ page }) => {
  const g41 = new G41Page(page);
  await page.goto("./#p=AAAA_nonsense");
  await expect(page.locator(".notice")).toContainText("damaged");
  await expect(g41.output).toHaveValue(/G1/);
  await page.goto("./#elsewhere");
  await page.reload();
  await expect(page.locator(".notice")).toBeHidden();
});

test("a program that is too long for a link says so", async ({ page }) => {
  const g41 = new G41Page(page);
  await g41.open();
  let seed = 1;
  const lines = Array.from({ length: 12_000 }, () => {
    seed = (seed * 48271) % 2147483647;
    return `G1 X${seed / 1e6} Y${(seed % 99991) / 100} F300`;
  });
  await g41.drop({ name: "long.nc", text: lines.join("\n") });
  await expect(page.locator(".file-name")).toHaveText("long.nc");
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect(page.locator(".notice")).toContainText("too long for a link");
});
