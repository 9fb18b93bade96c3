//! The language without compensation: programs of our own, and the moves that the interpreter of
//! `LinuxCNC` 2.9 printed for them.
//!
//! `language.txt` holds expressions, arcs, coordinate systems, cycles, O words, spellings and the order
//! within blocks: each program, and of the canonical calls its moves, with four decimals in its unit:
//! `0 x y z` of `STRAIGHT_TRAVERSE`, `1 x y z` of `STRAIGHT_FEED`, `2` and `3` `x y z` of `ARC_FEED` with
//! the centre in the axes of its plane and P for several turns, F where the feed is another one. Calls
//! that move nothing are left out. `stops` names the line at which the interpreter refused to go on.
//!
//! Made by `rs274 -g -i FILE.ini -t TOOL.tbl -v FILE.var PROGRAM`, with `LINEAR_UNITS=mm` and a
//! parameter file of `5161 0`; the programs come from seeded generators.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::TAU;

use g41::contour::{Move, MoveCurve, ToolPath};
use g41::diagnostic::{Origin, Severity};
use g41::program::{Dialect, Program, interpret};
use g41::simulation::{Profile, Tools, compensate_program};

use super::run::{end, start};

const PRINTED: &str = include_str!("language.txt");

/// How near numbers have to be [mm], besides half a unit of the last digit that was printed.
const NEAR: f64 = 1e-4;

fn path_of(text: &str) -> ToolPath {
    let profile = Profile::LinuxCnc;
    let read = interpret(&Program::parse(text, Dialect::LinuxCnc), profile.rules());
    compensate_program(&read, &Tools::default(), &profile.options())
}

/// The numbers of a move in the unit of its program: its kind, its end, and of arcs centre and turns.
fn numbers(step: &Move, turned: f64, unit: f64) -> Vec<f64> {
    let kind = match step.curve {
        MoveCurve::Arc(arc) if arc.is_clockwise() => 2.0,
        MoveCurve::Arc(_) => 3.0,
        _ if step.rapid => 0.0,
        _ => 1.0,
    };
    let place = end(step) / unit;
    let mut numbers = vec![kind, place.x, place.y, place.z];
    if let MoveCurve::Arc(arc) = step.curve {
        let center = arc.center() / unit;
        numbers.extend([center.x, center.y, (turned / TAU - 1e-4).ceil().max(1.0)]);
    }
    numbers
}

/// The moves of a path, those too short to be printed apart, and arcs of several turns as one.
fn found(path: &ToolPath, unit: f64) -> Vec<(Vec<f64>, Option<f64>)> {
    let mut found: Vec<(Vec<f64>, Option<f64>)> = Vec::new();
    let (mut turned, mut last) = (0.0, None);
    for step in &path.moves {
        let arc = if let MoveCurve::Arc(arc) = step.curve { Some(arc) } else { None };
        if arc.is_none() && start(step).distance(end(step)) < 1.5 * NEAR * unit {
            continue;
        }
        // Its circles come before what is left of it, in the same block.
        let circle = last.is_some_and(|(origin, full)| full && origin == step.origin);
        if circle && arc.is_some() {
            found.pop();
        } else {
            turned = 0.0;
        }
        turned += arc.map_or(0.0, |arc| arc.sweep().abs());
        last = Some((step.origin, arc.is_some_and(|arc| arc.is_full_circle())));
        let feed = step.feed.filter(|_| !step.rapid).map(|feed| feed * 60.0 / unit);
        found.push((numbers(step, turned, unit), feed));
    }
    found
}

/// What differs between a program's path and what was printed for it.
fn fault(whole: &str) -> Option<String> {
    let (text, printed) = whole.strip_prefix("program\n")?.split_once("\ngives\n")?;
    let path = path_of(text);
    let unit = if text.contains("G20") { 25.4 } else { 1.0 };
    let near = NEAR / unit + 0.5e-4;
    let mut stops = Vec::new();
    for told in &path.diagnostics {
        if let (Severity::Error, Some(Origin::Block { line, .. })) = (told.severity, told.origin) {
            stops.push(line.to_string());
        }
    }
    let (mut moves, mut feed, mut stop) = (found(&path, unit).into_iter(), 0.0, None);
    for line in printed.lines() {
        if let Some(at) = line.strip_prefix("stops ") {
            stop = Some(at.to_owned());
            continue;
        }
        let (mut wanted, mut turns) = (Vec::new(), 1.0);
        for word in line.split(' ') {
            let number = |text: &str| text.parse::<f64>().expect("a number");
            match word.split_at(1) {
                ("F", value) => feed = number(value),
                ("P", value) => turns = number(value),
                _ => wanted.push(number(word)),
            }
        }
        if wanted.len() > 4 {
            wanted.push(turns);
        }
        let Some((move_, at_feed)) = moves.next() else { return Some(format!("ends at {line}")) };
        let same = move_.len() == wanted.len()
            && move_.iter().zip(&wanted).all(|(a, b)| (a - b).abs() <= near);
        if !same {
            return Some(format!("{move_:?} is not {line}"));
        }
        if at_feed.is_some_and(|found| (found - feed).abs() > near.max(1e-6 * feed)) {
            return Some(format!("the feed {at_feed:?} is not {feed}: {line}"));
        }
    }
    match (stop, moves.next()) {
        (_, Some((further, _))) => Some(format!("goes on to {further:?}")),
        (Some(line), _) if !stops.contains(&line) => Some(format!("stops at {stops:?}")),
        (None, _) if !stops.is_empty() => Some(format!("stops at {stops:?}")),
        _ => None,
    }
}

#[test]
fn programs_are_read_as_linuxcnc_reads_them() {
    let mut faults = Vec::new();
    let mut programs = 0;
    for whole in PRINTED.trim_end().split("\n\n") {
        programs += 1;
        assert!(whole.contains("\ngives\n"), "no program: {whole}");
        if let Some(fault) = fault(whole) {
            faults.push(format!("{fault}:\n{whole}"));
        }
    }
    assert!(faults.is_empty(), "{} of {programs}\n{}", faults.len(), faults.join("\n\n"));
    assert!(programs >= 300, "only {programs}");
}
