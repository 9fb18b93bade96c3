//! Tracks: joints by the frames on either side, deviations by brute force.

use std::f64::consts::{FRAC_PI_2, PI};

use g41::contour::{Move, MoveCurve, Plane, Role};
use g41::diagnostic::Origin;
use g41::geometry::{Arc, Cubic, Line, Parameter, Spline, SplineEnds};
use g41::motion::{CornerCurve, CurvatureSteps, Joint, Limits, Piece, Placed, pieces, track};
use glam::{DVec2, DVec3};

use crate::common::random::Random;
use crate::common::{near, p};

fn along(curve: MoveCurve) -> Move {
    let origin = Origin::Segment(0);
    let (role, plane) = (Role::Free, Plane::Xy);
    Move { curve, role, rapid: false, feed: None, plane, heights: [0.0; 2], origin }
}

fn line(from: DVec2, to: DVec2) -> Move {
    along(MoveCurve::Line(Line::new(from, to).expect("two points")))
}

fn arc(from: DVec2, center: DVec2, sweep: f64) -> Move {
    along(MoveCurve::Arc(Arc::from_sweep(from, center, sweep).expect("an arc")))
}

/// A line, an arc of `radius` that touches it and turns by `sweep`, and a line on.
fn slot(radius: f64, sweep: f64) -> Vec<Move> {
    let side = sweep.signum();
    let center = p(50.0, side * radius);
    let bend = Arc::from_sweep(p(50.0, 0.0), center, sweep).expect("an arc");
    let end = bend.end();
    let on = end + DVec2::from_angle(sweep) * 30.0;
    vec![line(p(0.0, 0.0), p(50.0, 0.0)), along(MoveCurve::Arc(bend)), line(end, on)]
}

fn wave() -> Vec<Move> {
    let mut points = Vec::new();
    for i in 0..12 {
        let t = f64::from(i) * 0.6;
        points.push(p(8.0 * t, 10.0 * (1.3 * t).sin() + f64::from(i % 3)));
    }
    let spline = Spline::through(points, SplineEnds::NATURAL, Parameter::Chord).expect("a spline");
    spline.pieces().iter().map(|cubic| along(MoveCurve::Cubic(*cubic))).collect()
}

/// The programmed path, with places along each of its pieces.
struct Dense(Vec<(Piece, Vec<DVec3>)>);

const PLACES: usize = 300;

impl Dense {
    fn of(moves: &[Move]) -> Self {
        let mut dense = Vec::new();
        for piece in moves.iter().flat_map(pieces) {
            let length = piece.length();
            let at = |i: usize| piece.frame(length * i as f64 / PLACES as f64).point;
            let places = (0..=PLACES).map(at).collect();
            dense.push((piece, places));
        }
        Self(dense)
    }

    fn ends(&self) -> [DVec3; 2] {
        [self.0[0].1[0], self.0[self.0.len() - 1].1[PLACES]]
    }

    /// The distance of a point: of the nearest place of each piece, and then within the two stretches
    /// beside it by thirds.
    fn distance(&self, point: DVec3) -> f64 {
        let mut least = f64::INFINITY;
        for (piece, places) in &self.0 {
            if let Piece::Straight(line) = piece {
                let s = (point - line.start).dot(line.tangent).clamp(0.0, line.length);
                least = least.min(line.frame(s).point.distance(point));
                continue;
            }
            let mut nearest = 0;
            for (i, place) in places.iter().enumerate() {
                if place.distance(point) < places[nearest].distance(point) {
                    nearest = i;
                }
            }
            let spacing = piece.length() / PLACES as f64;
            let [mut from, mut to] = [
                nearest.saturating_sub(1) as f64 * spacing,
                (nearest + 1).min(PLACES) as f64 * spacing,
            ];
            if places[nearest].distance(point) - spacing > least {
                continue;
            }
            for _ in 0..40 {
                let third = (to - from) / 3.0;
                let away = |s: f64| piece.frame(s).point.distance(point);
                if away(from + third) < away(to - third) { to -= third } else { from += third }
            }
            least = least.min(piece.frame(f64::midpoint(from, to)).point.distance(point));
        }
        least
    }
}

/// Counts of what a track is made of, and the largest distance between it and its moves [mm].
#[derive(Debug, Default)]
struct Found {
    corners: usize,
    stops: usize,
    steps: usize,
    deviation: f64,
}

