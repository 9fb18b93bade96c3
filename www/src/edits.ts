// Edits of a part: each takes a part and returns another.

import {
  along,
  angleOf,
  arcMiddle,
  arcSweep,
  between,
  centerOfSweep,
  circleThrough,
  coincide,
  direction,
  distance,
  onCircle,
  type Point,
  perp,
  turnsRight,
} from "./geometry";
import {
  type BlockWords,
  type Contour,
  endNode,
  isCircle,
  isClosed,
  type Node,
  type Part,
  type PointRef,
  type Segment,
  type SegmentKind,
  startOf,
} from "./part";

/** Fewest type points of a spline after its start: with fewer it is a straight line. */
const LEAST_TYPE_POINTS = 2;

/** Moves a point; arcs keep their sweep, and points that coincide by intent stay together. */
export function movePoint(part: Part, ref: PointRef, to: Point): Part {
  return change(part, ref.contour, (contour) => {
    switch (ref.role) {
      case "lead-in":
        return contour.leadIn ? { ...contour, leadIn: { ...contour.leadIn, at: to } } : contour;
      case "lead-out":
        return contour.leadOut ? { ...contour, leadOut: { ...contour.leadOut, at: to } } : contour;
      case "type":
        return ref.index === lastIndex(contour, ref.segment)
          ? moveEnd(contour, ref.segment + 1, to)
          : replaceSegment(contour, ref.segment, (segment) =>
              segment.kind === "spline"
                ? { ...segment, points: withNode(segment.points, ref.index, to) }
                : segment,
            );
      case "middle":
        return moveMiddle(contour, ref.segment, to);
      case "center":
        return moveCenter(contour, ref.segment, to);
      case "start":
        return moveEnd(contour, 0, to);
      case "end":
        return moveEnd(contour, ref.segment + 1, to);
    }
  });
}

/** A part with a new point on a segment, and that point. */
export function insertPoint(
  part: Part,
  contourIndex: number,
  segmentIndex: number,
  at: Point,
  /** For a spline: before which of its type points. */
  before: number,
): { part: Part; ref: PointRef } {
  const segment = part.contours[contourIndex]?.segments[segmentIndex];
  const role = segment?.kind === "spline" ? "type" : "end";
  const ref: PointRef = { contour: contourIndex, role, segment: segmentIndex, index: 0 };
  const node: Node = { at, line: 0 };
  const inserted = change(part, contourIndex, (contour) => {
    const segments = [...contour.segments];
    if (!segment) return contour;
    if (segment.kind === "spline") {
      const points = [...segment.points];
      points.splice(before, 0, node);
      segments[segmentIndex] = { ...segment, points };
    } else {
      const first: Segment =
        segment.kind === "arc"
          ? { ...segment, end: node, center: [...segment.center] }
          : { ...segment, end: node };
      segments.splice(segmentIndex, 0, first);
    }
    return { ...contour, segments };
  });
  return { part: inserted, ref: role === "type" ? { ...ref, index: before } : ref };
}

/** Whether a point can be deleted. */
export function canDelete(part: Part, ref: PointRef): boolean {
  const contour = part.contours[ref.contour];
  if (!contour?.editable) return false;
  if (ref.role === "type") return true;
  return (ref.role === "end" || ref.role === "start") && contour.segments.length > 1;
}

/** Deletes a point; the segment that ended in it gives way to the next one. */
export function deletePoint(part: Part, ref: PointRef): Part {
  if (!canDelete(part, ref)) return part;
  return change(part, ref.contour, (contour) => {
    if (ref.role === "start") return deleteStart(contour);
    const segment = contour.segments[ref.segment];
    if (ref.role === "type" && segment?.kind === "spline") {
      const points = segment.points.filter((_, k) => k !== ref.index);
      const removed = segment.points[ref.index] as Node;
      const heir = points[ref.index];
      if (heir) points[ref.index] = inherit(heir, removed);
      const last = points.at(-1);
      if (!last) return deleteSegment(contour, ref.segment);
      const spline: Segment =
        points.length < LEAST_TYPE_POINTS
          ? { kind: "line", end: last }
          : { kind: "spline", points };
      return refit(
        contour,
        replaceSegment(contour, ref.segment, () => spline),
      );
    }
    return deleteSegment(contour, ref.segment);
  });
}

