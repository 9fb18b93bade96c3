//! Programs with the moves that the interpreter of `LinuxCNC` 2.9 printed for them, and whether ours are the
//! same.
//!
//! A program follows the word `program` and the tools of its table, each with its diameter [mm] and
//! orientation; behind `gives` stand the moves among the canonical calls, with four decimals in the unit of
//! the program: `0 x y z` of `STRAIGHT_TRAVERSE`, `1 x y z` of `STRAIGHT_FEED`, `2` and `3` `x y z` of
//! `ARC_FEED` with the centre in the axes of its plane and P for several turns, F where the feed per minute is
//! another one. Calls that move nothing are left out. `stops` names the line at which the interpreter
//! refused to go on. `scripts/linuxcnc.mjs` tells how they are made.
use std::f64::consts::TAU;

use g41::contour::{Move, MoveCurve, ToolPath};
use g41::diagnostic::{Origin, Severity};
use g41::program::{Dialect, Program, interpret};
use g41::simulation::{ListedTool, Profile, ToolSize, Tools, compensate_program};
use glam::{DVec2, DVec3};

use super::run::end;

/// How near places have to be [mm], besides the rounding of what was printed.
const NEAR: f64 = 1e-4;

/// Half a unit of the last digit that was printed.
const ROUNDED: f64 = 0.5e-4;

/// A move as printed, in the unit of its program.
#[derive(Debug)]
struct Printed {
    kind: u8,
    to: DVec3,
    center: DVec2,
    turns: f64,
    feed: f64,
}

impl Printed {
    /// Whether an arc turns about its own end, in whichever plane it lies.
    fn is_point(&self, least: f64) -> bool {
        let DVec3 { x, y, z } = self.to;
        [DVec2::new(x, y), DVec2::new(z, x)].iter().any(|end| end.distance(self.center) < least)
    }
}

/// A program and what was printed for it.
#[derive(Debug, Default)]
struct Case {
    text: String,
    tools: Tools,
    moves: Vec<Printed>,
    stops: Option<u32>,
}

/// How many programs, refusals and moves were compared, and what differs.
#[derive(Debug, Default)]
pub(crate) struct Compared {
    pub(crate) programs: usize,
    pub(crate) stops: usize,
    pub(crate) moves: usize,
    pub(crate) faults: Vec<String>,
}

/// Compares all programs of a text, read in a dialect.
pub(crate) fn compare(text: &str, dialect: Dialect) -> Compared {
    let mut compared = Compared::default();
    for whole in text.trim_end().split("\n\n") {
        let case = read(whole);
        compared.programs += 1;
        compared.stops += usize::from(case.stops.is_some());
        compared.moves += case.moves.len();
        if let Err(fault) = check(&case, dialect) {
            compared.faults.push(format!("{fault}:\n{whole}"));
        }
    }
    compared
}

fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("{text} is no number"))
}

fn read(whole: &str) -> Case {
    let mut case = Case::default();
    let (mut feed, mut is_output) = (0.0, false);
    for line in whole.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        match words.as_slice() {
            ["program"] => {}
            ["tool", tool, diameter, orientation] => case.tools.listed.push(ListedTool {
                number: tool.parse().expect("the number of a tool"),
                size: ToolSize::Radius(0.5 * number(diameter)),
                orientation: orientation.parse().expect("an orientation"),
            }),
            ["gives"] => is_output = true,
            ["stops", line] => case.stops = Some(line.parse().expect("a line")),
            [kind, x, y, z, rest @ ..] if is_output => {
                let (mut center, mut turns) = (Vec::new(), 1.0);
                for word in rest {
                    match word.split_at(1) {
                        ("F", value) => feed = number(value),
                        ("P", value) => turns = number(value),
                        _ => center.push(number(word)),
                    }
                }
                let center = DVec2::from_slice(if center.is_empty() { &[0.0; 2] } else { &center });
                let to = DVec3::new(number(x), number(y), number(z));
                case.moves.push(Printed { kind: kind.as_bytes()[0], to, center, turns, feed });
            }
            _ => {
                case.text.push_str(line);
                case.text.push('\n');
            }
        }
    }
    assert!(is_output, "no program: {whole}");
    case
}

/// The line of the block that a move comes from.
fn line_of(step: &Move) -> u32 {
    match step.origin {
        Origin::Block { line, .. } => line,
        Origin::Segment(index) => index,
    }
}

