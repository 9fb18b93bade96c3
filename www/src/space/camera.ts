// How space becomes pixels: a camera far away that is turned about the vertical and tilted.

import type { Point } from "../geometry";
import type { Size } from "../view";
import { type Box3, boxOf3, type Point3, type SpaceStrokes } from "./strokes";

/** Where the camera looks from. */
export interface Camera {
  /** The turn about z, 0 where x goes to the right [rad]. */
  readonly yaw: number;
  /** The height above the plane of x and y, π/2 from straight above [rad]. */
  readonly pitch: number;
  /** [px/mm] */
  readonly scale: number;
  /** What is in the middle of the canvas [mm]. */
  readonly target: Point3;
}

/** Views by name, as yaw and pitch. */
export const VIEWS = {
  iso: { yaw: Math.PI / 5, pitch: Math.PI / 5 },
  top: { yaw: 0, pitch: Math.PI / 2 },
  front: { yaw: 0, pitch: 0 },
  right: { yaw: Math.PI / 2, pitch: 0 },
} as const;

/** Heights of each kind that are looked at. */
const MOST_HEIGHTS = 4000;

/** The directions of the screen in space. */
export function axesOf({ yaw, pitch }: Camera): { right: Point3; up: Point3 } {
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  const lift = Math.sin(pitch);
  return { right: [c, s, 0], up: [-s * lift, c * lift, Math.cos(pitch)] };
}

/** What puts points of space onto the canvas. */
export function projection(camera: Camera, { width, height }: Size): (p: Point3) => Point {
  const { right, up } = axesOf(camera);
  const { scale, target } = camera;
  const dot = (a: Point3, b: Point3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return (p) => {
    const d: Point3 = [p[0] - target[0], p[1] - target[1], p[2] - target[2]];
    return [width / 2 + scale * dot(right, d), height / 2 - scale * dot(up, d)];
  };
}

/** The corners of a box, the lower four first. */
export function cornersOf({ min, max }: Box3): Point3[] {
  return [min[2], max[2]].flatMap((z): Point3[] => [
    [min[0], min[1], z],
    [max[0], min[1], z],
    [max[0], max[1], z],
    [min[0], max[1], z],
  ]);
}

/** The camera that shows a box as large as fits, with a margin [px]. */
export function fitted(camera: Camera, box: Box3, size: Size, margin: number): Camera {
  const target: Point3 = [0, 1, 2].map(
    (axis) => ((box.min[axis] as number) + (box.max[axis] as number)) / 2,
  ) as unknown as Point3;
  const at = cornersOf(box).map(projection({ ...camera, target, scale: 1 }, size));
  const span = (axis: 0 | 1) => {
    const values = at.map((p) => p[axis]);
    return Math.max(Math.max(...values) - Math.min(...values), 1e-3);
  };
  const room = (length: number) => Math.max(40, length - 2 * margin);
  const scale = Math.min(room(size.width) / span(0), room(size.height) / span(1), 1e4);
  return { ...camera, target, scale };
}

/** The camera moved by pixels of the picture. */
export function panned(camera: Camera, dx: number, dy: number): Camera {
  const { right, up } = axesOf(camera);
  const target = camera.target.map(
    (value, i) => value - (dx * (right[i] as number) - dy * (up[i] as number)) / camera.scale,
  ) as unknown as Point3;
  return { ...camera, target };
}

/** The camera nearer or farther, about a place of the canvas, which stays where it is. */
export function zoomed(camera: Camera, factor: number, at: Point, size: Size): Camera {
  const scale = Math.min(1e4, Math.max(1e-3, camera.scale * factor));
  const ratio = scale / camera.scale;
  const [dx, dy] = [at[0] - size.width / 2, at[1] - size.height / 2];
  return panned({ ...camera, scale }, dx * (1 - ratio), dy * (1 - ratio));
}

/** The camera turned and tilted, never head over heels. */
export function turned(camera: Camera, yaw: number, pitch: number): Camera {
  const most = Math.PI / 2;
  const tilt = Math.min(most, Math.max(-most, camera.pitch + pitch));
  return { ...camera, yaw: camera.yaw + yaw, pitch: tilt };
}

/** The box around all strokes but rapid moves; around these where there is nothing else. */
export function boxOfStrokes(all: readonly SpaceStrokes[]): Box3 | undefined {
  const seen = all.filter(({ kind }) => kind !== "rapid").map(({ points }) => points);
  return boxOf3(seen) ?? boxOf3(all.map(({ points }) => points));
}

/** Heights that part the moves that cut into bands with as many vertices each; rising [mm]. */
export function depthsOf(all: readonly SpaceStrokes[], bands: number): number[] {
  const heights: number[] = [];
  for (const { kind, points } of all) {
    if (kind !== "free" && kind !== "cut") continue;
    const step = 3 * Math.max(1, Math.ceil(points.length / 3 / MOST_HEIGHTS));
    for (let i = 2; i < points.length; i += step) heights.push(points[i] as number);
  }
  const sorted = heights.filter((height) => !Number.isNaN(height)).sort((a, b) => a - b);
  const highest = sorted[sorted.length - 1];
  const steps = Array.from(
    { length: bands - 1 },
    (_, i) => sorted[Math.floor(((i + 1) / bands) * sorted.length)],
  );
  return [...new Set(steps)].filter((step) => step !== undefined && step !== highest) as number[];
}

/** The line of the text of the move nearest to a place of the canvas, within a distance [px]. */
export function lineAt(
  all: readonly SpaceStrokes[],
  toScreen: (p: Point3) => Point,
  [x, y]: Point,
  within: number,
): number | undefined {
  let [nearest, found] = [within, undefined as number | undefined];
  for (const { points, lines } of all) {
    let before: Point = [Number.NaN, Number.NaN];
    for (let i = 0; i < lines.length; i += 1) {
      const k = 3 * i;
      const at = toScreen([points[k] as number, points[k + 1] as number, points[k + 2] as number]);
      const [dx, dy] = [at[0] - before[0], at[1] - before[1]];
      const along = ((x - before[0]) * dx + (y - before[1]) * dy) / (dx * dx + dy * dy || 1);
      const part = Math.min(1, Math.max(0, along));
      const far = Math.hypot(x - before[0] - part * dx, y - before[1] - part * dy);
      if (far < nearest && lines[i]) [nearest, found] = [far, lines[i]];
      before = at;
    }
  }
  return found;
}
