//! Intersections of two curves, one file for each pair.
//!
//! Every function takes finite curves and returns all crossings on both. A crossing that misses
//! an end by at most [`END_SLACK`] counts as on it, since ends meant to touch differ by rounding.

mod arc_arc;
mod arc_spline;
mod involute;
mod line_arc;
mod line_line;
mod line_spline;
mod spline_spline;

use glam::DVec2;

use super::sort_short;

pub use arc_arc::{arc_arc, circles};
pub use arc_spline::arc_cubic;
pub use involute::involute_with;
pub use line_arc::{line_arc, line_circle};
pub use line_line::{line_line, lines_extended};
pub use line_spline::line_cubic;
pub use spline_spline::cubic_cubic;

/// How far a crossing may miss the end of a curve and still count [mm].
pub const END_SLACK: f64 = 1e-9;

/// A point that two curves share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The point [mm].
    pub point: DVec2,
    /// Its parameter on the first curve, in `[0, 1]`.
    pub t: f64,
    /// Its parameter on the second curve, in `[0, 1]`.
    pub u: f64,
}

/// How two curves meet.
#[derive(Debug, Clone, PartialEq)]
pub enum Intersections {
    /// In these points, in order along the first curve; none is a valid answer.
    Points(Vec<Crossing>),
    /// They share a stretch, so there is no single point to name.
    Coincident,
}

impl Intersections {
    /// The points; none where the curves coincide.
    #[must_use]
    pub fn points(self) -> Vec<Crossing> {
        match self {
            Self::Points(points) => points,
            Self::Coincident => Vec::new(),
        }
    }

    /// The same meeting with first and second curve exchanged.
    #[must_use]
    pub fn exchanged(self) -> Self {
        match self {
            Self::Points(mut points) => {
                for crossing in &mut points {
                    std::mem::swap(&mut crossing.t, &mut crossing.u);
                }
                Self::sorted(points)
            }
            Self::Coincident => Self::Coincident,
        }
    }

    fn sorted(mut points: Vec<Crossing>) -> Self {
        sort_short(&mut points, |crossing| crossing.t);
        Self::Points(points)
    }
}

/// `t` clamped to `[0, 1]` where it is off by at most [`END_SLACK`] on a curve of the given
/// length [mm]; `None` where it is farther off.
fn within(t: f64, length: f64) -> Option<f64> {
    let slack = END_SLACK / length;
    (t >= -slack && t <= 1.0 + slack).then(|| t.clamp(0.0, 1.0))
}

/// `roots` with 0 and 1 added where the curve's end is on the other curve: rounding may put that
/// root just outside the interval.
fn with_ends(mut roots: Vec<f64>, at_ends: [bool; 2]) -> Vec<f64> {
    if at_ends[0] && roots.first().is_none_or(|&t| t > 1e-6) {
        roots.insert(0, 0.0);
    }
    if at_ends[1] && roots.last().is_none_or(|&t| t < 1.0 - 1e-6) {
        roots.push(1.0);
    }
    roots
}

/// `roots` of a distance with those places of `stationary` added where it is not zero but within
/// [`END_SLACK`]: the curves touch there up to rounding.
fn with_touches(
    mut roots: Vec<f64>,
    stationary: impl IntoIterator<Item = f64>,
    distance: impl Fn(f64) -> f64,
) -> Vec<f64> {
    for t in stationary {
        let within = |t: f64| distance(t).abs() <= END_SLACK;
        // Between the two roots of a slight overlap the distance stays within the slack too.
        if within(t) && !roots.iter().any(|r| within(0.5 * (r + t))) {
            roots.push(t);
        }
    }
    roots
}
