// The page comes up without an error.
import { expect, test } from "@playwright/test";

test("the page loads without an error", async ({ page }) => {
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  await page.goto("./");
  await expect(page).toHaveTitle(/g41/);
  await page.waitForLoadState("networkidle");
  expect(errors).toEqual([]);
});
