//! Pieces by arc length: constant feed on lines, arcs, helices, spirals and cubics.

use std::f64::consts::PI;

use g41::contour::Plane;
use g41::geometry::{Arc, Cubic};
use g41::motion::{ByLength, Helix, Piece, Straight};
use glam::{DVec2, DVec3};

use crate::common::{near, p};

/// The largest relative error of the feed between steps of `step` [mm], with the chord of each step
/// taken for its arc: `1 + κ² step²/24` and the next term of the series.
fn feed_error(piece: &Piece, step: f64) -> f64 {
    let mut worst = 0.0_f64;
    let steps = (piece.length() / step).floor();
    let mut s = 0.5 * step;
    while s < (steps - 0.5) * step {
        let frame = piece.frame(s);
        let chord = piece.frame(s - 0.5 * step).point.distance(piece.frame(s + 0.5 * step).point);
        let bend = frame.curvature.length_squared() * step * step;
        worst = worst.max((chord / step * (1.0 + bend / 24.0) - 1.0).abs());
        s += step;
    }
    worst
}

fn cubics() -> [(&'static str, Cubic); 4] {
    [
        ("gentle", Cubic::new(p(0.0, 0.0), p(2.0, 3.0), p(4.0, -1.0), p(6.0, 1.0))),
        ("far out", Cubic::new(p(1e3, 2e3), p(1020.0, 2e3), p(1020.0, 2020.0), p(1040.0, 2020.0))),
        ("uneven", Cubic::new(p(0.0, 0.0), p(0.3, 0.0), p(0.5, 3.0), p(9.0, 9.0))),
        ("tight", Cubic::new(p(0.0, 0.0), p(10.0, 10.0), p(3.0, 10.0), p(10.0, 0.0))),
    ]
}

/// Arc length of a cubic by Simpson's rule.
fn length_of(cubic: &Cubic) -> f64 {
    let places = 20_000;
    let h = 1.0 / f64::from(places);
    let mut sum = 0.0;
    for i in 0..places {
        let a = f64::from(i) * h;
        let speed = |t: f64| cubic.derivative(t).length();
        sum += h / 6.0 * (speed(a) + 4.0 * speed(a + 0.5 * h) + speed(a + h));
    }
    sum
}

#[test]
fn lines_and_arcs_have_constant_feed_to_1e_12() {
    let line = Straight::between(DVec3::new(1.0, -2.0, 3.0), DVec3::new(-40.0, 9.0, 8.0));
    let line = Piece::Straight(line.expect("two points"));
    let arc = Arc::from_sweep(p(30.0, 0.0), p(0.0, 0.0), -1.9 * PI).expect("an arc");
    let flat = Piece::Helix(Helix::of_arc(&arc, Plane::Zx, [2.0, 2.0]));
    let helix = Piece::Helix(Helix::of_arc(&arc, Plane::Yz, [2.0, -30.0]));
    for (piece, what) in [(&line, "line"), (&flat, "arc"), (&helix, "helix")] {
        // Chords of equal arcs are equal, on a helix too.
        let step = 0.1;
        let chord = piece.frame(0.0).point.distance(piece.frame(step).point);
        let mut s = 0.0;
        while s + step < piece.length() {
            let here = piece.frame(s).point.distance(piece.frame(s + step).point);
            assert!((here / chord - 1.0).abs() < 1e-12, "{what} at {s}: {here} and {chord}");
            s += step;
        }
        near(chord / step, 1.0, 1e-6, what);
    }
    near(helix.length(), (1.9 * PI * 30.0_f64).hypot(32.0), 1e-12, "length of the helix");
    let end = helix.frame(helix.length()).point;
    let truth = Plane::Yz.place(arc.end(), -30.0);
    assert!(end.distance(truth) < 1e-12, "the helix ends {end} at {truth}");
}

#[test]
fn cubics_have_constant_feed_to_1e_8() {
    for (name, cubic) in cubics() {
        for heights in [[0.0, 0.0], [1.0, 4.0]] {
            let parts = ByLength::of_cubic(&cubic, Plane::Xy, heights);
            assert_eq!(parts.len(), 1, "{name} has no cusp");
            let piece = Piece::Curve(Box::new(parts[0].clone()));
            let truth = length_of(&cubic).hypot(heights[1] - heights[0]);
            near(piece.length() / truth, 1.0, 1e-10, name);
            let error = feed_error(&piece, 1e-3);
            assert!(error < 1e-8, "{name}: feed errs by {error:e}");
            let end = piece.frame(piece.length()).point;
            let miss = end.distance(cubic.end().extend(heights[1]));
            assert!(miss < 1e-11, "{name}: ends {miss:e} off");
        }
    }
}

#[test]
fn frames_of_curves_are_the_derivatives_of_their_points() {
    let arc = Arc::winding(p(10.0, 0.0), p(0.0, 10.4), p(0.0, 0.0), false).expect("an arc");
    let spiral = ByLength::of_winding_arc(&arc, Plane::Zx, [0.0, 3.0]);
    let mut pieces = vec![("spiral", Piece::Curve(Box::new(spiral)))];
    for (name, cubic) in &cubics()[..3] {
        let part = ByLength::of_cubic(cubic, Plane::Yz, [0.0, 2.0]).swap_remove(0);
        pieces.push((name, Piece::Curve(Box::new(part))));
    }
    let circle = Arc::from_sweep(p(3.0, 1.0), p(0.0, 0.0), 4.0).expect("an arc");
    pieces.push(("helix", Piece::Helix(Helix::of_arc(&circle, Plane::Xy, [0.0, 7.0]))));
    for (name, piece) in &pieces {
        let length = piece.length();
        for i in 1..20 {
            let s = length * f64::from(i) / 20.0;
            let h = 1e-5 * length;
            let [a, here, b] = [s - h, s, s + h].map(|s| piece.frame(s));
            let check = |found: DVec3, said: DVec3, order: &str| {
                let error = found.distance(said) / (said.length() + 1e-2);
                assert!(error < 1e-4, "{name} at {s}: {order} {found} and {said}");
            };
            check((b.point - a.point) / (2.0 * h), here.tangent, "tangent");
            check((b.tangent - a.tangent) / (2.0 * h), here.curvature, "curvature");
            check((b.curvature - a.curvature) / (2.0 * h), here.sharpness, "sharpness");
            near(here.tangent.length(), 1.0, 1e-12, name);
            near(here.tangent.dot(here.curvature), 0.0, 1e-9, name);
        }
    }
    let end = pieces[0].1.frame(pieces[0].1.length()).point;
    let truth = Plane::Zx.place(p(0.0, 10.4), 3.0);
    assert!(end.distance(truth) < 1e-11, "the spiral ends at {end}");
}

#[test]
fn a_cubic_is_cut_where_it_turns_back() {
    let cusp = Cubic::new(p(0.0, 0.0), p(10.0, 10.0), p(0.0, 10.0), p(10.0, 0.0));
    let back = Cubic::new(p(0.0, 0.0), p(10.0, 0.0), p(-5.0, 0.0), p(4.0, 0.0));
    for (cubic, count) in [(cusp, 2), (back, 3)] {
        let parts = ByLength::of_cubic(&cubic, Plane::Xy, [0.0, 1.0]);
        assert_eq!(parts.len(), count, "parts between cusps");
        let mut length = 0.0;
        let mut reached = DVec3::ZERO;
        for part in parts {
            let piece = Piece::Curve(Box::new(part));
            let start = piece.frame(0.0);
            assert!(start.point.distance(reached) < 1e-9, "parts join: {} {reached}", start.point);
            assert!(start.sharpness.is_finite(), "and can be traversed from their ends");
            reached = piece.frame(piece.length()).point;
            length += piece.length();
        }
        assert!(reached.distance(cubic.end().extend(1.0)) < 1e-9, "to the end: {reached}");
        near(length, cubic.length().hypot(1.0), 1e-6, "their length");
    }
    let still = Cubic::new(p(1.0, 1.0), p(1.0, 1.0), p(1.0, 1.0), p(1.0, 1.0));
    assert!(ByLength::of_cubic(&still, Plane::Xy, [0.0, 0.0]).is_empty(), "nothing moves");
}

#[test]
fn a_part_is_where_the_whole_is() {
    let arc = Arc::from_sweep(p(3.0, 1.0), p(0.0, 0.0), -4.0).expect("an arc");
    let cubic = ByLength::of_cubic(&cubics()[0].1, Plane::Xy, [0.0, 2.0]).swap_remove(0);
    let tangents = [DVec3::X, DVec3::new(0.6, 0.0, 0.8)];
    let corner = g41::motion::Corner::with_leg(
        g41::motion::CornerCurve::Ph13,
        DVec3::splat(3.0),
        tangents,
        2.0,
    );
    for piece in [
        Piece::Straight(Straight::between(DVec3::ZERO, DVec3::ONE).expect("two points")),
        Piece::Helix(Helix::of_arc(&arc, Plane::Xy, [0.0, 7.0])),
        Piece::Curve(Box::new(cubic)),
        Piece::Corner(corner.expect("it turns")),
    ] {
        let length = piece.length();
        let part = piece.part(0.2 * length, 0.9 * length);
        near(part.length(), 0.7 * length, 1e-14 * length, "length of the part");
        for i in 0..=10 {
            let s = 0.7 * length * f64::from(i) / 10.0;
            let (whole, part) = (piece.frame(0.2 * length + s), part.frame(s));
            assert!(whole.point.distance(part.point) < 1e-13, "{piece:?} at {s}");
            assert!(whole.sharpness.distance(part.sharpness) < 1e-11, "{piece:?} at {s}");
        }
        let again = part.part(-0.2 * length, 0.8 * length);
        let [start, end] = [0.0, length].map(|s| again.frame(s).point);
        assert!(start.distance(piece.frame(0.0).point) < 1e-13, "the start comes back");
        assert!(end.distance(piece.frame(length).point) < 1e-13, "and the end");
    }
}

#[test]
fn a_flat_curve_stays_in_its_plane() {
    let cubic = Cubic::new(p(0.0, 0.0), p(2.0, 3.0), p(4.0, -1.0), p(6.0, 1.0));
    let part = ByLength::of_cubic(&cubic, Plane::Zx, [5.0, 5.0]).swap_remove(0);
    let piece = Piece::Curve(Box::new(part));
    let mut on = DVec2::ZERO;
    for i in 0..=50 {
        let (flat, height) =
            Plane::Zx.split(piece.frame(piece.length() * f64::from(i) / 50.0).point);
        near(height, 5.0, 1e-15, "the height stays");
        assert!(cubic.nearest(flat).distance < 1e-11, "{flat} is on the curve");
        assert!(flat.x >= on.x, "and goes on");
        on = flat;
    }
}
