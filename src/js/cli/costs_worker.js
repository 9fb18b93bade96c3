// A thread that plans the path of a program by the limits of several machines.
import { parentPort, workerData } from "node:worker_threads";

import { compensate, parseProgram } from "../node.js";
import { durationOf } from "./costs.js";

/** @type {{ source: import("./costs.js").Source, machines: import("../types.d.ts").Limits[] }} */
const { source, machines } = workerData;
const path = compensate(parseProgram(source.text, source.parse), source.compensate);
parentPort?.postMessage(machines.map((limits) => durationOf(path, limits)));
