// The button that opens the panel of motion, which is loaded with its plots when it is first wanted.

import type { MotionPanel } from "../motion/motion-panel";
import type { Stage } from "../stage";
import type { Store } from "../state";
import { closesOnLong, closesOthers } from "./drawer";
import { element, iconButton } from "./elements";

const ICON = "M5.6 18.4a9 9 0 1 1 12.8 0M12 13l4-4M12 13h.01";

/** Puts the button into the toolbar; returns what is to be called when the scheme changes. */
export function motionButton(
  section: HTMLElement,
  buttons: HTMLElement,
  stage: Stage,
  store: Store,
): () => void {
  const keys = "feed, acceleration and jerk, and how long it takes";
  const button = iconButton("Motion", ICON, keys, "Motion");
  button.setAttribute("aria-expanded", "false");
  button.setAttribute("aria-controls", section.id);
  buttons.append(button);
  let panel: MotionPanel | undefined;
  let loading: Promise<void> | undefined;
  const load = async () => {
    const { MotionPanel } = await import("../motion/motion-panel");
    section.replaceChildren();
    panel = new MotionPanel(section, stage, store);
  };
  const open = async () => {
    try {
      loading ??= load();
      await loading;
      if (!section.hidden) panel?.open();
    } catch {
      // Without a network it may be tried again.
      loading = undefined;
      section.replaceChildren(element("p", { role: "status" }, "The plots could not be loaded."));
    }
  };
  const toggle = () => {
    section.hidden = !section.hidden;
    button.setAttribute("aria-expanded", String(!section.hidden));
    // The picture has another height now, with its next frame.
    stage.fitNext();
    if (section.hidden) panel?.close();
    else open();
  };
  button.addEventListener("click", toggle);
  closesOthers(button);
  // Of a very long program it would take as long as everything else.
  closesOnLong(button, store);
  return () => panel?.recolour();
}
