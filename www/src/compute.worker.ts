// The worker: reads a program, compensates it and sends the geometry back without copying it.

import init, { compensate, parseProgram, RECORD_STRIDE } from "g41";
import { compensationOptions } from "./parameters";
import type { Lines, Reply, Request, Result } from "./result";

/** How far the polylines on the screen may be from their curves [mm]. */
const DRAWING_TOLERANCE = 0.002;

let ready = init();

self.addEventListener("message", async ({ data }: MessageEvent<Request>) => {
  const reply = await answer(data);
  const buffers = reply.kind === "result" ? transferables(reply.result) : [];
  self.postMessage(reply, { transfer: buffers });
});

async function answer(request: Request): Promise<Reply> {
  try {
    await ready;
    return { kind: "result", result: compute(request) };
  } catch (error) {
    // After an internal error the package asks to be loaded afresh.
    ready = init();
    return { kind: "failure", id: request.id, message: String(error) };
  }
}

function compute({ id, text, settings }: Request): Result {
  const began = performance.now();
  const { tolerance } = settings;
  const program = parseProgram(text);
  try {
    const path = compensate(program, compensationOptions(settings));
    try {
      const written = path.emit({ tolerance });
      return {
        id,
        text,
        settings,
        contours: program.contours,
        programmed: lines(program.polylines(DRAWING_TOLERANCE)),
        path: lines(path.polylines(DRAWING_TOLERANCE)),
        records: path.records(),
        stride: RECORD_STRIDE,
        transitions: path.transitions,
        diagnostics: [...path.diagnostics, ...written.diagnostics],
        gouges: path.gouges,
        uncut: path.uncut,
        gcode: written.text,
        milliseconds: performance.now() - began,
      };
    } finally {
      path[Symbol.dispose]();
    }
  } finally {
    program[Symbol.dispose]();
  }
}

function lines({ points, starts, owners }: Lines): Lines {
  return { points, starts, owners };
}

function transferables({ programmed, path, records, uncut }: Result): Transferable[] {
  const arrays = [programmed, path].flatMap(({ points, starts, owners }) => [
    points,
    starts,
    owners,
  ]);
  const outlines = uncut.map(({ outline }) => outline);
  return [...arrays, ...outlines, records].map((array) => array.buffer as ArrayBuffer);
}
