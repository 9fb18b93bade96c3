//! The tools that a program calls by number.

use glam::DVec2;

use crate::program::{OrientationSource, ProgrammedContour, RadiusSource};

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

    /// Which way the tip of the tool of a contour points, 0 where that is not known.
    #[must_use]
    pub fn orientation_of(&self, programmed: &ProgrammedContour) -> u8 {
        match programmed.orientation {
            OrientationSource::Given(orientation) => orientation,
            OrientationSource::Tool(number) => self.find(number).map_or(0, |tool| tool.orientation),
        }
    }

    fn find(&self, number: u32) -> Option<&ListedTool> {
        self.listed.iter().find(|tool| tool.number == number)
    }

    /// The radius of the tool of a contour [mm], if it is known.
    #[must_use]
    pub fn radius_of(&self, programmed: &ProgrammedContour) -> Option<f64> {
        let number = match programmed.radius {
            RadiusSource::Given(radius) => return Some(radius + programmed.allowance),
            RadiusSource::Tool(number) => number,
        };
        let radius = match self.find(number) {
            Some(ListedTool { size: ToolSize::Radius(radius), .. }) => Some(*radius),
            Some(ListedTool { size: ToolSize::Diameter(diameter), .. }) => {
                Some(0.5 * diameter * programmed.unit)
            }
            None => self.default_radius,
        };
        radius.map(|radius| radius + programmed.allowance)
    }
}

/// From the centre of the tip of a lathe tool to the point that is programmed, in z and x [mm]: the
/// corner of the square about the tip, or the middle of its side, that the tool points to.
/// Orientations count from the corner of greater z and smaller x, as `LinuxCNC` numbers them.
pub(super) fn tip(orientation: u8, radius: f64) -> DVec2 {
    let direction = match orientation {
        1 => (1.0, -1.0),
        2 => (-1.0, -1.0),
        3 => (-1.0, 1.0),
        4 => (1.0, 1.0),
        5 => (1.0, 0.0),
        6 => (0.0, -1.0),
        7 => (-1.0, 0.0),
        8 => (0.0, 1.0),
        _ => (0.0, 0.0),
    };
    DVec2::from(direction) * radius
}
