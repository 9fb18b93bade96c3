//! Where the offsets of two segments meet in an inside corner.
//!
//! Of two points where they do, that one counts by which the move before the corner is cut short
//! least, along its whole line or circle; it need not lie on either move.

use glam::DVec2;

use super::Refused;
use crate::geometry::{direction, perp};

/// The offset of a segment.
#[derive(Debug, Clone, Copy)]
pub(super) enum Flank {
    /// A straight line.
    Line,
    /// A circle.
    Arc {
        /// Its centre [mm].
        center: DVec2,
        /// Its radius [mm].
        radius: f64,
        clockwise: bool,
        /// Whether the tool is inside of the arc.
        is_inside: bool,
    },
}

/// An inside corner: of the incoming and the outgoing segment the tangents, and the normals to the
/// side of the tool.
pub(super) struct InsideCorner {
    pub(super) point: DVec2,
    pub(super) tool_radius: f64,
    pub(super) tangents: [DVec2; 2],
    pub(super) normals: [DVec2; 2],
}

const NO_ROOM: Refused = Refused("corner-refused", "the tool does not fit into the inside corner");

impl InsideCorner {
    /// Where the flanks of the incoming and the outgoing segment meet [mm].
    pub(super) fn meet(&self, flanks: [Flank; 2]) -> Result<DVec2, Refused> {
        match flanks {
            [Flank::Line, Flank::Line] => {
                let sum = self.normals[0] + self.normals[1];
                let towards = sum * (2.0 * self.tool_radius / sum.length_squared());
                if towards.is_finite() { Ok(self.point + towards) } else { Err(NO_ROOM) }
            }
            [Flank::Line, Flank::Arc { center, radius, is_inside, .. }] => {
                self.on_line(0, center, radius, is_inside, 1.0)
            }
            [Flank::Arc { center, radius, is_inside, .. }, Flank::Line] => {
                self.on_line(1, center, radius, is_inside, -1.0)
            }
            [
                Flank::Arc { center, radius, is_inside, .. },
                Flank::Arc { center: next, radius: next_radius, clockwise, .. },
            ] => {
                let apart = next - center;
                let towards = direction(apart).ok_or(NO_ROOM)?;
                let distance = apart.length();
                // Two sides of a triangle about the first centre, and the cosine between them.
                let cosine = (radius * radius + distance * distance - next_radius * next_radius)
                    / (2.0 * radius * distance);
                if cosine.is_nan() || cosine.abs() > 1.0 {
                    return Err(NO_ROOM);
                }
                let sine = (1.0 - cosine * cosine).sqrt();
                let across = if is_inside == clockwise { -sine } else { sine };
                Ok(center + (towards * cosine + perp(towards) * across) * radius)
            }
        }
    }

    /// Where the offset of the straight segment, 0 or 1 in order, meets that of an arc; `sense` is
    /// the side of the foot of its centre, along the line, where the tool inside of the arc comes to.
    fn on_line(
        &self,
        line: usize,
        center: DVec2,
        radius: f64,
        is_inside: bool,
        sense: f64,
    ) -> Result<DVec2, Refused> {
        let (tangent, normal) = (self.tangents[line], self.normals[line]);
        let (own, sense) = if is_inside {
            (radius + self.tool_radius, sense)
        } else {
            (radius - self.tool_radius, -sense)
        };
        // The corner is on the arc itself, in the direction of its centre, or that centre.
        let to_center = direction(center - self.point).unwrap_or_default();
        let height = self.tool_radius - own * normal.dot(to_center);
        let squared = radius * radius - height * height;
        if squared < 0.0 {
            return Err(NO_ROOM);
        }
        Ok(center + normal * height + tangent * (sense * squared.sqrt()))
    }
}
