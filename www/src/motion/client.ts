// Talks to the worker that plans: one request under way, and of those that wait only the latest is sent;
// work that takes long is given up for it.

import type { Limits } from "g41";
import type { Settings } from "../parameters";
import type { MotionData, MotionReply, MotionRequest, Other } from "./protocol";

/** What is told of the answers. */
export interface MotionListeners {
  planned(data: MotionData): void;
  compared(stops: Other | undefined, method: Other | undefined): void;
  failed(message: string): void;
  busy(busy: boolean): void;
}

/** Work that has taken longer is given up when something else is asked: a new worker is there sooner [ms]. */
const PATIENCE = 700;

/** What is asked. */
export type MotionQuestion = Omit<MotionRequest, "id">;

/** Starts the worker with the first question. */
export class MotionClient {
  #worker: Worker | undefined;
  #underWay: number | undefined;
  /** When the worker was given what it has not ended yet. */
  #since: number | undefined;
  #waiting: MotionQuestion | undefined;
  #id = 0;
  #tell: MotionListeners;

  constructor(listeners: MotionListeners) {
    this.#tell = listeners;
  }

  /** Asks for the motion of a program; an older question that was not sent yet is forgotten. */
  ask(text: string, settings: Settings, limits: Limits): void {
    this.#waiting = { text, settings, limits };
    if (this.#since !== undefined && performance.now() - this.#since > PATIENCE) this.#stop();
    if (this.#underWay === undefined) this.#send();
  }

  #send(): void {
    const question = this.#waiting;
    if (!question) return;
    this.#waiting = undefined;
    this.#worker ??= this.#start();
    this.#id += 1;
    this.#underWay = this.#id;
    this.#since = performance.now();
    this.#tell.busy(true);
    this.#worker.postMessage({ id: this.#id, ...question } satisfies MotionRequest);
  }

  #stop(): void {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#underWay = undefined;
    this.#since = undefined;
  }

  #start(): Worker {
    const worker = new Worker(new URL("./motion.worker.ts", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data }: MessageEvent<MotionReply>) => this.#take(data));
    worker.addEventListener("error", (event) => {
      // Where memory has ended, another worker has some for what waits.
      this.#stop();
      if (this.#waiting) {
        this.#send();
        return;
      }
      this.#tell.failed(event.message || "the worker could not be started");
      this.#tell.busy(false);
    });
    return worker;
  }

  #take(reply: MotionReply): void {
    if (reply.id !== this.#id) return;
    if (reply.kind === "others") {
      this.#since = undefined;
      this.#tell.compared(reply.stops, reply.method);
      return;
    }
    this.#underWay = undefined;
    if (reply.kind === "plan") this.#tell.planned(reply.data);
    else {
      this.#since = undefined;
      this.#tell.failed(reply.message);
    }
    if (this.#waiting) this.#send();
    else this.#tell.busy(false);
  }
}