/// Examines a track: that pieces follow each other as their joints say, that it runs from the start of
/// the moves to their end, and how far it strays.
fn examine(moves: &[Move], limits: &Limits, name: &str) -> Found {
    let track = track(moves, limits);
    let mut found = Found::default();
    for pair in track.windows(2) {
        let (end, start) = (pair[0].piece.frame(pair[0].piece.length()), pair[1].piece.frame(0.0));
        let gap = end.point.distance(start.point);
        assert!(gap < 1e-9, "{name}: a gap of {gap:e}");
        assert!(pair[0].block <= pair[1].block, "{name}: blocks in order");
        let turn = end.tangent.distance(start.tangent);
        let bend = end.curvature.distance(start.curvature);
        let change = end.sharpness.distance(start.sharpness);
        match pair[0].end {
            Joint::Smooth => {
                assert!(turn < 2e-9, "{name}: a smooth turn by {turn:e}");
                let size = 1.0 + end.curvature.length_squared();
                // Coordinates of 1e2 mm are rounded to 1e-14, which a short piece divides by powers
                // of its length.
                let length = pair[0].piece.length().min(pair[1].piece.length());
                let rounding = 1e-13 / (length * length);
                assert!(
                    bend < 2e-8 * size + rounding,
                    "{name}: a smooth step of curvature by {bend:e}"
                );
                let size = size * size;
                assert!(
                    change < 1e-5 * size + rounding / length,
                    "{name}: a smooth step of sharpness by {change:e}"
                );
            }
            Joint::Step { curvature, sharpness } => {
                assert!(turn < 2e-9, "{name}: a step turns by {turn:e}");
                near(bend, curvature, 1e-9 + 1e-6 * curvature, name);
                near(change, sharpness, 1e-6 + 1e-6 * sharpness, name);
                found.steps += 1;
            }
            Joint::Stop => found.stops += 1,
        }
    }
    let first = &track[0].piece;
    let last = &track[track.len() - 1];
    assert_eq!(last.end, Joint::Stop, "{name}: rests at its end");
    let dense = Dense::of(moves);
    let [from, to] = dense.ends();
    let start = first.frame(0.0).point.distance(from);
    let end = last.piece.frame(last.piece.length()).point.distance(to);
    assert!(start < 1e-9 && end < 1e-9, "{name}: misses its ends by {start:e} and {end:e}");
    for placed in &track {
        let piece = &placed.piece;
        if placed.is_corner() {
            found.corners += 1;
            let (before, after) = around(placed);
            let mut nearest = f64::INFINITY;
            for i in 0..=200 {
                let point = piece.frame(piece.length() * f64::from(i) / 200.0).point;
                if i % 4 == 0 {
                    found.deviation = found.deviation.max(dense.distance(point));
                }
                nearest = nearest.min(point.distance(before));
            }
            assert!(before.distance(after) < 1e-9, "{name}: legs meet");
            // The joint that it rounds lies on the path, within 1 % of half a place's distance.
            let spacing = piece.length() / 400.0;
            found.deviation = found.deviation.max(nearest - spacing.min(0.01 * nearest));
        }
    }
    found
}

/// The joint that a corner rounds, from both of its legs.
fn around(corner: &Placed) -> (DVec3, DVec3) {
    let [incoming, outgoing] = corner.legs().expect("a corner has legs");
    let length = corner.piece.length();
    let (start, end) = (corner.piece.frame(0.0), corner.piece.frame(length));
    assert!(incoming.frame(0.0).point.distance(start.point) < 1e-9, "the corner begins on its leg");
    assert!(incoming.frame(0.0).tangent.distance(start.tangent) < 1e-9, "and in its direction");
    let leg = outgoing.frame(outgoing.length());
    assert!(leg.point.distance(end.point) < 1e-9, "and ends on the other");
    assert!(leg.tangent.distance(end.tangent) < 1e-9, "in its direction");
    (incoming.frame(incoming.length()).point, outgoing.frame(0.0).point)
}

#[test]
fn a_square_has_a_corner_at_each_vertex_at_the_deviation() {
    let corners = [p(0.0, 0.0), p(50.0, 0.0), p(50.0, 50.0), p(0.0, 50.0), p(0.0, 0.0)];
    let mut moves: Vec<Move> = corners.windows(2).map(|pair| line(pair[0], pair[1])).collect();
    moves.push(line(p(0.0, 0.0), p(25.0, 0.0)));
    for corner in [CornerCurve::Ph13, CornerCurve::Ph11, CornerCurve::Ph9, CornerCurve::Ph5] {
        let limits = Limits { corner, ..Limits::default() };
        let found = examine(&moves, &limits, "square");
        assert_eq!((found.corners, found.stops), (4, 0), "{corner:?}: {found:?}");
        assert_eq!(found.steps, if corner == CornerCurve::Ph5 { 8 } else { 0 }, "{corner:?}");
        near(found.deviation, 0.05, 5.1e-4, "from the corner");
    }
}

