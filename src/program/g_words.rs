//! The G words: what each means here, and which exclude each other in a block.

use crate::contour::Side;

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
    /// G05 with axes alone.
    TypePoints,
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

/// What a G word means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum GWord {
    /// How the axis words of this block and the next ones move the tool.
    Motion(Motion),
    /// A word of the G05 and G06 families, told apart by the words beside it.
    SplineFamily,
    /// G80: the end of a cycle.
    EndOfCycle,
    /// G04.
    Dwell,
    /// G17, or another plane by its name.
    Plane(Option<&'static str>),
    /// G20 and G21.
    Inches(bool),
    /// G90 and G91.
    Relative(bool),
    /// G90.1 and G91.1.
    AbsoluteCenter(bool),
    /// G94, or another meaning of F by its name.
    FeedMode(Option<&'static str>),
    /// G40 to G42.1.
    Compensation(Compensation),
    /// It changes nothing here.
    Harmless,
    /// It is for the controller and moves nothing.
    PassedOn,
    /// It is left out, and the machine has to make up for it; what it is and its letters.
    LeftOut(&'static str, &'static str),
    /// It is left out, which leaves the path as it is; what it is and its letters.
    Noted(&'static str, &'static str),
    /// Its block cannot be turned into moves; what it is.
    NotSupported(&'static str),
}

/// The meaning of a G word by ten times its number.
pub(super) fn g_word(tenths: u32) -> Option<GWord> {
    Some(match tenths {
        0 => GWord::Motion(Motion::Rapid),
        10 => GWord::Motion(Motion::Linear),
        20 => GWord::Motion(Motion::Arc { clockwise: true }),
        30 => GWord::Motion(Motion::Arc { clockwise: false }),
        40 => GWord::Dwell,
        50..=53 | 61 | 62 => GWord::SplineFamily,
        100 => GWord::NotSupported("setting data (G10)"),
        121 => GWord::NotSupported("polar coordinate interpolation (G12.1)"),
        160 => GWord::NotSupported("polar coordinates (G16)"),
        170 => GWord::Plane(None),
        180 => GWord::Plane(Some("G18")),
        190 => GWord::Plane(Some("G19")),
        200 => GWord::Inches(true),
        210 => GWord::Inches(false),
        280 | 300 => GWord::NotSupported("going to the reference point"),
        281 | 301 => GWord::NotSupported("storing the reference point"),
        310 | 382..=385 => GWord::NotSupported("probing"),
        330 | 331 => GWord::Motion(Motion::NotSupported("threading")),
        390 => GWord::NotSupported("the corner arc (G39)"),
        400 => GWord::Compensation(Compensation::Off),
        410 => GWord::Compensation(Compensation::Tool(Side::Left)),
        420 => GWord::Compensation(Compensation::Tool(Side::Right)),
        411 => GWord::Compensation(Compensation::Diameter(Side::Left)),
        421 => GWord::Compensation(Compensation::Diameter(Side::Right)),
        430 | 440 => GWord::LeftOut("tool length compensation", "H"),
        431 => GWord::LeftOut("tool length compensation", "HXYZ"),
        510 => GWord::NotSupported("scaling (G51)"),
        520 => GWord::NotSupported("the local coordinate system (G52)"),
        530 => GWord::NotSupported("machine coordinates (G53)"),
        540 | 550 | 560 | 570 | 580 | 590..=593 => GWord::PassedOn,
        600 => GWord::NotSupported("one-sided positioning (G60)"),
        640 => GWord::Noted("path blending", "PQ"),
        650 | 660 => GWord::NotSupported("a macro call"),
        680 => GWord::NotSupported("rotated coordinates (G68)"),
        730 | 740 | 760 | 810 | 820..=890 if tenths.is_multiple_of(10) => {
            GWord::Motion(Motion::NotSupported("a cycle"))
        }
        800 => GWord::EndOfCycle,
        900 => GWord::Relative(false),
        910 => GWord::Relative(true),
        901 => GWord::AbsoluteCenter(true),
        911 => GWord::AbsoluteCenter(false),
        920 | 923 => GWord::NotSupported("moving the origin (G92)"),
        930 => GWord::FeedMode(Some("inverse time feed (G93)")),
        940 => GWord::FeedMode(None),
        950 => GWord::FeedMode(Some("feed per revolution (G95)")),
        960 => GWord::NotSupported("constant surface speed (G96)"),
        // Exact stop and the ends of modes that are not supported anyway: lathe diameters, polar
        // coordinates, length compensation, scaling, macros, rotation, G92; spindle speed in
        // rev/min; the return level of cycles.
        80 | 90 | 131 | 150 | 490 | 500 | 610 | 611 | 670 | 690 | 921 | 922 | 970 | 980 | 990 => {
            GWord::Harmless
        }
        _ => return None,
    })
}

impl GWord {
    /// Words of one group exclude each other; `None` for words that stand alone.
    pub(super) fn group(self) -> Option<u8> {
        match self {
            Self::Motion(_) | Self::SplineFamily | Self::EndOfCycle => Some(1),
            Self::Plane(_) => Some(2),
            Self::Relative(_) => Some(3),
            Self::AbsoluteCenter(_) => Some(4),
            Self::FeedMode(_) => Some(5),
            Self::Inches(_) => Some(6),
            Self::Compensation(_) => Some(7),
            Self::Dwell
            | Self::Harmless
            | Self::PassedOn
            | Self::LeftOut(..)
            | Self::Noted(..)
            | Self::NotSupported(_) => None,
        }
    }
}
