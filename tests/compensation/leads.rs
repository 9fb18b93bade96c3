//! Lead-in and lead-out ("Tool radius compensation algorithm of spline curve", 2.4), point by point.

use g41::compensation::{CornerStyle, LeadStyle, Options, SplineMethod};
use g41::contour::{MoveCurve, Role, Shape, Side, ToolPath};
use g41::diagnostic::Severity;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::in_one_piece;
use super::sketch::{Sketch, arc, line, spline};
use crate::common::{near, near_point, p};

const RADIUS: f64 = 2.0;
const CORNER: DVec2 = DVec2::new(10.0, -4.0);

/// Turns towards the tool, in degrees, and whether the corner is shortened, elongated or inserted.
const TURNS: [(f64, char); 6] =
    [(40.0, 's'), (120.0, 's'), (-40.0, 'e'), (-90.0, 'e'), (-100.0, 'i'), (-150.0, 'i')];

/// A contour of one segment from the corner along `along`, and the tangent that decides.
fn shapes(along: DVec2, method: SplineMethod) -> [(Shape, DVec2, bool); 3] {
    let center = CORNER + along.perp() * 30.0;
    let end = center + DVec2::from_angle(0.8).rotate(CORNER - center);
    let points = [p(5.0, 0.6), p(11.0, 0.2), p(18.0, -1.0)].map(|q| CORNER + along.rotate(q));
    let sketch = Sketch::open(CORNER, [spline(&points)]);
    let tangent = match method {
        SplineMethod::Exact => sketch.contour().segments()[0].curve.tangent(0.0),
        SplineMethod::TypePoints => (points[0] - CORNER).normalize(),
    };
    [
        (line(CORNER + along * 20.0), along, true),
        (arc(end, center, false), along, false),
        (spline(&points), tangent, false),
    ]
}

/// Vertices of the path from the lead's far end to the first point beside the contour.
fn vertices(path: &ToolPath) -> Vec<DVec2> {
    let mut points = vec![path.moves[0].curve.start()];
    for one in &path.moves {
        if one.role == Role::Segment {
            break;
        }
        points.push(one.curve.end());
    }
    points
}

fn judge(style: LeadStyle, corner: CornerStyle, method: SplineMethod) {
    for side in [Side::Left, Side::Right] {
        for (degrees, kind) in TURNS {
            for which in 0..3 {
                let sigma = side.sign();
                let t2_wanted = DVec2::from_angle(0.5);
                let (shape, t2, straight) = shapes(t2_wanted, method)[which].clone();
                let t1 = DVec2::from_angle(-sigma * degrees.to_radians()).rotate(t2);
                let from = CORNER - t1 * 15.0;
                let mut sketch = Sketch::open(CORNER, [shape]);
                sketch.lead_in = Some(from);
                let options = Options { lead: style, corner, spline: method, ..Options::default() };
                let path = sketch.compensated(side, RADIUS, &options);
                let what =
                    format!("{side:?} {degrees}° shape {which} {style:?} {corner:?} {method:?}");
                let (n1, n2) = (t1.perp() * sigma, t2.perp() * sigma);
                let (beside1, beside2) = (CORNER + n1 * RADIUS, CORNER + n2 * RADIUS);
                let v =
                    CORNER + (n1 + n2).normalize() * RADIUS / (0.5 * degrees.to_radians()).cos();
                let (a1, a2) = (beside1 + t1 * RADIUS, beside2 - t2 * RADIUS);
                // A straight offset itself runs from V or A2; a curve starts beside its own start.
                let mut expected = match (style, corner, kind) {
                    (LeadStyle::ExtraMove, ..) => vec![from, CORNER, beside2],
                    (LeadStyle::Perpendicular, ..) | (_, _, 's') => vec![from, beside2],
                    (_, CornerStyle::Arc, _) => vec![from, beside1, beside2],
                    (_, _, 'e') => vec![from, beside1, v, beside2],
                    _ => vec![from, beside1, a1, a2, beside2],
                };
                let outside = style.goes_round() && kind != 's';
                // Type points: the moved spline starts at V where nothing is inserted.
                let at_v = which == 2 && method == SplineMethod::TypePoints && kind == 'e';
                if outside && corner == CornerStyle::Linear && (straight || at_v) {
                    expected.pop();
                }
                let found = vertices(&path);
                assert_eq!(found.len(), expected.len(), "{what}: {found:?} for {expected:?}");
                for (point, expected) in found.iter().zip(&expected) {
                    near_point(*point, *expected, 1e-9, &what);
                }
                assert_eq!(path.moves[0].role, Role::LeadIn, "{what}");
                in_one_piece(&path, &what);
                if corner == CornerStyle::Arc && outside {
                    let MoveCurve::Arc(arc) = path.moves[1].curve else { panic!("{what}: no arc") };
                    near_point(arc.center(), CORNER, 1e-9, &what);
                    near(arc.radius(), RADIUS, 1e-9, &what);
                }
                // The lead-out is the same thing backwards, on the other side.
                let back = sketch.reversed().compensated(side.opposite(), RADIUS, &options);
                assert_eq!(back.moves[back.moves.len() - 1].role, Role::LeadOut, "{what}");
                let ends: Vec<DVec2> = back
                    .moves
                    .iter()
                    .rev()
                    .take(expected.len() - 1)
                    .map(|one| one.curve.end())
                    .collect();
                for (point, expected) in ends.iter().zip(&expected) {
                    near_point(*point, *expected, 1e-9, &format!("{what}, lead-out"));
                }
                in_one_piece(&back, &format!("{what}, lead-out"));
            }
        }
    }
}

