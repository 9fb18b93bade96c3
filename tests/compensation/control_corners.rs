//! Outside corners as SINUMERIK's G450 with DISC and G451 have them, and corners that a program asks
//! for one by one, against closed forms.

use g41::compensation::{CornerStyle, Options, avoid, compensate};
use g41::contour::{
    Attributes, Contour, ContourBuilder, CornerWish, MoveCurve, Role, Side, Tool, ToolPath, Wish,
};
use g41::diagnostic::Origin;
use g41::geometry::Curve;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::corners::{Leg, corner};
use super::judge::{field_of, in_one_piece, samples};
use super::sketch::line;
use crate::common::{near, near_point, p};

const RADIUS: f64 = 2.5;
const SIDES: [Side; 2] = [Side::Left, Side::Right];

fn options(corner: CornerStyle) -> Options {
    Options { corner, ..Options::default() }
}

/// The path round a corner at the origin that turns away from the tool.
fn round(legs: [Leg; 2], side: Side, degrees: f64, style: CornerStyle) -> (Contour, ToolPath) {
    let turn = -side.sign() * degrees.to_radians();
    let sketch = corner(legs, 0.3, turn, RADIUS);
    (sketch.contour(), sketch.compensated(side, RADIUS, &options(style)))
}

fn transitions(path: &ToolPath) -> Vec<MoveCurve> {
    let inserted = path.moves.iter().filter(|step| step.role == Role::Transition);
    inserted.map(|step| step.curve).collect()
}

/// How far a point is from the line or circle on which a segment lies.
fn off_the_whole_curve(curve: &Curve, point: DVec2) -> f64 {
    match curve {
        Curve::Line(line) => (point - line.start()).perp_dot(line.tangent()).abs(),
        Curve::Arc(arc) => (point.distance(arc.center()) - arc.radius()).abs(),
        Curve::Spline(_) | Curve::Involute(_) => panic!("it does not go on"),
    }
}

#[test]
fn lines_and_arcs_run_on_to_where_they_meet() {
    let legs = [Leg::Line, Leg::Arc(14.0), Leg::Arc(-14.0)];
    for (first, second) in legs.iter().flat_map(|a| legs.iter().map(move |b| (*a, *b))) {
        for side in SIDES {
            for degrees in [5.0, 30.0, 60.0, 90.0, 99.9] {
                let what = format!("{first:?} {second:?} {side:?} {degrees}°");
                let (contour, path) =
                    round([first, second], side, degrees, CornerStyle::Intersection);
                in_one_piece(&path, &what);
                assert_eq!(path.moves.len(), 2, "{what}: nothing is inserted");
                let point = path.moves[0].curve.end();
                for segment in contour.segments() {
                    near(off_the_whole_curve(&segment.curve, point), RADIUS, 1e-9, &what);
                }
                let field = field_of(&contour);
                for point in samples(&path, 50) {
                    assert!(field.distance(point) >= RADIUS - 1e-9, "{what}: cuts at {point}");
                }
            }
        }
    }
}

#[test]
fn beyond_the_limit_angle_and_beside_splines_an_arc_goes_round() {
    for side in SIDES {
        for (legs, degrees, style) in [
            ([Leg::Line, Leg::Line], 100.1, CornerStyle::Intersection),
            ([Leg::Arc(14.0), Leg::Line], 150.0, CornerStyle::Intersection),
            ([Leg::Spline(16.0), Leg::Line], 40.0, CornerStyle::Intersection),
            ([Leg::Line, Leg::Spline(-16.0)], 90.0, CornerStyle::Intersection),
            ([Leg::Line, Leg::Line], 100.1, CornerStyle::Conic(50)),
            ([Leg::Line, Leg::Arc(14.0)], 60.0, CornerStyle::Conic(0)),
            ([Leg::Line, Leg::Line], 120.0, CornerStyle::Conic(100)),
        ] {
            let what = format!("{legs:?} {side:?} {degrees}° {style:?}");
            let (_, path) = round(legs, side, degrees, style);
            let (_, as_arc) = round(legs, side, degrees, CornerStyle::Arc);
            assert_eq!(path.moves, as_arc.moves, "{what}");
            let [MoveCurve::Arc(arc)] = transitions(&path)[..] else { panic!("{what}: one arc") };
            near_point(arc.center(), DVec2::ZERO, 1e-9, &what);
            near(arc.radius(), RADIUS, 1e-9, &what);
        }
    }
}

