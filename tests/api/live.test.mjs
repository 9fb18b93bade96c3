// A contour that is edited live: its polylines, what has changed of them, and what is refused.
import assert from "node:assert/strict";
import { test } from "node:test";

import { compensate, LiveContour } from "../../dist/node.js";

const options = { side: "right", radius: 3 };

function part() {
  return {
    start: [0, 0],
    segments: [
      { kind: "line", to: [40, 0] },
      { kind: "arc", to: [50, 10], center: [40, 10], clockwise: false },
      {
        kind: "spline",
        points: [
          [48, 22],
          [36, 27],
          [20, 24],
          [0, 30],
        ],
      },
    ],
  };
}

/** Points without those that repeat the one before. */
function distinct(points) {
  const list = [];
  for (let i = 0; i < points.length; i += 2) {
    const [x, y] = [points[i], points[i + 1]];
    const last = list.at(-1);
    if (!last || Math.hypot(x - last[0], y - last[1]) > 1e-9) list.push([x, y]);
  }
  return list;
}

/** Asserts that the live path is that of a contour computed afresh. */
function same(live, contour) {
  const { points, starts } = live.update();
  // Before the next call, which may move the memory that they are views of.
  const own = distinct(points);
  assert.deepEqual([...starts], [0]);
  const fresh = distinct(compensate(contour, options).polyline());
  assert.equal(own.length, fresh.length);
  own.forEach(([x, y], i) => {
    assert.ok(Math.hypot(x - fresh[i][0], y - fresh[i][1]) < 1e-8, `vertex ${i}`);
  });
}

test("edits give the path of the edited contour", () => {
  const live = new LiveContour(part(), options);
  same(live, part());
  const edited = part();
  edited.segments[2].points[1] = [37, 29];
  live.movePoint(2, 1, 37, 29);
  same(live, edited);
  edited.segments[2].points.splice(2, 0, [28, 26]);
  live.insertPoint(2, 2, 28, 26);
  same(live, edited);
  edited.segments[2].points.splice(0, 1);
  live.removePoint(2, 0);
  same(live, edited);
  edited.start = [-5, 1];
  live.movePoint(-1, 0, -5, 1);
  same(live, edited);
  edited.segments[0].to = [40, 1];
  edited.segments[1].center = [40, 11];
  live.movePoint(1, 1, 40, 11);
  live.movePoint(0, 0, 40, 1);
  edited.segments[1].to = [50, 11];
  live.movePoint(1, 0, 50, 11);
  same(live, edited);
  edited.segments[1] = { kind: "line", to: [52, 8] };
  live.setSegment(1, edited.segments[1]);
  same(live, edited);
  assert.deepEqual(live.path().records(), compensate(edited, options).records());
});

test("options change, and those that are not given stay", () => {
  const live = new LiveContour(part(), { ...options, chordTolerance: 0.01 });
  const coarse = live.update().points.length;
  live.set({ chordTolerance: 1e-4 });
  const fine = live.update().points.length;
  assert.ok(fine > 2 * coarse, `${fine} numbers after ${coarse}`);
  live.set({ radius: 4 });
  assert.deepEqual(
    live.path().records(),
    compensate(part(), { side: "right", radius: 4 }).records(),
  );
  const { points } = live.update();
  const before = points.slice();
  live.set();
  assert.deepEqual(live.update().points, before, "nothing given is nothing changed");
});

test("options are taken as they are when they are given", () => {
  const given = { ...options };
  const live = new LiveContour(part(), given);
  given.radius = 4;
  live.set({ tolerance: 0.001 });
  assert.deepEqual(live.path().records(), compensate(part(), options).records());
});

test("an update tells the range of vertices that have changed", () => {
  const count = 3000;
  const points = Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * ((i + 1) % count)) / count;
    const reach = 2400 + 8 * Math.sin(150 * angle);
    return [reach * Math.cos(angle), reach * Math.sin(angle)];
  });
  const contour = { start: points.at(-1), closed: true, segments: [{ kind: "spline", points }] };
  const live = new LiveContour(contour, { side: "left", radius: 5 });
  const first = live.update();
  assert.deepEqual([first.from, first.to], [0, first.points.length / 2]);
  const outline = first.contour;
  assert.deepEqual([outline.from, outline.to], [0, outline.points.length / 2]);
  const before = first.points.slice();
  const none = live.update();
  assert.deepEqual([none.from, none.contour.from], [none.to, none.contour.to]);
  const [x, y] = points[1000];
  live.movePoint(0, 1000, x + 0.5, y);
  const { points: after, from, to } = live.update();
  assert.ok(to > from && to - from < 3000, `${to - from} vertices of ${after.length / 2}`);
  for (let i = 0; i < after.length / 2; i += 1) {
    const moved = after[2 * i] !== before[2 * i] || after[2 * i + 1] !== before[2 * i + 1];
    assert.ok(!moved || (i >= from && i < to), `vertex ${i} has changed outside ${from} to ${to}`);
  }
});

test("views are of the memory as it is after it has grown", () => {
  const live = new LiveContour(part(), options);
  live.update();
  const count = 200_000;
  const points = new Float64Array(2 * count).map((_, i) => (i % 2 ? Math.sin(i) : 2.5 * i));
  const huge = { start: [-5, 0], segments: [{ kind: "spline", points }] };
  const other = new LiveContour(huge, options);
  other.update();
  live.movePoint(2, 1, 37, 28);
  const edited = part();
  edited.segments[2].points[1] = [37, 28];
  same(live, edited);
});

test("what cannot be edited is refused with its place", () => {
  const live = new LiveContour(part(), options);
  const bad = (path) => ({ code: "bad-argument", path });
  assert.throws(() => live.movePoint(3, 0, 1, 1), bad("segment"));
  assert.throws(() => live.movePoint(0, 1, 1, 1), bad("index"));
  assert.throws(() => live.movePoint(-1, 1, 1, 1), bad("segment"));
  assert.throws(() => live.movePoint(2, 0.5, 1, 1), bad("index"));
  assert.throws(() => live.movePoint(2, 0, Number.NaN, 1), bad("x"));
  assert.throws(() => live.insertPoint(0, 0, 1, 1), bad("segment"));
  assert.throws(() => live.removePoint(2, 4), bad("index"));
  assert.throws(() => live.setSegment(0, { kind: "line" }), bad("segment.to"));
  assert.throws(() => live.set({ radius: "3" }), bad("options.radius"));
  assert.throws(() => new LiveContour([part(), part()], options), bad("contour"));
  assert.throws(() => new LiveContour(part(), { radius: 3 }), bad("options.side"));
  assert.throws(() => new LiveContour(part(), { ...options, chords: 1 }), bad("options.chords"));
});

test("a contour that was given back cannot be edited", () => {
  const live = new LiveContour(part(), options);
  live[Symbol.dispose]();
  assert.throws(() => live.update(), { code: "disposed" });
});
