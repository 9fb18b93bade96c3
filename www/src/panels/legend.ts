// The legend: what the lines and marks of the picture mean, and how many corners take each kind.

import type { Transition } from "g41";
import { isFollowed } from "../draw/transition";
import { findingsOf } from "../findings";
import type { Store } from "../state";
import { element } from "./elements";

/** Lines and marks as in the picture, in a box of 34 by 14; colours come from the style sheet. */
const SWATCHES: readonly (readonly [name: string, kind: string, drawing: string])[] = [
  ["Contour", "contour", '<path d="M1 7h32" stroke-width="2.25"/>'],
  ["Tool path", "path", '<path d="M1 7h32" stroke-width="1.75"/>'],
  ["Lead-in, lead-out", "lead", '<path d="M1 7h32" stroke-width="1.5" stroke-dasharray="6 4"/>'],
  [
    "Shortened",
    "shortened",
    '<path d="M1 7h32" stroke-width="1.25" stroke-dasharray="2 3"/><rect x="13" y="3" width="8" height="8"/>',
  ],
  [
    "Elongated",
    "elongated",
    '<path d="M1 7h32" stroke-width="4" stroke-dasharray="9 4"/><path class="solid" d="m17 1.5 5.5 5.5-5.5 5.5L11.5 7z"/>',
  ],
  [
    "Inserted",
    "inserted",
    '<path d="M1 7h32" stroke-width="4" stroke-dasharray="3 3"/><path class="solid" d="m17 2 5.5 9.5h-11z"/>',
  ],
  ["Gouge", "gouge", '<path class="tint" d="M1 1h32v12H1z"/><path d="M1 1h32" stroke-width="2"/>'],
  [
    "Uncut",
    "uncut",
    '<path d="M1 1h32v12H1zM1 9l8-8M5 13 17 1M13 13 25 1M21 13 33 1M29 13l4-4" stroke-width="1"/>',
  ],
];

/** What is shown only where there is some. */
const WHERE_FOUND = ["gouge", "uncut"];

/** Fills the legend and counts the transitions in it. */
export function legend(list: HTMLElement, store: Store): void {
  const counts = new Map<string, HTMLElement>();
  const items = new Map<string, HTMLElement>();
  for (const [name, kind, drawing] of SWATCHES) {
    const item = element("li", { class: `swatch swatch-${kind}` });
    item.innerHTML = `<svg viewBox="0 0 34 14" width="34" height="14" aria-hidden="true">${drawing}</svg>`;
    const count = element("small");
    counts.set(kind, count);
    items.set(kind, item);
    item.hidden = WHERE_FOUND.includes(kind);
    item.append(element("span", {}, name), count);
    list.append(item);
  }
  store.subscribe(({ result }, before) => {
    if (!result || result === before.result) return;
    for (const kind of ["shortened", "elongated", "inserted"] satisfies Transition["kind"][]) {
      const followed = result.transitions.filter((transition) => isFollowed(transition, result));
      const count = followed.filter((transition) => transition.kind === kind).length;
      const place = counts.get(kind);
      if (place) place.textContent = String(count);
    }
    const findings = findingsOf(result);
    for (const kind of WHERE_FOUND) {
      const count = findings.filter((finding) => finding.kind === kind).length;
      const [place, item] = [counts.get(kind), items.get(kind)];
      if (place) place.textContent = String(count);
      if (item) item.hidden = count === 0;
    }
  });
}
