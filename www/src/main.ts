// The page: state → worker → result → picture, and controls that change the state.

import "./style/tokens.css";
import "./style/base.css";
import "./style/controls.css";
import "./style/layout.css";
import "./style/panels.css";
import "./style/findings.css";
import "./style/deviation.css";
import "./style/files.css";
import "./style/motion.css";
import "./style/narrow.css";
import "./style/space.css";
import "./style/low.css";
import { openExample } from "./actions";
import { autosave, restore } from "./autosave";
import { ComputeClient } from "./compute-client";
import { EXAMPLES } from "./examples";
import { connectDrops, Files } from "./files";
import { showpiece } from "./hit";
import { connectKeys } from "./keyboard";
import { PictureClient } from "./large/picture-client";
import type { Strokes } from "./large/strokes";
import { Drag } from "./live/drag";
import { LiveClient } from "./live/live-client";
import { callout } from "./panels/callout";
import { codePanel } from "./panels/code-panel";
import { description } from "./panels/description";
import { deviationPanel } from "./panels/deviation-panel";
import { diagnosticsPanel } from "./panels/diagnostics-panel";
import { find } from "./panels/elements";
import { filePanel } from "./panels/file-panel";
import { galleryMenu } from "./panels/gallery-menu";
import { legend } from "./panels/legend";
import { motionButton } from "./panels/motion-button";
import { parametersPanel } from "./panels/parameters-panel";
import { readout } from "./panels/readout";
import { toolbar } from "./panels/toolbar";
import { toolsPanel } from "./panels/tools-panel";
import { workPanel } from "./panels/work-panel";
import { INITIAL_SETTINGS } from "./parameters";
import { locate } from "./part";
import { connectPointers } from "./pointer";
import { partOf } from "./program-text";
import { isResultOf, type Result } from "./result";
import { connectScheme } from "./scheme";
import { connectLinks } from "./share";
import { SpaceView } from "./space/space-view";
import { Stage } from "./stage";
import { NO_PART, Store } from "./state";

const first = EXAMPLES[0];
if (!first) throw new Error("the gallery is empty");

const saved = restore();
const store = new Store({
  name: saved?.name ?? `${first.id}.nc`,
  text: saved?.text ?? first.text,
  file: undefined,
  part: NO_PART,
  partText: "",
  settings: saved?.settings ?? { ...INITIAL_SETTINGS, ...first.settings },
});

const drawing = new PictureClient({
  drawn: (first) => {
    if (first) store.set({ work: undefined });
    stage.refresh();
  },
  found: (line) => {
    if (store.state.result?.long && line !== store.state.hover) store.set({ hover: line });
  },
  traced: (line) => stage.showTraced(line),
  failed: (message) => {
    store.set({ work: undefined, notice: `The program could not be drawn: ${message}.` });
  },
});
const stage = new Stage(find("stage"), store, drawing, readout(find("readout"), store));

/** Takes what the worker found, and derives what the page needs of it. */
function take(result: Result, strokes: readonly Strokes[]): void {
  files.take(result);
  // A very long program is shown as a whole or not at all.
  if (result.long?.file !== store.document.file) return;
  if (result.long) {
    // Its work ends with the first picture of it.
    drawing.load(strokes);
    store.set({ result, failure: undefined, corner: undefined, live: undefined, hover: undefined });
    return;
  }
  if (store.state.work) store.set({ work: undefined });
  drawing.clear();
  if (store.document.text === result.text && store.document.partText !== result.text) {
    store.amend({ part: partOf(result.text, result.contours), partText: result.text });
  }
  const known = store.state.corner;
  const corner =
    known === undefined || known >= result.transitions.length ? showpiece(result) : known;
  store.set({ result, failure: undefined, corner: cornerOfSelection(result) ?? corner });
  drag.take(result);
}

/** The transition at the selected point. */
function cornerOfSelection(result: Result): number | undefined {
  const { selection } = store.state;
  const at = selection && locate(store.document.part, selection);
  if (!at) return undefined;
  const index = result.transitions.findIndex(
    ({ corner }) => Math.hypot(corner[0] - at[0], corner[1] - at[1]) < 2e-3,
  );
  return index < 0 ? undefined : index;
}

const liveClient = new LiveClient((live) => {
  // What was dragged last may be written and computed by now.
  const isBehind = !isResultOf(store.state.result, store.document);
  if (drag.isAhead || isBehind) store.set({ live });
});
const drag = new Drag(store, liveClient);

const client = new ComputeClient({
  result: take,
  failure: (message) => {
    if (files.fail(message)) return;
    // What there is of a program before must not be taken, and saved, for that of this one.
    drawing.clear();
    store.set({ failure: message, result: undefined, work: undefined, live: undefined });
  },
  busy: (busy) => find("stage").setAttribute("aria-busy", String(busy)),
  progress: (step, part) => {
    const { name, file } = store.document;
    // Who types or drags is not to have it in front of the picture.
    if (files.opening || file) store.set({ work: { name: files.opening ?? name, step, part } });
  },
});
const files = new Files(store, client, stage);
store.subscribe((state, before) => {
  const { present } = state.history;
  const { text, file, settings } = before.history.present;
  if (present.text !== text || present.file !== file || present.settings !== settings) {
    client.ask(present);
  }
  if (state.selection !== before.selection && state.result) {
    const corner = cornerOfSelection(state.result);
    if (corner !== undefined && corner !== state.corner) store.set({ corner });
  }
});

connectPointers(stage, store, drag);
connectKeys(stage, store);
toolbar(find("toolbar"), stage, store, {
  zoom: (factor) => (store.state.space ? space : stage).zoom(factor),
  fit: () => (store.state.space ? space : stage).fit(),
});
parametersPanel(find("parameters"), store);
filePanel(find<HTMLFormElement>("file"), files, store);
toolsPanel(find("tools"), store);
workPanel(find("work"), files, store);
connectDrops(files);
const showLine = codePanel(store, stage);
diagnosticsPanel(find("diagnostics"), stage, store, showLine);
callout(find("stage"), stage, store);
const drawers = find("toolbar").querySelector<HTMLElement>(".drawer-buttons") ?? find("toolbar");
const space = new SpaceView(find("stage"), drawers, stage, store);
deviationPanel(find("deviation"), drawers, stage, store);
const recolourMotion = motionButton(find("motion"), drawers, stage, store);
legend(find("legend"), store);
description(find("description"), store);
connectScheme(find("scheme"), (scheme) => {
  stage.setScheme(scheme);
  space.setScheme(scheme);
  recolourMotion();
});

galleryMenu(
  find<HTMLSelectElement>("example"),
  (example) => {
    stage.fitNext();
    openExample(store, example);
  },
  store,
);
autosave(store);
connectLinks(store, stage);

client.ask(store.document);
