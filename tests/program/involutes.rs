//! G02.2 and G03.2: what they mean in each plane, unit and frame, what the control's alarms are for,
//! and how they are written.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::Options;
use g41::contour::{MoveCurve, Plane, ToolPath};
use g41::geometry::{Curve, Involute};
use g41::program::{Dialect, EmitOptions, Interpretation, Target, emit};
use g41::simulation::{Tools, compensate_program};
use glam::DVec2;

use super::sample::{codes, moves, only_contour, read, read_clean};
use crate::common::oracle::Plain;
use crate::common::{near, near_point, p};

/// On the involute of the circle of radius 10 about the origin that begins at (10, 0), counter-clockwise
/// outward: the points at the rolls 0.5 and 1, rounded as a program does.
const FROM: [f64; 2] = [11.173, 0.407];
const TO: [f64; 2] = [13.818, 3.012];

const TEXT: &str =
    "G0 X11.173 Y0.407 Z5.\nG1 Z-1. F600\nG3.2 X13.818 Y3.012 I-11.173 J-0.407 R10.\n";

fn involutes(read: &Interpretation) -> Vec<Involute> {
    let curves = moves(read).into_iter().map(|one| one.curve);
    curves.filter_map(|c| if let MoveCurve::Involute(i) = c { Some(i) } else { None }).collect()
}

fn only(text: &str) -> Involute {
    let read = read_clean(text);
    let [involute] = involutes(&read)[..] else { panic!("{text}: {:?}", read.items) };
    involute
}

#[test]
fn a_block_is_the_involute_between_its_ends() {
    let involute = only(TEXT);
    near_point(involute.start(), DVec2::from(FROM), 1e-9, "start");
    near_point(involute.end(), DVec2::from(TO), 1e-9, "end");
    near_point(involute.center(), DVec2::ZERO, 1e-9, "centre");
    near(involute.base_radius(), 10.0, 2e-3, "base radius");
    assert!(!involute.is_clockwise() && involute.is_outward(), "G3.2 away from the circle");
    // By its definition, to what rounding of the program leaves.
    for k in 0..=10 {
        let roll = 0.5 + 0.05 * f64::from(k);
        let leaves = DVec2::from_angle(roll);
        let truth = (leaves - leaves.perp() * roll) * 10.0;
        near(involute.nearest(truth).distance, 0.0, 1e-3, "on the true one");
    }
    // Back again: clockwise, towards the circle.
    let back = only("G0 X13.818 Y3.012\nG2.2 X11.173 Y0.407 I-13.818 J-3.012 R10 F600\n");
    assert!(back.is_clockwise() && !back.is_outward(), "{back:?}");
    for t in [0.0, 0.3, 1.0] {
        near_point(back.reversed().point(t), involute.point(t), 1e-9, "the same curve");
    }
    // The other sense is the mirror image, which does not end there.
    assert_eq!(codes(&TEXT.replace("G3.2", "G2.2"), Dialect::Fanuc), ["off-involute"], "mirrored");
}

#[test]
fn the_word_stays_in_effect_and_the_centre_is_always_counted_from_the_start() {
    let whole = only(TEXT);
    let middle = whole.point(0.4);
    let (x, y) = (middle.x, middle.y);
    for modes in ["", "G90.1\n", "G91\nG90.1\n"] {
        let [a, b] = if modes.contains("G91") {
            [middle - DVec2::from(FROM), DVec2::from(TO) - middle]
        } else {
            [middle, DVec2::from(TO)]
        };
        let text = format!(
            "G0 X11.173 Y0.407 Z5\n{modes}G3.2 X{} Y{} I-11.173 J-0.407 R10 F600\nX{} Y{} I{} J{} R10\n",
            a.x, a.y, b.x, b.y, -x, -y
        );
        let read = read_clean(&text);
        let [first, second] = involutes(&read)[..] else { panic!("{text}: {:?}", read.items) };
        near_point(first.end(), middle, 1e-9, &text);
        near_point(second.end(), whole.end(), 1e-9, &text);
        near(first.length() + second.length(), whole.length(), 1e-4, &text);
    }
}

