//! What segments carry besides their curve: heights, feeds, rapids, origins, and words between.

use g41::compensation::{CornerStyle, Options, compensate};
use g41::contour::{
    Attributes, ContourBuilder, EventKind, MoveCurve, Role, Shape, Side, Tool, ToolPath,
};
use g41::diagnostic::Origin;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::sketch::{arc, line, spline};
use crate::common::{near, p};

/// Shapes with the heights at their ends; each segment has its number for a feed.
fn climbing() -> Vec<(Shape, [f64; 2])> {
    vec![
        (line(p(20.0, 0.0)), [0.0, 0.0]),
        (arc(p(30.0, 10.0), p(20.0, 10.0), false), [0.0, -2.0]),
        (line(p(10.0, 10.0)), [-2.0, -3.0]),
        (spline(&[p(0.0, 22.0), p(5.0, 35.0), p(20.0, 42.0)]), [-3.0, -3.0]),
        (line(p(40.0, 60.0)), [-3.0, 1.0]),
        (line(p(40.0, 30.0)), [1.0, 1.0]),
    ]
}

fn attributes(i: usize, z: [f64; 2]) -> Attributes {
    let number = u32::try_from(i).expect("few segments");
    let (feed, heights) = (Some(i as f64 + 1.0), z);
    Attributes { feed, rapid: i >= 4, heights, ..Attributes::at(Origin::Segment(number)) }
}

fn paths() -> Vec<(String, ToolPath)> {
    let mut paths = Vec::new();
    for side in [Side::Left, Side::Right] {
        for corner in [CornerStyle::Linear, CornerStyle::Arc] {
            let mut builder = ContourBuilder::new(p(0.0, 0.0));
            for (i, (shape, z)) in climbing().into_iter().enumerate() {
                if i == 3 {
                    builder.event(EventKind::Words("M8".into()), Origin::Segment(90));
                    let z = Attributes { rapid: true, ..attributes(91, [-3.0, -3.0]) };
                    builder.event(EventKind::Vertical(z), Origin::Segment(91));
                }
                builder.segment(shape, attributes(i, z));
            }
            builder.event(EventKind::Words("M9".into()), Origin::Segment(92));
            let contour = builder.build(false).contour.expect("a contour");
            let tool = Tool::new(1.5, side).expect("a valid radius");
            let options = Options { corner, ..Options::default() };
            paths.push((format!("{side:?} {corner:?}"), compensate(&contour, tool, &options)));
        }
    }
    paths
}

#[test]
fn heights_change_without_a_step_and_evenly_along_each_segment() {
    for (what, path) in paths() {
        for pair in path.moves.windows(2) {
            near(
                pair[0].heights[1],
                pair[1].heights[0],
                1e-12,
                &format!("{what}: a step at {pair:?}"),
            );
        }
        for (i, (_, z)) in climbing().iter().enumerate() {
            let origin = attributes(i, *z).origin;
            let of = |one: &&g41::contour::Move| one.origin == origin && one.role == Role::Segment;
            let moves: Vec<_> = path.moves.iter().filter(of).collect();
            assert!(!moves.is_empty(), "{what}: nothing of segment {i}");
            near(moves[0].heights[0], z[0], 1e-12, &format!("{what}: start of segment {i}"));
            near(
                moves[moves.len() - 1].heights[1],
                z[1],
                1e-12,
                &format!("{what}: end of segment {i}"),
            );
            let length: f64 = moves.iter().map(|one| one.curve.length()).sum();
            let slope = (z[1] - z[0]) / length;
            for one in moves {
                let climb = slope * one.curve.length();
                near(
                    one.heights[1] - one.heights[0],
                    climb,
                    1e-9,
                    &format!("{what}: slope of segment {i}"),
                );
            }
        }
    }
}

#[test]
fn feeds_rapids_and_origins_are_those_of_their_segment() {
    for (what, path) in paths() {
        for one in path.moves.iter().filter(|one| one.role == Role::Segment) {
            let Origin::Segment(i) = one.origin else { panic!("{what}: {one:?}") };
            if i >= 90 {
                continue;
            }
            assert_eq!(one.feed, Some(f64::from(i) + 1.0), "{what}: feed of {one:?}");
            assert_eq!(one.rapid, i >= 4, "{what}: rapid of {one:?}");
        }
        let order: Vec<_> = path
            .moves
            .iter()
            .filter_map(|one| match one.origin {
                Origin::Segment(i) if i < 90 => Some(i),
                _ => None,
            })
            .collect();
        assert!(order.is_sorted(), "{what}: out of order, {order:?}");
        for one in path.moves.iter().filter(|one| one.role == Role::Transition) {
            let Origin::Segment(next) = one.origin else { panic!("{what}: {one:?}") };
            assert_eq!(one.rapid, next >= 5, "{what}: a rapid only between rapids, {one:?}");
        }
    }
}

#[test]
fn words_keep_their_place_between_segments() {
    for (what, path) in paths() {
        let words: Vec<_> = path.words.iter().map(|w| (w.words.as_str(), w.before)).collect();
        let [("M8", before), ("M9", end)] = words[..] else { panic!("{what}: {words:?}") };
        let origins = |moves: &[g41::contour::Move]| -> Vec<u32> {
            moves
                .iter()
                .filter_map(|one| match one.origin {
                    Origin::Segment(i) if i < 90 && one.role == Role::Segment => Some(i),
                    _ => None,
                })
                .collect()
        };
        assert!(origins(&path.moves[..before]).iter().all(|i| *i <= 2), "{what}: M8 too late");
        assert!(origins(&path.moves[before..]).iter().all(|i| *i >= 3), "{what}: M8 too early");
        assert_eq!(end, path.moves.len(), "{what}: M9 at the end");
        let vertical = path.moves.iter().find(|one| matches!(one.curve, MoveCurve::Vertical(_)));
        assert!(vertical.is_some_and(|one| one.rapid), "{what}: the move along z is kept");
    }
}
