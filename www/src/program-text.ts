// Program text and part: reads the part from a text, and writes its contours back into it.

import type { ProgrammedContour } from "g41";
import { isMotion, motionBlocks } from "./blocks";
import { readContour, wordsOf } from "./contour-reader";
import { ContourWriter, coordinates, join, modeAt } from "./contour-writer";
import { coincide, type Point } from "./geometry";
import type { Contour, Node, Part } from "./part";

/** The part that a text programs, from the contours that the package found in it. */
export function partOf(text: string, contours: readonly ProgrammedContour[]): Part {
  const lines = text.split("\n");
  const motions = motionBlocks(lines);
  return { contours: contours.map((contour) => readContour(contour, lines, motions)) };
}

/** A text and the part it programs. */
export interface Written {
  readonly text: string;
  readonly part: Part;
}

/** Rewrites the blocks of one contour in the text; all other lines stay as they are. */
export function rewrite(text: string, part: Part, index: number): Written {
  const contour = part.contours[index];
  if (!contour?.editable) return { text, part };
  const lines = text.split("\n");
  moveLeadIn(lines, contour);
  const [first, last] = contour.extent;
  const writer = new ContourWriter(lines.slice(0, first - 1), contour);
  const written = writer.contour();
  const shift = writer.lines.length - last;
  const rest = lines.slice(last);
  const contours = part.contours.map((other, i) => {
    if (i === index) return written;
    return other.extent[0] > last ? shifted(other, shift) : other;
  });
  return { text: [...writer.lines, ...rest].join("\n"), part: { contours } };
}

/** Changes the side of all contours. */
export function withSide(text: string, part: Part, side: "left" | "right"): Written {
  const word = side === "left" ? "G41" : "G42";
  const change = (line: string) =>
    line.replace(/(\([^)]*\))|(?<![A-Z])G4[12](?!\d)/gi, (found, comment) =>
      comment ? found : word,
    );
  const inside = (line: number) =>
    part.contours.some(({ blocks }) => line >= blocks[0] && line <= blocks[1]);
  const lines = text.split("\n").map((line, i) => (inside(i + 1) ? change(line) : line));
  const contours = part.contours.map((contour): Contour => {
    const { words } = contour.start;
    const start = words && {
      ...contour.start,
      words: { ...words, modal: change(words.modal), before: words.before.map(change) },
    };
    return { ...contour, side, start: start ?? contour.start };
  });
  return { text: lines.join("\n"), part: { contours } };
}

function shifted(contour: Contour, by: number): Contour {
  const move = (node: Node): Node => (node.line > 0 ? { ...node, line: node.line + by } : node);
  return {
    ...contour,
    blocks: [contour.blocks[0] + by, contour.blocks[1] + by],
    extent: [contour.extent[0] + by, contour.extent[1] + by],
    start: move(contour.start),
    leadIn: contour.leadIn && move(contour.leadIn),
    leadOut: contour.leadOut && move(contour.leadOut),
    segments: contour.segments.map((segment) =>
      segment.kind === "spline"
        ? { ...segment, points: segment.points.map(move) }
        : { ...segment, end: move(segment.end) },
    ),
  };
}

/** Rewrites the block before a contour, where its lead-in comes from. */
function moveLeadIn(lines: string[], { leadIn }: Contour): void {
  if (!leadIn || leadIn.line === 0) return;
  const before = motionBlocks(lines.slice(0, leadIn.line));
  const own = before.at(-1);
  if (own?.block.line !== leadIn.line || coincide(own.to, leadIn.at)) return;
  const mode = modeAt(lines, leadIn.line);
  const from: Point = before.at(-2)?.to ?? [0, 0];
  const words = wordsOf(own.block, []);
  const motion = own.block.words.filter(isMotion).map((word) => word.raw);
  const place = coordinates(from, leadIn.at, mode);
  lines[leadIn.line - 1] = join([words.number, words.modal, ...motion, place, words.tail]);
}
