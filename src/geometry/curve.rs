//! A programmed curve of any kind, and what makes one impossible.

use std::fmt;

use glam::DVec2;

use super::{Arc, Bounds, Decimal, Involute, Line, Nearest, Spline, flatten_arc, flatten_cubic};

/// Largest coordinate that may be programmed [mm]: ten kilometres, a hundred times the largest
/// machine.
pub const MAX_COORDINATE: f64 = 1e7;

/// Largest coordinate a curve may have [mm]. A path runs beside its contour, and the centre of a
/// flat arc lies far beyond it; still every product of the solvers (at most degree 6 in
/// coordinates) stays far from overflow.
pub(super) const MAX_REACH: f64 = 1e9;

/// Shortest distance at which two points count as two [mm]: a picometre.
///
/// Coordinates of 1e6 mm are spaced by 1e-10 mm, so anything shorter has no direction left.
pub const MIN_LENGTH: f64 = 1e-9;

/// Why a curve cannot be made from the given numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveError {
    /// A coordinate is not finite, or too large for a curve or to be programmed.
    OutOfRange {
        /// The point as given.
        point: DVec2,
    },
    /// Start and end coincide.
    ZeroLength,
    /// An arc's end is not as far from its centre as its start.
    RadiiDisagree {
        /// Distance from the centre to the start [mm].
        start: f64,
        /// Distance from the centre to the end [mm].
        end: f64,
    },
    /// An arc given by its radius cannot span the distance of its ends.
    RadiusTooSmall {
        /// The radius as given [mm].
        radius: f64,
        /// Half the distance between the ends: the smallest radius possible [mm].
        least: f64,
    },
    /// A full circle cannot be given by its radius: its centre could be anywhere.
    FullCircleByRadius,
    /// A spline has too few type points for its end conditions, or Bézier curves a control point too
    /// few.
    TooFewPoints {
        /// How many there are.
        count: usize,
        /// How many there must be.
        least: usize,
    },
    /// Two successive type points of a spline coincide.
    CoincidentPoints {
        /// Index of the second of them, counting the start as 0.
        index: usize,
    },
    /// A periodic spline does not end where it starts.
    NotClosed,
    /// The circle of an involute has no radius, or one so small that an end is beyond 100 turns.
    NoBaseCircle {
        /// The radius as given [mm].
        radius: f64,
    },
    /// An involute starts or ends inside its base circle.
    InsideBaseCircle {
        /// Distance of that end from the centre [mm].
        distance: f64,
        /// Radius of the circle [mm].
        radius: f64,
    },
    /// An involute does not end on the one through its start.
    OffInvolute {
        /// How far off it ends [mm].
        off: f64,
    },
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { point } => write!(
                f,
                "the point ({}, {}) is not a finite number of at most 1e7 mm",
                Decimal::of(point.x),
                Decimal::of(point.y)
            ),
            Self::ZeroLength => write!(f, "start and end coincide"),
            Self::RadiiDisagree { start, end } => {
                let (start, end) = (Decimal::new(*start, 6), Decimal::new(*end, 6));
                write!(f, "the arc's start is {start} mm from its centre, its end {end} mm")
            }
            Self::RadiusTooSmall { radius, least } => {
                let (radius, least) = (Decimal::new(*radius, 6), Decimal::new(*least, 6));
                write!(
                    f,
                    "the arc's radius {radius} mm is less than half the distance of its ends, {least} mm"
                )
            }
            Self::FullCircleByRadius => {
                write!(f, "an arc given by its radius cannot end where it starts")
            }
            Self::TooFewPoints { count, least } => {
                write!(f, "the spline has {count} points and needs {least}")
            }
            Self::CoincidentPoints { index } => {
                write!(f, "type points {} and {index} of the spline coincide", index - 1)
            }
            Self::NotClosed => write!(f, "the periodic spline does not end where it starts"),
            Self::NoBaseCircle { radius } => {
                let radius = Decimal::of(*radius);
                write!(f, "a base circle of radius {radius} mm has no such involute")
            }
            Self::InsideBaseCircle { distance, radius } => {
                let (distance, radius) = (Decimal::new(*distance, 6), Decimal::of(*radius));
                write!(
                    f,
                    "an end of the involute is {distance} mm from the centre, inside the base circle of radius {radius} mm"
                )
            }
            Self::OffInvolute { off } => {
                let off = Decimal::new(*off, 6);
                write!(f, "the end is {off} mm off the involute through the start")
            }
        }
    }
}

