// The program as editable text: a text area over a coloured copy of its lines, with line numbers.

import { element } from "./elements";

/** Longer texts are shown without colours. */
const MOST_COLOURED_LINES = 3000;
const MOST_COLOURED_LETTERS = 200_000;

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
  #marks: LineMarks = { current: undefined, diagnosed: new Map() };

  constructor(label: string, readOnly: boolean) {
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
    this.#colour(text);
    this.#follow();
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
    return this.area.value.slice(0, this.area.selectionStart).split("\n").length;
  }

  /** Scrolls a line into sight. */
  reveal(line: number): void {
    const height = this.#copy.firstElementChild?.getBoundingClientRect().height ?? 20;
    const top = (line - 1) * height;
    const { scrollTop, clientHeight } = this.area;
    if (top < scrollTop + height || top > scrollTop + clientHeight - 3 * height) {
      this.area.scrollTop = top - clientHeight / 2;
    }
    this.#follow();
  }

  #colour(text: string): void {
    const lines = text.split("\n");
    const plain = lines.length > MOST_COLOURED_LINES || text.length > MOST_COLOURED_LETTERS;
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
      } else if (this.#lines[i] === line) {
        return;
      }
      copy.replaceChildren(...coloured(line));
    });
    this.#lines = wanted;
  }

  #markLine(copy: Element, number: Element | undefined, index: number): void {
    const severity = this.#marks.diagnosed.get(index + 1);
    for (const place of [copy, number]) {
      place?.classList.toggle("current", this.#marks.current === index + 1);
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
