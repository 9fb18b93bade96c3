// The time of the plan beside those of a stop at each block and of the other method.

import type { Violation } from "g41";
import { element } from "../panels/elements";
import { seconds } from "./player";
import { type MotionData, type Other, otherMethod } from "./protocol";

/** What the methods are called. */
const METHODS = { fast: "Fast", textbook: "Textbook" } as const;

/** A list of three times; the others come later than the plan. */
export class Comparison {
  readonly root = element("ul", { class: "motion-times", "aria-label": "Cycle times" });
  #duration = 0;
  #others = [tile("Full stops"), tile("")] as const;
  #own = tile("Cycle time");

  constructor() {
    this.root.append(this.#own.root, ...this.#others.map(({ root }) => root));
  }

  /** Shows the time of the plan. */
  show({ duration, violations, limits }: MotionData): void {
    this.#duration = duration;
    this.#others[1].name.textContent = METHODS[otherMethod(limits.mode)];
    this.#own.time.textContent = seconds(duration);
    this.#own.note.textContent = broken(violations) ?? "keeps every limit";
    this.#own.note.className = violations.length > 0 ? "beyond" : "inside";
    for (const { root } of this.#others) root.classList.add("stale");
  }

  /** Shows the times of the others. */
  compare(stops: Other | undefined, method: Other | undefined): void {
    [stops, method].forEach((other, i) => {
      const shown = this.#others[i];
      if (!shown) return;
      const { root, time, note } = shown;
      root.classList.remove("stale");
      time.textContent = other ? seconds(other.duration) : "—";
      const faults = other && broken(other.violations);
      note.textContent = other
        ? [ratio(other.duration, this.#duration), faults].filter(Boolean).join(", ")
        : "too long to tell";
      note.className = faults ? "beyond" : "";
    });
  }
}

function tile(title: string) {
  const [name, time] = [element("span", {}, title), element("strong", {}, "…")];
  const note = element("small", {}, "");
  return { root: element("li", {}, name, time, note), name, time, note };
}

function ratio(time: number, own: number): string {
  if (!(own > 0)) return "";
  const times = time / own;
  if (times >= 2) return `${times.toFixed(times >= 10 ? 0 : 1)} times as long`;
  const percent = 100 * (times - 1);
  if (Math.abs(percent) < 0.05) return "the same";
  return `${percent > 0 ? "+" : "−"}${Math.abs(percent).toFixed(1)} %`;
}

/** The limits that are broken, in words; undefined for none. */
function broken(violations: readonly Violation[]): string | undefined {
  if (violations.length === 0) return undefined;
  const words = violations.map(({ limit, value, allowed }) => {
    const times = value / allowed;
    const by = times >= 1.1 && times < 1e6 ? ` ×${times.toFixed(times >= 10 ? 0 : 1)}` : "";
    return `${NAMES[limit]}${by}`;
  });
  return `breaks ${words.join(", ")}`;
}

/** What limits are called. */
const NAMES: Readonly<Record<Violation["limit"], string>> = {
  velocity: "velocity",
  feed: "feed",
  acceleration: "acceleration",
  jerk: "jerk",
  snap: "jerk by steps",
  "axes.velocity": "velocity of an axis",
  "axes.acceleration": "acceleration of an axis",
  "axes.jerk": "jerk of an axis",
  cornerDeviation: "deviation",
  chordError: "chord error",
  end: "end",
};
