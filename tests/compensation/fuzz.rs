//! Garbage: whatever is described, the path is finite and in one piece, and nothing panics.

use g41::compensation::{CornerStyle, LeadStyle, Options, SplineMethod, TangentBand, compensate};
use g41::contour::{Attributes, ContourBuilder, Lead, Shape, Side, SplineShape, Tool};
use g41::diagnostic::Origin;
use g41::geometry::{MAX_COORDINATE, Parameter, RadiusForm};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::random::Random;

const CASES: u32 = if cfg!(target_arch = "wasm32") { 500 } else { 6_000 };

fn number(random: &mut Random, reach: f64) -> f64 {
    match random.index(60) {
        0 => [f64::NAN, f64::INFINITY, 1e300, -1e12, 1e-300][random.index(5)],
        1 => random.within(-MAX_COORDINATE, MAX_COORDINATE),
        2 => random.within(-1e-9, 1e-9),
        3..=15 => 0.0,
        // On a grid, so that points coincide and lines are parallel.
        16..=35 => random.within(-4.0, 4.0).round() * reach / 4.0,
        _ => random.within(-reach, reach),
    }
}

fn point(random: &mut Random, reach: f64, near: DVec2) -> DVec2 {
    match random.index(12) {
        0 => near,
        1 => near + random.point(1e-8),
        _ => DVec2::new(number(random, reach), number(random, reach)),
    }
}

fn shape(random: &mut Random, reach: f64, from: DVec2) -> Shape {
    let to = point(random, reach, from);
    match random.index(5) {
        0 => Shape::Line { to },
        1 => {
            let center = point(random, reach, from.midpoint(to));
            Shape::Arc { to, center, clockwise: random.coin() }
        }
        2 => {
            // An arc that fits.
            let center = point(random, reach, from);
            let to = center + random.direction().rotate(from - center);
            Shape::Arc { to, center, clockwise: random.coin() }
        }
        3 => Shape::ArcByRadius {
            to,
            radius: number(random, reach),
            form: if random.coin() { RadiusForm::Minor } else { RadiusForm::Major },
            clockwise: random.coin(),
        },
        _ => {
            let mut points = vec![to];
            for _ in 0..random.index(7) {
                let last = points[points.len() - 1];
                points.push(point(random, reach, last));
            }
            let tangent =
                |random: &mut Random| random.coin().then(|| point(random, 1.0, DVec2::ZERO));
            Shape::Spline(SplineShape {
                points,
                start_tangent: tangent(random),
                end_tangent: tangent(random),
                smooth: random.coin(),
                periodic: (random.index(3) == 0).then(|| random.coin()),
                parameter: if random.coin() { Parameter::Chord } else { Parameter::Centripetal },
            })
        }
    }
}

fn options(random: &mut Random) -> Options {
    Options {
        tolerance: [0.1, 0.01, 0.001, 1e-6][random.index(4)],
        corner: if random.coin() { CornerStyle::Linear } else { CornerStyle::Arc },
        spline: if random.coin() { SplineMethod::Exact } else { SplineMethod::TypePoints },
        lead: if random.coin() { LeadStyle::Textbook } else { LeadStyle::Perpendicular },
        tangent_band: if random.coin() {
            TangentBand::Auto
        } else {
            TangentBand::Angle(random.within(0.0, 0.1))
        },
        ..Options::default()
    }
}

#[test]
fn garbage_makes_a_finite_path_in_one_piece() {
    let mut random = Random::new(0x6734_3140);
    let (mut built, mut moves) = (0, 0);
    for case in 0..CASES {
        let reach = [1e-3, 10.0, 100.0, 100.0, 1e6][random.index(5)];
        let start = point(&mut random, reach, DVec2::ZERO);
        let mut builder = ContourBuilder::new(start);
        let mut shapes = Vec::new();
        let mut at = start;
        for i in 0..=u32::try_from(random.index(6)).expect("small") {
            let shape = shape(&mut random, reach, at);
            at = shape.end().unwrap_or(at);
            shapes.push(shape.clone());
            builder.segment(shape, Attributes::at(Origin::Segment(i)));
        }
        let closed = random.coin();
        if closed && random.coin() {
            shapes.push(Shape::Line { to: start });
            builder.segment(Shape::Line { to: start }, Attributes::at(Origin::Segment(99)));
        }
        let attributes = Attributes::at(Origin::Segment(0));
        if random.index(3) == 0 {
            builder.lead_in(Lead { point: point(&mut random, reach, start), attributes });
        }
        if random.index(3) == 0 {
            builder.lead_out(Lead { point: point(&mut random, reach, at), attributes });
        }
        let radius = match random.index(5) {
            0 => 0.0,
            1 => random.within(0.0, 1e-6),
            2 => random.within(0.0, 0.1 * reach),
            3 => random.within(-2.0 * reach, 2.0 * reach),
            _ => 10.0_f64.powf(random.within(-3.0, 6.0)),
        };
        let side = if random.coin() { Side::Left } else { Side::Right };
        let options = options(&mut random);
        let what = format!("case {case}: {start} {shapes:?}, {side:?}, r {radius}, {options:?}");
        let Some(contour) = builder.build(closed).contour else { continue };
        built += 1;
        let tool = Tool::new(radius, side).expect("a valid radius");
        let path = compensate(&contour, tool, &options);
        moves += path.moves.len();
        for one in &path.moves {
            for t in [0.0, 0.3, 1.0] {
                assert!(one.curve.point(t).is_finite(), "{what}: {one:?}");
            }
        }
        // Coordinates of a million kilometres are spaced by 1e-7 mm.
        let slack = 1e-8 + 1e-14 * (radius.abs() + contour.bounds().size().max_element());
        for pair in path.moves.windows(2) {
            let gap = pair[0].curve.end().distance(pair[1].curve.start());
            let scale = pair[0].curve.end().abs().max_element();
            assert!(gap <= slack + 1e-14 * scale, "{what}: a gap of {gap:e} between {pair:?}");
        }
        for found in path.diagnostics.iter().filter_map(|d| d.depth) {
            assert!(found.is_finite() && found >= 0.0, "{what}: depth {found}");
        }
        assert!(path.moves.len() < 200_000, "{what}: {} moves", path.moves.len());
    }
    assert!(built > CASES / 4, "only {built} of {CASES} could be built");
    println!("{built} contours of {CASES}, {moves} moves");
}
