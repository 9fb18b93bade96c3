//! The tools that a program calls by number.

use crate::program::{ProgrammedContour, RadiusSource};

/// Tools by their number.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tools {
    /// Each tool that is known by itself.
    pub listed: Vec<ListedTool>,
    /// Radius of every tool that is not listed [mm].
    pub default_radius: Option<f64>,
}

/// A tool and its number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ListedTool {
    /// The D word, or the T word where there is none.
    pub number: u32,
    /// How large it is; a negative size swaps the side.
    pub size: ToolSize,
    /// Which way the tip of a lathe tool points, 1 to 9 as `LinuxCNC` numbers them; 0 for a tool that
    /// turns.
    pub orientation: u8,
}

/// How large a tool is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ToolSize {
    /// Its radius [mm].
    Radius(f64),
    /// Its diameter as a table without units has it, such as that of `LinuxCNC`: it counts in the unit that
    /// is in effect where compensation is switched on [mm or inch].
    Diameter(f64),
}

impl Tools {
    /// One radius for every tool [mm].
    #[must_use]
    pub fn all(radius: f64) -> Self {
        Self { listed: Vec::new(), default_radius: Some(radius) }
    }

    /// The radius of the tool of a contour [mm], if it is known.
    #[must_use]
    pub fn radius_of(&self, programmed: &ProgrammedContour) -> Option<f64> {
        let number = match programmed.radius {
            RadiusSource::Given(radius) => return Some(radius),
            RadiusSource::Tool(number) => number,
        };
        match self.listed.iter().find(|tool| tool.number == number) {
            Some(ListedTool { size: ToolSize::Radius(radius), .. }) => Some(*radius),
            Some(ListedTool { size: ToolSize::Diameter(diameter), .. }) => {
                Some(0.5 * diameter * programmed.unit)
            }
            None => self.default_radius,
        }
    }
}
