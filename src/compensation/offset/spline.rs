//! The offset of a spline: cubics within the tolerance of the true equidistant.
//!
//! Each span is cut at the cusps of its offset, where `1 − δκ` changes its sign. A piece is the
//! cubic with the exact end points and end derivatives `O' = C' (1 − δκ)` of the equidistant; its
//! error falls with the fourth power of its length, which tells how many pieces a stretch needs.
//! The error is measured at sample points: where a sample stands at right angles over the spline,
//! its distance from the equidistant is exactly the excess of its distance from the spline.

use std::f64::consts::PI;

use glam::DVec2;

use super::{Bend, cusps::cusps};
use crate::contour::MoveCurve;
use crate::geometry::{Arc, Cubic, MIN_LENGTH, Spline, cross, perp};

/// Parameters of a piece at which its error is measured. The error of a Hermite cubic is
/// `t² (1 − t)²` times a smooth function, so these see its largest value but for a few percent.
const SAMPLES: [f64; 5] = [0.15, 0.32, 0.5, 0.68, 0.85];

/// Part of the tolerance that the measured error may use; the rest is for what lies between the
/// samples.
const SAFETY: f64 = 0.9;

/// Most pieces a stretch is cut into at once; a worse estimate is cut again.
const MAX_CUTS: f64 = 64.0;

/// Stretches of a span shorter than this are not cut further: 1e-9 of a cubic has no inner shape.
const SHORTEST: f64 = 1e-9;

/// The offset of a spline.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::compensation) struct SplineOffset {
    /// Cubics that follow each other, and arcs around cusps of the spline itself.
    pub(in crate::compensation) pieces: Vec<MoveCurve>,
    /// Where the spline bends tighter than the tool.
    pub(in crate::compensation) bends: Vec<Bend>,
}

/// The spline offset by `offset` [mm] to its left, within `tolerance` [mm].
pub(in crate::compensation) fn offset_spline(
    spline: &Spline,
    offset: f64,
    tolerance: f64,
) -> SplineOffset {
    let mut pieces = Vec::with_capacity(spline.pieces().len());
    // Stretches that the tool does not fit into, as (span, from, to).
    let mut tight: Vec<(usize, f64, f64)> = Vec::new();
    for (span, cubic) in spline.pieces().iter().enumerate() {
        let halves = cut_at_standstill(cubic);
        for part in &halves {
            let mut from = 0.0;
            for to in cusps(&part.cubic, offset).into_iter().chain([1.0]) {
                let middle = 0.5 * (from + to);
                let fits = super::cusps::room(&part.cubic, offset, middle) >= 0.0;
                if !fits {
                    tight.push((span, part.at(from), part.at(to)));
                }
                let stretch = Stretch { cubic: &part.cubic, offset, from, to };
                stretch.fit(SAFETY * tolerance, &mut pieces, offset);
                from = to;
            }
        }
    }
    let bends = bends(spline, offset, &tight);
    SplineOffset { pieces, bends }
}

/// A part of a span between two standstills of the spline.
struct Part {
    cubic: Cubic,
    from: f64,
    to: f64,
}

impl Part {
    /// Parameter on the span of `t` on the part.
    fn at(&self, t: f64) -> f64 {
        self.from + (self.to - self.from) * t
    }
}

/// Cuts a cubic where it stands still and turns back, as a spline through type points on one
/// line does that double back; most cubics are left whole.
fn cut_at_standstill(cubic: &Cubic) -> Vec<Part> {
    let whole = || vec![Part { cubic: *cubic, from: 0.0, to: 1.0 }];
    let d = cubic.hodograph();
    let chord = cubic.end() - cubic.start();
    if d.iter().all(|v| v.dot(chord) > 0.0) {
        return whole();
    }
    // |C'|² is least where C' · C'' = 0, a cubic in Bernstein form.
    let (e0, e1) = (d[1] - d[0], d[2] - d[1]);
    let slope = [
        d[0].dot(e0),
        (2.0 * d[1].dot(e0) + d[0].dot(e1)) / 3.0,
        (d[2].dot(e0) + 2.0 * d[1].dot(e1)) / 3.0,
        d[2].dot(e1),
    ];
    let scale = cubic.hull_length();
    let stands = |t: f64| cubic.derivative(t).length() <= 1e-7 * scale;
    let still: Vec<f64> = crate::geometry::roots(slope)
        .into_iter()
        .filter(|&t| t > SHORTEST && t < 1.0 - SHORTEST && stands(t))
        .collect();
    if still.is_empty() {
        return whole();
    }
    let ends = [0.0].into_iter().chain(still).chain([1.0]).collect::<Vec<_>>();
    ends.windows(2).map(|w| Part { cubic: cubic.part(w[0], w[1]), from: w[0], to: w[1] }).collect()
}

