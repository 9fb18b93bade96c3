//! The offset of a line: the same line, moved sideways.

use crate::geometry::{Line, perp};

/// The line moved by `offset` [mm] to its left; `None` where that leaves the range of coordinates.
pub(in crate::compensation) fn offset_line(line: &Line, offset: f64) -> Option<Line> {
    let sideways = perp(line.tangent()) * offset;
    Line::new(line.start() + sideways, line.end() + sideways).ok()
}