#[test]
fn short_legs_are_shared_and_never_overlap() {
    // Steps of a staircase far shorter than the legs that the deviation allows.
    let mut moves = Vec::new();
    let mut at = p(0.0, 0.0);
    let mut random = Random::new(7);
    for i in 0..200 {
        let way = if i % 2 == 0 { p(1.0, 0.0) } else { p(0.0, 1.0) };
        let next = at + way * random.within(0.01, 0.3);
        moves.push(line(at, next));
        at = next;
    }
    let limits = Limits { corner_deviation: 0.2, fit: false, ..Limits::default() };
    let found = examine(&moves, &limits, "staircase");
    assert_eq!((found.corners, found.stops), (199, 0), "{found:?}");
    assert!(found.deviation <= 0.2, "{found:?}");
    let whole: f64 = track(&moves, &limits).iter().map(|placed| placed.piece.length()).sum();
    let programmed: f64 = moves.iter().map(|one| one.curve.length()).sum();
    assert!(whole < programmed && whole > 0.7 * programmed, "{whole} of {programmed}");
}

#[test]
fn a_leg_takes_what_its_neighbour_leaves() {
    // Wanted are 0.17 mm and, at the gentle corner, 2.4 mm of a line of 2 mm: not half of it.
    let gentle = DVec2::from_angle(FRAC_PI_2 + 0.133);
    let moves = [
        line(p(0.0, 0.0), p(50.0, 0.0)),
        line(p(50.0, 0.0), p(50.0, 2.0)),
        line(p(50.0, 2.0), p(50.0, 2.0) + gentle * 50.0),
    ];
    let limits = Limits { fit: false, corner: CornerCurve::Ph13, ..Limits::default() };
    let track = track(&moves, &limits);
    let corners: Vec<_> = track.iter().filter_map(Placed::legs).collect();
    let [sharp, gentle] = [&corners[0][1], &corners[1][0]].map(Piece::length);
    near(sharp, 0.05 * 3.494_66, 1e-5, "leg of the right angle");
    near(gentle, 2.0 - sharp, 1e-12, "leg of the gentle corner");
}

#[test]
fn a_line_runs_into_an_arc_without_a_step() {
    for radius in [0.2, 2.0, 10.0, 100.0] {
        for sweep in [0.5, 1.5, -1.5, -3.0] {
            let moves = slot(radius, sweep);
            let name = format!("radius {radius}, sweep {sweep}");
            let found = examine(&moves, &Limits::default(), &name);
            // An arc of 0.1 mm is fitted with its lines, all in one.
            let corners = if radius * sweep.abs() < 0.15 { 0 } else { 2 };
            let meant = (corners, 0, 0);
            assert_eq!((found.corners, found.stops, found.steps), meant, "{name}: {found:?}");
            assert!(found.deviation <= 0.05, "{name}: {found:?}");
            for placed in track(&moves, &Limits::default()) {
                for i in 0..=100 {
                    let frame = placed.piece.frame(placed.piece.length() * f64::from(i) / 100.0);
                    let bend = frame.curvature.length() * radius;
                    assert!(bend < 1.12, "{name}: curvature swings to {bend} of the arc's");
                }
            }
        }
    }
}

#[test]
fn steps_of_curvature_are_treated_as_the_user_says() {
    let moves = slot(10.0, 1.5);
    for (curvature_steps, stops, steps) in
        [(CurvatureSteps::Slow, 0, 2), (CurvatureSteps::Stop, 2, 0)]
    {
        let limits = Limits { curvature_steps, ..Limits::default() };
        let found = examine(&moves, &limits, "slot");
        assert_eq!((found.corners, found.stops, found.steps), (0, stops, steps), "{found:?}");
        let track = track(&moves, &limits);
        if let Joint::Step { curvature, sharpness } = track[0].end {
            near(curvature, 0.1, 1e-12, "that of the arc");
            near(sharpness, 0.01, 1e-12, "its square");
        }
    }
}

