// A very long program as text: of its lines only those that are seen are there, numbered and marked.

import { type LongText, lineAt } from "../long-text";
import type { LineMarks } from "./editor";
import { element } from "./elements";
import { coloured } from "./line";

/** Height of a line [px]. */
const LINE = 20;
/** Room above the first line [px]. */
const PAD = 8;
/** Browsers lay out elements up to some 17 million px; more lines are scrolled by their share. */
const MOST_HEIGHT = 8_000_000;
/** Lines above and below those that are seen. */
const SPARE = 8;

/** What happens to a line. */
export interface LineListener {
  /** The keyboard or the pointer has gone to a line. */
  onLine(line: number): void;
}

/** A scrolling list of lines, one of which is current. */
export class LineView {
  readonly root: HTMLElement;
  #rows: HTMLElement;
  #spacer: HTMLElement;
  #text: LongText | undefined;
  #marks: LineMarks = { current: undefined, hovered: undefined, diagnosed: new Map() };
  /** The first line that is seen, counted from 0, with its fraction. */
  #top = 0;
  /** Where the scroll bar was put, so that its event is told from the user's. */
  #scrollTop = 0;
  #frame = 0;
  #id: string;

  constructor(label: string, id: string, listener: LineListener) {
    this.#id = id;
    this.#rows = element("div", { class: "rows", role: "presentation" });
    this.#spacer = element("div", { class: "spacer", role: "presentation" }, this.#rows);
    this.root = element(
      "div",
      { class: "line-view", role: "listbox", tabindex: 0, "aria-label": label, hidden: true },
      this.#spacer,
    );
    this.root.addEventListener("scroll", () => this.#scrolled(), { passive: true });
    this.root.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    this.root.addEventListener("click", (event) => {
      const row = (event.target as Element).closest<HTMLElement>("[data-line]");
      if (row) listener.onLine(Number(row.dataset.line));
    });
    this.root.addEventListener("keydown", (event) => {
      const line = this.#lineFor(event.key);
      if (line === undefined) return;
      event.preventDefault();
      listener.onLine(line);
      this.reveal(line);
    });
    new ResizeObserver(() => this.#scrollTo(this.#top)).observe(this.root);
  }

  /** Shows a text; the place in it stays as far as it can. */
  show(text: LongText | undefined): void {
    if (text === this.#text) return;
    this.#text = text;
    this.#spacer.style.height = `${this.#height}px`;
    this.root.style.setProperty("--digits", String(this.#count).length.toString());
    this.#scrollTo(Math.min(this.#top, this.#last));
  }

  /** Marks lines. */
  mark(marks: LineMarks): void {
    this.#marks = marks;
    this.#draw();
  }

  /** Scrolls a line into sight. */
  reveal(line: number): void {
    const seen = this.root.clientHeight / LINE;
    if (line - 1 < this.#top + 1 || line > this.#top + seen - 2) {
      this.#scrollTo(line - 1 - seen / 2);
    }
  }

  get #count(): number {
    return this.#text?.starts.length ?? 0;
  }

  /** Height of all lines as it is laid out [px]. */
  get #height(): number {
    return Math.min(MOST_HEIGHT, this.#count * LINE + 2 * PAD);
  }

  /** The first line that is seen when the last one is. */
  get #last(): number {
    return Math.max(0, this.#count - (this.root.clientHeight - 2 * PAD) / LINE);
  }

  #scrollTo(top: number): void {
    this.#top = Math.min(this.#last, Math.max(0, top));
    const room = this.#height - this.root.clientHeight;
    this.#scrollTop = this.#last > 0 ? (this.#top / this.#last) * Math.max(0, room) : 0;
    this.root.scrollTop = this.#scrollTop;
    this.#scrollTop = this.root.scrollTop;
    this.#draw();
  }

  #scrolled(): void {
    const { scrollTop } = this.root;
    if (Math.abs(scrollTop - this.#scrollTop) >= 1) {
      const room = Math.max(1, this.#height - this.root.clientHeight);
      this.#top = (scrollTop / room) * this.#last;
      this.#scrollTop = scrollTop;
    }
    this.#draw();
  }

  #wheel(event: WheelEvent): void {
    // Sideways, and where a pixel is a pixel, the browser scrolls.
    if (event.ctrlKey || this.#height < MOST_HEIGHT || event.deltaY === 0) return;
    event.preventDefault();
    const lines =
      event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY : event.deltaY / LINE;
    this.#scrollTo(this.#top + lines);
  }

  #lineFor(key: string): number | undefined {
    const now = this.#marks.current ?? Math.floor(this.#top);
    const page = Math.max(1, Math.floor(this.root.clientHeight / LINE) - 1);
    const steps: Readonly<Record<string, number>> = {
      ArrowUp: now - 1,
      ArrowDown: now + 1,
      PageUp: now - page,
      PageDown: now + page,
      Home: 1,
      End: this.#count,
    };
    const line = steps[key];
    return line === undefined ? undefined : Math.min(this.#count, Math.max(1, line));
  }

  #draw(): void {
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#fill();
    });
  }

  #fill(): void {
    const seen = Math.ceil(this.root.clientHeight / LINE);
    if (seen === 0) return;
    const first = Math.max(0, Math.floor(this.#top) - SPARE);
    const end = Math.min(this.#count, Math.floor(this.#top) + seen + SPARE);
    const rows: HTMLElement[] = [];
    for (let i = first; i < end; i += 1) rows.push(this.#row(i));
    this.#rows.replaceChildren(...rows);
    const shift = this.#scrollTop + PAD - (this.#top - first) * LINE;
    this.#rows.style.transform = `translateY(${shift}px)`;
    const { current } = this.#marks;
    const isThere = current !== undefined && current > first && current <= end;
    if (isThere) this.root.setAttribute("aria-activedescendant", this.#name(current));
    else this.root.removeAttribute("aria-activedescendant");
  }

  #row(index: number): HTMLElement {
    const line = index + 1;
    const { current, hovered, diagnosed } = this.#marks;
    const found = diagnosed.get(line);
    const states = [
      line === current ? "current" : "",
      line === hovered ? "hovered" : "",
      found ? `has-${found.severity}` : "",
    ];
    const copy = element("span", { class: "row-text", "data-remark": found?.message });
    if (this.#text) copy.append(...coloured(lineAt(this.#text, index)));
    return element(
      "div",
      {
        class: ["row", ...states].filter(Boolean).join(" "),
        role: "option",
        id: this.#name(line),
        "data-line": line,
        "aria-selected": String(line === current),
        "aria-setsize": this.#count,
        "aria-posinset": line,
        title: found?.message,
      },
      element("span", { class: "row-number", "aria-hidden": "true" }, String(line)),
      copy,
    );
  }

  #name(line: number): string {
    return `${this.#id}-${line}`;
  }
}
