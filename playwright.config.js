// How the tests of the page run: on the built page, in the installed browser, by mouse and by touch.
import { defineConfig, devices } from "@playwright/test";

import { browserFlags, findBrowser } from "./scripts/browser.mjs";

const port = Number(process.env.G41_TEST_PORT ?? 4142);

export default defineConfig({
  testDir: "tests/page",
  outputDir: "test-results",
  // Some tests measure frames: they need the machine to themselves.
  workers: 1,
  forbidOnly: Boolean(process.env.CI),
  reporter: "list",
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    launchOptions: { executablePath: findBrowser(), args: browserFlags },
  },
  projects: [
    {
      name: "desktop",
      testIgnore: "touch.spec.ts",
      use: { ...devices["Desktop Chrome"], viewport: { width: 1280, height: 800 } },
    },
    { name: "touch", testMatch: "touch.spec.ts", use: { ...devices["Pixel 7"] } },
  ],
  webServer: {
    command: `node scripts/serve.mjs ${port}`,
    url: `http://127.0.0.1:${port}/`,
    reuseExistingServer: false,
  },
});
