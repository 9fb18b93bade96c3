// Offers the radii of tools that the comments of the program tell, as long as others are used.

import { setSettings } from "../actions";
import { format } from "../expression";
import { namedTools } from "../named-tools";
import { radiusOfTool, type Settings } from "../parameters";
import type { Store } from "../state";
import { element } from "./elements";

/** A row that is hidden where there is nothing to offer. */
export function namedToolsOffer(store: Store): HTMLElement {
  const said = element("span");
  const use = element("button", { type: "button", class: "button" });
  const row = element("p", { class: "named-tools" }, said, use);
  let known: { text: string; named: ReadonlyMap<number, number> } | undefined;
  const offered = (): [tool: number, radius: number][] => {
    const { result } = store.state;
    const { text, settings } = store.document;
    // A program that states its radii needs no others.
    if (!result || result.contours.some(({ radius }) => radius !== undefined)) return [];
    if (known?.text !== text) known = { text, named: namedTools(text) };
    return result.tools.flatMap((tool): [number, number][] => {
      const diameter = known?.named.get(tool);
      if (diameter === undefined || settings.tools[tool]) return [];
      const isUsed = Math.abs(radiusOfTool(settings, tool, () => 1) - diameter / 2) < 5e-4;
      return isUsed ? [] : [[tool, diameter / 2]];
    });
  };
  use.addEventListener("click", () => {
    setSettings(store, taken(store.document.settings, offered(), store.state.result?.tools ?? []));
    // The button goes, and the focus must not go with it.
    row.parentElement?.querySelector<HTMLElement>(".parameter-radius input")?.focus();
  });
  const show = () => {
    const list = offered();
    row.hidden = list.length === 0;
    if (row.hidden) return;
    const names = list.map(([tool, radius]) => `T${tool} ⌀ ${format(2 * radius)}`).join(", ");
    said.textContent = `By its comments: ${names} mm`;
    const [first] = list;
    use.textContent =
      first && list.length === 1 ? `Use radius ${format(first[1])} mm` : "Use their radii";
  };
  store.subscribe((state, before) => {
    if (state.history !== before.history || state.result !== before.result) show();
  });
  show();
  return row;
}

/** The settings with what is offered: the only tool has the radius of all, several have their own. */
function taken(
  { tools }: Settings,
  offered: readonly [number, number][],
  called: readonly number[],
): Partial<Settings> {
  const [first] = offered;
  if (first && called.length === 1) return { radius: round(first[1]) };
  const own = offered.map(([tool, radius]) => [tool, { radius: round(radius) }] as const);
  return { tools: { ...tools, ...Object.fromEntries(own) } };
}

function round(radius: number): number {
  return Math.round(radius * 1e6) / 1e6;
}
