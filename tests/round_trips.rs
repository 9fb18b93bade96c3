//! Every program of `tests/programs`, written for every target: an independent controller that reads
//! it makes the path that was asked for, so does the reader, and writing it again changes nothing.
#![cfg(not(target_arch = "wasm32"))]

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use g41::compensation::Options;
use g41::contour::{Move, MoveCurve, ToolPath};
use g41::diagnostic::{Diagnostic, Severity};
use g41::program::{Dialect, EmitOptions, Program, Rules, SplineOutput, Target, emit, interpret};
use g41::simulation::{Tools, compensate_program};
use glam::{DVec2, DVec3};

mod common;
#[path = "common/controller.rs"]
mod controller;
#[path = "common/klartext.rs"]
mod klartext;
use common::random::Random;
use controller::run;

/// Tool radius [mm]: small enough for every contour of the programs.
const RADIUS: f64 = 1.5;

/// Of splines [mm].
const TOLERANCE: f64 = 0.001;

fn programs() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let mut programs: Vec<(String, String)> = fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| {
            let path = entry.expect("the entry can be read").path();
            let name = path.file_name().expect("a file has a name").to_string_lossy().into_owned();
            (name, fs::read_to_string(&path).expect("it is text"))
        })
        .collect();
    assert!(programs.len() >= 40, "{} programs", programs.len());
    programs.sort();
    programs
}

fn path_of(text: &str) -> ToolPath {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    compensate_program(&read, &Tools::all(RADIUS), &Options::default())
}

fn options(target: Target) -> EmitOptions {
    EmitOptions { target, tolerance: TOLERANCE, clearance: Some(20.0), ..EmitOptions::default() }
}

/// What rounding may add to any distance [mm]: one and a half units of the last digit.
fn rounding(target: Target) -> f64 {
    match target {
        Target::Fanuc0M | Target::Fanuc6M | Target::Fanuc30I => 1.5e-3,
        _ => 1.5e-4,
    }
}

fn errors(diagnostics: &[Diagnostic]) -> Vec<&Diagnostic> {
    diagnostics.iter().filter(|found| found.severity == Severity::Error).collect()
}

