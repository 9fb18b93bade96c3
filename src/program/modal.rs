//! What a control keeps from block to block.

use glam::{DVec2, DVec3};

use super::coordinates::Systems;
use super::corner_words::Wishes;
use super::cycles::CycleNumbers;
use super::drilling::Drill;
use super::feed::Feed;
use super::frame::Frame;
use super::g_words::Motion;
use crate::contour::Plane;

/// Millimetres in an inch.
pub(super) const INCH: f64 = 25.4;

/// Most tools that G10 can give a radius: as many as the largest tables of tools hold.
const MOST_RADII: usize = 1000;

/// The modes and numbers in effect.
#[derive(Debug, Clone)]
#[expect(clippy::struct_excessive_bools, reason = "each is a mode of its own")]
pub(super) struct Modal {
    /// How axis words move the tool, once a word said so.
    pub(super) motion: Option<Motion>,
    /// The plane of arcs, splines and compensation.
    pub(super) plane: Plane,
    /// What corners and leads are to be like.
    pub(super) wishes: Wishes,
    /// G20.
    pub(super) inches: bool,
    /// Whether a word said which unit.
    pub(super) says_unit: bool,
    /// Length of the unit that the F word of the block counts in [mm].
    pub(super) feed_unit: f64,
    /// G91.
    pub(super) relative: bool,
    /// G90.1.
    pub(super) absolute_center: bool,
    /// G07: X words are diameters.
    pub(super) diameter: bool,
    /// G99: cycles go back to the level R only.
    pub(super) retract_to_r: bool,
    /// Tool length compensation was ever switched on.
    pub(super) length: bool,
    pub(super) feed: Feed,
    /// How the spindle turns: the number of its M word.
    pub(super) spindle: Option<u32>,
    pub(super) cycle: CycleNumbers,
    /// The motion word before the cycle.
    pub(super) before_cycle: Option<Motion>,
    /// From programmed to program coordinates.
    pub(super) frame: Frame,
    pub(super) systems: Systems,
    /// The T word.
    selected: Option<u32>,
    /// The tool that the last M6 put into the spindle.
    loaded: Option<u32>,
    /// The D word, since the last tool change.
    pub(super) radius_number: Option<u32>,
    /// OFFN: what is left on the contour [mm].
    pub(super) allowance: f64,
    /// Radii that G10 gave tools [mm].
    pub(super) radii: ByTool,
    /// By how much G10 L13 has them worn: what is added to their radii [mm].
    pub(super) wears: ByTool,
    /// Which way it has the tips of lathe tools point, 0 to 9.
    pub(super) tips: ByTool,
    /// Where the program is, in program coordinates [mm]: not where the tool is, once compensation
    /// is on.
    pub(super) position: DVec3,
    /// Which coordinates of the position the program has stated; the others are assumed.
    pub(super) stated: [bool; 3],
    /// Of which coordinates it is not sure, since a tool change or a stop, that the machine is where
    /// the program is; the next block that states one is written, even if it moves nothing.
    pub(super) restate: [bool; 3],
    /// Where the other axes are, A B C [degrees] and U V W [mm], once the program has said so.
    pub(super) others: [Option<f64>; 6],
    /// The pole of AP and RP in programmed coordinates, and their last values.
    pub(super) polar: About,
    /// What MCALL drills after each block that moves in the plane.
    pub(super) drill: Option<Drill>,
    /// G12.1: X is not what it says until G13.1.
    pub(super) polar_interpolation: bool,
}

impl Modal {
    /// Those that a control begins with.
    pub(super) fn new(is_strict: bool) -> Self {
        Self {
            motion: None,
            plane: Plane::Xy,
            wishes: Wishes::default(),
            inches: false,
            says_unit: false,
            feed_unit: 1.0,
            relative: false,
            absolute_center: false,
            diameter: false,
            retract_to_r: is_strict,
            length: false,
            feed: Feed::new(),
            spindle: None,
            cycle: CycleNumbers::default(),
            before_cycle: None,
            frame: Frame::new(),
            systems: Systems::new(),
            selected: None,
            loaded: None,
            radius_number: None,
            allowance: 0.0,
            radii: ByTool::default(),
            wears: ByTool::default(),
            tips: ByTool::default(),
            position: DVec3::ZERO,
            stated: [false; 3],
            restate: [false; 3],
            others: [None; 6],
            polar: About::default(),
            drill: None,
            polar_interpolation: false,
        }
    }

    /// Length of the unit of coordinates [mm].
    pub(super) fn unit(&self) -> f64 {
        if self.inches { INCH } else { 1.0 }
    }

    /// G20 and G21. The F word of the block comes before it on a control that is strict, where it
    /// is known which unit it counts in by then.
    pub(super) fn set_inches(&mut self, inches: bool, is_strict: bool) {
        self.inches = inches;
        if !(is_strict && self.says_unit) {
            self.feed_unit = self.unit();
        }
        self.says_unit = true;
    }

    /// What the number of the word for axis `i` means [mm].
    pub(super) fn length_of(&self, i: usize, value: f64) -> f64 {
        let value = value * self.unit();
        if i == 0 && self.diameter { 0.5 * value } else { value }
    }

    pub(super) fn select_tool(&mut self, number: u32) {
        self.selected = Some(number);
    }

    /// M6: the selected tool goes into the spindle, and the D word of the old one is void.
    pub(super) fn change_tool(&mut self) {
        self.loaded = self.selected;
        self.radius_number = None;
        self.restate = [true; 3];
    }

    /// The tool that the last M6 put into the spindle, 0 for none.
    pub(super) fn loaded_tool(&self) -> u32 {
        self.loaded.unwrap_or(0)
    }

    /// The tool in the spindle. A program without M6 changes tools by T alone.
    pub(super) fn active_tool(&self) -> u32 {
        self.loaded.or(self.selected).unwrap_or(0)
    }
}

/// A point about a pole.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct About {
    /// [mm]
    pub(super) pole: DVec2,
    /// [mm]
    pub(super) radius: f64,
    /// [rad]
    pub(super) angle: f64,
}

/// A number that tools were given.
#[derive(Debug, Clone, Default)]
pub(super) struct ByTool(Vec<(u32, f64)>);

impl ByTool {
    pub(super) fn set(&mut self, tool: u32, value: f64) {
        let known = self.0.iter_mut().find(|(other, _)| *other == tool);
        if let Some((_, known)) = known {
            *known = value;
        } else if self.0.len() < MOST_RADII {
            self.0.push((tool, value));
        }
    }

    pub(super) fn of(&self, tool: u32) -> Option<f64> {
        self.0.iter().find(|(other, _)| *other == tool).map(|(_, value)| *value)
    }
}
