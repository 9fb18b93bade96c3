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

// Neither may be a number where the other is not, so that comparing tells; the standard ones are
// calls of functions in WebAssembly.
fn lesser(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(if b.x < a.x { b.x } else { a.x }, if b.y < a.y { b.y } else { a.y })
}

fn greater(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(if b.x > a.x { b.x } else { a.x }, if b.y > a.y { b.y } else { a.y })
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
        self.min = lesser(self.min, point);
        self.max = greater(self.max, point);
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: lesser(self.min, other.min), max: greater(self.max, other.max) }
    }

    /// The box with `margin` [mm] added on every side.
    #[must_use]
    pub fn inflated(self, margin: f64) -> Self {
        Self { min: self.min - margin, max: self.max + margin }
    }

    /// Whether the boxes share a point; boxes that only touch do.
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        self.min.x <= other.max.x
            && other.min.x <= self.max.x
            && self.min.y <= other.max.y
            && other.min.y <= self.max.y
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
        self.gap_squared(&Self { min: point, max: point }).sqrt()
    }

    /// Square of the distance between two boxes [mm²]; zero where they meet, infinite from an empty
    /// one.
    #[must_use]
    pub fn gap_squared(&self, other: &Self) -> f64 {
        let gap = greater(self.min - other.max, other.min - self.max);
        greater(gap, DVec2::ZERO).length_squared()
    }

    /// Square of the longest distance between a point of one box and one of another [mm²].
    #[must_use]
    pub fn span_squared(&self, other: &Self) -> f64 {
        greater(self.max - other.min, other.max - self.min).length_squared()
    }
}
