// The table of interpolation rules, on demand: how evenly each steps along the program's splines.

import { element } from "../panels/elements";
import type { Document } from "../state";
import { rounded } from "./plots";
import type { MotionData } from "./protocol";
import { RULES, type RulesErrors, type RulesReply, type RulesRequest } from "./rules-protocol";

/** Less than this is rounding. */
const ROUNDING = 1e-12;

/** A table that is made when it is opened, and anew while it is open. */
export class RulesTable {
  readonly root = element("details", { class: "motion-rules" });
  #content = element("div", { "aria-live": "polite" });
  #worker: Worker | undefined;
  #document: Document | undefined;
  #data: MotionData | undefined;

  constructor() {
    this.root.append(element("summary", {}, "Interpolation rules compared"), this.#content);
    this.root.addEventListener("toggle", () => this.#make());
  }

  /** Takes what is planned now. */
  show(document: Document, data: MotionData): void {
    this.#document = document;
    this.#data = data;
    this.#make();
  }

  #make(): void {
    this.#worker?.terminate();
    this.#worker = undefined;
    const [document, data] = [this.#document, this.#data];
    if (!this.root.open || !document || !data) return;
    const feeds = feedsOf(data);
    const { period = 0.001 } = data.limits;
    const { text, settings } = document;
    const worker = new Worker(new URL("./rules.worker.ts", import.meta.url), { type: "module" });
    this.#worker = worker;
    // A table of the program before would be read as that of this one.
    this.#content.replaceChildren(element("p", {}, "Stepping along the splines …"));
    const done = (shown: Node) => {
      worker.terminate();
      this.#content.replaceChildren(shown);
    };
    const failed = (message: string) => done(element("p", { class: "motion-failure" }, message));
    worker.addEventListener("message", ({ data: reply }: MessageEvent<RulesReply>) => {
      if (typeof reply === "string") failed(reply);
      else done(reply.splines > 0 ? table(reply, feeds, period) : NO_SPLINE());
    });
    worker.addEventListener("error", ({ message }) =>
      failed(message || "the worker could not be started"),
    );
    const steps = feeds.map((feed) => feed * period);
    worker.postMessage({ text, settings, steps } satisfies RulesRequest);
  }
}

const NO_SPLINE = () =>
  element("p", {}, "The program compensates no spline: along lines and arcs every rule is exact.");

/** The largest feed that is programmed, and that of the machine [mm/s]. */
function feedsOf({ feeds, rapid, limits }: MotionData): number[] {
  const programmed = Math.max(0, ...feeds.filter((_, move) => !rapid[move]));
  return [...new Set([programmed || limits.velocity, limits.velocity])];
}

function table({ columns }: RulesErrors, feeds: readonly number[], period: number): HTMLElement {
  const heads = feeds.map((feed) => {
    const step = `${rounded(feed * period)} mm a period`;
    return element(
      "th",
      { scope: "col" },
      `${rounded(60 * feed)} mm/min`,
      element("small", {}, step),
    );
  });
  const rows = RULES.map(({ name }, i) => {
    const cells = columns.map((column) => element("td", {}, inPowers(column[i])));
    return element("tr", {}, element("th", { scope: "row" }, name), ...cells);
  });
  const title =
    "Largest error of a step along the splines of the program, as a part of it. The planner uses none of these rules: it measures the length of the curve, to 1e-9 of a step.";
  return element(
    "table",
    {},
    element("caption", {}, title),
    element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "Rule"), ...heads)),
    element("tbody", {}, ...rows),
  );
}

/** A small number as a multiple of a power of ten. */
function inPowers(value: number | undefined): string {
  if (value === undefined) return "too many steps";
  if (value < ROUNDING) return "< 1e−12";
  return value.toExponential(1).replace("-", "−");
}
