// What opens below the picture takes its height, so one such panel is open at a time.

import type { Store } from "../state";

const buttons: HTMLButtonElement[] = [];

/** Lets a button that opens a panel close the one that another has opened. */
export function closesOthers(button: HTMLButtonElement): void {
  buttons.push(button);
  button.addEventListener("click", () => {
    if (button.getAttribute("aria-expanded") !== "true") return;
    for (const other of buttons) {
      if (other !== button && other.getAttribute("aria-expanded") === "true") other.click();
    }
  });
}

/** Disables a button, and says why, while the program is too long for its panel; closes that with it. */
export function closesOnLong(button: HTMLButtonElement, store: Store): void {
  const { title } = button;
  const name = button.getAttribute("aria-label");
  store.subscribe((state) => {
    const isLong = state.history.present.file !== undefined;
    if (isLong === button.disabled) return;
    // A panel whose button is disabled could not be closed, and shows the program before.
    if (isLong && button.getAttribute("aria-expanded") === "true") button.click();
    button.disabled = isLong;
    button.title = isLong ? `${name}: the program is too long for it` : title;
  });
}