#[test]
fn each_plane_has_its_own_letters() {
    let turned = |axes: &str, centers: &str| -> String {
        let other = |c: char| {
            let place = "XYZ".find(c).and_then(|i| axes.chars().nth(i));
            place.or_else(|| "IJK".find(c).and_then(|i| centers.chars().nth(i))).unwrap_or(c)
        };
        TEXT.chars().map(other).collect()
    };
    for (plane, word, axes, centers) in
        [(Plane::Zx, "G18", "ZXY", "KIJ"), (Plane::Yz, "G19", "YZX", "JKI")]
    {
        let read = read_clean(&format!("{word} {}", turned(axes, centers)));
        assert_eq!(involutes(&read), [only(TEXT)], "{word}");
        assert!(moves(&read).iter().all(|one| one.plane == plane), "{word}");
    }
    assert_eq!(
        codes(&TEXT.replace('J', "K"), Dialect::Fanuc).last(),
        Some(&"word-not-understood"),
        "K belongs to another plane"
    );
}

#[test]
fn units_and_frames_turn_and_stretch_it() {
    let flat = only(TEXT);
    let inches = only("G20 G0 X1.1173 Y0.0407\nG3.2 X1.3818 Y0.3012 I-1.1173 J-0.0407 R1 F60\n");
    near(inches.base_radius(), 2.54 * flat.base_radius(), 1e-9, "inches");
    near_point(inches.end(), flat.end() * 2.54, 1e-9, "inches");
    let scaled = only(&format!("G51 X0 Y0 Z0 P2\n{TEXT}"));
    near(scaled.base_radius(), 2.0 * flat.base_radius(), 1e-9, "scaled");
    let rotated = only(&format!("G68 X0 Y0 R90\n{TEXT}"));
    near_point(rotated.end(), flat.end().perp(), 1e-9, "rotated");
    near_point(rotated.point(0.4), flat.point(0.4).perp(), 1e-9, "rotated");
    let mirrored = only(&format!("G51.1 X0\n{TEXT}"));
    assert!(mirrored.is_clockwise(), "mirrored");
    near_point(mirrored.point(0.4), flat.point(0.4) * p(-1.0, 1.0), 1e-9, "mirrored");
    let uneven = read(&format!("G51 X0 Y0 I2000 J1000\n{TEXT}"));
    assert!(involutes(&uneven).is_empty(), "an ellipse has none");
}

#[test]
fn what_the_control_gives_alarms_for_is_told() {
    let start = "G0 X11.173 Y0.407\n";
    for (block, code) in [
        // End, centre or radius are missing: alarm 241.
        ("G3.2 I-11.173 J-0.407 R10. F600", "involute-incomplete"),
        ("G3.2 X13.818 Y3.012 R10. F600", "involute-incomplete"),
        ("G3.2 X13.818 Y3.012 I-11.173 J-0.407 F600", "involute-incomplete"),
        // No circle, or an end inside of it, or beyond a hundred turns: alarm 242.
        ("G3.2 X13.818 Y3.012 I-11.173 J-0.407 R0 F600", "no-base-circle"),
        ("G3.2 X13.818 Y3.012 I-11.173 J-0.407 R-10. F600", "no-base-circle"),
        ("G3.2 X13.818 Y3.012 I0 J0 R10. F600", "inside-base-circle"),
        ("G3.2 X13.818 Y3.012 I-11.173 J-0.407 R11.3 F600", "inside-base-circle"),
        ("G3.2 X9. Y3.012 I-11.173 J-0.407 R10. F600", "inside-base-circle"),
        ("G3.2 X7000. Y0 I-11.173 J-0.407 R10. F600", "no-base-circle"),
        // The end is not on the curve: alarm 243.
        ("G3.2 X13.818 Y3.112 I-11.173 J-0.407 R10. F600", "off-involute"),
        ("G3.2 X13.818 Y3.012 I-11.173 J-0.407 R9.5 F600", "off-involute"),
    ] {
        let text = format!("{start}{block}\n");
        let read = read(&text);
        assert_eq!(codes(&text, Dialect::Fanuc), [code], "{block}");
        // A line stands in its place, and what follows starts at its end.
        let last = moves(&read).last().copied();
        assert!(last.is_none_or(|one| !matches!(one.curve, MoveCurve::Involute(_))), "{block}");
    }
    // What rounding to two decimals makes is let pass.
    let rounded = read_clean("G0 X11.17 Y0.41\nG3.2 X13.82 Y3.01 I-11.17 J-0.41 R10. F600\n");
    assert_eq!(involutes(&rounded).len(), 1, "{:?}", rounded.items);
}

