//! Writing a tool path as a plain program: G0, G1, G2 and G3.
//!
//! Coordinates are rounded first and everything else follows from what was written: the centre of
//! an arc is given from its start as written, so that rounding does not add up and no control
//! finds its radii to disagree. Cubics become arcs and lines within a tolerance, over as long a
//! run of them as possible. G41, G42, D and H words have done their work and do not appear. Between
//! pieces that do not follow each other the tool rises, crosses and comes down again (`crossing`).

use std::f64::consts::PI;

use glam::DVec2;

use super::block_writer::{BlockWriter, SCALE, units};
use super::crossing::Crossing;
use super::target::Target;
use crate::contour::{Move, MoveCurve, ToolPath};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Arc, ArcOrLine, Cubic, Decimal, MIN_LENGTH, fit_arcs, sin_cos};

/// How a program is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EmitOptions {
    /// For whom.
    pub target: Target,
    /// Largest distance of arcs and lines from the cubics they stand for [mm].
    pub tolerance: f64,
    /// Feed of moves for which none is programmed [mm/s].
    pub feed: Option<f64>,
    /// Height at which the tool crosses from one piece of the path to the next [mm]. At the height
    /// of the pieces it crosses straight. Without it, it is the highest at which the path itself has
    /// rapid moves; where that is not above the pieces, the program ends before the first crossing,
    /// with an error.
    pub clearance: Option<f64>,
}

impl Default for EmitOptions {
    fn default() -> Self {
        Self { target: Target::default(), tolerance: 0.001, feed: None, clearance: None }
    }
}

/// A program as written.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Emitted {
    /// The text.
    pub text: String,
    /// What was found on the way.
    pub diagnostics: Vec<Diagnostic>,
}

/// Finest tolerance for cubics [mm]: a tenth of the last digit written.
const MIN_TOLERANCE: f64 = 1e-5;

/// Arcs of less radius are written as lines [mm]: five units of the last digit have no shape.
const MIN_RADIUS: f64 = 5e-4;

/// Arcs that bulge less than half a unit of the last digit are lines [mm]. Among them are all
/// whose sweep a control in single precision could take for zero, and so for a full circle.
const MIN_SAGITTA: f64 = 5e-5;

/// Arcs beyond three quarters of a circle whose ends are nearer than this are written as two
/// [mm]: rounding, or a control in single precision, could take them for a full circle or nothing.
const NEARLY_FULL: f64 = 0.01;

