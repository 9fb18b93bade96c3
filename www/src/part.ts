// The part: the contours of a program as the page edits them, and the points one can take hold of.

import { arcMiddle, coincide, distance, type Point } from "./geometry";

/** What a block carries besides its motion; kept when its point moves. */
export interface BlockWords {
  /** Lines without motion that stand before the block. */
  readonly before: readonly string[];
  /** A block-skip mark and the N word. */
  readonly number: string;
  /** Modal words such as G41 D1. */
  readonly modal: string;
  /** Further words such as F300, and comments. */
  readonly tail: string;
}

/** A programmed point and its block. */
export interface Node {
  readonly at: Point;
  readonly words?: BlockWords | undefined;
  /** Line of the text, counted from 1. */
  readonly line: number;
}

/** A straight segment. */
export interface LineSegment {
  readonly kind: "line";
  readonly end: Node;
  readonly rapid?: boolean;
}

/** A segment on a circle. */
export interface ArcSegment {
  readonly kind: "arc";
  readonly end: Node;
  readonly center: Point;
  readonly clockwise: boolean;
}

/** A segment through type points; the point before it is its first. */
export interface SplineSegment {
  readonly kind: "spline";
  readonly points: readonly Node[];
}

/** One segment of a contour; it starts where the one before it ends. */
export type Segment = LineSegment | ArcSegment | SplineSegment;

/** What a segment can be changed to. */
export type SegmentKind = Segment["kind"];

/** One contour between the switching on and off of compensation. */
export interface Contour {
  /** First and last line of its blocks, counted from 1. */
  readonly blocks: readonly [first: number, last: number];
  readonly side: "left" | "right";
  readonly start: Node;
  readonly segments: readonly Segment[];
  /** Where the lead-in comes from; its line is 0 where it cannot be moved. */
  readonly leadIn?: Node | undefined;
  readonly leadOut?: Node | undefined;
  /** First and last of the lines that are rewritten when it is edited, counted from 1. */
  readonly extent: readonly [first: number, last: number];
  /** Whether its blocks are plain enough to be rewritten from the picture. */
  readonly editable: boolean;
}

/** All contours of a program. */
export interface Part {
  readonly contours: readonly Contour[];
}

/** What a point is to its contour. */
export type PointRole = "lead-in" | "start" | "end" | "type" | "middle" | "center" | "lead-out";

/** The name of a point that can be moved. */
export interface PointRef {
  readonly contour: number;
  readonly role: PointRole;
  /** The segment it belongs to; −1 where it belongs to none. */
  readonly segment: number;
  /** Which type point of the segment; 0 otherwise. */
  readonly index: number;
}

/** A point that can be moved, and where it is. */
export interface Handle {
  readonly ref: PointRef;
  readonly at: Point;
}

/** Whether two references name the same point. */
export function samePoint(a: PointRef | undefined, b: PointRef | undefined): boolean {
  if (!a || !b) return a === b;
  return (
    a.contour === b.contour && a.role === b.role && a.segment === b.segment && a.index === b.index
  );
}

/** The last node of a segment. */
export function endNode(segment: Segment): Node {
  if (segment.kind !== "spline") return segment.end;
  const last = segment.points.at(-1);
  if (!last) throw new Error("a spline segment has at least one point");
  return last;
}

/** Where segment `index` of a contour starts. */
export function startOf(contour: Contour, index: number): Point {
  const before = contour.segments[index - 1];
  return before ? endNode(before).at : contour.start.at;
}

/** Whether a contour ends where it starts. */
export function isClosed(contour: Contour): boolean {
  const last = contour.segments.at(-1);
  return last !== undefined && coincide(endNode(last).at, contour.start.at);
}

/** Whether a segment is a whole circle. */
export function isCircle(contour: Contour, index: number): boolean {
  const segment = contour.segments[index];
  return segment?.kind === "arc" && coincide(startOf(contour, index), segment.end.at);
}

const known = new WeakMap<Part, readonly Handle[]>();

/** All points of a part that can be moved, in the order of the program. */
export function handles(part: Part): readonly Handle[] {
  const before = known.get(part);
  if (before) return before;
  const list = part.contours.flatMap((contour, c) =>
    contour.editable ? contourHandles(contour, c) : [],
  );
  known.set(part, list);
  return list;
}

