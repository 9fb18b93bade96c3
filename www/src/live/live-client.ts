// Talks to the live worker: one step under way, and of those that wait only the latest is sent.

import type { ProgrammedContour, Segment } from "g41";
import type { Point } from "../geometry";
import type { Settings } from "../parameters";
import { type Contour, endNode, type PointRef } from "../part";
import { type LivePicture, patched } from "./picture";
import type { Changed, Edit, Grab, Lost, Step } from "./protocol";

type Now = Pick<LivePicture, "contour" | "ref" | "at" | "leads">;

/** Edits of one contour at a time; `step` may be called at any rate. */
export class LiveClient {
  #worker: Worker | undefined;
  #onPicture: (picture: LivePicture, milliseconds: number) => void;
  #picture: LivePicture | undefined;
  #held: { contour: ProgrammedContour; settings: Settings } | undefined;
  #now: Now | undefined;
  #waiting: { edits: readonly Edit[]; now: Now } | undefined;
  #underWay: Now | undefined;
  #id = 0;

  constructor(onPicture: (picture: LivePicture, milliseconds: number) => void) {
    this.#onPicture = onPicture;
    // Before it is needed, since a drag does not wait.
    this.#worker = this.#start();
  }

  #start(): Worker {
    const worker = new Worker(new URL("./live.worker.ts", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data }: MessageEvent<Changed | Lost>) =>
      this.#take(data),
    );
    worker.addEventListener("error", () => {
      worker.terminate();
      this.#worker = undefined;
      this.#lose();
    });
    return worker;
  }

  /** The text goes on alone, and with the next drag the contour is taken hold of afresh. */
  #lose(): void {
    this.#held = undefined;
    this.#waiting = undefined;
    this.#underWay = undefined;
  }

  /** Takes hold of a contour, unless it is the one that is held. */
  grab(index: number, contour: ProgrammedContour, settings: Settings, radius: number): void {
    if (this.#held?.contour === contour && this.#held.settings === settings) return;
    this.#held = { contour, settings };
    this.#picture = undefined;
    this.#waiting = undefined;
    this.#underWay = undefined;
    const leads = [contour.leadIn !== undefined, contour.leadOut !== undefined] as const;
    const ref: PointRef = { contour: index, role: "start", segment: -1, index: 0 };
    this.#now = { contour: index, ref, at: contour.start, leads };
    this.#id += 1;
    this.#send({ kind: "grab", id: this.#id, contour: packed(contour), settings, radius });
  }

  /** Takes a contour for the one that is held, as the program now says it. */
  hold(contour: ProgrammedContour | undefined): void {
    if (this.#held && contour) this.#held = { ...this.#held, contour };
  }

  /** Edits the contour that is held. */
  step(edits: readonly Edit[], ref: PointRef, at: Point): void {
    if (!this.#held || !this.#now) return;
    this.#waiting = { edits, now: { ...this.#now, ref, at } };
    if (!this.#underWay) this.#sendWaiting();
  }

  #sendWaiting(): void {
    if (!this.#waiting) return;
    const { edits, now } = this.#waiting;
    this.#waiting = undefined;
    this.#now = now;
    this.#send({ kind: "step", id: this.#id, edits });
  }

  #send(message: Grab | Step): void {
    this.#underWay = this.#now;
    this.#worker ??= this.#start();
    this.#worker.postMessage(message);
  }

  #take(changed: Changed | Lost): void {
    // Of a contour that is held no more.
    if (changed.id !== this.#id || !this.#underWay) return;
    if ("lost" in changed) {
      this.#lose();
      return;
    }
    const first = this.#picture === undefined;
    this.#picture = patched(this.#picture, this.#underWay, changed);
    this.#underWay = undefined;
    this.#sendWaiting();
    // The first answer shows what is there already.
    if (this.#picture && !first) this.#onPicture(this.#picture, changed.milliseconds);
  }
}

/** A contour with its type points in one array, which is sent faster than many. */
function packed(contour: ProgrammedContour): ProgrammedContour {
  const segments = contour.segments.map((segment) => {
    if (segment.kind !== "spline" || segment.points instanceof Float64Array) return segment;
    const points = new Float64Array(2 * segment.points.length);
    segment.points.forEach(([x, y], i) => {
      points[2 * i] = x;
      points[2 * i + 1] = y;
    });
    return { ...segment, points };
  });
  return { ...contour, segments };
}

/** What has changed between two states of a contour; undefined where that is not only points. */
export function editsBetween(before: Contour, after: Contour): Edit[] | undefined {
  const edits: Edit[] = [];
  if (before.segments.length !== after.segments.length) return undefined;
  const moved = (a: Point, b: Point) => a[0] !== b[0] || a[1] !== b[1];
  for (const lead of ["leadIn", "leadOut"] as const) {
    const [old, now] = [before[lead], after[lead]];
    if (old && now && moved(old.at, now.at)) return undefined;
  }
  if (moved(before.start.at, after.start.at)) {
    edits.push({ kind: "move", segment: -1, index: 0, to: after.start.at });
  }
  for (const [i, now] of after.segments.entries()) {
    const old = before.segments[i];
    if (old === now) continue;
    if (!old || old.kind !== now.kind) return undefined;
    const to = endNode(now).at;
    if (now.kind === "arc") {
      const { center, clockwise } = now;
      const shape: Segment = { kind: "arc", to, center, clockwise };
      edits.push({ kind: "set", segment: i, shape });
    } else if (moved(endNode(old).at, to)) {
      const index = now.kind === "spline" ? now.points.length - 1 : 0;
      edits.push({ kind: "move", segment: i, index, to });
    }
  }
  return edits;
}

/** Whether a point is an inner type point, of which only it itself moves. */
export function isInner(contour: Contour, { role, segment, index }: PointRef): boolean {
  const own = contour.segments[segment];
  return role === "type" && own?.kind === "spline" && index < own.points.length - 1;
}
