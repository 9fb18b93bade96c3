// Numbers in the corner of the picture: where the tool is as it runs, else where the pointer is.

import type { Point } from "../geometry";
import type { Store } from "../state";
import { toWorld, type View } from "../view";

const NAMES = ["X", "Y", "Z"] as const;

/** Keeps the read-out true to the state; returns what tells it of the view and the pointer. */
export function readout(
  output: HTMLElement,
  store: Store,
): (view: View, pointer: Point | undefined) => void {
  let pointed = "";
  const show = () => {
    const { played } = store.state;
    output.textContent = played
      ? NAMES.map((name, axis) => `${name} ${fixed(played.point[axis] as number, 3)}`).join("  ")
      : pointed;
  };
  store.subscribe((state, before) => {
    if (state.played !== before.played) show();
  });
  return (view, pointer) => {
    const digits = Math.min(3, Math.max(0, Math.ceil(Math.log10(view.scale))));
    const at = pointer && toWorld(view, pointer);
    const [right, up] = store.state.result?.axes ?? [0, 1];
    pointed = at
      ? `${NAMES[right]} ${fixed(at[0], digits)}  ${NAMES[up]} ${fixed(at[1], digits)}`
      : "";
    show();
  };
}

/** A number with so many decimals, and no sign where they are all zero. */
function fixed(value: number, digits: number): string {
  return value.toFixed(digits).replace(/^-(?=[0.]*$)/, "");
}
