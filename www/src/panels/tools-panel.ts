// The tools that the program calls by number: each may have a radius of its own.

import type { ToolSize } from "g41";
import { setSettings } from "../actions";
import { evaluate, format } from "../expression";
import type { Settings } from "../parameters";
import type { Store } from "../state";
import { element } from "./elements";

/** More tools than these are given by a table. */
const MOST = 24;

/** Fills the list of tools and keeps it true to the state. */
export function toolsPanel(section: HTMLElement, store: Store): void {
  const title = element("span", { class: "tools-title" }, "Tools");
  const list = element("div", { class: "tools-list" });
  section.append(title, list);
  let shown = "";
  const show = () => {
    const { settings } = store.document;
    const numbers = numbersOf(store);
    section.hidden = numbers.length === 0;
    // Fields are kept while they say the same, and with them the focus.
    const key = JSON.stringify([numbers, settings.tools, settings.radius]);
    if (key === shown) return;
    shown = key;
    const focused = section.contains(document.activeElement)
      ? (document.activeElement as HTMLElement).dataset.tool
      : undefined;
    list.replaceChildren(...numbers.slice(0, MOST).map((number) => field(number, settings, store)));
    if (focused) list.querySelector<HTMLElement>(`[data-tool="${focused}"]`)?.focus();
  };
  store.subscribe((state, before) => {
    if (state.history !== before.history || state.result !== before.result) show();
  });
  show();
}

/** The tools that the program calls, where that is more than one, and those that have a size. */
function numbersOf(store: Store): number[] {
  const called = store.state.result?.tools ?? [];
  const listed = Object.keys(store.document.settings.tools).map(Number);
  const own = called.filter((number) => listed.includes(number));
  return called.length > 1 || own.length > 0 ? called.toSorted((a, b) => a - b) : [];
}

function field(number: number, settings: Settings, store: Store): HTMLElement {
  const size = settings.tools[number];
  const isDiameter = size !== undefined && "diameter" in size;
  let shown = size === undefined ? "" : format("radius" in size ? size.radius : size.diameter);
  const input = element("input", {
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    spellcheck: "false",
    "data-tool": number,
    value: shown,
    placeholder: format(settings.radius),
    "aria-label": isDiameter
      ? `Diameter of tool ${number} in the unit of the program`
      : `Radius of tool ${number} in mm`,
  });
  const enter = () => {
    const text = input.value.trim();
    const value = evaluate(text);
    const isWrong = text !== "" && value === undefined;
    input.setAttribute("aria-invalid", String(isWrong));
    if (isWrong) return;
    // Enter and leaving the field both say so.
    if (text === shown) return;
    shown = text;
    const tools: Record<number, ToolSize> = { ...store.document.settings.tools };
    delete tools[number];
    if (value !== undefined) tools[number] = sized(size, value);
    setSettings(store, { tools });
  };
  input.addEventListener("change", enter);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") enter();
  });
  return element(
    "label",
    { class: "tool", title: "Empty: the tool radius above" },
    element("span", {}, `T${number}`),
    input,
    element("small", { "aria-hidden": "true" }, isDiameter ? "⌀" : "r"),
  );
}

/** A size of the same sort. */
function sized(before: ToolSize | undefined, value: number): ToolSize {
  if (!before || "radius" in before) return { ...before, radius: value };
  return { ...before, diameter: value };
}
