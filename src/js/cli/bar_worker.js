// The thread that draws the bar, since the one that works has no time for it.
import { writeSync } from "node:fs";
import { parentPort, workerData } from "node:worker_threads";

import { Bar } from "./bar.js";

/** The file descriptor of standard error, which other threads only lend. */
const standardError = 2;

/** How often the bar is drawn anew [ms]. */
const period = 100;

const bar = new Bar((text) => writeSync(standardError, text), workerData);
let began = 0;
let isKnown = false;

const timer = setInterval(() => {
  if (!isKnown) {
    bar.guess((performance.now() - began) / 1000);
  }
}, period);

parentPort?.on("message", (/** @type {"next" | "end" | number} */ message) => {
  if (message === "next") {
    began = performance.now();
    isKnown = false;
    bar.next();
  } else if (message === "end") {
    clearInterval(timer);
    bar.end();
    parentPort?.close();
  } else {
    isKnown = true;
    bar.part(message);
  }
});
