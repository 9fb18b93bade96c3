// Finds the points of a programmed contour in the blocks of the text.

import type { ProgrammedContour, ProgrammedSegment } from "g41";
import { type Block, endsAt, isMotion, type MotionBlock, type Word } from "./blocks";
import type { Point } from "./geometry";
import type { BlockWords, Contour, Node, Segment } from "./part";

/** The words of a block that carries none to keep. */
export const NO_WORDS: BlockWords = { before: [], number: "", modal: "", tail: "" };

/** Letters of words that the page writes itself. */
const REWRITTEN = new Set(["X", "Y", "I", "J", "R"]);

/** The contour as the page edits it, from the one that the package found in the same text. */
export function readContour(
  programmed: ProgrammedContour,
  lines: readonly string[],
  motions: readonly MotionBlock[],
): Contour {
  return new Reader(lines, motions).contour(programmed);
}

/** What is kept of a block when its motion is rewritten. */
export function wordsOf(block: Block, before: readonly string[]): BlockWords {
  const kept = block.words.filter((word) => !isMotion(word) && !REWRITTEN.has(word.letter));
  const isModal = ({ letter }: Word) => letter === "G" || letter === "D";
  const raw = (list: readonly Word[]) => list.map((word) => word.raw);
  return {
    before,
    number: block.number,
    modal: raw(kept.filter(isModal)).join(" "),
    tail: [...raw(kept.filter((word) => !isModal(word))), ...block.comments].join(" "),
  };
}

const isStraight = (motion: number) => motion <= 1;
const isSpline = (motion: number) => motion === 5;
const isInvolute = (motion: number) => motion === 2.2 || motion === 3.2;

/** Takes one motion block after the other as the points of a contour. */
class Reader {
  #lines: readonly string[];
  #motions: readonly MotionBlock[];
  /** Index of the motion block that is taken next. */
  #next = 0;
  /** The line that was taken last; 0 before the first. */
  #line = 0;
  /** Whether each block was what the contour says, so that it can be rewritten. */
  #plain = true;

  constructor(lines: readonly string[], motions: readonly MotionBlock[]) {
    this.#lines = lines;
    this.#motions = motions;
  }

  contour({ blocks, side, start, segments, leadIn, leadOut }: ProgrammedContour): Contour {
    const first = segments[0]?.origin.block ?? blocks[0];
    const next = this.#motions.findIndex(({ block }) => block.line >= first);
    const before = this.#motions[next - 2];
    this.#next = Math.max(0, next - 1);
    const startNode = this.#take(start, isStraight);
    const taken = segments.map((segment) => this.#segment(segment));
    const end = leadOut && this.#take(leadOut, isStraight);
    const canMove = leadIn && endsAt(before, leadIn) && before.motion <= 1 && before.block.plain;
    return {
      blocks,
      side,
      start: startNode,
      segments: taken,
      leadIn: leadIn && { at: leadIn, line: canMove ? before.block.line : 0 },
      leadOut: end,
      extent: [startNode.line, this.#line],
      editable: this.#plain && segments.length > 0,
    };
  }

  #segment(segment: ProgrammedSegment): Segment {
    switch (segment.kind) {
      case "line": {
        const rapid = this.#motions[this.#next]?.motion === 0;
        return { kind: "line", end: this.#take(segment.to, isStraight), rapid };
      }
      case "arc": {
        const { center, clockwise, to } = segment;
        const end = this.#take(to, (motion) => motion === (clockwise ? 2 : 3));
        return { kind: "arc", end, center, clockwise };
      }
      case "spline": {
        this.#skipSeparator();
        const points = pairs(segment.points);
        return { kind: "spline", points: points.map((at) => this.#take(at, isSpline)) };
      }
      case "bezier": {
        // Its control points are no points of the contour; the text is where they are changed.
        this.#plain = false;
        const end = pairs(segment.controls).at(-1) ?? [0, 0];
        return { kind: "spline", points: [this.#take(end, isSpline)] };
      }
      case "involute":
        // Its end lies where circle and start let it; the text is where it is changed.
        this.#plain = false;
        return { kind: "spline", points: [this.#take(segment.to, isInvolute)] };
    }
  }

  /** A repeated type point only says that another spline begins. */
  #skipSeparator(): void {
    const before = this.#motions[this.#next - 1];
    const here = this.#motions[this.#next];
    if (before?.motion !== 5 || here?.motion !== 5 || !endsAt(here, before.to)) return;
    this.#next += 1;
    this.#line = here.block.line;
  }

  /** Takes the next motion block, which should end at `at`, as a point of the contour. */
  #take(at: Point, fits: (motion: number) => boolean): Node {
    const found = this.#motions[this.#next];
    if (!endsAt(found, at) || !fits(found.motion) || !found.block.plain) {
      this.#plain = false;
      return { at, words: NO_WORDS, line: found?.block.line ?? this.#line };
    }
    const { line } = found.block;
    const before = this.#line > 0 ? this.#lines.slice(this.#line, line - 1) : [];
    this.#next += 1;
    this.#line = line;
    return { at, words: wordsOf(found.block, before), line };
  }
}

function pairs(points: readonly Point[] | Float64Array): Point[] {
  if (!(points instanceof Float64Array)) return [...points];
  const list: Point[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) {
    list.push([points[i] as number, points[i + 1] as number]);
  }
  return list;
}
