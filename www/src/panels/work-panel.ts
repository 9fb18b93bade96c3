// How far long work is, over the picture, with a button that stops it.

import type { Files } from "../files";
import type { Store } from "../state";
import { element } from "./elements";

/** Fills the panel of long work and keeps it true to the state. */
export function workPanel(panel: HTMLElement, files: Files, store: Store): void {
  const name = element("strong");
  const step = element("span", { "aria-live": "polite" });
  const bar = element("progress", { max: 1, value: 0, "aria-label": "Progress" });
  const cancel = element("button", { type: "button", class: "button" }, "Cancel");
  cancel.addEventListener("click", () => files.cancel());
  panel.append(name, step, bar, cancel);
  store.subscribe((state, before) => {
    const { work } = state;
    if (work === before.work) return;
    panel.hidden = !work;
    if (!work) return;
    name.textContent = work.name;
    if (step.textContent !== `${work.step} …`) step.textContent = `${work.step} …`;
    bar.value = work.part;
  });
}
