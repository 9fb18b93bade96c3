// What the tests of the public face share: the built package, and a part to compensate.
import assert from "node:assert/strict";

export * from "../../dist/node.js";
export { default } from "../../dist/node.js";

/** A part with a line, an arc and a spline. */
export const part = {
  start: [0, 0],
  segments: [
    { kind: "line", to: [10, 0] },
    { kind: "arc", to: [20, 10], center: [10, 10], clockwise: false },
    {
      kind: "spline",
      points: [
        [22, 14],
        [18, 20],
        [10, 22],
      ],
    },
  ],
};

export const left = { side: "left", radius: 3 };

/** The same part under G41 in a program, with free moves before and after. */
export const program = `N10 G21 G90
N20 G0 X-20 Y0
N30 G41 D1 G1 X0 Y0 F300
N40 X10
N50 G3 X20 Y10 I0 J10
N60 G5 X22 Y14
N70 G5 X18 Y20
N80 G5 X10 Y22
N90 G40 G1 X-20 Y22
N100 M30
`;

/** States that a call throws an error with this code, and where it is about an argument, this path. */
export function throwsCode(call, code, path) {
  assert.throws(call, (error) => {
    assert.ok(error instanceof Error);
    assert.deepEqual([error.code, error.path], [code, path], error.message);
    return true;
  });
}

/** Distance of two points. */
export function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}
