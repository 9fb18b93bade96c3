//! Arcs and lines fitted to chains of cubics, against dense sampling of both.

use g41::geometry::{ArcOrLine, Cubic, fit_arcs};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::{Field, Plain};
use crate::common::random::Random;
use crate::common::{near_point, p};

fn plain(piece: &ArcOrLine) -> Plain {
    match piece {
        ArcOrLine::Arc(arc) => Plain::of_arc(arc),
        ArcOrLine::Line(line) => Plain::of_line(line),
    }
}

fn ends(piece: &ArcOrLine) -> (DVec2, DVec2) {
    match piece {
        ArcOrLine::Arc(arc) => (arc.start(), arc.end()),
        ArcOrLine::Line(line) => (line.start(), line.end()),
    }
}

/// Asserts that the fitted pieces follow each other from end to end of the chain, that every point
/// of the chain is within `tolerance` of them and every point of theirs of the chain.
fn judge(cubics: &[Cubic], tolerance: f64, what: &str) -> usize {
    let pieces = fit_arcs(cubics, tolerance);
    assert!(!pieces.is_empty(), "{what}: nothing fitted");
    let (start, end) = (cubics[0].points[0], cubics[cubics.len() - 1].points[3]);
    // Where the chain stands still for less than the tolerance a piece may be missing.
    near_point(ends(&pieces[0]).0, start, 1e-9, &format!("{what}: start"));
    near_point(ends(&pieces[pieces.len() - 1]).1, end, 1e-9, &format!("{what}: end"));
    for pair in pieces.windows(2) {
        near_point(ends(&pair[0]).1, ends(&pair[1]).0, 1e-9, &format!("{what}: joint"));
    }
    let chain: Vec<Plain> = cubics.iter().map(Plain::of_cubic).collect();
    let fitted: Vec<Plain> = pieces.iter().map(plain).collect();
    for (from, to, name) in [(&chain, &fitted, "chain"), (&fitted, &chain, "fit")] {
        let samples = if name == "fit" { 512 } else { 64 };
        let field = Field::new(to.iter().map(|curve| (*curve, samples)));
        for curve in from {
            for sample in curve.sampled(60) {
                let off = field.distance(sample);
                assert!(off <= tolerance, "{what}: a point of the {name} is {off:e} off");
            }
        }
    }
    pieces.len()
}

#[test]
fn arcs_follow_random_splines_within_the_tolerance() {
    let mut random = Random::new(71);
    for case in 0..40 {
        let spline = shapes::spline(&mut random, 20.0);
        for tolerance in [1e-1, 1e-2, 1e-3] {
            judge(spline.pieces(), tolerance, &format!("case {case} at {tolerance}: {spline:?}"));
        }
    }
}

#[test]
fn arcs_follow_random_cubics_with_kinks_between_them() {
    let mut random = Random::new(72);
    for case in 0..40 {
        let mut from = random.point(20.0);
        let mut chain = Vec::new();
        for _ in 0..=random.index(5) {
            let mut cubic = shapes::cubic(&mut random, 20.0);
            cubic.points[0] = from;
            from = cubic.points[3];
            chain.push(cubic);
        }
        for tolerance in [1e-1, 1e-2, 1e-3] {
            judge(&chain, tolerance, &format!("case {case} at {tolerance}: {chain:?}"));
        }
    }
}

#[test]
fn arcs_follow_a_chain_into_its_cusp_and_out_again() {
    let at = |a: f64, b: f64, c: f64| p((a * b + a * c + b * c) / 3.0, a * b * c) * 10.0;
    // The semicubical parabola (t², t³): a cusp inside a cubic, and between two.
    let piece = |a: f64, b: f64| Cubic::new(at(a, a, a), at(a, a, b), at(a, b, b), at(b, b, b));
    for tolerance in [1e-1, 1e-2, 1e-3, 1e-4] {
        judge(&[piece(-1.0, 1.5)], tolerance, &format!("a cusp inside at {tolerance}"));
        judge(
            &[piece(-1.0, 0.0), piece(0.0, 1.5)],
            tolerance,
            &format!("a cusp between at {tolerance}"),
        );
        let back = [piece(0.0, 1.0), piece(0.0, 1.0).reversed()];
        judge(&back, tolerance, &format!("there and back at {tolerance}"));
    }
}

#[test]
fn a_circle_takes_few_arcs_and_a_line_one_line() {
    // A quarter circle as a cubic (error 2.7e-4 of its radius) is one biarc at a tolerance of 0.01.
    let k = 4.0 / 3.0 * (2.0_f64.sqrt() - 1.0);
    let quarter = Cubic::new(p(10.0, 0.0), p(10.0, 10.0 * k), p(10.0 * k, 10.0), p(0.0, 10.0));
    let count = judge(&[quarter], 0.01, "a quarter circle");
    assert!(count <= 2, "a quarter circle takes {count} pieces");
    let straight = Cubic::new(p(0.0, 0.0), p(1.0, 2.0), p(5.0, 10.0), p(7.0, 14.0));
    let pieces = fit_arcs(&[straight], 1e-6);
    assert_eq!(pieces.len(), 1, "a straight cubic is one line: {pieces:?}");
    assert!(matches!(pieces[0], ArcOrLine::Line(_)), "a straight cubic is a line: {pieces:?}");
}

#[test]
fn a_cubic_that_stands_still_takes_nothing_and_harms_nothing() {
    let still = Cubic::new(p(3.0, 4.0), p(3.0, 4.0), p(3.0, 4.0), p(3.0, 4.0));
    assert!(fit_arcs(&[still], 1e-3).is_empty(), "standing still");
    let go = Cubic::new(p(3.0, 4.0), p(4.0, 6.0), p(6.0, 6.0), p(9.0, 4.0));
    judge(&[still, go, go.reversed(), still, go], 1e-3, "standing between");
}
