// The program as editable text: a text area over a coloured copy of its lines, with line numbers.

import { element } from "./elements";

/** Longer texts are shown without colours. */
const MOST_COLOURED_LINES = 3000;
/** Of longer texts only some lines are shown: a browser takes seconds to lay out all of them. */
const MOST_LETTERS = 200_000;
/** Lines that are shown of such a text, and how near to their ends others are fetched. */
const EXCERPT = 1000;
const RIM = 100;

const TOKENS =
  /(?<comment>\([^)]*\)?|;.*)|(?<number>\bN\d+)|(?<motion>\b[GM]\d+(?:\.\d+)?)|(?<axis>[XYZIJR](?=\s*[-+.\d]))/gi;

/** What an editor shows besides its text. */
export interface LineMarks {
  /** The line that belongs to what is selected. */
  readonly current: number | undefined;
  /** Lines with a diagnostic, and its severity. */
  readonly diagnosed: ReadonlyMap<number, string>;
}

/** A text area with numbered, coloured and marked lines. */
export class Editor {
  readonly root: HTMLElement;
  readonly area: HTMLTextAreaElement;
  #copy: HTMLElement;
  #gutter: HTMLElement;
  #lines: string[] = [];
  #text = "";
  #readOnly: boolean;
  /** All lines of a text of which only some are shown, and the index of the first of those. */
  #all: string[] | undefined;
  #first = 0;
  #marks: LineMarks = { current: undefined, diagnosed: new Map() };

  constructor(label: string, readOnly: boolean) {
    this.#readOnly = readOnly;
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
    this.area.addEventListener("scroll", () => this.#scrolled(), { passive: true });
  }

  /** The whole text. */
  get text(): string {
    return this.#all ? this.#text : this.area.value;
  }

  /** Shows a text; the caret stays where it is as far as it can. */
  show(text: string): void {
    if (text.length > MOST_LETTERS) {
      if (text === this.#text) return;
      this.#text = text;
      this.#all = text.split("\n");
      this.#first = Math.max(0, Math.min(this.#first, this.#all.length - EXCERPT));
    } else {
      this.#text = text;
      this.#all = undefined;
      this.#first = 0;
    }
    this.area.readOnly = this.#readOnly || this.#all !== undefined;
    this.area.title = this.#all ? "Of this very long program only some lines are shown." : "";
    this.#fill();
  }

  #fill(): void {
    const lines = this.#all?.slice(this.#first, this.#first + EXCERPT);
    const text = lines ? lines.join("\n") : this.#text;
    if (this.area.value !== text) {
      const { selectionStart, selectionEnd, scrollTop, scrollLeft } = this.area;
      this.area.value = text;
      this.area.setSelectionRange(selectionStart, selectionEnd);
      this.area.scrollTop = scrollTop;
      this.area.scrollLeft = scrollLeft;
    }
    this.#colour(lines ?? text.split("\n"));
    this.#follow();
  }

  /** Shows other lines of a text of which only some are shown, `line` in their middle. */
  #move(line: number): void {
    if (!this.#all) return;
    const first = Math.round(line - EXCERPT / 2);
    this.#first = Math.max(0, Math.min(first, this.#all.length - EXCERPT));
    this.#fill();
    this.mark(this.#marks);
  }

  #scrolled(): void {
    const top = Math.round(this.area.scrollTop / this.#lineHeight());
    const shown = Math.round(this.area.clientHeight / this.#lineHeight());
    const before = this.#first;
    const isAtEnd = top + shown > EXCERPT - RIM && before + EXCERPT < (this.#all?.length ?? 0);
    if (this.#all && (isAtEnd || (top < RIM && before > 0))) {
      this.#move(before + top + shown / 2);
      this.area.scrollTop += (before - this.#first) * this.#lineHeight();
    }
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
    return this.#first + before.split("\n").length;
  }

  /** Scrolls a line into sight. */
  reveal(line: number): void {
    if (this.#all && (line < this.#first + RIM || line > this.#first + EXCERPT - RIM)) {
      this.#move(line);
    }
    const height = this.#lineHeight();
    const top = (line - 1 - this.#first) * height;
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
      const number = String(this.#first + i + 1);
      let copy = this.#copy.children[i];
      if (!copy) {
        copy = element("div");
        this.#copy.append(copy);
        this.#gutter.append(element("div", {}, number));
        this.#markLine(copy, this.#gutter.children[i], i);
      } else {
        const shown = this.#gutter.children[i];
        if (shown && shown.textContent !== number) shown.textContent = number;
        if (this.#lines[i] === line) return;
      }
      copy.replaceChildren(...coloured(line));
    });
    this.#lines = wanted;
  }

  #markLine(copy: Element, number: Element | undefined, index: number): void {
    const line = this.#first + index + 1;
    const severity = this.#marks.diagnosed.get(line);
    for (const place of [copy, number]) {
      place?.classList.toggle("current", this.#marks.current === line);
      place?.classList.toggle("has-error", severity === "error");
      place?.classList.toggle("has-warning", severity === "warning");
    }
  }

  #follow(): void {
    const { scrollTop, scrollLeft } = this.area;
    this.#copy.style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
    this.#gutter.style.transform = `translateY(${-scrollTop}px)`;
  }
}

/** A line as text and coloured spans. */
function coloured(line: string): (Node | string)[] {
  const nodes: (Node | string)[] = [];
  let at = 0;
  for (const match of line.matchAll(TOKENS)) {
    if (match.index > at) nodes.push(line.slice(at, match.index));
    const name = Object.entries(match.groups ?? {}).find(([, text]) => text)?.[0];
    nodes.push(element("span", { class: `t-${name}` }, match[0]));
    at = match.index + match[0].length;
  }
  nodes.push(line.slice(at) || (at === 0 ? "\u200b" : ""));
  return nodes;
}
