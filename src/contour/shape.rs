//! Segments as they are described, before a contour is built of them.

use glam::DVec2;

use super::stated::{RADIUS_TOLERANCE, stated_arc};
use crate::geometry::{Arc, Curve, CurveError, Involute, Line, Parameter, RadiusForm, in_range};

/// How much an arc's two radii may differ [mm], unless it is by less than
/// [`RELATIVE_ARC_TOLERANCE`]: twice the diagonal of a square of 0.01 mm, as much as rounding a
/// centre and an end to two decimals makes of it, and what `LinuxCNC` lets pass.
pub const ARC_TOLERANCE: f64 = 0.028_284_271;

/// How much an arc's two radii may differ, as a part of them.
pub const RELATIVE_ARC_TOLERANCE: f64 = 1e-3;

/// A segment as described: all but its start, which is the end of the one before it.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A straight line.
    Line {
        /// Its end [mm].
        to: DVec2,
    },
    /// An arc about a centre; a full circle where its end is its start.
    Arc {
        /// Its end [mm].
        to: DVec2,
        /// Its centre [mm].
        center: DVec2,
        /// Whether it runs clockwise, as G2 does.
        clockwise: bool,
    },
    /// An arc of a radius.
    ArcByRadius {
        /// Its end [mm].
        to: DVec2,
        /// Its radius [mm].
        radius: f64,
        /// Which of the two arcs.
        form: RadiusForm,
        /// Whether it runs clockwise, as G2 does.
        clockwise: bool,
    },
    /// A spline through type points.
    Spline(SplineShape),
    /// Cubic Bézier curves, each from the end of the one before. Where they turn a corner they are
    /// segments of their own.
    Bezier {
        /// Of each curve both inner control points and its end [mm].
        controls: Vec<DVec2>,
    },
    /// An involute of a circle, outward where its end is farther from the centre than its start.
    Involute {
        /// Its end [mm].
        to: DVec2,
        /// Centre of the base circle [mm].
        center: DVec2,
        /// Radius of the base circle [mm].
        radius: f64,
        /// Whether it runs clockwise, as G02.2 does.
        clockwise: bool,
    },
}

/// A spline as described.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SplineShape {
    /// The type points after the start [mm].
    pub points: Vec<DVec2>,
    /// Tangent at the start, of any length.
    pub start_tangent: Option<DVec2>,
    /// Tangent at the end, of any length.
    pub end_tangent: Option<DVec2>,
    /// Whether ends without a tangent are tangent to a neighbouring line, arc or involute.
    pub smooth: bool,
    /// Whether its end is smoothly its start; by default so where it is all of a closed contour.
    pub periodic: Option<bool>,
    /// How its parameter is spaced.
    pub parameter: Parameter,
}

impl Shape {
    /// Where the segment ends [mm]; `None` for a spline without points.
    #[must_use]
    pub fn end(&self) -> Option<DVec2> {
        match self {
            Self::Line { to }
            | Self::Arc { to, .. }
            | Self::ArcByRadius { to, .. }
            | Self::Involute { to, .. } => Some(*to),
            Self::Spline(SplineShape { points, .. }) | Self::Bezier { controls: points } => {
                points.last().copied()
            }
        }
    }

    /// A line, arc or involute from its start, arcs as they are stated within a tolerance [mm], or else
    /// about a centre that is equally far from both ends; the line to its end instead of a spline.
    ///
    /// # Errors
    /// Why there is no such curve.
    pub(crate) fn curve(&self, from: DVec2, stated: Option<f64>) -> Result<Curve, CurveError> {
        let to = self.end().unwrap_or(from);
        if !in_range(to) {
            return Err(CurveError::OutOfRange { point: to });
        }
        match *self {
            Self::Arc { center, clockwise, .. } => {
                let arc = if let Some(tolerance) = stated {
                    stated_arc(from, to, center, clockwise, tolerance)
                } else {
                    let relative = RELATIVE_ARC_TOLERANCE * from.distance(center);
                    Arc::from_center(from, to, center, clockwise, ARC_TOLERANCE.max(relative))
                };
                arc.map(Curve::Arc)
            }
            Self::ArcByRadius { radius, form, clockwise, .. } => {
                let tolerance = stated.map_or(ARC_TOLERANCE, |_| RADIUS_TOLERANCE);
                Arc::from_radius(from, to, radius, form, clockwise, tolerance).map(Curve::Arc)
            }
            Self::Involute { center, radius, clockwise, .. } => {
                Involute::new(from, to, center, radius, clockwise, ARC_TOLERANCE)
                    .map(Curve::Involute)
            }
            _ => Line::new(from, to).map(Curve::Line),
        }
    }
}