/** Changes a segment into another kind with the same ends. */
export function setKind(part: Part, ref: PointRef, kind: SegmentKind): Part {
  return change(part, ref.contour, (contour) => {
    const from = startOf(contour, ref.segment);
    return replaceSegment(contour, ref.segment, (segment) =>
      segment.kind === kind ? segment : convert(segment, from, kind, contour.side),
    );
  });
}

function convert(segment: Segment, from: Point, kind: SegmentKind, side: string): Segment {
  const end = endNode(segment);
  const outwards = along([0, 0], perp(direction(from, end.at)), side === "left" ? 1 : -1);
  const chord = distance(from, end.at);
  if (coincide(from, end.at)) return convertClosed(segment, from, kind);
  switch (kind) {
    case "line":
      return { kind, end };
    case "arc": {
      const points = segment.kind === "spline" ? segment.points : [];
      const shape = points[Math.floor((points.length - 1) / 2)]?.at;
      const bulge = along(between(from, end.at, 0.5), outwards, chord / 5);
      const middle = shape && circleThrough(from, shape, end.at) ? shape : bulge;
      const center = circleThrough(from, middle, end.at)?.center ?? between(from, end.at, 0.5);
      return { kind, end, center, clockwise: turnsRight(from, middle, end.at) };
    }
    case "spline": {
      const places =
        segment.kind === "arc"
          ? quarters(from, segment.end.at, segment.center, segment.clockwise)
          : [1 / 3, 2 / 3].map((t) => along(between(from, end.at, t), outwards, chord / 10));
      return { kind, points: [...places.map((at) => ({ at, line: 0 })), end] };
    }
  }
}

/** A segment that ends where it starts can be a circle or a spline, but not a line. */
function convertClosed(segment: Segment, from: Point, kind: SegmentKind): Segment {
  const end = endNode(segment);
  if (kind === "arc" && segment.kind === "spline") {
    const { points } = segment;
    const opposite = points[Math.floor((points.length - 1) / 2)]?.at ?? from;
    const quarter = points[Math.floor((points.length - 1) / 4)]?.at ?? from;
    if (coincide(opposite, from)) return segment;
    const clockwise = turnsRight(from, quarter, opposite);
    return { kind, end, center: between(from, opposite, 0.5), clockwise };
  }
  if (kind === "spline" && segment.kind === "arc") {
    const places = quarters(from, end.at, segment.center, segment.clockwise);
    return { kind, points: [...places.map((at) => ({ at, line: 0 })), end] };
  }
  return segment;
}

/** Points on an arc between its ends. */
function quarters(from: Point, to: Point, center: Point, clockwise: boolean): Point[] {
  const sweep = arcSweep(from, to, center, clockwise);
  const count = Math.max(2, Math.round(Math.abs(sweep) / (Math.PI / 4)));
  const radius = distance(center, from);
  return Array.from({ length: count - 1 }, (_, k) =>
    onCircle(center, radius, angleOf(center, from) + (sweep * (k + 1)) / count),
  );
}

function change(part: Part, index: number, edit: (contour: Contour) => Contour): Part {
  return { contours: part.contours.map((contour, c) => (c === index ? edit(contour) : contour)) };
}

function replaceSegment(
  contour: Contour,
  index: number,
  edit: (segment: Segment) => Segment,
): Contour {
  return {
    ...contour,
    segments: contour.segments.map((segment, i) => (i === index ? edit(segment) : segment)),
  };
}

function withNode(nodes: readonly Node[], index: number, at: Point): Node[] {
  return nodes.map((node, k) => (k === index ? { ...node, at } : node));
}

function lastIndex(contour: Contour, index: number): number {
  const segment = contour.segments[index];
  return segment?.kind === "spline" ? segment.points.length - 1 : 0;
}

function withEnd(segment: Segment, at: Point): Segment {
  if (segment.kind !== "spline") return { ...segment, end: { ...segment.end, at } };
  return { ...segment, points: withNode(segment.points, segment.points.length - 1, at) };
}

/** Moves corner `corner` of a contour: 0 is its start, i + 1 the end of segment i. */
function moveEnd(contour: Contour, corner: number, to: Point): Contour {
  const last = contour.segments.length;
  const moved = new Set([corner]);
  if (isClosed(contour) && (corner === 0 || corner === last)) moved.add(0).add(last);
  contour.segments.forEach((_, i) => {
    if (isCircle(contour, i) && (moved.has(i) || moved.has(i + 1))) moved.add(i).add(i + 1);
  });
  const segments = contour.segments.map((segment, i) =>
    moved.has(i + 1) ? withEnd(segment, to) : segment,
  );
  const start = moved.has(0) ? { ...contour.start, at: to } : contour.start;
  return refit(contour, { ...contour, start, segments });
}

