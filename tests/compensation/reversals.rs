//! Reversals and nearly tangent joints: spikes, slits and the tangent band.

use std::f64::consts::PI;

use g41::compensation::{CornerStyle, Options, TangentBand};
use g41::contour::{Role, Side, TransitionKind};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::corners::{Leg, corner};
use super::judge::{at_the_radius, field_of, in_one_piece};
use super::sketch::{Sketch, arc, line};
use crate::common::{near, near_point, p};

#[test]
fn a_spike_of_two_lines_is_rounded_on_both_sides() {
    // Out along a line and back along it: the tool goes round its end with a square or an arc.
    let sketch = Sketch::open(p(0.0, 0.0), [line(p(20.0, 0.0)), line(p(5.0, 0.0))]);
    for side in [Side::Left, Side::Right] {
        let sigma = side.sign();
        let path = sketch.compensated(side, 2.0, &Options::default());
        assert_eq!(path.transitions[0].kind, TransitionKind::Inserted, "{side:?}");
        near(path.transitions[0].angle, 0.0, 1e-12, "α");
        let ends: Vec<_> = path.moves.iter().map(|m| m.curve.end()).collect();
        assert_eq!(ends.len(), 3, "{side:?}: {ends:?}");
        near_point(path.moves[0].curve.start(), p(0.0, 2.0 * sigma), 1e-12, "start");
        near_point(ends[0], p(22.0, 2.0 * sigma), 1e-12, "A1");
        near_point(ends[1], p(22.0, -2.0 * sigma), 1e-12, "A2");
        near_point(ends[2], p(5.0, -2.0 * sigma), 1e-12, "end");
        let options = Options { corner: CornerStyle::Arc, ..Options::default() };
        let path = sketch.compensated(side, 2.0, &options);
        in_one_piece(&path, "arc about a spike");
        at_the_radius(&path, &field_of(&sketch.contour()), 2.0, CornerStyle::Arc, 1e-9, "spike");
        let round = path.moves.iter().find(|m| m.role == Role::Transition).expect("an arc");
        near(round.curve.length(), 2.0 * PI, 1e-9, "half a circle");
        near_point(round.curve.point(0.5), p(22.0, 0.0), 1e-9, "its far end");
    }
}

#[test]
fn a_spike_of_two_arcs_is_inserted_outside_and_a_slit_inside() {
    // Two arcs come together in a cusp at the origin, pointing along +x: between them material on
    // one side, a slit on the other. Both bend to the left.
    let sketch = Sketch::open(
        p(-20.0, 20.0),
        [arc(p(0.0, 0.0), p(0.0, 20.0), false), arc(p(-30.0, -30.0), p(0.0, -30.0), false)],
    );
    for corner_style in [CornerStyle::Linear, CornerStyle::Arc] {
        let options = Options { corner: corner_style, ..Options::default() };
        let outside = sketch.compensated(Side::Right, 2.0, &options);
        assert_eq!(outside.transitions[0].kind, TransitionKind::Shortened, "towards the bend");
        near(outside.transitions[0].angle, 2.0 * PI, 1e-12, "α of a slit");
        let spike = sketch.compensated(Side::Left, 2.0, &options);
        assert_eq!(spike.transitions[0].kind, TransitionKind::Inserted, "away from the bend");
        near(spike.transitions[0].angle, 0.0, 1e-12, "α of a spike");
        in_one_piece(&spike, "spike");
        in_one_piece(&outside, "slit");
    }
}

#[test]
fn slits_and_spikes_of_arcs_keep_the_distance() {
    // The same cusp made of material: both arcs turn their backs to the tool.
    let sketch = Sketch::open(
        p(-20.0, 20.0),
        [arc(p(0.0, 0.0), p(0.0, 20.0), false), arc(p(-30.0, -30.0), p(0.0, -30.0), false)],
    );
    for (options, corner) in [
        (Options::default(), CornerStyle::Linear),
        (Options { corner: CornerStyle::Arc, ..Options::default() }, CornerStyle::Arc),
    ] {
        let field = field_of(&sketch.contour());
        for side in [Side::Left, Side::Right] {
            let path = sketch.compensated(side, 2.0, &options);
            let what = format!("{side:?} {corner:?}");
            if path.gouges.is_empty() {
                at_the_radius(&path, &field, 2.0, corner, 1e-6, &what);
            } else {
                panic!("{what}: the tool of 2 mm fits into this cusp: {:?}", path.gouges);
            }
        }
    }
}

#[test]
fn turns_within_the_band_are_no_corners() {
    let radius = 5.0;
    for first in Leg::ALL {
        for second in Leg::ALL {
            for side in [Side::Left, Side::Right] {
                for turn in [0.0, 1e-6, -1e-6, 0.9e-3 / 50.0] {
                    let sketch = corner([first, second], 0.3, turn, radius);
                    let path = sketch.compensated(side, radius, &Options::default());
                    let what = format!("{first:?} {second:?} {side:?} {turn:e}");
                    assert!(path.transitions.is_empty(), "{what}: {:?}", path.transitions);
                    in_one_piece(&path, &what);
                    let field = field_of(&sketch.contour());
                    // The gap closed is at most a tenth of the tolerance.
                    at_the_radius(&path, &field, radius, CornerStyle::Arc, 1.1e-3, &what);
                }
                for turn in [1.1e-3 / 50.0, -1.1e-3 / 50.0] {
                    let sketch = corner([first, second], 0.3, turn, radius);
                    let path = sketch.compensated(side, radius, &Options::default());
                    let what = format!("{first:?} {second:?} {side:?} {turn:e}");
                    assert_eq!(path.transitions.len(), 1, "{what}: just beyond the band");
                    in_one_piece(&path, &what);
                }
            }
        }
    }
}

#[test]
fn a_band_given_as_an_angle_is_that_angle() {
    // LinuxCNC takes turns of up to 0.05 rad for tangent, the ISG kernel of up to 3°.
    for band in [0.05, 3.0_f64.to_radians()] {
        let options = Options { tangent_band: TangentBand::Angle(band), ..Options::default() };
        for (turn, transitions) in [(0.99 * band, 0), (1.01 * band, 1)] {
            for sign in [1.0, -1.0] {
                let sketch = corner([Leg::Line, Leg::Line], 0.0, sign * turn, 2.0);
                let path = sketch.compensated(Side::Left, 2.0, &options);
                assert_eq!(path.transitions.len(), transitions, "turn {turn} in a band of {band}");
                in_one_piece(&path, "a wide band");
            }
        }
    }
}
