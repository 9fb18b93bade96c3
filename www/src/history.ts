// Undo and redo over immutable documents: one entry per gesture.

/** A document with what came before and what was undone. */
export interface History<T> {
  readonly past: readonly T[];
  readonly present: T;
  readonly future: readonly T[];
  /** The gesture that made the present; its further steps replace it. */
  readonly gesture: string | undefined;
}

/** A history of one document. */
export function begin<T>(present: T): History<T> {
  return { past: [], present, future: [], gesture: undefined };
}

/** Adds a document; one that continues the gesture of the present replaces it. */
export function record<T>(history: History<T>, present: T, gesture?: string): History<T> {
  const continues = gesture !== undefined && gesture === history.gesture;
  const past = continues ? history.past : [...history.past, history.present];
  return { past, present, future: [], gesture };
}

/** Replaces the present without an entry: for what is derived from it. */
export function amend<T>(history: History<T>, present: T): History<T> {
  return { ...history, present };
}

/** Ends the gesture, so that the next step is an entry of its own. */
export function settle<T>(history: History<T>): History<T> {
  return history.gesture === undefined ? history : { ...history, gesture: undefined };
}

/** One step back. */
export function undo<T>({ past, present, future }: History<T>): History<T> | undefined {
  const before = past.at(-1);
  if (before === undefined) return undefined;
  return {
    past: past.slice(0, -1),
    present: before,
    future: [present, ...future],
    gesture: undefined,
  };
}

/** One step forward. */
export function redo<T>({ past, present, future }: History<T>): History<T> | undefined {
  const [after, ...rest] = future;
  if (after === undefined) return undefined;
  return { past: [...past, present], present: after, future: rest, gesture: undefined };
}
