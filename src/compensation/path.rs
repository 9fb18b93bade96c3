//! Collecting the moves of a tool path, one after the other.

use glam::DVec2;

use crate::contour::{Attributes, Move, MoveCurve, Role, ToolPath};
use crate::geometry::{Line, MIN_LENGTH};

/// A tool path in the making.
#[derive(Debug, Default)]
pub(super) struct PathBuilder {
    pub(super) path: ToolPath,
}

impl PathBuilder {
    /// Where the tool is, once it has moved [mm].
    fn position(&self) -> Option<DVec2> {
        self.path.moves.last().map(|last| last.curve.end())
    }

    /// Appends moves of one segment, whose change of height is spread over their length.
    pub(super) fn moves(&mut self, curves: &[MoveCurve], role: Role, attributes: &Attributes) {
        let [start, end] = attributes.heights;
        let climbs = start != end;
        let total: f64 = if climbs { curves.iter().map(MoveCurve::length).sum() } else { 0.0 };
        let mut run = 0.0;
        let mut height = start;
        for (i, curve) in curves.iter().enumerate() {
            self.bridge(curve.start(), role, attributes, height);
            let to = if climbs && i + 1 < curves.len() {
                run += curve.length();
                start + (end - start) * run / total
            } else {
                end
            };
            self.piece(*curve, role, attributes, [height, to]);
            height = to;
        }
        if climbs
            && curves.is_empty()
            && let Some(at) = self.position()
        {
            // The segment has come to a point; its change of height has not.
            self.piece(MoveCurve::Vertical(at), role, attributes, [start, end]);
        }
    }

    /// Appends one move of a piece of path that may start anywhere, between two heights [mm].
    pub(super) fn piece(
        &mut self,
        curve: MoveCurve,
        role: Role,
        attributes: &Attributes,
        heights: [f64; 2],
    ) {
        let Attributes { origin, feed, rapid, plane, .. } = *attributes;
        self.path.moves.push(Move { curve, role, rapid, feed, plane, heights, origin });
    }

    /// A straight move to `point`. If the tool is there already, only its height changes.
    pub(super) fn line_to(&mut self, from: DVec2, point: DVec2, role: Role, with: &Attributes) {
        match Line::new(from, point) {
            Ok(line) => self.moves(&[MoveCurve::Line(line)], role, with),
            Err(_) if with.heights[0] != with.heights[1] => {
                self.moves(&[MoveCurve::Vertical(from)], role, with);
            }
            Err(_) => {}
        }
    }

    /// Closes the gap to the next move where a segment in between has come to a point.
    fn bridge(&mut self, to: DVec2, role: Role, attributes: &Attributes, height: f64) {
        if let Some(from) = self.position()
            && from.distance(to) > MIN_LENGTH
            && let Ok(line) = Line::new(from, to)
        {
            self.piece(MoveCurve::Line(line), role, attributes, [height; 2]);
        }
    }
}

/// What a move between two segments carries: rapid only between rapids, at the feed of the
/// segment it comes from, at the height where the next one starts.
pub(super) fn between(incoming: &Attributes, outgoing: &Attributes) -> Attributes {
    let rapid = incoming.rapid && outgoing.rapid;
    let feed = if incoming.rapid { outgoing.feed } else { incoming.feed.or(outgoing.feed) };
    Attributes {
        origin: outgoing.origin,
        feed,
        time: None,
        rapid,
        plane: outgoing.plane,
        heights: [outgoing.heights[0]; 2],
        wish: outgoing.wish,
    }
}
