// What is wrong with the fit of the tool: where it cuts too deep, and what it does not reach.

import type { Diagnostic, Gouge, Origin, Uncut } from "g41";
import { trackOf } from "./draw/track";
import { format } from "./expression";
import { distance, type Point } from "./geometry";
import { contourAt, type Result, radiusOn } from "./result";

/** A place in the picture where the tool does not fit. */
interface Place {
  /** What tells it from the others. */
  readonly key: string;
  /** The number that matters, with its unit. */
  readonly title: string;
  /** The reason, as a sentence without its full stop. */
  readonly reason: string;
  /** Lines of the text concerned, in order. */
  readonly lines: readonly number[];
  /** Where it is [mm]. */
  readonly at: Point;
}

/** Where the tool cuts too deep. */
export interface GougePlace extends Place {
  readonly kind: "gouge";
  /** [mm] */
  readonly depth: number;
  /** Where the tool stands when it cuts deepest, and its radius [mm]. */
  readonly center: Point;
  readonly radius: number;
}

/** What the tool does not reach. */
export interface UncutPlace extends Place {
  readonly kind: "uncut";
  /** [mm²] */
  readonly area: number;
  /** x0, y0, x1, y1, … [mm] */
  readonly outline: Float64Array;
}

/** One finding. */
export type Finding = GougePlace | UncutPlace;

/** Areas below this are not worth a word [mm²]. */
const LEAST_AREA = 1e-4;

const known = new WeakMap<Result, readonly Finding[]>();

/** All findings of a result, the gravest of each kind first. */
export function findingsOf(result: Result): readonly Finding[] {
  const before = known.get(result);
  if (before) return before;
  const starts = new Set(result.path.starts);
  const gouges = result.gouges.map((gouge, i) => gougePlace(result, starts, gouge, i));
  const uncut = result.uncut
    .filter(({ area, outline }) => area >= LEAST_AREA && outline.length >= 6)
    .map((region, i) => uncutPlace(result, region, i));
  gouges.sort((a, b) => b.depth - a.depth);
  uncut.sort((a, b) => b.area - a.area);
  const findings = [...gouges, ...uncut];
  known.set(result, findings);
  return findings;
}

/** The finding at a place; of several the one whose mark is nearest. */
export function findingAt(result: Result, p: Point, within: number): Finding | undefined {
  let best: Finding | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const finding of findingsOf(result)) {
    const d = distance(finding.at, p);
    if ((d <= within || covers(finding, p)) && d < least) {
      best = finding;
      least = d;
    }
  }
  return best;
}

/** The finding that a diagnostic is about, if it is one of them. */
export function findingOf(result: Result, { at, depth }: Diagnostic): Finding | undefined {
  if (!at || depth === undefined) return undefined;
  return findingsOf(result).find(
    (finding) =>
      finding.kind === "gouge" && finding.depth === depth && distance(finding.at, at) < 1e-9,
  );
}

/** Lines of the text in words: one, two, or from the first to the last. */
export function linesInWords(lines: readonly number[]): string {
  const [first, second] = lines;
  if (first === undefined) return "";
  if (second === undefined) return `line ${first}`;
  if (lines.length === 2) return `lines ${first} and ${second}`;
  return `lines ${first} to ${lines.at(-1)}`;
}

function gougePlace(
  result: Result,
  starts: ReadonlySet<number>,
  gouge: Gouge,
  index: number,
): GougePlace {
  const { at, depth, segments, kind } = gouge;
  const lines = linesOf(segments);
  const radius = Math.abs(radiusOn(result, contourAt(result, lines[0])));
  const where = linesInWords(lines);
  let center: Point | undefined;
  const reason =
    kind === "curvature"
      ? `the tool (radius ${format(radius)} mm) is too large for the bend or corner at ${where}`
      : `the path along one of ${where} comes too near to the other`;
  return {
    kind: "gouge",
    key: `gouge ${index}`,
    title: `${format(depth)} mm too deep`,
    reason: lines.length === 0 ? "the tool is too large" : reason,
    lines,
    at,
    depth,
    radius,
    // Looked for only where it is drawn: of thousands few are in sight.
    get center() {
      center ??= deepest(result.path, starts, at, { away: radius - depth, radius });
      return center;
    },
  };
}

function uncutPlace(result: Result, region: Uncut, index: number): UncutPlace {
  const { area, outline, segments } = region;
  const lines = linesOf(segments);
  const radius = Math.abs(radiusOn(result, contourAt(result, lines[0])));
  const between = lines.length === 2 ? "between" : "at";
  return {
    kind: "uncut",
    key: `uncut ${index}`,
    title: `${format(area)} mm² uncut`,
    reason: `the tool (radius ${format(radius)} mm) does not fit ${between} ${linesInWords(lines)}`,
    lines,
    at: middle(outline),
    area,
    outline,
  };
}

function linesOf(origins: readonly Origin[]): number[] {
  const lines = origins.flatMap((origin) => ("block" in origin ? [origin.block] : []));
  return [...new Set(lines)].sort((a, b) => a - b);
}

/** Where on the path the tool stands when it is at a distance from a point, as near as it comes. */
function deepest(
  { points }: Result["path"],
  starts: ReadonlySet<number>,
  at: Point,
  { away, radius }: { away: number; radius: number },
): Point {
  let best: Point = at;
  // Among the chords near the point alone: there may be as many gouges as there are chords.
  let least = 2 * radius;
  trackOf(points).nearChords(
    at,
    starts,
    () => away + least,
    ({ point }) => {
      const off = Math.abs(distance(point, at) - away);
      if (off < least) {
        least = off;
        best = point;
      }
    },
  );
  return best;
}

/** The centroid of an outline, or its first vertex where it has no area. */
function middle(outline: Float64Array): Point {
  let [twice, x, y] = [0, 0, 0];
  const [x0, y0] = [outline[0] as number, outline[1] as number];
  for (let i = 0; i < outline.length; i += 2) {
    const j = (i + 2) % outline.length;
    const [ax, ay] = [(outline[i] as number) - x0, (outline[i + 1] as number) - y0];
    const [bx, by] = [(outline[j] as number) - x0, (outline[j + 1] as number) - y0];
    const cross = ax * by - bx * ay;
    twice += cross;
    x += (ax + bx) * cross;
    y += (ay + by) * cross;
  }
  return twice === 0 ? [x0, y0] : [x0 + x / (3 * twice), y0 + y / (3 * twice)];
}

function covers(finding: Finding, [x, y]: Point): boolean {
  if (finding.kind === "gouge") return distance(finding.at, [x, y]) <= finding.depth;
  const { outline } = finding;
  let inside = false;
  for (let i = 0, j = outline.length - 2; i < outline.length; j = i, i += 2) {
    const [ax, ay] = [outline[i] as number, outline[i + 1] as number];
    const [bx, by] = [outline[j] as number, outline[j + 1] as number];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  }
  return inside;
}
