// A field for an exact number: takes arithmetic, and the arrow keys step it.

import { evaluate, format } from "../expression";
import { element } from "./elements";

/** What a number field needs to know. */
export interface NumberFieldOptions {
  readonly label: string;
  readonly unit?: string;
  /** What the arrow keys add; with Shift ten times, with Alt a tenth. */
  readonly step: number;
  readonly digits?: number;
  /** The least and the largest number that may be entered, and what to do instead of less. */
  readonly range?: { readonly min: number; readonly max: number; readonly instead?: string };
  /** Called with each number that was entered; `gesture` joins repeated steps. */
  readonly onValue: (value: number, gesture?: string) => void;
}

/** A labelled number field. */
export class NumberField {
  readonly root: HTMLLabelElement;
  readonly input: HTMLInputElement;
  #value = 0;
  #options: NumberFieldOptions;

  constructor(options: NumberFieldOptions) {
    this.#options = options;
    this.input = element("input", {
      type: "text",
      inputmode: "decimal",
      autocomplete: "off",
      spellcheck: "false",
      "aria-label": options.unit ? `${options.label} in ${options.unit}` : options.label,
    });
    this.root = element("label", { class: "field number-field" });
    this.root.append(element("span", {}, options.label), this.input);
    if (options.unit) this.root.append(element("small", { "aria-hidden": "true" }, options.unit));
    this.input.addEventListener("change", () => this.#enter());
    this.input.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Shows a value, unless someone is typing another. */
  show(value: number | undefined): void {
    this.input.disabled = value === undefined;
    const text = value === undefined ? "" : format(value, this.#options.digits);
    if (value !== undefined && value === this.#value && this.#isTyping()) return;
    this.#value = value ?? 0;
    this.input.value = text;
    this.#complain("");
  }

  #isTyping(): boolean {
    return document.activeElement === this.input;
  }

  #enter(): void {
    const value = evaluate(this.input.value);
    const wrong =
      value === undefined ? "This is no number, as 5, 2.5 or 10/3 are" : this.#beyond(value);
    if (value === undefined || wrong) {
      this.#complain(`${wrong}; Esc brings ${format(this.#value, this.#options.digits)} back.`);
      return;
    }
    this.#complain("");
    this.#options.onValue(value);
    this.input.value = format(this.#value, this.#options.digits);
  }

  /** Why a number is too small or too large; "" where it is neither. */
  #beyond(value: number): string {
    const { range, unit = "", digits } = this.#options;
    const bound = (at: number) => `${format(at, digits)} ${unit}`.trim();
    if (range && value < range.min) {
      return [`This is less than ${bound(range.min)}`, range.instead].filter(Boolean).join("; ");
    }
    return range && value > range.max ? `This is more than ${bound(range.max)}` : "";
  }

  /** Marks the field as wrong and says why, to pointers and screen readers too; nothing wrong is "". */
  #complain(why: string): void {
    this.input.setCustomValidity(why);
    this.input.title = why;
    if (why) this.input.setAttribute("aria-invalid", "true");
    else this.input.removeAttribute("aria-invalid");
  }

  #key(event: KeyboardEvent): void {
    if (event.key === "Enter") {
      event.preventDefault();
      this.#enter();
      this.input.reportValidity();
      return;
    }
    if (event.key === "Escape") {
      this.#complain("");
      this.input.value = format(this.#value, this.#options.digits);
      return;
    }
    const sign = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (sign === 0) return;
    event.preventDefault();
    const factor = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
    const value = (evaluate(this.input.value) ?? this.#value) + sign * factor * this.#options.step;
    this.#options.onValue(Number(value.toFixed(6)), `step ${this.#options.label}`);
  }
}
