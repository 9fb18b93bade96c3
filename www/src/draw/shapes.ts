// Path2D objects of a result in millimetres, made once and kept as long as the result.

import {
  contourAt,
  FIELD,
  forRuns,
  type Lines,
  lineOfMove,
  MoveRole,
  RAPID,
  type Result,
  roleOf,
} from "../result";

/** A contour that encloses an area. */
export interface ClosedShape {
  readonly path: Path2D;
  /** [mm²], positive counter-clockwise. */
  readonly area: number;
  /** Index of the contour. */
  readonly contour: number;
}

/** What the static layer strokes and fills. */
export interface Shapes {
  /** All programmed contours. */
  readonly contour: Path2D;
  readonly closed: readonly ClosedShape[];
  /** The tool path where it is compensated, one for each contour. */
  readonly cuts: readonly Path2D[];
  /** Lead-ins, lead-outs and moves that are not compensated. */
  readonly leads: Path2D;
  readonly rapids: Path2D;
}

const known = new WeakMap<Result, Shapes>();

/** The shapes of a result. */
export function shapesOf(result: Result): Shapes {
  const before = known.get(result);
  if (before) return before;
  const shapes = { ...contourShapes(result), ...pathShapes(result), rapids: rapidShape(result) };
  known.set(result, shapes);
  return shapes;
}

function pathShapes(result: Result): Pick<Shapes, "cuts" | "leads"> {
  const cuts = result.contours.map(() => new Path2D());
  const leads = new Path2D();
  // A run that goes on where the one before it ended is joined to it, for the sake of line joins.
  let end = -1;
  let before: Path2D | undefined;
  forRuns(result.path, (move, first, last) => {
    const role = roleOf(result, move);
    const cut = cuts[contourAt(result, lineOfMove(result, move))];
    if (cut && (role === MoveRole.Segment || role === MoveRole.Transition)) {
      addRun(cut, result.path, first, last, end === first && cut === before);
      end = last;
      before = cut;
    } else {
      addRun(leads, result.path, first, last);
    }
  });
  return { cuts, leads };
}

function rapidShape({ records, stride }: Result): Path2D {
  const rapids = new Path2D();
  // The first rapid is left out: it comes from where the tool stood before, which nobody knows.
  const first = records[FIELD.kind] === RAPID ? stride : 0;
  for (let at = first; at + stride <= records.length; at += stride) {
    if (records[at + FIELD.kind] !== RAPID) continue;
    const [from, to] = [at + FIELD.from, at + FIELD.to];
    rapids.moveTo(records[from] as number, records[from + 1] as number);
    rapids.lineTo(records[to] as number, records[to + 1] as number);
  }
  return rapids;
}

function contourShapes({ programmed }: Result): Pick<Shapes, "contour" | "closed"> {
  const contour = new Path2D();
  const closed: ClosedShape[] = [];
  const count = programmed.points.length / 2;
  programmed.starts.forEach((first, index) => {
    const last = (programmed.starts[index + 1] ?? count) - 1;
    if (last <= first) return;
    const [x0, y0] = vertex(programmed, first);
    const [x1, y1] = vertex(programmed, last);
    const path = new Path2D();
    addRun(path, programmed, first, last);
    if (Math.hypot(x1 - x0, y1 - y0) < 1e-3) {
      path.closePath();
      closed.push({ path, area: area(programmed, first, last), contour: index });
    }
    contour.addPath(path);
  });
  return { contour, closed };
}

function area(lines: Lines, first: number, last: number): number {
  let sum = 0;
  for (let i = first; i < last; i += 1) {
    const [x0, y0] = vertex(lines, i);
    const [x1, y1] = vertex(lines, i + 1);
    sum += x0 * y1 - x1 * y0;
  }
  return sum / 2;
}

/** Adds a run of vertices to a path. */
export function addRun(
  path: Path2D,
  lines: Lines,
  first: number,
  last: number,
  goesOn = false,
): void {
  for (let i = first; i <= last; i += 1) {
    const [x, y] = vertex(lines, i);
    if (i > first) path.lineTo(x, y);
    else if (!goesOn) path.moveTo(x, y);
  }
}

function vertex(lines: Lines, i: number): [x: number, y: number] {
  return [lines.points[2 * i] as number, lines.points[2 * i + 1] as number];
}
