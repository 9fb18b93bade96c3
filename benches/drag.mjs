// Drags type points of long contours in headless Chromium: time of one step, and memory.
//
// A step is a move of a point and the update after it, as the page makes them while a pointer moves.
// Points are chosen at random, each is dragged for some steps, and the steps of all are judged.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { pathToFileURL } from "node:url";

import { chromium } from "@playwright/test";

import { browserFlags, findBrowser } from "../scripts/browser.mjs";
import { main, root } from "../scripts/command.mjs";

const COUNTS = [1000, 10_000, 100_000];
const types = { ".js": "text/javascript", ".wasm": "application/wasm" };

/** Measures each number of type points with the package as it was last built. */
export async function benchDrag() {
  const server = createServer((request, response) => {
    const type = types[extname(request.url)];
    response.setHeader("content-type", type ?? "text/html");
    // Pages apart from all others have a clock of five microseconds instead of a hundred.
    response.setHeader("cross-origin-opener-policy", "same-origin");
    response.setHeader("cross-origin-embedder-policy", "require-corp");
    response.end(type ? readFileSync(join(root, "dist", request.url)) : "<!doctype html>");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const browser = await chromium.launch({ executablePath: findBrowser(), args: browserFlags });
  console.log("\none step of a drag in Chromium, wave of n type points, tolerance 1e-3 mm:");
  console.log(
    "policy    radius        n     median       99 %      worst   99 % of as long idle   made in        memory",
  );
  try {
    for (const [gouge, radius] of [
      ["report", 5],
      ["avoid", 5],
      ["avoid", 60],
    ]) {
      for (const n of COUNTS) {
        // Each in a page of its own, whose memory begins empty.
        const page = await browser.newPage();
        await page.goto(`http://127.0.0.1:${server.address().port}/`);
        show(gouge, radius, n, await page.evaluate(measure, [n, gouge, radius]));
        await page.close();
      }
    }
  } finally {
    await browser.close();
    server.close();
  }
}

function show(gouge, radius, n, { median, high, worst, idle, made, memory }) {
  const ms = (value, width) => `${value.toFixed(3)} ms`.padStart(width);
  console.log(
    [
      gouge.padEnd(8),
      `${radius} mm`.padStart(7),
      String(n).padStart(8),
      ms(median, 11),
      ms(high, 11),
      ms(worst, 11),
      ms(idle, 26),
      `${made.toFixed(0)} ms`.padStart(10),
      `${(memory / n).toFixed(0)} B/point`.padStart(14),
    ].join(""),
  );
}

/** Runs in the browser. */
async function measure([n, gouge, radius]) {
  const { default: init, LiveContour } = await import("/web.js");
  const glue = await import("/g41.js");
  await init();
  const waves = Math.max(3, Math.floor(n / 20));
  const middle = (5 * n) / (2 * Math.PI);
  const points = new Float64Array(2 * n);
  for (let i = 0; i < n; i += 1) {
    const angle = (2 * Math.PI * ((i + 1) % n)) / n;
    const reach = middle + 8 * Math.sin(waves * angle);
    points[2 * i] = reach * Math.cos(angle);
    points[2 * i + 1] = reach * Math.sin(angle);
  }
  const start = [points[2 * n - 2], points[2 * n - 1]];
  const contour = { start, closed: true, segments: [{ kind: "spline", points }] };
  const { memory: used } = glue.initSync();
  const before = used.buffer.byteLength;
  const began = performance.now();
  const live = new LiveContour(contour, { side: "left", radius, gouge });
  live.update();
  const made = performance.now() - began;
  const memory = used.buffer.byteLength - before;
  let seed = 1;
  const random = () => {
    seed = (seed * 48271) % 2147483647;
    return seed / 2147483647;
  };
  const times = [];
  const idle = [];
  const patience = performance.now() + 20_000;
  for (let drag = 0; drag < 70 && performance.now() < patience; drag += 1) {
    const index = Math.floor(random() * (n - 1));
    const [x, y] = [points[2 * index], points[2 * index + 1]];
    const [dx, dy] = [random() * 6 - 3, random() * 6 - 3];
    for (let step = 1; step <= 25; step += 1) {
      const t = step / 25;
      const from = performance.now();
      live.movePoint(0, index, x + dx * t, y + dy * t);
      live.update();
      const to = performance.now();
      // The first steps of all make the engine compile what they run.
      if (drag < 10) continue;
      times.push(to - from);
      // What the machine does meanwhile takes its part of this too.
      const rest = 2 * to - from;
      while (performance.now() < rest);
      idle.push(performance.now() - to);
    }
    // Each point is dragged on the curve as it was.
    live.movePoint(0, index, x, y);
    live.update();
  }
  const at = (list, part) =>
    list.sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(part * list.length))];
  return {
    median: at(times, 0.5),
    high: at(times, 0.99),
    worst: at(times, 1),
    idle: at(idle, 0.99),
    made,
    memory,
  };
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  main(benchDrag);
}
