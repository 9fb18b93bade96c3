//! A straight line by arc length.

use glam::DVec3;

use super::Frame;

/// A straight line from a point along a unit vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Straight {
    /// Where it begins [mm].
    pub start: DVec3,
    /// Unit tangent.
    pub tangent: DVec3,
    /// Length [mm].
    pub length: f64,
}

impl Straight {
    /// The line between two points [mm]; `None` where they are too close to have a direction.
    #[must_use]
    pub fn between(start: DVec3, end: DVec3) -> Option<Self> {
        let tangent = (end - start).try_normalize()?;
        Some(Self { start, tangent, length: start.distance(end) })
    }

    /// Point and derivatives at the arc length `s` [mm]; the error is that of rounding.
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        Frame {
            point: self.start + self.tangent * s,
            tangent: self.tangent,
            curvature: DVec3::ZERO,
            sharpness: DVec3::ZERO,
        }
    }

    /// The part from one arc length to another [mm].
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        Self { start: self.start + self.tangent * from, length: to - from, ..*self }
    }
}
