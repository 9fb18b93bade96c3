//! Writing a tool path as a plain program: G0, G1, G2 and G3, and G2.2 and G3.2 where they are known.
//!
//! Coordinates are rounded first and everything else follows from what was written: the centre of
//! an arc is given from its start as written, so that rounding does not add up and no control
//! finds its radii to disagree. Cubics become arcs and lines within a tolerance, over as long a
//! run of them as possible. What a target knows stands in `target`, what becomes of other words in
//! `passed`. Between pieces that do not follow each other the tool rises, crosses and comes down
//! again (`crossing`).

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::block_writer::BlockWriter;
use super::crossing::{Crossing, ends};
use super::explained::Explanations;
use super::passed::{Passing, has_frame, program_number};
use super::target::Target;
use crate::contour::{ARC_TOLERANCE, AuxiliaryWords, Move, MoveCurve, Plane, ToolPath};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Arc, ArcOrLine, Cubic, Decimal, MIN_LENGTH, fit_arcs, sin_cos};

/// How a program is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EmitOptions {
    /// For whom.
    pub target: Target,
    /// Largest distance of arcs and lines, as they are written, from the cubics and involutes they
    /// stand for [mm]; where it is less than three units of the last digit, rounding may add as much.
    pub tolerance: f64,
    /// What cubics become.
    pub splines: SplineOutput,
    /// Feed of moves for which none is programmed [mm/s].
    pub feed: Option<f64>,
    /// Height at which the tool crosses from one piece of the path to the next [mm]. At the height
    /// of the pieces it crosses straight. Without it, it is the highest at which the path itself has
    /// rapid moves; where that is not above the pieces, the program ends before the first crossing,
    /// with an error.
    pub clearance: Option<f64>,
    /// Whether a comment before each move that was not programmed says why it is there.
    pub explain: bool,
}

impl Default for EmitOptions {
    fn default() -> Self {
        Self {
            target: Target::default(),
            tolerance: 0.001,
            splines: SplineOutput::default(),
            feed: None,
            clearance: None,
            explain: false,
        }
    }
}

/// What cubics become.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SplineOutput {
    /// Arcs and lines within the tolerance, whatever the target knows: how finely a controller
    /// cuts up its own splines is not ours to say.
    #[default]
    Arcs,
    /// Cubics (G5) where the target knows them, up to rounding; arcs and lines elsewhere.
    Native,
}

/// A program as written.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Emitted {
    /// The text.
    pub text: String,
    /// What was found on the way.
    pub diagnostics: Vec<Diagnostic>,
}

/// Arcs of less radius are written as lines [units of the last digit]: they have no shape.
const MIN_RADIUS: f64 = 5.0;

/// The same for `LinuxCNC`, which refuses arcs of less than 0.00127 mm.
const LINUXCNC_MIN_RADIUS: f64 = 13.5;

/// Arcs that bulge less than this are lines [units of the last digit]. Among them are all
/// whose sweep a control in single precision could take for zero, and so for a full circle.
const MIN_SAGITTA: f64 = 0.5;

/// What rounding may move a point of an arc by [units of the last digit]: its ends by 0.7, its
/// middle by as much again through the centre.
const ROUNDING: f64 = 1.5;

/// Most steps to a centre that stays as it is when it is read and written again; two suffice but
/// for one in thousands.
const ROUNDS: u32 = 8;

/// Arcs beyond three quarters of a circle whose ends are nearer than this are written as two
/// [mm]: rounding, or a control in single precision, could take them for a full circle or nothing.
const NEARLY_FULL: f64 = 0.01;

