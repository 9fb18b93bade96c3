// What can be done to the document: each action is one step of the history.

import { canDelete, deletePoint, insertPoint, movePoint, setKind } from "./edits";
import type { Example } from "./examples";
import { type Point, roundTo } from "./geometry";
import { INITIAL_SETTINGS, type Settings } from "./parameters";
import { locate, type Part, type PointRef, type SegmentKind } from "./part";
import { rewrite, withSide } from "./program-text";
import { type Document, NO_PART, type Store } from "./state";

/** The finest step of a coordinate [mm]: what a program can write. */
const FINEST = 0.001;

/** Opens an example; it can be undone like any edit. */
export function openExample(store: Store, { id, text, settings }: Example): void {
  const { target } = store.document.settings;
  const own = { ...INITIAL_SETTINGS, target, ...settings };
  const file = undefined;
  openText(store, { name: `${id}.nc`, text, file, part: NO_PART, partText: "", settings: own });
}

/** Shows another document; it can be undone like any edit. */
export function openText(store: Store, document: Document): void {
  store.edit(document, undefined, undefined);
  const none = { corner: undefined, selection: undefined, caret: undefined, hover: undefined };
  store.set({ ...none, chosen: undefined, pointed: undefined, notice: undefined });
}

/** Where a point is put that is moved to a place: at a multiple of a step [mm]. */
export function rounded(to: Point, step = FINEST): Point {
  return [roundTo(to[0], step), roundTo(to[1], step)];
}

/** Moves a point; the steps of one gesture are undone together. */
export function move(store: Store, ref: PointRef, to: Point, gesture: string, step = FINEST): void {
  const at = rounded(to, step);
  const now = locate(store.document.part, ref);
  if (!now || (now[0] === at[0] && now[1] === at[1])) return;
  apply(store, movePoint(store.document.part, ref, at), ref.contour, gesture, ref);
}

/** Inserts a point on a segment and selects it. */
export function insert(
  store: Store,
  contour: number,
  segment: number,
  at: Point,
  before: number,
): void {
  const rounded: Point = [roundTo(at[0], FINEST), roundTo(at[1], FINEST)];
  const { part, ref } = insertPoint(store.document.part, contour, segment, rounded, before);
  apply(store, part, contour, undefined, ref);
}

/** Deletes the selected point. */
export function deleteSelected(store: Store): void {
  const { selection } = store.state;
  if (!selection || !canDelete(store.document.part, selection)) return;
  const part = deletePoint(store.document.part, selection);
  apply(store, part, selection.contour, undefined, neighbour(part, selection));
}

/** Changes the segment of the selected point into another kind. */
export function changeKind(store: Store, ref: PointRef, kind: SegmentKind): void {
  const before = store.document.part;
  const part = setKind(before, ref, kind);
  const own = (of: Part) => of.contours[ref.contour]?.segments[ref.segment];
  if (own(part) === own(before)) {
    // Not possible: the controls show again what is.
    store.set({ selection: { ...ref } });
    return;
  }
  const role = kind === "spline" ? "type" : kind === "arc" ? "middle" : "end";
  const wanted: PointRef = { ...ref, role, index: 0 };
  const kept = locate(part, wanted) ? wanted : { ...wanted, role: "start" as const, segment: -1 };
  apply(store, part, ref.contour, undefined, kept);
}

/** Changes the text; `gesture` joins what is typed in one go. */
export function setText(store: Store, text: string, gesture?: string): void {
  if (text !== store.document.text) store.edit({ text }, gesture);
}

/** Changes the side of all contours, which is a word of the program. */
export function setSide(store: Store, side: "left" | "right"): void {
  const { text, part, partText } = store.document;
  if (text !== partText) return;
  const written = withSide(text, part, side);
  store.edit({ ...written, partText: written.text });
}

/** Changes settings; `gesture` joins the steps of one slide. */
export function setSettings(store: Store, change: Partial<Settings>, gesture?: string): void {
  const { settings } = store.document;
  const names = Object.keys(change) as (keyof Settings)[];
  // A step of undo that changes nothing looks like a key that does not work.
  if (names.every((name) => settings[name] === change[name])) return;
  store.edit({ settings: { ...settings, ...change } }, gesture);
}

function apply(
  store: Store,
  part: Part,
  contour: number,
  gesture: string | undefined,
  selection: PointRef | undefined,
): void {
  if (store.document.partText !== store.document.text) return;
  const written = rewrite(store.document.text, part, contour);
  store.edit({ ...written, partText: written.text }, gesture, selection);
}

/** The point that takes the place of a deleted one. */
function neighbour(part: Part, ref: PointRef): PointRef | undefined {
  const candidates: PointRef[] = [
    ref,
    { ...ref, index: ref.index - 1 },
    { ...ref, role: "end", index: 0 },
    { ...ref, role: "end", segment: ref.segment - 1, index: 0 },
  ];
  return candidates.find((candidate) => locate(part, candidate));
}
