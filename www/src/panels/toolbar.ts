// The bar above the picture: the selected point, and buttons for history and view.

import { changeKind, deleteSelected, move } from "../actions";
import { canDelete } from "../edits";
import { describePoint, locate, type SegmentKind, segmentOf } from "../part";
import type { Stage } from "../stage";
import type { State, Store } from "../state";
import { Choice, element, iconButton } from "./elements";
import { NumberField } from "./number-field";

const ICONS = {
  undo: "M9 14 4 9l5-5M4 9h10a6 6 0 0 1 0 12h-3",
  redo: "m15 14 5-5-5-5M20 9H10a6 6 0 0 0 0 12h3",
  fit: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  zoomIn: "M12 5v14M5 12h14",
  zoomOut: "M5 12h14",
  remove: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13",
} as const;

/** What of the picture that is shown the buttons change. */
export interface Picture {
  zoom(factor: number): void;
  fit(): void;
}

/** Fills the toolbar and keeps it true to the state. */
export function toolbar(bar: HTMLElement, stage: Stage, store: Store, picture: Picture): void {
  const name = element("p", { class: "point-name" });
  let steps = 0;
  const enter = (axis: 0 | 1) => (value: number, gesture?: string) => {
    const { selection } = store.state;
    const at = selection && locate(store.document.part, selection);
    if (!selection || !at) return;
    if (!gesture) steps += 1;
    const to = axis === 0 ? ([value, at[1]] as const) : ([at[0], value] as const);
    move(store, selection, to, `${gesture ?? "enter"} ${steps}`);
    stage.reveal(to);
  };
  const x = new NumberField({ label: "X", step: 1, onValue: enter(0) });
  const y = new NumberField({ label: "Y", step: 1, onValue: enter(1) });
  const kind = new Choice(
    "kind",
    "Kind of segment",
    { line: "Line", arc: "Arc", spline: "Spline" },
    (value) => {
      const { selection } = store.state;
      if (selection) {
        changeKind(store, { ...selection, segment: segmentOf(selection) }, value as SegmentKind);
      }
    },
  );
  const remove = iconButton("Delete point", ICONS.remove, "Del");
  remove.addEventListener("click", () => deleteSelected(store));
  const point = element("div", { class: "point", role: "group", "aria-label": "Selected point" });
  point.append(name, x.root, y.root, kind.root, remove);
  const hint = element("p", { class: "hint" });

  const undo = iconButton("Undo", ICONS.undo, "Ctrl+Z");
  const redo = iconButton("Redo", ICONS.redo, "Ctrl+Y");
  const out = iconButton("Zoom out", ICONS.zoomOut, "−");
  const fit = iconButton("Fit", ICONS.fit, "F");
  const closer = iconButton("Zoom in", ICONS.zoomIn, "+");
  undo.addEventListener("click", () => store.undo());
  redo.addEventListener("click", () => store.redo());
  out.addEventListener("click", () => picture.zoom(1 / 1.4));
  fit.addEventListener("click", () => picture.fit());
  closer.addEventListener("click", () => picture.zoom(1.4));
  const view = element("div", {
    class: "view-buttons",
    role: "group",
    "aria-label": "History and view",
  });
  const divider = () => element("span", { class: "divider" });
  const drawers = element("span", { class: "drawer-buttons" });
  view.append(drawers, divider(), undo, redo, divider(), out, fit, closer);
  bar.append(element("div", { class: "strip" }, hint, point), view);

  const show = () => {
    const { selection, history } = store.state;
    const { part } = store.document;
    const at = selection && locate(part, selection);
    hint.textContent = hintOf(store.state);
    hint.hidden = Boolean(at);
    point.hidden = !at;
    undo.disabled = history.past.length === 0;
    redo.disabled = history.future.length === 0;
    if (!selection || !at) return;
    const segment = part.contours[selection.contour]?.segments[segmentOf(selection)];
    name.textContent = describePoint(part, selection);
    x.show(at[0]);
    y.show(at[1]);
    kind.root.disabled = segment === undefined;
    kind.show(segment?.kind);
    remove.disabled = !canDelete(part, selection);
  };
  store.subscribe((state, before) => {
    const { history, selection, result, space } = before;
    const isKnown = state.history === history && state.result === result;
    if (!isKnown || state.selection !== selection || state.space !== space) show();
  });
  show();
}

/** What can be done with the picture as it is. */
function hintOf({ history, result, space }: State): string {
  const { file, part, text, partText } = history.present;
  const isTouch = matchMedia("(pointer: coarse)").matches;
  if (space) {
    return isTouch
      ? "Drag to turn, with two fingers to move and zoom."
      : "Drag to turn, with Shift to move. Click a move to find its line.";
  }
  if (file) return "Click a move to find its line, or a line to find its moves.";
  // Until the text has been read, nobody knows better than that something can be done.
  if (result && text === partText && !part.contours.some(({ editable }) => editable)) {
    return part.contours.length === 0
      ? "Nothing here is compensated: there is no G41 or G42."
      : "No point can be dragged here: change the text instead.";
  }
  const twice = isTouch ? "Double-tap" : "Double-click";
  return `Drag any point. ${twice} a segment to add one.`;
}
