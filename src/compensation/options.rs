//! What the caller may choose about compensation.

use crate::contour::{Attributes, CornerWish, LeadWish};

/// How an outside corner is joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CornerStyle {
    /// By straight moves: the tool keeps clear of sharp corners.
    #[default]
    Linear,
    /// By an arc about the corner: the shortest way round.
    Arc,
    /// To where the offsets, lines run on straight and arcs on their circles, meet; by an arc about
    /// the corner where that is sharper than 100°, or beside a spline (SINUMERIK's G451).
    Intersection,
    /// By a conic whose peak lies this many parts of a hundred of the way from the arc about the
    /// corner to where the end tangents of the offsets meet; by the arc where the corner is sharper
    /// than 100° (SINUMERIK's G450 with DISC).
    Conic(u8),
}

/// How a spline is offset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SplineMethod {
    /// The true equidistant, within the tolerance.
    #[default]
    Exact,
    /// The spline through moved type points ("Tool radius compensation algorithm of spline
    /// curve", 2.3): at radius r at the type points, somewhat off between them.
    TypePoints,
}

/// What the path of a spline is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Output {
    /// Cubics: as few pieces as the tolerance allows.
    #[default]
    Cubics,
    /// Arcs and lines, for machines and libraries that know nothing else.
    Arcs,
}

/// How compensation is switched on and off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LeadStyle {
    /// As the article has it (2.4): round the corner between lead and contour as round any other.
    #[default]
    Textbook,
    /// Straight to the point beside the start of the first segment, and straight away from beside
    /// the end of the last (FANUC type A).
    Perpendicular,
    /// Into an inside corner straight; round an outside one beside the end of the lead-in, and to the
    /// intersection of the offsets, or along the moves that are inserted (FANUC type B). The
    /// textbook's, which is drawn after it.
    Intersection,
    /// To the programmed start of the first segment itself, and from there at right angles to it; at
    /// the end likewise (FANUC type C). The tool stands *on* the contour meanwhile.
    ExtraMove,
    /// To the point beside the end of the lead-in itself, from where the first corner is a corner
    /// like any other; straight away from beside the end of the last segment (`LinuxCNC`).
    LinuxCnc,
}

impl LeadStyle {
    /// Whether an outside corner between a lead and the contour is gone round as any other.
    #[must_use]
    pub fn goes_round(self) -> bool {
        matches!(self, Self::Textbook | Self::Intersection)
    }
}

/// Which turns are no corners.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum TangentBand {
    /// Turns φ with `r |φ| ≤ tolerance / 10`: the gap they leave is far within the tolerance.
    #[default]
    Auto,
    /// Turns of at most this angle [rad].
    Angle(f64),
}

/// What becomes of places where the tool does not fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum GougePolicy {
    /// The path is as a control without a look-ahead would cut it; what it gouges is reported.
    #[default]
    Report,
    /// The path leaves out what would gouge; what it leaves uncut is reported.
    Avoid,
    /// The first gouge is one too many: there is no path, only the report.
    Stop,
}

/// How many paths beside each other clear a pocket.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Passes {
    /// Along the contour only.
    #[default]
    One,
    /// This many, as far as there is room for them.
    Several {
        /// How many, the one along the contour included.
        count: u32,
        /// Distance from one to the next [mm].
        stepover: f64,
    },
    /// As many as there is room for.
    All {
        /// Distance from one to the next [mm].
        stepover: f64,
    },
}

/// Choices of [`compensate`](super::compensate) and [`compensate_all`](super::compensate_all).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Largest distance of the path of a spline from the true equidistant [mm].
    pub tolerance: f64,
    /// How outside corners are joined.
    pub corner: CornerStyle,
    /// How splines are offset.
    pub spline: SplineMethod,
    /// What the paths of splines are made of; [`compensate`](super::compensate) and
    /// [`avoid`](super::avoid) by themselves make cubics.
    pub output: Output,
    /// How compensation is switched on and off.
    pub lead: LeadStyle,
    /// Which turns are no corners.
    pub tangent_band: TangentBand,
    /// What becomes of places where the tool does not fit; [`compensate`](super::compensate) by
    /// itself reports them.
    pub gouge: GougePolicy,
    /// How many paths beside each other, where gouges are avoided.
    pub passes: Passes,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tolerance: 0.001,
            corner: CornerStyle::default(),
            spline: SplineMethod::default(),
            output: Output::default(),
            lead: LeadStyle::default(),
            tangent_band: TangentBand::default(),
            gouge: GougePolicy::default(),
            passes: Passes::default(),
        }
    }
}

/// Finest tolerance [mm]: below it, coordinates of a metre have no digits left.
pub const MIN_TOLERANCE: f64 = 1e-9;

impl Options {
    /// How the outside corner at the start of a segment is joined: as its program asks, or else as
    /// is chosen here.
    #[must_use]
    pub fn corner_of(&self, attributes: &Attributes) -> CornerStyle {
        match attributes.wish.corner {
            CornerWish::AsChosen => self.corner,
            CornerWish::Linear => CornerStyle::Linear,
            CornerWish::Arc => CornerStyle::Arc,
            CornerWish::Conic(disc) => CornerStyle::Conic(disc),
            CornerWish::Intersection => CornerStyle::Intersection,
        }
    }

    /// How a lead joins the contour.
    #[must_use]
    pub fn lead_of(&self, wish: LeadWish) -> LeadStyle {
        match wish {
            LeadWish::AsChosen => self.lead,
            LeadWish::Perpendicular => LeadStyle::Perpendicular,
            LeadWish::Round => LeadStyle::Textbook,
        }
    }

    /// The tolerance, at least [`MIN_TOLERANCE`].
    #[must_use]
    pub fn usable_tolerance(&self) -> f64 {
        self.tolerance.max(MIN_TOLERANCE)
    }

    /// The largest turn that is no corner for a tool of `radius` [mm], in rad.
    #[must_use]
    pub fn band(&self, radius: f64) -> f64 {
        match self.tangent_band {
            TangentBand::Auto => 0.1 * self.usable_tolerance() / radius,
            TangentBand::Angle(angle) => angle,
        }
    }
}
