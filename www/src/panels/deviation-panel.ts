// The plot of deviations: how far the tool path is from the true equidistant, along the contour.

import type { Deviation } from "../deviation";
import type { Deviations } from "../deviation.worker";
import { format } from "../expression";
import type { Point } from "../geometry";
import type { Stage } from "../stage";
import type { Store } from "../state";
import { gridStep } from "../view";
import { closesOnLong, closesOthers } from "./drawer";
import { element, iconButton } from "./elements";

const ICON = "M4 19h16M4 19V5M7 13c2-7 4-7 5-2s3 6 4 1 2-5 4-5";
const SVG = "http://www.w3.org/2000/svg";

/** Changes that follow each other faster are measured once [ms]. */
const PAUSE = 120;

/** The size of one plot, and the room beside it for numbers [px]. */
const HEIGHT = 84;
const LEFT = 58;
const RIGHT = 12;

/** Which part of the samples decides about the range: a gouge must not flatten everything else. */
const SHARE = 0.98;

/** Micrometres of a millimetre. */
const MICRO = 1000;

const METHODS = [
  { key: "exact", name: "Exact" },
  { key: "typePoints", name: "Type points" },
] as const;

/** Fills the section of the plot, and puts the button that opens it into the toolbar. */
export function deviationPanel(
  section: HTMLElement,
  buttons: HTMLElement,
  stage: Stage,
  store: Store,
): void {
  const button = iconButton("Deviation plot", ICON, "how far the path is off", "Deviation");
  button.setAttribute("aria-expanded", "false");
  button.setAttribute("aria-controls", section.id);
  buttons.append(button);
  const note = element(
    "p",
    { class: "deviation-note" },
    "Distance of the tool centre from its segment, less the radius, against the arc length of the contour: positive leaves material, negative cuts too deep.",
  );
  const plots = element("div", { class: "deviation-plots" });
  const failure = element("p", { class: "deviation-failure", role: "status" });
  const nothing = element(
    "p",
    { class: "deviation-nothing", role: "status", hidden: true },
    "Nothing here is compensated, so there is no deviation to be measured.",
  );
  const title = element("h2", {}, "Deviation from the equidistant, µm");
  section.append(title, note, nothing, failure, plots);

  let worker: Worker | undefined;
  let measured: Deviations | undefined;
  let underWay = false;
  let wanted = false;
  let timer = 0;
  /** Whether the plots are new, and with them the height of the picture. */
  let opening = false;

  const ask = () => {
    if (section.hidden || store.document.file) return;
    wanted = true;
    if (underWay) return;
    worker ??= start();
    wanted = false;
    underWay = true;
    section.setAttribute("aria-busy", "true");
    worker.postMessage({ text: store.document.text, settings: store.document.settings });
  };
  const start = () => {
    const made = new Worker(new URL("../deviation.worker.ts", import.meta.url), { type: "module" });
    const take = (data: Deviations | string) => {
      underWay = false;
      const failed = typeof data === "string";
      // Of nothing, plots would say that all of it is within the tolerance.
      const isEmpty = !failed && data.length === 0;
      nothing.hidden = !isEmpty;
      failure.textContent = failed ? data : "";
      measured = failed || isEmpty ? undefined : data;
      // What was measured before is of another program.
      if (!measured) plots.replaceChildren();
      else draw();
      if (wanted) ask();
      else section.setAttribute("aria-busy", "false");
    };
    made.addEventListener("message", ({ data }: MessageEvent<Deviations | string>) => take(data));
    made.addEventListener("error", ({ message }) => {
      made.terminate();
      worker = undefined;
      take(message || "the worker could not be started");
    });
    return made;
  };
  const draw = () => {
    const found = measured;
    if (!found || section.hidden) return;
    const width = Math.max(240, plots.clientWidth);
    const look = (at: Point | undefined) => store.set({ probe: at });
    if (opening) stage.fitNext();
    opening = false;
    plots.replaceChildren(
      ...METHODS.map(({ key, name }) => plot(name, found[key], found, width, look)),
    );
  };

  const toggle = () => {
    section.hidden = !section.hidden;
    button.setAttribute("aria-expanded", String(!section.hidden));
    store.set({ probe: undefined });
    // The picture has another height now, with its next frame.
    stage.fitNext();
    opening = !section.hidden;
    plots.replaceChildren();
    measured = undefined;
    ask();
    draw();
  };
  button.addEventListener("click", toggle);
  closesOthers(button);
  // Of a very long program it would take as long as everything else.
  closesOnLong(button, store);
  new ResizeObserver(draw).observe(section);
  store.subscribe((state, before) => {
    const { text, settings } = state.history.present;
    const old = before.history.present;
    if (text === old.text && settings === old.settings) return;
    clearTimeout(timer);
    timer = window.setTimeout(ask, PAUSE);
  });
}

