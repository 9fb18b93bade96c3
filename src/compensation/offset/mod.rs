//! Offsets of single segments: the equidistant of a line, an arc or a spline. That of an involute
//! is geometry's.
//!
//! The offset by `δ = σ r` of a curve `C` with left normal `N` is `O = C + δ N`, and
//! `O' = C' (1 − δ κ)`: where `1 − δ κ` is negative the tool does not fit into the bend, and the
//! offset runs against the curve.

mod arc;
mod bend;
mod cusps;
mod fit;
mod involute;
mod line;
mod proof;
mod proved;
mod spline;

use glam::DVec2;

pub(super) use arc::{ArcOffset, offset_arc};
pub(super) use involute::involute_bend;
pub(super) use line::offset_line;
pub use proved::{ProvedPiece, proved_offset};
pub(super) use spline::{SpanEnd, offset_spline, spline_bends};
pub(super) use spline::{Tolerances, offset_span, offset_span_roughly};

/// A stretch of one segment that bends tighter than the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bend {
    /// The point of the segment that is cut deepest [mm].
    pub(super) at: DVec2,
    /// The centre of the tool that cuts it [mm].
    pub(super) center: DVec2,
    /// How deep [mm].
    pub(super) depth: f64,
    /// Its smallest radius of curvature [mm].
    pub(super) radius: f64,
}
