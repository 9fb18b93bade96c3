// Keeps the document over a reload, in the storage of the browser.

import { INITIAL_SETTINGS, type Settings } from "./parameters";
import type { Store } from "./state";

const KEY = "g41.document";
/** Changes that follow each other faster are saved once [ms]. */
const PAUSE = 400;
/** Longer programs are not saved: storage is small. */
const MOST_LETTERS = 500_000;

/** What is kept. */
export interface Saved {
  readonly text: string;
  readonly settings: Settings;
}

/** The document as it was left; undefined where none was saved. */
export function restore(): Saved | undefined {
  try {
    const saved: unknown = JSON.parse(localStorage.getItem(KEY) ?? "null");
    if (!saved || typeof saved !== "object") return undefined;
    const { text, settings } = saved as Partial<Saved>;
    if (typeof text !== "string" || !settings || typeof settings !== "object") return undefined;
    return { text, settings: valid(settings) };
  } catch {
    return undefined;
  }
}

/** Saves the document after each change. */
export function autosave(store: Store): void {
  let timer = 0;
  store.subscribe((state, before) => {
    if (state.history.present === before.history.present) return;
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      const { text, settings } = store.document;
      try {
        if (text.length <= MOST_LETTERS)
          localStorage.setItem(KEY, JSON.stringify({ text, settings }));
      } catch {
        // Where storage is full or forbidden, the document lasts as long as the page.
      }
    }, PAUSE);
  });
}

/** Settings whose every value is one that the controls could have given. */
function valid(saved: Partial<Settings>): Settings {
  const { radius, corner, spline, tolerance, gouge, passes, stepover } = saved;
  const number = (value: unknown, otherwise: number) =>
    typeof value === "number" && Number.isFinite(value) && value >= 0 ? value : otherwise;
  return {
    radius: number(radius, INITIAL_SETTINGS.radius),
    tolerance: Math.max(0.0001, number(tolerance, INITIAL_SETTINGS.tolerance)),
    corner: corner === "arc" ? "arc" : "linear",
    spline: spline === "type-points" ? "type-points" : "exact",
    gouge: gouge === "avoid" || gouge === "stop" ? gouge : "report",
    passes: passes === "all" ? "all" : "one",
    stepover: Math.max(0.01, number(stepover, INITIAL_SETTINGS.stepover)),
  };
}
