//! Roundings and chamfers: what is put in the place of the corner between two lines or arcs.
//!
//! Both are seen from the corner P outward, the first one backwards. Each has there a unit tangent
//! `o`, the unit normal `n` on the side of the rounding, and a curvature `k` towards that side.

use glam::DVec2;

use super::{Curve, cross, perp, turn};

/// Turns up to this one are none [rad]: FANUC's manuals give 1° for two lines, for a line and the
/// tangent of an arc, and for two arcs. Rounded centres make tangents differ by tenths of it.
const TANGENT: f64 = std::f64::consts::PI / 180.0;

/// How much longer than its moves an element may come to be by rounded numbers [mm].
const ROUNDED: f64 = 1e-6;

/// Steps that halve the length of the legs of a chamfer: as many as a double has digits.
const HALVINGS: u32 = 60;

/// How the size of what is cut off a corner is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CornerMeasure {
    /// A tangent arc, by its radius.
    Radius,
    /// A straight chamfer, by how far both its ends are from the corner.
    Legs,
    /// A straight chamfer with legs of one length, by its own.
    Length,
}

/// What is to be cut off a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerSize {
    /// How it is measured.
    pub measure: CornerMeasure,
    /// Its size [mm], positive.
    pub value: f64,
}

/// What comes of a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CornerCut {
    /// An element in its place.
    Made {
        /// Where it begins, on the first move, and where it ends, on the second [mm].
        ends: [DVec2; 2],
        /// Centre of the arc [mm]; none for a chamfer.
        center: Option<DVec2>,
        /// Whether the arc runs clockwise.
        clockwise: bool,
        /// What is left of both moves [mm]; 0 where nothing is.
        rest: [f64; 2],
    },
    /// The moves are tangent: there is no corner.
    Tangent,
    /// It does not fit between the far ends of the moves, or no such arc touches both.
    Misfit,
}

/// One of the two moves, seen from the corner.
#[derive(Clone, Copy)]
struct Leg {
    out: DVec2,
    normal: DVec2,
    curvature: f64,
    length: f64,
}

impl Leg {
    fn new(curve: &Curve, out: DVec2, normal: DVec2, side: f64) -> Self {
        let curvature = match curve {
            Curve::Arc(arc) => side * arc.curvature(),
            _ => 0.0,
        };
        Self { out, normal, curvature, length: curve.length() }
    }

    /// The point at `chord` from the corner, as seen from there; not a number on circles too small.
    fn at_chord(&self, chord: f64) -> DVec2 {
        // Half the angle that the chord spans has this sine.
        let sine = 0.5 * self.curvature * chord;
        (self.out * (1.0 - sine * sine).sqrt() + self.normal * sine) * chord
    }

    /// How far along the move a point of it is [mm].
    fn along(&self, point: DVec2) -> f64 {
        if self.curvature == 0.0 {
            return point.dot(self.out);
        }
        // The angle between chord and tangent is half that of the arc.
        let angle = turn(self.out, point) * cross(self.out, self.normal);
        2.0 * angle / self.curvature
    }
}

/// Cuts the corner where `first` ends and `second` starts; both are lines or arcs.
///
/// The centre C of a rounding, `v = C − P`, lies R beside each move, whether line or arc:
/// `k (v² − R²) / 2 = v·n − R`. With `w = (v² − R²) / 2` both conditions are linear in v, so that
/// `v = A + B w`, and what is left is a quadratic in w; of its roots that one is taken which comes
/// into the corner as R goes to zero. Between lines B is zero.
#[must_use]
pub fn cut_corner(first: &Curve, second: &Curve, size: CornerSize) -> CornerCut {
    let (incoming, outgoing) = (first.tangent(1.0), second.tangent(0.0));
    let angle = turn(incoming, outgoing);
    if angle.abs() <= TANGENT {
        return CornerCut::Tangent;
    }
    let side = angle.signum();
    let legs = [
        Leg::new(first, -incoming, perp(incoming) * side, side),
        Leg::new(second, outgoing, perp(outgoing) * side, side),
    ];
    let mut center = DVec2::NAN;
    let mut ends = match size.measure {
        CornerMeasure::Radius => rounding(legs, size.value, &mut center),
        CornerMeasure::Legs => chamfer(legs, size.value),
        CornerMeasure::Length => chamfer_of(legs, size.value),
    };
    // In a reversal the legs of a chamfer coincide.
    let mut fits = ends[0].distance(ends[1]) > ROUNDED;
    let corner = first.end();
    let mut rest = [0.0; 2];
    for i in 0..2 {
        let left = legs[i].length - legs[i].along(ends[i]);
        // What is not a number does not fit.
        fits &= left >= -ROUNDED && left < legs[i].length;
        if left > ROUNDED {
            rest[i] = left;
        }
        ends[i] += corner;
    }
    if !fits {
        return CornerCut::Misfit;
    }
    let center = (size.measure == CornerMeasure::Radius).then(|| corner + center);
    CornerCut::Made { ends, center, clockwise: side < 0.0, rest }
}

/// The ends and the centre of a rounding, as seen from the corner; no numbers where there is none.
fn rounding([first, second]: [Leg; 2], radius: f64, center: &mut DVec2) -> [DVec2; 2] {
    // The v whose products with both normals are p and q is (q n1⊥ − p n2⊥) / (n1 × n2).
    let turned = cross(first.normal, second.normal);
    let (one, two) = (perp(first.normal), perp(second.normal));
    let a = (one - two) * (radius / turned);
    let b = (one * second.curvature - two * first.curvature) / turned;
    let half = 1.0 - a.dot(b);
    let constant = a.length_squared() - radius * radius;
    let root = (half * half - b.length_squared() * constant).sqrt();
    // From the corner on, as the radius grows, the roots meet before they change sign.
    let w = if half > 0.0 { constant / (half + root) } else { f64::NAN };
    *center = a + b * w;
    // Where the circles touch, or the circle and the line.
    let touch = |leg: Leg| (*center - leg.normal * radius) / (1.0 - leg.curvature * radius);
    [touch(first), touch(second)]
}

/// The ends of a chamfer with such legs, as seen from the corner.
fn chamfer(legs: [Leg; 2], chord: f64) -> [DVec2; 2] {
    [legs[0].at_chord(chord), legs[1].at_chord(chord)]
}

/// Those of a chamfer that is this long: it grows with its legs.
fn chamfer_of(legs: [Leg; 2], length: f64) -> [DVec2; 2] {
    let is_short = |[a, b]: [DVec2; 2]| a.distance(b) < length;
    let (mut low, mut high) = (0.0, legs[0].length.min(legs[1].length) + ROUNDED);
    // One that is still too short does not fit.
    let mut ends = [DVec2::NAN; 2];
    for _ in 0..HALVINGS {
        let chord = 0.5 * (low + high);
        let found = chamfer(legs, chord);
        if is_short(found) {
            low = chord;
        } else {
            (high, ends) = (chord, found);
        }
    }
    ends
}
