// What opens below the picture takes its height, so one such panel is open at a time.

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
