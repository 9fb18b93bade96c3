//! The table: every pair of segments, every kind of transition, both sides, both corner styles.

use std::f64::consts::{FRAC_PI_2, PI};

use g41::compensation::{CornerStyle, Options};
use g41::contour::{Role, Side, ToolPath, TransitionKind};
use g41::geometry::Curve;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::brute::{Offset, inside_corner};
use super::corners::{Leg, corner};
use super::judge::{at_the_radius, field_of, field_of_path, in_one_piece, same_path};
use super::sketch::Sketch;
use crate::common::{near, near_point};

const RADIUS: f64 = 2.5;

/// Turns towards the tool side (negative: away) and the kind of their corners.
const TURNS: [(f64, TransitionKind); 11] = [
    (15.0, TransitionKind::Shortened),
    (60.0, TransitionKind::Shortened),
    (90.0, TransitionKind::Shortened),
    (120.0, TransitionKind::Shortened),
    (-5.0, TransitionKind::Elongated),
    (-45.0, TransitionKind::Elongated),
    (-90.0, TransitionKind::Elongated),
    (-90.001, TransitionKind::Inserted),
    (-120.0, TransitionKind::Inserted),
    (-150.0, TransitionKind::Inserted),
    (-178.0, TransitionKind::Inserted),
];

struct Case {
    legs: [Leg; 2],
    side: Side,
    corner: CornerStyle,
    turn: f64,
    kind: TransitionKind,
    sketch: Sketch,
    name: String,
}

impl Case {
    fn options(&self) -> Options {
        Options { corner: self.corner, ..Options::default() }
    }

    fn path(&self) -> ToolPath {
        self.sketch.compensated(self.side, RADIUS, &self.options())
    }
}

/// Calls `check` with each row of the table.
fn for_each(check: impl Fn(&Case)) {
    let mut cases = 0;
    for first in Leg::ALL {
        for second in Leg::ALL {
            for side in [Side::Left, Side::Right] {
                for corner_style in [CornerStyle::Linear, CornerStyle::Arc] {
                    for (degrees, kind) in TURNS {
                        let turn = side.sign() * f64::to_radians(degrees);
                        let legs = [first, second];
                        check(&Case {
                            legs,
                            side,
                            corner: corner_style,
                            turn,
                            kind,
                            sketch: corner(legs, 0.4, turn, RADIUS),
                            name: format!(
                                "{first:?} to {second:?}, {side:?}, {corner_style:?}, {degrees}°"
                            ),
                        });
                        cases += 1;
                    }
                }
            }
        }
    }
    assert_eq!(cases, 49 * 2 * 2 * TURNS.len(), "rows of the table");
}

/// Ends of the offset of a curve.
fn beside(curve: &Curve, t: f64, side: Side) -> DVec2 {
    curve.point(t) + curve.tangent(t).perp() * side.sign() * RADIUS
}

#[test]
fn the_turn_decides_the_kind_and_the_angle() {
    for_each(|case| {
        let path = case.path();
        assert_eq!(path.transitions.len(), 1, "{}: transitions", case.name);
        let transition = &path.transitions[0];
        assert_eq!(transition.kind, case.kind, "{}", case.name);
        let alpha = PI + case.side.sign() * case.turn;
        near(transition.angle, alpha, 1e-9, &format!("{}: α", case.name));
        near_point(transition.corner, DVec2::ZERO, 1e-9, &case.name);
    });
}

#[test]
fn every_path_is_in_one_piece_from_beside_the_start_to_beside_the_end() {
    for_each(|case| {
        let path = case.path();
        in_one_piece(&path, &case.name);
        let contour = case.sketch.contour();
        let (first, last) = (&contour.segments()[0].curve, &contour.segments()[1].curve);
        let ends = (path.moves[0].curve.start(), path.moves[path.moves.len() - 1].curve.end());
        near_point(ends.0, beside(first, 0.0, case.side), 1e-9, &case.name);
        near_point(ends.1, beside(last, 1.0, case.side), 1e-9, &case.name);
    });
}

