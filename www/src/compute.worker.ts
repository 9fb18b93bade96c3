// The worker: reads a program, compensates it and sends the geometry back without copying it.

import init, {
  compensate,
  type Diagnostic,
  type Program,
  ProgramCompensation,
  ProgramReader,
  parseProgram,
  RECORD_STRIDE,
  type ToolPath,
} from "g41";
import { modeAt } from "./contour-writer";
import {
  boxOfStrokes,
  coarsePolylines,
  type Moves,
  movesOf,
  seen,
  strokesOf,
} from "./large/strokes";
import { decoded, longText } from "./long-text";
import { compensationOptions, parseOptions, radiusOfTool, type Settings } from "./parameters";
import { type Lines, LONG, lineOf, type Reply, type Request, type Result } from "./result";
import { spaceOf } from "./space/strokes";
import { boxOf } from "./view";

/** How far the polylines on the screen may be from their curves [mm]. */
const DRAWING_TOLERANCE = 0.002;
/** Blocks of one slice of a long program. */
const SLICE = 20_000;
/** Diagnostics of a very long program that are listed. */
const MOST_DIAGNOSTICS = 2000;

/** What is done with a long program, and about which part of the time it takes. */
const STEPS = [
  ["Reading", 35],
  ["Compensating", 30],
  ["Writing", 20],
  ["Drawing", 15],
] as const;

/** A very long program that was read, so that other settings need no second reading. */
interface Held {
  readonly key: string;
  readonly program: Program;
}

/** What is said of work under way. */
type Tell = (step: number, part: number) => void;

let ready = init();
let held: Held | undefined;

self.addEventListener("message", async ({ data }: MessageEvent<Request>) => {
  const reply = await answer(data);
  self.postMessage(reply, { transfer: reply.kind === "result" ? transferables(reply) : [] });
});

async function answer(request: Request): Promise<Reply> {
  try {
    await ready;
    return request.file ? await computeLong(request, request.file) : compute(request);
  } catch (error) {
    // After an internal error the package asks to be loaded afresh.
    ready = init();
    held = undefined;
    return { kind: "failure", id: request.id, message: String(error) };
  }
}

/** All that is known of a program of a usual length. */
function compute({ id, text, settings }: Request): Reply {
  const began = performance.now();
  release();
  const tell = text.length > LONG ? teller(id) : undefined;
  const program = tell
    ? readInSlices(text, settings, tell)
    : parseProgram(text, parseOptions(settings));
  const path = tell
    ? compensated(program, settings, tell)
    : compensate(program, compensationOptions(settings));
  try {
    tell?.(2, 0);
    const { target, tolerance } = settings;
    const written = path.emit({ target, tolerance });
    const diagnostics = gravestFirst([...path.diagnostics, ...written.diagnostics]);
    tell?.(3, 0);
    const moves = movesOf(path);
    const { axes, rapids } = moves;
    const outlines = program.polylines(DRAWING_TOLERANCE);
    const way = path.polylines(DRAWING_TOLERANCE);
    const space = spaceOf(outlines, way, moves);
    const programmed = lines(outlines, axes);
    const drawn = lines(way, axes);
    const { contours } = program;
    const radii = contours.map(({ radius, tool, blocks }) => {
      const unit = () => modeAt(text.split("\n"), blocks[0]).unit;
      return radius ?? radiusOfTool(settings, tool, unit);
    });
    const room = Math.min(50, Math.abs(settings.radius));
    const result: Result = {
      id,
      text,
      settings,
      axes,
      box: boxOf(room, programmed.points, drawn.points) ?? boxOf(1, seen(rapids, axes)),
      dialect: program.dialect,
      tools: program.tools,
      long: undefined,
      contours,
      radii,
      programmed,
      path: drawn,
      space,
      ways: moves.ways,
      records: path.records(),
      stride: RECORD_STRIDE,
      transitions: path.transitions,
      diagnostics,
      counts: countsOf(diagnostics),
      gouges: path.gouges,
      uncut: path.uncut,
      gcode: written.text,
      milliseconds: performance.now() - began,
    };
    return { kind: "result", strokes: [], result };
  } finally {
    path[Symbol.dispose]();
    program[Symbol.dispose]();
  }
}

