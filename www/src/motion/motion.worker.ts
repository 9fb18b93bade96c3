// The worker behind the plots of motion: plans the path, and then by other methods beside it.

import init, {
  compensate,
  type Limits,
  type Motion,
  parseProgram,
  RECORD_STRIDE,
  type ToolPath,
} from "g41";
import { lineOfWay } from "../large/ways";
import { compensationOptions, parseOptions, type Settings } from "../parameters";
import { FIELD, RAPID } from "../result";
import {
  type MotionData,
  type MotionReply,
  type MotionRequest,
  type Other,
  otherMethod,
} from "./protocol";

/** The place of the feed in a record. */
const FEED = 3;

/** A path of more moves is not planned once more by the methods that take longer. */
const MOST_COMPARED = 20_000;

/** A path that was planned, so that other limits need no second compensation. */
interface Held {
  readonly text: string;
  readonly settings: string;
  readonly path: ToolPath;
}

let ready = init();
let held: Held | undefined;
/** The request that came last: what is asked for before it is not compared. */
let latest = 0;

self.addEventListener("message", async ({ data }: MessageEvent<MotionRequest>) => {
  latest = data.id;
  try {
    await ready;
    const path = pathOf(data);
    const plan = planned(path, data.limits);
    const reply: MotionReply = { kind: "plan", id: data.id, data: plan };
    self.postMessage(reply, { transfer: buffersOf(plan) });
    await compared(path, data);
  } catch (error) {
    // After an internal error the package asks to be loaded afresh.
    ready = init();
    held?.path[Symbol.dispose]();
    held = undefined;
    self.postMessage({
      kind: "failure",
      id: data.id,
      message: reasonOf(error),
    } satisfies MotionReply);
  }
});

/** Why there is no motion, in words for those who did not call a function. */
function reasonOf(error: unknown): string {
  const message = error instanceof Error ? error.message : String(error);
  if (!message.includes("million samples")) return message;
  return "This motion is too long to be shown: it has more than 8 million samples. A longer period gives fewer.";
}

/** The path of a program, compensated unless it is the one that is held. */
function pathOf({ text, settings }: MotionRequest): ToolPath {
  const key = keyOf(settings);
  if (held?.text === text && held.settings === key) return held.path;
  held?.path[Symbol.dispose]();
  held = undefined;
  const program = parseProgram(text, parseOptions(settings));
  try {
    const path = compensate(program, compensationOptions(settings));
    held = { text, settings: key, path };
    return path;
  } finally {
    program[Symbol.dispose]();
  }
}

function keyOf(settings: Settings): string {
  return JSON.stringify([parseOptions(settings), compensationOptions(settings)]);
}

function planned(path: ToolPath, limits: Limits): MotionData {
  const began = performance.now();
  const motion = path.plan(limits);
  try {
    const milliseconds = performance.now() - began;
    const { duration, time, x, y, z, velocity, jerk, step, violations } = motion;
    const { tangentialAcceleration: tangential, normalAcceleration: normal } = motion;
    const length = lengths(motion);
    const of = { time, x, y, z, velocity, tangential, normal, jerk, length };
    const moves = movesOf(path, limits);
    return { duration, violations, limits, milliseconds, step, ...of, ...moves };
  } finally {
    motion[Symbol.dispose]();
  }
}

/** The length of the chords up to each sample. */
function lengths({ x, y, z }: Motion): Float64Array {
  const length = new Float64Array(x.length);
  for (let i = 1; i < x.length; i += 1) {
    const away = (of: Float64Array) => (of[i] as number) - (of[i - 1] as number);
    length[i] = (length[i - 1] as number) + Math.hypot(away(x), away(y), away(z));
  }
  return length;
}

/** What is known of the moves of a path and of the ways between its pieces, in the order of `step`. */
function movesOf(path: ToolPath, { velocity, feedOverride = 1 }: Limits) {
  const { count: own, ways } = path;
  const records = path.records();
  const count = own + ways.length;
  const feeds = new Float64Array(count);
  const rapid = new Uint8Array(count);
  const lines = new Uint32Array(count);
  let next = 0;
  const add = (feed: number, isRapid: boolean, line: number) => {
    const isFree = isRapid || Number.isNaN(feed);
    feeds[next] = isFree ? velocity : Math.min(velocity, (feed / 60) * feedOverride);
    rapid[next] = isRapid ? 1 : 0;
    lines[next] = Number.isNaN(line) ? 0 : line;
    next += 1;
  };
  let way = 0;
  for (let i = 0; i < own; i += 1) {
    for (let leads = ways[way]; leads?.before === i; way += 1, leads = ways[way]) {
      const { kind, feed = Number.NaN } = leads.move;
      add(feed, kind === "rapid", lineOfWay(leads));
    }
    const at = i * RECORD_STRIDE;
    const [feed, line] = [records[at + FEED] as number, records[at + FIELD.block] as number];
    add(feed, records[at + FIELD.kind] === RAPID, line);
  }
  return { feeds, rapid, lines };
}

/** Tells how long the path takes with a stop at each block, and by the other method. */
async function compared(path: ToolPath, { id, limits }: MotionRequest): Promise<void> {
  const others: (Other | undefined)[] = [];
  for (const change of [
    { exactStop: true, mode: "fast" },
    { exactStop: false, mode: otherMethod(limits.mode) },
  ] as const) {
    // What was asked meanwhile comes first.
    await new Promise((resolve) => setTimeout(resolve));
    if (latest !== id) return;
    others.push(path.count > MOST_COMPARED ? undefined : other(path, { ...limits, ...change }));
  }
  const [stops, method] = others;
  self.postMessage({ kind: "others", id, stops, method } satisfies MotionReply);
}

function other(path: ToolPath, limits: Limits): Other | undefined {
  let motion: Motion;
  try {
    motion = path.plan(limits);
  } catch {
    // It takes so long that there would be too many samples.
    return undefined;
  }
  const { duration, violations } = motion;
  motion[Symbol.dispose]();
  return { duration, violations };
}

function buffersOf(data: MotionData): ArrayBuffer[] {
  return Object.values(data)
    .filter((value) => ArrayBuffer.isView(value) && value.byteLength > 0)
    .map((array) => array.buffer as ArrayBuffer);
}