#[test]
fn every_path_keeps_the_distance_of_the_tool() {
    for_each(|case| {
        let contour = case.sketch.contour();
        let field = field_of(&contour);
        if case.kind == TransitionKind::Inserted {
            // Doubling back, two segments may bend towards each other: a bottleneck, which is not
            // this table's business.
            let offset =
                |i: usize| Offset::new(&contour.segments()[i].curve, case.side, RADIUS, 64).points;
            let nearest = [offset(0), offset(1)].concat().into_iter().map(|p| field.distance(p));
            if nearest.fold(f64::INFINITY, f64::min) < RADIUS - 1e-9 {
                return;
            }
        }
        at_the_radius(&case.path(), &field, RADIUS, case.corner, 0.001, &case.name);
    });
}

#[test]
fn inserted_moves_are_as_many_as_in_the_table_of_a_control() {
    // Beckhoff TwinCAT 3 CNC (ISG kernel), "Generate compensation blocks": blocks inserted with
    // G25 (linear) elongated and inserted; one circular block with G26; a spline counts as CIR.
    for_each(|case| {
        let moves = case.path().moves;
        let inserted = moves.iter().filter(|one| one.role == Role::Transition).count();
        let curved = case.legs.iter().filter(|leg| !leg.is_straight()).count();
        let expected = match (case.kind, case.corner) {
            (TransitionKind::Shortened, _) => 0,
            (TransitionKind::Elongated, CornerStyle::Linear) => curved,
            (TransitionKind::Inserted, CornerStyle::Linear) => curved + 1,
            _ => 1,
        };
        assert_eq!(inserted, expected, "{}", case.name);
    });
}

#[test]
fn outside_corners_have_the_vertices_of_their_construction() {
    for_each(|case| {
        if case.kind == TransitionKind::Shortened {
            return;
        }
        let (t1, t2) = (DVec2::from_angle(0.4), DVec2::from_angle(0.4 + case.turn));
        let (n1, n2) = (t1.perp() * case.side.sign(), t2.perp() * case.side.sign());
        // On the bisector, r over the cosine of half the turn away.
        let v = (n1 + n2).normalize() * RADIUS / (0.5 * case.turn).cos();
        let mut expected = vec![("P", DVec2::ZERO), ("N1", n1 * RADIUS), ("N2", n2 * RADIUS)];
        match (case.corner, case.kind) {
            (CornerStyle::Linear, TransitionKind::Elongated) => expected.push(("V", v)),
            (CornerStyle::Linear, _) => {
                expected.push(("A1", (n1 + t1) * RADIUS));
                expected.push(("A2", (n2 - t2) * RADIUS));
            }
            _ => {}
        }
        let path = case.path();
        let construction = &path.transitions[0].construction;
        assert_eq!(construction.len(), expected.len(), "{}: {construction:?}", case.name);
        let field = field_of_path(&path);
        for ((name, point), (expected_name, expected_point)) in construction.iter().zip(expected) {
            assert_eq!(*name, expected_name, "{}", case.name);
            near_point(*point, expected_point, 1e-9, &format!("{}: {name}", case.name));
            let passed = match case.corner {
                CornerStyle::Linear => ["V", "A1", "A2"].contains(name),
                _ => ["N1", "N2"].contains(name),
            };
            if passed {
                near(field.distance(*point), 0.0, 1e-8, &format!("{}: {name}", case.name));
            }
        }
    });
}

