//! How a control reads the words that concern compensation, and splines.

use super::dialect::Dialect;
use crate::geometry::Parameter;

/// How near curves that are no cubics are read as such by default [mm].
const CURVE_TOLERANCE: f64 = 1e-4;

/// Controls that have words of their own for corners and leads.
///
/// With any of them but the first a new radius (D) takes effect over the next straight block: its
/// path starts beside its start with the old radius, and ends with the new one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ControlWords {
    /// G39 alone; radius and side may change, with a warning.
    #[default]
    Common,
    /// FANUC: G39. Where the side changes the tool goes to where both paths cross.
    Fanuc,
    /// ISG and Beckhoff: G25, G26, G138, G139.
    Isg,
    /// SINUMERIK: G450, G451, DISC, NORM, KONT.
    Sinumerik,
}

/// What differs from control to control. By default everything that has a meaning is read, as the
/// textbook's machine does.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a rule of its own")]
pub struct Rules {
    /// Any move leads in, an arc too, and any straight one leads out, along the normal of the plane
    /// or of no length too; arcs are taken as they are stated.
    pub any_lead: bool,
    /// What may not change while compensation is on ends the program where it is asked for.
    pub is_strict: bool,
    /// Without a D word, and with D0, the tool is the one that the last M6 put into the spindle.
    pub spindle_tool: bool,
    /// Whose words for corners and leads are read, and what may change while compensation is on.
    pub words: ControlWords,
    /// Blocks that begin with / are left out: the switch of the control is on.
    pub block_delete: bool,
    /// How the parameter of splines through points is spaced, where the words leave it open.
    pub parameter: Parameter,
    /// How near curves that are no cubics, those with weights and of a high degree, are read as
    /// such [mm]; at least 1e-9.
    pub curve_tolerance: f64,
}

impl Rules {
    /// How a text is to be read: as asked for, or else in the language of the control, where that is
    /// strict or the text shows signs of no other.
    #[must_use]
    pub fn dialect(&self, asked: Dialect, text: &str) -> Dialect {
        if self.is_strict && asked == Dialect::Auto {
            return Dialect::LinuxCnc;
        }
        match (asked.of(text), self.words) {
            (Dialect::Auto, ControlWords::Fanuc) => Dialect::Fanuc,
            (Dialect::Auto, ControlWords::Sinumerik) => Dialect::Sinumerik,
            (found, _) => found,
        }
    }
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            any_lead: false,
            is_strict: false,
            spindle_tool: false,
            words: ControlWords::Common,
            block_delete: false,
            parameter: Parameter::Chord,
            curve_tolerance: CURVE_TOLERANCE,
        }
    }
}
