//! The tools that a program calls by number.

use std::collections::BTreeMap;

/// Radii of tools by their number.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tools {
    /// Radius of each tool [mm]; a negative one swaps the side.
    pub radii: BTreeMap<u32, f64>,
    /// Radius of every tool that is not listed [mm].
    pub default_radius: Option<f64>,
}

impl Tools {
    /// One radius for every tool [mm].
    #[must_use]
    pub fn all(radius: f64) -> Self {
        Self { radii: BTreeMap::new(), default_radius: Some(radius) }
    }

    /// Radius of a tool [mm], if it is known.
    #[must_use]
    pub fn radius(&self, number: u32) -> Option<f64> {
        self.radii.get(&number).copied().or(self.default_radius)
    }
}
