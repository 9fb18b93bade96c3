// Keeps the document over a reload, in the storage of the browser.

import type { ToolSize } from "g41";
import { DIALECTS, isName, PROFILES, TARGETS } from "./controls";
import { INITIAL_SETTINGS, type Settings } from "./parameters";
import type { Store } from "./state";

const KEY = "g41.document";
/** Changes that follow each other faster are saved once [ms]. */
const PAUSE = 400;
/** Longer programs are not saved: storage is small. */
const MOST_LETTERS = 500_000;

/** What is kept. */
export interface Saved {
  readonly name: string;
  readonly text: string;
  readonly settings: Settings;
}

/** The document as it was left; undefined where none was saved. */
export function restore(): Saved | undefined {
  try {
    return validDocument(JSON.parse(localStorage.getItem(KEY) ?? "null"));
  } catch {
    return undefined;
  }
}

/** A document that was kept or passed on, with settings that the page knows; undefined for none. */
export function validDocument(saved: unknown): Saved | undefined {
  if (!saved || typeof saved !== "object") return undefined;
  const { name, text, settings } = saved as Partial<Saved>;
  if (typeof text !== "string" || !settings || typeof settings !== "object") return undefined;
  return { name: typeof name === "string" ? name : "", text, settings: valid(settings) };
}

/** Saves the document after each change. */
export function autosave(store: Store): void {
  let timer = 0;
  const save = () => {
    clearTimeout(timer);
    timer = 0;
    const { name, text, file, settings } = store.document;
    try {
      if (!file && text.length <= MOST_LETTERS)
        localStorage.setItem(KEY, JSON.stringify({ name, text, settings }));
    } catch {
      // Where storage is full or forbidden, the document lasts as long as the page.
    }
  };
  store.subscribe((state, before) => {
    if (state.history.present === before.history.present) return;
    clearTimeout(timer);
    timer = window.setTimeout(save, PAUSE);
  });
  // Who leaves at once has not seen the pause end.
  window.addEventListener("pagehide", () => {
    if (timer !== 0) save();
  });
}

/** Settings whose every value is one that the controls could have given. */
function valid(saved: Partial<Settings>): Settings {
  const { profile, dialect, target, tools } = saved;
  const { radius, corner, spline, tolerance, gouge, passes, stepover } = saved;
  const number = (value: unknown, otherwise: number) =>
    typeof value === "number" && Number.isFinite(value) && value >= 0 ? value : otherwise;
  return {
    profile: isName(PROFILES, profile) ? profile : INITIAL_SETTINGS.profile,
    dialect: isName(DIALECTS, dialect) ? dialect : INITIAL_SETTINGS.dialect,
    target: isName(TARGETS, target) ? target : INITIAL_SETTINGS.target,
    tools: validTools(tools),
    radius: number(radius, INITIAL_SETTINGS.radius),
    tolerance: Math.max(0.0001, number(tolerance, INITIAL_SETTINGS.tolerance)),
    corner: corner === "arc" || corner === "linear" ? corner : "profile",
    spline: spline === "type-points" ? "type-points" : "exact",
    gouge: gouge === "avoid" || gouge === "stop" ? gouge : "report",
    passes: passes === "all" ? "all" : "one",
    stepover: Math.max(0.01, number(stepover, INITIAL_SETTINGS.stepover)),
  };
}

/** The tools that a saved list names rightly. */
function validTools(saved: unknown): Record<number, ToolSize> {
  const tools: Record<number, ToolSize> = {};
  if (!saved || typeof saved !== "object") return tools;
  for (const [number, size] of Object.entries(saved)) {
    const { radius, diameter, orientation } = (size ?? {}) as Partial<Record<string, unknown>>;
    const isSize = (value: unknown): value is number =>
      typeof value === "number" && Math.abs(value) <= 1e6;
    const way = Number.isInteger(orientation) ? { orientation: Number(orientation) } : {};
    if (!/^\d{1,9}$/.test(number) || (way.orientation ?? 0) < 0 || (way.orientation ?? 0) > 9) {
      continue;
    }
    if (isSize(radius)) tools[Number(number)] = { radius, ...way };
    else if (isSize(diameter)) tools[Number(number)] = { diameter, ...way };
  }
  return tools;
}