/// A part of one cubic, and the offset asked for.
#[derive(Clone, Copy)]
struct Stretch<'a> {
    cubic: &'a Cubic,
    offset: f64,
    from: f64,
    to: f64,
}

impl Stretch<'_> {
    /// Appends pieces within `tolerance` of the offset of the stretch.
    fn fit(&self, tolerance: f64, pieces: &mut Vec<MoveCurve>, offset: f64) {
        let piece = self.hermite();
        if let Some(last) = pieces.last() {
            join(last.end(), piece.start(), self.cubic.point(self.from), offset, pieces);
        }
        self.fit_from(&piece, tolerance, pieces);
    }

    fn fit_from(&self, piece: &Cubic, tolerance: f64, pieces: &mut Vec<MoveCurve>) {
        let error = self.error(piece);
        // A piece shorter than the tolerance is within it whatever it does in between: at cusps.
        let done = error <= tolerance
            || piece.hull_length() <= tolerance
            || self.to - self.from < SHORTEST;
        if done {
            if piece.hull_length() >= MIN_LENGTH {
                pieces.push(MoveCurve::Cubic(*piece));
            }
            return;
        }
        let cuts = (error / tolerance).powf(0.25).ceil().clamp(2.0, MAX_CUTS);
        let mut i = 0.0;
        while i < cuts {
            let at = |k: f64| self.from + (self.to - self.from) * (k / cuts);
            let to = if i + 1.0 == cuts { self.to } else { at(i + 1.0) };
            let part = Self { from: if i == 0.0 { self.from } else { at(i) }, to, ..*self };
            part.fit_from(&part.hermite(), tolerance, pieces);
            i += 1.0;
        }
    }

    /// Point and derivative of the offset at `t`, the derivative by the cubic's parameter.
    fn offset_frame(&self, t: f64) -> (DVec2, DVec2) {
        let first = self.cubic.derivative(t);
        let second = self.cubic.second_derivative(t);
        let speed = first.length();
        let scale = self.cubic.hull_length();
        // At a standstill the normal is that of the way on, and the offset stands still too but
        // for a turn that `join` makes.
        let inside = 1e-6 * (self.to - self.from);
        let toward = if t == self.to { t - inside } else { t + inside };
        if speed <= 1e-7 * scale {
            let along = self.cubic.derivative(toward).normalize_or(DVec2::X);
            return (self.cubic.point(t) + perp(along) * self.offset, DVec2::ZERO);
        }
        let factor = 1.0 - self.offset * cross(first, second) / (speed * speed * speed);
        (self.cubic.point(t) + perp(first) * (self.offset / speed), first * factor)
    }

    /// The cubic with the exact ends and end derivatives of the offset.
    fn hermite(&self) -> Cubic {
        let width = self.to - self.from;
        let (start, at_start) = self.offset_frame(self.from);
        let (end, at_end) = self.offset_frame(self.to);
        Cubic::hermite(start, at_start * width, end, at_end * width)
    }

    /// Largest measured distance of `piece` from the offset [mm].
    fn error(&self, piece: &Cubic) -> f64 {
        SAMPLES.into_iter().map(|s| self.error_at(piece.point(s), s)).fold(0.0, f64::max)
    }

    /// Distance from the offset of `sample`, which stands at `s` of the piece.
    ///
    /// Never less than the true distance: either the sample stands at right angles over a point of
    /// the stretch, and then `C + δN` there is that far away, or the offset's point at the same
    /// parameter is taken.
    fn error_at(&self, sample: DVec2, s: f64) -> f64 {
        let mut t = self.from + (self.to - self.from) * s;
        let same = sample.distance(self.offset_frame(t).0);
        for _ in 0..2 {
            let (first, second) = (self.cubic.derivative(t), self.cubic.second_derivative(t));
            let away = sample - self.cubic.point(t);
            // Newton's method for (H − C) · C' = 0.
            let slope = away.dot(second) - first.length_squared();
            if slope >= 0.0 {
                return same;
            }
            t -= away.dot(first) / slope;
        }
        if t < self.from || t > self.to {
            return same;
        }
        let first = self.cubic.derivative(t);
        let speed = first.length();
        if speed == 0.0 {
            return same;
        }
        let away = sample - self.cubic.point(t);
        let (along, aside) = (away.dot(first) / speed, cross(first, away) / speed);
        // What Newton left along the tangent counts in full.
        ((aside - self.offset).abs() + along.abs()).min(same)
    }
}

