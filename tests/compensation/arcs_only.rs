//! Paths of arcs and lines alone: at the radius within the tolerance, in one piece, never too near.

use g41::compensation::{CornerStyle, GougePolicy, Options, Output, Passes, compensate_all};
use g41::contour::{
    Attributes, Contour, ContourBuilder, EventKind, MoveCurve, Shape, Side, SplineShape, Tool,
    ToolPath,
};
use g41::diagnostic::Origin;
use g41::gouge::check;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::families::Case;
use super::judge::{at_the_radius, field_of, in_one_piece};
use crate::common::curves::wave;
use crate::common::{near, near_point, p};

const SEEDS: u64 = if cfg!(target_arch = "wasm32") { 100 } else { 600 };

fn through(points: &[DVec2], closed: bool, heights: [f64; 2]) -> Contour {
    let mut builder = ContourBuilder::new(points[0]);
    let shape = SplineShape { points: points[1..].to_vec(), ..SplineShape::default() };
    let attributes = Attributes { heights, ..Attributes::at(Origin::Segment(0)) };
    builder.segment(Shape::Spline(shape), attributes);
    builder.event(EventKind::Words("M9".into()), Origin::Segment(0));
    builder.build(closed).contour.expect("a contour")
}

fn arcs(contour: &Contour, radius: f64, options: Options) -> ToolPath {
    let tool = Tool::new(radius, Side::Left).expect("a radius");
    compensate_all(&[(contour, tool)], &Options { output: Output::Arcs, ..options })
}

fn is_cubic(curve: &MoveCurve) -> bool {
    matches!(curve, MoveCurve::Cubic(_))
}

#[test]
fn arcs_lie_at_the_radius_within_the_tolerance() {
    let contour = through(&wave(60), true, [0.0; 2]);
    let field = field_of(&contour);
    let mut before = 0;
    for tolerance in [1e-1, 1e-2, 1e-3, 1e-4] {
        let path = arcs(&contour, 5.0, Options { tolerance, ..Options::default() });
        let what = format!("tolerance {tolerance}");
        assert!(!path.moves.iter().any(|one| is_cubic(&one.curve)), "{what}: no cubics");
        in_one_piece(&path, &what);
        at_the_radius(&path, &field, 5.0, CornerStyle::Arc, tolerance, &what);
        assert!(path.moves.len() > before, "{what}: {} moves", path.moves.len());
        before = path.moves.len();
        // Chords of the same curve, bends of 40 mm on the average: √(8 R tolerance) each.
        let chords = 300.0 / (8.0_f64 * 40.0 * tolerance).sqrt();
        assert!((before as f64) < chords.max(40.0), "{what}: {before} moves, {chords} chords");
    }
}

#[test]
fn arcs_never_cut_deeper_than_cubics_may() {
    let mut with_arcs = 0;
    for seed in 0..SEEDS {
        let case = Case::of(seed);
        let Some(contour) = case.contour() else { continue };
        let tool = Tool::new(case.radius, case.side).expect("a radius");
        let (gouge, tolerance) = (GougePolicy::Avoid, case.tolerance);
        let options = Options { gouge, tolerance, corner: case.corner, ..Options::default() };
        let cubics = compensate_all(&[(&contour, tool)], &options);
        if !cubics.moves.iter().any(|one| is_cubic(&one.curve)) {
            continue;
        }
        with_arcs += 1;
        let path =
            compensate_all(&[(&contour, tool)], &Options { output: Output::Arcs, ..options });
        assert!(!path.moves.iter().any(|one| is_cubic(&one.curve)), "seed {seed}: no cubics");
        let gouges = check(&contour, &path, case.radius.abs(), tolerance * (1.0 + 1e-6));
        assert_eq!(gouges, [], "seed {seed}: {case:?}");
    }
    assert!(with_arcs > SEEDS / 10, "{with_arcs} of {SEEDS} have splines that the tool can follow");
}

#[test]
fn words_and_loops_keep_their_places() {
    let contour = through(&wave(60), true, [0.0; 2]);
    let path = arcs(&contour, 5.0, Options::default());
    assert_eq!(path.words.len(), 1, "{:?}", path.words);
    assert_eq!(path.words[0].before, path.moves.len(), "behind all moves of the spline");

    let passes = Passes::Several { count: 2, stepover: 4.0 };
    let options = Options { gouge: GougePolicy::Avoid, passes, ..Options::default() };
    let path = arcs(&contour, 5.0, options);
    assert!(path.loops.len() >= 2, "{:?}", path.loops);
    for one in &path.loops {
        let moves = &path.moves[one.first_move..one.moves_end];
        near_point(moves[0].curve.start(), moves[moves.len() - 1].curve.end(), 1e-6, "closed");
    }
    assert_eq!(path.loops[path.loops.len() - 1].moves_end, path.moves.len(), "all are in loops");
}

#[test]
fn heights_climb_evenly_along_the_arcs() {
    let points = [p(0.0, 0.0), p(10.0, 6.0), p(22.0, 4.0), p(30.0, 12.0)];
    let path = arcs(&through(&points, false, [1.0, -2.0]), 3.0, Options::default());
    in_one_piece(&path, "climbing");
    near(path.moves[0].heights[0], 1.0, 1e-12, "start");
    near(path.moves[path.moves.len() - 1].heights[1], -2.0, 1e-12, "end");
    let length: f64 = path.moves.iter().map(|one| one.curve.length()).sum();
    for one in &path.moves {
        let climb = -3.0 * one.curve.length() / length;
        near(one.heights[1] - one.heights[0], climb, 1e-4, &format!("{one:?}"));
    }
}
