// The file that is shown, which control it is written for, and the compensated program to be saved.

import { setSettings } from "../actions";
import { DIALECTS, isName, PROFILES, TARGETS } from "../controls";
import { counted } from "../counts";
import { type Files, save, savedName } from "../files";
import type { LongText } from "../long-text";
import { INITIAL_SETTINGS, type Settings } from "../parameters";
import { isResultOf } from "../result";
import { linkTo } from "../share";
import type { Store } from "../state";
import { element, icon, iconButton } from "./elements";

const ICONS = {
  open: "M4 18V6h6l2 2h8v2M4 18l2.5-8H22l-2.5 8z",
  link: "M10 14a4 4 0 0 0 6 0l3-3a4.2 4.2 0 0 0-6-6l-1.5 1.5M14 10a4 4 0 0 0-6 0l-3 3a4.2 4.2 0 0 0 6 6l1.5-1.5",
  save: "M12 4v11M7.5 10.5 12 15l4.5-4.5M5 20h14",
} as const;

/** Fills the form of the file and keeps it true to the state. */
export function filePanel(form: HTMLFormElement, files: Files, store: Store): void {
  form.addEventListener("submit", (event) => event.preventDefault());
  const open = element("button", { type: "button", class: "button" }, icon(ICONS.open), "Open");
  open.title = "Open a program or a tool table; or drop it anywhere";
  open.addEventListener("click", () => files.choose());
  const name = element("output", { class: "file-name" });
  const facts = element("small", { class: "file-facts" });
  form.append(
    element(
      "div",
      { class: "file-row" },
      open,
      element("div", { class: "file-what" }, name, facts),
      linkButton(store),
    ),
  );

  const select = <Key extends "profile" | "dialect" | "target">(
    key: Key,
    label: string,
    names: Readonly<Record<string, string>>,
    hint: string,
  ) => {
    const menu = element("select", { "aria-label": label });
    for (const [value, text] of Object.entries(names))
      menu.append(element("option", { value }, text));
    menu.addEventListener("change", () => {
      if (isName(names, menu.value)) setSettings(store, { [key]: menu.value });
    });
    const row = element("label", { class: `field file-${key}`, title: hint });
    row.append(element("span", {}, label), menu);
    return { row, show: () => (menu.value = store.document.settings[key]) };
  };
  const profile = select(
    "profile",
    "Profile",
    PROFILES,
    "The control that the program is written for: whose rules of compensation are followed",
  );
  const dialect = select("dialect", "Read as", DIALECTS, "The language of the program");
  const target = select("target", "Write for", TARGETS, "The control that the result is for");
  const saver = element("button", { type: "button", class: "button main" }, icon(ICONS.save));
  const savedAs = element("span", {}, "Save");
  saver.append(savedAs);
  saver.addEventListener("click", () => {
    const { result } = store.state;
    if (result) save(savedName(store.document), result.long?.code.bytes ?? result.gcode);
  });
  const notice = element("p", { class: "notice", role: "status" });
  form.append(
    element("div", { class: "file-rules" }, profile.row, dialect.row),
    offer(store),
    element("div", { class: "file-row file-save" }, target.row, saver),
    notice,
  );

  const show = () => {
    const { result, notice: said } = store.state;
    const { name: file } = store.document;
    name.textContent = file || "Own program";
    name.title = file;
    const long = isResultOf(result, store.document) ? result?.long : undefined;
    facts.textContent = long ? factsOf(long.text) : "";
    facts.hidden = facts.textContent === "";
    for (const each of [profile, dialect, target]) each.show();
    const as = savedName(store.document);
    savedAs.textContent = "Save";
    saver.setAttribute("aria-label", `Save ${as}`);
    saver.title = `Save the compensated program as ${as}`;
    saver.disabled = !result;
    notice.textContent = said ?? "";
    notice.hidden = said === undefined;
  };
  store.subscribe((state, before) => {
    const { history, result, notice: said } = before;
    if (state.history !== history || state.result !== result || state.notice !== said) show();
  });
  show();
}

/** Offers the rules of the control that the program seems to be written for, as long as none are chosen. */
function offer(store: Store): HTMLElement {
  const seen = element("span");
  const use = element("button", { type: "button", class: "button" });
  const row = element("p", { class: "offer" }, seen, use);
  const control = () => {
    const { result } = store.state;
    // Another profile would be what decides. A result that is not of this very text yet will do.
    if (!result || !isOpen(result.settings) || !isOpen(store.document.settings)) return undefined;
    return result.dialect === "auto" ? undefined : result.dialect;
  };
  use.addEventListener("click", () => {
    const profile = control();
    if (!profile) return;
    setSettings(store, { profile });
    // The button goes, and the focus must not go with it.
    row.parentElement?.querySelector<HTMLElement>(".file-profile select")?.focus();
  });
  const show = () => {
    const found = control();
    row.hidden = !found;
    if (!found) return;
    seen.textContent = `It seems to be written for ${PROFILES[found]}.`;
    use.textContent = `Use ${PROFILES[found]}'s rules`;
  };
  store.subscribe((state, before) => {
    if (state.history !== before.history || state.result !== before.result) show();
  });
  show();
  return row;
}

/** Whether neither rules nor a language are chosen. */
function isOpen({ profile, dialect }: Settings): boolean {
  return profile === INITIAL_SETTINGS.profile && dialect === INITIAL_SETTINGS.dialect;
}

/** A button that copies a link to the program as it is. */
function linkButton(store: Store): HTMLButtonElement {
  const button = iconButton("Copy link", ICONS.link, "to this program and its settings");
  button.addEventListener("click", async () => {
    const link = await linkTo(store.document).catch(() => "");
    if (link === "") {
      store.set({ notice: "This browser cannot pack a program: pass on its file instead." });
      return;
    }
    if (!link) {
      store.set({ notice: "The program is too long for a link: pass on its file instead." });
      return;
    }
    try {
      await navigator.clipboard.writeText(link);
      store.set({ notice: "Copied: a link that holds the program and its settings." });
    } catch {
      // Where the clipboard may not be written, the address bar holds it.
      history.replaceState(null, "", link);
      store.set({ notice: "The address of this page is a link to the program now." });
    }
  });
  return button;
}

function factsOf({ starts, bytes }: LongText): string {
  return `${counted(starts.length, "line")}, ${(bytes.length / 1e6).toFixed(1)} MB`;
}