/// Writes a tool path as a program.
#[must_use]
pub fn emit(path: &ToolPath, options: &EmitOptions) -> Emitted {
    let mut emitter = Emitter {
        out: BlockWriter::new("G21 G90 G17 G94"),
        tolerance: options.tolerance.max(MIN_TOLERANCE),
        feed: options.feed,
        crossing: Crossing::new(options.clearance, &path.moves),
        at: [0.0; 3],
        diagnostics: Vec::new(),
    };
    let mut words = path.words.iter().peekable();
    let mut i = 0;
    while i <= path.moves.len() {
        while let Some(passed) = words.next_if(|words| words.before <= i || i == path.moves.len()) {
            emitter.out.words(&passed.words);
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
        if run.len() > 1 {
            emitter.cubics(&run, first, first.heights);
            i += run.len();
        } else {
            emitter.one(first);
            i += 1;
        }
        if let Some(last) = path.moves.get(i - 1) {
            emitter.crossing.passed(last);
            emitter.at = last.curve.end().extend(last.heights[1]).to_array();
        }
    }
    Emitted { text: emitter.out.finish(), diagnostics: emitter.diagnostics }
}

/// The cubics at the beginning of `moves` that can be written as one curve.
fn cubic_run(moves: &[Move]) -> Vec<Cubic> {
    let mut run: Vec<Cubic> = Vec::new();
    let Some(first) = moves.first() else { return run };
    for next in moves {
        let alike = next.role == first.role
            && next.rapid == first.rapid
            && next.feed == first.feed
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

struct Emitter {
    out: BlockWriter,
    tolerance: f64,
    feed: Option<f64>,
    crossing: Crossing,
    /// Where the tool is [mm], not rounded.
    at: [f64; 3],
    diagnostics: Vec<Diagnostic>,
}

impl Emitter {
    /// Goes to where the path starts. A program says itself how the tool comes to its first move; a
    /// plain contour does not.
    fn begin(&mut self, first: &Move) {
        if matches!(first.origin, Origin::Segment(_)) || self.is_away(first) {
            let start = first.heights[0];
            self.go(first, self.crossing.given(start).unwrap_or(start));
        }
    }

    /// Crosses to where `next` starts, if the tool is not there; tells whether it is now.
    fn cross(&mut self, next: &Move) -> bool {
        if !self.is_away(next) {
            return true;
        }
        let [from_x, from_y, from_z] = self.at;
        let (start, z) = (next.curve.start(), next.heights[0]);
        let Some(height) = self.crossing.height(from_z, z) else {
            let [from_x, from_y, x, y] = [from_x, from_y, start.x, start.y].map(Decimal::of);
            let message = format!(
                "the path goes on elsewhere, from X{from_x} Y{from_y} to X{x} Y{y}, and no height is known at which the tool can cross"
            );
            self.diagnostics.push(
                Diagnostic::error("no-clearance", message)
                    .with_origin(next.origin)
                    .with_point(start)
                    .with_hint("give a clearance height, or let the program make a rapid move above the part; until then the written program ends before this"),
            );
            return false;
        };
        self.go(next, height);
        true
    }

    /// Goes to the start of `next`: up to a height where the tool is, across, and down.
    fn go(&mut self, next: &Move, height: f64) {
        let (start, z) = (units(next.curve.start()), units_of(next.heights[0]));
        let below = units_of(self.at[2]);
        let height = units_of(height).max(below);
        if height > below {
            self.out.rapid(self.out.position(), height);
        }
        self.out.state_position();
        self.out.rapid(start, height);
        if next.rapid {
            self.out.rapid(start, z);
        } else if height > z {
            self.set_feed(&Move { feed: self.crossing.plunge(next), ..*next });
            self.out.line(start, z);
        }
    }

    fn is_away(&self, next: &Move) -> bool {
        next.curve.start().extend(next.heights[0]).distance(self.at.into()) > 1.0 / SCALE
    }

    fn one(&mut self, next: &Move) {
        let [z0, z1] = next.heights;
        let (end, z) = (units(next.curve.end()), units_of(z1));
        if next.rapid {
            let total = next.curve.length();
            let mut points = Vec::new();
            if !matches!(next.curve, MoveCurve::Line(_) | MoveCurve::Vertical(_)) {
                next.curve.flatten(self.tolerance, &mut |point| points.push(point));
                points.pop();
            }
            let mut from = next.curve.start();
            let mut run = 0.0;
            for point in points {
                run += from.distance(point);
                from = point;
                self.out.rapid(units(point), units_of(z0 + (z1 - z0) * (run / total).min(1.0)));
            }
            self.out.rapid(end, z);
            return;
        }
        match next.curve {
            MoveCurve::Line(_) | MoveCurve::Vertical(_) => {
                self.set_feed(next);
                self.out.line(end, z);
            }
            MoveCurve::Arc(arc) => {
                self.set_feed(next);
                self.arc(&arc, next.heights);
            }
            MoveCurve::Cubic(cubic) => self.cubics(&[cubic], next, next.heights),
        }
    }

    /// Cubics of one height, or one cubic that climbs.
    fn cubics(&mut self, cubics: &[Cubic], like: &Move, [z0, z1]: [f64; 2]) {
        if like.rapid {
            for cubic in cubics {
                self.one(&Move { curve: MoveCurve::Cubic(*cubic), ..*like });
            }
            return;
        }
        self.set_feed(like);
        let pieces = fit_arcs(cubics, self.tolerance);
        let length = |piece: &ArcOrLine| match piece {
            ArcOrLine::Arc(arc) => arc.length(),
            ArcOrLine::Line(line) => line.length(),
        };
        let total: f64 = pieces.iter().map(length).sum();
        let mut run = 0.0;
        let mut z = z0;
        for piece in &pieces {
            run += length(piece);
            let to = z0 + (z1 - z0) * (run / total);
            match piece {
                ArcOrLine::Arc(arc) => self.arc(arc, [z, to]),
                ArcOrLine::Line(line) => self.out.line(units(line.end()), units_of(to)),
            }
            z = to;
        }
        // A cubic that comes to a point, and whatever rounding left over.
        if let Some(last) = cubics.last() {
            self.out.line(units(last.end()), units_of(z1));
        }
    }

    /// An arc as one block, as two, or as a line where it has no shape at this resolution.
    fn arc(&mut self, arc: &Arc, [z0, z1]: [f64; 2]) {
        let (end, z) = (units(arc.end()), units_of(z1));
        let (radius, sweep) = (arc.radius(), arc.sweep());
        let sagitta = radius * (1.0 - sin_cos(0.5 * sweep).1);
        if radius < MIN_RADIUS || (sweep.abs() < 1.0 && sagitta < MIN_SAGITTA) {
            self.out.line(end, z);
            return;
        }
        let start = self.out.position();
        if arc.is_full_circle() {
            self.out.arc(arc.is_clockwise(), start, z, units(arc.center() - in_mm(start)));
            return;
        }
        let mut center = arc.center();
        if sweep.abs() < PI && start != end {
            // Equally far from both ends as written. Beyond half a circle their rounding would be
            // magnified.
            let chord = in_mm(end) - in_mm(start);
            let middle = in_mm(start).midpoint(in_mm(end));
            center -= chord * ((center - middle).dot(chord) / chord.length_squared());
        }
        let offset = units(center - in_mm(start));
        let center = in_mm(start) + in_mm(offset);
        let written =
            Arc::from_center(in_mm(start), in_mm(end), center, arc.is_clockwise(), f64::INFINITY);
        // Rounding moves the ends by parts of a radian at most; more is a turn gained or lost.
        let keeps_its_sweep = written.is_ok_and(|w| (w.sweep() - sweep).abs() < 1.0);
        let nearly_full = sweep.abs() > 4.7 && in_mm(start).distance(in_mm(end)) < NEARLY_FULL;
        if keeps_its_sweep && !nearly_full {
            self.out.arc(arc.is_clockwise(), end, z, offset);
        } else if let (true, Ok((first, second))) = (sweep.abs() > 1.0, arc.split(0.5)) {
            let middle = 0.5 * (z0 + z1);
            self.arc(&first, [z0, middle]);
            self.arc(&second, [middle, z1]);
        } else {
            self.out.line(end, z);
        }
    }

    fn set_feed(&mut self, next: &Move) {
        if let Some(feed) = next.feed.or(self.feed) {
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

/// A point as written [mm].
fn in_mm([x, y]: [i64; 2]) -> DVec2 {
    DVec2::new(x as f64 / SCALE, y as f64 / SCALE)
}

fn units_of(value: f64) -> i64 {
    units(DVec2::new(value, 0.0))[0]
}
