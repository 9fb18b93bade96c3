//! What an interpreted program consists of.

use crate::contour::{Contour, Move, Reset, Side};
use crate::diagnostic::{Diagnostic, Origin};

/// One step of an interpreted program.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// A move without compensation.
    Free(Move),
    /// Words to be passed through. They move nothing, apart from two cases: a block that states a
    /// coordinate assumed already, at the beginning or after a change of the coordinate system,
    /// such as `G0 X0 Y0` or `G1 Z0 F100`; and moves that only the machine knows the end of (G28,
    /// G53), which come with a reset.
    Words {
        /// The words, as [`AuxiliaryWords`](crate::contour::AuxiliaryWords) has them.
        words: String,
        /// What they do to the coordinates.
        reset: Option<Reset>,
        /// The block they come from.
        origin: Origin,
    },
    /// A contour to be compensated.
    Contour(Box<ProgrammedContour>),
}

/// A contour between the words that switch compensation on and off.
#[derive(Debug, Clone, PartialEq)]
pub struct ProgrammedContour {
    /// The contour with its lead-in and lead-out.
    pub contour: Contour,
    /// The side of the tool.
    pub side: Side,
    /// Where the tool radius comes from.
    pub radius: RadiusSource,
    /// What is to be left on the contour, added to the radius [mm].
    pub allowance: f64,
    /// The unit of coordinates in effect at the word that switches on [mm]: diameters of a table of
    /// tools that names no unit count in it.
    pub unit: f64,
    /// Which way the tip of the tool points.
    pub orientation: OrientationSource,
    /// Of each spline of several blocks, those of its pieces: the segment itself has the first.
    pub curves: Vec<Vec<Origin>>,
    /// Whether its first segment is itself the lead-in: an arc, or all that there is.
    pub leads_in: bool,
    /// How it begins.
    pub begins: ContourStart,
    /// How it ends.
    pub end: ContourEnd,
    /// The line of the word that switches on, and the last line that belongs to the contour.
    pub blocks: [u32; 2],
}

/// How a programmed contour begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContourStart {
    /// With a lead-in, or where the contour before it has ended.
    Anew,
    /// Its first segment is the last one of the contour before it, on which the radius changes.
    Tapers,
    /// The tool changes its side: where its path crosses that beside the contour before it.
    Crosses,
}

/// How a programmed contour ends.
#[derive(Debug, Clone, PartialEq)]
pub enum ContourEnd {
    /// Compensation is switched off, or the program ends.
    Off,
    /// It is switched off, and the tool changed before the next move: whatever no word states stays where
    /// the tool is, beside the contour.
    Beside,
    /// Its last segment is the first of the next contour, on which the radius changes.
    Tapers,
    /// The control stops in the middle of it, and makes no move whose end it does not know yet.
    CutOff,
    /// It is switched off, but unless its tool has no radius the control stops at what follows.
    Refused(Box<Diagnostic>),
}

/// Where it comes from which way the tip of a tool points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrientationSource {
    /// The table of tools, as for [`RadiusSource`].
    Tool(u32),
    /// The program itself, as lathe tools are numbered: 1 to 9, or 0.
    Given(u8),
}

/// Where a tool radius comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RadiusSource {
    /// The table of tools: the D word, or the active tool where there is none.
    Tool(u32),
    /// The program itself [mm].
    Given(f64),
}
