// The names of controls: by which rules a program is read and compensated, and for whom it is written.

import type { Dialect, Profile, Target } from "g41";

/** Whose rules of compensation are followed. */
export const PROFILES: Readonly<Record<Profile, string>> = {
  g41: "g41 (textbook)",
  linuxcnc: "LinuxCNC",
  fanuc: "FANUC",
  isg: "ISG, Beckhoff",
  sinumerik: "SINUMERIK",
};

/** The language that a program is written in. */
export const DIALECTS: Readonly<Record<Dialect, string>> = {
  auto: "as detected",
  linuxcnc: "LinuxCNC",
  fanuc: "FANUC",
  sinumerik: "SINUMERIK",
};

/** For whom a program is written. */
export const TARGETS: Readonly<Record<Target, string>> = {
  grbl: "grbl",
  grblhal: "grblHAL",
  linuxcnc: "LinuxCNC",
  smoothieware: "Smoothieware",
  marlin: "Marlin",
  "fanuc-0m": "FANUC 0M",
  "fanuc-6m": "FANUC 6M",
  "fanuc-30i": "FANUC 30i",
  heidenhain: "Heidenhain",
};

/** Whether a text is one of the names. */
export function isName<Name extends string>(
  names: Readonly<Record<Name, string>>,
  text: unknown,
): text is Name {
  return typeof text === "string" && Object.hasOwn(names, text);
}
