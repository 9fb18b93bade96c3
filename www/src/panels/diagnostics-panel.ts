// The list of diagnostics; a click shows the place of one in the picture and in the text.

import type { Diagnostic } from "g41";
import { keyOf, lineOf } from "../result";
import type { Stage } from "../stage";
import type { Store } from "../state";
import { element } from "./elements";

const MARKS = { error: "Error", warning: "Warning", info: "Note" } as const;

/** No list is readable that is longer than this. */
const MOST = 100;

/** Fills the list of diagnostics and keeps it true to the result. */
export function diagnosticsPanel(
  section: HTMLElement,
  stage: Stage,
  store: Store,
  showLine: (line: number) => void,
): void {
  const summary = element("p", { class: "summary" });
  const list = element("ul");
  section.append(summary, list);

  const choose = (diagnostic: Diagnostic) => {
    store.set({ chosen: keyOf(diagnostic), selection: undefined, caret: undefined });
    if (diagnostic.at) stage.reveal(diagnostic.at);
    const line = lineOf(diagnostic);
    if (line !== undefined) showLine(line);
  };

  const row = (diagnostic: Diagnostic) => {
    const button = element("button", { type: "button", "data-key": keyOf(diagnostic) });
    const line = lineOf(diagnostic);
    const place = line === undefined ? "" : `line ${line}`;
    const deep = diagnostic.severity !== "info" && diagnostic.depth !== undefined;
    const depth = deep ? `${diagnostic.depth?.toFixed(3)} mm deep` : "";
    button.append(
      element("span", { class: "severity" }, MARKS[diagnostic.severity]),
      element("span", { class: "message" }, diagnostic.message),
      element(
        "small",
        { class: "place" },
        [place, depth, diagnostic.hint].filter(Boolean).join(" · "),
      ),
    );
    button.addEventListener("click", () => choose(diagnostic));
    return element("li", { class: `diagnostic diagnostic-${diagnostic.severity}` }, button);
  };

  let shown = "";
  const show = () => {
    const { result, failure, chosen } = store.state;
    const diagnostics = result?.diagnostics ?? [];
    section.dataset.empty = String(diagnostics.length === 0 && !failure);
    summary.textContent = failure ?? (result ? summarize(diagnostics) : "Loading …");
    // Rows are kept while they say the same, and with them the focus.
    const rows = diagnostics.slice(0, MOST);
    const key = rows.map(keyOf).join();
    if (key !== shown) list.replaceChildren(...rows.map(row));
    shown = key;
    for (const button of list.querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.key === chosen));
    }
  };
  store.subscribe((state, before) => {
    const { result, failure, chosen } = before;
    if (state.result !== result || state.failure !== failure || state.chosen !== chosen) show();
  });
  show();
}

function summarize(diagnostics: readonly Diagnostic[]): string {
  if (diagnostics.length === 0) return "Nothing found: no gouges at bends and corners.";
  const parts = (["error", "warning", "info"] as const).flatMap((severity) => {
    const count = diagnostics.filter((diagnostic) => diagnostic.severity === severity).length;
    if (count === 0) return [];
    return `${count} ${MARKS[severity].toLowerCase()}${count === 1 ? "" : "s"}`;
  });
  const more = diagnostics.length > MOST ? `; the first ${MOST} are listed` : "";
  return parts.join(", ") + more;
}
