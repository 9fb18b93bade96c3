// The words beside a gouge or an uncut region that is looked at in the picture or in the list.

import { findingsOf } from "../findings";
import type { Stage } from "../stage";
import type { State, Store } from "../state";
import { toScreen } from "../view";
import { element } from "./elements";

/** Distance from the place that it is about [px]. */
const GAP = 18;

/** Makes the callout of a stage and keeps it true to the state. */
export function callout(parent: HTMLElement, stage: Stage, store: Store): void {
  const title = element("strong");
  const reason = element("span");
  const root = element("div", { class: "callout", hidden: true }, title, reason);
  // What it says stands in the list of diagnostics too, where it can be read and reached by keys.
  root.setAttribute("aria-hidden", "true");
  parent.append(root);

  const show = () => {
    const found = current(store.state);
    root.hidden = !found;
    if (!found) return;
    root.dataset.kind = found.kind;
    title.textContent = found.title;
    reason.textContent = found.reason;
    const [x, y] = toScreen(stage.view, found.at);
    const { width, height } = stage.size;
    const left = Math.min(Math.max(8, x + GAP), width - root.offsetWidth - 8);
    const above = y - GAP - root.offsetHeight;
    const top = above < 8 ? y + GAP : above;
    root.style.left = `${Math.max(8, left)}px`;
    root.style.top = `${Math.min(Math.max(8, top), height - root.offsetHeight - 8)}px`;
  };
  store.subscribe((state, before) => {
    if (state.finding !== before.finding || state.result !== before.result) show();
  });
  stage.onViewChange(show);
}

/** The finding that is looked at. */
function current({ finding, result }: State) {
  if (finding === undefined || !result) return undefined;
  return findingsOf(result).find(({ key }) => key === finding);
}
