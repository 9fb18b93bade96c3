// The two programs: the part as it is programmed, to be edited, and the compensated one.

import { setText } from "../actions";
import { lineOfPoint } from "../part";
import { lineOf } from "../result";
import type { Store } from "../state";
import { Editor } from "./editor";
import { element, find } from "./elements";

/** Typing that pauses for this long is undone as one step [ms]. */
const TYPING_PAUSE = 900;

/** Fills both tabs and keeps them true to the state; returns what shows a line of the program. */
export function codePanel(store: Store): (line: number) => void {
  const program = new Editor("Program of the part", false);
  const output = new Editor("Compensated program", true);
  find("panel-program").append(program.root);
  find("panel-output").append(output.root);
  const choose = tabs(["program", "output"]);
  actions(store, () => (find("panel-output").hidden ? program : output).text);

  let typing = 0;
  let lastTyped = 0;
  program.area.addEventListener("input", () => {
    const now = performance.now();
    if (now - lastTyped > TYPING_PAUSE) typing += 1;
    lastTyped = now;
    setText(store, program.area.value, `type ${typing}`);
    store.set({ caret: program.caretLine(), selection: undefined, chosen: undefined });
  });
  // The document of the page has the history, not the text area.
  program.area.addEventListener("beforeinput", (event) => {
    if (event.inputType !== "historyUndo" && event.inputType !== "historyRedo") return;
    event.preventDefault();
    if (event.inputType === "historyUndo") store.undo();
    else store.redo();
  });
  const caret = () => {
    const line = program.caretLine();
    if (document.activeElement === program.area && line !== store.state.caret) {
      store.set({ caret: line, selection: undefined });
    }
  };
  for (const name of ["keyup", "click", "focus"]) program.area.addEventListener(name, caret);
  program.area.addEventListener("blur", () => {
    store.settle();
    store.set({ caret: undefined });
  });

  const mark = () => {
    const { selection, caret: line, result } = store.state;
    const current = line ?? (selection && lineOfPoint(store.document.part, selection));
    const diagnosed = new Map<number, string>();
    for (const diagnostic of result?.diagnostics ?? []) {
      const at = lineOf(diagnostic);
      if (at !== undefined && diagnosed.get(at) !== "error") diagnosed.set(at, diagnostic.severity);
    }
    program.mark({ current, diagnosed });
    if (current !== undefined && line === undefined) program.reveal(current);
  };
  store.subscribe((state, before) => {
    if (state.history !== before.history) program.show(store.document.text);
    if (state.result !== before.result) output.show(state.result?.gcode ?? "");
    const { selection, caret: line, result, history } = before;
    if (
      state.selection !== selection ||
      state.caret !== line ||
      state.result !== result ||
      state.history !== history
    ) {
      mark();
    }
  });
  program.show(store.document.text);
  return (line) => {
    choose("program");
    program.reveal(line);
    program.mark({ current: line, diagnosed: new Map() });
  };
}

/** Tabs as the keyboard expects them: arrows choose, one tab stop. */
function tabs(names: readonly string[]): (name: string) => void {
  const choose = (name: string) => {
    for (const each of names) {
      const tab = find(`tab-${each}`);
      tab.setAttribute("aria-selected", String(each === name));
      tab.tabIndex = each === name ? 0 : -1;
      find(`panel-${each}`).hidden = each !== name;
    }
  };
  names.forEach((name, i) => {
    const tab = find(`tab-${name}`);
    tab.addEventListener("click", () => choose(name));
    tab.addEventListener("keydown", (event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      const other = names[(i + by + names.length) % names.length];
      if (by === 0 || !other) return;
      choose(other);
      find(`tab-${other}`).focus();
    });
  });
  return choose;
}

/** Copy and download for the tab that is shown. */
function actions(store: Store, shown: () => string): void {
  const copy = element("button", { type: "button" }, "Copy");
  copy.addEventListener("click", async () => {
    const said = await navigator.clipboard.writeText(shown()).then(
      () => "Copied",
      () => "Not allowed",
    );
    copy.textContent = said;
    setTimeout(() => {
      copy.textContent = "Copy";
    }, 1400);
  });
  const download = element("button", { type: "button" }, "Download");
  download.addEventListener("click", () => {
    const compensated = !find("panel-output").hidden;
    const address = URL.createObjectURL(new Blob([shown()], { type: "text/plain" }));
    element("a", { href: address, download: compensated ? "compensated.nc" : "part.nc" }).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  });
  const open = element("input", {
    type: "file",
    accept: ".nc,.ngc,.tap,.gcode,.txt,.cnc",
    hidden: true,
  });
  open.addEventListener("change", async () => {
    const file = open.files?.[0];
    if (file) setText(store, await file.text());
    open.value = "";
  });
  const opener = element("button", { type: "button" }, "Open");
  opener.addEventListener("click", () => open.click());
  find("code-actions").append(opener, copy, download, open);
}
