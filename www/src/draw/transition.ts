// A transition and its construction: where it lies, and how its points were found.

import type { Transition } from "g41";
import {
  along,
  angleOf,
  arcSweep,
  between,
  direction,
  distance,
  onCircle,
  type Point,
  perp,
} from "../geometry";
import { contourAt, isLeft, type Result } from "../result";
import { toScreen, type View } from "../view";
import { type Caption, type Context, dot, labels, strokeLine } from "./canvas";
import type { Palette } from "./palette";
import { trackOf } from "./track";

/** The line along which the offsets are joined, or for a shortened corner what is cut away. */
export function transitionLine(transition: Transition, result: Result): Point[] {
  const { P, N1, N2, V, A1, A2 } = transition.construction;
  if (!N1 || !N2 || !P) return [];
  if (A1 && A2) return [N1, A1, A2, N2];
  if (V) return [N1, V, N2];
  if (transition.kind === "shortened") return [];
  return cornerArc(P, N1, N2, isLeftAt(transition, result));
}

/** Where on the tool path a transition is marked. */
export function transitionPlace(transition: Transition, result: Result): Point {
  const { P, N1, N2, V, A1, A2 } = transition.construction;
  if (V) return V;
  if (A1 && A2) return between(A1, A2, 0.5);
  if (!P || !N1 || !N2) return transition.corner;
  if (transition.kind !== "shortened") {
    const arc = cornerArc(P, N1, N2, isLeftAt(transition, result));
    return arc[Math.floor(arc.length / 2)] ?? transition.corner;
  }
  // A lead-in ends beside the start of the contour, a lead-out begins beside its end.
  return isOnPath(N2, result) ? N2 : N1;
}

/** A transition that the tool path takes, and where it is marked. */
export interface Marked {
  readonly transition: Transition;
  readonly place: Point;
  /** How far from there its line reaches [mm]. */
  readonly reach: number;
}

const marked = new WeakMap<Result, readonly Marked[]>();

/** The transitions that the tool path takes. */
export function followedTransitions(result: Result): readonly Marked[] {
  const before = marked.get(result);
  if (before) return before;
  const followed = result.transitions.filter((transition) => isFollowed(transition, result));
  const list = followed.map((transition) => {
    const place = transitionPlace(transition, result);
    const line = transitionLine(transition, result);
    return { transition, place, reach: Math.max(0, ...line.map((end) => distance(place, end))) };
  });
  marked.set(result, list);
  return list;
}

const vertices = new WeakMap<Result, Set<string>>();

/** Whether the tool path takes a transition: one that avoids gouges may leave it out. */
function isFollowed(transition: Transition, result: Result): boolean {
  if (result.settings.gouge !== "avoid") return true;
  let known = vertices.get(result);
  if (!known) {
    known = new Set();
    const { points } = result.path;
    for (let i = 0; i + 1 < points.length; i += 2) {
      known.add(nameOf(points[i] as number, points[i + 1] as number));
    }
    vertices.set(result, known);
  }
  const { N1, V, A1 } = transition.construction;
  const place = A1 ?? V ?? N1 ?? transition.corner;
  // To within half a step of the names, whichever step the point falls to.
  const around = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) => [dx, dy] as const));
  return around.some(([dx, dy]) => known.has(nameOf(place[0] + dx * STEP, place[1] + dy * STEP)));
}

/** Points are told apart to this [mm]. */
const STEP = 1e-4;

function nameOf(x: number, y: number): string {
  return `${Math.round(x / STEP)} ${Math.round(y / STEP)}`;
}

/** The tangents T1 and T2 at a corner. */
function tangents(transition: Transition, result: Result): [Point, Point] | undefined {
  const { P, N1, N2 } = transition.construction;
  if (!P || !N1 || !N2 || distance(P, N1) === 0) return undefined;
  // n = σ perp(T), hence T = −σ perp(n).
  const sign = isLeftAt(transition, result) ? -1 : 1;
  return [along([0, 0], perp(direction(P, N1)), sign), along([0, 0], perp(direction(P, N2)), sign)];
}

/** A construction whose normals are shorter has no room for names [px]. */
const LEAST_REACH = 12;

