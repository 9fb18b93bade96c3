// The player: the tool runs along its path as fast as it would, or slower, or faster.

import { element, icon } from "../panels/elements";

const PLAY = "M8 5.5v13l11-6.5z";
const PAUSE = "M8 5.5v13M16 5.5v13";

/** How fast time may pass. */
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 25, 50, 100] as const;

/** Steps of the slider. */
const STEPS = 1000;

/** Who wants less motion sees where the tool is in steps of this [ms]. */
const CALM_STEP = 500;

/** Told where the player is. */
export type PlayerListener = (time: number, playing: boolean) => void;

/** Buttons and slider of the player, and its time. */
export class Player {
  readonly root: HTMLElement;
  #time = 0;
  #duration = 0;
  #speed = 1;
  #frame = 0;
  #last = 0;
  #calm = matchMedia("(prefers-reduced-motion: reduce)");
  #tell: PlayerListener;
  #button = element("button", { type: "button", class: "icon-button motion-play" });
  #range = element("input", {
    type: "range",
    min: 0,
    max: STEPS,
    step: 1,
    value: 0,
    "aria-label": "Time",
  });
  #readout = element("output", { class: "motion-time", "aria-live": "off" });

  constructor(listener: PlayerListener) {
    this.#tell = listener;
    const speeds = element("select", { "aria-label": "Speed" });
    for (const speed of SPEEDS) {
      speeds.append(element("option", { value: speed, selected: speed === 1 }, `×${speed}`));
    }
    speeds.addEventListener("change", () => {
      this.#speed = Number(speeds.value);
    });
    this.#button.addEventListener("click", () => (this.playing ? this.pause() : this.#play()));
    this.#range.addEventListener("input", () => {
      this.seek((this.#range.valueAsNumber / STEPS) * this.#duration);
    });
    this.#range.addEventListener("keydown", (event) => this.#key(event));
    const controls = [this.#button, this.#range, this.#readout, speeds];
    const name = { class: "motion-player", role: "group", "aria-label": "Player" };
    this.root = element("div", name, ...controls);
    this.#show();
  }

  /** Whether the tool is running. */
  get playing(): boolean {
    return this.#frame !== 0;
  }

  /** [s] */
  get time(): number {
    return this.#time;
  }

  /** Takes how long the motion is, and stays at the same part of it. */
  setDuration(duration: number): void {
    const part = this.#duration > 0 ? this.#time / this.#duration : 0;
    this.#duration = duration;
    this.#time = part * duration;
    this.#show();
  }

  /** Goes to a time [s]. */
  seek(time: number): void {
    this.#time = Math.min(this.#duration, Math.max(0, time));
    this.#show();
    this.#tell(this.#time, this.playing);
  }

  /** Stops where it is. */
  pause(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#show();
    this.#tell(this.#time, false);
  }

  #play(): void {
    if (this.#time >= this.#duration) this.#time = 0;
    this.#last = performance.now();
    const step = (now: number) => {
      this.#frame = requestAnimationFrame(step);
      const passed = now - this.#last;
      if (this.#calm.matches && passed < CALM_STEP) return;
      this.#last = now;
      this.seek(this.#time + (Math.max(0, passed) / 1000) * this.#speed);
      if (this.#time >= this.#duration) this.pause();
    };
    this.#frame = requestAnimationFrame(step);
    this.#show();
  }

  /** The slider alone has a thousand steps; with Shift an arrow key goes a hundredth of a second. */
  #key(event: KeyboardEvent): void {
    const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (event.key === " ") this.#button.click();
    else if (sign !== undefined && event.shiftKey) this.seek(this.#time + sign * 0.01);
    else return;
    event.preventDefault();
  }

  #show(): void {
    const part = this.#duration > 0 ? this.#time / this.#duration : 0;
    this.#range.value = String(Math.round(part * STEPS));
    this.#range.style.setProperty("--share", `${part * 100}%`);
    const [time, duration] = [this.#time, this.#duration].map((value) => seconds(value));
    this.#range.setAttribute("aria-valuetext", `${time} of ${duration}`);
    this.#readout.textContent = `${time} / ${duration}`;
    const name = this.playing ? "Pause" : "Play";
    if (this.#button.getAttribute("aria-label") === name) return;
    this.#button.setAttribute("aria-label", name);
    this.#button.title = `${name} the tool's motion`;
    this.#button.replaceChildren(icon(this.playing ? PAUSE : PLAY));
  }
}

/** A time as people read it [s]. */
export function seconds(time: number): string {
  if (time < 59.995) return `${time.toFixed(2)} s`;
  const whole = Math.round(time);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  const two = (value: number) => String(value).padStart(2, "0");
  const rest = two(whole % 60);
  return hours > 0 ? `${hours}:${two(minutes)}:${rest} h` : `${minutes}:${rest} min`;
}
