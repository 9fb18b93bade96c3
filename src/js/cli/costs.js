// What each limit of the machine costs: how long the path would take if one thing were otherwise.
import { once } from "node:events";
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";

/** @typedef {import("../types.d.ts").ToolPath} ToolPath */
/** @typedef {import("../types.d.ts").Limits} Limits */
/** @typedef {{ name: string, duration: number }} Cost */

/**
 * What a path is made of, by which a thread has it too.
 *
 * @typedef {object} Source
 * @property {string} text
 * @property {import("../types.d.ts").ParseOptions} parse
 * @property {import("../types.d.ts").ProgramOptions} compensate
 */

/** Paths of more moves than this are not planned again and again. */
const many = 20_000;

/** What planned the path in less time than this does so again sooner than threads would start [s]. */
const short = 0.3;

/** Threads may hold so many samples at a time, about 100 bytes each. */
const held = 4_000_000;

/**
 * The times with one thing otherwise; none for a very long path.
 *
 * @param {ToolPath} path
 * @param {Source} source of the path
 * @param {Limits} limits
 * @param {{ seconds: number, samples: number }} planned how long it took to plan the path by those limits,
 *   and the samples that came of it
 * @returns {Promise<Cost[]>}
 */
export async function costsOf(path, source, limits, { seconds, samples }) {
  if (path.count > many) {
    return [];
  }
  const others = changed(limits);
  const all = [...others.values()];
  const threads = Math.min(all.length, availableParallelism(), Math.floor(held / samples));
  const times =
    seconds < short || threads < 2
      ? all.map((other) => durationOf(path, other))
      : await inThreads(source, all, threads);
  return [...others.keys()].map((name, i) => ({ name, duration: Number(times[i]) }));
}

/**
 * The limits with one thing otherwise, by what that is.
 *
 * @param {Limits} limits
 * @returns {Map<string, Limits>}
 */
export function changed(limits) {
  const { acceleration, jerk, velocity, cornerDeviation = 0.05, snap } = limits;
  const twice = snap === undefined ? {} : { snap: 2 * snap };
  return new Map([
    ["twice the velocity", { ...limits, velocity: 2 * velocity }],
    ["twice the acceleration", { ...limits, acceleration: 2 * acceleration }],
    ["twice the jerk", { ...limits, jerk: 2 * jerk, ...twice }],
    ["twice the corner deviation", { ...limits, cornerDeviation: 2 * cornerDeviation }],
    ["a stop at each block", { ...limits, exactStop: true }],
  ]);
}

/**
 * How long a machine takes for a path [s].
 *
 * @param {ToolPath} path
 * @param {Limits} limits
 */
export function durationOf(path, limits) {
  const motion = path.plan(limits);
  const { duration } = motion;
  motion[Symbol.dispose]?.();
  return duration;
}

/**
 * How long machines take for a path [s], found by threads each of which takes every so manieth.
 *
 * @param {Source} source
 * @param {readonly Limits[]} machines
 * @param {number} threads
 * @returns {Promise<number[]>}
 */
export async function inThreads(source, machines, threads) {
  /** @type {number[]} */
  const times = [];
  const place = new URL("./costs_worker.js", import.meta.url);
  await Promise.all(
    Array.from({ length: threads }, async (_, first) => {
      const own = machines.filter((_machine, i) => i % threads === first);
      const worker = new Worker(place, { workerData: { source, machines: own } });
      const [found] = await once(worker, "message");
      for (const [i, time] of found.entries()) {
        times[first + i * threads] = time;
      }
    }),
  );
  return times;
}
