//! Blends: curves that join two pieces without a step of direction, curvature or its derivative.
//!
//! A blend is the polynomial of degree 7 that matches both pieces, where it leaves the one and meets
//! the other, in point and three derivatives by arc length. Its parametric speed at the ends is
//! that of the corner curve of degree 13 with the same legs, to which it is so close that it may
//! stand for it: at a right angle between lines its curvature is 3 % less, for the same deviation.
//!
//! Where a line touches an arc no curve between them has a curvature that only grows: the circles
//! of curvature of such a curve lie in each other without touching (A. Kneser, 1912), as the arc's
//! and the line do not. This one swings by 6 % of the step on either side.

use glam::DVec3;

use super::{ByLength, CornerCurve, CornerShape, Frame, Piece};
use crate::geometry::nth_root;

/// A blend in its place.
#[derive(Debug, Clone)]
pub(super) struct Blend {
    pub(super) piece: Piece,
    /// What it takes of either piece [mm].
    pub(super) leg: f64,
}

/// A joint that a blend is wanted at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rough {
    pub(super) shape: CornerShape,
    /// The leg that the deviation allows, as far as the joint itself tells [mm].
    pub(super) leg: f64,
    /// The longest leg that is of use [mm].
    most: f64,
    /// Whether the turn, not the curvature, makes the deviation.
    by_turn: bool,
}

/// Cosine of half of 170°: beyond it a corner is so sharp that a stop is quicker.
pub(super) const SHARPEST: f64 = 0.087;

/// The deviation of a blend of length 1 at a step by 1 of curvature, and of its derivative: the
/// error of interpolation of degree 7 for `(t − ½)²/2` and `(t − ½)³/6` beyond ½.
const OF_CURVATURE: f64 = 0.001_887;
const OF_SHARPNESS: f64 = 0.000_651_1;

/// Most lengths of leg that are tried; each that is too long makes the next at least 2 % shorter, and
/// most joints take one or two.
const TRIALS: usize = 16;

/// Legs shorter than this are not worth a curve [mm].
const LEAST_LEG: f64 = 1e-6;

/// Places at which a blend is compared with what it replaces, in each half.
const PLACES: usize = 16;

/// Cosine of the turn from one place to the next, 25°, that is still slight: corners of 170° turn by
/// 10°, and an arc that a leg takes a radian of by 4°.
const SLIGHT: f64 = 0.9;

/// Cosine of about a radian: a leg that turns by more says little about the joint.
const RADIAN: f64 = 0.5;

impl Rough {
    /// The joint from the end of one piece to the start of another, with legs of at most `most` [mm];
    /// `None` where it all but goes back.
    pub(super) fn of(end: &Frame, start: &Frame, most: f64, deviation: f64) -> Option<Self> {
        let shape = CornerShape::between(CornerCurve::Ph13, end.tangent, start.tangent)?;
        if shape.half_cosine() < SHARPEST {
            return None;
        }
        // The deviation is a k + b k² + c k³ of the leg k, whose root Newton's method reaches from
        // above without passing it.
        let a = shape.deviation() / shape.leg();
        let b = 4.0 * OF_CURVATURE * (start.curvature - end.curvature).length();
        let c = 8.0 * OF_SHARPNESS * (start.sharpness - end.sharpness).length();
        let mut leg =
            (deviation / a).min((deviation / b).sqrt()).min(nth_root(deviation / c, 3)).min(1e6);
        for _ in 0..4 {
            let excess = leg * (a + leg * (b + leg * c)) - deviation;
            leg -= excess / (a + leg * (2.0 * b + leg * 3.0 * c)).max(f64::MIN_POSITIVE);
        }
        let by_turn = a * leg > 0.5 * deviation;
        Some(Self { shape, leg: leg.min(most), most, by_turn })
    }

    /// The longest blend whose legs are at most `most` [mm], and that stays within `deviation` [mm] of
    /// the two pieces, as the joint does of it.
    pub(super) fn blend(
        &self,
        incoming: &Piece,
        outgoing: &Piece,
        most: f64,
        deviation: f64,
    ) -> Option<Blend> {
        let most = most.min(self.most);
        let mut leg = self.leg.min(most);
        let mut best = None;
        for _ in 0..TRIALS {
            if leg < LEAST_LEG {
                break;
            }
            let speed = leg / self.shape.leg();
            let from = incoming.length() - leg;
            let coefficients = septic(&incoming.frame(from), &outgoing.frame(leg), speed);
            let found = strays(&coefficients, incoming, outgoing, leg, speed);
            let ratio = deviation / found;
            let ratio = if self.by_turn { ratio } else { ratio.sqrt() };
            if found <= deviation {
                let shrunk = best.is_none() && leg < self.leg.min(most);
                best = Some((coefficients, leg));
                // A curvature that changes fast makes the estimate far too small.
                if shrunk || leg >= most || found > 0.5 * deviation {
                    break;
                }
                leg = (leg * (0.95 * ratio).min(4.0)).min(most);
            } else if best.is_some() {
                break;
            } else {
                leg *= (0.98 * ratio).clamp(0.3, 0.98);
            }
        }
        best.map(|(coefficients, leg)| Blend {
            piece: Piece::Curve(Box::new(ByLength::of_polynomial(coefficients))),
            leg,
        })
    }
}

