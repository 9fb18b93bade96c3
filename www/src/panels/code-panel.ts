// The two programs: the part as it is programmed, to be edited, and the compensated one.

import type { Diagnostic } from "g41";
import { setText } from "../actions";
import { save, savedName } from "../files";
import { lineOfPoint } from "../part";
import { keyOf, lineOf, type Result } from "../result";
import type { Stage } from "../stage";
import type { Store } from "../state";
import type { Editor, LineMarks, LineRemark } from "./editor";
import { element, find } from "./elements";
import { ProgramView } from "./program-view";

/** Typing that pauses for this long is undone as one step [ms]. */
const TYPING_PAUSE = 900;

/** Fills both tabs and keeps them true to the state; returns what shows a line of the program. */
export function codePanel(store: Store, stage: Stage): (line: number) => void {
  const program = new ProgramView(
    "Program of the part",
    "program",
    false,
    (line) => {
      store.set({ caret: line, selection: undefined, chosen: keyAt(store, line) });
      stage.revealLine(line);
    },
    (line) => {
      store.set({ pointed: line, caret: undefined, selection: undefined });
      const diagnostic = diagnosticAt(store, line);
      store.set({ chosen: diagnostic && keyOf(diagnostic) });
      if (diagnostic?.at) stage.reveal(diagnostic.at);
      else stage.revealLine(line);
    },
  );
  let outputLine: number | undefined;
  const output = new ProgramView(
    "Compensated program",
    "output",
    true,
    (line) => {
      outputLine = line;
      output.mark({ ...NO_MARKS, current: line });
    },
    () => {},
  );
  find("panel-program").append(...program.roots);
  find("panel-output").append(...output.roots);
  const choose = tabs(["program", "output"]);
  actions(store, () => (find("panel-output").hidden ? program : output).text);
  connectEditor(program.editor, store);

  const mark = () => {
    const { selection, caret, hover, pointed, result } = store.state;
    const selected = selection && lineOfPoint(store.document.part, selection);
    const current = caret ?? selected ?? pointed;
    program.mark({ current, hovered: hover, diagnosed: remarksOf(result) });
    return caret === undefined ? current : undefined;
  };
  store.subscribe((state, before) => {
    const { selection, caret, hover, pointed, result, history } = before;
    const { long } = state.result ?? {};
    if (state.history !== history || state.result !== result) {
      const { text, file } = store.document;
      if (!file) program.show(text);
      else if (long?.file === file) program.show(long.text);
    }
    if (state.result !== result) {
      output.show(long?.code ?? state.result?.gcode ?? "");
      output.mark({ ...NO_MARKS, current: outputLine });
    }
    const isMoved =
      state.selection !== selection || state.caret !== caret || state.pointed !== pointed;
    if (isMoved || state.hover !== hover || state.result !== result || state.history !== history) {
      const current = mark();
      if (current !== undefined && (isMoved || state.history !== history)) program.reveal(current);
    }
  });
  program.show(store.document.text);
  return (line) => {
    choose("program");
    program.reveal(line);
  };
}

const NO_MARKS: LineMarks = { current: undefined, hovered: undefined, diagnosed: new Map() };

const known = new WeakMap<Result, ReadonlyMap<number, LineRemark>>();

/** The gravest diagnostic of each line. */
function remarksOf(result: Result | undefined): ReadonlyMap<number, LineRemark> {
  if (!result) return NO_MARKS.diagnosed;
  const before = known.get(result);
  if (before) return before;
  const remarks = new Map<number, LineRemark>();
  const ranks = ["info", "warning", "error"];
  for (const diagnostic of result.diagnostics) {
    const { severity, message } = diagnostic;
    const line = lineOf(diagnostic);
    const other = line === undefined ? undefined : remarks.get(line);
    if (line === undefined) continue;
    if (!other || ranks.indexOf(severity) > ranks.indexOf(other.severity)) {
      remarks.set(line, { severity, message });
    }
  }
  known.set(result, remarks);
  return remarks;
}

function diagnosticAt({ state }: Store, line: number): Diagnostic | undefined {
  return state.result?.diagnostics.find((diagnostic) => lineOf(diagnostic) === line);
}

function keyAt(store: Store, line: number): string | undefined {
  const diagnostic = diagnosticAt(store, line);
  return diagnostic && keyOf(diagnostic);
}

/** Lets the program be edited as text. */
function connectEditor(program: Editor, store: Store): void {
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
function actions(store: Store, shown: () => ProgramView["text"]): void {
  const copy = element("button", { type: "button" }, "Copy");
  copy.addEventListener("click", async () => {
    const text = shown();
    const letters = typeof text === "string" ? text : new TextDecoder().decode(text);
    try {
      await navigator.clipboard.writeText(letters);
      copy.textContent = "Copied";
    } catch {
      // Neither where it is refused nor on a page without https, which has no clipboard at all.
      copy.textContent = "Not allowed";
    }
    setTimeout(() => {
      copy.textContent = "Copy";
    }, 1400);
  });
  const download = element("button", { type: "button" }, "Download");
  download.addEventListener("click", () => {
    const compensated = !find("panel-output").hidden;
    const { document } = store;
    save(compensated ? savedName(document) : document.name || "part.nc", shown());
  });
  find("code-actions").append(copy, download);
}
