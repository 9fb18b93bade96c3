// Dragging a point: the picture follows at once, and the text as soon as it can.
//
// Of a program of a usual length the text is written at every step, and the whole of it is computed
// with it. Of a very long one the text waits until the drag pauses, since writing and reading a
// hundred thousand blocks takes many frames, where moving one of their points takes none.

import { move, rounded } from "../actions";
import { movePoint } from "../edits";
import type { Point } from "../geometry";
import type { Contour, Part, PointRef } from "../part";
import { type Result, radiusOn } from "../result";
import type { Store } from "../state";
import { editsBetween, isInner, type LiveClient } from "./live-client";

/** Letters of a program from which on it is very long. */
const LONG = 60_000;
/** A drag that rests for this long pauses [ms]. */
const PAUSE = 500;

/** Drags points of the document, one at a time. */
export class Drag {
  #store: Store;
  #client: LiveClient;
  /** The contour as it was taken hold of. */
  #held: Contour | undefined;
  /** What is not written yet. */
  #unwritten: { ref: PointRef; to: Point; gesture: string; step: number | undefined } | undefined;
  #timer = 0;

  constructor(store: Store, client: LiveClient) {
    this.#store = store;
    this.#client = client;
  }

  /** Whether the picture is ahead of the text. */
  get isAhead(): boolean {
    return this.#unwritten !== undefined;
  }

  /** Takes hold of a point. */
  begin(ref: PointRef): void {
    const { document, state } = this.#store;
    const { result } = state;
    const programmed = result?.contours[ref.contour];
    const contour = document.part.contours[ref.contour];
    // The worker may know a text already that the part is behind of, or the other way round.
    if (!result || !programmed || !contour?.editable || result.text !== document.partText) return;
    this.#held = contour;
    const radius = radiusOn(result, ref.contour);
    this.#client.grab(ref.contour, programmed, document.settings, radius);
  }

  /** Moves the point that is held; the steps of one gesture are undone together. */
  step(ref: PointRef, to: Point, gesture: string, step?: number): void {
    const { document } = this.#store;
    const at = rounded(to, step);
    if (this.#held) {
      const edits = isInner(this.#held, ref)
        ? [{ kind: "move" as const, segment: ref.segment, index: ref.index, to: at }]
        : editsOf(document.part, this.#held, ref, at);
      if (edits) this.#client.step(edits, ref, at);
      if (edits && document.text.length > LONG) {
        this.#unwritten = { ref, to, gesture, step };
        this.#waitForPause();
        return;
      }
    }
    move(this.#store, ref, to, gesture, step);
  }

  #waitForPause(): void {
    clearTimeout(this.#timer);
    const due = performance.now() + PAUSE;
    this.#timer = window.setTimeout(() => {
      // Late is what the page was busy for: the pointer may have moved meanwhile.
      if (performance.now() > due + PAUSE / 4) this.#waitForPause();
      else this.write();
    }, PAUSE);
  }

  /** Lets go of the point. */
  end(): void {
    this.write();
    this.#held = undefined;
  }

  /** Writes what the picture is ahead by. */
  write(): void {
    clearTimeout(this.#timer);
    const unwritten = this.#unwritten;
    this.#unwritten = undefined;
    if (!unwritten) return;
    const { ref, to, gesture, step } = unwritten;
    move(this.#store, ref, to, gesture, step);
  }

  /** Takes note of a result: what is held is what it says, as far as it came of the drag. */
  take(result: Result): void {
    const { document, state } = this.#store;
    if (result.text !== document.text || this.#unwritten) return;
    if (state.live) this.#client.hold(result.contours[state.live.contour]);
    this.#store.set({ live: undefined });
  }
}

/** What moving a point changes in the contour that was taken hold of. */
function editsOf(part: Part, held: Contour, ref: PointRef, to: Point) {
  const contours = part.contours.map((other, i) => (i === ref.contour ? held : other));
  const moved = movePoint({ contours }, ref, to).contours[ref.contour];
  return moved && editsBetween(held, moved);
}
