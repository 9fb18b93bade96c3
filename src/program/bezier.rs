//! G05 with I, J, P and Q, and G05.1: Bézier curves of one block, as `LinuxCNC` has them.

use glam::{DVec2, DVec3};

use super::axes::Axes;
use super::block::{Block, Word};
use super::g_words::Motion;
use super::interpret::{GEOMETRY, Interpreter};
use super::type_points::{SplineWord, spline_word};
use super::words::Words;
use crate::contour::{Plane, Shape};

/// The letters of an offset from the start, for x, y and z.
const CENTER: [char; 3] = ['I', 'J', 'K'];

/// How a cubic Bézier curve ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chained {
    /// The point in program coordinates [mm].
    at: DVec3,
    /// From the end on, as far as the last control point is before it [mm].
    ahead: DVec2,
}

impl Interpreter {
    /// A block under G05: a type point, or a curve by what it says of control points.
    pub(super) fn g05(&mut self, block: &Block, words: &mut Words) {
        if !words.has_any("XYZIJKPQ") {
            return;
        }
        if self.rules.is_strict && self.modal.plane != Plane::Xy {
            return self.refuse("G5 is a curve in the plane G17", block.start());
        }
        match spline_word(50, words) {
            SplineWord::Cubic => {
                self.modal.motion = Some(Motion::Cubic);
                self.finish_spline();
                self.cubic(block, words);
            }
            SplineWord::TypePoint if self.rules.is_strict => {
                words.take_all(GEOMETRY);
                self.refuse("G5 needs P and Q", block.start());
            }
            SplineWord::TypePoint => {
                self.modal.motion = Some(Motion::TypePoints);
                if let Some((axes, to)) = self.target(block, words, "") {
                    self.type_point(block, Motion::TypePoints, &axes, to);
                }
            }
            SplineWord::NotSupported(what) => {
                self.modal.motion = Some(Motion::NotSupported(what));
                self.finish_spline();
                self.motion(block, Motion::NotSupported(what), true, words);
            }
            _ => words.take_all(GEOMETRY),
        }
    }

    /// G05 I J P Q.
    fn cubic(&mut self, block: &Block, words: &mut Words) {
        let [first, second] = self.offset_axes();
        let start = [first, second].map(|i| words.take(CENTER[i]));
        let end = ['P', 'Q'].map(|letter| words.take(letter));
        let Some((axes, to)) = self.flat_target(block, words) else { return };
        let from = self.modal.position;
        let ahead = match (start, self.curves.chained) {
            ([None, None], Some(Chained { at, ahead })) if at == from => ahead,
            ([Some(_), Some(_)], _) => self.offset(from, start),
            (given, _) => {
                let message = match given {
                    [None, None] => "the first curve of a series needs I and J",
                    _ => "the curve needs both I and J, or neither",
                };
                self.curve_fault(block, "bezier-without-start", message);
                self.line_instead(block, &axes, to);
                return;
            }
        };
        let behind = self.offset(to, end);
        let plane = self.modal.plane;
        let [start, to_flat] = [from, to].map(|point| plane.split(point).0);
        let controls = vec![start + ahead, to_flat + behind, to_flat];
        self.add_bezier(block, &axes, to, controls);
        self.curves.chained = Some(Chained { at: to, ahead: -behind });
    }

    /// G05.1 I J.
    pub(super) fn quadratic(&mut self, block: &Block, words: &mut Words) {
        let [first, second] = self.offset_axes();
        let offset = [first, second].map(|i| words.take(CENTER[i]));
        let Some((axes, to)) = self.flat_target(block, words) else { return };
        if offset.iter().flatten().all(|word| word.value == 0.0) {
            let message = "the curve (G05.1) needs I or J, not zero";
            self.curve_fault(block, "bezier-without-start", message);
            self.line_instead(block, &axes, to);
            return;
        }
        let from = self.modal.position;
        let plane = self.modal.plane;
        let [start, end] = [from, to].map(|point| plane.split(point).0);
        let control = start + self.offset(from, offset);
        // A parabola as a cubic: its control points are two thirds of the way to the one it has.
        let controls = [start, end].map(|point| point.lerp(control, 2.0 / 3.0));
        self.add_bezier(block, &axes, to, vec![controls[0], controls[1], end]);
    }

    /// The axes of the plane in the order of their letters.
    fn offset_axes(&self) -> [usize; 2] {
        let [first, second, _] = self.modal.plane.axes();
        [first.min(second), first.max(second)]
    }

    /// The way in the plane from a point to where offsets along its axes lead [mm].
    fn offset(&self, at: DVec3, words: [Option<&Word>; 2]) -> DVec2 {
        let mut point = self.modal.frame.unmap(at);
        for (i, word) in self.offset_axes().into_iter().zip(words) {
            point[i] += word.map_or(0.0, |word| word.value * self.modal.unit());
        }
        let plane = self.modal.plane;
        plane.split(self.modal.frame.map(point)).0 - plane.split(at).0
    }

    /// Where the axis words lead to in the plane; a move along its normal is refused.
    pub(super) fn flat_target<'a>(
        &mut self,
        block: &Block,
        words: &mut Words<'a>,
    ) -> Option<(Axes<'a>, DVec3)> {
        let (axes, to) = self.target(block, words, "")?;
        let plane = self.modal.plane;
        let height = plane.split(self.modal.position).1;
        let (end, above) = plane.split(to);
        if let Some(word) = axes.words[plane.axes()[2]]
            && above != height
        {
            self.error(
                "z-in-spline",
                "a spline has one height",
                block.origin_at(word.column),
                &format!(
                    "the {} word has no effect; move along it before or after the spline",
                    word.letter
                ),
            );
        }
        Some((axes, plane.place(end, height)))
    }

    fn curve_fault(&mut self, block: &Block, code: &'static str, message: &str) {
        self.error(code, message, block.start(), "a straight line stands in its place");
    }

    fn line_instead(&mut self, block: &Block, axes: &Axes, to: DVec3) {
        let attributes = self.attributes(block, false, to);
        self.line(axes, to, attributes);
        self.arrive(axes, to);
    }

    fn add_bezier(&mut self, block: &Block, axes: &Axes, to: DVec3, controls: Vec<DVec2>) {
        let attributes = self.attributes(block, false, to);
        let from = attributes.plane.split(self.modal.position).0;
        self.course.curve(from, Shape::Bezier { controls }, attributes, &mut self.report);
        self.arrive(axes, to);
    }
}
