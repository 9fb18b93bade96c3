// Keys: on the canvas they walk and move the points; undo and redo work everywhere.

import { deleteSelected, move } from "./actions";
import { along, type Point } from "./geometry";
import { locate, samePoint } from "./part";
import type { Stage } from "./stage";
import type { Store } from "./state";

const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Connects the keys to the stage and the store. */
export function connectKeys(stage: Stage, store: Store): void {
  const canvas = stage.overlay;
  let nudge = 0;
  canvas.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    if (event.key === "Tab" || arrow) canvas.classList.remove("by-pointer");
    if (event.key === "Tab") {
      if (walk(stage, store, event.shiftKey ? -1 : 1)) event.preventDefault();
    } else if (arrow) {
      event.preventDefault();
      if (!event.repeat) nudge += 1;
      const step = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
      const { selection } = store.state;
      const at = selection && locate(store.document.part, selection);
      if (selection && at) {
        move(store, selection, along(at, arrow, step), `nudge ${nudge}`);
        stage.reveal(locate(store.document.part, selection) ?? at);
      } else stage.pan(-40 * arrow[0], 40 * arrow[1]);
    } else if (event.key === "Delete" || event.key === "Backspace") {
      event.preventDefault();
      deleteSelected(store);
    } else if (event.key === "Escape") {
      store.set({ selection: undefined, chosen: undefined });
    } else if (!event.ctrlKey && !event.metaKey && !event.altKey) {
      view(stage, event);
    }
  });
  window.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    if (key === "z") (event.shiftKey ? redo : undo)();
    else if (key === "y" && !event.shiftKey) redo();
    else return;
    event.preventDefault();
  });
  const undo = () => store.undo();
  const redo = () => store.redo();
}

function view(stage: Stage, event: KeyboardEvent): void {
  if (event.key === "f" || event.key === "F") stage.fit();
  else if (event.key === "+" || event.key === "=") stage.zoom(1.25);
  else if (event.key === "-") stage.zoom(1 / 1.25);
  else return;
  event.preventDefault();
}

/** Selects the next point; false behind the last, where the focus moves on. */
function walk(stage: Stage, store: Store, by: 1 | -1): boolean {
  const list = stage.handles();
  const { selection } = store.state;
  const now = list.findIndex(({ ref }) => samePoint(ref, selection));
  const next = now < 0 ? (by > 0 ? 0 : list.length - 1) : now + by;
  const handle = list[next];
  if (!handle) {
    store.set({ selection: undefined });
    return false;
  }
  store.set({ selection: handle.ref, chosen: undefined });
  stage.reveal(handle.at);
  return true;
}
