// Tells how far long work is, by a bar on the terminal.
import { once } from "node:events";
import { Worker } from "node:worker_threads";

/** Programs shorter than this are done before a bar could be read [letters]. */
const long = 500_000;

/**
 * Seconds that a step takes for a million letters of program, as measured on a machine of 2026.
 *
 * @typedef {readonly (readonly [name: string, seconds: number])[]} Steps
 */

/** Work in steps. */
export class Progress {
  /** @type {Worker | undefined} */
  #worker;

  /**
   * @param {number} size of the program [letters]
   * @param {Steps} steps
   */
  constructor(size, steps) {
    if (process.stderr.isTTY && size >= long) {
      const workerData = steps.map(([name, seconds]) => [name, (seconds * size) / 1e6]);
      this.#worker = new Worker(new URL("./bar_worker.js", import.meta.url), { workerData });
    }
  }

  /** Begins the next step. */
  next() {
    this.#worker?.postMessage("next");
  }

  /**
   * Tells how much of the step is done; until then it is guessed from the time that it takes.
   *
   * @param {number} part from 0 to 1
   */
  part(part) {
    this.#worker?.postMessage(part);
  }

  /** Takes the bar away. */
  async end() {
    const worker = this.#worker;
    this.#worker = undefined;
    if (worker) {
      worker.postMessage("end");
      await once(worker, "exit");
    }
  }
}