#[test]
fn corners_with_arcs_are_rounded_within_the_deviation() {
    for turn in [-2.6, -1.5, -0.7, -0.01, 1e-5, 0.3, 1.2, 2.5] {
        for radius in [0.3, 5.0, 40.0] {
            for sweep in [1.0, -1.0] {
                let corner = p(50.0, 0.0);
                let out = DVec2::from_angle(turn + FRAC_PI_2 * f64::signum(sweep)) * radius;
                let bend = Arc::from_sweep(corner, corner + out, sweep).expect("an arc");
                let moves = [line(p(0.0, 0.0), corner), along(MoveCurve::Arc(bend))];
                let back = [along(MoveCurve::Arc(bend.reversed())), line(corner, p(0.0, 0.0))];
                for (moves, way) in [(moves, "to"), (back, "back")] {
                    let name = format!("{way}: turn {turn}, radius {radius}, sweep {sweep}");
                    let found = examine(&moves, &Limits::default(), &name);
                    assert_eq!((found.corners, found.stops), (1, 0), "{name}: {found:?}");
                    assert!(found.deviation <= 0.05, "{name}: {found:?}");
                }
            }
        }
    }
}

#[test]
fn splines_run_through_their_type_points_without_a_step_of_jerk() {
    let moves = wave();
    let found = examine(&moves, &Limits::default(), "wave");
    assert_eq!((found.corners, found.stops, found.steps), (10, 0, 0), "{found:?}");
    assert!(found.deviation <= 0.05, "{found:?}");
    let limits = Limits { curvature_steps: CurvatureSteps::Slow, ..Limits::default() };
    let found = examine(&moves, &limits, "wave as it is");
    assert_eq!((found.corners, found.stops, found.steps), (0, 0, 10), "{found:?}");
}

#[test]
fn what_cannot_be_rounded_stops() {
    let there = line(p(0.0, 0.0), p(50.0, 0.0));
    let back = line(p(50.0, 0.0), p(0.0, 0.0));
    let sharp = line(p(50.0, 0.0), p(0.0, 4.0));
    for (moves, name) in [([there, back], "reversal"), ([there, sharp], "a turn of 175°")] {
        let found = examine(&moves, &Limits::default(), name);
        assert_eq!((found.corners, found.stops), (0, 1), "{name}: {found:?}");
    }
    let bend = Arc::from_sweep(p(0.0, 0.0), p(0.0, 10.0), 1.0).expect("an arc");
    let moves = [along(MoveCurve::Arc(bend)), along(MoveCurve::Arc(bend.reversed()))];
    let found = examine(&moves, &Limits::default(), "an arc and back");
    assert_eq!((found.corners, found.stops), (0, 1), "{found:?}");
    for limits in [
        Limits { exact_stop: true, ..Limits::default() },
        Limits { corner_deviation: 0.0, ..Limits::default() },
    ] {
        let corner = [there, line(p(50.0, 0.0), p(50.0, 50.0))];
        let found = examine(&corner, &limits, "exact");
        assert_eq!((found.corners, found.stops), (0, 1), "{found:?}");
    }
    let cusp = Cubic::new(p(0.0, 0.0), p(10.0, 10.0), p(0.0, 10.0), p(10.0, 0.0));
    let found = examine(&[along(MoveCurve::Cubic(cusp))], &Limits::default(), "cusp");
    assert_eq!((found.corners, found.stops), (0, 1), "{found:?}");
}

#[test]
fn moves_that_do_not_follow_are_joined_by_a_rapid_move_at_rest() {
    let moves = [
        line(p(0.0, 0.0), p(10.0, 0.0)),
        line(p(20.0, 5.0), p(30.0, 5.0)),
        line(p(30.0, 5.0), p(40.0, 5.0)),
    ];
    let track = track(&moves, &Limits { fit: false, ..Limits::default() });
    let ends: Vec<_> = track.iter().map(|placed| (placed.rapid, placed.end)).collect();
    let expected =
        [(false, Joint::Stop), (true, Joint::Stop), (false, Joint::Smooth), (false, Joint::Stop)];
    assert_eq!(ends, expected, "line, rapid, line and its continuation");
    near(track[1].piece.length(), 125.0_f64.sqrt(), 1e-12, "the way between");
}

#[test]
fn feeds_and_blocks_go_with_their_moves() {
    let mut moves = [
        line(p(0.0, 0.0), p(10.0, 0.0)),
        line(p(10.0, 0.0), p(10.0, 10.0)),
        along(MoveCurve::Vertical(p(10.0, 10.0))),
        along(MoveCurve::Vertical(p(10.0, 10.0))),
    ];
    moves[0].feed = Some(20.0);
    moves[1].feed = Some(10.0);
    moves[2].heights = [0.0, 0.0];
    moves[3].heights = [0.0, -5.0];
    moves[3].rapid = true;
    moves[3].feed = Some(10.0);
    let track = track(&moves, &Limits::default());
    let found: Vec<_> = track.iter().map(|p| (p.block, p.feed, p.rapid, p.is_corner())).collect();
    let expected = [
        (0, 20.0, false, false),
        (0, 10.0, false, true),
        (1, 10.0, false, false),
        (1, 10.0, false, true),
        (3, f64::INFINITY, true, false),
    ];
    assert_eq!(found, expected, "block, feed, rapid, corner");
}