/// Writes a tool path as a program.
#[must_use]
pub fn emit(path: &ToolPath, options: &EmitOptions) -> Emitted {
    let facts = options.target.facts();
    // Words before the first move may carry the number of the program.
    let mut head = path.words.iter().take_while(|words| words.before == 0);
    let number = head.find_map(|words| program_number(&words.words));
    let out = BlockWriter::new(facts, number.unwrap_or(1));
    let unit = 1.0 / out.scale;
    let mut emitter = Emitter {
        out,
        unit,
        tolerance: (options.tolerance - ROUNDING * unit)
            .max(0.5 * options.tolerance)
            .max(0.1 * unit),
        options: *options,
        crossing: Crossing::new(options.clearance, path),
        at: DVec3::ZERO,
        passing: Passing::default(),
        diagnostics: Vec::new(),
    };
    if !facts.frame.is_empty() && !path.words.iter().any(|words| has_frame(&words.words)) {
        emitter.frame(facts.frame);
    }
    let mut explanations = Explanations::new(&path.transitions);
    let mut words = path.words.iter().peekable();
    let mut i = 0;
    while i <= path.moves.len() {
        while let Some(passed) = words.next_if(|words| words.before <= i || i == path.moves.len()) {
            i += emitter.pass(passed);
            if emitter.passing.is_cut_off {
                i = path.moves.len();
            }
        }
        let Some(first) = path.moves.get(i) else { break };
        let until = words.peek().map_or(path.moves.len(), |words| words.before);
        let run = cubic_run(path.moves.get(i..until).unwrap_or_default());
        if i == 0 {
            emitter.begin(first);
        } else if !emitter.cross(first) {
            i = path.moves.len();
            continue;
        }
        if options.explain
            && let Some(why) = explanations.why(first)
        {
            emitter.out.comment(&why);
        }
        if run.len() > 1 {
            emitter.cubics(&run, first);
            i += run.len();
        } else {
            emitter.one(first);
            i += 1;
        }
        if let Some(last) = path.moves.get(i - 1) {
            emitter.crossing.passed(last);
            emitter.at = ends(last)[1];
        }
    }
    let mut diagnostics = emitter.diagnostics;
    diagnostics.append(&mut emitter.passing.diagnostics);
    Emitted { text: emitter.out.finish(), diagnostics }
}

/// The cubics at the beginning of `moves` that can be written as one curve.
fn cubic_run(moves: &[Move]) -> Vec<Cubic> {
    let mut run: Vec<Cubic> = Vec::new();
    let Some(first) = moves.first() else { return run };
    for next in moves {
        let alike = next.role == first.role
            && next.rapid == first.rapid
            && next.feed == first.feed
            && next.plane == first.plane
            && next.heights == [first.heights[0]; 2];
        match next.curve {
            MoveCurve::Cubic(cubic)
                if alike
                    && run
                        .last()
                        .is_none_or(|last| last.end().distance(cubic.start()) <= MIN_LENGTH) =>
            {
                run.push(cubic);
            }
            _ => break,
        }
    }
    run
}

pub(super) struct Emitter {
    pub(super) out: BlockWriter,
    options: EmitOptions,
    /// The last digit [mm].
    pub(super) unit: f64,
    /// Of arcs and lines before they are rounded [mm].
    pub(super) tolerance: f64,
    crossing: Crossing,
    /// Where the tool is [mm], not rounded.
    at: DVec3,
    passing: Passing,
    diagnostics: Vec<Diagnostic>,
}

impl Emitter {
    /// Passes words on; tells how many of the next moves they make themselves.
    fn pass(&mut self, words: &AuxiliaryWords) -> usize {
        let mut text = words.words.as_str();
        if (self.out.facts.tape || self.out.facts.klartext) && program_number(text).is_some() {
            // It stands at the head of the program.
            text = text.split_once(')').map_or("", |(_, rest)| rest);
        }
        let written = self.passing.pass(&mut self.out, text, words.origin);
        let Some(reset) = words.reset else { return 0 };
        self.at = reset.at;
        self.out.reset(reset, written);
        reset.moves
    }

    /// The coordinate system of a program that names none.
    fn frame(&mut self, frame: &str) {
        self.out.words(frame);
        if frame.starts_with("G92") {
            self.out.at_zero();
        }
        let message = format!("{frame} stands at the head: the program names no coordinate system");
        let hint = "set it to the program's zero, or where G92 does, begin with the tool there";
        self.diagnostics.push(Diagnostic::info("frame-added", message).with_hint(hint));
    }

    /// Goes to where the path starts. A program says itself how the tool comes to its first move; a
    /// plain contour does not.
    fn begin(&mut self, first: &Move) {
        let start = ends(first)[0];
        if matches!(first.origin, Origin::Segment(_)) || self.is_away(start) {
            self.go(first, self.crossing.given(start.z).unwrap_or(start.z));
        }
    }

    /// Crosses to where `next` starts, if the tool is not there; tells whether it is now.
    fn cross(&mut self, next: &Move) -> bool {
        let start = ends(next)[0];
        if !self.is_away(start) {
            return true;
        }
        let Some(height) = self.crossing.height(self.at.z, start.z) else {
            let (from_x, from_y) = (Decimal::of(self.at.x), Decimal::of(self.at.y));
            let (x, y) = (Decimal::of(start.x), Decimal::of(start.y));
            let message = format!(
                "the path goes on elsewhere, from X{from_x} Y{from_y} to X{x} Y{y}, and no height is known at which the tool can cross"
            );
            self.diagnostics.push(
                Diagnostic::error("no-clearance", message)
                    .with_origin(next.origin)
                    .with_point(next.curve.start())
                    .with_hint("give a clearance height, or a rapid move above the part"),
            );
            return false;
        };
        self.go(next, height);
        true
    }

