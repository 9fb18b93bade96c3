// Whose control a program seems to be written for, so that its rules can be offered.
//
// Only words that leave no doubt count, and how a text is read does not depend on them: the package
// decides that for itself. A program number after `%` is left out, since many controls take one.

import type { Profile } from "g41";

/** Words of one control stand at the beginning of a program [letters]. */
const LOOKED_AT = 50_000;

/** By line; what is looked for first decides where a line has signs of several. */
const SIGNS: readonly (readonly [Profile, RegExp])[] = [
  ["linuxcnc", /#\s*<|^(N\d+\s*)?O\s*(<|\d+\s*(SUB|CALL|IF|WHILE|DO|REPEAT)\b)/],
  [
    "sinumerik",
    /%_N_|\bMSG\s*\(|\b(CR|DISC|[XYZ])\s*=|^(N\d+\s*)?R\d+\s*=|(?<!\d)G45[01](?!\d)|\b[ABC]SPLINE\b|\bGOTO[FB]\b|\bCYCLE8|\bDEF\s+(REAL|INT)\b/,
  ],
  ["fanuc", /\bIF\s*\[|\bWHILE\s*\[|(?<!\d)G6[56]\s*P\d|\bM98\s*P\d/],
];

/** The control that the first sign in a text is of; undefined where there is none. */
export function controlOf(text: string): Profile | undefined {
  for (const line of text.slice(0, LOOKED_AT).split("\n")) {
    // What MSG shows is no comment.
    const words = line
      .replace(/;.*$|(?<!MSG\s*)\([^)]*\)/gi, "")
      .toUpperCase()
      .trim();
    const [profile] = SIGNS.find(([, sign]) => sign.test(words)) ?? [];
    if (profile) return profile;
  }
  return undefined;
}
