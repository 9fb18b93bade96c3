// The page: state → worker → result → picture, and controls that change the state.

import "./style/tokens.css";
import "./style/base.css";
import "./style/controls.css";
import "./style/layout.css";
import "./style/panels.css";
import "./style/findings.css";
import "./style/deviation.css";
import "./style/narrow.css";
import { openExample } from "./actions";
import { autosave, restore } from "./autosave";
import { ComputeClient } from "./compute-client";
import { EXAMPLES } from "./examples";
import { showpiece } from "./hit";
import { connectKeys } from "./keyboard";
import { Drag } from "./live/drag";
import { LiveClient } from "./live/live-client";
import { callout } from "./panels/callout";
import { codePanel } from "./panels/code-panel";
import { description } from "./panels/description";
import { deviationPanel } from "./panels/deviation-panel";
import { diagnosticsPanel } from "./panels/diagnostics-panel";
import { find } from "./panels/elements";
import { galleryMenu } from "./panels/gallery-menu";
import { legend } from "./panels/legend";
import { parametersPanel } from "./panels/parameters-panel";
import { toolbar } from "./panels/toolbar";
import { INITIAL_SETTINGS } from "./parameters";
import { locate } from "./part";
import { connectPointers } from "./pointer";
import { partOf } from "./program-text";
import type { Result } from "./result";
import { connectScheme } from "./scheme";
import { Stage } from "./stage";
import { NO_PART, Store } from "./state";
import { toWorld } from "./view";

const first = EXAMPLES[0];
if (!first) throw new Error("the gallery is empty");

const saved = restore();
const store = new Store({
  text: saved?.text ?? first.text,
  part: NO_PART,
  partText: "",
  settings: saved?.settings ?? { ...INITIAL_SETTINGS, ...first.settings },
});

const readout = find("readout");
const stage = new Stage(find("stage"), store, (view, pointer) => {
  const digits = Math.min(3, Math.max(0, Math.ceil(Math.log10(view.scale))));
  const at = pointer && toWorld(view, pointer);
  readout.textContent = at ? `X ${at[0].toFixed(digits)}  Y ${at[1].toFixed(digits)}` : "";
});

/** Takes what the worker found, and derives what the page needs of it. */
function take(result: Result): void {
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
  const isBehind = store.state.result?.text !== store.document.text;
  if (drag.isAhead || isBehind) store.set({ live });
});
const drag = new Drag(store, liveClient);

const client = new ComputeClient(
  take,
  (message) => store.set({ failure: message }),
  (busy) => find("stage").setAttribute("aria-busy", String(busy)),
);
store.subscribe((state, before) => {
  const { text, settings } = state.history.present;
  const old = before.history.present;
  if (text !== old.text || settings !== old.settings) client.ask({ text, settings });
  if (state.selection !== before.selection && state.result) {
    const corner = cornerOfSelection(state.result);
    if (corner !== undefined && corner !== state.corner) store.set({ corner });
  }
});

connectPointers(stage, store, drag);
connectKeys(stage, store);
toolbar(find("toolbar"), stage, store);
parametersPanel(find("parameters"), store);
const showLine = codePanel(store);
diagnosticsPanel(find("diagnostics"), stage, store, showLine);
callout(find("stage"), stage, store);
deviationPanel(
  find("deviation"),
  find("toolbar").querySelector(".view-buttons") ?? find("toolbar"),
  stage,
  store,
);
legend(find("legend"), store);
description(find("description"), store);
connectScheme(find("scheme"), (scheme) => stage.setScheme(scheme));

galleryMenu(
  find<HTMLSelectElement>("example"),
  (example) => {
    stage.fitNext();
    openExample(store, example);
  },
  store,
);
autosave(store);

client.ask({ text: store.document.text, settings: store.document.settings });
