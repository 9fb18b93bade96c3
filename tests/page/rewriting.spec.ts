// Edits of a part and the text they are written to say the same; no browser is needed for it.
import { expect, test } from "@playwright/test";
import { parseProgram } from "g41";
import { deletePoint, insertPoint, middleOf, movePoint, setKind } from "../../www/src/edits";
import { EXAMPLES } from "../../www/src/examples";
import { handles, linesOf, type Part, type PointRef } from "../../www/src/part";
import { partOf, rewrite } from "../../www/src/program-text";

const CASES = 200;
const EDITS = 12;

/** The examples with points that can be moved. */
const EDITABLE = EXAMPLES.filter(({ text }) => handles(read(text)).length > 0);

/** Numbers in [0, 1) from a seed. */
function generator(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function read(text: string): Part {
  return partOf(text, parseProgram(text).contours);
}

/** What must agree exactly: kinds, lines, sides. */
function structure(part: Part): unknown {
  return part.contours.map(({ start, segments, leadIn, leadOut, editable, extent, side }) => ({
    editable,
    extent,
    side,
    lines: [leadIn?.line, start.line, leadOut?.line],
    segments: segments.map((segment) => [segment.kind, ...linesOf(segment)]),
  }));
}

/** What must agree to what a program can write: all points. */
function points(part: Part): number[] {
  return part.contours.flatMap((contour) => {
    const { start, segments, leadIn, leadOut } = contour;
    return [
      ...[leadIn, start, leadOut].flatMap((node) => node?.at ?? []),
      ...segments.flatMap((segment) =>
        segment.kind === "spline" ? segment.points.flatMap(({ at }) => at) : segment.end.at,
      ),
      // The middle of an arc, since the centre of a flat one is far away and says little.
      ...segments.flatMap((_, i) => middleOf(contour, i) ?? []),
    ];
  });
}

/** The largest difference of two lists of coordinates [mm]. */
function gap(a: number[], b: number[]): number {
  return Math.max(...a.map((value, i) => Math.abs(value - (b[i] ?? Number.NaN))));
}

/** One random edit; an edit that is not possible gives the same part. */
function edit(part: Part, random: () => number): { part: Part; contour: number; what: string } {
  const list = handles(part);
  const { ref, at } = list[Math.floor(random() * list.length)] as (typeof list)[number];
  const kind = random();
  const to = [at[0] + random() * 8 - 4, at[1] + random() * 8 - 4].map(
    (value) => Math.round(value * 1000) / 1000,
  ) as [number, number];
  const segment = Math.max(0, ref.segment);
  const done = (edited: Part, what: string) => ({
    part: edited,
    contour: ref.contour,
    what: `${what} ${JSON.stringify(ref satisfies PointRef)} ${to}`,
  });
  if (kind < 0.5) return done(movePoint(part, ref, to), "move");
  if (kind < 0.65) return done(deletePoint(part, ref), "delete");
  if (kind < 0.8) {
    // The page inserts on the segment itself.
    const own = part.contours[ref.contour];
    const on = (own && middleOf(own, segment)) ?? to;
    return done(insertPoint(part, ref.contour, segment, on, 0).part, "insert");
  }
  const kinds = ["line", "arc", "spline"] as const;
  const wanted = kinds[Math.floor(random() * 3)] as (typeof kinds)[number];
  return done(setKind(part, { ...ref, segment }, wanted), `to ${wanted}`);
}

test("what is written is read again as the same part, edit after edit", () => {
  let worst = 0;
  for (let seed = 1; seed <= CASES; seed += 1) {
    const random = generator(seed);
    const example = EDITABLE[seed % EDITABLE.length] as (typeof EXAMPLES)[number];
    let text = example.text;
    let part = read(text);
    const story = [`seed ${seed}, ${example.id}`];
    for (let i = 0; i < EDITS; i += 1) {
      const edited = edit(part, random);
      story.push(edited.what);
      const written = rewrite(text, edited.part, edited.contour);
      const again = read(written.text);
      const told = () => `${story.join("\n")}\n${written.text}`;
      // A matcher for each step would take longer than all edits together.
      const [found, wanted] = [structure(again), structure(written.part)];
      if (JSON.stringify(found) !== JSON.stringify(wanted)) expect(found, told()).toEqual(wanted);
      worst = Math.max(worst, gap(points(again), points(written.part)));
      if (!(worst < 0.0021)) expect(worst, told()).toBeLessThan(0.0021);
      ({ text, part } = written);
    }
  }
  expect(worst).toBeGreaterThan(0);
});

test("writing a part that was not edited changes nothing", () => {
  for (const { text, id } of EXAMPLES) {
    const part = read(text);
    for (const index of part.contours.keys()) {
      expect(rewrite(text, part, index).text, id).toBe(text);
    }
  }
});
