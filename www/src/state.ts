// The state of the page: an immutable document with its history, what is selected, and the result.

import type { Point } from "./geometry";
import { amend, begin, type History, record, redo, settle, undo } from "./history";
import type { LivePicture } from "./live/picture";
import type { Settings } from "./parameters";
import type { Part, PointRef } from "./part";
import type { Result } from "./result";

/** What is edited, undone and redone. */
export interface Document {
  /** The name of the file that it was read from; empty where it was none. */
  readonly name: string;
  /** Empty for a very long program, which is where its file is. */
  readonly text: string;
  readonly file: File | undefined;
  /** The part that `partText` programs; behind `text` until the worker has read it. */
  readonly part: Part;
  readonly partText: string;
  readonly settings: Settings;
}

/** Long work under way. */
export interface Work {
  /** What it is about. */
  readonly name: string;
  /** What is being done. */
  readonly step: string;
  /** How much is done, from 0 to 1. */
  readonly part: number;
}

/** Everything that the page shows. */
export interface State {
  readonly history: History<Document>;
  readonly result: Result | undefined;
  /** Why there is no result, if the worker failed. */
  readonly failure: string | undefined;
  readonly selection: PointRef | undefined;
  /** Index of the transition whose construction is shown. */
  readonly corner: number | undefined;
  /** The line of the text that the caret is in, while the text has the focus. */
  readonly caret: number | undefined;
  /** The line of the move below the pointer. */
  readonly hover: number | undefined;
  /** The line of the move that was pointed at last. */
  readonly pointed: number | undefined;
  /** Work that takes long enough to be watched. */
  readonly work: Work | undefined;
  /** What became of the last file, if that must be told. */
  readonly notice: string | undefined;
  /** The key of the diagnostic that was chosen in the list. */
  readonly chosen: string | undefined;
  /** The key of the gouge or the uncut region that is looked at. */
  readonly finding: string | undefined;
  /** Where on its path the tool is shown, as the plot of deviations asks for it. */
  readonly probe: Point | undefined;
  /** Where the tool is as it runs along its path, and on the move of which line of the text. */
  readonly played: Played | undefined;
  /** Whether the moves are shown in space, and not the plane. */
  readonly space: boolean;
  /** The contour that is dragged, as long as it is ahead of the result. */
  readonly live: LivePicture | undefined;
}

/** A place of the tool as it runs. */
export interface Played {
  /** As it is seen. */
  readonly at: Point;
  readonly point: readonly [x: number, y: number, z: number];
  readonly line: number | undefined;
  /** Whether it is on a rapid move, above what it cuts. */
  readonly isRapid: boolean;
}

/** Called after each change, with the state before it. */
export type Listener = (state: State, before: State) => void;

/** An empty part. */
export const NO_PART: Part = { contours: [] };

/** Holds the state; every change goes through it and is told to all listeners. */
export class Store {
  #state: State;
  #listeners: Listener[] = [];

  constructor(document: Document) {
    this.#state = {
      history: begin(document),
      result: undefined,
      failure: undefined,
      selection: undefined,
      corner: undefined,
      caret: undefined,
      hover: undefined,
      pointed: undefined,
      work: undefined,
      notice: undefined,
      chosen: undefined,
      finding: undefined,
      probe: undefined,
      played: undefined,
      space: false,
      live: undefined,
    };
  }

  /** The state as it is now. */
  get state(): State {
    return this.#state;
  }

  /** The document as it is now. */
  get document(): Document {
    return this.#state.history.present;
  }

  /** Tells `listener` of every change. */
  subscribe(listener: Listener): void {
    this.#listeners.push(listener);
  }

  /** Changes parts of the state. */
  set(change: Partial<State>): void {
    const before = this.#state;
    this.#state = { ...before, ...change };
    for (const listener of this.#listeners) listener(this.#state, before);
  }

  /** Edits the document; steps of one gesture are one entry of the history. */
  edit(change: Partial<Document>, gesture?: string, selection = this.#state.selection): void {
    const history = record(this.#state.history, { ...this.document, ...change }, gesture);
    this.set({ history, selection });
  }

  /** Completes the document with what was derived from it, without an entry of its own. */
  amend(change: Partial<Document>): void {
    this.set({ history: amend(this.#state.history, { ...this.document, ...change }) });
  }

  /** Ends a gesture. */
  settle(): void {
    this.set({ history: settle(this.#state.history) });
  }

  /** One step back in the history. */
  undo(): void {
    const history = undo(this.#state.history);
    if (history) this.set({ history });
  }

  /** One step forward in the history. */
  redo(): void {
    const history = redo(this.#state.history);
    if (history) this.set({ history });
  }
}
