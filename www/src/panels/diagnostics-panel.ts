// The list of diagnostics and of what is not reached; a click shows the place of one in the picture
// and in the text, and while the pointer or the focus is on it, its measure.

import type { Diagnostic } from "g41";
import { counted } from "../counts";
import { format } from "../expression";
import { type Finding, findingOf, findingsOf, linesInWords, type UncutPlace } from "../findings";
import type { Point } from "../geometry";
import { keyOf, lineOf, type Result } from "../result";
import type { Stage } from "../stage";
import type { Store } from "../state";
import { element } from "./elements";

const MARKS = { error: "Error", warning: "Warning", info: "Note", uncut: "Uncut" } as const;

/** No list is readable that is longer than this. */
const MOST = 100;

/** Of what is not reached, only the largest are worth a row each. */
const MOST_UNCUT = 12;

/** One row of the list. */
interface Row {
  /** What tells it from the others. */
  readonly key: string;
  readonly kind: keyof typeof MARKS;
  readonly message: string;
  /** Place, number and advice. */
  readonly more: readonly string[];
  readonly line: number | undefined;
  readonly at: Point | undefined;
  /** What it lets look at in the picture. */
  readonly finding: string | undefined;
}

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

  const choose = ({ key, at, line }: Row) => {
    store.set({ chosen: key, selection: undefined, caret: undefined, pointed: line });
    if (line !== undefined) showLine(line);
    if (at) stage.reveal(at);
    else if (line !== undefined) stage.revealLine(line);
  };

  const item = (row: Row) => {
    const button = element("button", { type: "button", "data-key": row.key });
    button.append(
      element("span", { class: "severity" }, MARKS[row.kind]),
      element("span", { class: "message" }, row.message),
      element("small", { class: "place" }, row.more.filter(Boolean).join(" · ")),
    );
    button.addEventListener("click", () => choose(row));
    for (const name of ["focus", "pointerenter"]) {
      button.addEventListener(name, () => store.set({ finding: row.finding }));
    }
    for (const name of ["blur", "pointerleave"]) {
      button.addEventListener(name, () => store.set({ finding: undefined }));
    }
    return element("li", { class: `diagnostic diagnostic-${row.kind}` }, button);
  };

  let shown = "";
  const show = () => {
    const { result, failure, chosen } = store.state;
    const rows = result ? rowsOf(result) : [];
    section.dataset.empty = String(rows.length === 0 && !failure);
    summary.textContent = failure ?? (result ? summarize(result) : "Loading …");
    // Rows are kept while they say the same, and with them the focus.
    const key = JSON.stringify(rows);
    if (key !== shown) list.replaceChildren(...rows.map(item));
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

/** What is listed: diagnostics, gouges that none of them is about, and what is not reached. */
function rowsOf(result: Result): Row[] {
  const diagnostics = result.diagnostics.slice(0, MOST);
  const told = new Set<string>();
  const rows = diagnostics.map((diagnostic) => {
    const finding = findingOf(result, diagnostic);
    if (finding) told.add(finding.key);
    return diagnosticRow(diagnostic, finding);
  });
  const [gouges, uncut] = split(findingsOf(result));
  const untold = gouges.filter(({ key }) => !told.has(key)).slice(0, MOST - rows.length);
  return [
    ...rows,
    ...untold.map((finding) => findingRow(finding, "error")),
    ...uncut.slice(0, MOST_UNCUT).map((finding) => findingRow(finding, "uncut")),
  ];
}

function diagnosticRow(diagnostic: Diagnostic, finding: Finding | undefined): Row {
  const { severity, message, depth, hint, at } = diagnostic;
  const line = lineOf(diagnostic);
  const lines = finding?.lines ?? (line === undefined ? [] : [line]);
  const deep = severity !== "info" && depth !== undefined && !message.includes(" mm too deep");
  return {
    key: keyOf(diagnostic),
    kind: severity,
    message,
    more: [linesInWords(lines), deep ? `${depth.toFixed(3)} mm deep` : "", hint ?? ""],
    line,
    at,
    finding: finding?.key,
  };
}

function findingRow(finding: Finding, kind: "error" | "uncut"): Row {
  const { key, title, reason, lines, at } = finding;
  const hint = kind === "uncut" ? "a smaller tool reaches more of it" : "use a smaller tool";
  return {
    key,
    kind,
    message: `${title}: ${reason}`,
    more: [hint],
    line: lines[0],
    at,
    finding: key,
  };
}

function split(findings: readonly Finding[]): [Finding[], UncutPlace[]] {
  const gouges = findings.filter(({ kind }) => kind === "gouge");
  return [gouges, findings.filter((finding) => finding.kind === "uncut")];
}

function summarize(result: Result): string {
  const { diagnostics, counts } = result;
  const [gouges, uncut] = split(findingsOf(result));
  const parts = (["error", "warning", "info"] as const).flatMap((severity) => {
    const count = counts[severity];
    return count === 0 ? [] : counted(count, MARKS[severity].toLowerCase());
  });
  if (diagnostics.length > MOST) parts.push(`the first ${MOST} are listed`);
  if (gouges.length > 0) parts.push(counted(gouges.length, "gouge"));
  if (uncut.length > 0) {
    const area = uncut.reduce((sum, region) => sum + region.area, 0);
    const listed = uncut.length > MOST_UNCUT ? `, the largest ${MOST_UNCUT} listed` : "";
    parts.push(`${format(area)} mm² uncut in ${counted(uncut.length, "place")}${listed}`);
  }
  if (parts.length > 0) return parts.join(", ");
  if (result.long || result.contours.length > 0) return "Nothing found: no gouges.";
  return result.text.trim() === ""
    ? "The program is empty."
    : "Nothing found. Nothing is compensated: there is no G41 or G42.";
}