#[test]
fn textbook_leads_go_round_outside_corners_and_straight_into_inside_ones() {
    for method in [SplineMethod::Exact, SplineMethod::TypePoints] {
        judge(LeadStyle::Textbook, CornerStyle::Linear, method);
    }
}

#[test]
fn textbook_leads_go_round_by_an_arc_where_corners_are_arcs() {
    judge(LeadStyle::Textbook, CornerStyle::Arc, SplineMethod::Exact);
}

#[test]
fn perpendicular_leads_go_straight_beside_the_start() {
    for corner in [CornerStyle::Linear, CornerStyle::Arc] {
        judge(LeadStyle::Perpendicular, corner, SplineMethod::Exact);
    }
}

#[test]
fn intersection_leads_go_round_outside_corners_by_both_vectors() {
    for corner in [CornerStyle::Linear, CornerStyle::Arc] {
        judge(LeadStyle::Intersection, corner, SplineMethod::Exact);
    }
}

#[test]
fn extra_moves_go_from_the_contour_to_beside_it_at_right_angles() {
    for corner in [CornerStyle::Linear, CornerStyle::Arc] {
        judge(LeadStyle::ExtraMove, corner, SplineMethod::Exact);
    }
    // Along a tangent lead too, where the other kinds have no corner.
    let sketch = Sketch::open(p(0.0, 0.0), [line(p(20.0, 0.0))]).led(p(-10.0, 0.0), p(30.0, 0.0));
    let options = Options { lead: LeadStyle::ExtraMove, ..Options::default() };
    let path = sketch.compensated(Side::Left, RADIUS, &options);
    let ends: Vec<DVec2> = path.moves.iter().map(|step| step.curve.end()).collect();
    let expected = [p(0.0, 0.0), p(0.0, 2.0), p(20.0, 2.0), p(20.0, 0.0), p(30.0, 0.0)];
    assert_eq!(ends, expected, "onto the contour, off it, along it and back");
}

#[test]
fn a_lead_in_shorter_than_the_radius_is_told() {
    for (length, told) in [(1.9, true), (2.1, false)] {
        let sketch =
            Sketch::open(p(0.0, 0.0), [line(p(20.0, 0.0))]).led(p(0.0, -length), p(20.0, -10.0));
        let path = sketch.compensated(Side::Left, 2.0, &Options::default());
        let warned = path.diagnostics.iter().any(|d| d.severity >= Severity::Warning);
        assert_eq!(warned, told, "a lead-in of {length} mm: {:?}", path.diagnostics);
    }
}

#[test]
fn a_closed_contour_with_leads_begins_and_ends_beside_its_start() {
    let corners = [p(20.0, 0.0), p(20.0, 20.0), p(0.0, 20.0), p(0.0, 0.0)];
    let sketch = Sketch::closed(p(0.0, 0.0), corners.map(line)).led(p(-10.0, 0.0), p(0.0, -10.0));
    let path = sketch.compensated(Side::Right, 2.0, &Options::default());
    in_one_piece(&path, "leads of a square");
    near_point(path.moves[0].curve.start(), p(-10.0, 0.0), 1e-12, "lead-in");
    near_point(path.moves[0].curve.end(), p(0.0, -2.0), 1e-12, "along the first side");
    let last = &path.moves[path.moves.len() - 1];
    near_point(last.curve.start(), p(-2.0, 0.0), 1e-12, "along the last side");
    near_point(last.curve.end(), p(0.0, -10.0), 1e-12, "lead-out");
}
