//! The G words: what each means here, and which exclude each other in a block.

use super::feed::FeedMode;
use super::pending_spline::Family;
use crate::contour::{Plane, Side};

/// How axis words move the tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Motion {
    /// G00.
    Rapid,
    /// G01.
    Linear,
    /// G02 and G03.
    Arc {
        /// G02.
        clockwise: bool,
    },
    /// CT: the arc that goes on tangentially.
    Tangent,
    /// CIP: the arc through a point between (I1, J1, K1).
    ByPoint,
    /// G02.2 and G03.2.
    Involute {
        /// G02.2.
        clockwise: bool,
    },
    /// G05 with axes alone.
    TypePoints,
    /// G05 with I, J, P and Q.
    Cubic,
    /// G05.1 with I and J.
    Quadratic,
    /// G05.2.
    Controls,
    /// G06.1.
    Through,
    /// G06.2.
    Knots,
    /// ASPLINE, BSPLINE and CSPLINE.
    Named(Family),
    /// G73, G74, G76 and G81 to G89, by its number.
    Cycle(u32),
    /// Moves that the machine makes in its own way, by ten times their G word: threads (G33, G33.1)
    /// and probing (G38.2 to G38.5, FANUC's G31).
    Passed(u32),
    /// A mode whose blocks cannot be turned into moves; its name.
    NotSupported(&'static str),
}

/// A word that switches compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Compensation {
    /// G40.
    Off,
    /// G41 and G42: the radius of a tool.
    Tool(Side),
    /// G41.1 and G42.1: the diameter is the D word.
    Diameter(Side),
}

/// A word that acts before the move of its block, with axis words of its own or without.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Act {
    /// G10.
    SetData,
    /// G28 and G30.
    Home,
    /// G28.1 and G30.1.
    StoreHome,
    /// G53.
    Machine,
    /// G92.
    Origin,
    /// G92.1, and G92.2, which keeps the shift for G92.3.
    OriginOff,
    /// G92.3.
    OriginOn,
    /// G54 to G59.3 from 0, and G54.1 with a P word.
    System(Option<usize>),
    /// G52.
    Local,
    /// G50 and G51.
    Scale(bool),
    /// G50.1 and G51.1.
    Mirror(bool),
    /// G69 and G68.
    Rotate(bool),
    /// G15 and G16.
    Polar(bool),
}