/// Joins the offsets before and behind a cusp of the spline itself, where its tangent turns back:
/// half a circle about the cusp, on the outside, so that nothing is gouged.
fn join(from: DVec2, to: DVec2, cusp: DVec2, offset: f64, pieces: &mut Vec<MoveCurve>) {
    // Neighbouring spans differ by rounding only.
    if from.distance(to) > offset.abs() {
        let sweep = if offset > 0.0 { -PI } else { PI };
        if let Ok(arc) = Arc::from_center(from, to, cusp, sweep < 0.0, f64::INFINITY) {
            pieces.push(MoveCurve::Arc(arc));
        }
    }
}

/// Depth and place of the gouge of every stretch that bends tighter than the tool.
fn bends(spline: &Spline, offset: f64, tight: &[(usize, f64, f64)]) -> Vec<Bend> {
    let mut found = Vec::new();
    let mut i = 0;
    while i < tight.len() {
        // Stretches that continue over a type point are one bend.
        let mut last = i;
        while last + 1 < tight.len() && continues(tight[last], tight[last + 1]) {
            last += 1;
        }
        found.push(bend(spline, offset, &tight[i..=last]));
        i = last + 1;
    }
    found
}

fn continues(a: (usize, f64, f64), b: (usize, f64, f64)) -> bool {
    (a.0 == b.0 && a.2 == b.1) || (a.0 + 1 == b.0 && a.2 == 1.0 && b.1 == 0.0)
}

/// Places of the tool examined for the depth of one bend.
const DEPTH_SAMPLES: usize = 24;

/// Depth and place of the gouge of one bend.
///
/// The tool cuts on both sides of the stretch too, as far as the tails of the offset reach: the
/// spans beside it are examined with it, and searched for the nearest point.
fn bend(spline: &Spline, offset: f64, tight: &[(usize, f64, f64)]) -> Bend {
    let r = offset.abs();
    let (first, last) = (tight[0].0, tight[tight.len() - 1].0);
    let spans = first.saturating_sub(2)..(last + 3).min(spline.pieces().len());
    let near = &spline.pieces()[spans];
    let mut bend = Bend { at: spline.pieces()[first].point(tight[0].1), depth: 0.0, radius: r };
    for &(span, from, to) in tight {
        let cubic = &spline.pieces()[span];
        for k in 0..=DEPTH_SAMPLES {
            let t = from + (to - from) * k as f64 / DEPTH_SAMPLES as f64;
            let tangent = cubic.tangent(t);
            let center = cubic.point(t) + perp(tangent) * offset;
            let curvature = cubic.curvature(t).abs();
            if curvature > 0.0 {
                bend.radius = bend.radius.min(1.0 / curvature);
            }
            for piece in near {
                // Only what is nearer than the deepest so far can be cut deeper.
                if piece.hull_bounds().distance(center) < r - bend.depth {
                    let nearest = piece.nearest(center);
                    if r - nearest.distance > bend.depth {
                        bend.depth = r - nearest.distance;
                        bend.at = nearest.point;
                    }
                }
            }
        }
    }
    bend
}
