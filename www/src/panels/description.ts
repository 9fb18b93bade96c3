// The state in words, for those who do not see the picture.

import { counted, grouped } from "../counts";
import { format } from "../expression";
import { findingsOf } from "../findings";
import { describePoint, locate } from "../part";
import type { State, Store } from "../state";

/** Changes that follow each other faster are told once [ms]. */
const PAUSE = 500;

/** Keeps a live region true to the state. */
export function description(region: HTMLElement, store: Store): void {
  let timer = 0;
  store.subscribe((state, before) => {
    const { result, selection, failure } = before;
    const isSame = state.result === result && state.failure === failure;
    if (isSame && state.selection === selection) return;
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      region.textContent = describe(store.state);
    }, PAUSE);
  });
}

/** One paragraph about what the picture shows. */
export function describe({ result, selection, history, failure }: State): string {
  if (failure) return failure;
  if (!result) return "Loading.";
  const { name, part, settings } = history.present;
  const sentences = part.contours.map(({ segments, side }, i) => {
    const name = part.contours.length > 1 ? `Contour ${i + 1}` : "The contour";
    const kinds = (["line", "arc", "spline"] as const).flatMap((kind) => {
      const count = segments.filter((segment) => segment.kind === kind).length;
      return count > 0 ? [counted(count, kind)] : [];
    });
    return `${name} has ${kinds.join(", ")}; the tool runs on its ${side}.`;
  });
  sentences.push(`Tool radius ${format(settings.radius)} mm.`);
  if (result.long) {
    const { text, moves } = result.long;
    const { error, warning } = result.counts;
    sentences.unshift(
      `${name} has ${counted(text.starts.length, "line")} and gives ${counted(moves, "move")}, with ${counted(error, "error")} and ${counted(warning, "warning")}.`,
    );
    return sentences.join(" ");
  }
  const count = (kind: string) =>
    grouped(result.transitions.filter((each) => each.kind === kind).length);
  sentences.push(
    `Transitions: ${count("shortened")} shortened, ${count("elongated")} elongated, ${count("inserted")} inserted.`,
  );
  const findings = findingsOf(result);
  const [deepest] = findings.filter((finding) => finding.kind === "gouge");
  if (deepest) sentences.push(`The deepest gouge is ${deepest.title}.`);
  const uncut = findings.flatMap((finding) => (finding.kind === "uncut" ? [finding.area] : []));
  if (uncut.length > 0) {
    const area = uncut.reduce((sum, each) => sum + each, 0);
    sentences.push(`${format(area)} mm² stay uncut, in ${counted(uncut.length, "place")}.`);
  }
  const { diagnostics } = result;
  if (diagnostics.length > 0) {
    const first = diagnostics[0]?.message ?? "";
    const most = counted(diagnostics.length, "diagnostic");
    sentences.push(`${most}${diagnostics.length > 1 ? ", the first" : ""}: ${first}.`);
  }
  const at = selection && locate(part, selection);
  if (selection && at) {
    sentences.unshift(`${describePoint(part, selection)}: x ${format(at[0])}, y ${format(at[1])}.`);
  }
  return sentences.join(" ");
}
