// The legend: what the lines and marks of the picture mean, and how many corners take each kind.

import type { Transition } from "g41";
import { grouped } from "../counts";
import { plungesOf } from "../draw/plunges";
import { followedTransitions } from "../draw/transition";
import { findingsOf } from "../findings";
import type { StrokeKind } from "../large/strokes";
import { waysInPlane } from "../large/ways";
import { FIELD, MoveRole, RAPID, type Result } from "../result";
import type { Store } from "../state";
import { element } from "./elements";

/** Lines and marks as in the picture, in a box of 34 by 14; colours come from the style sheet. */
const SWATCHES: readonly (readonly [name: string, kind: string, drawing: string])[] = [
  ["Contour", "contour", '<path d="M1 7h32" stroke-width="2.25"/>'],
  ["Tool path", "path", '<path d="M1 7h32" stroke-width="1.75"/>'],
  ["Not compensated", "free", '<path d="M1 7h32" stroke-width="1.5"/>'],
  ["Rapid", "rapid", '<path d="M1 7h32" stroke-width="1" stroke-dasharray="2 4"/>'],
  [
    "Plunge",
    "plunge",
    '<circle cx="17" cy="7" r="4.5" fill="none" stroke="currentColor" stroke-width="1.25"/><circle cx="17" cy="7" r="1.5" fill="currentColor"/>',
  ],
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

/** What there is of a program that compensates, and only there. */
const COMPENSATED = ["contour", "path", "lead"];

/** What a very long program has too many of to be told apart. */
const CORNERS = ["shortened", "elongated", "inserted"];

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
    item.hidden = WHERE_FOUND.includes(kind) || ["free", "rapid", "plunge"].includes(kind);
    item.append(element("span", {}, name), count);
    list.append(item);
  }
  const show = (kind: string, isShown: boolean) => {
    const item = items.get(kind);
    if (item) item.hidden = !isShown;
  };
  store.subscribe(({ result, space }, before) => {
    if (!result || (result === before.result && space === before.space)) return;
    for (const kind of ["shortened", "elongated", "inserted"] satisfies Transition["kind"][]) {
      const followed = followedTransitions(result);
      const count = followed.filter(({ transition }) => transition.kind === kind).length;
      const place = counts.get(kind);
      if (place) place.textContent = grouped(count);
    }
    const isCompensated = result.long !== undefined || result.contours.length > 0;
    for (const kind of COMPENSATED) show(kind, isCompensated);
    for (const kind of CORNERS) show(kind, isCompensated && !result.long);
    show("plunge", plungesOf(result).length > 0);
    for (const kind of ["free", "rapid"] as const) {
      const isWay = kind === "rapid" && waysInPlane(result).length > 0;
      const isMove = isWay || hasMoves(result, kind === "rapid");
      const isDrawn = space ? hasStrokes(result, kind) : isMove;
      show(kind, result.long !== undefined || isDrawn);
    }
    const findings = findingsOf(result);
    for (const kind of WHERE_FOUND) {
      const count = findings.filter((finding) => finding.kind === kind).length;
      const place = counts.get(kind);
      if (place) place.textContent = grouped(count);
      show(kind, count > 0);
    }
  });
}

/** Whether moves of a kind are drawn in space, where those along the axis of the tool show too. */
function hasStrokes({ space }: Result, wanted: StrokeKind): boolean {
  return space.strokes.some(({ kind, lines }) => kind === wanted && lines.length > 0);
}

/** Whether a path has moves in the plane that are not compensated: rapid ones, or those that cut. */
function hasMoves({ records, stride, axes }: Result, rapid: boolean): boolean {
  // The first comes from where the tool stood before, which nobody knows.
  for (let at = stride; at < records.length; at += stride) {
    if (records[at + FIELD.role] !== MoveRole.Free) continue;
    if ((records[at + FIELD.kind] === RAPID) !== rapid) continue;
    for (const axis of axes) {
      if (records[at + FIELD.from + axis] !== records[at + FIELD.to + axis]) return true;
    }
  }
  return false;
}
