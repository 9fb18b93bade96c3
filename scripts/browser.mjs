// Finds a Chrome or Chromium and its driver, and on Debian and Ubuntu installs them where root runs this.
import { accessSync, constants, existsSync, readFileSync } from "node:fs";
import { delimiter, join } from "node:path";

import { Failure, run } from "./command.mjs";

const windows = process.platform === "win32";

const browserNames = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"];

/** Where installers put Chrome without adding it to PATH. */
const browserPlaces = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  ...["ProgramFiles", "ProgramFiles(x86)", "LOCALAPPDATA"].map((variable) =>
    join(process.env[variable] ?? "", "Google/Chrome/Application/chrome.exe"),
  ),
];

// One call for both, since the driver must be of the browser's version; a font, since a machine
// without a screen may have none. Ubuntu has other names than Debian.
const aptPackages = {
  debian: ["chromium", "chromium-driver", "fonts-dejavu-core"],
  ubuntu: ["chromium-browser", "chromium-chromedriver", "fonts-dejavu-core"],
};

/** What a browser needs to run in a container as root, and to leave the network alone. */
export const browserFlags = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--disable-dev-shm-usage",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** The path of the browser, or undefined. CHROME_PATH chooses one. */
export function findBrowser() {
  return process.env.CHROME_PATH ?? onPath(browserNames) ?? browserPlaces.find(existsSync);
}

/** The path of the browser's driver, or undefined. CHROMEDRIVER chooses one. */
export function findDriver() {
  return process.env.CHROMEDRIVER ?? onPath(["chromedriver"]);
}

/** Makes sure that there is a browser and its driver, or says what to install. */
export async function provideBrowser() {
  const apt = aptPackages[distribution()];
  if ((!findBrowser() || !findDriver()) && apt && process.getuid() === 0) {
    const env = { DEBIAN_FRONTEND: "noninteractive" };
    await run("apt-get", ["update", "-qq"], { env });
    await run("apt-get", ["install", "-qq", "-y", "--no-install-recommends", ...apt], { env });
  }
  const browser = findBrowser();
  if (!browser) {
    throw new Failure(
      "No browser was found: install Chrome or Chromium, or name it in CHROME_PATH.",
    );
  }
  const driver = findDriver();
  if (!driver) {
    const advice = apt
      ? `apt-get install ${apt[1]}`
      : "https://developer.chrome.com/docs/chromedriver";
    throw new Failure(
      `No chromedriver was found for ${browser}: install the one of the same version (${advice}), or name it in CHROMEDRIVER.`,
    );
  }
  return { browser, driver };
}

function onPath(names) {
  const folders = (process.env.PATH ?? "").split(delimiter);
  const paths = names.flatMap((name) =>
    folders.map((folder) => join(folder, windows ? `${name}.exe` : name)),
  );
  return paths.find(isExecutable);
}

function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

function distribution() {
  const file = "/etc/os-release";
  return existsSync(file) ? readFileSync(file, "utf8").match(/^ID="?(\w+)/m)?.[1] : undefined;
}
