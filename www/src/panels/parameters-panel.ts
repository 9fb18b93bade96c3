// The controls of the parameters, made from their table.

import { setSettings, setSide } from "../actions";
import { format } from "../expression";
import {
  type ChoiceParameter,
  clampParameter,
  type NumberParameter,
  PARAMETERS,
  type Settings,
} from "../parameters";
import type { Store } from "../state";
import { Choice, element } from "./elements";
import { namedToolsOffer } from "./named-tools-offer";
import { NumberField } from "./number-field";

/** Fills the form of parameters and keeps it true to the state. */
export function parametersPanel(form: HTMLElement, store: Store): void {
  form.addEventListener("submit", (event) => event.preventDefault());
  const shows = PARAMETERS.map((parameter) => {
    const row = element("div", {
      class: `parameter parameter-${parameter.key}`,
      title: parameter.hint,
    });
    form.append(row);
    const showValue =
      parameter.kind === "number"
        ? numberRow(row, parameter, store)
        : choiceRow(row, parameter, store);
    return () => {
      row.hidden = parameter.matters?.(store.document.settings) === false;
      showValue();
    };
  });
  // The radius of a program that states its own cannot be chosen here.
  const stated = element("p", { class: "stated" });
  form.querySelector(".parameter-radius")?.after(stated, namedToolsOffer(store));
  const show = () => {
    for (const each of shows) each();
    const radii = (store.state.result?.contours ?? []).flatMap(({ radius }) => radius ?? []);
    stated.hidden = radii.length === 0;
    stated.textContent = `The program states its own: ${radii.map((r) => format(r)).join(", ")} mm`;
  };
  store.subscribe((state, before) => {
    if (state.history !== before.history || state.result !== before.result) show();
  });
  show();
}

function choiceRow(row: HTMLElement, parameter: ChoiceParameter, store: Store): () => void {
  const { key, label, choices, details } = parameter;
  const choose = (value: string) => {
    if (key === "side") setSide(store, value as "left" | "right");
    else setSettings(store, { [key]: value } as Partial<Settings>);
  };
  const choice = new Choice(key, label, choices, choose, details);
  row.append(choice.root);
  return () => {
    const side = store.document.part.contours[0]?.side ?? store.state.result?.contours[0]?.side;
    choice.show(key === "side" ? side : store.document.settings[key]);
    // Of a very long program the text is not edited, and of some there is no side to change.
    const { result } = store.state;
    const hasNone = result !== undefined && result.contours.length === 0;
    if (key === "side") choice.root.disabled = store.document.file !== undefined || hasNone;
  };
}

function numberRow(row: HTMLElement, parameter: NumberParameter, store: Store): () => void {
  const { key, label, unit, slider } = parameter;
  const enter = (value: number, gesture?: string) => {
    const clamped = clampParameter(parameter, value);
    if (clamped !== undefined) setSettings(store, { [key]: clamped }, gesture);
  };
  const field = new NumberField({
    label,
    unit,
    step: slider?.step ?? parameter.step,
    digits: 4,
    range: parameter,
    onValue: enter,
  });
  row.append(field.root);
  const range = slider && element("input", { type: "range", ...slider, "aria-label": label });
  if (range) {
    let slides = 0;
    range.addEventListener("pointerdown", () => {
      slides += 1;
    });
    range.addEventListener("input", () => enter(range.valueAsNumber, `slide ${slides}`));
    range.addEventListener("change", () => store.settle());
    row.append(range);
  }
  return () => {
    const value = store.document.settings[key];
    field.show(value);
    if (range && document.activeElement !== range) range.value = String(value);
    else if (range && range.valueAsNumber !== value) range.value = String(value);
    if (range) {
      const share =
        (range.valueAsNumber - Number(range.min)) / (Number(range.max) - Number(range.min));
      range.style.setProperty("--share", `${share * 100}%`);
      range.setAttribute("aria-valuetext", `${value} ${unit}`);
    }
  };
}
