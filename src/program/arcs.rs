//! G02 and G03, and where involutes join them: arcs by centre, radius or angle (AR), in each plane, of several turns
//! and helical; SINUMERIK's CT and CIP.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::block::{Block, Word};
use super::frame::radians;
use super::interpret::Interpreter;
use super::number::whole;
use super::open::arc_tolerance;
use super::words::Words;
use crate::contour::{Attributes, Shape};
use crate::diagnostic::Origin;
use crate::geometry::{Curve, CurveError, RadiusForm, perp, rotate, sin_cos, turn};

/// Most turns of one arc.
const MOST_TURNS: u32 = 10_000;

/// Angles between chord and tangent below which an arc is straight [rad].
const STRAIGHT: f64 = 1e-9;

/// The letters of a centre, for x, y and z.
pub(super) const CENTER: [char; 3] = ['I', 'J', 'K'];

impl Interpreter {
    /// G02, G03 and, where it is an `involute`, G02.2 and G03.2.
    pub(super) fn arc(
        &mut self,
        block: &Block,
        words: &mut Words,
        clockwise: bool,
        involute: bool,
    ) {
        let plane = self.modal.plane;
        let about_pole = words.has_any("jq") && !words.has_any("IJKR");
        let Some((axes, mut to)) = self.target(block, words, "IJKR") else { return };
        let clockwise = clockwise != self.modal.frame.flips(plane);
        let by_angle =
            words.take('a').and_then(|word| self.arc_by_angle(word, words, &mut to, clockwise));
        let attributes = self.attributes(block, false, to);
        let (turns, shape) = if by_angle.is_some() {
            (self.turns(block, words), by_angle)
        } else if about_pole {
            let pole = self.modal.frame.map(plane.place(self.modal.polar.pole, 0.0));
            let (to, center) = (plane.split(to).0, plane.split(pole).0);
            let shape = self.even_factor(block).map(|_| Shape::Arc { to, center, clockwise });
            (self.turns(block, words), shape)
        } else if involute {
            (1, self.involute_shape(block, words, &axes, to, clockwise))
        } else {
            (self.turns(block, words), self.arc_shape(block, words, to, clockwise))
        };
        match shape {
            Some(shape) => self.turning(shape, turns, attributes),
            None => self.line(&axes, to, attributes),
        }
        self.arrive(&axes, to);
    }

    /// CT, and CIP where it is `by_point`.
    pub(super) fn arc_by_point(&mut self, block: &Block, words: &mut Words, by_point: bool) {
        let plane = self.modal.plane;
        let mut via = self.modal.frame.unmap(self.modal.position);
        for (i, letter) in ['x', 'y', 'z'].into_iter().enumerate() {
            if let Some(word) = words.take(letter) {
                let value = self.modal.length_of(i, word.value);
                via[i] = if self.modal.relative { via[i] + value } else { value };
            }
        }
        let via = plane.split(self.modal.frame.map(via)).0;
        let from = plane.split(self.modal.position).0;
        let Some((axes, to)) = self.target(block, words, "") else { return };
        let attributes = self.attributes(block, false, to);
        let end = plane.split(to).0;
        // An angle that the arc spans is twice that between chord and tangent, or seen from a point on
        // it: the centre is beside the middle of the chord by half of it over the tangent of that.
        let (chord, seen) = (end - from, [via - from, end - via]);
        let angle = match self.course.heading {
            _ if by_point => turn(seen[0], seen[1]),
            Some(heading) => turn(heading, chord),
            None => 0.0,
        };
        let straight = angle.abs() < STRAIGHT || self.even_factor(block).is_none();
        if straight {
            self.line(&axes, to, attributes);
        } else {
            let shape = arc_over(from, end, 2.0 * angle);
            let turns = self.turns(block, words);
            self.turning(shape, turns, attributes);
        }
        self.arrive(&axes, to);
    }

    /// The arc of an angle (AR), between its ends or about its centre, where it moves `to`.
    fn arc_by_angle(
        &mut self,
        word: &Word,
        words: &mut Words,
        to: &mut DVec3,
        clockwise: bool,
    ) -> Option<Shape> {
        let plane = self.modal.plane;
        let [first, second, _] = plane.axes();
        let angle = radians(if clockwise { -word.value } else { word.value });
        let from = plane.split(self.modal.position).0;
        let (end, height) = plane.split(*to);
        let centers = [first, second].map(|i| words.take(CENTER[i]));
        if centers == [None; 2] {
            return (end != from).then(|| arc_over(from, end, angle));
        }
        let center = self.center(centers, self.modal.absolute_center);
        let end = center + rotate(from - center, angle);
        *to = plane.place(end, height);
        Some(Shape::Arc { to: end, center, clockwise })
    }

    /// The P word: how many turns, full or not; TURN, how many more.
    fn turns(&mut self, block: &Block, words: &mut Words) -> u32 {
        let (word, more) = match words.take('t') {
            Some(word) => (word, 1.0),
            None => match words.take('P') {
                Some(word) => (word, 0.0),
                None => return 1,
            },
        };
        if let Some(turns @ 1..=MOST_TURNS) = whole(word.value + more) {
            return if turns == 1 || self.may_expand(block, turns) { turns } else { 1 };
        }
        let at = block.origin_at(word.column);
        let hint = "P is a whole number from 1; the arc makes less than one turn";
        self.error("bad-turns", "no such number of turns of an arc", at, hint);
        1
    }

