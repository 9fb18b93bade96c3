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

/// What is to be cut off a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CornerSize {
    /// A tangent arc of this radius [mm].
    Radius(f64),
    /// A straight chamfer between the points of both moves this far from the corner [mm].
    Legs(f64),
    /// A straight chamfer of this length [mm] with legs of one length.
    Length(f64),
}

impl CornerSize {
    /// The same, larger by a factor.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Radius(radius) => Self::Radius(radius * factor),
            Self::Legs(legs) => Self::Legs(legs * factor),
            Self::Length(length) => Self::Length(length * factor),
        }
    }

    /// The number that it is given by [mm].
    #[must_use]
    pub fn value(self) -> f64 {
        let (Self::Radius(value) | Self::Legs(value) | Self::Length(value)) = self;
        value
    }
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
    /// The point at `chord` from the corner, as seen from there; none on circles too small.
    fn at_chord(&self, chord: f64) -> Option<DVec2> {
        // Half the angle that the chord spans has this sine.
        let sine = 0.5 * self.curvature * chord;
        let square = 1.0 - sine * sine;
        (square >= 0.0).then(|| (self.out * square.sqrt() + self.normal * sine) * chord)
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
    let leg = |curve: &Curve, out: DVec2, tangent: DVec2| {
        let curvature = match curve {
            Curve::Arc(arc) => side * arc.curvature(),
            _ => 0.0,
        };
        Leg { out, normal: perp(tangent) * side, curvature, length: curve.length() }
    };
    let legs = [leg(first, -incoming, incoming), leg(second, outgoing, outgoing)];
    let made = match size {
        CornerSize::Radius(radius) => rounding(legs, radius),
        CornerSize::Legs(chord) => chamfer(legs, chord),
        CornerSize::Length(length) => chamfer_of(legs, length),
    };
    // In a reversal the legs of a chamfer coincide.
    let Some((ends, center)) = made.filter(|([a, b], _)| a.distance(*b) > ROUNDED) else {
        return CornerCut::Misfit;
    };
    let mut rest = [0.0; 2];
    for i in 0..2 {
        rest[i] = legs[i].length - legs[i].along(ends[i]);
        // A NaN does not fit either.
        let fits = rest[i] >= -ROUNDED && rest[i] < legs[i].length;
        if !fits {
            return CornerCut::Misfit;
        }
        if rest[i] <= ROUNDED {
            rest[i] = 0.0;
        }
    }
    let corner = first.end();
    CornerCut::Made {
        ends: ends.map(|end| corner + end),
        center: center.map(|center| corner + center),
        clockwise: side < 0.0,
        rest,
    }
}

type Element = ([DVec2; 2], Option<DVec2>);

/// The ends and the centre of a rounding, as seen from the corner.
fn rounding([first, second]: [Leg; 2], radius: f64) -> Option<Element> {
    let turned = cross(first.normal, second.normal);
    // The v whose products with both normals are these.
    let solve = |a: f64, b: f64| (perp(second.normal) * -a + perp(first.normal) * b) / turned;
    let [a, b] = [solve(radius, radius), solve(first.curvature, second.curvature)];
    let half = 1.0 - a.dot(b);
    let constant = a.length_squared() - radius * radius;
    let square = half * half - b.length_squared() * constant;
    // From the corner on, as the radius grows, the roots meet before they change sign.
    if half.is_nan() || half <= 0.0 || square < 0.0 {
        return None;
    }
    let center = a + b * (constant / (half + square.sqrt()));
    // Where the circles touch, or the circle and the line.
    let touch = |leg: Leg| (center - leg.normal * radius) / (1.0 - leg.curvature * radius);
    Some(([touch(first), touch(second)], Some(center)))
}

/// The ends of a chamfer, as seen from the corner.
fn chamfer([first, second]: [Leg; 2], chord: f64) -> Option<Element> {
    Some(([first.at_chord(chord)?, second.at_chord(chord)?], None))
}

/// Those of a chamfer that is this long: it grows with its legs.
fn chamfer_of(legs: [Leg; 2], length: f64) -> Option<Element> {
    let (mut low, mut high) = (0.0, legs[0].length.min(legs[1].length) + ROUNDED);
    let mut made = None;
    for _ in 0..HALVINGS {
        let chord = 0.5 * (low + high);
        let found = chamfer(legs, chord);
        match found {
            Some(([a, b], _)) if a.distance(b) < length => low = chord,
            _ => {
                high = chord;
                made = found;
            }
        }
    }
    made
}
