//! Axis-parallel boxes around points and curves.

use glam::DVec2;

/// An axis-parallel box; empty until a point is added.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Lower left corner [mm].
    pub min: DVec2,
    /// Upper right corner [mm].
    pub max: DVec2,
}

impl Bounds {
    /// The box that holds nothing.
    pub const EMPTY: Self = Self { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };

    /// The smallest box around `points`.
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Self {
        let mut bounds = Self::EMPTY;
        for point in points {
            bounds.add(point);
        }
        bounds
    }

    /// Grows the box until it holds `point`.
    pub fn add(&mut self, point: DVec2) {
        self.min = self.min.min(point);
        self.max = self.max.max(point);
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The box with `margin` [mm] added on every side.
    #[must_use]
    pub fn inflated(self, margin: f64) -> Self {
        Self { min: self.min - margin, max: self.max + margin }
    }

    /// Whether the boxes share a point; boxes that only touch do.
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Whether nothing was added yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x
    }

    /// Width and height [mm].
    #[must_use]
    pub fn size(&self) -> DVec2 {
        if self.is_empty() { DVec2::ZERO } else { self.max - self.min }
    }

    /// Distance from `point` to the box [mm]; zero inside.
    #[must_use]
    pub fn distance(&self, point: DVec2) -> f64 {
        (self.min - point).max(point - self.max).max(DVec2::ZERO).length()
    }
}