#[test]
fn a_conic_is_tangent_to_both_offsets_and_peaks_where_disc_says() {
    for side in SIDES {
        for degrees in [20.0_f64, 60.0, 90.0, 99.0] {
            for disc in [1, 25, 50, 99] {
                let what = format!("{side:?} {degrees}° DISC={disc}");
                let legs = [Leg::Line, Leg::Arc(14.0)];
                let (contour, path) = round(legs, side, degrees, CornerStyle::Conic(disc));
                in_one_piece(&path, &what);
                let conic = transitions(&path);
                let (first, last) = (&conic[0], &conic[conic.len() - 1]);
                for (a, b) in [
                    (first.tangent(0.0), contour.segments()[0].curve.tangent(1.0)),
                    (last.tangent(1.0), contour.segments()[1].curve.tangent(0.0)),
                ] {
                    near(a.perp_dot(b), 0.0, 1e-6, &what);
                }
                // The bisector of the corner meets the arc at r and the end tangents at
                // r / cos(φ/2); no point of the conic is farther off than on it.
                let way = 1.0 / (0.5 * degrees.to_radians()).cos() - 1.0;
                let peak = RADIUS * (1.0 + way * 0.01 * f64::from(disc));
                let mut farthest = 0.0_f64;
                for piece in &conic {
                    for k in 0..=200 {
                        let distance = piece.point(f64::from(k) / 200.0).length();
                        assert!(distance >= RADIUS - 1e-3, "{what}: {distance}");
                        farthest = farthest.max(distance);
                    }
                }
                near(farthest, peak, 1e-3, &what);
            }
        }
    }
}

#[test]
fn disc_of_100_is_the_intersection() {
    let legs = [Leg::Line, Leg::Arc(-14.0)];
    let (_, path) = round(legs, Side::Left, 70.0, CornerStyle::Conic(100));
    let (_, expected) = round(legs, Side::Left, 70.0, CornerStyle::Intersection);
    assert_eq!(path.moves, expected.moves, "nothing between the two");
}

/// Three sides of a square, the tool outside, and a wish for its second corner.
fn square(second: CornerWish) -> Contour {
    let mut builder = ContourBuilder::new(p(0.0, 0.0));
    let corners = [p(0.0, 20.0), p(20.0, 20.0), p(20.0, 0.0)];
    let wishes = [CornerWish::AsChosen, CornerWish::AsChosen, second];
    for ((index, to), corner) in (0..).zip(corners).zip(wishes) {
        let wish = Wish { corner, ..Wish::default() };
        builder.segment(line(to), Attributes { wish, ..Attributes::at(Origin::Segment(index)) });
    }
    builder.build(false).contour.expect("a contour")
}

#[test]
fn one_corner_may_be_wished_otherwise() {
    let tool = Tool::new(2.0, Side::Left).expect("a tool");
    let arc_at = |path: &ToolPath| {
        let [MoveCurve::Arc(arc)] = transitions(path)[..] else { panic!("one arc: {path:?}") };
        arc.center()
    };
    let linear = options(CornerStyle::Linear);
    let path = compensate(&square(CornerWish::Arc), tool, &linear);
    near_point(arc_at(&path), p(20.0, 20.0), 1e-9, "the second corner alone");
    let path = compensate(&square(CornerWish::Linear), tool, &options(CornerStyle::Arc));
    near_point(arc_at(&path), p(0.0, 20.0), 1e-9, "the first corner alone");
    let path = avoid(&square(CornerWish::Arc), tool, &linear);
    near_point(arc_at(&path), p(20.0, 20.0), 1e-9, "where gouges are avoided too");
    for wish in [CornerWish::Conic(100), CornerWish::Intersection] {
        let path = compensate(&square(wish), tool, &options(CornerStyle::Arc));
        near_point(arc_at(&path), p(0.0, 20.0), 1e-9, "the first corner alone");
        near_point(path.moves[2].curve.end(), p(22.0, 22.0), 1e-9, "the second, sharp");
    }
}