function contourHandles(contour: Contour, c: number): Handle[] {
  const list: Handle[] = [];
  const add = (role: PointRole, at: Point, segment = -1, index = 0) =>
    list.push({ ref: { contour: c, role, segment, index }, at });
  if (contour.leadIn && contour.leadIn.line > 0) add("lead-in", contour.leadIn.at);
  add("start", contour.start.at);
  const closed = isClosed(contour);
  contour.segments.forEach((segment, i) => {
    const hidden = closed && i === contour.segments.length - 1;
    if (segment.kind === "spline") {
      segment.points.forEach((node, k) => {
        if (!(hidden && k === segment.points.length - 1)) add("type", node.at, i, k);
      });
      return;
    }
    if (segment.kind === "arc") {
      const from = startOf(contour, i);
      add("center", segment.center, i);
      if (!isCircle(contour, i)) {
        add("middle", arcMiddle(from, segment.end.at, segment.center, segment.clockwise), i);
      }
      if (isCircle(contour, i) && !hidden) return;
    }
    if (!hidden) add("end", segment.end.at, i);
  });
  if (contour.leadOut) add("lead-out", contour.leadOut.at);
  return list;
}

/** Where a point is, if the part still has it. */
export function locate(part: Part, ref: PointRef): Point | undefined {
  return handles(part).find((handle) => samePoint(handle.ref, ref))?.at;
}

/** The segment that a point speaks for: the one it ends or shapes, else the first. */
export function segmentOf(ref: PointRef): number {
  return ref.role === "start" ? 0 : ref.segment;
}

/** What a point is called, in words. */
export function describePoint(part: Part, ref: PointRef): string {
  const segment = part.contours[ref.contour]?.segments[ref.segment];
  const name = segment ? `${segment.kind} ${ref.segment + 1}` : "";
  switch (ref.role) {
    case "lead-in":
      return "Start of the lead-in";
    case "lead-out":
      return "End of the lead-out";
    case "start":
      return "Start of the contour";
    case "type":
      return `Type point ${ref.index + 2} of ${name}`;
    case "center":
      return `Centre of ${name}`;
    case "middle":
      return `Middle of ${name}`;
    case "end":
      return `End of ${name}`;
  }
}

/** The lines of the text that belong to a segment. */
export function linesOf(segment: Segment): readonly number[] {
  return segment.kind === "spline" ? segment.points.map((node) => node.line) : [segment.end.line];
}

/** The segment that a line of the text belongs to. */
export function segmentAtLine(
  part: Part,
  line: number,
): { contour: number; segment: number } | undefined {
  for (const [c, contour] of part.contours.entries()) {
    if (line < contour.blocks[0] || line > contour.blocks[1]) continue;
    const segment = contour.segments.findIndex((candidate) => linesOf(candidate).includes(line));
    if (segment >= 0) return { contour: c, segment };
  }
  return undefined;
}

/** The point that a line of the text programs. */
export function pointAtLine(part: Part, line: number): PointRef | undefined {
  for (const [c, contour] of part.contours.entries()) {
    const ref = (role: PointRole, segment = -1, index = 0) => ({
      contour: c,
      role,
      segment,
      index,
    });
    if (contour.leadIn?.line === line) return ref("lead-in");
    if (contour.start.line === line) return ref("start");
    if (contour.leadOut?.line === line) return ref("lead-out");
    for (const [i, segment] of contour.segments.entries()) {
      const k = linesOf(segment).indexOf(line);
      if (k < 0) continue;
      const last = i === contour.segments.length - 1 && k === linesOf(segment).length - 1;
      if (last && isClosed(contour)) return ref("start");
      if (isCircle(contour, i)) return ref("center", i);
      return segment.kind === "spline" ? ref("type", i, k) : ref("end", i);
    }
  }
  return undefined;
}

/** The line of the text that programs a point. */
export function lineOfPoint(part: Part, ref: PointRef): number | undefined {
  const contour = part.contours[ref.contour];
  if (!contour) return undefined;
  if (ref.role === "lead-in") return contour.leadIn?.line;
  if (ref.role === "lead-out") return contour.leadOut?.line;
  if (ref.role === "start") return contour.start.line;
  const segment = contour.segments[ref.segment];
  if (!segment) return undefined;
  return segment.kind === "spline" ? segment.points[ref.index]?.line : segment.end.line;
}

/** The nearest handle to a point, within a distance [mm]. */
export function nearestHandle(
  list: readonly Handle[],
  p: Point,
  within: number,
): Handle | undefined {
  let best: Handle | undefined;
  let least = within;
  for (const handle of list) {
    // Handles of shape give way to points of the contour where both lie under the pointer.
    const shape = handle.ref.role === "center" || handle.ref.role === "middle";
    const d = distance(handle.at, p) * (shape ? 1.3 : 1);
    if (d <= least) {
      best = handle;
      least = d;
    }
  }
  return best;
}