    /// The arc after as many full circles as there are turns besides its own.
    fn turning(&mut self, shape: Shape, turns: u32, attributes: Attributes) {
        let from = attributes.plane.split(self.modal.position).0;
        let arc = if turns > 1 {
            shape.curve(from, self.rules.any_lead.then(|| arc_tolerance(self.course.unit)))
        } else {
            Err(CurveError::ZeroLength)
        };
        let Ok(Curve::Arc(arc)) = arc else {
            self.course.curve(from, shape, attributes, &mut self.report);
            return;
        };
        self.course.leave_corner(&mut self.report);
        self.course.leave_asked(&mut self.report);
        let [start, end] = attributes.heights;
        let total = TAU * f64::from(turns - 1) + arc.sweep().abs();
        let circle = Shape::Arc { to: from, center: arc.center(), clockwise: arc.is_clockwise() };
        for turn in 0..turns {
            let run = |turn: u32| (TAU * f64::from(turn) / total).min(1.0);
            let run = [run(turn), run(turn + 1)];
            let [before, after] = run.map(|run| start + (end - start) * run);
            let time = attributes.time.map(|time| time * (run[1] - run[0]));
            let last = turn + 1 == turns;
            let heights = [before, if last { end } else { after }];
            let shape = if last { &shape } else { &circle };
            let mut attributes = Attributes { time, heights, ..attributes };
            if let Origin::Block { column, .. } = &mut attributes.origin
                && !last
                && self.course.switched().is_some()
            {
                // In a contour: that it goes on, and is no block of its own as in a loop.
                *column = Some(1);
            }
            self.course.curve(from, shape.clone(), attributes, &mut self.report);
        }
    }

    /// The arc as described, `None` where a straight move has to stand in its place.
    fn arc_shape(
        &mut self,
        block: &Block,
        words: &mut Words,
        to: DVec3,
        clockwise: bool,
    ) -> Option<Shape> {
        let plane = self.modal.plane;
        let [first, second, normal] = plane.axes();
        let centers = CENTER.map(|letter| words.take(letter));
        let radius = words.take('R');
        let (a, b) = (centers[first], centers[second]);
        // Some programs state all three for every arc, the needless one as 0.
        if let Some(word) = centers[normal]
            && (word.value != 0.0 || self.rules.is_strict)
        {
            self.error(
                "contradictory-words",
                format!("{} belongs to another plane", word.letter),
                block.origin_at(word.column),
                "the centre is I J in G17, I K in G18, J K in G19",
            );
        }
        let to = plane.split(to).0;
        let factor = self.even_factor(block)?;
        if let Some(radius) = radius {
            if let Some(center) = a.or(b) {
                self.error(
                    "contradictory-words",
                    "the arc has a radius and a centre",
                    block.origin_at(center.column),
                    "the radius counts; leave out R, or the centre",
                );
            }
            let form = if radius.value < 0.0 { RadiusForm::Major } else { RadiusForm::Minor };
            let radius = radius.value.abs() * self.modal.unit() * factor;
            return Some(Shape::ArcByRadius { to, radius, form, clockwise });
        }
        let [letter_a, letter_b] = [CENTER[first], CENTER[second]];
        if a.is_none() && b.is_none() {
            self.error(
                "arc-without-centre",
                "the arc has neither centre nor radius",
                block.start(),
                "add I and J, or R; a straight line stands in its place",
            );
            return None;
        }
        if self.modal.absolute_center && (a.is_none() || b.is_none()) {
            self.error(
                "arc-without-centre",
                format!("an absolute centre (G90.1) needs both {letter_a} and {letter_b}"),
                block.start(),
                "the missing one is taken from the arc's start",
            );
        }
        let center = self.center([a, b], self.modal.absolute_center);
        Some(Shape::Arc { to, center, clockwise })
    }

    /// The centre that the words for the axes of the plane state, from the start or `absolute` [mm].
    pub(super) fn center(&self, words: [Option<&Word>; 2], absolute: bool) -> DVec2 {
        let plane = self.modal.plane;
        let mut center = self.modal.frame.unmap(self.modal.position);
        for (i, word) in plane.axes().into_iter().zip(words) {
            if let Some(word) = word {
                let way = word.value * self.modal.unit();
                center[i] = if absolute { way } else { center[i] + way };
            }
        }
        plane.split(self.modal.frame.map(center)).0
    }

    /// By how much the coordinate system makes the lengths of its plane longer; told, where not all of
    /// them alike.
    pub(super) fn even_factor(&mut self, block: &Block) -> Option<f64> {
        let factor = self.modal.frame.factor(self.modal.plane);
        if factor.is_none() {
            self.error(
                "arc-distorted",
                "scaling or rotation makes the curve another one",
                block.start(),
                "scale both axes alike; a straight line stands in its place",
            );
        }
        factor
    }
}

/// The arc between two points over an angle [rad], to the left where that is positive.
fn arc_over(from: DVec2, to: DVec2, angle: f64) -> Shape {
    let (sin, cos) = sin_cos(0.5 * angle);
    let center = 0.5 * (from + to) + perp(to - from) * (0.5 * cos / sin);
    Shape::Arc { to, center, clockwise: angle < 0.0 }
}
