// The options of the commands: what each takes and means; --help and the reading of arguments follow it.
import {
  corners,
  dialects,
  gouges,
  leads,
  outputs,
  profiles,
  splines,
  targets,
} from "../options.js";
import { parameters } from "../pack.js";

/**
 * @typedef {object} Flag
 * @property {string} help what it does
 * @property {string} [value] what its value is called; without it the option takes none
 * @property {readonly string[]} [names] the values that there are
 * @property {"number"} [kind] that its value is a number, or else one of the names
 * @property {boolean} [several] whether it may be given more than once
 * @property {string} [short] its one-letter name
 */

/** @typedef {{ title: string, flags: Readonly<Record<string, Flag>> }} Group */

/** @type {Group} */
const reading = {
  title: "How the program is read",
  flags: {
    from: { value: "DIALECT", names: dialects, help: "the dialect; by default it is found out" },
    "block-delete": { help: "leave out the blocks that begin with /" },
    "spline-parameter": {
      value: "SPACING",
      names: parameters,
      help: "how the parameter of splines through points is spaced",
    },
    "curve-tolerance": {
      value: "T",
      kind: "number",
      help: "how near curves that are no cubics, as NURBS with weights, are read as such [mm]",
    },
  },
};

/** @type {Group} */
const tools = {
  title: "Tools, by their D word, or else the active T",
  flags: {
    tool: { value: "D=R", several: true, help: "radius R of tool D [mm]; may be repeated" },
    "tool-table": {
      value: "FILE.tbl",
      help: "LinuxCNC's tool table; its diameters count in the unit of the program",
    },
    radius: { value: "R", kind: "number", help: "radius of every other tool [mm]" },
  },
};

/** @type {Group} */
const compensation = {
  title: "The tool path",
  flags: {
    profile: {
      value: "PROFILE",
      names: profiles,
      help: "the control that the program is for, and to compensate like",
    },
    gouge: {
      value: "POLICY",
      names: gouges,
      help: "what becomes of places where the tool does not fit",
    },
    passes: {
      value: "COUNT",
      kind: "number",
      names: ["all"],
      help: "how many paths beside each other, with --gouge avoid",
    },
    stepover: { value: "S", kind: "number", help: "distance from one pass to the next [mm]" },
    tolerance: { value: "T", kind: "number", help: "of the path, and of arcs for splines [mm]" },
    corner: { value: "STYLE", names: corners, help: "what is inserted at outside corners" },
    lead: { value: "STYLE", names: leads, help: "how compensation is switched on and off" },
    "tangent-band": {
      value: "ANGLE",
      kind: "number",
      names: ["auto"],
      help: "turns up to this angle are no corners [rad]",
    },
    spline: { value: "METHOD", names: splines, help: "how splines are compensated" },
    curves: { value: "KIND", names: outputs, help: "what the paths of splines are made of" },
  },
};

/** @type {Group} */
const writing = {
  title: "What is written",
  flags: {
    to: { value: "TARGET", names: targets, help: "the controller to write for" },
    "keep-compensation": {
      help: "leave compensation to that controller: G41, G42 and the D words are kept",
    },
    feed: { value: "F", kind: "number", help: "feed of moves that have none [mm/min]" },
    clearance: { value: "H", kind: "number", help: "height to cross at between pieces [mm]" },
    "native-splines": { help: "write splines as such where the controller knows them" },
    explain: { help: "write a comment at each move that was not programmed, telling why" },
    json: { help: "write moves, transitions and diagnostics as JSON instead of a program" },
    output: {
      short: "o",
      value: "OUT",
      help: "write to this file; otherwise, and for -, to standard output",
    },
  },
};

/** @type {Group} */
const verdict = {
  title: "What is written",
  flags: {
    json: { help: "write a list with file, diagnostics and gouges of each program as JSON" },
  },
};

/** @type {Group} */
const motion = {
  title: "The machine, and what is told of its motion",
  flags: {
    limits: {
      value: "NAME=VALUE,…",
      several: true,
      help:
        "what the machine can do: velocity [mm/s], acceleration [mm/s²] and jerk [mm/s³]; beside these " +
        "there are cornerDeviation [mm], chordError [mm], period [s], snap [mm/s⁴], feedOverride, mode " +
        "(fast, textbook), curvatureSteps (round, slow, stop), corner (eased, ph13, ph11, ph9, ph5), exactStop " +
        "(true, false), axes.velocity, axes.acceleration and axes.jerk (X/Y/Z)",
    },
    "all-blocks": { help: "list all blocks in the order of the program, not the longest alone" },
    csv: { value: "OUT", help: "write the samples to this file as comma-separated values" },
    json: { help: "write times, costs and broken limits as JSON instead of tables" },
  },
};

/** @type {Group} */
const general = {
  title: "Others",
  flags: {
    help: { short: "h", help: "print this help" },
    version: { short: "V", help: "print the version" },
  },
};

/** @typedef {{ purpose: string, usage: string, groups: readonly Group[] }} Command */

/** @type {Readonly<Record<string, Command>>} */
export const commands = {
  convert: {
    purpose:
      "Reads a program with G41, G42 or splines, and writes one for the centre of the tool that needs neither.",
    usage: "g41 convert FILE [OPTIONS]",
    groups: [reading, tools, compensation, writing, general],
  },
  check: {
    purpose:
      "Reads programs, compensates them, and judges by distances alone whether the tool cuts into what should stay. Ends with exit code 1 where it does, or where a program has errors.",
    usage: "g41 check FILE… [OPTIONS]",
    groups: [reading, tools, compensation, verdict, general],
  },
  plan: {
    purpose:
      "Reads and compensates a program, plans the motion of a machine along it, and tells the cycle time by tool and by block, and what each limit costs. Ends with exit code 1 where the motion breaks a limit, or where the program has errors.",
    usage: "g41 plan FILE --limits velocity=200,acceleration=2000,jerk=5e4 [OPTIONS]",
    groups: [reading, tools, compensation, motion, general],
  },
};

/** Names of the options that only a path of the tool's centre follows. */
export const ofPaths = Object.keys({ ...tools.flags, ...compensation.flags }).filter(
  (name) => name !== "profile" && name !== "tolerance",
);

/** Names of the options that only what is written as a program follows. */
export const ofPrograms = Object.keys(writing.flags).filter(
  (name) => name !== "json" && name !== "output",
);

/** The options that do not need a command. */
export const withoutCommand = [general];

/**
 * The options of several groups by their name.
 *
 * @param {readonly Group[]} groups
 * @returns {Readonly<Record<string, Flag>>}
 */
export function flagsOf(groups) {
  return Object.assign({}, ...groups.map(({ flags }) => flags));
}
