//! Running a program by the profile, and comparing the moves of the tool centre with a list.

use g41::contour::{Move, MoveCurve, ToolPath};
use g41::diagnostic::Severity;
use g41::program::{Dialect, Program, interpret};
use g41::simulation::{ListedTool, Profile, ToolSize, Tools, compensate_program};
use glam::DVec3;

/// A table of tools: number, diameter in the unit of the program, orientation.
pub(crate) type Table = [(u32, f64, u8)];

pub(crate) fn run(text: &str, table: &Table) -> ToolPath {
    let profile = Profile::LinuxCnc;
    let read = interpret(&Program::parse(text, Dialect::Auto), profile.rules());
    let list = |&(number, diameter, orientation): &(u32, f64, u8)| ListedTool {
        number,
        size: ToolSize::Diameter(diameter),
        orientation,
    };
    let tools = Tools { listed: table.iter().map(list).collect(), default_radius: None };
    compensate_program(&read, &tools, &profile.options())
}

/// The errors of a path by their codes.
pub(crate) fn errors(path: &ToolPath) -> Vec<&'static str> {
    let is_error = |severity| severity == Severity::Error;
    path.diagnostics.iter().filter(|found| is_error(found.severity)).map(|f| f.code).collect()
}

/// Where a move ends [mm].
pub(crate) fn end(step: &Move) -> DVec3 {
    step.plane.place(step.curve.end(), step.heights[1])
}

/// Where a move begins [mm].
pub(crate) fn start(step: &Move) -> DVec3 {
    step.plane.place(step.curve.start(), step.heights[0])
}

/// Asserts that a program gives the moves of a list, whose numbers are in units of `unit` [mm] with
/// four decimals. A line is `G0 x y z`, `G1 x y z`, or of an arc `G2 x y z` and its centre by the
/// two axes of the plane.
#[track_caller]
pub(crate) fn assert_moves(text: &str, table: &Table, unit: f64, list: &str) {
    let path = run(text, table);
    assert_eq!(errors(&path), [""; 0], "{:?}", path.diagnostics);
    let found: Vec<String> = path.moves.iter().map(|step| describe(step, unit)).collect();
    let lines: Vec<&str> = list.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    assert_eq!(found.len(), lines.len(), "{found:#?}");
    for (i, (found, line)) in found.iter().zip(&lines).enumerate() {
        let [a, b] = [found, &(*line).to_string()].map(|line| {
            let (word, numbers) = line.split_once(' ').expect("a word and numbers");
            let numbers: Vec<f64> =
                numbers.split_whitespace().map(|n| n.parse().expect("a number")).collect();
            (word.to_string(), numbers)
        });
        let is_same = a.0 == b.0
            && a.1.len() == b.1.len()
            && a.1.iter().zip(&b.1).all(|(a, b)| (a - b).abs() < 6e-5);
        assert!(is_same, "move {i}: {found} should be {line}");
    }
    for (i, pair) in path.moves.windows(2).enumerate() {
        let is_reset = path.words.iter().any(|w| w.before == i + 1 && w.reset.is_some());
        let gap = end(&pair[0]).distance(start(&pair[1]));
        assert!(is_reset || gap < 1e-9, "a gap of {gap} at {:?}", pair[1]);
    }
}

fn describe(step: &Move, unit: f64) -> String {
    let DVec3 { x, y, z } = end(step) / unit;
    match &step.curve {
        MoveCurve::Arc(arc) => {
            let word = if arc.is_clockwise() { "G2" } else { "G3" };
            let center = arc.center() / unit;
            format!("{word} {x} {y} {z} {} {}", center.x, center.y)
        }
        _ if step.rapid => format!("G0 {x} {y} {z}"),
        _ => format!("G1 {x} {y} {z}"),
    }
}