    /// Goes to the start of `next`: up to a height where the tool is, across, and down.
    fn go(&mut self, next: &Move, height: f64) {
        let [up, across, down] = self.crossing.way(self.at, next, height.max(self.at.z));
        self.upright(&up);
        self.out.forget_place();
        let to = self.out.place(ends(&across)[1]);
        self.out.rapid(to, Plane::Xy);
        self.upright(&down);
    }

    /// Goes up or down, if at all.
    fn upright(&mut self, step: &Move) {
        let [x, y, _] = self.out.at;
        let [from, z] = step.heights.map(|height| self.out.units(height));
        if from == z {
            return;
        }
        if step.rapid {
            return self.out.rapid([x, y, z], Plane::Xy);
        }
        self.set_feed(step);
        self.out.line([x, y, z], Plane::Xy);
    }

    fn is_away(&self, place: DVec3) -> bool {
        place.distance(self.at) > self.unit
    }

    fn one(&mut self, next: &Move) {
        let flat = !matches!(next.curve, MoveCurve::Line(_) | MoveCurve::Vertical(_));
        let known = next.plane == Plane::Xy || self.out.facts.planes;
        if !next.rapid {
            self.set_feed(next);
            if flat && known {
                match next.curve {
                    MoveCurve::Arc(arc) => self.arc(&arc, next.plane, next.heights),
                    MoveCurve::Cubic(cubic) => self.cubics(&[cubic], next),
                    MoveCurve::Involute(involute) => self.involute(&involute, next),
                    MoveCurve::Line(_) | MoveCurve::Vertical(_) => {}
                }
                return;
            }
        }
        if flat {
            self.chords(next);
        }
        self.straight(next, next.curve.end(), next.heights[1]);
    }

    /// The curve of a move as straight lines, up to before its end.
    fn chords(&mut self, next: &Move) {
        let [z0, z1] = next.heights;
        // Each with the length of the chords up to it.
        let mut points = Vec::new();
        let (mut from, mut total) = (next.curve.start(), 0.0);
        next.curve.flatten(self.tolerance, &mut |point| {
            total += from.distance(point);
            from = point;
            points.push((point, total));
        });
        points.pop();
        for (point, run) in points {
            self.straight(next, point, z0 + (z1 - z0) * (run / total));
        }
    }

    fn straight(&mut self, like: &Move, to: DVec2, height: f64) {
        let to = self.out.place(like.plane.place(to, height));
        if like.rapid {
            self.out.rapid(to, like.plane);
        } else {
            self.out.line(to, like.plane);
        }
    }

    /// Cubics of one height, or one cubic that climbs.
    pub(super) fn cubics(&mut self, cubics: &[Cubic], like: &Move) {
        if like.rapid || like.plane != Plane::Xy && !self.out.facts.planes {
            for cubic in cubics {
                let curve = MoveCurve::Cubic(*cubic);
                if !like.rapid {
                    self.set_feed(like);
                }
                self.chords(&Move { curve, ..*like });
                self.straight(like, cubic.end(), like.heights[1]);
            }
            return;
        }
        self.set_feed(like);
        let [z0, z1] = like.heights;
        let native = self.options.splines == SplineOutput::Native && self.out.facts.splines;
        if native && like.plane == Plane::Xy && z0 == z1 {
            for cubic in cubics {
                self.native(cubic, z0);
            }
            return;
        }
        let pieces = fit_arcs(cubics, self.tolerance);
        let total: f64 = pieces.iter().map(ArcOrLine::length).sum();
        let mut run = 0.0;
        let mut z = z0;
        for piece in &pieces {
            run += piece.length();
            let to = z0 + (z1 - z0) * (run / total);
            match piece {
                ArcOrLine::Arc(arc) => self.arc(arc, like.plane, [z, to]),
                ArcOrLine::Line(line) => self.straight(like, line.end(), to),
            }
            z = to;
        }
        // A cubic that comes to a point, and whatever rounding left over.
        if let Some(last) = cubics.last() {
            self.straight(like, last.end(), z1);
        }
    }

    /// A cubic as one block, its inner control points from its ends as written.
    fn native(&mut self, cubic: &Cubic, z: f64) {
        let written = |k: usize| {
            let point = cubic.points[k];
            [self.out.units(point.x), self.out.units(point.y)]
        };
        let (first, second, end) = (written(1), written(2), written(3));
        let start = self.out.at;
        let controls =
            [[first[0] - start[0], first[1] - start[1]], [second[0] - end[0], second[1] - end[1]]];
        let to = [end[0], end[1], self.out.units(z)];
        self.out.cubic(to, controls);
    }

