// A line of a program in colours.

import { element } from "./elements";

const TOKENS =
  /(?<comment>\([^)]*\)?|;.*)|(?<number>\bN\d+)|(?<motion>\b[GM]\d+(?:\.\d+)?)|(?<axis>[XYZIJR](?=\s*[-+.\d]))/gi;

/** A line as text and coloured spans. */
export function coloured(line: string): (Node | string)[] {
  const nodes: (Node | string)[] = [];
  let at = 0;
  for (const match of line.matchAll(TOKENS)) {
    if (match.index > at) nodes.push(line.slice(at, match.index));
    const name = Object.entries(match.groups ?? {}).find(([, text]) => text)?.[0];
    nodes.push(element("span", { class: `t-${name}` }, match[0]));
    at = match.index + match[0].length;
  }
  nodes.push(line.slice(at) || (at === 0 ? "\u200b" : ""));
  return nodes;
}
