// The tool path as its user sees it: what the WebAssembly holds, unpacked when it is asked for.
import { bad } from "./check.js";
import { drawOn, svgData } from "./draw.js";
import { emitted } from "./gcode.js";
import { coded, Handle } from "./lifecycle.js";
import { packLimits } from "./limits.js";
import { Motion } from "./motion.js";
import { unpackMoves, unpackWays } from "./moves.js";
import { polylinesOf } from "./polylines.js";

/** @typedef {import("./types.d.ts").ToolPath} Face */
/** @typedef {import("./lifecycle.js").Glue} Glue */
/** @typedef {import("./g41.js").ToolPathHandle} Raw */

/**
 * Runs a call with what a path holds, for `check` and the command line alone.
 *
 * @type {<R>(path: ToolPath, work: (raw: Raw, glue: Glue) => R) => R}
 */
export let useToolPath;

/** Beyond every index. */
const everything = 0xffffffff;

/** Items of a list that are unpacked at a time: the text of a million takes a quarter of a gigabyte. */
const slice = 4096;

/** @implements {Face} */
export class ToolPath {
  /** @type {Handle<Raw>} */
  #handle;
  /** @type {Face["moves"] | undefined} */
  #moves;
  /** @type {Face["transitions"] | undefined} */
  #transitions;
  /** @type {Face["diagnostics"] | undefined} */
  #diagnostics;
  /** @type {Face["gouges"] | undefined} */
  #gouges;
  /** @type {Face["loops"] | undefined} */
  #loops;
  /** @type {Face["uncut"] | undefined} */
  #uncut;
  /** @type {Face["ways"] | undefined} */
  #ways;

  static {
    useToolPath = (path, work) => path.#handle.use(work);
  }

  /** @param {(glue: Glue) => Raw} make */
  constructor(make) {
    this.#handle = new Handle(make);
  }

  get moves() {
    this.#moves ??= unpackMoves(this.records());
    return this.#moves;
  }

  get transitions() {
    this.#transitions ??= this.#list("Transitions");
    return /** @type {Face["transitions"]} */ (this.#transitions);
  }

  get diagnostics() {
    this.#diagnostics ??= this.#list("Diagnostics");
    return /** @type {Face["diagnostics"]} */ (this.#diagnostics);
  }

  get gouges() {
    this.#gouges ??= this.#list("Gouges");
    return /** @type {Face["gouges"]} */ (this.#gouges);
  }

  get loops() {
    this.#loops ??= this.#list("Loops");
    return /** @type {Face["loops"]} */ (this.#loops);
  }

  get uncut() {
    this.#uncut ??= unpackUncut(
      this.#list("Uncut"),
      this.#handle.use((raw) => raw.outlines()),
    );
    return this.#uncut;
  }

  /**
   * All items of a list.
   *
   * @param {keyof typeof import("./g41.js").List} name
   * @returns {any[]}
   */
  #list(name) {
    /** @type {any[]} */
    const items = [];
    for (let from = 0; ; from += slice) {
      const some = JSON.parse(
        this.#handle.use((raw, { List }) => raw.report(List[name], from, from + slice)),
      );
      for (const item of some) {
        items.push(item);
      }
      if (some.length < slice) {
        return items;
      }
    }
  }

  get ways() {
    this.#handle.needWhole();
    this.#ways ??= unpackWays(this.#handle.use((raw) => raw.ways()));
    return this.#ways;
  }

  get count() {
    return this.#handle.use((raw) => raw.count());
  }

  records(from = 0, to = everything) {
    index(from, "from");
    index(to, "to");
    return this.#handle.use((raw) => raw.records(from, to));
  }

  /** @param {number} [within] */
  polyline(within) {
    const { points, starts } = this.polylines(within);
    if (starts.length > 1) {
      throw coded(
        "several-pieces",
        `the path is in ${starts.length} pieces: use polylines() instead of polyline()`,
      );
    }
    return points;
  }

  /** @param {number} [within] */
  polylines(within) {
    return polylinesOf(this.#handle, within);
  }

  /** @param {import("./types.d.ts").Limits} limits */
  plan(limits) {
    this.#handle.needWhole();
    const packed = packLimits(limits);
    return this.#handle.use((raw, glue) => {
      const make = () => glue.planMotion(raw, packed);
      return new Motion(make, raw.count(), glue.toolChanges(raw));
    });
  }

  /** @returns {any} `Path2D`, which the types name only where the environment has it */
  toPath2D() {
    if (typeof Path2D === "undefined") {
      throw coded("not-supported", "toPath2D() needs an environment with Path2D; svg() does not");
    }
    return drawOn(new Path2D(), this.records());
  }

  svg() {
    return svgData(this.records());
  }

  /** @param {import("./types.d.ts").GcodeOptions} [options] */
  emit(options) {
    return emitted(this.#handle, options);
  }

  /** @param {import("./types.d.ts").GcodeOptions} [options] */
  gcode(options) {
    return this.emit(options).text;
  }

  toJSON() {
    const { moves, transitions, diagnostics, gouges, loops } = this;
    const uncut = this.uncut.map(({ outline, ...region }) => ({
      outline: Array.from(outline),
      ...region,
    }));
    return { moves, transitions, diagnostics, gouges, uncut, loops };
  }

  // Where the environment has no Symbol.dispose yet, this only has a name that nobody calls.
  [Symbol.dispose]() {
    this.#handle.dispose();
  }
}

/**
 * @param {unknown} value
 * @param {string} name
 */
function index(value, name) {
  if (!Number.isInteger(value) || Number(value) < 0 || Number(value) > everything) {
    bad(() => name, "be an index of a move");
  }
}

/**
 * Puts regions and their outlines together.
 *
 * @param {(Omit<Face["uncut"][number], "outline"> & { vertices: number })[]} regions with the
 *   number of vertices in the place of each outline
 * @param {Float64Array} outlines one after the other
 * @returns {Face["uncut"]}
 */
function unpackUncut(regions, outlines) {
  let from = 0;
  return regions.map(({ vertices, ...region }) => {
    const outline = outlines.slice(from, from + 2 * vertices);
    from += 2 * vertices;
    return { outline, ...region };
  });
}
