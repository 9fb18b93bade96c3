//! Outside corners of SINUMERIK controls: offsets that run on beyond their ends as the curves they
//! are (G451), and conics between them (G450 with DISC).

use std::f64::consts::PI;

use glam::DVec2;

use super::run::Run;
use super::transition::{CornerFrame, Place, Solution, Terminal, polyline};
use super::type_points::{leg_meets_arc, parameter_beyond};
use crate::contour::MoveCurve;
use crate::geometry::intersect::circles;
use crate::geometry::{Nurbs, in_range, sin_cos};

/// The largest turn at which the tool goes to the intersection (SINUMERIK's
/// `CUTCOM_CORNER_LIMIT`): 100°, in rad. Beyond, the way there and back is idle, and an arc stands
/// in its place.
const LIMIT_TURN: f64 = 100.0 / 180.0 * PI;

/// Rounding of an angle [rad].
const ROUNDED: f64 = 1e-9;

/// How far the point may lie from the corner, as a multiple of the way to where the end tangents
/// meet: farther off, circles only meet elsewhere.
const REACH: f64 = 2.0;

/// Part of the tolerance that the cubics of a conic may use up.
const CONIC_SHARE: f64 = 0.1;

/// Whether a turn [rad] is too sharp to go to the intersection.
pub(super) fn is_too_sharp(turn: f64) -> bool {
    turn.abs() > LIMIT_TURN + ROUNDED
}

/// Both offsets run on to where they meet, lines straight and arcs on their circles; `None` where
/// the corner is too sharp, they do not meet near it, or one is a spline, which is never run on.
pub(super) fn run_on(
    incoming: &Run,
    outgoing: &Run,
    frame: &CornerFrame,
    turn: f64,
) -> Option<Solution> {
    let ([a], [b]) = (incoming.pieces.as_slice(), outgoing.pieces.as_slice()) else { return None };
    if is_too_sharp(turn) {
        return None;
    }
    let v = frame.v();
    let point = match (a, b) {
        (MoveCurve::Line(_), MoveCurve::Line(_)) => v,
        (MoveCurve::Line(line), MoveCurve::Arc(arc))
        | (MoveCurve::Arc(arc), MoveCurve::Line(line)) => leg_meets_arc(line, arc, v)?,
        (MoveCurve::Arc(a), MoveCurve::Arc(b)) => {
            let [first, second] = circles(a, b)?;
            if first.distance(v) <= second.distance(v) { first } else { second }
        }
        _ => return None,
    };
    if !in_range(point) || point.distance(frame.p) > REACH * v.distance(frame.p) {
        return None;
    }
    let mut construction = frame.construction();
    construction.push(("V", point));
    Some(Solution {
        incoming: terminal(incoming, a, point, 1)?,
        outgoing: terminal(outgoing, b, point, 0)?,
        inserted: Vec::new(),
        construction,
    })
}

/// How an offset of one piece ends at a point beyond the given end; `None` where that lies before it,
/// or the offset runs backwards.
fn terminal(run: &Run, piece: &MoveCurve, point: DVec2, end: usize) -> Option<Terminal> {
    // Forwards beyond the end, backwards beyond the start.
    let sign = if end == 1 { 1.0 } else { -1.0 };
    let t = if end == 1 { 1.0 } else { 0.0 };
    if piece.tangent(t).dot(run.tangents[end]) < 0.0 {
        return None;
    }
    if let MoveCurve::Arc(arc) = piece {
        let beyond = parameter_beyond(arc, point, end);
        let place = Place { piece: 0, t: beyond };
        return (sign * (beyond - t) >= 0.0).then_some(Terminal::At(place));
    }
    let way = (point - run.ends[end]).dot(run.tangents[end]);
    (sign * way >= -ROUNDED).then_some(Terminal::To(point))
}

/// A conic from N1 to N2, tangent to both offsets there, whose peak lies by `disc` parts of a hundred
/// of the way from that of the arc about the corner to V; `None` where that is the arc, or the corner
/// is too sharp.
///
/// Above the chord, which is `r cos(φ/2)` from the corner, the peak of a conic of weight w is at
/// `w / (1 + w)` of the way to V, `r / cos(φ/2)` from the corner (Farin, Curves and Surfaces, rational
/// quadratics).
pub(super) fn conic(
    frame: &CornerFrame,
    turn: f64,
    disc: u8,
    tolerance: f64,
) -> Option<Vec<MoveCurve>> {
    if disc == 0 || is_too_sharp(turn) {
        return None;
    }
    let (v, cosine) = (frame.v(), sin_cos(0.5 * turn).1);
    let peak = 1.0 + (1.0 / cosine - 1.0) * 0.01 * f64::from(disc);
    let share = (peak - cosine) / (1.0 / cosine - cosine);
    if disc >= 100 {
        return Some(polyline(&[frame.n1, v, frame.n2]));
    }
    let controls = [(frame.n1, 1.0), (v, share / (1.0 - share)), (frame.n2, 1.0)];
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    let cubics = Nurbs::new(3, knots, &controls).ok()?.cubics(CONIC_SHARE * tolerance).ok()?;
    Some(cubics.into_iter().map(MoveCurve::Cubic).collect())
}
