// Talks to the worker that draws very long programs. The picture of the last view is shown moved and
// scaled until the next one is there, so that moving and zooming are as fluent as with a small part.

import type { Point } from "../geometry";
import type { Size, View } from "../view";
import type { Answer, Colors, Draw, Drawn, Task } from "./protocol";
import type { Strokes } from "./strokes";

/** Room that is drawn around the view [px]. */
const MARGIN = 120;

/** The moves of one line of the text. */
export interface TracedLine {
  readonly line: number;
  /** x0, y0, x1, y1, …; NaN between two pieces [mm]. */
  readonly points: Float64Array;
}

/** What is told of the answers. */
export interface PictureListeners {
  /** There is another picture, the first of its drawing or not. */
  drawn(first: boolean): void;
  /** What was sought is on a line of the text, or nowhere. */
  found(line: number | undefined): void;
  traced(line: TracedLine): void;
  /** There will be no picture. */
  failed(message: string): void;
}

/** A drawing of a very long program; `draw` may be called at any rate. */
export class PictureClient {
  #worker: Worker | undefined;
  #id = 0;
  #drawn: Drawn | undefined;
  #wanted: Draw | undefined;
  #underWay = false;
  #seeking = false;
  #sought: { at: Point; within: number } | undefined;
  #tell: PictureListeners;

  constructor(listeners: PictureListeners) {
    this.#tell = listeners;
  }

  /** What was drawn last, for those who measure. */
  get last(): { vertices: number; milliseconds: number } | undefined {
    return this.#drawn;
  }

  /** Takes a drawing in, whose arrays are gone after it. */
  load(strokes: readonly Strokes[]): void {
    this.#worker ??= this.#start();
    this.#id += 1;
    this.#forget();
    const transfer = strokes.flatMap(({ points, lines }) => [points.buffer, lines.buffer]);
    this.#worker.postMessage({ kind: "load", id: this.#id, strokes } satisfies Task, {
      transfer: transfer as ArrayBuffer[],
    });
  }

  /** Gives the drawing back, if there is one. */
  clear(): void {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#forget();
  }

  /** Shows the drawing in a view, as sharp as it is known yet. */
  draw(context: CanvasRenderingContext2D, view: View, size: Size, colors: Colors): void {
    const last = this.#drawn;
    if (last) {
      const scale = view.scale / last.view.scale;
      const x = view.x - last.view.x * scale - last.margin * scale;
      const y = view.y - last.view.y * scale - last.margin * scale;
      const width = (last.size.width + 2 * last.margin) * scale;
      const height = (last.size.height + 2 * last.margin) * scale;
      context.drawImage(last.bitmap, x, y, width, height);
    }
    if (last?.view === view && last.size === size && last.colors === colors) return;
    const ratio = devicePixelRatio || 1;
    this.#wanted = { kind: "draw", id: this.#id, view, size, margin: MARGIN, ratio, colors };
    this.#next();
  }

  /** Looks for the move nearest to a point; of several questions only the latest is answered. */
  seek(at: Point, within: number): void {
    this.#sought = { at, within };
    if (!this.#seeking) this.#seekNext();
  }

  /** Asks for the moves of a line of the text. */
  trace(line: number): void {
    this.#worker?.postMessage({ kind: "trace", id: this.#id, line } satisfies Task);
  }

  #forget(): void {
    this.#drawn?.bitmap.close();
    this.#drawn = undefined;
    this.#wanted = undefined;
    this.#underWay = false;
    this.#seeking = false;
    this.#sought = undefined;
  }

  #start(): Worker {
    const worker = new Worker(new URL("./picture.worker.ts", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data }: MessageEvent<Answer>) => this.#take(data));
    worker.addEventListener("error", ({ message }) => {
      // The drawing went with it.
      this.clear();
      this.#tell.failed(message || "the worker could not be started");
    });
    return worker;
  }

  #next(): void {
    if (this.#underWay || !this.#wanted || !this.#worker) return;
    this.#underWay = true;
    this.#worker.postMessage(this.#wanted);
    this.#wanted = undefined;
  }

  #seekNext(): void {
    if (!this.#sought || !this.#worker) return;
    this.#seeking = true;
    this.#worker.postMessage({ kind: "seek", id: this.#id, ...this.#sought } satisfies Task);
    this.#sought = undefined;
  }

  #take(answer: Answer): void {
    // Of a drawing that is gone.
    if (answer.id !== this.#id) return;
    switch (answer.kind) {
      case "drawn": {
        const first = !this.#drawn;
        this.#drawn?.bitmap.close();
        this.#drawn = answer;
        this.#underWay = false;
        this.#next();
        this.#tell.drawn(first);
        break;
      }
      case "found":
        this.#seeking = false;
        this.#seekNext();
        this.#tell.found(answer.line);
        break;
      case "traced":
        this.#tell.traced(answer);
    }
  }
}