/** Gives arcs whose ends differ from those before the edit a centre that keeps their sweep. */
function refit(before: Contour, after: Contour): Contour {
  // An arc is recognised by its centre: the one object that an edit of its ends leaves alone.
  const olds = new Map<unknown, number>();
  before.segments.forEach((segment, i) => {
    if (segment.kind === "arc") olds.set(segment.center, i);
  });
  return {
    ...after,
    segments: after.segments.map((segment, i) => {
      if (segment.kind !== "arc") return segment;
      const k = olds.get(segment.center);
      const old = k === undefined ? undefined : before.segments[k];
      if (k === undefined || old?.kind !== "arc") return segment;
      const [from, to] = [startOf(after, i), segment.end.at];
      const [oldFrom, oldTo] = [startOf(before, k), old.end.at];
      if (isCircle(before, k) || coincide(from, to)) return segment;
      if (distance(from, oldFrom) === 0 && distance(to, oldTo) === 0) return segment;
      const sweep = arcSweep(oldFrom, oldTo, old.center, old.clockwise);
      return { ...segment, center: centerOfSweep(from, to, sweep) };
    }),
  };
}

function moveMiddle(contour: Contour, index: number, to: Point): Contour {
  const from = startOf(contour, index);
  return replaceSegment(contour, index, (segment) => {
    if (segment.kind !== "arc") return segment;
    const circle = circleThrough(from, to, segment.end.at);
    // An arc is never quite straight: it stays as flat as it was.
    if (!circle || circle.radius > 1e4) return segment;
    const clockwise = turnsRight(from, to, segment.end.at);
    return { ...segment, center: circle.center, clockwise };
  });
}

function moveCenter(contour: Contour, index: number, to: Point): Contour {
  const from = startOf(contour, index);
  return replaceSegment(contour, index, (segment) => {
    if (segment.kind !== "arc") return segment;
    if (isCircle(contour, index)) return coincide(to, from) ? segment : { ...segment, center: to };
    // The centre can only move along the perpendicular bisector of the chord.
    const half = between(from, segment.end.at, 0.5);
    const axis = perp(direction(from, segment.end.at));
    const height = (to[0] - half[0]) * axis[0] + (to[1] - half[1]) * axis[1];
    return { ...segment, center: along(half, axis, height) };
  });
}

function deleteSegment(contour: Contour, index: number): Contour {
  const removed = contour.segments[index];
  if (!removed || contour.segments.length < 2) return contour;
  const heir = contour.segments[index + 1];
  const segments = contour.segments.filter((_, i) => i !== index);
  if (heir) {
    const node = endNode(removed);
    segments[index] =
      heir.kind === "spline"
        ? { ...heir, points: heir.points.map((p, k) => (k === 0 ? inherit(p, node) : p)) }
        : { ...heir, end: inherit(heir.end, node) };
  }
  return refit(contour, { ...contour, segments });
}

/** Deletes the first point of a contour; a closed one stays closed. */
function deleteStart(contour: Contour): Contour {
  const [first, ...rest] = contour.segments;
  if (!first || rest.length === 0) return contour;
  const to = endNode(first).at;
  const last = rest.length - 1;
  const segments = isClosed(contour)
    ? rest.map((segment, i) => (i === last ? withEnd(segment, to) : segment))
    : rest;
  return refit(contour, { ...contour, start: { ...contour.start, at: to }, segments });
}

/** Hands the lines and words of a deleted block on to the one after it. */
function inherit(heir: Node, removed: Node): Node {
  const [own, left] = [heir.words, removed.words];
  if (!left) return heir;
  const words: BlockWords = {
    before: [...left.before, ...(own?.before ?? [])],
    number: own?.number ?? "",
    modal: own?.modal || left.modal,
    tail: own?.tail || left.tail,
  };
  return { ...heir, words };
}

/** The point half way along an arc segment. */
export function middleOf(contour: Contour, index: number): Point | undefined {
  const segment = contour.segments[index];
  if (segment?.kind !== "arc") return undefined;
  return arcMiddle(startOf(contour, index), segment.end.at, segment.center, segment.clockwise);
}
