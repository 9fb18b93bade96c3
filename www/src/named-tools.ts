// Diameters of tools as the comments of a program tell them, in the ways of common postprocessors.

import { modeAt } from "./contour-writer";

const NUMBER = "(\\d+\\.?\\d*|\\.\\d+)";
/** A tool by its number: T1, T01, TOOL 1. */
const TOOL = /\bT(?:OOL)?\s*#?\s*0*(\d{1,4})\b/i;
/** D=6., D6, DIA 6, DIAMETER: 6; in the unit of the program unless one follows. */
const NAMED = new RegExp(
  `\\b(?:D|DIA|DIAMETER)\\.?\\s*[=:]?\\s*${NUMBER}\\s*(mm\\b|in\\b|inch|")?`,
  "i",
);
/** 6mm, 6 MM */
const MILLIMETRES = new RegExp(`(?:^|[^\\d.])${NUMBER}\\s*mm\\b`, "i");
/** 1/2", 0.5", 0.5 inch */
const INCHES = new RegExp(`(?:^|[^\\d./])${NUMBER}(?:/${NUMBER})?\\s*(?:"|in\\b|inch)`, "i");
const INCH = 25.4;

/** The diameters that comments tell [mm], by the numbers of tools; none of which two are told. */
export function namedTools(text: string): ReadonlyMap<number, number> {
  const found = new Map<number, number>();
  const doubtful = new Set<number>();
  const lines = text.split("\n");
  lines.forEach((line, index) => {
    if (!/[(;]/.test(line)) return;
    for (const [comment] of line.matchAll(/\([^)]*\)?|;.*/g)) {
      const tool = Number(TOOL.exec(comment)?.[1] ?? Number.NaN);
      if (Number.isNaN(tool)) continue;
      const diameter = diameterOf(comment, () => unitOf(lines, index));
      if (!diameter) continue;
      const before = found.get(tool);
      if (before !== undefined && Math.abs(before - diameter) > 1e-3) doubtful.add(tool);
      found.set(tool, diameter);
    }
  });
  for (const tool of doubtful) found.delete(tool);
  return found;
}

/** The unit of a program at a comment [mm], which often stands before the word that chooses it. */
function unitOf(lines: readonly string[], index: number): number {
  const first = lines.findIndex((line) =>
    /G0*(?:20|21|70|71)(?!\d)/i.test(line.replace(/\(.*?\)/g, "")),
  );
  return modeAt(lines, Math.max(index, first) + 1).unit;
}

function diameterOf(comment: string, unit: () => number): number | undefined {
  const named = NAMED.exec(comment);
  if (named) {
    const own = named[2]?.toLowerCase();
    return Number(named[1]) * (own === undefined ? unit() : own === "mm" ? 1 : INCH);
  }
  const metric = MILLIMETRES.exec(comment);
  if (metric) return Number(metric[1]);
  const inches = INCHES.exec(comment);
  return inches ? (Number(inches[1]) / Number(inches[2] ?? 1)) * INCH : undefined;
}