const FLANK: &str = "G17 G21 G90\nG0 X20 Y-10\nG1 G42 D1 X11.173 Y0.407 F300\n\
                     G3.2 X13.818 Y3.012 I-11.173 J-0.407 R10\nG1 G40 X20 Y12\nM30\n";

fn compensated(text: &str) -> ToolPath {
    compensate_program(&read_clean(text), &Tools::all(1.5), &Options::default())
}

#[test]
fn a_flank_is_compensated_as_an_involute_and_written_as_one_where_it_is_known() {
    let read = read_clean(FLANK);
    let curve = &only_contour(&read).contour.segments()[0].curve;
    let Curve::Involute(programmed) = curve else { panic!("{curve:?}") };
    let path = compensated(FLANK);
    let flank = path.moves.iter().find_map(|one| match one.curve {
        MoveCurve::Involute(involute) => Some(involute),
        _ => None,
    });
    let flank = flank.expect("the flank is an involute");
    near(flank.base_radius(), programmed.base_radius(), 1e-9, "of the same circle");
    let plain = Plain::of_involute(programmed);
    for k in 0..=10 {
        near(plain.distance(flank.point(f64::from(k) / 10.0), 200), 1.5, 1e-9, "at the radius");
    }
    for target in Target::ALL {
        // Its programs are no G-code; `tests/targets.rs` reads them by a reader of their own.
        if target == Target::Heidenhain {
            continue;
        }
        let written = emit(&path, &EmitOptions { target, ..EmitOptions::default() });
        let native = written.text.contains("G3.2");
        assert_eq!(native, target == Target::Fanuc30I, "{target:?}: {}", written.text);
        let blocks = written.text.lines().filter(|line| line.contains('J')).count();
        // Arcs are off by κ' h³ / 48 at most: four of them along 5 mm.
        assert!(if native { blocks == 1 } else { (2..=6).contains(&blocks) }, "{}", written.text);
        let again = read_clean(&written.text);
        let plain = Plain::of_involute(&flank);
        let (first, last) = (flank.start(), flank.end());
        let mut along = 0;
        for one in moves(&again) {
            let (start, end) = (one.curve.start(), one.curve.end());
            let on = |at: DVec2| plain.distance(at, 200) < 2e-3;
            if !on(start) || !on(end) {
                continue;
            }
            along += 1;
            for k in 0..=10 {
                let at = one.curve.point(f64::from(k) / 10.0);
                near(plain.distance(at, 200), 0.0, 2.5e-3, &format!("{target:?}"));
            }
        }
        assert!(along >= 1 && first != last, "{target:?}: it is there");
    }
}

#[test]
fn a_written_involute_is_read_as_it_is_and_written_again() {
    let options = EmitOptions { target: Target::Fanuc30I, ..EmitOptions::default() };
    let mut text = emit(&compensated(FLANK), &options).text;
    for round in 0..3 {
        let read = read_clean(&text);
        let path = compensate_program(&read, &Tools::all(1.5), &Options::default());
        let again = emit(&path, &options).text;
        assert_eq!(again, text, "round {round}");
        text = again;
    }
}