/// The polynomial of degree 7 that matches two frames with the parametric speed `speed` [mm] at both
/// ends: coefficients of the powers of `t` in `[0, 1]`.
///
/// The upper four follow from what the lower four leave of the conditions at the end (Hermite
/// interpolation on two points).
fn septic(start: &Frame, end: &Frame, speed: f64) -> Vec<DVec3> {
    let (square, cube) = (speed * speed, speed * speed * speed);
    let c1 = start.tangent * speed;
    let c2 = start.curvature * (0.5 * square);
    let c3 = start.sharpness * (cube / 6.0);
    // Seen from the start, so that far from the origin no digits are lost.
    let r0 = (end.point - start.point) - c1 - c2 - c3;
    let r1 = end.tangent * speed - c1 - c2 * 2.0 - c3 * 3.0;
    let r2 = end.curvature * square - c2 * 2.0 - c3 * 6.0;
    let r3 = end.sharpness * cube - c3 * 6.0;
    vec![
        start.point,
        c1,
        c2,
        c3,
        r0 * 35.0 - r1 * 15.0 + r2 * 2.5 - r3 / 6.0,
        r1 * 39.0 - r0 * 84.0 - r2 * 7.0 + r3 * 0.5,
        r0 * 70.0 - r1 * 34.0 + r2 * 6.5 - r3 * 0.5,
        r1 * 10.0 - r0 * 20.0 - r2 * 2.0 + r3 / 6.0,
    ]
}

/// How far a blend strays from the pieces that it replaces the ends of, and the joint from the blend
/// [mm]; infinite where it, or what it replaces, has a bend that the places are too few for.
///
/// Compared at places, and between them along the parabola through the offsets at three of them, with
/// a hundredth on top: the lobes of the difference are some ten places wide, where a parabola errs by
/// a five-hundredth.
fn strays(c: &[DVec3], incoming: &Piece, outgoing: &Piece, leg: f64, speed: f64) -> f64 {
    let joint = outgoing.frame(0.0).point;
    let end = incoming.length();
    let ends = [incoming.frame(end).tangent, outgoing.frame(0.0).tangent];
    let (mut most, mut nearest) = (0.0_f64, f64::INFINITY);
    let mut last = [DVec3::ZERO; 2];
    let (mut direction, mut heading) = (DVec3::ZERO, DVec3::ZERO);
    for i in 0..=2 * PLACES {
        let t = i as f64 / (2 * PLACES) as f64;
        let (mut point, mut derivative) = (DVec3::ZERO, DVec3::ZERO);
        for c in c.iter().rev() {
            derivative = derivative * t + point;
            point = point * t + *c;
        }
        // Between the ends it should go on as there: it stands where the tangents all but oppose
        // each other, and bulges where the curvature changes too much for its length.
        let size = derivative.length();
        if !(0.25 * speed..=2.0 * speed).contains(&size) {
            return f64::INFINITY;
        }
        // Each half strays from the piece on its side, which cannot be less than from both.
        let foot = if i <= PLACES {
            foot(incoming, point, [end - leg, end], end + leg * (2.0 * t - 1.0))
        } else {
            foot(outgoing, point, [0.0, leg], leg * (2.0 * t - 1.0))
        };
        let offset = point - foot.point;
        // The foot jumps from one piece to the other in the middle of a corner.
        let jumps = i == PLACES + 1;
        if i >= 1 {
            let turned = derivative.dot(direction) < SLIGHT * size * direction.length();
            let leads = foot.tangent.dot(ends[usize::from(i > PLACES)]) > RADIAN;
            if turned || !leads || !jumps && foot.tangent.dot(heading) < SLIGHT {
                return f64::INFINITY;
            }
        }
        if i >= 2 && !jumps && i != PLACES + 2 {
            let slope = (offset - last[1]) * 0.5;
            let bend = (offset - last[0] * 2.0 + last[1]) * 0.5;
            for x in [-0.5, -0.25, 0.25, 0.5] {
                most = most.max((last[0] + (slope + bend * x) * x).length());
            }
        }
        most = most.max(offset.length());
        (last, direction, heading) = ([offset, last[0]], derivative, foot.tangent);
        // The foot of the joint on the tangent here, where that is near enough to be one.
        let back = (joint - point).dot(derivative) / (size * size);
        let on = point + derivative * back.clamp(-0.02, 0.02);
        nearest = nearest.min(joint.distance(on));
    }
    1.01 * most.max(nearest)
}

/// The foot of a point [mm] on a piece, within a range of lengths and near a guess.
fn foot(piece: &Piece, point: DVec3, [from, to]: [f64; 2], guess: f64) -> Frame {
    let mut s = guess.clamp(from, to);
    for _ in 0..3 {
        let frame = piece.frame(s);
        let away = point - frame.point;
        // The derivative of (point − r)·T is −1 + (point − r)·T'.
        let slope = (1.0 - away.dot(frame.curvature)).max(0.1);
        let step = away.dot(frame.tangent) / slope;
        let next = (s + step).clamp(from, to);
        if (next - s).abs() < 1e-9 {
            return frame;
        }
        s = next;
    }
    piece.frame(s)
}
