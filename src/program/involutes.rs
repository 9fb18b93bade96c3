//! G02.2 and G03.2: involutes, as FANUC controls state them and are told them.
//!
//! `G17 G02.2 X Y I J R`: I and J lead from the start to the centre of the base circle, whatever
//! G90 and G90.1 say, and R is its radius. In G18 the centre is K and I, in G19 J and K.

use glam::DVec3;

use super::arcs::CENTER;
use super::axes::Axes;
use super::block::Block;
use super::emit::Emitter;
use super::interpret::Interpreter;
use super::words::Words;
use crate::contour::{Move, Shape};
use crate::geometry::Involute;

/// Part of the tolerance of arcs and lines that the cubics along an involute may be off by.
const CUBICS_SHARE: f64 = 0.02;

/// How far off the involute through the start the end may come to be by rounding [units of the last
/// digit].
const ROUNDED: f64 = 4.0;

impl Interpreter {
    /// The involute as described, `None` where a straight move has to stand in its place.
    pub(super) fn involute_shape(
        &mut self,
        block: &Block,
        words: &mut Words,
        axes: &Axes,
        to: DVec3,
        clockwise: bool,
    ) -> Option<Shape> {
        let plane = self.modal.plane;
        let [first, second, _] = plane.axes();
        // A word of the third axis is left over, and told so.
        let center = [words.take(CENTER[first]), words.take(CENTER[second])];
        let radius = words.take('R');
        let leads = axes.words[first].or(axes.words[second]).is_some();
        let Some(radius) = radius.filter(|_| leads && center != [None; 2]) else {
            let hint = "add what is missing; a straight line stands in its place";
            let message = "an involute needs its end, its centre and R";
            self.error("involute-incomplete", message, block.start(), hint);
            return None;
        };
        let factor = self.even_factor(block)?;
        Some(Shape::Involute {
            to: plane.split(to).0,
            center: self.center(center, false),
            radius: radius.value * self.modal.unit() * factor,
            clockwise,
        })
    }
}

impl Emitter {
    /// An involute as one block where the target knows it, else as arcs and lines.
    pub(super) fn involute(&mut self, involute: &Involute, like: &Move) {
        let level = like.heights[0] == like.heights[1];
        if !(self.out.facts.involutes && level && self.involute_block(involute, like)) {
            let whole = self.tolerance;
            self.tolerance = (1.0 - CUBICS_SHARE) * whole;
            self.cubics(&involute.cubics(CUBICS_SHARE * whole), like);
            self.tolerance = whole;
        }
    }

    /// Writes an involute as one block, unless rounding leaves nothing of it.
    fn involute_block(&mut self, involute: &Involute, like: &Move) -> bool {
        let (plane, clockwise) = (like.plane, involute.is_clockwise());
        let to = self.out.place(plane.place(involute.end(), like.heights[1]));
        let (start, end) = (self.in_plane(plane, self.out.at), self.in_plane(plane, to));
        let way = involute.center() - start;
        let offset = [self.out.units(way.x), self.out.units(way.y)];
        let center = start + self.way(offset);
        // The radius that the rounded places ask for: read again, it comes out the same.
        let (radius, tolerance) = (involute.base_radius(), ROUNDED * self.unit);
        let Ok(written) = Involute::new(start, end, center, radius, clockwise, tolerance) else {
            return false;
        };
        let mut radius = self.out.units(written.base_radius());
        // Rounded up it could leave an end inside its circle.
        let least = start.distance(center).min(end.distance(center));
        if radius as f64 * self.unit > least {
            radius -= 1;
        }
        self.out.involute(clockwise, plane, to, offset, radius);
        true
    }
}
