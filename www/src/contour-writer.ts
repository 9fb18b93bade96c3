// Writes the blocks of a contour: motion words anew, all else as it was.

import { INITIAL_MODE, type Mode, modeAfter, motionBlocks, readBlock } from "./blocks";
import { NO_WORDS } from "./contour-reader";
import type { Point } from "./geometry";
import type { Contour, Node, Segment } from "./part";

/** Writes the blocks of a contour below the lines before it. */
export class ContourWriter {
  readonly lines: string[];
  #contour: Contour;
  #mode: Mode;
  #motion: number | undefined;
  #at: Point;
  #unnumbered: number[] = [];

  constructor(before: readonly string[], contour: Contour) {
    this.lines = [...before];
    this.#contour = contour;
    this.#mode = modeAt(before, before.length);
    const motions = motionBlocks(before);
    this.#at = contour.leadIn?.at ?? motions.at(-1)?.to ?? [0, 0];
    this.#motion = undefined;
  }

  contour(): Contour {
    const { start, segments, leadOut, blocks, extent } = this.#contour;
    const newStart = this.#node(start, 1);
    let inSpline = false;
    const written = segments.map((segment) => {
      const afterSpline = inSpline;
      inSpline = segment.kind === "spline";
      // Two splines in a row are told apart by a repeated type point.
      if (afterSpline && inSpline) this.#node({ at: this.#at, line: 0 }, 5);
      return this.#segment(segment);
    });
    const last = leadOut && this.#node(leadOut, 1);
    const end = this.lines.length;
    return {
      ...this.#contour,
      start: newStart,
      segments: written,
      leadOut: last,
      blocks: [blocks[0], blocks[1] + end - extent[1]],
      extent: [extent[0], end],
    };
  }

  #segment(segment: Segment): Segment {
    switch (segment.kind) {
      case "line":
        return { ...segment, end: this.#node(segment.end, segment.rapid ? 0 : 1) };
      case "arc": {
        const { end, center, clockwise } = segment;
        return { ...segment, end: this.#node(end, clockwise ? 2 : 3, center) };
      }
      case "spline":
        return { ...segment, points: segment.points.map((node) => this.#node(node, 5)) };
    }
  }

  /** Writes the block of one node and returns the node at its new line. */
  #node(node: Node, motion: number, center?: Point): Node {
    const words = node.words ?? NO_WORDS;
    this.lines.push(...words.before);
    for (const line of [...words.before, words.modal]) {
      this.#mode = modeAfter(this.#mode, readBlock(line, 0).words);
    }
    const from = this.#at;
    const code = motion === this.#motion ? "" : motion === 5 ? "G05" : `G${motion}`;
    const place = coordinates(from, node.at, this.#mode, center !== undefined || motion === 5);
    const middle = center ? this.#centers(from, center) : "";
    this.lines.push(join([words.number, code, words.modal, place, middle, words.tail]));
    this.#motion = motion;
    this.#at = node.at;
    this.#numberLines(words.number);
    return { ...node, line: this.lines.length };
  }

  #centers(from: Point, center: Point): string {
    const { unit, absoluteCenters } = this.#mode;
    const base: Point = absoluteCenters ? [0, 0] : roundPoint(from, unit);
    return `I${decimal(center[0] - base[0], unit)} J${decimal(center[1] - base[1], unit)}`;
  }

  /** Gives blocks that were added between two numbered ones numbers between theirs. */
  #numberLines(number: string): void {
    const here = /^N(\d+)$/i.exec(number);
    const line = this.lines.length - 1;
    if (!here) {
      if (number === "") this.#unnumbered.push(line);
      return;
    }
    const first = this.#unnumbered[0];
    const count = this.#unnumbered.length;
    const before = first === undefined ? null : /^N(\d+)/i.exec(this.lines[first - 1] ?? "");
    if (before) {
      const [low, high] = [Number(before[1]), Number(here[1])];
      const step = (high - low) / (count + 1);
      if (step >= 1) {
        this.#unnumbered.forEach((at, k) => {
          this.lines[at] = `N${Math.round(low + step * (k + 1))} ${this.lines[at]}`;
        });
      }
    }
    this.#unnumbered = [];
  }
}

/** The modes after the first lines of a text. */
export function modeAt(lines: readonly string[], count: number): Mode {
  return lines
    .slice(0, count)
    .reduce((mode, line, i) => modeAfter(mode, readBlock(line, i + 1).words), INITIAL_MODE);
}

/** X and Y words from one point to another; both where `full`, else only what changes. */
export function coordinates(from: Point, to: Point, mode: Mode, full = false): string {
  const { unit, incremental } = mode;
  const [a, b] = [roundPoint(from, unit), roundPoint(to, unit)];
  const words = (["X", "Y"] as const).map((letter, i) => {
    const [x, y] = [a[i] as number, b[i] as number];
    return !full && x === y ? "" : `${letter}${decimal(incremental ? y - x : y, unit)}`;
  });
  return words.some(Boolean) ? join(words) : `X${decimal(incremental ? 0 : b[0], unit)}`;
}

function roundPoint(point: Point, unit: number): Point {
  return [Number(decimal(point[0], unit)) * unit, Number(decimal(point[1], unit)) * unit];
}

/** A length as a number of the program: micrometres, or as many inches. */
function decimal(value: number, unit: number): string {
  const text = (value / unit).toFixed(unit === 1 ? 3 : 5).replace(/\.?0+$/, "");
  return text === "-0" || text === "" ? "0" : text;
}

/** Words of a block, without those that are empty. */
export function join(words: readonly string[]): string {
  return words.filter(Boolean).join(" ");
}
