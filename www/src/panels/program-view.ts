// A program as text: in an editor, or where it is too long for one as a list of its lines.

import { type LongText, longText } from "../long-text";
import { Editor, type LineMarks } from "./editor";
import { LineView } from "./line-view";

/** A text area of more letters than this takes seconds to be laid out. */
const MOST_LETTERS = 200_000;

/** A text that is edited, or looked at. */
export class ProgramView {
  readonly editor: Editor;
  readonly list: LineView;
  /** Whether the list shows it. */
  #isListed = false;
  #text: string | LongText = "";

  /** `onLine` is called with a line that was gone to; `onNumber` with one whose number was clicked. */
  constructor(
    label: string,
    id: string,
    readOnly: boolean,
    onLine: (line: number) => void,
    onNumber: (line: number) => void,
  ) {
    this.editor = new Editor(label, readOnly, onNumber);
    this.list = new LineView(label, id, { onLine });
  }

  /** Both, of which one is seen. */
  get roots(): [HTMLElement, HTMLElement] {
    return [this.editor.root, this.list.root];
  }

  /** The whole text, or its bytes. */
  get text(): string | Uint8Array<ArrayBuffer> {
    return typeof this.#text === "string" ? this.#text : this.#text.bytes;
  }

  /** Shows a text. */
  show(text: string | LongText): void {
    this.#isListed = typeof text !== "string" || text.length > MOST_LETTERS;
    this.editor.root.hidden = this.#isListed;
    this.list.root.hidden = !this.#isListed;
    if (typeof text === "string" && !this.#isListed) {
      this.list.show(undefined);
      this.editor.show(text);
    } else if (text !== this.#text) {
      this.list.show(typeof text === "string" ? longText(new TextEncoder().encode(text)) : text);
    }
    this.#text = text;
  }

  /** Marks lines. */
  mark(marks: LineMarks): void {
    (this.#isListed ? this.list : this.editor).mark(marks);
  }

  /** Scrolls a line into sight. */
  reveal(line: number): void {
    (this.#isListed ? this.list : this.editor).reveal(line);
  }
}
