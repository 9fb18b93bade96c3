//! What every tool path must be: in one piece, and at its distance from the contour.

use std::f64::consts::SQRT_2;

use g41::compensation::CornerStyle;
use g41::contour::{Contour, MoveCurve, Role, ToolPath};
use glam::DVec2;

use crate::common::oracle::{Field, Plain};

/// Distances from the segments of a contour.
pub(crate) fn field_of(contour: &Contour) -> Field {
    let pieces = contour.segments().iter().flat_map(|segment| Plain::of_curve(&segment.curve));
    Field::new(pieces.map(|piece| (piece, piece.samples())))
}

/// Distances from the moves of a path.
pub(crate) fn field_of_path(path: &ToolPath) -> Field {
    let moves = path.moves.iter().filter_map(|one| Plain::of_move(&one.curve));
    Field::new(moves.map(|piece| (piece, piece.samples())))
}

/// Asserts that every move is finite and starts where the one before it ended.
#[track_caller]
pub(crate) fn in_one_piece(path: &ToolPath, what: &str) {
    for one in &path.moves {
        let (start, end) = (one.curve.start(), one.curve.end());
        assert!(start.is_finite() && end.is_finite(), "{what}: not finite, {one:?}");
        if let MoveCurve::Arc(arc) = &one.curve {
            let (at_start, at_end) = (start.distance(arc.center()), end.distance(arc.center()));
            let off = (at_start - arc.radius()).abs().max((at_end - arc.radius()).abs());
            assert!(off <= 1e-8 * (1.0 + arc.radius()), "{what}: not an arc, {arc:?}");
        }
    }
    for pair in path.moves.windows(2) {
        let (end, start) = (pair[0].curve.end(), pair[1].curve.start());
        let gap = end.distance(start);
        assert!(gap <= 1e-8, "{what}: a gap of {gap:e} at {end}: {pair:?}");
    }
}

/// Points of all moves but leads, `count` to a move.
pub(crate) fn samples(path: &ToolPath, count: u32) -> Vec<DVec2> {
    let leads = [Role::LeadIn, Role::LeadOut];
    path.moves
        .iter()
        .filter(|one| !leads.contains(&one.role))
        .flat_map(|one| (0..=count).map(|i| one.curve.point(f64::from(i) / f64::from(count))))
        .collect()
}

/// Asserts that the path is nowhere nearer to the contour than r − tolerance, and nowhere farther
/// than r + tolerance with arcs at corners, than √2 r + tolerance (the vertex of a right angle)
/// with straight moves.
#[track_caller]
pub(crate) fn at_the_radius(
    path: &ToolPath,
    field: &Field,
    radius: f64,
    corner: CornerStyle,
    tolerance: f64,
    what: &str,
) {
    assert!(!path.moves.is_empty(), "{what}: no path");
    let most = if corner == CornerStyle::Arc { radius } else { SQRT_2 * radius };
    for point in samples(path, 12) {
        let distance = field.distance(point);
        assert!(
            distance >= radius - tolerance,
            "{what}: {point} is {:e} too near",
            radius - distance
        );
        assert!(distance <= most + tolerance, "{what}: {point} is {:e} too far", distance - most);
    }
}

/// Asserts that two paths are the same curve: each point of one is on the other.
#[track_caller]
pub(crate) fn same_path(a: &ToolPath, b: &ToolPath, slack: f64, what: &str) {
    for (one, other, name) in [(a, b, "first"), (b, a, "second")] {
        let field = field_of_path(other);
        for point in samples(one, 9) {
            let off = field.distance(point);
            assert!(off <= slack, "{what}: {point} of the {name} path is {off:e} off the other");
        }
    }
    let (la, lb): (f64, f64) = (length(a), length(b));
    assert!((la - lb).abs() <= slack * 100.0, "{what}: lengths {la} and {lb}");
}

fn length(path: &ToolPath) -> f64 {
    let leads = [Role::LeadIn, Role::LeadOut];
    path.moves.iter().filter(|m| !leads.contains(&m.role)).map(|m| m.curve.length()).sum()
}
