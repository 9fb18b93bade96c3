// Files: opened by a button or dropped anywhere, and saved; tool tables are taken for the tools.

import { readToolTable, type Target } from "g41";
import { openText, setSettings } from "./actions";
import type { ComputeClient } from "./compute-client";
import { counted } from "./counts";
import { decoded } from "./long-text";
import { isResultOf, LONG, type Result, VERY_LONG } from "./result";
import type { Stage } from "./stage";
import { type Document, NO_PART, type Store } from "./state";

/** Larger files are no programs [bytes]. */
const MOST_BYTES = 256 * 1024 * 1024;

/** What the dialog of files offers. */
const ENDINGS = ".nc,.ngc,.tap,.gcode,.cnc,.txt,.mpf,.spf,.min,.eia,.iso,.ncc,.tbl";

/** Opens files into the document. */
export class Files {
  #store: Store;
  #client: ComputeClient;
  #stage: Stage;
  /** What becomes the document once it was read; until then the page shows what it did. */
  #pending: Document | undefined;

  constructor(store: Store, client: ComputeClient, stage: Stage) {
    this.#store = store;
    this.#client = client;
    this.#stage = stage;
    // Who opens something else meanwhile must not have it replaced when the file was read.
    store.subscribe(({ history }, before) => {
      const { name } = before.history.present;
      if (this.#pending && history.present.name !== name) this.#abandon();
    });
  }

  /** The name of the file that is being opened. */
  get opening(): string | undefined {
    return this.#pending?.name;
  }

  /** Lets files be chosen. */
  choose(): void {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ENDINGS;
    input.multiple = true;
    input.addEventListener("change", () => this.open(input.files ?? []));
    input.click();
  }

  /** Opens a program, a tool table, or both. */
  async open(files: Iterable<File>): Promise<void> {
    this.#store.set({ notice: undefined });
    const all = [...files];
    const tables = all.filter(({ name }) => /\.tbl$/i.test(name));
    const programs = all.filter((file) => !tables.includes(file));
    for (const table of tables) await this.#openTable(table);
    const [program, another] = programs;
    if (program) await this.#openProgram(program);
    if (another) this.#say(`One program at a time: ${program?.name} was opened.`);
  }

  /** Takes the document of a result that was waited for. */
  take(result: Result): void {
    const pending = this.#pending;
    if (!pending || !isResultOf(result, pending)) return;
    this.#pending = undefined;
    this.#stage.fitNext();
    openText(this.#store, pending);
  }

  /** Stops what takes long: what was shown before is shown again. */
  cancel(): void {
    this.#client.cancel();
    const { name } = this.#store.state.work ?? { name: "" };
    const wasOpening = this.#pending !== undefined;
    this.#pending = undefined;
    this.#store.set({ work: undefined, notice: `${name || "The program"}: cancelled.` });
    // The document has changed already where other settings were asked for.
    if (!wasOpening) this.#store.undo();
    else this.#client.ask(this.#store.document);
  }

  /** Says why a file could not be opened; false where none is being opened. */
  fail(message: string): boolean {
    const pending = this.#pending;
    this.#pending = undefined;
    if (pending) this.#store.set({ work: undefined, notice: `${pending.name}: ${message}` });
    return pending !== undefined;
  }

  #abandon(): void {
    this.#pending = undefined;
    this.#client.cancel();
    this.#store.set({ work: undefined });
  }

  async #openProgram(file: File): Promise<void> {
    const { name, size } = file;
    if (size > MOST_BYTES) {
      this.#say(`${name} is too large: ${Math.round(size / 1e6)} MB.`);
      return;
    }
    const { settings } = this.#store.document;
    const empty = { name, text: "", file: undefined, part: NO_PART, partText: "", settings };
    if (size > VERY_LONG) {
      this.#waitFor({ ...empty, file });
      return;
    }
    const bytes = await file.arrayBuffer().catch(() => undefined);
    const found = bytes && decoded(new Uint8Array(bytes));
    if (!found) {
      this.#say(`${name} ${bytes ? "is not a text" : "could not be read"}.`);
      return;
    }
    const document = { ...empty, text: found.text };
    // What is shown already needs no other answer, and gets none.
    if (size > LONG && found.text !== this.#store.document.text) {
      this.#waitFor(document);
      return;
    }
    this.#stage.fitNext();
    openText(this.#store, document);
  }

  /** Asks for what takes long, and shows how far that is. */
  #waitFor(document: Document): void {
    this.#store.set({ work: { name: document.name, step: "Reading", part: 0 } });
    this.#pending = document;
    this.#client.ask({ ...document, isOpening: true });
  }

  async #openTable(file: File): Promise<void> {
    const text = await file.text().catch(() => undefined);
    if (text === undefined) {
      this.#say(`${file.name} could not be read.`);
      return;
    }
    const { tools, diagnostics } = readToolTable(text);
    const [first] = diagnostics;
    const count = Object.keys(tools).length;
    if (count > 0) setSettings(this.#store, { tools });
    const line = first?.origin && "block" in first.origin ? first.origin.block : 0;
    const wrong = first ? ` Line ${line}: ${first.message}.` : "";
    this.#say(`${file.name}: ${counted(count, "tool")} read.${wrong}`);
  }

  #say(notice: string): void {
    this.#store.set({ notice });
  }
}

/** Lets files be dropped anywhere on the page, and shows that they may be. */
export function connectDrops(files: Files): void {
  let depth = 0;
  const holds = (event: DragEvent) => event.dataTransfer?.types.includes("Files") === true;
  const show = (on: boolean) => document.body.classList.toggle("dropping", on);
  window.addEventListener("dragenter", (event) => {
    if (!holds(event)) return;
    event.preventDefault();
    depth += 1;
    show(true);
  });
  window.addEventListener("dragover", (event) => {
    if (holds(event)) event.preventDefault();
  });
  window.addEventListener("dragleave", (event) => {
    if (!holds(event)) return;
    depth = Math.max(0, depth - 1);
    show(depth > 0);
  });
  window.addEventListener("drop", (event) => {
    if (!holds(event)) return;
    event.preventDefault();
    depth = 0;
    show(false);
    // The list of a drop is empty once this has returned.
    void files.open([...(event.dataTransfer?.files ?? [])]);
  });
}

/** The name of a file without its ending. */
function stem(name: string): string {
  return name.replace(/\.[^.]*$/, "") || "part";
}

/** Saves a text, or its bytes, as a file. */
export function save(name: string, text: string | Uint8Array<ArrayBuffer>): void {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

/** What the names of programs end in, where controls look for no others. */
const SAVED: Partial<Record<Target, string>> = {
  heidenhain: "h",
  linuxcnc: "ngc",
  marlin: "gcode",
};

/** The name under which the compensated program is saved. */
export function savedName({ name, settings }: Document): string {
  const { target } = settings;
  return `${stem(name)}.${target}.${SAVED[target] ?? "nc"}`;
}
