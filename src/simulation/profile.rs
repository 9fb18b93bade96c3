//! Profiles: how the control that a program is written for reads and compensates it.

use crate::compensation::{CornerStyle, LeadStyle, Options, TangentBand};
use crate::program::{ControlWords, Rules};

/// Turns that `LinuxCNC` takes for none [rad] (`TOLERANCE_CONCAVE_CORNER` of its interpreter).
const LINUXCNC_BAND: f64 = 0.05;

/// The largest turn that Beckhoff and ISG controls take for none by default: 3°, in rad
/// (`TANGENTIAL_LIMIT`).
const ISG_BAND: f64 = 3.0 * std::f64::consts::PI / 180.0;

/// Whose compensation a program is written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Profile {
    /// The textbook's: straight moves are inserted at acute corners.
    #[default]
    G41,
    /// `LinuxCNC`.
    LinuxCnc,
    /// FANUC cutter compensation C, with leads of type A.
    Fanuc,
    /// The ISG kernel, as in Beckhoff controls, with G25 and G139.
    Isg,
    /// SINUMERIK with G450 and NORM.
    Sinumerik,
}

impl Profile {
    /// The options of compensation that the control's rules amount to.
    #[must_use]
    pub fn options(self) -> Options {
        let base = Options::default();
        match self {
            Self::G41 => base,
            Self::Fanuc => Options { lead: LeadStyle::Perpendicular, ..base },
            Self::LinuxCnc => Options {
                corner: CornerStyle::Arc,
                lead: LeadStyle::LinuxCnc,
                tangent_band: TangentBand::Angle(LINUXCNC_BAND),
                ..base
            },
            Self::Isg => Options { tangent_band: TangentBand::Angle(ISG_BAND), ..base },
            Self::Sinumerik => {
                Options { corner: CornerStyle::Arc, lead: LeadStyle::Perpendicular, ..base }
            }
        }
    }

    /// How the control reads the words of compensation.
    #[must_use]
    pub fn rules(self) -> Rules {
        let is_linuxcnc = self == Self::LinuxCnc;
        Rules {
            any_lead: is_linuxcnc,
            is_strict: is_linuxcnc,
            spindle_tool: is_linuxcnc,
            words: match self {
                Self::G41 | Self::LinuxCnc => ControlWords::Common,
                Self::Fanuc => ControlWords::Fanuc,
                Self::Isg => ControlWords::Isg,
                Self::Sinumerik => ControlWords::Sinumerik,
            },
            ..Rules::default()
        }
    }
}