/// The path by the profile, without what is too short to be seen, arcs of several turns with how
/// many they make.
fn moves_of(path: &ToolPath, least: f64) -> Vec<(Move, f64)> {
    let mut moves: Vec<(Move, f64)> = Vec::new();
    let mut turned = 0.0;
    for step in &path.moves {
        let starts = step.plane.place(step.curve.start(), step.heights[0]);
        match step.curve {
            MoveCurve::Arc(arc) => {
                // What is shown of such an arc is a point.
                if arc.radius() < least && starts.distance(end(step)) < least {
                    continue;
                }
                let goes_on = moves.last().is_some_and(|(last, _)| {
                    line_of(last) == line_of(step)
                        && last.role == step.role
                        && matches!(last.curve, MoveCurve::Arc(before)
                            if before.center().distance(arc.center()) < 0.1)
                });
                turned = if goes_on { turned } else { 0.0 } + arc.sweep().abs();
                if goes_on {
                    moves.pop();
                }
                moves.push((*step, turned));
            }
            _ if starts.distance(end(step)) < least => {}
            _ => moves.push((*step, 0.0)),
        }
    }
    moves
}

/// What differs between a move and what was printed.
fn difference((step, turned): &(Move, f64), printed: &Printed, unit: f64) -> Option<String> {
    let near = NEAR + ROUNDED * unit;
    let place = end(step) / unit;
    if (end(step) - printed.to * unit).abs().max_element() > near {
        return Some(format!("ends at {place}"));
    }
    let kind = match step.curve {
        MoveCurve::Arc(arc) => {
            if (arc.center() - printed.center * unit).abs().max_element() > near {
                return Some(format!("turns about {}", arc.center() / unit));
            }
            // Printed it is not to be told whether an arc that ends at its start is a circle.
            let turns = (turned / TAU - 1e-4).ceil();
            if (turns - printed.turns).abs() > 1.0 {
                return Some(format!("makes {turns} turns"));
            }
            if arc.is_clockwise() { b'2' } else { b'3' }
        }
        _ if step.rapid => b'0',
        _ => b'1',
    };
    let climbs = matches!(step.curve, MoveCurve::Vertical(_)) && printed.is_point(near / unit);
    if kind != printed.kind && !climbs {
        return Some("is of another kind".to_string());
    }
    // Feeds per revolution are not compared: what is printed of them is none per minute.
    let feed = step.feed.unwrap_or(printed.feed * unit / 60.0) * 60.0;
    let differs = (feed - printed.feed * unit).abs() > (NEAR + ROUNDED * unit).max(1e-6 * feed);
    (!step.rapid && printed.feed > 0.0 && differs).then(|| format!("has the feed {}", feed / unit))
}

fn check(case: &Case, dialect: Dialect) -> Result<(), String> {
    let profile = Profile::LinuxCnc;
    let read = interpret(&Program::parse(&case.text, dialect), profile.rules());
    let path = compensate_program(&read, &case.tools, &profile.options());
    let unit = if case.text.contains("G20") { 25.4 } else { 1.0 };
    let mut stops = Vec::new();
    for found in &path.diagnostics {
        if let (Severity::Error, Some(Origin::Block { line, .. })) = (found.severity, found.origin)
        {
            stops.push(line);
        }
    }
    match case.stops {
        None if !stops.is_empty() => return Err(format!("stops at {stops:?}")),
        Some(line) if !stops.contains(&line) => return Err(format!("stops at {stops:?}")),
        _ => {}
    }
    let least = 1.5e-4 * unit;
    let moves = moves_of(&path, least);
    let mut at = DVec3::ZERO;
    let mut seen = moves.iter();
    for (i, printed) in case.moves.iter().enumerate() {
        let goes = printed.to.distance(std::mem::replace(&mut at, printed.to)) * unit;
        if goes < least && (printed.kind < b'2' || printed.is_point(least / unit)) {
            continue;
        }
        let Some(step) = seen.next() else { return Err(format!("has no move {i}")) };
        if let Some(difference) = difference(step, printed, unit) {
            return Err(format!("move {i} {difference}, not {printed:?}"));
        }
    }
    match seen.next() {
        Some((step, _)) => Err(format!("has one more, to {}", end(step) / unit)),
        None => Ok(()),
    }
}