    /// An arc as one block, as two, or as a line where it has no shape at this resolution.
    fn arc(&mut self, arc: &Arc, plane: Plane, [z0, z1]: [f64; 2]) {
        let to = self.out.place(plane.place(arc.end(), z1));
        let (radius, sweep) = (arc.radius(), arc.sweep());
        let sagitta = radius * (1.0 - sin_cos(0.5 * sweep).1);
        let is_linuxcnc = self.options.target == Target::LinuxCnc;
        let least = if is_linuxcnc { LINUXCNC_MIN_RADIUS } else { MIN_RADIUS };
        if radius < least * self.unit || (sweep.abs() < 1.0 && sagitta < MIN_SAGITTA * self.unit) {
            self.out.line(to, plane);
            return;
        }
        let start = self.in_plane(plane, self.out.at);
        let units = |point: DVec2| [self.out.units(point.x), self.out.units(point.y)];
        if arc.is_full_circle() {
            let offset = units(arc.center() - start);
            let [first, second, _] = plane.axes();
            let mut to = to;
            to[first] = self.out.at[first];
            to[second] = self.out.at[second];
            self.out.arc(arc.is_clockwise(), plane, to, offset);
            return;
        }
        let (to, offset) = self.stable(arc, plane, to);
        let (end, center) = (self.in_plane(plane, to), start + self.way(offset));
        let written = Arc::from_center(start, end, center, arc.is_clockwise(), f64::INFINITY);
        // Rounding moves the ends by parts of a radian at most; more is a turn gained or lost.
        let keeps_its_sweep = written.is_ok_and(|w| (w.sweep() - sweep).abs() < 1.0);
        let nearly_full = sweep.abs() > 4.7 && start.distance(end) < NEARLY_FULL;
        if keeps_its_sweep && !nearly_full {
            self.out.arc(arc.is_clockwise(), plane, to, offset);
        } else if let (true, Ok((first, second))) = (sweep.abs() > 1.0, arc.split(0.5)) {
            let middle = 0.5 * (z0 + z1);
            self.arc(&first, plane, [z0, middle]);
            self.arc(&second, plane, [middle, z1]);
        } else {
            self.out.line(to, plane);
        }
    }

    /// The end of an arc, rounded to `to`, and the way to its centre that stay as they are when they
    /// are read and written again: equally far from both ends as written, which rounded is not quite
    /// so any more, and beyond half a circle whatever reading makes of it.
    fn stable(&self, arc: &Arc, plane: Plane, mut to: [i64; 3]) -> ([i64; 3], [i64; 2]) {
        let start = self.in_plane(plane, self.out.at);
        let units = |point: DVec2| [self.out.units(point.x), self.out.units(point.y)];
        // Short arcs are always moved, those of a control that winds in or out above all.
        let tolerance = if arc.sweep().abs() > PI { ARC_TOLERANCE } else { f64::INFINITY };
        let mut way = arc.center() - start;
        let mut offset = units(way);
        for round in 0..ROUNDS {
            let end = self.in_plane(plane, to);
            let read = Arc::from_center(start, end, start + way, arc.is_clockwise(), tolerance);
            let Ok(read) = read else { break };
            let before = (to, std::mem::replace(&mut offset, units(read.center() - start)));
            let [x, y] = units(read.end() - end);
            // Ends that are farther off are so in the program.
            if x.abs().max(y.abs()) <= 2 {
                let [first, second, _] = plane.axes();
                to[first] += x;
                to[second] += y;
            }
            if round > 0 && (to, offset) == before {
                break;
            }
            way = self.way(offset);
        }
        (to, offset)
    }

    /// A way as written, in a plane [mm].
    pub(super) fn way(&self, [x, y]: [i64; 2]) -> DVec2 {
        DVec2::new(x as f64, y as f64) / self.out.scale
    }

    /// A point as written, in a plane [mm].
    pub(super) fn in_plane(&self, plane: Plane, place: [i64; 3]) -> DVec2 {
        let [first, second, _] = plane.axes();
        self.way([place[first], place[second]])
    }

    fn set_feed(&mut self, next: &Move) {
        if let Some(feed) = next.feed.or(self.options.feed) {
            self.out.set_feed(feed);
        } else if !self.out.has_feed() {
            self.report_once(
                Diagnostic::warning("no-feed", "no feed is programmed for this move")
                    .with_origin(next.origin)
                    .with_point(next.curve.start())
                    .with_hint("add an F word, or choose a feed"),
            );
        }
    }

    fn report_once(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.iter().all(|found| found.code != diagnostic.code) {
            self.diagnostics.push(diagnostic);
        }
    }
}