/** One plot as a figure: its worst value in words, band, curve, and a cross hair. */
function plot(
  name: string,
  deviation: Deviation,
  { length, ends, tolerance }: Deviations,
  width: number,
  look: (at: Point | undefined) => void,
): HTMLElement {
  const { s, d, places, worst } = deviation;
  const range = Math.max(1.6 * tolerance, 1.15 * usual(d));
  const right = width - RIGHT;
  const x = (at: number) => LEFT + (at / Math.max(length, 1e-9)) * (right - LEFT);
  const y = (off: number) => {
    const share = Math.max(-1, Math.min(1, off / range));
    return HEIGHT / 2 - share * (HEIGHT / 2 - 6);
  };
  const svg = shape("svg", { width, height: HEIGHT + 18, viewBox: `0 0 ${width} ${HEIGHT + 18}` });
  const inside = Math.abs(worst) <= tolerance;
  const words = `${name}: at most ${micro(Math.abs(worst))} µm off, ${inside ? "within" : "beyond"} the tolerance of ${micro(tolerance)} µm`;
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", words);
  const band = {
    x: LEFT,
    width: right - LEFT,
    y: y(tolerance),
    height: Math.max(1, y(-tolerance) - y(tolerance)),
  };
  svg.append(shape("rect", { class: "band", ...band }));
  for (const end of ends) {
    svg.append(shape("path", { class: "joint", d: `M${x(end)} 4V${HEIGHT - 4}` }));
  }
  svg.append(shape("path", { class: "zero", d: `M${LEFT} ${y(0)}H${right}` }));
  for (const off of ticks(range, tolerance)) {
    const text = `${off > 0 ? "+" : off < 0 ? "−" : ""}${micro(Math.abs(off))}`;
    svg.append(label(text, LEFT - 8, y(off) + 4, "end"));
  }
  const step = gridStep((right - LEFT) / Math.max(length, 1e-9), 70);
  for (let at = 0; at <= length + 1e-9; at += step) {
    const end = at + step > length;
    svg.append(
      label(end ? `${format(at)} mm` : format(at), x(at), HEIGHT + 14, end ? "end" : "middle"),
    );
  }
  svg.append(shape("path", { class: "curve", d: curve(s, d, x, y) }));
  const cross = shape("path", { class: "cross", d: "" });
  svg.append(cross);
  const said = element("small", { class: "deviation-at" });
  const caption = element(
    "figcaption",
    {},
    element("strong", {}, name),
    " ",
    worstInWords(worst, tolerance),
    said,
  );

  const nearest = (at: number) => {
    let best = -1;
    s.forEach((each, i) => {
      if (best < 0 || Math.abs(each - at) < Math.abs((s[best] as number) - at)) {
        if (!Number.isNaN(each)) best = i;
      }
    });
    return best;
  };
  svg.addEventListener("pointermove", (event) => {
    const px = event.clientX - svg.getBoundingClientRect().left;
    const i = nearest(((px - LEFT) / (right - LEFT)) * length);
    if (i < 0) return;
    const [at, off] = [s[i] as number, d[i] as number];
    cross.setAttribute("d", `M${x(at)} 2V${HEIGHT - 2}M${x(at) - 4} ${y(off)}h8`);
    said.textContent = `at ${at.toFixed(2)} mm: ${off < 0 ? "−" : "+"}${micro(Math.abs(off))} µm`;
    look([places[2 * i] as number, places[2 * i + 1] as number]);
  });
  svg.addEventListener("pointerleave", () => {
    cross.setAttribute("d", "");
    said.textContent = "";
    look(undefined);
  });
  return element("figure", { class: "deviation-plot" }, caption, svg);
}

function worstInWords(worst: number, tolerance: number): HTMLElement {
  const inside = Math.abs(worst) <= tolerance;
  const text = `at most ${micro(Math.abs(worst))} µm, ${inside ? "within" : "beyond"} ±${micro(tolerance)} µm`;
  return element("span", { class: inside ? "inside" : "beyond" }, text);
}

/** The deviation that nearly all samples keep to. */
function usual(d: Float64Array): number {
  const sizes = d.filter((off) => !Number.isNaN(off)).map(Math.abs);
  sizes.sort();
  return sizes[Math.floor(SHARE * (sizes.length - 1))] ?? 0;
}

/** Where numbers stand on the axis of deviations: the band, and further out what is left room for. */
function ticks(range: number, tolerance: number): number[] {
  // The largest of 1, 2 and 5 times a power of ten that has room; 0.36 finds one always.
  const step = [0.95, 0.7, 0.5, 0.36]
    .map((share) => gridStep(1 / range, share))
    .find((size) => size <= 0.95 * range);
  const sizes = tolerance > 0.3 * range || step === undefined ? [tolerance] : [step];
  return [0, ...sizes.flatMap((size) => [size, -size])].filter((off) => Math.abs(off) <= range);
}

/** The curve, of samples in one column of pixels only the first, the extremes and the last. */
function curve(
  s: Float64Array,
  d: Float64Array,
  x: (at: number) => number,
  y: (off: number) => number,
): string {
  let text = "";
  let pen = false;
  let column = { at: Number.NaN, low: 0, high: 0, last: 0 };
  const flush = () => {
    if (Number.isNaN(column.at)) return;
    const { at, low, high, last } = column;
    for (const value of low === high ? [last] : [low, high, last])
      text += `L${at} ${value.toFixed(2)}`;
  };
  for (let i = 0; i < s.length; i += 1) {
    const at = Math.round(2 * x(s[i] as number)) / 2;
    const value = y(d[i] as number);
    if (Number.isNaN(at)) {
      flush();
      column = { at, low: 0, high: 0, last: 0 };
      pen = false;
    } else if (!pen) {
      text += `M${at} ${value.toFixed(2)}`;
      column = { at, low: value, high: value, last: value };
      pen = true;
    } else if (at === column.at) {
      const { low, high } = column;
      column = { at, low: Math.min(low, value), high: Math.max(high, value), last: value };
    } else {
      flush();
      column = { at, low: value, high: value, last: value };
    }
  }
  flush();
  return text;
}

/** A length in micrometres with three digits that count. */
function micro(value: number): string {
  const size = value * MICRO;
  if (size >= 100) return size.toFixed(0);
  const digits = Math.min(9, Math.max(0, 2 - Math.floor(Math.log10(Math.max(size, 1e-7)))));
  return format(size, digits);
}

function shape(name: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

function label(text: string, x: number, y: number, anchor: "end" | "middle"): SVGElement {
  const made = shape("text", { x, y, "text-anchor": anchor });
  made.textContent = text;
  return made;
}
