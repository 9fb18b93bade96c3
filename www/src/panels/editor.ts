// The program as editable text: a text area over a coloured copy of its lines, with line numbers.

import { element } from "./elements";
import { coloured } from "./line";

/** Longer texts are shown without colours. */
const MOST_COLOURED_LINES = 3000;

/** What is said of a line. */
export interface LineRemark {
  readonly severity: "error" | "warning" | "info";
  readonly message: string;
}

/** What is shown besides a text. */
export interface LineMarks {
  /** The line that belongs to what is selected. */
  readonly current: number | undefined;
  /** The line whose move the pointer is over. */
  readonly hovered: number | undefined;
  /** Lines with a diagnostic. */
  readonly diagnosed: ReadonlyMap<number, LineRemark>;
}

/** A text area with numbered, coloured and marked lines. */
export class Editor {
  readonly root: HTMLElement;
  readonly area: HTMLTextAreaElement;
  #copy: HTMLElement;
  #gutter: HTMLElement;
  #lines: string[] = [];
  #marks: LineMarks = { current: undefined, hovered: undefined, diagnosed: new Map() };

  /** `onNumber` is called with the line whose number was clicked. */
  constructor(label: string, readOnly: boolean, onNumber: (line: number) => void) {
    this.area = element("textarea", {
      "aria-label": label,
      spellcheck: "false",
      autocapitalize: "characters",
      autocomplete: "off",
      wrap: "off",
      readonly: readOnly,
    });
    this.#copy = element("pre", { class: "copy", "aria-hidden": "true" });
    this.#gutter = element("pre", { class: "gutter", "aria-hidden": "true" });
    const text = element("div", { class: "editor-text" }, this.#copy, this.area);
    this.root = element("div", { class: "editor" }, this.#gutter, text);
    this.area.addEventListener("scroll", () => this.#follow(), { passive: true });
    this.#gutter.addEventListener("click", ({ target }) => {
      const line = [...this.#gutter.children].indexOf(target as Element) + 1;
      if (line > 0) onNumber(line);
    });
  }

  /** The whole text. */
  get text(): string {
    return this.area.value;
  }

  /** Shows a text; the caret stays where it is as far as it can. */
  show(text: string): void {
    if (this.area.value !== text) {
      const { selectionStart, selectionEnd, scrollTop, scrollLeft } = this.area;
      this.area.value = text;
      this.area.setSelectionRange(selectionStart, selectionEnd);
      this.area.scrollTop = scrollTop;
      this.area.scrollLeft = scrollLeft;
    }
    this.#colour(text.split("\n"));
    this.#follow();
  }

  #lineHeight(): number {
    return this.#copy.firstElementChild?.getBoundingClientRect().height || 20;
  }

  /** Marks lines. */
  mark(marks: LineMarks): void {
    this.#marks = marks;
    for (const [i, line] of [...this.#copy.children].entries()) {
      this.#markLine(line, this.#gutter.children[i], i);
    }
  }

  /** The line that the caret is in, counted from 1. */
  caretLine(): number {
    const before = this.area.value.slice(0, this.area.selectionStart);
    return before.split("\n").length;
  }

  /** Scrolls a line into sight. */
  reveal(line: number): void {
    const height = this.#lineHeight();
    const top = (line - 1) * height;
    const { scrollTop, clientHeight } = this.area;
    if (top < scrollTop + height || top > scrollTop + clientHeight - 3 * height) {
      this.area.scrollTop = top - clientHeight / 2;
    }
    this.#follow();
  }

  #colour(lines: string[]): void {
    const plain = lines.length > MOST_COLOURED_LINES;
    this.root.classList.toggle("plain", plain);
    const wanted = plain ? [] : lines;
    while (this.#copy.children.length > wanted.length) {
      this.#copy.lastElementChild?.remove();
      this.#gutter.lastElementChild?.remove();
    }
    wanted.forEach((line, i) => {
      let copy = this.#copy.children[i];
      if (!copy) {
        copy = element("div");
        this.#copy.append(copy);
        this.#gutter.append(element("div", {}, String(i + 1)));
        this.#markLine(copy, this.#gutter.children[i], i);
      } else if (this.#lines[i] === line) return;
      copy.replaceChildren(...coloured(line));
    });
    this.#lines = wanted;
  }

  #markLine(copy: Element, number: Element | undefined, index: number): void {
    const line = index + 1;
    const { current, hovered, diagnosed } = this.#marks;
    const found = diagnosed.get(line);
    for (const place of [copy, number]) {
      place?.classList.toggle("current", current === line);
      place?.classList.toggle("hovered", hovered === line);
      for (const severity of ["error", "warning", "info"]) {
        place?.classList.toggle(`has-${severity}`, found?.severity === severity);
      }
    }
    for (const [place, name] of [
      [copy, "data-remark"],
      [number, "title"],
    ] as const) {
      if (found) place?.setAttribute(name, found.message);
      else place?.removeAttribute(name);
    }
  }

  #follow(): void {
    const { scrollTop, scrollLeft } = this.area;
    this.#copy.style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
    this.#gutter.style.transform = `translateY(${-scrollTop}px)`;
  }
}
