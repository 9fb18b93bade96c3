//! G17, G18 and G19: lines, arcs, splines and contours in each plane.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::{PI, TAU};

use g41::contour::{EventKind, MoveCurve, Plane, Side};
use g41::geometry::Curve;

use super::sample::{moves, near, only_contour, read, read_clean, steps};

/// The same program in another plane: the letters of each axis and of its centre change places.
fn turned(text: &str, axes: &str, centers: &str) -> String {
    let other = |c: char| {
        let place = "XYZ".find(c).and_then(|i| axes.chars().nth(i));
        place.or_else(|| "IJK".find(c).and_then(|i| centers.chars().nth(i))).unwrap_or(c)
    };
    text.chars().map(other).collect()
}

#[test]
fn what_is_programmed_in_one_plane_is_the_same_in_each() {
    let text = "G0 X3 Y-20 Z5\nG1 Z-1 F600\nG41 D1 X0 Y0\nX50\nG3 X60 Y10 I0 J10\nG2 X70 Y20 R10\n\
                G1 Z-2\nY40 Z-3\nG5 X75 Y50\nX70 Y60\nX60 Y62\nG40 G1 X80 Y90\n\
                G2 I5 Z-9\nG0 Z5\n";
    let flat = read_clean(&format!("G17 {text}"));
    for (plane, word, axes, centers) in
        [(Plane::Zx, "G18", "ZXY", "KIJ"), (Plane::Yz, "G19", "YZX", "JKI")]
    {
        let other = read_clean(&format!("{word} {}", turned(text, axes, centers)));
        let (a, b) = (moves(&flat), moves(&other));
        assert_eq!(a.len(), b.len(), "{word}");
        for (a, b) in a.iter().zip(&b) {
            assert_eq!((a.curve, a.heights, a.feed), (b.curve, b.heights, b.feed), "{word}");
            assert_eq!((a.plane, b.plane), (Plane::Xy, plane), "{word}");
        }
        let (a, b) = (only_contour(&flat), only_contour(&other));
        assert_eq!(a.side, b.side, "{word}");
        for (a, b) in a.contour.segments().iter().zip(b.contour.segments()) {
            assert_eq!(a.curve, b.curve, "{word}");
            let found = (a.attributes.heights, b.attributes.plane);
            assert_eq!(found, (b.attributes.heights, plane), "heights and plane");
        }
        let vertical = |events: &[g41::contour::Event]| match events {
            [event] => matches!(event.kind, EventKind::Vertical(v) if v.heights == [-1.0, -2.0]),
            _ => false,
        };
        assert!(vertical(a.contour.events()) && vertical(b.contour.events()), "{word}");
        assert!(b.contour.segments().iter().any(|s| matches!(s.curve, Curve::Spline(_))), "{word}");
    }
}

#[test]
fn clockwise_is_seen_from_the_positive_side_of_the_normal() {
    // Looking at the plane of z and x from +y, z points right and x up: a quarter turn from +z to
    // +x is counter-clockwise, G3.
    let read = read_clean("G18 G0 X0 Y0 Z10\nG3 X10 Z0 I0 K-10 F60\n");
    let MoveCurve::Arc(arc) = moves(&read).last().expect("it is there").curve else { panic!() };
    assert!((arc.sweep() - PI / 2.0).abs() < 1e-9, "{arc:?}");
    assert!(near(arc.center(), [0.0, 0.0]), "{arc:?}");
    assert!(near(arc.end(), [0.0, 10.0]), "z before x: {arc:?}");
}

#[test]
fn an_arc_of_several_turns_climbs_evenly() {
    // Two full circles and a quarter: nine quarters from 0 to 9.
    let read = read_clean("G0 X10 Y0 Z0\nG3 X0 Y10 Z9 I-10 P3 F100\n");
    let arcs = &moves(&read)[1..];
    let heights: Vec<_> = arcs.iter().map(|m| m.heights).collect();
    assert_eq!(arcs.len(), 3, "{arcs:?}");
    for (found, expected) in heights.iter().zip([[0.0, 4.0], [4.0, 8.0], [8.0, 9.0]]) {
        let off = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
        assert!(off < 1e-9, "{found:?}, not {expected:?}");
    }
    let sweeps: Vec<f64> = arcs
        .iter()
        .map(|m| if let MoveCurve::Arc(arc) = m.curve { arc.sweep() } else { 0.0 })
        .collect();
    assert!((sweeps.iter().sum::<f64>() - (2.0 * TAU + PI / 2.0)).abs() < 1e-9, "{sweeps:?}");
    let full = read_clean("G0 X10 Y0 Z0\nG2 I-10 Z-4 P4 F100\n");
    assert_eq!(moves(&full).len(), 5, "P4 is four circles");
    let by_radius = read_clean("G0 X10 Y0\nG3 X0 Y10 R10 P2 F100\n");
    assert_eq!(moves(&by_radius).len(), 3, "in R form, too");
}

#[test]
fn an_absolute_centre_counts_in_the_plane() {
    let read = read_clean("G18 G90.1 G0 X0 Y1 Z10\nG3 X10 Z0 I0 K0 F60\n");
    let MoveCurve::Arc(arc) = moves(&read).last().expect("it is there").curve else { panic!() };
    assert!(near(arc.center(), [0.0, 0.0]), "{arc:?}");
}

#[test]
fn arcs_may_be_as_uneven_as_linuxcnc_lets_them() {
    for (text, accepted) in [
        // Its interpreter: 0.0283 mm (2 √2 hundredths), or a thousandth of the radius.
        ("G0 X0 Y0\nG2 X10.025 Y0 I5 F60", true),
        ("G0 X0 Y0\nG2 X10.04 Y0 I5 F60", false),
        ("G0 X0 Y0\nG2 X400.18 Y0 I200 F60", true),
        ("G0 X0 Y0\nG2 X400.3 Y0 I200 F60", false),
        // Half a circle by its radius, rounded.
        ("G0 X0 Y0\nG2 X10 Y0 R4.999 F60", true),
        ("G0 X0 Y0\nG2 X10 Y0 R4.9 F60", false),
    ] {
        let read = read(text);
        assert_eq!(read.diagnostics.is_empty(), accepted, "{text}: {:?}", read.diagnostics);
    }
}

#[test]
fn lathe_diameters_are_halved() {
    for text in [
        "G7 G0 X20 Z5\nG1 X10 Z0 F60\n",
        "G8 G0 X10 Z5\nG7 G91 G1 X-10 Z-5 F60\n",
        "G0 X10 Z5 G8\nG1 X10 G7 Z0 F60\n",
    ] {
        assert_eq!(steps(&read_clean(text)), ["R 10 0 5", "5 0 0"], "{text}");
    }
    let arc = read_clean("G18 G7 G0 X0 Z0\nG3 X20 Z-10 I0 K-10 F60\n");
    let MoveCurve::Arc(arc) = moves(&arc).last().expect("it is there").curve else { panic!() };
    assert!((arc.radius() - 10.0).abs() < 1e-9, "the centre is no diameter: {arc:?}");
}

#[test]
fn a_contour_ends_where_the_plane_changes() {
    let read = read("G0 X0 Y-9\nG41 D1 G1 Y0 F100\nX9\nG19\nY20\nZ9\nG40 Z20 Y30\n");
    let planes: Vec<_> = super::sample::contours(&read)
        .iter()
        .map(|c| (c.contour.segments()[0].attributes.plane, c.side))
        .collect();
    assert_eq!(planes, [(Plane::Xy, Side::Left), (Plane::Yz, Side::Left)], "{read:?}");
}
