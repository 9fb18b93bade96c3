//! Pieces of a track: curves in space that are traversed by their arc length.

use glam::DVec3;

use super::{ByLength, Corner, Eased, Helix, Quintic, Straight, Unwound};

/// Where a curve is at an arc length, and its derivatives by arc length there.
///
/// With the speed `v`, the tangential acceleration `a` and its rate `j` the machine's velocity is
/// `v T`, its acceleration `a T + v² T'` and its jerk `j T + 3 v a T' + v³ T''` (the chain rule,
/// thrice), with `T'` the [`curvature`](Self::curvature) and `T''` the
/// [`sharpness`](Self::sharpness).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// The point [mm].
    pub point: DVec3,
    /// Unit tangent `T`, in the direction of motion.
    pub tangent: DVec3,
    /// `dT/ds = κ N` [1/mm], perpendicular to the tangent.
    pub curvature: DVec3,
    /// `d²T/ds²` [1/mm²]: `κ' N − κ² T` on a plane curve.
    pub sharpness: DVec3,
}

impl Frame {
    /// The frame of a curve with the derivatives `[r', r'', r''']` by any parameter that moves it on
    /// at `point`; with `r' = 0` nothing here is finite.
    ///
    /// With `σ = |r'|` and `T` the tangent (differentiate `T = r'/σ` by `ds = σ dt` twice):
    /// `T' = (r'' − (r''·T) T)/σ²`, and across the tangent
    /// `T'' = (r''' − 3 σ (r''·T) T')/σ³`, to which `−|T'|² T` comes along it.
    #[must_use]
    pub fn of_derivatives(point: DVec3, [first, second, third]: [DVec3; 3]) -> Self {
        // Divisions take long: one for all.
        let inverse = first.length_recip();
        let square = inverse * inverse;
        let tangent = first * inverse;
        let along = second.dot(tangent);
        let curvature = (second - tangent * along) * square;
        let turned = (third * inverse - curvature * (3.0 * along)) * square;
        let across = turned - tangent * turned.dot(tangent);
        let sharpness = across - tangent * curvature.length_squared();
        Self { point, tangent, curvature, sharpness }
    }
}

/// One curve of a track.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// A straight line.
    Straight(Straight),
    /// A circular arc, or a helix.
    Helix(Helix),
    /// An involute.
    Unwound(Unwound),
    /// A rounded corner between lines.
    Corner(Corner),
    /// A curve whose arc length is measured.
    Curve(Box<ByLength>),
    /// A polynomial of degree five, as fitted to dense blocks.
    Quintic(Box<Quintic>),
    /// A rounded corner between lines, by its pace in the place of its arc length.
    Eased(Eased),
}

impl Piece {
    /// Arc length [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Straight(straight) => straight.length,
            Self::Helix(helix) => helix.length,
            Self::Unwound(unwound) => unwound.length,
            Self::Corner(corner) => corner.length,
            Self::Curve(curve) => curve.length,
            Self::Quintic(quintic) => quintic.length,
            Self::Eased(eased) => eased.length(),
        }
    }

    /// Point and derivatives at the arc length `s` [mm] from its start; a little beyond either end
    /// the curve runs on.
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        match self {
            Self::Straight(straight) => straight.frame(s),
            Self::Helix(helix) => helix.frame(s),
            Self::Unwound(unwound) => unwound.frame(s),
            Self::Corner(corner) => corner.frame(s),
            Self::Curve(curve) => curve.frame(s),
            Self::Quintic(quintic) => quintic.frame(s),
            Self::Eased(eased) => eased.frame(s),
        }
    }

    /// The part from one arc length to another [mm]; of a piece that is a part itself, also from
    /// before its start or to beyond its end.
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        match self {
            Self::Straight(straight) => Self::Straight(straight.part(from, to)),
            Self::Helix(helix) => Self::Helix(helix.part(from, to)),
            Self::Unwound(unwound) => Self::Unwound(unwound.part(from, to)),
            Self::Corner(corner) => Self::Corner(corner.part(from, to)),
            Self::Curve(curve) => Self::Curve(Box::new(curve.part(from, to))),
            Self::Quintic(quintic) => Self::Quintic(Box::new(quintic.part(from, to))),
            Self::Eased(eased) => Self::Eased(eased.part(from, to)),
        }
    }
}
