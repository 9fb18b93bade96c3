// The panel of motion below the picture: times, player, plots and the machine.

import { Choice, element, iconButton } from "../panels/elements";
import type { Stage } from "../stage";
import type { Store } from "../state";
import { toWorld } from "../view";
import { MotionClient } from "./client";
import { Comparison } from "./comparison";
import { LimitsForm } from "./limits-form";
import { limitsOf, restoreMachine, saveMachine } from "./machine";
import { Player } from "./player";
import { type Across, Plots } from "./plots";
import type { MotionData } from "./protocol";
import { RulesTable } from "./rules-table";
import { nearestSample, placeAt } from "./samples";

/** Changes that follow each other faster are planned once [ms]. */
const PAUSE = 120;

/** How near the pointer must be to the path for the plots to show where it is [px]. */
const REACH = 40;

const ICONS = { closer: "M12 5v14M5 12h14", out: "M5 12h14" } as const;

/** The panel, for as long as the page is open. */
export class MotionPanel {
  #section: HTMLElement;
  #stage: Stage;
  #store: Store;
  #machine = restoreMachine();
  #across: Across = "time";
  #data: MotionData | undefined;
  #timer = 0;
  #isPointed = false;
  #comparison = new Comparison();
  #failure = element("p", { class: "motion-failure", role: "status" });
  #rules = new RulesTable();
  #player = new Player((time, playing) => this.#played(time, playing));
  #plots = new Plots({
    look: (index) => this.#look(index),
    seek: (index) => this.#seek(index),
  });
  #client = new MotionClient({
    planned: (data) => this.#planned(data),
    compared: (stops, method) => this.#comparison.compare(stops, method),
    failed: (message) => this.#failed(message),
    busy: (busy) => this.#section.setAttribute("aria-busy", String(busy)),
  });

  constructor(section: HTMLElement, stage: Stage, store: Store) {
    this.#section = section;
    this.#stage = stage;
    this.#store = store;
    const form = new LimitsForm(this.#machine, (machine) => {
      this.#machine = machine;
      saveMachine(machine);
      this.#askSoon();
    });
    const side = element("div", { class: "motion-side" }, form.root);
    const shown = element("div", { class: "motion-shown" }, this.#plots.root);
    const title = element("h2", { class: "hidden" }, "Motion");
    const bar = element("div", { class: "motion-bar" }, this.#player.root, this.#tools());
    const body = element("div", { class: "motion-body" }, shown, side);
    section.append(title, this.#comparison.root, bar, this.#failure, body, this.#rules.root);
    // What is said of the times may take another line, and with it height of the picture.
    new ResizeObserver(() => stage.keepFit()).observe(section);
    store.subscribe((state, before) => {
      const { text, settings } = state.history.present;
      const old = before.history.present;
      if (text !== old.text || settings !== old.settings) this.#askSoon();
    });
    stage.overlay.addEventListener("pointermove", (event) => this.#follow(event));
    stage.overlay.addEventListener("pointerleave", () => this.#leave());
  }

  /** Begins to show what is planned now. */
  open(): void {
    this.#ask();
  }

  /** Takes the tool off the picture. */
  close(): void {
    this.#player.pause();
    this.#store.set({ played: undefined });
  }

  /** Draws the plots in the colours of another scheme. */
  recolour(): void {
    this.#plots.recolour();
  }

  #tools(): HTMLElement {
    const across = new Choice(
      "motion-across",
      "Against",
      { time: "Time", length: "Length" },
      (value) => {
        this.#across = value as Across;
        if (this.#data) this.#plots.show(this.#data, this.#across);
        this.#mark();
      },
    );
    across.show(this.#across);
    const closer = iconButton("Plots closer", ICONS.closer, "or drag over a stretch of them");
    const out = iconButton("More of the plots", ICONS.out, "all of them by a double-click");
    closer.addEventListener("click", () => this.#plots.zoom(2));
    out.addEventListener("click", () => this.#plots.zoom(0.5));
    return element("div", { class: "motion-tools" }, across.root, out, closer);
  }

  #askSoon(): void {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.#ask(), PAUSE);
  }

  #ask(): void {
    const { text, file, settings } = this.#store.document;
    if (this.#section.hidden || file) return;
    this.#client.ask(text, settings, limitsOf(this.#machine));
  }

  /** There is nothing to show: what was planned before is of another program, or another machine. */
  #failed(message: string): void {
    this.#data = undefined;
    this.#failure.textContent = message;
    this.#section.dataset.failed = "";
    this.close();
  }

  #planned(data: MotionData): void {
    if (data.duration === 0) {
      this.#failed("There is no motion: the program moves nothing.");
      return;
    }
    // With its first plots the panel takes its height from the picture.
    if (!this.#data) this.#stage.fitNext();
    this.#data = data;
    this.#failure.textContent = "";
    delete this.#section.dataset.failed;
    this.#comparison.show(data);
    this.#rules.show(this.#store.document, data);
    this.#player.setDuration(data.duration);
    this.#plots.show(data, this.#across);
    this.#mark();
  }

  #mark(): void {
    const place = this.#data && placeAt(this.#data, this.#player.time);
    this.#plots.mark(place?.index);
  }

  /** The player is at a time: the tool goes there, and while it runs its line is marked. */
  #played(time: number, playing: boolean): void {
    const place = this.#data && placeAt(this.#data, time);
    if (!place) return;
    this.#plots.mark(place.index);
    this.#show(place);
    const { line } = place;
    if (playing && line !== undefined && line !== this.#store.state.pointed) {
      this.#store.set({ pointed: line, caret: undefined, selection: undefined });
    }
  }

  /** The pointer is on a plot: the tool is shown there until it leaves. */
  #look(index: number | undefined): void {
    const data = this.#data;
    if (!data || this.#player.playing) return;
    const time = index === undefined ? this.#player.time : (data.time[index] ?? 0);
    const place = placeAt(data, time);
    if (place) this.#show(place);
  }

  #seek(index: number): void {
    this.#player.seek(this.#data?.time[index] ?? 0);
  }

  #show({ point, line, move }: NonNullable<ReturnType<typeof placeAt>>): void {
    const [right, up] = this.#store.state.result?.axes ?? [0, 1];
    const isRapid = this.#data?.rapid[move] === 1;
    this.#store.set({ played: { at: [point[right], point[up]], point, line, isRapid } });
  }

  /** The pointer is on the picture: near the path, the plots show where. */
  #follow(event: PointerEvent): void {
    const data = this.#data;
    if (!data || this.#section.hidden || this.#player.playing || event.buttons !== 0) return;
    const { view } = this.#stage;
    const axes = this.#store.state.result?.axes ?? [0, 1];
    const at = toWorld(view, [event.offsetX, event.offsetY]);
    const index = nearestSample(data, axes, at, REACH / view.scale);
    // The tool follows the pointer there by itself.
    if (this.#store.state.played) this.#store.set({ played: undefined });
    this.#isPointed = index !== undefined;
    this.#plots.point(index);
  }

  #leave(): void {
    if (!this.#isPointed) return;
    this.#isPointed = false;
    this.#plots.point(undefined);
    this.#mark();
  }
}
