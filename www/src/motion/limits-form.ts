// The controls of the machine, made from their table.

import { Choice, element } from "../panels/elements";
import { NumberField } from "../panels/number-field";
import {
  type ChoiceLimit,
  LIMITS,
  MACHINE_KEYS,
  MACHINES,
  type Machine,
  type NumberLimit,
  SMALL,
} from "./machine";

/** A form that shows a machine and tells of each change. */
export class LimitsForm {
  readonly root = element("form", { class: "motion-limits", "aria-label": "Machine" });
  #machine: Machine;
  #shows: (() => void)[] = [];
  #tell: (machine: Machine) => void;

  constructor(machine: Machine, onChange: (machine: Machine) => void) {
    this.#machine = machine;
    this.#tell = onChange;
    this.root.addEventListener("submit", (event) => event.preventDefault());
    this.root.append(this.#machines());
    const [first, more] = LIMITS;
    for (const limit of first ?? []) this.root.append(this.#row(limit));
    const rest = element("div", { class: "motion-more" });
    for (const limit of more ?? []) rest.append(this.#row(limit));
    this.root.append(element("details", {}, element("summary", {}, "More"), rest));
    this.#show();
  }

  #change(change: Partial<Machine>): void {
    this.#machine = { ...this.#machine, ...change };
    this.#show();
    this.#tell(this.#machine);
  }

  #show(): void {
    for (const show of this.#shows) show();
  }

  #machines(): HTMLElement {
    const select = element("select", {});
    for (const name of Object.keys(MACHINES)) select.append(element("option", {}, name));
    select.append(element("option", { value: "" }, "Own"));
    select.addEventListener("change", () => {
      const chosen = MACHINES[select.value];
      if (!chosen) return;
      const full = { ...SMALL, ...chosen };
      this.#change(Object.fromEntries(MACHINE_KEYS.map((key) => [key, full[key]])));
    });
    this.#shows.push(() => {
      const isOwn = ([, machine]: readonly [string, Partial<Machine>]) =>
        MACHINE_KEYS.every((key) => ({ ...SMALL, ...machine })[key] === this.#machine[key]);
      select.value = Object.entries(MACHINES).find(isOwn)?.[0] ?? "";
    });
    return element("label", { class: "field motion-row" }, element("span", {}, "Machine"), select);
  }

  #row(limit: NumberLimit | ChoiceLimit): HTMLElement {
    const row = element("div", { class: "motion-row", title: limit.hint });
    if (limit.kind === "number") {
      const { key, label, unit, step, min, max } = limit;
      const field = new NumberField({
        label,
        unit,
        step,
        digits: 4,
        onValue: (value) => {
          if (!Number.isFinite(value)) return;
          this.#change({ [key]: Math.min(max, Math.max(min, value)) });
        },
      });
      row.append(field.root);
      this.#shows.push(() => field.show(this.#machine[key]));
    } else {
      const { key, label, choices } = limit;
      const choice = new Choice(`motion-${key}`, label, choices, (value) =>
        this.#change({ [key]: value }),
      );
      row.append(choice.root);
      this.#shows.push(() => choice.show(this.#machine[key]));
    }
    return row;
  }
}
