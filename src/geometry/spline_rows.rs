//! The linear system of the C2 cubic spline: rows for its joints and ends, and its derivatives.

use glam::DVec2;

use super::Cubic;
use super::spline::EndCondition;
use super::tridiagonal::{Row, solve, solve_cyclic};

/// Parameter values of the type points, and the cubics between them.
pub(super) fn spans_of(
    points: &[DVec2],
    intervals: &[f64],
    derivatives: &[DVec2],
) -> (Vec<f64>, Vec<Cubic>) {
    let mut knots = Vec::with_capacity(points.len());
    let mut pieces = Vec::with_capacity(intervals.len());
    knots.push(0.0);
    for (i, &h) in intervals.iter().enumerate() {
        knots.push(knots[i] + h);
        let (d0, d1) = (derivatives[i] * h, derivatives[i + 1] * h);
        pieces.push(Cubic::hermite(points[i], d0, points[i + 1], d1));
    }
    (knots, pieces)
}

/// The row that makes the second derivative continuous at a type point with the span `before`
/// behind and the span `after` ahead of it (de Boor, A Practical Guide to Splines, ch. IV).
pub(super) fn continuity_row(before: (DVec2, f64), after: (DVec2, f64)) -> Row {
    let ((chord0, h0), (chord1, h1)) = (before, after);
    Row {
        lower: h1,
        diagonal: 2.0 * (h0 + h1),
        upper: h0,
        right: (chord0 * (h1 / h0) + chord1 * (h0 / h1)) * 3.0,
    }
}

/// Chord and parameter interval of span `i`.
fn span(points: &[DVec2], intervals: &[f64], i: usize) -> (DVec2, f64) {
    (points[i + 1] - points[i], intervals[i])
}

/// Derivatives at the type points of an open spline.
pub(super) fn open_derivatives(
    points: &[DVec2],
    intervals: &[f64],
    start: EndCondition,
    end: EndCondition,
) -> Vec<DVec2> {
    let last = points.len() - 1;
    let mut rows = Vec::with_capacity(points.len());
    for i in 0..=last {
        rows.push(if i == 0 {
            let next = (last > 2).then(|| span(points, intervals, 1));
            end_row(start, span(points, intervals, 0), next, false)
        } else if i == last {
            let next = (last > 2).then(|| span(points, intervals, last - 2));
            end_row(end, span(points, intervals, last - 1), next, true)
        } else {
            continuity_row(span(points, intervals, i - 1), span(points, intervals, i))
        });
    }
    solve(&rows)
}

/// The row of an end's condition: the chord and the interval of the span there, and of the span next
/// to it where there are three or more.
pub(super) fn end_row(
    condition: EndCondition,
    (chord, h): (DVec2, f64),
    next: Option<(DVec2, f64)>,
    at_end: bool,
) -> Row {
    let (diagonal, beside, right) = match (condition, next) {
        (EndCondition::Natural, _) => (2.0, 1.0, chord * (3.0 / h)),
        // The speed of the chord: the given direction bends the curve, its length does not.
        (EndCondition::Tangent(tangent), _) => {
            (1.0, 0.0, tangent.normalize_or(chord.normalize()) * (chord.length() / h))
        }
        // One third derivative on both sides of the joint (de Boor, ch. IV).
        (EndCondition::NotAKnot, Some((next_chord, k))) => {
            let both = h + k;
            let right = chord * (k * (h + 2.0 * both) / h) + next_chord * (h * h / k);
            (k, both, right / both)
        }
        (EndCondition::NotAKnot, None) => (1.0, 1.0, chord * (2.0 / h)),
    };
    let (lower, upper) = if at_end { (beside, 0.0) } else { (0.0, beside) };
    Row { lower, diagonal, upper, right }
}

/// Derivatives at the type points of a periodic spline, the first repeated as the last.
pub(super) fn periodic_derivatives(points: &[DVec2], intervals: &[f64]) -> Vec<DVec2> {
    let spans = points.len() - 1;
    let rows: Vec<Row> = (0..spans)
        .map(|i| {
            let before = if i == 0 { spans - 1 } else { i - 1 };
            continuity_row(span(points, intervals, before), span(points, intervals, i))
        })
        .collect();
    let mut derivatives = solve_cyclic(&rows);
    derivatives.push(derivatives[0]);
    derivatives
}
