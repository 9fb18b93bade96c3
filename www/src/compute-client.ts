// Talks to the worker: one request under way, and of those that wait only the latest is sent.

import type { Settings } from "./parameters";
import type { Reply, Result } from "./result";

/** What is asked of the worker. */
export interface Question {
  readonly text: string;
  readonly settings: Settings;
}

/** Starts the worker; `ask` may be called at any rate. */
export class ComputeClient {
  #worker: Worker;
  #underWay = false;
  #waiting: Question | undefined;
  #id = 0;

  #onBusy: (busy: boolean) => void;

  constructor(
    onResult: (result: Result) => void,
    onFailure: (message: string) => void,
    onBusy: (busy: boolean) => void,
  ) {
    this.#onBusy = onBusy;
    this.#worker = new Worker(new URL("./compute.worker.ts", import.meta.url), { type: "module" });
    this.#worker.addEventListener("message", ({ data }: MessageEvent<Reply>) => {
      this.#underWay = false;
      this.#sendWaiting();
      if (data.kind === "result") onResult(data.result);
      else onFailure(data.message);
      if (!this.#underWay) onBusy(false);
    });
    this.#worker.addEventListener("error", (event) => {
      onFailure(event.message || "the worker could not be started");
    });
  }

  /** Asks for the tool path of a text; an older question that was not sent yet is forgotten. */
  ask(question: Question): void {
    this.#waiting = question;
    if (this.#underWay) return;
    this.#onBusy(true);
    this.#sendWaiting();
  }

  #sendWaiting(): void {
    if (!this.#waiting) return;
    this.#id += 1;
    this.#underWay = true;
    this.#worker.postMessage({ id: this.#id, ...this.#waiting });
    this.#waiting = undefined;
  }
}
