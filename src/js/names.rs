//! The names that options and requests have in JavaScript, and what they stand for.
#![allow(missing_docs, reason = "the macro adds a variant and a function to each without a word")]
#![allow(clippy::float_cmp_const, reason = "the macro compares the number that an enum is there")]

use wasm_bindgen::prelude::wasm_bindgen;

use crate::compensation::{CornerStyle, GougePolicy, LeadStyle, Output, SplineMethod};
use crate::contour::Side;
use crate::geometry::Parameter;
use crate::program::{Dialect, SplineOutput, Target};
use crate::simulation::Profile;

/// Names that cross the boundary, each for the variant of the core's type that is called the same. A
/// name has a further variant for texts that are none of it; `options.js` lets none of these pass.
macro_rules! names {
    ($($(#[$doc:meta])* $name:ident of $meaning:ident { $($variant:ident = $text:tt),+ })+) => { $(
        $(#[$doc])*
        #[wasm_bindgen]
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name { $($variant = $text),+ }

        impl $name {
            /// What it stands for.
            pub(super) fn meaning(self) -> Option<$meaning> {
                match self {
                    $(Self::$variant => Some($meaning::$variant),)+
                    Self::__Invalid => None,
                }
            }
        }
    )+ };
}

names! {
    /// `side` of `types.d.ts`.
    SideName of Side { Left = "left", Right = "right" }

    /// `output` of `types.d.ts`.
    OutputName of Output { Cubics = "cubics", Arcs = "arcs" }

    /// `corner` of `types.d.ts`.
    CornerName of CornerStyle { Linear = "linear", Arc = "arc", Intersection = "intersection" }

    /// `spline` of `types.d.ts`.
    SplineName of SplineMethod { Exact = "exact", TypePoints = "type-points" }

    /// `lead` of `types.d.ts`.
    LeadName of LeadStyle {
        Textbook = "textbook",
        Perpendicular = "perpendicular",
        Intersection = "intersection",
        ExtraMove = "extra-move",
        LinuxCnc = "linuxcnc"
    }

    /// `profile` of `types.d.ts`.
    ProfileName of Profile {
        G41 = "g41",
        LinuxCnc = "linuxcnc",
        Fanuc = "fanuc",
        Isg = "isg",
        Sinumerik = "sinumerik"
    }

    /// `dialect` of `types.d.ts`.
    DialectName of Dialect {
        Auto = "auto",
        LinuxCnc = "linuxcnc",
        Fanuc = "fanuc",
        Sinumerik = "sinumerik"
    }

    /// `gouge` of `types.d.ts`.
    GougeName of GougePolicy { Report = "report", Avoid = "avoid", Stop = "stop" }

    /// `splineParameter` of `types.d.ts`.
    ParameterName of Parameter { Chord = "chord", Centripetal = "centripetal" }

    /// `target` of `types.d.ts`.
    TargetName of Target {
        Grbl = "grbl",
        GrblHal = "grblhal",
        LinuxCnc = "linuxcnc",
        Smoothieware = "smoothieware",
        Marlin = "marlin",
        Fanuc0M = "fanuc-0m",
        Fanuc6M = "fanuc-6m",
        Fanuc30I = "fanuc-30i",
        Heidenhain = "heidenhain"
    }

    /// `splines` of `types.d.ts`.
    WrittenName of SplineOutput { Arcs = "arcs", Native = "native" }
}

/// What is done to a point.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edit {
    /// The start of the contour is moved.
    MoveStart,
    /// A point of a segment is moved.
    MovePoint,
    /// A type point is inserted.
    InsertPoint,
    /// A type point is removed.
    RemovePoint,
}

/// A list that a path has.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum List {
    /// `diagnostics` of `types.d.ts`.
    Diagnostics,
    /// `transitions`.
    Transitions,
    /// `gouges`.
    Gouges,
    /// `loops`.
    Loops,
    /// `uncut`.
    Uncut,
}

/// The name of a side.
pub(super) fn side_name(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}