#[test]
fn every_program_is_understood() {
    let mut faults = Vec::new();
    for (name, text) in programs() {
        let path = path_of(&text);
        faults.extend(errors(&path.diagnostics).iter().map(|found| format!("{name}: {found}")));
        assert!(!path.moves.is_empty(), "{name} moves nothing");
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_controller_that_reads_what_is_written_makes_the_path() {
    let mut faults = Vec::new();
    for (name, text) in programs() {
        let path = path_of(&text);
        for target in Target::ALL {
            for splines in [SplineOutput::Arcs, SplineOutput::Native] {
                let written = emit(&path, &EmitOptions { splines, ..options(target) });
                let found = errors(&written.diagnostics);
                assert!(found.is_empty(), "{name} for {target:?}: {found:?}");
                if let Err(fault) = follows(&path, &written.text, target) {
                    faults.push(format!("{name} for {target:?}: {fault}"));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Whether every point that a controller passes is on the path, and in its order, from end to end.
fn follows(path: &ToolPath, text: &str, target: Target) -> Result<(), String> {
    let radii = 4.0 * rounding(target);
    let run = match target {
        Target::Heidenhain => {
            let mut run = klartext::run(text, 24, radii);
            // There the program's zero is set on the machine.
            run.reset |= path.words.iter().any(|words| words.words.contains("G92"));
            run
        }
        _ => run(text, 24, radii),
    };
    // Chords of the other planes' arcs, of rapid cubics and of all cubics may use the tolerance.
    let within = TOLERANCE + rounding(target);
    let mut index = 0;
    let mut reached = DVec3::ZERO;
    for point in &run.points {
        let point = DVec3::from(*point);
        // The first step goes from wherever the tool is to the first position.
        if index == 0 && point == DVec3::ZERO {
            continue;
        }
        let near =
            (index..path.moves.len()).take(40).find(|&i| distance(&path.moves[i], point) <= within);
        if let Some(near) = near {
            index = near;
            reached = point;
        } else {
            let crosses = path.moves.get(index + 1).is_some_and(|next| {
                next.curve.start().distance(path.moves[index].curve.end()) > 1e-6
            });
            if !crosses && !run.reset {
                return Err(format!("{point} is off after move {index} {:?}", path.moves[index]));
            }
        }
    }
    let last = path.moves.last().expect("it moves");
    let end = last.plane.place(last.curve.end(), last.heights[1]);
    if reached.distance(end) <= within {
        Ok(())
    } else {
        Err(format!("ends at {reached}, not {end}"))
    }
}

/// Distance of a point from a move.
fn distance(step: &Move, point: DVec3) -> f64 {
    let (flat, height) = step.plane.split(point);
    let [from, to] = step.heights;
    let beside = |at: DVec2, t: f64| (flat - at).length().hypot(height - from - (to - from) * t);
    match &step.curve {
        MoveCurve::Vertical(at) => {
            let share = if from == to { 0.0 } else { (height - from) / (to - from) };
            beside(*at, share.clamp(0.0, 1.0))
        }
        MoveCurve::Line(line) => {
            // In space, where a line that climbs is nearest.
            let (a, b) = (line.start().extend(from), line.end().extend(to));
            let at = flat.extend(height);
            let share = (at - a).dot(b - a) / (b - a).length_squared();
            at.distance(a + (b - a) * share.clamp(0.0, 1.0))
        }
        MoveCurve::Arc(arc) if from != to => {
            // By its height: it may pass the same place at another.
            let share = ((height - from) / (to - from)).clamp(0.0, 1.0);
            beside(arc.point(share), share)
        }
        curve => {
            let nearest = curve.nearest(flat);
            beside(nearest.point, nearest.t)
        }
    }
}

#[test]
fn writing_a_written_program_again_changes_nothing() {
    let mut faults = Vec::new();
    for (name, text) in programs() {
        let path = path_of(&text);
        // What is written in Heidenhain's language is not read again.
        for target in Target::ALL.into_iter().filter(|target| *target != Target::Heidenhain) {
            let written = emit(&path, &options(target)).text;
            let again = path_of(&written);
            let what = format!("{name} for {target:?}");
            faults
                .extend(errors(&again.diagnostics).iter().map(|found| format!("{what}: {found}")));
            let rewritten = emit(&again, &options(target)).text;
            if rewritten != written {
                let differs = written.lines().zip(rewritten.lines()).find(|(a, b)| a != b);
                faults.push(format!("{what} differs: {differs:?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn lines_and_arcs_come_back_within_a_tenth_of_a_micrometre() {
    for (name, text) in programs() {
        let path = path_of(&text);
        if path.moves.iter().any(|step| matches!(step.curve, MoveCurve::Cubic(_))) {
            continue;
        }
        for target in [Target::Grbl, Target::GrblHal, Target::LinuxCnc, Target::Smoothieware] {
            let again = path_of(&emit(&path, &options(target)).text);
            let what = format!("{name} for {target:?}");
            let ends = |path: &ToolPath| -> Vec<DVec3> {
                let end = |step: &Move| step.plane.place(step.curve.end(), step.heights[1]);
                path.moves.iter().map(end).collect()
            };
            let (before, after) = (ends(&path), ends(&again));
            // Blocks shorter than the last digit vanish, nearly full circles are cut in two.
            let mut rest = after.iter();
            for end in &before {
                let same = |other: &DVec3| other.distance(*end) < 1e-4;
                let short = before.len() > after.len();
                assert!(rest.any(same) || short, "{what}: nothing ends at {end}");
            }
        }
    }
}

#[test]
fn arcs_of_any_sweep_stay_where_they_are_when_they_are_written_again() {
    let mut random = Random::new(7);
    for case in 0..4_000 {
        let radius = 10f64.powf(random.within(-1.0, 3.0));
        let [from, close] = [random.within(0.0, TAU), 10f64.powf(random.within(-2.0, 0.0))];
        // Many of them lack just a bit of a full circle.
        let sweep = if case % 2 == 0 { TAU * (1.0 - 0.2 * close) } else { random.within(0.1, TAU) };
        let sweep = if case % 4 < 2 { sweep } else { -sweep };
        let at = |angle: f64| DVec2::from_angle(angle) * radius;
        let (start, end) = (at(from), at(from + sweep));
        let g = if sweep < 0.0 { 2 } else { 3 };
        let text = format!(
            "G21 G90 G17\nG0 X{:.6} Y{:.6} Z0\nG{g} X{:.6} Y{:.6} I{:.6} J{:.6} F100\nG1 X0 Y0\n",
            start.x, start.y, end.x, end.y, -start.x, -start.y
        );
        for target in [Target::Grbl, Target::Fanuc30I] {
            let written = emit(&path_of(&text), &options(target)).text;
            let again = path_of(&written);
            let rewritten = emit(&again, &options(target)).text;
            assert_eq!(rewritten, written, "case {case} for {target:?}: {text}");
            for step in &again.moves {
                let MoveCurve::Arc(arc) = &step.curve else { continue };
                for share in [0.1, 0.5, 0.9] {
                    let off = (arc.point(share).length() - radius).abs();
                    assert!(
                        off < rounding(target),
                        "case {case}: {off} off for {target:?}: {text}"
                    );
                }
            }
        }
    }
}
