//! The answer to "which point of this curve is nearest?".

use glam::DVec2;

/// The point of a curve that is nearest to a given one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Parameter of the point on its curve, in `[0, 1]`.
    pub t: f64,
    /// The point itself [mm].
    pub point: DVec2,
    /// Its distance from the given point [mm].
    pub distance: f64,
}

impl Nearest {
    /// `point` at `t` of a curve, as seen from `from`.
    #[must_use]
    pub fn new(t: f64, point: DVec2, from: DVec2) -> Self {
        Self { t, point, distance: point.distance(from) }
    }

    /// The nearer of two; the first where they are equally near.
    #[must_use]
    pub fn or_nearer(self, other: Self) -> Self {
        if other.distance < self.distance { other } else { self }
    }
}
