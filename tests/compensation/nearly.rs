//! Contours that nearly touch, cross or turn back: within the tolerance what they are is open.

use std::f64::consts::TAU;

use g41::compensation::{CornerStyle, Options, avoid};
use g41::contour::{Side, Tool, ToolPath};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::families::Case;
use super::judge::{field_of, samples};
use super::sketch::{Sketch, arc, line};
use super::verdict::{Depth, faults, path_of};
use crate::common::{near, p};

const TOLERANCE: f64 = 1e-3;

fn avoided(sketch: &Sketch, side: Side, radius: f64) -> ToolPath {
    let options = Options { tolerance: TOLERANCE, corner: CornerStyle::Arc, ..Options::default() };
    avoid(&sketch.contour(), Tool::new(radius, side).expect("a radius"), &options)
}

fn polygon(points: &[(f64, f64)]) -> Sketch {
    let start = p(points[0].0, points[0].1);
    let rest = points[1..].iter().chain(&points[..1]);
    Sketch::closed(start, rest.map(|&(x, y)| line(p(x, y))))
}

/// Whether a path is one loop.
fn is_one_loop(path: &ToolPath) -> bool {
    let joined = |a: DVec2, b: DVec2| a.distance(b) <= 1e-6;
    let moves = &path.moves;
    moves.windows(2).all(|pair| joined(pair[0].curve.end(), pair[1].curve.start()))
        && joined(moves[moves.len() - 1].curve.end(), moves[0].curve.start())
}

fn length(path: &ToolPath) -> f64 {
    path.moves.iter().map(|one| one.curve.length()).sum()
}

#[test]
fn the_tip_of_a_slender_slit_is_not_gone_round_from_outside() {
    // A pocket of 20 by 20 mm with a slit in a wall, 10 mm deep and 10 µm wide at its mouth.
    let slit = [(20.0, 9.995), (30.0, 10.0), (20.0, 10.005)];
    let corners = [&[(0.0, 0.0), (20.0, 0.0)], slit.as_slice(), &[(20.0, 20.0), (0.0, 20.0)]];
    let radius = 0.006;
    let path = avoided(&polygon(&corners.concat()), Side::Left, radius);
    assert!(is_one_loop(&path), "the tool stays in the pocket: {:?}", path.moves);
    // It hangs on both edges of the mouth, where the slit is as wide as 10 of its 12 µm.
    let deepest = samples(&path, 40).into_iter().map(|at| at.x).fold(0.0, f64::max);
    let hangs = 20.0 - (0.006_f64.powi(2) - 0.005_f64.powi(2)).sqrt();
    near(deepest, hangs, 1e-6, "how far it comes");
    near(length(&path), 4.0 * 20.0 - 8.0 * radius, 2e-3, "the square, and two roundings");
}

#[test]
fn a_corner_that_turns_the_wrong_way_on_a_nanometre_is_gone_round() {
    // Between its first side and its second a triangle steps 0.2 µm down and 0.1 µm back.
    let corners = [(0.0, 0.0), (40.0, 0.0), (39.999_999_9, -2e-7), (0.0, 30.0)];
    let path = avoided(&polygon(&corners), Side::Right, 94.0);
    assert!(is_one_loop(&path), "{:?}", path.moves);
    near(length(&path), 120.0 + TAU * 94.0, 2.0 * TOLERANCE, "sides and a full turn");
}

#[test]
fn flanks_that_cross_near_their_tip_make_a_spike() {
    // Two arcs of 10 mm that bend away from each other would be a spike; turned by 5 mrad about their
    // tip they cross 50 µm behind it, where they are 60 nm apart at most.
    let turned = |x: f64, y: f64, by: f64| DVec2::from_angle(by).rotate(p(x, y));
    let by = -5e-3;
    let (from, low) = (turned(-8.0, -4.0, by), turned(0.0, -10.0, by));
    let sketch = Sketch::closed(
        from,
        [arc(p(0.0, 0.0), low, true), arc(p(-8.0, 4.0), p(0.0, 10.0), true), line(from)],
    );
    for (radius, corner) in [(0.05, "small"), (3.0, "large")] {
        let path = avoided(&sketch, Side::Right, radius);
        assert!(is_one_loop(&path), "a {corner} tool: {:?}", path.moves);
        let field = field_of(&sketch.contour());
        for at in samples(&path, 20) {
            let distance = field.distance(at);
            assert!(distance >= radius - TOLERANCE, "{at} is {distance} from the contour");
        }
        let beyond = samples(&path, 20).into_iter().map(|at| at.x).fold(0.0, f64::max);
        near(beyond, radius, TOLERANCE, "the tool goes round the tip");
    }
}

#[test]
fn contours_of_the_families_that_failed_once_are_free_of_faults() {
    for (what, seeds) in [
        ("slits and spikes whose flanks cross", &[4231, 8076, 5676, 83_947, 89_821, 142_320][..]),
        ("flanks that meet in less than the tolerance", &[1713, 71_421, 188_641]),
        (
            "segments and spans of a part of the tolerance",
            &[17_517, 54_947, 46_679, 858_350, 1_104_954],
        ),
        ("walls nearly a tool apart and nearly parallel", &[4522, 6071, 181_512, 88_633, 105_810]),
        ("paths that touch where they part", &[730_372, 5628, 749_446, 329_078]),
        ("a tolerance of nearly the radius", &[1_306_040]),
        ("bends as small as the tolerance", &[155_435, 241_421, 243_491]),
    ] {
        for &seed in seeds {
            let case = Case::of(seed);
            let contour = case.contour().expect("the families have these");
            let found = faults(&case, &contour, &path_of(&case, &contour), Depth::Brute);
            assert!(found.is_empty(), "{what}, seed {seed}: {found:?}");
        }
    }
}
