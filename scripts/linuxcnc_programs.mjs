// Programs by their seed, for comparison with LinuxCNC's interpreter: contours with compensation in G17 and
// G18, and what changes coordinates between them.

/** Millimetres of an inch. */
export const INCH = 25.4;

/** Writes the program of a seed. */
export class Writer {
  constructor(seed) {
    this.state = seed + 1;
    this.lines = [];
    this.inches = this.chance(0.2);
    this.unit = this.inches ? INCH : 1;
    this.lathe = this.chance(0.4);
    const tip = () => (this.lathe ? this.pick([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]) : 0);
    // Odd numbers, so that nothing is just as long as a radius.
    const diameter = () => this.pick([0.713, 1.377, 2.191, 3.833, -1.619]);
    this.tools = [1, 2].map((number) => [number, diameter(), tip()]);
    /** Where the program is: x, y, z. */
    this.at = [0, 0, 0];
    this.relative = false;
    this.inverse = false;
  }

  /** From 0 to 1, by mulberry32. */
  random() {
    this.state = (this.state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(this.state ^ (this.state >>> 15), 1 | this.state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  }

  chance(share) {
    return this.random() < share;
  }

  between(low, high) {
    return low + (high - low) * this.random();
  }

  pick(list) {
    return list[Math.floor(this.random() * list.length)];
  }

  block(words) {
    this.lines.push(`N${this.lines.length + 1} ${words}`);
  }

  program() {
    this.block(`G${this.inches ? 20 : 21} G90 G40 G94 G${this.lathe ? 18 : 17}`);
    this.block(`T${this.pick([1, 2])} M6`);
    this.block("F100 S1000 M3");
    this.approach();
    const contours = this.pick([1, 1, 2, 3]);
    for (let i = 0; i < contours; i++) {
      if (this.chance(0.4)) this.coordinates();
      if (this.chance(0.2)) {
        this.inverse = !this.inverse;
        this.block(this.inverse ? "G93" : "G94 F80");
      }
      if (this.chance(0.2)) this.otherWay();
      this.contour();
      this.approach();
    }
    this.block("M2");
    const text = this.lines.join("\n");
    const used = this.tools.filter(([number]) => new RegExp(`[TD]${number}\\b`).test(text));
    return { lines: this.lines, tools: used };
  }

  /** To a new place, stated as a whole. */
  approach() {
    this.relative = false;
    this.at = this.at.map(() => rounded(this.between(-9, 9)));
    this.block(`G90 G0 ${this.at.map((value, i) => `${"XYZ"[i]}${value}`).join(" ")}`);
  }

  /** Words that change coordinates. */
  coordinates() {
    const axes = () => [..."XYZ"].map((axis) => axis + rounded(this.between(-9, 9))).join(" ");
    const turned = this.lathe ? "" : this.pick(["", "", " R30", " R-45"]);
    const words = [
      () => `G92 ${axes()}`,
      () => this.pick(["G92.1", "G92.2", "G92.3"]),
      () => `G52 ${axes()}`,
      () => this.pick(["G54", "G55", "G59.3"]),
      () => `G10 L2 P${this.pick([0, 1, 2, 9])} ${axes()}${turned}`,
      () => `G10 L20 P${this.pick([0, 1, 2])} ${axes()}`,
    ];
    for (let i = this.pick([1, 2]); i > 0; i--) this.block(this.pick(words)());
    this.approach();
  }

  contour() {
    const side = this.pick([41, 42]);
    const [number, listed] = this.pick(this.tools);
    const given = this.chance(0.3);
    const diameter = given ? this.pick([0.713, 1.377, 2.191]) : listed;
    const tip = given && this.lathe && this.chance(0.7) ? ` L${this.pick([1, 3, 6, 8, 9])}` : "";
    const size = rounded(diameter / this.unit, 6);
    const on = given ? `G${side}.1 D${size}${tip}` : `G${side} D${number}`;
    const left = (side === 41) === diameter > 0;
    const radius = Math.abs(diameter) / 2 / this.unit;
    this.angle = this.between(-Math.PI, Math.PI);
    this.block(on);
    const count = this.pick([2, 3, 4, 6, 9]);
    for (let i = 0; i < count; i++) {
      if (i > 0) {
        // Away from the tool mostly, into it gently.
        const turn = this.chance(0.6) ? -this.between(0, 3) : this.between(0.05, 1.6);
        this.angle += (left ? 1 : -1) * turn;
        if (this.chance(0.2)) this.aside();
      }
      // Some are too short, or too narrow.
      const short = this.chance(0.1);
      const length = radius * this.between(short ? 0.2 : 2, short ? 2 : 9);
      if (this.chance(i === 0 ? 0.75 : 0.5)) this.line(length);
      else this.arc(radius * this.between(short ? 0.5 : 1.3, 6));
    }
    const off = this.chance(0.5);
    if (off) this.block("G40");
    this.angle += this.between(-3, 3);
    this.line(radius * this.between(1, 6), off ? "" : "G40 ");
  }

  /** A block between two moves of a contour. */
  aside() {
    const up = rounded(this.between(-2, 2));
    const height = this.lathe ? 1 : 2;
    const words = [
      () => this.block(this.pick(["M8", "M9", "(a remark)", "G4 P0.1", "S500"])),
      () => {
        const to = [...this.at];
        to[height] += up;
        this.move("G1", to, this.feed());
      },
      () => this.otherWay(),
    ];
    this.pick(words)();
  }

  /** From absolute to incremental places, or back. */
  otherWay() {
    this.relative = !this.relative;
    this.block(this.relative ? "G91" : "G90");
  }

  feed() {
    if (this.inverse) return ` F${this.pick([1, 5, 12.5, 30])}`;
    return this.chance(0.2) ? ` F${this.pick([50, 120, 222.5])}` : "";
  }

  /** The point of the plane at a distance in the present direction, maybe at another height. */
  ahead(along, across = 0) {
    const [first, second, height] = this.lathe ? [2, 0, 1] : [0, 1, 2];
    const [cos, sin] = [Math.cos(this.angle), Math.sin(this.angle)];
    const to = [...this.at];
    to[first] += along * cos - across * sin;
    to[second] += along * sin + across * cos;
    if (this.chance(0.15)) to[height] += this.pick([-1, 1, 0.5]);
    return to;
  }

  line(length, before = "") {
    const rapid = this.chance(0.1);
    this.move(`${before}G${rapid ? 0 : 1}`, this.ahead(length), rapid ? "" : this.feed());
  }

  arc(radius) {
    const left = this.chance(0.5);
    const sweep = this.between(0.3, 5.5);
    const start = [...this.at];
    const turn = left ? sweep : -sweep;
    const across = (left ? 1 : -1) * radius * (1 - Math.cos(sweep));
    const to = this.ahead(radius * Math.sin(sweep), across);
    const word = `G${left ? 3 : 2}`;
    if (this.chance(0.3)) {
      this.move(word, to, ` R${rounded(sweep > Math.PI ? -radius : radius, 5)}${this.feed()}`);
    } else {
      const [first, second] = this.lathe ? [2, 0] : [0, 1];
      const center = [0, 0, 0];
      center[first] = -(left ? 1 : -1) * radius * Math.sin(this.angle);
      center[second] = (left ? 1 : -1) * radius * Math.cos(this.angle);
      const words = [first, second].map((i) => `${"IJK"[i]}${rounded(center[i], 5)}`).sort();
      const turns = this.chance(0.1) ? ` P${this.pick([1, 2, 3])}` : "";
      this.move(word, to, ` ${words.join(" ")}${turns}${this.feed()}`);
    }
    if (start.some((value, i) => value !== this.at[i])) this.angle += turn;
  }

  /** A block to a place; what stays where it is may be left out. */
  move(word, to, rest) {
    const words = [];
    for (const [i, axis] of [..."XYZ"].entries()) {
      const value = rounded(this.relative ? to[i] - this.at[i] : to[i]);
      const stays = Math.abs(to[i] - this.at[i]) < 1e-9;
      if (stays) continue;
      words.push(axis + value);
      this.at[i] = rounded(this.relative ? this.at[i] + value : value);
    }
    if (words.length > 0) this.block(`${word} ${words.join(" ")}${rest}`);
  }
}

function rounded(value, decimals = 4) {
  return Number(value.toFixed(decimals));
}
