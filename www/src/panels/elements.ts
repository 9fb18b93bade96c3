// Makes elements of the page in few words.

type Attributes = Readonly<Record<string, string | number | boolean | undefined>>;

/** Creates an element with attributes and children. */
export function element<K extends keyof HTMLElementTagNameMap>(
  name: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    made.setAttribute(key, value === true ? "" : String(value));
  }
  made.append(...children);
  return made;
}

/** Finds an element that the page is sure to have. */
export function find<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element #${id}`);
  return found as T;
}

/** An icon: a path in a box of 24 by 24. */
export function icon(path: string): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("width", "20");
  svg.setAttribute("height", "20");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(space, "path");
  line.setAttribute("d", path);
  svg.append(line);
  return svg;
}

/** A button that shows an icon and is called `name`; `word` stands beside it where there is room. */
export function iconButton(
  name: string,
  path: string,
  keys: string,
  word?: string,
): HTMLButtonElement {
  const made = element("button", {
    type: "button",
    class: "icon-button",
    title: `${name} (${keys})`,
  });
  made.setAttribute("aria-label", name);
  made.append(icon(path));
  if (word) made.append(element("span", { class: "button-word" }, word));
  return made;
}

/** One of a few values, as radio buttons side by side. */
export class Choice {
  readonly root: HTMLFieldSetElement;
  #inputs: HTMLInputElement[];

  constructor(
    name: string,
    legend: string,
    choices: Readonly<Record<string, string>>,
    onChoose: (value: string) => void,
    details: Readonly<Record<string, string>> = {},
  ) {
    this.root = element("fieldset", { class: "choice" }, element("legend", {}, legend));
    const row = element("div", { class: "choice-row" });
    this.#inputs = Object.entries(choices).map(([value, label]) => {
      const input = element("input", { type: "radio", name, value });
      input.addEventListener("change", () => onChoose(value));
      const text = element("span", {}, label);
      const detail = details[value];
      if (detail) text.append(" ", element("small", {}, detail));
      row.append(element("label", {}, input, text));
      return input;
    });
    this.root.append(row);
  }

  /** Shows a value; undefined shows none. */
  show(value: string | undefined): void {
    for (const input of this.#inputs) input.checked = input.value === value;
  }
}
