// Blocks of a program: their words, and where each of them leaves the tool.

import { coincide, type Point } from "./geometry";

/** One word of a block. */
export interface Word {
  readonly letter: string;
  readonly value: number;
  /** The word as it was written. */
  readonly raw: string;
}

/** A block split into what the page rewrites and what it keeps. */
export interface Block {
  /** Line of the text, counted from 1. */
  readonly line: number;
  /** A block-skip mark and the N word. */
  readonly number: string;
  readonly words: readonly Word[];
  readonly comments: readonly string[];
  /** Whether every character of it was understood. */
  readonly plain: boolean;
}

/** How coordinates are written at a place of the program. */
export interface Mode {
  /** G20: 25.4, G21: 1. */
  readonly unit: number;
  readonly incremental: boolean;
  /** G90.1: I and J are coordinates, not distances from the start. */
  readonly absoluteCenters: boolean;
}

/** A block that moves the tool in the plane. */
export interface MotionBlock {
  readonly block: Block;
  /** The motion word in force: 0, 1, 2, 2.2, 3, 3.2 or 5. */
  readonly motion: number;
  readonly to: Point;
}

/** Modes at the beginning of a program. */
export const INITIAL_MODE: Mode = { unit: 1, incremental: false, absoluteCenters: false };

const TOKEN =
  /\s+|(?<comment>\([^)]*\)?|;.*)|(?<skip>^\s*\/)|(?<letter>[A-Za-z])\s*(?<value>[-+]?(?:\d+\.?\d*|\.\d+))/gy;

/** Splits a line of a program into words. */
export function readBlock(text: string, line: number): Block {
  const words: Word[] = [];
  const comments: string[] = [];
  let number = "";
  let plain = true;
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const at = TOKEN.lastIndex;
    const groups = TOKEN.exec(text)?.groups;
    if (!groups) {
      plain = text.slice(at).trim() === "%";
      break;
    }
    const { comment, skip, letter, value } = groups;
    if (comment) comments.push(comment);
    else if (skip) number = "/";
    else if (letter && value) {
      const word = { letter: letter.toUpperCase(), value: Number(value), raw: `${letter}${value}` };
      if (word.letter === "N" && words.length === 0) number += word.raw;
      else words.push(word);
    }
  }
  return { line, number, words, comments, plain };
}

/** The value of the last word with this letter. */
function wordValue(block: Block, letter: string): number | undefined {
  return block.words.findLast((word) => word.letter === letter)?.value;
}

/** The modes after the G words of a block. */
export function modeAfter(mode: Mode, words: readonly Word[]): Mode {
  let { unit, incremental, absoluteCenters } = mode;
  for (const { letter, value } of words) {
    if (letter !== "G") continue;
    if (value === 20) unit = 25.4;
    else if (value === 21) unit = 1;
    else if (value === 90) incremental = false;
    else if (value === 91) incremental = true;
    else if (value === 90.1) absoluteCenters = true;
    else if (value === 91.1) absoluteCenters = false;
  }
  return { unit, incremental, absoluteCenters };
}

/** Whether a G word chooses how the tool moves. */
export function isMotion(word: Word): boolean {
  return word.letter === "G" && [0, 1, 2, 2.2, 3, 3.2, 5].includes(word.value);
}

/** All blocks of a text that move the tool in the plane, as far as the page understands them. */
export function motionBlocks(lines: readonly string[]): MotionBlock[] {
  const list: MotionBlock[] = [];
  let mode = INITIAL_MODE;
  let motion = 0;
  let at: Point = [0, 0];
  lines.forEach((text, i) => {
    const block = readBlock(text, i + 1);
    mode = modeAfter(mode, block.words);
    motion = block.words.findLast(isMotion)?.value ?? motion;
    const moves = block.words.some(({ letter }) => letter === "X" || letter === "Y");
    const turns = motion === 2 || motion === 3;
    const circles = turns && block.words.some(({ letter }) => letter === "I" || letter === "J");
    if (!moves && !circles) return;
    const coordinate = (letter: string, before: number) => {
      const value = wordValue(block, letter);
      if (value === undefined) return before;
      return value * mode.unit + (mode.incremental ? before : 0);
    };
    at = [coordinate("X", at[0]), coordinate("Y", at[1])];
    list.push({ block, motion, to: at });
  });
  return list;
}

/** Whether a motion block ends at a point. */
export function endsAt(block: MotionBlock | undefined, point: Point): block is MotionBlock {
  return block !== undefined && coincide(block.to, point);
}
