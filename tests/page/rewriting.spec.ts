// Edits of a part and the text they are written to say the same; no browser is needed for it.
import { expect, test } from "@playwright/test";
import { parseProgram } from "g41";
import { deletePoint, insertPoint, middleOf, movePoint, setKind } from "../../www/src/edits";
import { EXAMPLES } from "../../www/src/examples";
import { handles, type Part, type PointRef } from "../../www/src/part";
import { partOf, rewrite } from "../../www/src/program-text";

const CASES = 200;
const EDITS = 12;

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

/** What must agree: points, kinds, centres and lines, to what a program can write. */
function summary(part: Part): unknown {
  const point = (at: readonly [number, number]) =>
    at.map((value) => Math.round(value * 50) / 50 + 0);
  return part.contours.map(({ start, segments, leadIn, leadOut, editable, extent, side }) => ({
    editable,
    extent,
    side,
    nodes: [leadIn, start, leadOut].map((node) => node && [...point(node.at), node.line]),
    segments: segments.map((segment) =>
      segment.kind === "spline"
        ? [segment.kind, ...segment.points.map((node) => [...point(node.at), node.line])]
        : [segment.kind, ...point(segment.end.at), segment.end.line],
    ),
  }));
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
  for (let seed = 1; seed <= CASES; seed += 1) {
    const random = generator(seed);
    const example = EXAMPLES[seed % EXAMPLES.length] as (typeof EXAMPLES)[number];
    let text = example.text;
    let part = read(text);
    const story = [`seed ${seed}, ${example.id}`];
    for (let i = 0; i < EDITS; i += 1) {
      const edited = edit(part, random);
      story.push(edited.what);
      const written = rewrite(text, edited.part, edited.contour);
      expect(summary(read(written.text)), `${story.join("\n")}\n${written.text}`).toEqual(
        summary(written.part),
      );
      ({ text, part } = written);
    }
  }
});

test("writing a part that was not edited changes nothing", () => {
  for (const { text, id } of EXAMPLES) {
    const part = read(text);
    for (const index of part.contours.keys()) {
      expect(rewrite(text, part, index).text, id).toBe(text);
    }
  }
});
