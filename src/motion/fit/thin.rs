//! Thinning: the fewer straight legs that pass all points of a polygon closely, in one pass.

use std::f64::consts::FRAC_1_SQRT_2;

use glam::DVec3;

/// Takes points one by one and tells where a leg must end.
///
/// Each point since the last corner kept (the anchor) allows a range of directions in which a leg
/// from there passes it closely; a leg may end in a point within the ranges of all before it.
/// Ranges are rectangles of slopes across the direction in which the points first left the anchor:
/// one step a point, in the plane as in space.
///
/// # Guarantees
/// Between a leg that is admitted and the points that it stands for the distance is at most the
/// tolerance, both ways: the points are within half a square's side of its line, run along it, and
/// lie beyond its ends by no more than that.
#[derive(Debug, Clone)]
pub(super) struct Sleeve {
    /// Half the side of the square [mm] whose corners are off by the tolerance.
    half: f64,
    anchor: DVec3,
    /// Ahead, and two directions across it, once a point has left the anchor.
    axes: Option<[DVec3; 3]>,
    /// How far ahead the points have come [mm].
    reach: f64,
    low: [f64; 2],
    high: [f64; 2],
}

impl Sleeve {
    /// A sleeve from the first point on; the tolerance is in mm.
    pub(super) fn new(anchor: DVec3, tolerance: f64) -> Self {
        let half = tolerance * FRAC_1_SQRT_2;
        Self { half, anchor, axes: None, reach: 0.0, low: [0.0; 2], high: [0.0; 2] }
    }

    /// Begins afresh at a point, which is kept.
    pub(super) fn restart(&mut self, anchor: DVec3) {
        *self = Self { anchor, axes: None, reach: 0.0, ..*self };
    }

    /// Whether all points are so near to the anchor that it stands for them.
    pub(super) fn is_empty(&self) -> bool {
        self.axes.is_none()
    }

    /// Takes the next point and tells how far ahead the points have come [mm]; `None` where no leg
    /// from the anchor can end there, so that one must end at the point before.
    pub(super) fn admit(&mut self, point: DVec3) -> Option<f64> {
        let away = point - self.anchor;
        let Some([ahead, left, up]) = self.axes else {
            let distance = away.length();
            if distance > self.half {
                let ahead = away / distance;
                let (left, up) = ahead.any_orthonormal_pair();
                self.axes = Some([ahead, left, up]);
                self.reach = distance;
                let slope = self.half / distance;
                (self.low, self.high) = ([-slope; 2], [slope; 2]);
            }
            return Some(self.reach);
        };
        let along = away.dot(ahead);
        if along < self.reach - self.half || along < self.half {
            return None;
        }
        let slopes = [away.dot(left) / along, away.dot(up) / along];
        let width = self.half / along;
        let (mut low, mut high) = (self.low, self.high);
        for (i, slope) in slopes.into_iter().enumerate() {
            if slope < low[i] || slope > high[i] {
                return None;
            }
            low[i] = low[i].max(slope - width);
            high[i] = high[i].min(slope + width);
        }
        (self.low, self.high) = (low, high);
        self.reach = self.reach.max(along);
        Some(self.reach)
    }
}