/// What a G word means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum GWord {
    /// How the axis words of this block and the next ones move the tool.
    Motion(Motion),
    /// How those of this block alone do (G31, G60).
    Once(Motion),
    /// G12.1 and G13.1.
    PolarInterpolation(bool),
    /// A word of the G05 and G06 families, told apart by the words beside it.
    SplineFamily,
    /// G80: the end of a cycle.
    EndOfCycle,
    /// G04.
    Dwell,
    /// G17, G18 and G19.
    Plane(Plane),
    /// G20 and G21.
    Inches(bool),
    /// G90 and G91.
    Relative(bool),
    /// G90.1 and G91.1.
    AbsoluteCenter(bool),
    /// G07 and G08: whether X words are diameters.
    Diameter(bool),
    /// G98 and G99: whether cycles go back to the level R only.
    RetractToR(bool),
    /// G93, G94 and G95.
    FeedMode(FeedMode),
    /// G96 and G97: whether S is the speed of the surface.
    SurfaceSpeed(bool),
    /// G40 to G42.1.
    Compensation(Compensation),
    /// G43, G44 and their like, and G49: the height has another number from here on.
    Length(bool),
    /// It changes coordinates, or moves by others.
    Act(Act),
    /// It changes nothing here.
    Harmless,
    /// It changes no path, on other controls; its letters.
    Noted(&'static str),
    /// It is for the controller and moves nothing; its letters.
    PassedOn(&'static str),
    /// Its block cannot be turned into moves; what it is.
    NotSupported(&'static str),
}

/// The meaning of a G word by ten times its number; what `LinuxCNC` has no such word for is none
/// where `is_strict`.
pub(super) fn g_word(tenths: u32, is_strict: bool) -> Option<GWord> {
    common(tenths).or_else(|| if is_strict { None } else { elsewhere(tenths) })
}

/// Words of other controls: FANUC, Haas (G103, G110 to G129, G154, G187) and SINUMERIK.
fn elsewhere(tenths: u32) -> Option<GWord> {
    Some(match tenths {
        90 => GWord::PassedOn(""),
        121 => GWord::PolarInterpolation(true),
        131 => GWord::PolarInterpolation(false),
        150 => GWord::Act(Act::Polar(false)),
        160 => GWord::Act(Act::Polar(true)),
        // Fields that are not to be entered, and how exactly and how far ahead the control goes.
        220 => GWord::Noted("XYZIJK"),
        230 | 620 | 6010 | 6020 | 6030 => GWord::Noted(""),
        1030 => GWord::Noted("P"),
        1870 => GWord::Noted("PE"),
        310 => GWord::Once(Motion::Passed(310)),
        390 => GWord::NotSupported("the corner arc (G39)"),
        440 => GWord::Length(true),
        500 => GWord::Act(Act::Scale(false)),
        510 => GWord::Act(Act::Scale(true)),
        501 => GWord::Act(Act::Mirror(false)),
        511 => GWord::Act(Act::Mirror(true)),
        1530 => GWord::Act(Act::Machine),
        541 | 1540 => GWord::Act(Act::System(None)),
        600 => GWord::Once(Motion::Rapid),
        660 => GWord::NotSupported("a macro call"),
        680 => GWord::Act(Act::Rotate(true)),
        690 => GWord::Act(Act::Rotate(false)),
        // G110 to G129, G500, and G505 to G599.
        1100..=1290 | 5000 | 5050..=5990 if tenths.is_multiple_of(10) => {
            GWord::Act(Act::System(None))
        }
        // What calls a macro was taken out of the block before.
        670 => GWord::Harmless,
        _ => return None,
    })
}

fn common(tenths: u32) -> Option<GWord> {
    use GWord::{
        AbsoluteCenter, Diameter, Dwell, EndOfCycle, Inches, Length, PassedOn, Relative,
        RetractToR, SplineFamily, SurfaceSpeed,
    };
    Some(match tenths {
        0 => GWord::Motion(Motion::Rapid),
        10 => GWord::Motion(Motion::Linear),
        20 => GWord::Motion(Motion::Arc { clockwise: true }),
        30 => GWord::Motion(Motion::Arc { clockwise: false }),
        22 => GWord::Motion(Motion::Involute { clockwise: true }),
        32 => GWord::Motion(Motion::Involute { clockwise: false }),
        40 => Dwell,
        50..=53 | 61 | 62 => SplineFamily,
        70 => Diameter(true),
        80 => Diameter(false),
        610 | 611 => PassedOn(""),
        100 => GWord::Act(Act::SetData),
        170 => GWord::Plane(Plane::Xy),
        180 => GWord::Plane(Plane::Zx),
        190 => GWord::Plane(Plane::Yz),
        200 => Inches(true),
        210 => Inches(false),
        280 | 300 => GWord::Act(Act::Home),
        281 | 301 => GWord::Act(Act::StoreHome),
        330 | 331 | 382..=385 => GWord::Motion(Motion::Passed(tenths)),
        400 => GWord::Compensation(Compensation::Off),
        410 => GWord::Compensation(Compensation::Tool(Side::Left)),
        420 => GWord::Compensation(Compensation::Tool(Side::Right)),
        411 => GWord::Compensation(Compensation::Diameter(Side::Left)),
        421 => GWord::Compensation(Compensation::Diameter(Side::Right)),
        430..=432 => Length(true),
        490 => Length(false),
        520 => GWord::Act(Act::Local),
        530 => GWord::Act(Act::Machine),
        540 => GWord::Act(Act::System(Some(0))),
        550 => GWord::Act(Act::System(Some(1))),
        560 => GWord::Act(Act::System(Some(2))),
        570 => GWord::Act(Act::System(Some(3))),
        580 => GWord::Act(Act::System(Some(4))),
        590..=593 => GWord::Act(Act::System(Some((tenths - 585) as usize))),
        640 => PassedOn("PQ"),
        730 | 740 | 760 | 810 | 820 | 830 | 840 | 850 | 860 | 870 | 880 | 890 => {
            GWord::Motion(Motion::Cycle(tenths / 10))
        }
        800 => EndOfCycle,
        900 => Relative(false),
        910 => Relative(true),
        901 => AbsoluteCenter(true),
        911 => AbsoluteCenter(false),
        920 => GWord::Act(Act::Origin),
        921 | 922 => GWord::Act(Act::OriginOff),
        923 => GWord::Act(Act::OriginOn),
        930 => GWord::FeedMode(FeedMode::InverseTime),
        940 => GWord::FeedMode(FeedMode::PerMinute),
        950 => GWord::FeedMode(FeedMode::PerRevolution),
        960 => SurfaceSpeed(true),
        970 => SurfaceSpeed(false),
        980 => RetractToR(false),
        990 => RetractToR(true),
        _ => return None,
    })
}

impl GWord {
    /// Words of one group exclude each other; `None` for words that stand alone, fewer of which do on
    /// a control that is strict.
    pub(super) fn group(self, is_strict: bool) -> Option<u8> {
        match self {
            Self::Motion(_) | Self::Once(_) | Self::SplineFamily => Some(1),
            Self::Plane(_) => Some(2),
            Self::Relative(_) => Some(3),
            Self::AbsoluteCenter(_) => Some(4),
            Self::FeedMode(_) => Some(5),
            Self::Inches(_) => Some(6),
            Self::Compensation(_) => Some(7),
            Self::Length(_) => Some(8),
            Self::RetractToR(_) => Some(10),
            Self::Act(Act::System(_)) => Some(12),
            Self::SurfaceSpeed(_) => Some(14),
            Self::Diameter(_) => Some(15),
            Self::PassedOn(_) if is_strict => Some(13),
            Self::Dwell | Self::Act(_) if is_strict => Some(0),
            Self::EndOfCycle
            | Self::Dwell
            | Self::Harmless
            | Self::Noted(_)
            | Self::PolarInterpolation(_)
            | Self::Act(_)
            | Self::PassedOn(_)
            | Self::NotSupported(_) => None,
        }
    }
}