#[test]
fn inside_corners_are_cut_where_the_offsets_cross_last() {
    for_each(|case| {
        if case.kind != TransitionKind::Shortened {
            return;
        }
        let contour = case.sketch.contour();
        let offset = |i: usize| Offset::new(&contour.segments()[i].curve, case.side, RADIUS, 4096);
        let brute = inside_corner(&offset(0), &offset(1), case.side)
            .unwrap_or_else(|| panic!("{}: the offsets do not cross", case.name));
        let path = case.path();
        let found = path.transitions[0].construction.iter().find(|(name, _)| *name == "V");
        let (_, v) = found.unwrap_or_else(|| panic!("{}: no V", case.name));
        // Chords of 1/4096 of 30 mm bend away by 1e-6 at most; the tolerance of splines is 1e-3.
        let slack =
            2e-5 + if case.legs.iter().any(|l| matches!(l, Leg::Spline(_))) { 2e-3 } else { 0.0 };
        near_point(*v, brute.point, slack, &case.name);
        near(field_of_path(&path).distance(*v), 0.0, 1e-8, &format!("{}: V", case.name));
        assert!(path.gouges.is_empty(), "{}: {:?}", case.name, path.gouges);
    });
}

#[test]
fn at_a_right_angle_elongated_and_inserted_are_one() {
    for legs in [[Leg::Line, Leg::Line], [Leg::Line, Leg::Arc(9.0)], [Leg::Spline(16.0), Leg::Line]]
    {
        let options = Options::default();
        let path =
            |turn: f64| corner(legs, 0.0, turn, RADIUS).compensated(Side::Left, RADIUS, &options);
        let (elongated, inserted) = (path(-FRAC_PI_2), path(-FRAC_PI_2 - 1e-7));
        assert_eq!(elongated.transitions[0].kind, TransitionKind::Elongated, "{legs:?}");
        assert_eq!(inserted.transitions[0].kind, TransitionKind::Inserted, "{legs:?}");
        same_path(&elongated, &inserted, 1e-5, &format!("{legs:?}"));
    }
}

#[test]
fn the_table_holds_through_every_symmetry() {
    for_each(|case| {
        let (path, options, name) = (case.path(), case.options(), &case.name);
        let mapped = |map: &dyn Fn(DVec2) -> DVec2, path: &ToolPath| -> Vec<DVec2> {
            super::judge::samples(path, 7).into_iter().map(map).collect()
        };
        let agree = |image: Vec<DVec2>, other: &ToolPath, slack: f64, symmetry: &str| {
            let field = field_of_path(other);
            for point in image {
                let off = field.distance(point);
                assert!(off <= slack, "{name}, {symmetry}: {point} is {off:e} off");
            }
            let kinds = |p: &ToolPath| p.transitions.iter().map(|t| t.kind).collect::<Vec<_>>();
            assert_eq!(kinds(&path), kinds(other), "{name}, {symmetry}");
        };
        let mirror = |p: DVec2| DVec2::new(-p.x, p.y);
        let mirrored = case.sketch.mapped(true, mirror);
        let other = mirrored.compensated(case.side.opposite(), RADIUS, &options);
        agree(mapped(&mirror, &path), &other, 1e-8, "mirrored");

        let turned = |p: DVec2| DVec2::from_angle(1.234).rotate(p) + DVec2::new(70.0, -30.0);
        let other = case.sketch.mapped(false, turned).compensated(case.side, RADIUS, &options);
        agree(mapped(&turned, &path), &other, 1e-8, "turned and moved");

        let scaled = |p: DVec2| p * 10.0;
        let coarser = Options { tolerance: 0.01, ..options };
        let other =
            case.sketch.mapped(false, scaled).compensated(case.side, 10.0 * RADIUS, &coarser);
        agree(mapped(&scaled, &path), &other, 1e-7, "scaled");

        // A spline's pieces may be cut elsewhere on the way back.
        let splines = case.legs.iter().any(|leg| matches!(leg, Leg::Spline(_)));
        let slack = if splines { 2e-3 } else { 1e-8 };
        let other = case.sketch.reversed().compensated(case.side.opposite(), RADIUS, &options);
        agree(mapped(&|p| p, &path), &other, slack, "reversed");

        for index in 0..2 {
            let Some(split) = case.sketch.split(index, 0.5) else { continue };
            let other = split.compensated(case.side, RADIUS, &options);
            agree(mapped(&|p| p, &path), &other, 1e-8, "split");
        }
    });
}
