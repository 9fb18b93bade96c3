//! The names that options have in JavaScript, and what they stand for.
#![allow(missing_docs, reason = "the macro adds a variant and a function to each without a word")]

use wasm_bindgen::prelude::wasm_bindgen;

use crate::compensation::{CornerStyle, GougePolicy, LeadStyle, Output, SplineMethod};
use crate::contour::Side;
use crate::program::Dialect;
use crate::simulation::Profile;

/// `side` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SideName {
    /// G41.
    Left = "left",
    /// G42.
    Right = "right",
}

/// `output` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputName {
    /// Cubics.
    Cubics = "cubics",
    /// Arcs and lines.
    Arcs = "arcs",
}

/// `corner` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CornerName {
    /// Straight moves.
    Linear = "linear",
    /// An arc.
    Arc = "arc",
    /// To where the offsets meet.
    Intersection = "intersection",
}

/// `spline` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SplineName {
    /// The equidistant curve.
    Exact = "exact",
    /// The spline through the moved type points.
    TypePoints = "type-points",
}

/// `lead` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeadName {
    /// Joined as any corner.
    Textbook = "textbook",
    /// Straight to the end of the first offset.
    Perpendicular = "perpendicular",
    /// Round the corner by vectors.
    Intersection = "intersection",
    /// Onto the contour, and off it at right angles.
    ExtraMove = "extra-move",
    /// To beside the end of the lead-in.
    LinuxCnc = "linuxcnc",
}

/// `profile` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProfileName {
    /// The textbook's.
    G41 = "g41",
    /// `LinuxCNC`.
    LinuxCnc = "linuxcnc",
    /// FANUC cutter compensation C.
    Fanuc = "fanuc",
    /// Beckhoff and ISG.
    Isg = "isg",
    /// SINUMERIK.
    Sinumerik = "sinumerik",
}

/// `dialect` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DialectName {
    /// What the text shows signs of.
    Auto = "auto",
    /// `LinuxCNC`.
    LinuxCnc = "linuxcnc",
    /// FANUC and its kin.
    Fanuc = "fanuc",
    /// SINUMERIK.
    Sinumerik = "sinumerik",
}

/// `gouge` of `types.d.ts`.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GougeName {
    /// The path as it is, and what it gouges.
    Report = "report",
    /// The path without what it would gouge, and what it leaves uncut.
    Avoid = "avoid",
    /// No path where one would gouge.
    Stop = "stop",
}

// A name has a further variant for texts that are none of it; `api.js` lets none of these pass.

/// What a spline method's name stands for.
pub(super) fn spline_method(name: SplineName) -> Option<SplineMethod> {
    match name {
        SplineName::Exact => Some(SplineMethod::Exact),
        SplineName::TypePoints => Some(SplineMethod::TypePoints),
        SplineName::__Invalid => None,
    }
}

/// What an output's name stands for.
pub(super) fn output(name: OutputName) -> Option<Output> {
    match name {
        OutputName::Cubics => Some(Output::Cubics),
        OutputName::Arcs => Some(Output::Arcs),
        OutputName::__Invalid => None,
    }
}

/// What a corner style's name stands for.
pub(super) fn corner_style(name: CornerName) -> Option<CornerStyle> {
    match name {
        CornerName::Linear => Some(CornerStyle::Linear),
        CornerName::Arc => Some(CornerStyle::Arc),
        CornerName::Intersection => Some(CornerStyle::Intersection),
        CornerName::__Invalid => None,
    }
}

/// What a lead style's name stands for.
pub(super) fn lead_style(name: LeadName) -> Option<LeadStyle> {
    match name {
        LeadName::Textbook => Some(LeadStyle::Textbook),
        LeadName::Perpendicular => Some(LeadStyle::Perpendicular),
        LeadName::Intersection => Some(LeadStyle::Intersection),
        LeadName::ExtraMove => Some(LeadStyle::ExtraMove),
        LeadName::LinuxCnc => Some(LeadStyle::LinuxCnc),
        LeadName::__Invalid => None,
    }
}

/// What a profile's name stands for.
pub(super) fn profile(name: ProfileName) -> Option<Profile> {
    match name {
        ProfileName::G41 => Some(Profile::G41),
        ProfileName::LinuxCnc => Some(Profile::LinuxCnc),
        ProfileName::Fanuc => Some(Profile::Fanuc),
        ProfileName::Isg => Some(Profile::Isg),
        ProfileName::Sinumerik => Some(Profile::Sinumerik),
        ProfileName::__Invalid => None,
    }
}

/// What a dialect's name stands for.
pub(super) fn dialect(name: DialectName) -> Option<Dialect> {
    match name {
        DialectName::Auto => Some(Dialect::Auto),
        DialectName::LinuxCnc => Some(Dialect::LinuxCnc),
        DialectName::Fanuc => Some(Dialect::Fanuc),
        DialectName::Sinumerik => Some(Dialect::Sinumerik),
        DialectName::__Invalid => None,
    }
}

/// What a gouge policy's name stands for.
pub(super) fn gouge_policy(name: GougeName) -> Option<GougePolicy> {
    match name {
        GougeName::Report => Some(GougePolicy::Report),
        GougeName::Avoid => Some(GougePolicy::Avoid),
        GougeName::Stop => Some(GougePolicy::Stop),
        GougeName::__Invalid => None,
    }
}

/// The side of a name.
pub(super) fn side(name: SideName) -> Option<Side> {
    match name {
        SideName::Left => Some(Side::Left),
        SideName::Right => Some(Side::Right),
        SideName::__Invalid => None,
    }
}

/// The name of a side.
pub(super) fn side_name(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}
