// The plots of feed, acceleration and jerk, with their limits as lines and one cursor for all.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { grouped } from "../counts";
import { element } from "../panels/elements";
import type { MotionData } from "./protocol";
import { curves, indexAt } from "./samples";

/** What the plots are drawn against. */
export type Across = "time" | "length";

/** What the plots tell of the pointer on them. */
export interface PlotListeners {
  /** The sample below the pointer; undefined where it has left. */
  look(index: number | undefined): void;
  /** A sample was clicked. */
  seek(index: number): void;
}

/** A curve of a plot. */
interface Line {
  readonly name: string;
  /** The colour, by its name in the style. */
  readonly color: string;
  readonly dash?: number[];
  /** Whether it is constant along each move. */
  readonly stepped?: boolean;
  /** Its value at a sample. */
  readonly of: (data: MotionData, index: number) => number;
}

interface Plot {
  readonly title: string;
  readonly unit: string;
  readonly lines: readonly Line[];
  /** Lines at which limits lie. */
  readonly limits: (data: MotionData) => readonly number[];
  /** The least and the largest value that is shown. */
  readonly range: (data: MotionData) => readonly [number, number];
}

/** The size of a plot, and the room beside it for numbers [px]. */
const HEIGHT = 72;
/** The same on a low screen, where all three are to be in sight [px]. */
const LOW_HEIGHT = 52;
const LOW = "(min-width: 901px) and (max-height: 780px)";
const LEFT = 58;
const RIGHT = 12;
const AXIS = 22;

/** How far the pointer moves before a press is a drag, which looks closer [px]. */
const DRAG = 6;

/** Room above a limit. */
const ABOVE = 1.08;

const PLOTS: readonly Plot[] = [
  {
    title: "Feed",
    unit: "mm/min",
    lines: [
      {
        name: "allowed",
        color: "--error",
        dash: [4, 3],
        stepped: true,
        of: ({ feeds, step }, i) => 60 * (feeds[step[i] as number] as number),
      },
      { name: "reached", color: "--accent", of: ({ velocity }, i) => 60 * (velocity[i] as number) },
    ],
    limits: ({ limits }) => [60 * limits.velocity],
    range: (data) => [0, ABOVE * 60 * cuttingFeed(data)],
  },
  {
    title: "Acceleration",
    unit: "mm/s²",
    lines: [
      { name: "across", color: "--path", of: ({ normal }, i) => normal[i] as number },
      { name: "along", color: "--accent", of: ({ tangential }, i) => tangential[i] as number },
    ],
    limits: ({ limits }) => [limits.acceleration, -limits.acceleration],
    range: (data) => {
      const most = largest(data.limits.acceleration, data.tangential, data.normal);
      return [-ABOVE * most, ABOVE * most];
    },
  },
  {
    title: "Jerk",
    unit: "mm/s³",
    lines: [{ name: "size", color: "--accent", of: ({ jerk }, i) => jerk[i] as number }],
    limits: ({ limits }) => [limits.jerk],
    range: (data) => [0, ABOVE * largest(data.limits.jerk, data.jerk)],
  },
];

/** Three plots, one above the other. */
export class Plots {
  readonly root = element("div", { class: "motion-plots" });
  #tell: PlotListeners;
  #plots: { plot: uPlot; head: HTMLElement; said: HTMLElement }[] = [];
  #data: MotionData | undefined;
  #across: Across = "time";
  /** The samples that are shown. */
  #window: readonly [number, number] = [0, 0];
  #index: number | undefined;
  #head: number | undefined;

