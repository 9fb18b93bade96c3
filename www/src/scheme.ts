// The light and the dark scheme: what the system asks for, unless a button says otherwise.

/** A scheme of colours. */
export type Scheme = "light" | "dark";

const KEY = "g41.scheme";

/** Connects the button, and tells of each change of scheme. */
export function connectScheme(button: HTMLElement, onScheme: (scheme: Scheme) => void): void {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const chosen = () => document.documentElement.dataset.scheme as Scheme | undefined;
  const current = (): Scheme => chosen() ?? (system.matches ? "dark" : "light");
  const show = () => {
    button.setAttribute("aria-pressed", String(current() === "dark"));
    onScheme(current());
  };
  button.addEventListener("click", () => {
    const next: Scheme = current() === "dark" ? "light" : "dark";
    document.documentElement.dataset.scheme = next;
    try {
      localStorage.setItem(KEY, next);
    } catch {
      // Where storage is forbidden, the choice lasts as long as the page.
    }
    show();
  });
  system.addEventListener("change", show);
  show();
}