/** Draws how the points of a transition were found: normals, tangents, vertex and angle. */
export function drawConstruction(
  context: Context,
  view: View,
  palette: Palette,
  transition: Transition,
  result: Result,
): void {
  const { P, N1, N2, V, A1, A2 } = transition.construction;
  const both = tangents(transition, result);
  if (!P || !N1 || !N2 || !both) return;
  const color = palette.kinds[transition.kind].color;
  const screen = (point: Point) => toScreen(view, point);
  const line = (points: Point[], width: number, dash: number[] = [], ink = color) =>
    strokeLine(context, points.map(screen), ink, width, dash);
  line([N1, P, N2], 1.25, [], palette.muted);
  if (A1 && A2) {
    line([P, A1], 1.25, [4, 3]);
    line([P, A2], 1.25, [4, 3]);
  }
  if (V) line([P, V], 2);
  line(transitionLine(transition, result), 1.5);
  const angle = drawAngle(context, view, palette, transition, result, both);
  const named = Object.entries(transition.construction);
  const center = screen(P);
  for (const [name, point] of named) {
    const at = screen(point);
    context.lineWidth = 1.5;
    dot(context, at, 3.25, palette.paper, name === "P" ? palette.ink : color);
  }
  const grips = grouped(
    named.filter(([name]) => name !== "P").map(([name, p]) => [name, screen(p)]),
  );
  const names = grips.map(([text, at]): Caption => {
    const clear = Math.max(15, 30 - distance(center, at));
    const wide = text.length > 2 ? 4 * (text.length - 2) * Math.abs(outwards(center, at)[0]) : 0;
    return { text, at: along(at, outwards(center, at), clear + wide) };
  });
  const taken = grips.map(([, at]) => outwards(center, at));
  const corner: Caption = { text: "P", at: along(center, widest(taken, both), 16) };
  // Where the points lie upon each other, nobody sees which is which.
  const isTold = distance(center, screen(N1)) >= LEAST_REACH;
  labels(context, isTold ? [...names, corner, angle] : [angle], palette.ink, palette.paper);
}

/** Names of points that are too near to each other to be told apart, joined. */
function grouped(points: readonly (readonly [string, Point])[]): (readonly [string, Point])[] {
  const groups: (readonly [string, Point])[] = [];
  for (const [name, at] of points) {
    const near = groups.findIndex(([, other]) => distance(at, other) < 11);
    const group = groups[near];
    if (group) groups[near] = [`${group[0]} ${name}`, group[1]];
    else groups.push([name, at]);
  }
  return groups;
}

/** Draws the arc of the angle α, on the side of the workpiece; returns its value and where that belongs. */
function drawAngle(
  context: Context,
  view: View,
  palette: Palette,
  transition: Transition,
  result: Result,
  [, t2]: [Point, Point],
): Caption {
  const [x, y] = toScreen(view, transition.corner);
  const { P, N1 } = transition.construction;
  const reach = P && N1 ? distance(P, N1) * view.scale : 30;
  const radius = Math.min(34, Math.max(16, reach * 0.6));
  const turn = isLeftAt(transition, result) ? -transition.angle : transition.angle;
  const first = Math.atan2(t2[1], t2[0]);
  context.beginPath();
  context.arc(x, y, radius, -first, -(first + turn), turn > 0);
  context.strokeStyle = palette.ink;
  context.lineWidth = 1.25;
  context.stroke();
  const middle = first + turn / 2;
  const text = `α ${((transition.angle * 180) / Math.PI).toFixed(1)}°`;
  // In a narrow corner the value stands where there is room for it.
  const [width, height] = [54, 14];
  const [c, d] = [Math.cos(middle), Math.sin(middle)];
  const across = (width * Math.abs(d) + height * Math.abs(c)) / 2 + 5;
  const deep = (width * Math.abs(c) + height * Math.abs(d)) / 2;
  const narrow = transition.angle < 2 ? across / Math.tan(transition.angle / 2) : 0;
  const out = Math.max(radius + 6, Math.min(100, narrow)) + deep;
  return { text, at: [x + out * c, y - out * d] };
}

function outwards(from: Point, to: Point): Point {
  const d = direction(from, to);
  return d[0] === 0 && d[1] === 0 ? [0, -1] : d;
}

/** On the canvas, the direction from a corner that is farthest from all that is drawn there. */
function widest(taken: readonly Point[], [t1, t2]: readonly [Point, Point]): Point {
  const others: Point[] = [...taken, [-t1[0], t1[1]], [t2[0], -t2[1]]];
  const candidates = Array.from({ length: 16 }, (_, i) => onCircle([0, 0], 1, (i * Math.PI) / 8));
  const room = (p: Point) => Math.min(...others.map((q) => distance(p, q)));
  return candidates.reduce((best, p) => (room(p) > room(best) + 1e-9 ? p : best));
}

function cornerArc(center: Point, from: Point, to: Point, clockwise: boolean): Point[] {
  const sweep = arcSweep(from, to, center, clockwise);
  const count = 24;
  return Array.from({ length: count + 1 }, (_, i) =>
    onCircle(center, distance(center, from), angleOf(center, from) + (sweep * i) / count),
  );
}

function isLeftAt({ origin }: Transition, result: Result): boolean {
  return isLeft(result, contourAt(result, "block" in origin ? origin.block : undefined));
}

function isOnPath(point: Point, { path }: Result): boolean {
  let found = false;
  const near = () => (found ? -1 : 1e-3);
  trackOf(path.points).near(point, near, (first, end) => {
    for (let i = first; i <= end; i += 1) {
      const [x, y] = [path.points[2 * i] as number, path.points[2 * i + 1] as number];
      found ||= Math.abs(x - point[0]) + Math.abs(y - point[1]) < 1e-3;
    }
  });
  return found;
}