/** What is shown of a very long program, with word of how far it is. */
async function computeLong({ id, settings }: Request, file: File): Promise<Reply> {
  const began = performance.now();
  const tell = teller(id);
  tell(0, 0);
  const found = decoded(new Uint8Array(await file.arrayBuffer()));
  if (!found) throw new Error(`${file.name} is not a text`);
  const { text, bytes, encoding } = found;
  const program = read(text, `${file.name} ${file.lastModified} ${file.size}`, settings, tell);
  const path = compensated(program, settings, tell);
  try {
    tell(2, 0);
    const { target, tolerance } = settings;
    const written = path.emit({ target, tolerance });
    const code = longText(new TextEncoder().encode(written.text));
    tell(3, 0);
    const moves = movesOf(path);
    const strokes = strokesOf(program, path, moves);
    const diagnostics = gravestFirst([...path.diagnostics, ...written.diagnostics]);
    const result: Result = {
      ...NOTHING_LISTED,
      id,
      text: "",
      settings,
      axes: moves.axes,
      box: boxOfStrokes(strokes),
      space: spaceOf(coarsePolylines(program), coarsePolylines(path), moves),
      dialect: program.dialect,
      tools: program.tools,
      long: { file, text: longText(bytes, encoding), code, moves: path.count },
      stride: RECORD_STRIDE,
      diagnostics: diagnostics.slice(0, MOST_DIAGNOSTICS),
      counts: countsOf(diagnostics),
      milliseconds: performance.now() - began,
    };
    return { kind: "result", strokes, result };
  } finally {
    path[Symbol.dispose]();
  }
}

/** What a very long program has none of, since each list would be as long as it. */
const NOTHING_LISTED = {
  contours: [],
  radii: [],
  ways: [],
  programmed: emptyLines(),
  path: emptyLines(),
  records: new Float64Array(),
  transitions: [],
  gouges: [],
  uncut: [],
  gcode: "",
} as const;

function emptyLines(): Lines {
  return {
    points: new Float64Array(),
    starts: new Uint32Array(),
    owners: new Uint32Array(),
  };
}

/** Tells how much of everything is done. */
function teller(id: number): Tell {
  const all = STEPS.reduce((sum, [, share]) => sum + share, 0);
  return (step, part) => {
    const [name, share] = STEPS[step] ?? ["", 0];
    const before = STEPS.slice(0, step).reduce((sum, [, other]) => sum + other, 0);
    const done = (before + share * part) / all;
    self.postMessage({ kind: "progress", id, step: name, part: done } satisfies Reply);
  };
}

/** The program of a text, read in slices unless it is the one that is held. */
function read(text: string, name: string, settings: Settings, tell: Tell): Program {
  const key = JSON.stringify([name, parseOptions(settings)]);
  if (held?.key === key) return held.program;
  release();
  const program = readInSlices(text, settings, tell);
  held = { key, program };
  return program;
}

function readInSlices(text: string, settings: Settings, tell: Tell): Program {
  const reader = new ProgramReader(text, parseOptions(settings));
  while (reader.step(SLICE)) tell(0, reader.progress);
  return reader.finish();
}

function release(): void {
  held?.program[Symbol.dispose]();
  held = undefined;
}

function compensated(program: Program, settings: Settings, tell: Tell): ToolPath {
  tell(1, 0);
  const work = new ProgramCompensation(program, compensationOptions(settings));
  while (work.step(SLICE)) tell(1, work.progress);
  return work.finish();
}

function countsOf(diagnostics: readonly Diagnostic[]): Result["counts"] {
  const counts = { error: 0, warning: 0, info: 0 };
  for (const { severity } of diagnostics) counts[severity] += 1;
  return counts;
}

const GRAVITY = { error: 0, warning: 1, info: 2 } as const;

/** Sorts errors before all others, and those alike by their line. */
function gravestFirst(all: Diagnostic[]): Diagnostic[] {
  const before = (a: Diagnostic, b: Diagnostic) =>
    GRAVITY[a.severity] - GRAVITY[b.severity] || (lineOf(a) ?? 0) - (lineOf(b) ?? 0);
  return all.sort(before);
}

function lines(
  { points3, starts, owners }: ReturnType<ToolPath["polylines"]>,
  axes: Moves["axes"],
) {
  return { points: seen(points3, axes), starts, owners };
}

function transferables({ result, strokes }: Reply & { kind: "result" }): Transferable[] {
  const { programmed, path, space, records, uncut, long } = result;
  const arrays: ArrayBufferView[] = [records];
  for (const { points, starts, owners } of [programmed, path]) arrays.push(points, starts, owners);
  for (const { outline } of uncut) arrays.push(outline);
  for (const { points, lines } of [...strokes, ...space.strokes]) arrays.push(points, lines);
  for (const text of long ? [long.text, long.code] : []) arrays.push(text.bytes, text.starts);
  const buffers = arrays.filter(({ byteLength }) => byteLength > 0);
  return [...new Set(buffers.map((array) => array.buffer as ArrayBuffer))];
}
