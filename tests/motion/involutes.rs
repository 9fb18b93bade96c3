//! Involutes by arc length against their closed form, and joined to lines.

use g41::contour::{MoveCurve, Plane};
use g41::geometry::{Involute, Line};
use g41::motion::{Joint, Limits, Piece, Unwound, track};
use glam::{DVec2, DVec3};

use crate::common::{near, p};
use crate::shapes;

/// The end of a thread unwound by `roll` [rad] from the circle of `radius` about the origin, its foot
/// starting at the angle 0.
fn thread(radius: f64, roll: f64) -> DVec2 {
    let u = DVec2::from_angle(roll);
    radius * (u - roll * u.perp())
}

/// The involute of a circle about the origin between two rolls.
fn involute(radius: f64, [from, to]: [f64; 2]) -> Involute {
    let ends = [thread(radius, from), thread(radius, to)];
    let clockwise = to < from;
    Involute::new(ends[0], ends[1], p(0.0, 0.0), radius, clockwise, 1e-6).expect("an involute")
}

#[test]
fn feed_is_constant_to_1e_12() {
    let (radius, rolls) = (10.0, [0.3, 2.5]);
    for rolls in [rolls, [rolls[1], rolls[0]]] {
        let piece = Unwound::of_involute(&involute(radius, rolls), Plane::Xy, [0.0, 0.0]);
        let piece = Piece::Unwound(piece);
        let length = 0.5 * radius * (rolls[1] * rolls[1] - rolls[0] * rolls[0]);
        near(piece.length() / length.abs(), 1.0, 1e-12, "length R φ²/2");
        for i in 0..=1000 {
            let part = f64::from(i) / 1000.0;
            // The roll at that part of the length.
            let roll = (rolls[0] * rolls[0] + 2.0 * part * length / radius).sqrt();
            let found = piece.frame(part * piece.length()).point.truncate();
            let slip = found.distance(thread(radius, roll));
            assert!(slip < 1e-12 * piece.length(), "{rolls:?} at {part}: slips by {slip:e}");
        }
    }
}

#[test]
fn frames_are_the_derivatives_of_the_points() {
    for rolls in [[0.4, 2.0], [2.0, 0.4]] {
        let curve = involute(5.0, rolls);
        let piece = Piece::Unwound(Unwound::of_involute(&curve, Plane::Zx, [1.0, 4.0]));
        let h = 1e-4;
        for i in 1..30 {
            let s = piece.length() * f64::from(i) / 30.0;
            let [a, here, b] = [s - h, s, s + h].map(|s| piece.frame(s));
            let check = |found: DVec3, said: DVec3, order: &str| {
                let error = found.distance(said) / (0.01 + said.length());
                assert!(error < 1e-5, "{rolls:?} at {s}: {order} {found} and {said}");
            };
            check((b.point - a.point) / (2.0 * h), here.tangent, "tangent");
            check((b.tangent - a.tangent) / (2.0 * h), here.curvature, "curvature");
            check((b.curvature - a.curvature) / (2.0 * h), here.sharpness, "sharpness");
        }
    }
}

#[test]
fn a_line_joins_an_involute_even_on_its_base_circle() {
    // The thread leaves the circle across it; curvature is not bounded there.
    for (least, corner) in [(0.0, false), (0.05, false), (0.5, false), (0.5, true)] {
        let curve = involute(10.0, [least, 1.5]);
        let along = if corner { DVec2::Y } else { curve.tangent(0.0) };
        let line = Line::new(curve.start() - along * 8.0, curve.start()).expect("a line");
        let moves =
            [shapes::along(MoveCurve::Line(line)), shapes::along(MoveCurve::Involute(curve))];
        let track = track(&moves, &Limits::default());
        let ends: Vec<_> = track.iter().map(|placed| placed.end).collect();
        let what = format!("from a roll of {least}, corner {corner}");
        assert_eq!(ends, [Joint::Smooth, Joint::Smooth, Joint::Stop], "{what}");
        let blend = &track[1].piece;
        for pair in track.windows(2) {
            let [before, after] =
                [pair[0].piece.frame(pair[0].piece.length()), pair[1].piece.frame(0.0)];
            near(before.point.distance(after.point), 0.0, 1e-12, &what);
            near(before.tangent.distance(after.tangent), 0.0, 1e-10, &what);
            near(before.curvature.distance(after.curvature), 0.0, 1e-7, &what);
            near(before.sharpness.distance(after.sharpness), 0.0, 1e-5, &what);
        }
        let mut most = 0.0_f64;
        let mut bend = 0.0_f64;
        for i in 0..=200 {
            let frame = blend.frame(blend.length() * f64::from(i) / 200.0);
            let point = frame.point.truncate();
            let away = line.nearest(point).distance.min(curve.nearest(point).distance);
            most = most.max(away);
            bend = bend.max(frame.curvature.length());
        }
        assert!(most <= 0.05, "{what}: strays by {most}");
        assert!(bend < 4.0, "{what}: bends by {bend}");
    }
}
