//! A straight line between two points.

use glam::DVec2;

use super::{Bounds, CurveError, MIN_LENGTH, Nearest, curve::checked_point};

/// A straight line between two points.
///
/// # Guarantees
/// Both points are finite and at most 1e9 mm; they are at least
/// [`MIN_LENGTH`] apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    start: DVec2,
    end: DVec2,
}

impl Line {
    /// The line from `start` to `end` [mm].
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`] for a point that is not finite or too far out,
    /// [`CurveError::ZeroLength`] where the points coincide.
    pub fn new(start: DVec2, end: DVec2) -> Result<Self, CurveError> {
        checked_point(start)?;
        checked_point(end)?;
        if start.distance(end) < MIN_LENGTH {
            return Err(CurveError::ZeroLength);
        }
        Ok(Self { start, end })
    }

    /// Where the line begins [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.start
    }

    /// Where the line ends [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        self.end
    }

    /// The point at `t`; values outside `[0, 1]` lie on the line extended.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        // Exact at both ends, unlike start + t (end - start).
        self.start * (1.0 - t) + self.end * t
    }

    /// From the start to the end [mm]; not of unit length.
    #[must_use]
    pub fn vector(&self) -> DVec2 {
        self.end - self.start
    }

    /// Unit tangent.
    #[must_use]
    pub fn tangent(&self) -> DVec2 {
        self.vector().normalize()
    }

    /// Length [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.start.distance(self.end)
    }

    /// The smallest box around the line.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        Bounds::of([self.start, self.end])
    }

    /// The same line run the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { start: self.end, end: self.start }
    }

    /// Both halves of the line cut at `t`, strictly inside `(0, 1)`.
    ///
    /// # Errors
    /// [`CurveError::ZeroLength`] where a half would have no length.
    pub fn split(&self, t: f64) -> Result<(Self, Self), CurveError> {
        let middle = self.point(t);
        Ok((Self::new(self.start, middle)?, Self::new(middle, self.end)?))
    }

    /// The point of the line nearest to `point`.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> Nearest {
        let vector = self.vector();
        let t = ((point - self.start).dot(vector) / vector.length_squared()).clamp(0.0, 1.0);
        Nearest::new(t, self.point(t), point)
    }
}
