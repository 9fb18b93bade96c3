//! The tools that a program calls by number.

use crate::program::RadiusSource;

/// Radii of tools by their number.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tools {
    /// Number and radius [mm] of each tool; a negative radius swaps the side.
    pub radii: Vec<(u32, f64)>,
    /// Radius of every tool that is not listed [mm].
    pub default_radius: Option<f64>,
}

impl Tools {
    /// One radius for every tool [mm].
    #[must_use]
    pub fn all(radius: f64) -> Self {
        Self { radii: Vec::new(), default_radius: Some(radius) }
    }

    /// The radius that a contour asks for [mm], if it is known.
    #[must_use]
    pub fn radius_of(&self, source: RadiusSource) -> Option<f64> {
        match source {
            RadiusSource::Given(radius) => Some(radius),
            RadiusSource::Tool(number) => self.radius(number),
        }
    }

    /// Radius of a tool [mm], if it is known.
    #[must_use]
    pub fn radius(&self, number: u32) -> Option<f64> {
        let listed = self.radii.iter().find(|tool| tool.0 == number);
        listed.map(|tool| tool.1).or(self.default_radius)
    }
}