impl std::error::Error for CurveError {}

/// Whether both coordinates of a point are finite and within [`MAX_COORDINATE`].
#[must_use]
pub fn in_range(point: DVec2) -> bool {
    // A NaN compares as false and so is refused too.
    point.x.abs() <= MAX_COORDINATE && point.y.abs() <= MAX_COORDINATE
}

/// Accepts a point whose coordinates are finite and within [`MAX_REACH`].
pub(super) fn checked_point(point: DVec2) -> Result<(), CurveError> {
    if point.x.abs() <= MAX_REACH && point.y.abs() <= MAX_REACH {
        Ok(())
    } else {
        Err(CurveError::OutOfRange { point })
    }
}

/// A programmed curve: what a segment of a contour is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// A straight line.
    Line(Line),
    /// A circular arc.
    Arc(Arc),
    /// A cubic spline.
    Spline(Spline),
    /// An involute of a circle.
    Involute(Involute),
}

impl Curve {
    /// Where the curve begins [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        match self {
            Self::Line(line) => line.start(),
            Self::Arc(arc) => arc.start(),
            Self::Spline(spline) => spline.start(),
            Self::Involute(involute) => involute.start(),
        }
    }

    /// Where the curve ends [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        match self {
            Self::Line(line) => line.end(),
            Self::Arc(arc) => arc.end(),
            Self::Spline(spline) => spline.end(),
            Self::Involute(involute) => involute.end(),
        }
    }

    /// The point at `t` in `[0, 1]` [mm].
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        match self {
            Self::Line(line) => line.point(t),
            Self::Arc(arc) => arc.point(t),
            Self::Spline(spline) => spline.point(t),
            Self::Involute(involute) => involute.point(t),
        }
    }

    /// Unit tangent at `t`.
    #[must_use]
    pub fn tangent(&self, t: f64) -> DVec2 {
        match self {
            Self::Line(line) => line.tangent(),
            Self::Arc(arc) => arc.tangent(t),
            Self::Spline(spline) => spline.tangent(t),
            Self::Involute(involute) => involute.tangent(t),
        }
    }

    /// Curvature at `t` [1/mm], positive to the left.
    #[must_use]
    pub fn curvature(&self, t: f64) -> f64 {
        match self {
            Self::Line(_) => 0.0,
            Self::Arc(arc) => arc.curvature(),
            Self::Spline(spline) => spline.curvature(t),
            Self::Involute(involute) => involute.curvature(t),
        }
    }

    /// Arc length [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Line(line) => line.length(),
            Self::Arc(arc) => arc.length(),
            Self::Spline(spline) => spline.length(),
            Self::Involute(involute) => involute.length(),
        }
    }

    /// The smallest box around the curve.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::Line(line) => line.bounds(),
            Self::Arc(arc) => arc.bounds(),
            Self::Spline(spline) => spline.bounds(),
            Self::Involute(involute) => involute.bounds(),
        }
    }

    /// The point of the curve nearest to `point`.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> Nearest {
        match self {
            Self::Line(line) => line.nearest(point),
            Self::Arc(arc) => arc.nearest(point),
            Self::Spline(spline) => spline.nearest(point),
            Self::Involute(involute) => involute.nearest(point),
        }
    }

    /// The same curve run the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Line(line) => Self::Line(line.reversed()),
            Self::Arc(arc) => Self::Arc(arc.reversed()),
            Self::Spline(spline) => Self::Spline(spline.reversed()),
            Self::Involute(involute) => Self::Involute(involute.reversed()),
        }
    }

    /// Calls `add` with points after its start, up to and with its end, whose chords are within
    /// `tolerance` [mm] of it.
    pub fn flatten(&self, tolerance: f64, add: &mut dyn FnMut(DVec2)) {
        match self {
            Self::Line(line) => add(line.end()),
            Self::Arc(arc) => flatten_arc(arc, tolerance, add),
            Self::Spline(spline) => {
                for piece in spline.pieces() {
                    flatten_cubic(piece, tolerance, add);
                }
            }
            Self::Involute(involute) => involute.flatten(tolerance, add),
        }
    }
}
