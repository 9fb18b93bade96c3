//! Chords of curves, each with a bound of how far the curve leaves it.

use glam::DVec2;

use crate::contour::{Contour, MoveCurve};
use crate::geometry::{Arc, Bounds, Cubic, Curve, cross, sin_cos};

/// Most chords of one curve: reached only where the tolerance is absurdly fine for its size.
const MAX_CHORDS: f64 = 100_000.0;

/// A stretch of a curve and its chord.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    pub(super) start: DVec2,
    pub(super) end: DVec2,
    /// The curve stays within this distance of the chord [mm].
    pub(super) sagitta: f64,
    /// Index of the curve it belongs to.
    pub(super) curve: u32,
    /// Parameters on that curve.
    pub(super) range: [f64; 2],
}

impl Chord {
    pub(super) fn bounds(&self) -> Bounds {
        Bounds::of([self.start, self.end])
    }

    /// Distance of two chords [mm]: zero where they cross, else between an end of one and the
    /// other.
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let side = |c: &Self, p: DVec2| cross(c.end - c.start, p - c.start);
        let parted = |c: &Self, d: &Self| side(c, d.start) * side(c, d.end) > 0.0;
        let ends = [
            distance_to(self, other.start),
            distance_to(self, other.end),
            distance_to(other, self.start),
            distance_to(other, self.end),
        ];
        let nearest = ends.into_iter().fold(f64::INFINITY, f64::min);
        let collinear = side(self, other.start) == 0.0 && side(self, other.end) == 0.0;
        if parted(self, other) || parted(other, self) || collinear { nearest } else { 0.0 }
    }
}

/// Distance of a point from a chord, which may be a point itself.
fn distance_to(chord: &Chord, point: DVec2) -> f64 {
    let along = chord.end - chord.start;
    let length_squared = along.length_squared();
    let t = if length_squared > 0.0 {
        ((point - chord.start).dot(along) / length_squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    point.distance(chord.start + along * t)
}

/// One piece of the contour that can be asked for its nearest point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) curve: MoveCurve,
    /// Index of its segment.
    pub(super) segment: usize,
}

/// The pieces of a contour: lines, arcs and the cubics of its splines.
pub(super) fn pieces(contour: &Contour) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (segment, programmed) in contour.segments().iter().enumerate() {
        let mut add = |curve| pieces.push(Piece { curve, segment });
        match &programmed.curve {
            Curve::Line(line) => add(MoveCurve::Line(*line)),
            Curve::Arc(arc) => add(MoveCurve::Arc(*arc)),
            Curve::Spline(spline) => {
                spline.pieces().iter().copied().map(MoveCurve::Cubic).for_each(add);
            }
        }
    }
    pieces
}

/// Cuts a curve into chords with a sagitta of at most `sagitta` and of about `longest` [mm] at most.
pub(super) fn chords(
    curve: &MoveCurve,
    index: u32,
    sagitta: f64,
    longest: f64,
    chords: &mut Vec<Chord>,
) {
    let (count, length) = match curve {
        MoveCurve::Line(line) => (1.0, line.length()),
        MoveCurve::Arc(arc) => (arc_count(arc, sagitta), arc.length()),
        MoveCurve::Cubic(cubic) => (cubic_count(cubic, sagitta), cubic.hull_length()),
        MoveCurve::Vertical(_) => (1.0, 0.0),
    };
    let count = count.max((length / longest).ceil()).min(MAX_CHORDS);
    let sagitta = match curve {
        MoveCurve::Line(_) | MoveCurve::Vertical(_) => 0.0,
        MoveCurve::Arc(arc) => arc_sagitta(arc, count),
        MoveCurve::Cubic(cubic) => bend(cubic) / (8.0 * count * count),
    };
    let mut start = curve.start();
    let mut k = 0.0;
    while k < count {
        let range = [k / count, (k + 1.0) / count];
        let end = if k + 1.0 == count { curve.end() } else { curve.point(range[1]) };
        chords.push(Chord { start, end, sagitta, curve: index, range });
        start = end;
        k += 1.0;
    }
}

/// Number of equal chords of an arc with a sagitta `R (1 − cos(sweep / 2n))`.
fn arc_count(arc: &Arc, sagitta: f64) -> f64 {
    // acos(1 − x) by the half angle: small angles keep their digits, and one arctangent serves all of
    // the crate.
    let rise = (sagitta / arc.radius()).min(1.0);
    let half_angle = 2.0 * (rise / (2.0 - rise)).sqrt().atan();
    (0.5 * arc.sweep().abs() / half_angle).ceil().max(1.0)
}

/// The sagitta of one of `count` equal chords of an arc.
fn arc_sagitta(arc: &Arc, count: f64) -> f64 {
    // 1 − cos x = 2 sin²(x/2) keeps its digits for small angles.
    arc.radius() * 2.0 * sin_cos(0.25 * arc.sweep() / count).0.powi(2)
}

/// Number of equal steps of a cubic with a sagitta of `max |C''| / 8 n²` at most (Wang).
fn cubic_count(cubic: &Cubic, sagitta: f64) -> f64 {
    (bend(cubic) / (8.0 * sagitta)).sqrt().ceil().max(1.0)
}

/// Largest second derivative of a cubic: at an end, as it is linear.
fn bend(cubic: &Cubic) -> f64 {
    cubic.second_derivative(0.0).length().max(cubic.second_derivative(1.0).length())
}
