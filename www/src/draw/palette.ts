// The colours of the picture, in a light and a dark scheme; kinds differ by shape and dash as well.

import type { Transition } from "g41";
import type { StrokeKind } from "../large/strokes";

/** How one kind of transition is drawn. */
export interface KindStyle {
  readonly color: string;
  /** [px] */
  readonly dash: readonly number[];
  readonly shape: "square" | "diamond" | "triangle";
}

/** All colours of the picture. */
export interface Palette {
  readonly paper: string;
  readonly gridMinor: string;
  readonly gridMajor: string;
  readonly axis: string;
  readonly label: string;
  readonly material: string;
  readonly contour: string;
  readonly swept: string;
  readonly gouged: string;
  readonly uncut: string;
  readonly uncutFill: string;
  readonly path: string;
  /** Rapid moves, and moves that cut without being compensated. */
  readonly rapid: string;
  readonly free: string;
  readonly tool: string;
  readonly toolFill: string;
  readonly ink: string;
  readonly muted: string;
  readonly handleFill: string;
  readonly accent: string;
  readonly error: string;
  readonly warning: string;
  readonly kinds: Readonly<Record<Transition["kind"], KindStyle>>;
  /** Lines of very long programs. */
  readonly strokes: Readonly<Record<StrokeKind, string>>;
}

/** The scheme of paper. */
export const LIGHT: Palette = {
  paper: "#fcfcfa",
  gridMinor: "#f1f2ee",
  gridMajor: "#e4e6e1",
  axis: "#c6cbc5",
  label: "#667069",
  material: "#e4e8ee",
  contour: "#1b2430",
  swept: "rgba(0, 128, 115, 0.085)",
  gouged: "rgba(208, 32, 42, 0.42)",
  uncut: "#8a6100",
  uncutFill: "rgba(214, 158, 20, 0.16)",
  path: "#00786c",
  rapid: "#7f8a83",
  free: "#47587c",
  tool: "#00594f",
  toolFill: "rgba(0, 128, 115, 0.14)",
  ink: "#1b2430",
  muted: "#5f6874",
  handleFill: "#ffffff",
  accent: "#1f5fd0",
  error: "#c81e28",
  warning: "#a85b00",
  kinds: {
    shortened: { color: "#1f6fd0", dash: [], shape: "square" },
    elongated: { color: "#c76a00", dash: [9, 4], shape: "diamond" },
    inserted: { color: "#b0278f", dash: [3, 3], shape: "triangle" },
  },
  strokes: {
    rapid: "#9aa39d",
    free: "#47587c",
    contour: "#1b2430",
    lead: "#00786c",
    cut: "#00786c",
  },
};

/** The scheme of a dim workshop. */
export const DARK: Palette = {
  paper: "#101418",
  gridMinor: "#161b20",
  gridMajor: "#1f262d",
  axis: "#3b454f",
  label: "#8d98a3",
  material: "#252e39",
  contour: "#eef2f6",
  swept: "rgba(64, 214, 190, 0.09)",
  gouged: "rgba(255, 82, 82, 0.5)",
  uncut: "#e0b656",
  uncutFill: "rgba(224, 182, 86, 0.14)",
  path: "#45d4be",
  rapid: "#788490",
  free: "#a9bbdf",
  tool: "#8debdc",
  toolFill: "rgba(64, 214, 190, 0.15)",
  ink: "#eef2f6",
  muted: "#98a3ae",
  handleFill: "#101418",
  accent: "#79aefc",
  error: "#ff7b7b",
  warning: "#ffb454",
  kinds: {
    shortened: { color: "#6cb2ff", dash: [], shape: "square" },
    elongated: { color: "#ffae42", dash: [9, 4], shape: "diamond" },
    inserted: { color: "#f28bd8", dash: [3, 3], shape: "triangle" },
  },
  strokes: {
    rapid: "#5c6772",
    free: "#a9bbdf",
    contour: "#eef2f6",
    lead: "#45d4be",
    cut: "#45d4be",
  },
};