/// A path of lines, arcs and cubics of any size, plane and height, joined at any angle.
fn random_path(random: &mut Random) -> Vec<Move> {
    let plane = [Plane::Xy, Plane::Zx, Plane::Yz][random.index(3)];
    let mut at = random.point(20.0);
    let mut height = 0.0;
    let mut heading = random.direction();
    let mut moves = Vec::new();
    for _ in 0..2 + random.index(8) {
        let size = 10.0_f64.powf(random.within(-2.0, 1.5));
        // Tangent as often as not.
        if random.coin() {
            heading = heading.rotate(DVec2::from_angle(random.within(-PI, PI)));
        }
        let mut one = match random.index(3) {
            0 => line(at, at + heading * size),
            1 => arc(at, at + heading.perp() * (size * random.sign()), random.within(-3.0, 3.0)),
            _ => {
                let control = at + heading * random.within(0.2, 0.5) * size;
                let end = at + heading * size + random.point(0.5 * size);
                let before = end - random.direction() * random.within(0.2, 0.5) * size;
                along(MoveCurve::Cubic(Cubic::new(at, control, before, end)))
            }
        };
        let next = if random.coin() { height } else { height + random.within(-1.0, 1.0) * size };
        one.plane = plane;
        one.heights = [height, next];
        at = one.curve.end();
        heading = one.curve.tangent(1.0);
        height = next;
        moves.push(one);
    }
    moves
}

#[test]
fn random_paths_keep_every_promise() {
    let mut random = Random::new(2026);
    let (mut corners, mut stops, mut steps) = (0, 0, 0);
    for case in 0..120 {
        let moves = random_path(&mut random);
        let deviation = [0.05, 0.002, 0.5][random.index(3)];
        let limits = Limits { corner_deviation: deviation, ..Limits::default() };
        let found = examine(&moves, &limits, &format!("case {case}"));
        assert!(found.deviation <= 1.001 * deviation + 1e-6, "case {case}: {found:?}");
        corners += found.corners;
        stops += found.stops;
        steps += found.steps;
    }
    let counts = [corners, stops, steps];
    assert!(corners > 350 && (10..100).contains(&stops) && steps < 10, "{counts:?}");
}

#[test]
fn a_turned_mirrored_and_scaled_path_has_the_track_turned_mirrored_and_scaled() {
    let mut random = Random::new(11);
    for case in 0..40 {
        let moves = random_path(&mut random);
        let turn = random.direction();
        let scale = random.within(0.5, 2.0);
        let mirror = |point: DVec2| turn.rotate(DVec2::new(point.x, -point.y)) * scale;
        let other: Vec<Move> = moves
            .iter()
            .map(|one| {
                let curve = match one.curve {
                    MoveCurve::Line(line) => MoveCurve::Line(
                        Line::new(mirror(line.start()), mirror(line.end())).expect("a line"),
                    ),
                    MoveCurve::Arc(arc) => {
                        let [start, center] = [arc.start(), arc.center()].map(mirror);
                        MoveCurve::Arc(Arc::from_sweep(start, center, -arc.sweep()).expect("arc"))
                    }
                    MoveCurve::Cubic(cubic) => {
                        let [a, b, c, d] = cubic.points.map(mirror);
                        MoveCurve::Cubic(Cubic::new(a, b, c, d))
                    }
                    other => other,
                };
                Move { curve, heights: one.heights.map(|height| height * scale), ..*one }
            })
            .collect();
        // Fitting ends its search where the gain is small, not at the same digits.
        let limits = Limits { fit: false, ..Limits::default() };
        let scaled = Limits {
            velocity: scale * limits.velocity,
            jerk: scale * limits.jerk,
            corner_deviation: scale * limits.corner_deviation,
            ..limits
        };
        let (here, there) = (track(&moves, &limits), track(&other, &scaled));
        assert_eq!(here.len(), there.len(), "case {case}");
        for (i, (one, other)) in here.iter().zip(&there).enumerate() {
            let lengths = [one.piece.length() * scale, other.piece.length()];
            near(lengths[0], lengths[1], 1e-6 * lengths[1], &format!("case {case}, piece {i}"));
            assert_eq!(one.is_corner(), other.is_corner(), "case {case}, piece {i}");
        }
    }
}
