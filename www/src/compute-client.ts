// Talks to the worker: one request under way, and of those that wait only the latest is sent.

import type { Strokes } from "./large/strokes";
import type { Settings } from "./parameters";
import type { Reply, Request, Result } from "./result";

/** What is asked of the worker. */
export interface Question {
  readonly text: string;
  readonly file: File | undefined;
  readonly settings: Settings;
  /** Whether it is of a file that is being opened. */
  readonly isOpening?: boolean;
}

/** What is told of an answer, and on the way to it. */
export interface Listeners {
  result(result: Result, strokes: readonly Strokes[]): void;
  failure(message: string): void;
  busy(busy: boolean): void;
  /** How much is done, from 0 to 1, of what takes long. */
  progress(step: string, part: number): void;
}

/** Work that has taken longer is given up when something else is asked: a new worker is there sooner [ms]. */
const PATIENCE = 1500;

/** Starts the worker; `ask` may be called at any rate. */
export class ComputeClient {
  #worker: Worker | undefined;
  #underWay: Question | undefined;
  /** When that was asked. */
  #since = 0;
  #waiting: Question | undefined;
  /** The last answered, unless another was asked since. */
  #answered: Question | undefined;
  #id = 0;
  #tell: Listeners;

  constructor(listeners: Listeners) {
    this.#tell = listeners;
    this.#worker = this.#start();
  }

  /** Asks for the tool path of a text; an older question that was not sent yet is forgotten. */
  ask(question: Question): void {
    const latest = this.#waiting ?? this.#underWay ?? this.#answered;
    const isSame = latest?.text === question.text && latest.file === question.file;
    if (isSame && latest.settings === question.settings) return;
    this.#waiting = question;
    // A loop without end that is being typed must not hold up the text that ends it. Of a file the work
    // shows how far it is, and a button to stop it.
    const isShown = this.#underWay?.file !== undefined || this.#underWay?.isOpening;
    const isStuck = performance.now() - this.#since > PATIENCE && !isShown;
    if (this.#underWay && isStuck) this.#stop();
    if (this.#underWay) return;
    this.#tell.busy(true);
    this.#sendWaiting();
  }

  /** Stops what is under way, at once, and forgets what waits. */
  cancel(): void {
    this.#stop();
    this.#waiting = undefined;
    this.#answered = undefined;
    this.#tell.busy(false);
  }

  /** Gives the worker up; the next question starts another. */
  #stop(): void {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#underWay = undefined;
  }

  #start(): Worker {
    const worker = new Worker(new URL("./compute.worker.ts", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data }: MessageEvent<Reply>) => this.#take(data));
    worker.addEventListener("error", (event) => {
      // Of one that could not be loaded no other is started until something is asked, else there would
      // be no end to it. Where memory has ended, another has some for what waits.
      const { message = "" } = event;
      const isAsked = this.#underWay !== undefined;
      this.#stop();
      this.#answered = undefined;
      if (this.#waiting) this.#sendWaiting();
      else if (isAsked) this.#tell.failure(message || "the worker could not be started");
      if (!this.#underWay) this.#tell.busy(false);
    });
    return worker;
  }

  #take(reply: Reply): void {
    const { id } = reply.kind === "result" ? reply.result : reply;
    // Of a worker that was given up.
    if (id !== this.#id || !this.#underWay) return;
    if (reply.kind === "progress") {
      this.#tell.progress(reply.step, reply.part);
      return;
    }
    const asked = this.#underWay;
    this.#answered = asked;
    this.#underWay = undefined;
    this.#sendWaiting();
    if (reply.kind === "result") this.#tell.result(named(reply.result, asked), reply.strokes);
    else this.#tell.failure(reply.message);
    if (!this.#underWay) this.#tell.busy(false);
  }

  #sendWaiting(): void {
    if (!this.#waiting) return;
    const { text, file, settings } = this.#waiting;
    this.#id += 1;
    this.#underWay = this.#waiting;
    this.#since = performance.now();
    this.#waiting = undefined;
    const request: Request = { id: this.#id, text, file, settings };
    this.#worker ??= this.#start();
    this.#worker.postMessage(request);
  }
}

/** A result by the file that was asked about, of which the worker has had a copy. */
function named(result: Result, { file }: Partial<Question> = {}): Result {
  return result.long && file ? { ...result, long: { ...result.long, file } } : result;
}
