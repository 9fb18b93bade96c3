// The menu of examples; it shows which of them the program is, if it still is one.

import { EXAMPLES, type Example } from "../examples";
import type { Store } from "../state";
import { element } from "./elements";

/** Fills the menu and keeps it true to the state. */
export function galleryMenu(
  menu: HTMLSelectElement,
  onChoose: (example: Example) => void,
  store: Store,
): void {
  menu.append(element("option", { value: "", hidden: true }, "Own program"));
  for (const { id, name, note } of EXAMPLES) {
    menu.append(element("option", { value: id, title: note }, name));
  }
  menu.addEventListener("change", () => {
    const example = EXAMPLES.find(({ id }) => id === menu.value);
    if (example) onChoose(example);
  });
  const show = () => {
    menu.value = EXAMPLES.find(({ text }) => text === store.document.text)?.id ?? "";
  };
  store.subscribe((state, before) => {
    if (state.history.present.text !== before.history.present.text) show();
  });
  show();
}
