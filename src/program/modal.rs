//! What a control keeps from block to block.

use glam::DVec3;

use super::g_words::Motion;

/// Millimetres in an inch.
const INCH: f64 = 25.4;

/// The modes and numbers in effect.
#[derive(Debug, Clone)]
#[expect(clippy::struct_excessive_bools, reason = "each is a mode of its own")]
pub(super) struct Modal {
    /// How axis words move the tool, once a word said so.
    pub(super) motion: Option<Motion>,
    /// G20.
    pub(super) inches: bool,
    /// G91.
    pub(super) relative: bool,
    /// G90.1.
    pub(super) absolute_center: bool,
    /// A plane other than XY by its word.
    pub(super) other_plane: Option<&'static str>,
    /// Whether F means mm/min or inch/min.
    pub(super) feed_per_minute: bool,
    /// Feed [mm/s].
    pub(super) feed: Option<f64>,
    /// The T word.
    selected: Option<u32>,
    /// The tool that the last M6 put into the spindle.
    loaded: Option<u32>,
    /// The D word, since the last tool change.
    pub(super) radius_number: Option<u32>,
    /// Where the program is [mm]: not where the tool is, once compensation is on.
    pub(super) position: DVec3,
    /// Which coordinates of the position the program has stated; the others are assumed zero.
    pub(super) stated: [bool; 3],
}

impl Modal {
    pub(super) fn new() -> Self {
        Self {
            motion: None,
            inches: false,
            relative: false,
            absolute_center: false,
            other_plane: None,
            feed_per_minute: true,
            feed: None,
            selected: None,
            loaded: None,
            radius_number: None,
            position: DVec3::ZERO,
            stated: [false; 3],
        }
    }

    /// Length of the unit of coordinates [mm].
    pub(super) fn unit(&self) -> f64 {
        if self.inches { INCH } else { 1.0 }
    }

    /// The coordinate that an axis word asks for [mm].
    pub(super) fn coordinate(&self, value: f64, current: f64) -> f64 {
        let value = value * self.unit();
        if self.relative { current + value } else { value }
    }

    pub(super) fn select_tool(&mut self, number: u32) {
        self.selected = Some(number);
    }

    /// M6: the selected tool goes into the spindle, and the D word of the old one is void.
    pub(super) fn change_tool(&mut self) {
        self.loaded = self.selected;
        self.radius_number = None;
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
