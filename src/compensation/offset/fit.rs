//! Cubics that follow the offset of a cubic.
//!
//! Both share end points and end tangents with the offset. The plain one has its end derivatives
//! too, `O' = C' (1 − δκ)`: its error falls with the fourth power of its length. The collocated one
//! gives those lengths up to be at distance δ at two inner points, and its error falls with the
//! sixth power.

use glam::DVec2;

use crate::geometry::{Cubic, cross, perp};

/// Inner points at which the collocated cubic is at distance δ: near the roots of the error's
/// leading term, by trial on waves and spirals.
const COLLOCATED: [f64; 2] = [0.3, 0.7];

/// Largest relative change of a handle in one step; a larger one means that the step is lost, as at
/// inflections, where the handles hardly move the curve sideways.
const LARGEST_STEP: f64 = 0.25;

/// A cubic to be offset, whole.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source {
    pub(super) cubic: Cubic,
    /// δ [mm], positive to the left.
    pub(super) offset: f64,
}

/// Point and derivative of the offset at an end.
#[derive(Debug, Clone, Copy)]
struct End {
    point: DVec2,
    derivative: DVec2,
}

impl Source {
    /// Point and derivative of the offset at 0 or 1.
    fn end(&self, t: f64) -> End {
        let first = self.cubic.derivative(t);
        let speed = first.length();
        // Where the curve stands still its tangent is that of the way on; the offset stands too.
        if speed <= 1e-7 * self.cubic.hull_length() {
            let inside = if t == 0.0 { 1e-6 } else { 1.0 - 1e-6 };
            let along = self.cubic.derivative(inside).normalize_or(DVec2::X);
            let point = self.cubic.point(t) + perp(along) * self.offset;
            return End { point, derivative: DVec2::ZERO };
        }
        let bend = cross(first, self.cubic.second_derivative(t)) / (speed * speed * speed);
        End {
            point: self.cubic.point(t) + perp(first) * (self.offset / speed),
            derivative: first * (1.0 - self.offset * bend),
        }
    }

    /// The cubic with the exact ends and end derivatives of the offset.
    pub(super) fn hermite(&self) -> Cubic {
        let (start, end) = (self.end(0.0), self.end(1.0));
        Cubic::hermite(start.point, start.derivative, end.point, end.derivative)
    }

    /// The cubic with the ends and end tangents of `hermite` that is at distance δ at the
    /// collocated points; `None` where there is none near it.
    pub(super) fn collocated(&self, hermite: &Cubic) -> Option<Cubic> {
        let [p0, p1, p2, p3] = hermite.points;
        let (mut a, mut b) = (p1 - p0, p3 - p2);
        let cubic = |a: DVec2, b: DVec2| Cubic::new(p0, p0 + a, p3 - b, p3);
        // First both handles together, for the error in the middle; it starts the other within
        // reach.
        let (error, normal) = self.excess(&cubic(a, b), 0.5)?;
        let change = -error / ((a - b) * 0.375).dot(normal);
        if change.is_nan() || change.abs() > LARGEST_STEP {
            return None;
        }
        a *= 1.0 + change;
        b *= 1.0 + change;
        // Then each by itself, for both points: Newton's method in the factors of both handles.
        for _ in 0..2 {
            let [s, t] = COLLOCATED;
            let (error_s, normal_s) = self.excess(&cubic(a, b), s)?;
            let (error_t, normal_t) = self.excess(&cubic(a, b), t)?;
            let weights = |t: f64| (3.0 * t * (1.0 - t) * (1.0 - t), -3.0 * t * t * (1.0 - t));
            let ((as_, bs), (at, bt)) = (weights(s), weights(t));
            let (m00, m01) = (as_ * a.dot(normal_s), bs * b.dot(normal_s));
            let (m10, m11) = (at * a.dot(normal_t), bt * b.dot(normal_t));
            let determinant = m00 * m11 - m01 * m10;
            let change_a = (error_t * m01 - error_s * m11) / determinant;
            let change_b = (error_s * m10 - error_t * m00) / determinant;
            let step = change_a.abs().max(change_b.abs());
            if step.is_nan() || step > LARGEST_STEP {
                return None;
            }
            a *= 1.0 + change_a;
            b *= 1.0 + change_b;
        }
        Some(cubic(a, b))
    }

    /// How much farther than δ the piece at `t` is from the curve, signed to the left, and the
    /// normal there; `None` where no foot is found near the same parameter.
    pub(super) fn excess(&self, piece: &Cubic, t: f64) -> Option<(f64, DVec2)> {
        let sample = piece.point(t);
        let mut foot = t;
        for _ in 0..2 {
            let first = self.cubic.derivative(foot);
            let away = sample - self.cubic.point(foot);
            // Newton's method for (H − C) · C' = 0.
            let slope = away.dot(self.cubic.second_derivative(foot)) - first.length_squared();
            if slope >= 0.0 {
                return None;
            }
            foot -= away.dot(first) / slope;
        }
        if !(0.0..=1.0).contains(&foot) {
            return None;
        }
        let normal = perp(self.cubic.derivative(foot)).try_normalize()?;
        Some(((sample - self.cubic.point(foot)).dot(normal) - self.offset, normal))
    }

    /// Distance from the offset of the piece at `t`, never less than it is: either the piece
    /// stands at right angles over a point of the curve, and the offset there is its excess away,
    /// or the offset's point at the same parameter is taken.
    pub(super) fn distance(&self, piece: &Cubic, t: f64) -> f64 {
        let first = self.cubic.derivative(t);
        let same = self.cubic.point(t) + perp(first.normalize_or_zero()) * self.offset;
        let distance = piece.point(t).distance(same);
        self.excess(piece, t).map_or(distance, |(excess, _)| excess.abs().min(distance))
    }
}