  constructor(listeners: PlotListeners) {
    this.#tell = listeners;
    new ResizeObserver(() => this.#resize()).observe(this.root);
  }

  /** Shows another motion, or the same against something else. */
  show(data: MotionData, across: Across): void {
    const isOther = data.time.length !== this.#data?.time.length || across !== this.#across;
    this.#data = data;
    this.#across = across;
    if (isOther || this.#plots.length === 0) this.#window = [0, data.time.length];
    // What was pointed at, or played, may lie behind the end of a shorter motion.
    const last = data.time.length - 1;
    const within = (at?: number) => (at === undefined || last < 0 ? undefined : Math.min(at, last));
    this.#index = within(this.#index);
    this.#make();
    this.mark(within(this.#head));
  }

  /** Draws everything in the colours of the style as they are now. */
  recolour(): void {
    for (const { plot } of this.#plots) plot.redraw(false);
  }

  /** Shows the values at a sample, and the cursor there unless the pointer put it there. */
  point(index: number | undefined, byPointer = false): void {
    this.#index = index;
    const at = index === undefined ? undefined : this.#channel()[index];
    for (const [i, { plot, said }] of this.#plots.entries()) {
      said.textContent = index === undefined ? "" : this.#words(i, index);
      if (byPointer) continue;
      const left = at === undefined ? -10 : plot.valToPos(at, "x");
      plot.setCursor({ left, top: at === undefined ? -10 : 0 }, false);
    }
  }

  /** Puts the line of the player at a sample. */
  mark(index: number | undefined): void {
    this.#head = index;
    const at = index === undefined ? undefined : this.#channel()[index];
    for (const { plot, head } of this.#plots) {
      const left = at === undefined ? -1 : plot.valToPos(at, "x");
      head.hidden = !(left >= 0 && left <= plot.over.clientWidth);
      head.style.transform = `translateX(${left}px)`;
    }
    if (this.#index === undefined) {
      for (const [i, { said }] of this.#plots.entries()) {
        said.textContent = index === undefined ? "" : this.#words(i, index);
      }
    }
  }

  /** Shows a part of what is shown, about the line of the player, or more of it. */
  zoom(factor: number): void {
    const data = this.#data;
    if (!data) return;
    const [from, to] = this.#window;
    const middle = this.#head ?? (from + to) / 2;
    const size = Math.min(data.time.length, Math.max(20, (to - from) / factor));
    const first = Math.max(0, Math.min(data.time.length - size, middle - size / 2));
    this.#look([Math.round(first), Math.round(first + size)]);
  }

  #channel(): Float64Array {
    const data = this.#data as MotionData;
    return this.#across === "time" ? data.time : data.length;
  }

  #words(plot: number, index: number): string {
    const data = this.#data as MotionData;
    const { lines, unit } = PLOTS[plot] as Plot;
    const values = lines.map(({ of }) => rounded(of(data, index)));
    if (plot > 0) {
      const named = lines.map(({ name }, i) => `${name} ${values[i]}`);
      return `${lines.length > 1 ? named.join(" · ") : values[0]} ${unit}`;
    }
    // The first tells where too, and how much of the feed is reached.
    const place = rounded(this.#channel()[index] ?? 0);
    const across = this.#across === "time" ? "s" : "mm";
    return `${place} ${across}: ${values[1]} of ${values[0]} ${unit}`;
  }

  /** Makes the plots anew, or only their curves where they are there. */
  #make(): void {
    const data = this.#data as MotionData;
    if (this.#plots.length === 0) {
      this.root.replaceChildren(...PLOTS.map((plot, i) => this.#figure(plot, i)));
    }
    for (const [i, { plot }] of this.#plots.entries()) {
      const { lines } = PLOTS[i] as Plot;
      const [from, to] = this.#window;
      const of = lines.map((line) => (index: number) => line.of(data, index));
      plot.setData(curves(this.#channel(), of, from, to) as uPlot.AlignedData, true);
      plot.over.setAttribute("aria-label", summary(PLOTS[i] as Plot, data));
    }
  }

  #figure(plot: Plot, index: number): HTMLElement {
    const said = element("small", { class: "motion-said" });
    const keys = plot.lines.map(({ name, color, dash }) => {
      const swatch = element("i", { class: dash ? "dashed" : "", style: `color: var(${color})` });
      return plot.lines.length > 1 ? element("span", { class: "motion-key" }, swatch, name) : "";
    });
    const title = element("strong", {}, plot.title);
    const unit = element("small", { class: "motion-unit" }, plot.unit);
    const caption = element("figcaption", {}, title, unit, ...keys, said);
    const figure = element("figure", { class: "motion-plot" }, caption);
    const made = new uPlot(this.#options(plot, index), [[0], ...plot.lines.map(() => [0])], figure);
    made.over.setAttribute("role", "img");
    const head = element("div", { class: "motion-head", hidden: true });
    made.over.append(head);
    this.#plots[index] = { plot: made, head, said };
    return figure;
  }

  #options(plot: Plot, index: number): uPlot.Options {
    const isLast = index === PLOTS.length - 1;
    return {
      width: this.#width(),
      height: this.#height(index),
      padding: [4, RIGHT, 0, 0],
      legend: { show: false },
      cursor: {
        sync: { key: "g41-motion" },
        points: { show: false },
        y: false,
        drag: { x: true, y: false, setScale: false, dist: DRAG },
        bind: { dblclick: () => () => this.#whole() },
      },
      scales: {
        x: { time: false, range: (_, least, most) => [least, most > least ? most : least + 1] },
        y: { range: () => [...(this.#data ? plot.range(this.#data) : [0, 1])] as [number, number] },
      },
      axes: [this.#axisAcross(isLast), axisUp()],
      series: [
        {},
        ...plot.lines.map(({ color, dash, stepped }) => ({
          stroke: () => style(color),
          width: dash ? 1.25 : 1.5,
          points: { show: false },
          ...(dash ? { dash } : {}),
          ...(stepped && uPlot.paths.stepped ? { paths: uPlot.paths.stepped({ align: 1 }) } : {}),
        })),
      ],
      hooks: {
        draw: [(made) => this.#drawLimits(made, plot)],
        setSelect: [(made) => this.#select(made)],
        setCursor: [(made) => this.#cursor(made, index)],
        ready: [(made) => this.#connect(made)],
      },
    };
  }

  #axisAcross(shown: boolean): uPlot.Axis {
    return {
      ...axis(),
      size: shown ? AXIS : 4,
      space: 70,
      gap: 2,
      values: (_, splits) =>
        splits.map((value, i) => {
          if (!shown) return "";
          const unit = this.#across === "time" ? "s" : "mm";
          return i === splits.length - 1 ? `${rounded(value)} ${unit}` : rounded(value);
        }),
      ticks: { show: false },
    };
  }

  #drawLimits({ ctx, bbox, valToPos }: uPlot, { limits }: Plot): void {
    if (!this.#data) return;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.strokeStyle = style("--error");
    ctx.lineWidth = devicePixelRatio;
    for (const limit of limits(this.#data)) {
      const y = Math.round(valToPos(limit, "y", true)) + 0.5;
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
    }
    ctx.restore();
  }

  /** A stretch that was dragged over is looked at more closely. */
  #select(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width < DRAG) return;
    const channel = this.#channel();
    const from = indexAt(channel, plot.posToVal(left, "x"));
    const to = indexAt(channel, plot.posToVal(left + width, "x"));
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    if (to - from >= 4) this.#look([from, to + 1]);
  }

  #look(window: readonly [number, number]): void {
    this.#window = window;
    this.#make();
    this.mark(this.#head);
  }

  #whole(): null {
    if (this.#data) this.#look([0, this.#data.time.length]);
    return null;
  }

  /** Only the plot that the pointer is on tells of it. */
  #cursor(plot: uPlot, index: number): void {
    const { left, event } = plot.cursor;
    if (!event || !this.#plots[index] || !this.#data) return;
    if (event.type !== "mousemove" || left === undefined || left < 0) return;
    const at = indexAt(this.#channel(), plot.posToVal(left, "x"));
    this.point(at, true);
    this.#tell.look(at);
  }

  #connect(plot: uPlot): void {
    let pressed = 0;
    plot.over.addEventListener("pointerdown", ({ clientX }) => {
      pressed = clientX;
    });
    plot.over.addEventListener("pointerleave", () => {
      this.point(undefined);
      this.mark(this.#head);
      this.#tell.look(undefined);
    });
    plot.over.addEventListener("click", ({ clientX }) => {
      if (Math.abs(clientX - pressed) > DRAG || !this.#data) return;
      const left = clientX - plot.over.getBoundingClientRect().left;
      this.#tell.seek(indexAt(this.#channel(), plot.posToVal(left, "x")));
    });
  }

  #width(): number {
    return Math.max(240, this.root.clientWidth);
  }

  #height(index: number): number {
    const height = matchMedia(LOW).matches ? LOW_HEIGHT : HEIGHT;
    return height + (index === PLOTS.length - 1 ? AXIS : 4);
  }

  #resize(): void {
    const width = this.#width();
    this.#plots.forEach(({ plot }, index) => {
      const height = this.#height(index);
      if (plot.width !== width || plot.height !== height) plot.setSize({ width, height });
    });
    this.mark(this.#head);
  }
}

function axis(): uPlot.Axis {
  return {
    stroke: () => style("--muted"),
    font: "11px IBM Plex Mono, ui-monospace, monospace",
    grid: { stroke: () => style("--rule"), width: 1 },
  };
}

function axisUp(): uPlot.Axis {
  return {
    ...axis(),
    size: LEFT,
    space: 20,
    gap: 6,
    values: (_, splits) => splits.map((value) => short(value)),
    ticks: { show: false },
  };
}

function style(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/**
 * The largest feed while cutting [mm/s], allowed or reached: rapid moves, far above it, would flatten it.
 */
function cuttingFeed({ feeds, rapid, velocity, step, limits }: MotionData): number {
  let most = 0;
  feeds.forEach((feed, move) => {
    if (!rapid[move]) most = Math.max(most, feed);
  });
  velocity.forEach((value, i) => {
    if (!rapid[step[i] as number]) most = Math.max(most, value);
  });
  return most || limits.velocity;
}

function largest(least: number, ...channels: Float64Array[]): number {
  let most = least;
  for (const channel of channels) {
    for (const value of channel) most = Math.max(most, Math.abs(value));
  }
  return most;
}

/** What a plot says to those who do not see it. */
function summary({ title, unit, lines, limits }: Plot, data: MotionData): string {
  let most = 0;
  // Dashed is what is allowed.
  for (const { of } of lines.filter(({ dash }) => !dash)) {
    for (let i = 0; i < data.time.length; i += 1) most = Math.max(most, Math.abs(of(data, i)));
  }
  return `${title}: at most ${rounded(most)} ${unit}, limit ${rounded(limits(data)[0] ?? 0)} ${unit}`;
}

/** A number with at least three digits that count, and no more than are needed. */
export function rounded(value: number): string {
  const size = Math.abs(value);
  const digits = size >= 1000 || size < 1e-9 ? 0 : Math.max(0, 2 - Math.floor(Math.log10(size)));
  const text = size < 1e-6 ? "0" : value.toFixed(Math.min(6, digits));
  const plain = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return (plain.includes(".") ? plain : grouped(Number(plain))).replace("-", "−");
}

/** A number of an axis in few letters. */
function short(value: number): string {
  const size = Math.abs(value);
  const sign = value < 0 ? "−" : "";
  if (size >= 1e6) return `${sign}${rounded(size / 1e6)} M`;
  if (size >= 1e4) return `${sign}${rounded(size / 1e3)} k`;
  return `${sign}${rounded(size)}`;
}
