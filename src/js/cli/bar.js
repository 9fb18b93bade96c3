// Draws a bar that tells how far work in several steps is.

/** Letters of a bar. */
const width = 30;

/**
 * What is done and, as far as is known, how long it takes [s].
 *
 * @typedef {readonly [name: string, seconds: number]} Step
 */

export class Bar {
  #write;
  #steps;
  #step = -1;
  #last = "";

  /**
   * @param {(text: string) => void} write to the terminal
   * @param {readonly Step[]} steps
   */
  constructor(write, steps) {
    this.#write = write;
    this.#steps = steps;
  }

  /** Begins the next step. */
  next() {
    this.#step += 1;
    this.part(0);
  }

  /**
   * Guesses how much of the step is done. It never is all: what takes longer than expected comes
   * nearer and nearer to its end.
   *
   * @param {number} seconds since it began
   */
  guess(seconds) {
    this.part(1 - Math.exp(-seconds / (this.#steps[this.#step]?.[1] || 1)));
  }

  /**
   * Tells how much of the step is done.
   *
   * @param {number} part from 0 to 1
   */
  part(part) {
    const [name, seconds] = this.#steps[this.#step] ?? ["", 0];
    let before = 0;
    let total = 0;
    for (const [index, [, of]] of this.#steps.entries()) {
      before += index < this.#step ? of : 0;
      total += of;
    }
    const done = (before + seconds * Math.min(part, 1)) / total;
    const full = Math.round(done * width);
    const bar = `${"#".repeat(full)}${".".repeat(width - full)}`;
    const text = `\r\x1b[K[${bar}] ${Math.floor(done * 100)} % ${name}`;
    if (text !== this.#last) {
      this.#last = text;
      this.#write(text);
    }
  }

  /** Takes the bar away. */
  end() {
    this.#write("\r\x1b[K");
  }
}
