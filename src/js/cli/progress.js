// A bar on the terminal that tells how far long work is.

/** Programs shorter than this are done before a bar could be read [letters]. */
const long = 500_000;

/** Letters of a bar. */
const width = 30;

/** @typedef {{ isTTY?: boolean, write(text: string): unknown }} Stream */

/** Work in steps, each of which takes a share of the time. */
export class Progress {
  #stream;
  #shares;
  #shown;
  #step = -1;
  #last = "";

  /**
   * @param {Stream} stream where the bar is drawn, if it is a terminal
   * @param {number} size of the program [letters]
   * @param {readonly (readonly [name: string, share: number])[]} steps
   */
  constructor(stream, size, steps) {
    this.#stream = stream;
    this.#shares = steps;
    this.#shown = Boolean(stream.isTTY) && size >= long;
  }

  /** Begins the next step. */
  next() {
    this.#step += 1;
    this.part(0);
  }

  /**
   * Tells how much of the step is done.
   *
   * @param {number} part from 0 to 1
   */
  part(part) {
    const [name, share] = this.#shares[this.#step] ?? ["", 0];
    if (!this.#shown) {
      return;
    }
    let before = 0;
    let total = 0;
    for (const [index, [, of]] of this.#shares.entries()) {
      before += index < this.#step ? of : 0;
      total += of;
    }
    const done = (before + share * Math.min(part, 1)) / total;
    const full = Math.round(done * width);
    const bar = `${"#".repeat(full)}${".".repeat(width - full)}`;
    const text = `\r\x1b[K[${bar}] ${Math.floor(done * 100)} % ${name}`;
    if (text !== this.#last) {
      this.#last = text;
      this.#stream.write(text);
    }
  }

  /** Takes the bar away. */
  end() {
    if (this.#shown) {
      this.#stream.write("\r\x1b[K");
    }
    this.#shown = false;
  }
}
