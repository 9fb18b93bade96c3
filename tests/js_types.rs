//! What crosses the boundary as JSON has the types that `types.d.ts` states: one sample or more of
//! each report, with every variant and every field, is written for `tsc` to check.
#![cfg(not(target_arch = "wasm32"))]

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use g41::contour::{
    Attributes, ContourBuilder, Gouge, GougeKind, Lead, PathLoop, Shape, Side, SplineShape,
    Transition, TransitionKind, Uncut,
};
use g41::diagnostic::{Diagnostic, Origin};
use g41::geometry::Parameter;
use g41::js::{
    Numbering, RECORD_STRIDE, contours_json, diagnostics_json, gouges_json, loops_json,
    transitions_json, uncut_json, violations_json,
};
use g41::motion::{Peak, Violations};
use g41::program::{ContourEnd, ContourStart, OrientationSource, ProgrammedContour, RadiusSource};
use glam::{DVec2, dvec2};

const BLOCK: Origin = Origin::Block { line: 3, number: Some(20), column: Some(5) };
const BARE_BLOCK: Origin = Origin::Block { line: 4, number: None, column: None };
const SEGMENT: Origin = Origin::Segment(2);

#[test]
fn samples_of_every_report_are_written_for_tsc() {
    let mut samples = String::from("import type * as api from \"../../src/js/types.d.ts\";\n\n");
    let mut sample = |json: &str, of: &str| {
        // Writing to a string cannot fail.
        let _ = writeln!(samples, "({json}) satisfies {of};");
    };
    for numbering in [Numbering::plain(), Numbering::of(vec![0, 1])] {
        sample(&diagnostics_json(&diagnostics(), &numbering), "api.Diagnostic[]");
        sample(&transitions_json(&transitions(), &numbering), "api.Transition[]");
        sample(&gouges_json(&gouges(), &numbering), "api.Gouge[]");
        sample(
            &uncut_json(&uncut(), &numbering),
            "(Omit<api.Uncut, \"outline\"> & { vertices: number })[]",
        );
    }
    sample(&loops_json(&loops()), "api.PathLoop[]");
    sample(&contours_json(&contours()), "api.ProgrammedContour[]");
    sample(&violations_json(&broken(), 1.5), "api.Violation[]");
    sample(&RECORD_STRIDE.to_string(), "typeof api.RECORD_STRIDE");

    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/js_types");
    fs::create_dir_all(&folder).expect("the folder can be made");
    fs::write(folder.join("samples.ts"), samples).expect("the samples can be written");
}

#[test]
fn a_report_has_all_its_fields_and_no_others() {
    let json = diagnostics_json(&diagnostics()[..1], &Numbering::plain());
    let expected = concat!(
        r#"[{"severity":"error","code":"all","message":"every field \"quoted\"","#,
        r#""hint":"a hint","at":[1,-2.5],"origin":{"block":3,"number":20,"column":5},"#,
        r#""depth":0.125,"segments":[{"block":4},{"segment":2}]}]"#
    );
    assert_eq!(json, expected, "JSON");
}

fn diagnostics() -> Vec<Diagnostic> {
    vec![
        Diagnostic::error("all", "every field \"quoted\"")
            .with_hint("a hint")
            .with_point(dvec2(1.0, -2.5))
            .with_origin(BLOCK)
            .with_depth(0.125)
            .with_segments([BARE_BLOCK, SEGMENT]),
        Diagnostic::warning("none", "no field"),
        Diagnostic::info("origin", "a segment").with_origin(SEGMENT),
    ]
}

fn transitions() -> Vec<Transition> {
    use TransitionKind::{Elongated, Inserted, Shortened};
    let transition = |kind| Transition {
        kind,
        angle: 1.0 / 3.0,
        corner: DVec2::X,
        construction: vec![("P", DVec2::X), ("V", DVec2::Y)],
        origin: BLOCK,
    };
    [Shortened, Elongated, Inserted].map(transition).into()
}

fn gouges() -> Vec<Gouge> {
    let gouge =
        |kind| Gouge { kind, at: DVec2::X, depth: 0.5, segments: vec![BLOCK, BARE_BLOCK, SEGMENT] };
    [GougeKind::Curvature, GougeKind::Bottleneck].map(gouge).into()
}

fn uncut() -> Vec<Uncut> {
    vec![Uncut {
        outline: vec![DVec2::ZERO, DVec2::X, DVec2::Y],
        area: 0.5,
        segments: vec![BLOCK, BARE_BLOCK, SEGMENT],
    }]
}

fn loops() -> Vec<PathLoop> {
    let outer = PathLoop { first_move: 0, moves_end: 4, pass: 0, parent: None };
    vec![outer, PathLoop { first_move: 4, moves_end: 8, pass: 1, parent: Some(0) }]
}

/// Each limit, broken.
fn broken() -> Violations {
    let peak = Peak { value: 2.5, limit: 2.0, time: 0.125 };
    Violations {
        velocity: peak,
        feed: peak,
        acceleration: peak,
        jerk: Peak { value: f64::NAN, ..peak },
        jerk_change: peak,
        axes: vec![[peak; 3]; 3],
        deviation: peak,
        chord_error: peak,
        end: 1e-3,
    }
}

/// Contours with segments of every kind, splines with every end, and every source of a radius.
fn contours() -> Vec<ProgrammedContour> {
    let points = |at: f64| vec![dvec2(at + 1.0, 1.0), dvec2(at + 2.0, -1.0), dvec2(at + 3.0, 0.0)];
    let spline = |at, start_tangent, end_tangent, parameter| {
        let points = points(at);
        Shape::Spline(SplineShape {
            points,
            start_tangent,
            end_tangent,
            parameter,
            ..SplineShape::default()
        })
    };
    let involute = |from: DVec2| {
        let (center, leaves) = (from - dvec2(8.0, -8.0), DVec2::from_angle(1.0));
        let to = center + leaves * 8.0 - leaves.perp() * 16.0;
        Shape::Involute { to, center, radius: 8.0, clockwise: false }
    };
    let open = [
        Shape::Line { to: dvec2(10.0, 0.0) },
        Shape::Arc { to: dvec2(20.0, 0.0), center: dvec2(15.0, 0.0), clockwise: true },
        spline(20.0, Some(DVec2::X), Some(DVec2::Y), Parameter::Chord),
        spline(23.0, None, None, Parameter::Centripetal),
        Shape::Bezier { controls: points(26.0) },
        // A thread that has come off a circle of radius 8 by twice as much as at the start.
        involute(dvec2(29.0, 0.0)),
    ];
    let periodic = [Shape::Spline(SplineShape {
        points: vec![dvec2(9.0, 1.0), dvec2(8.0, 5.0), DVec2::ZERO],
        ..SplineShape::default()
    })];
    let contour = |shapes: &[Shape], closed, side, radius| {
        let mut builder = ContourBuilder::new(DVec2::ZERO);
        for shape in shapes {
            builder.segment(shape.clone(), Attributes::at(BLOCK));
        }
        let lead = Lead { point: dvec2(-5.0, -5.0), attributes: Attributes::at(BARE_BLOCK) };
        builder.lead_in(lead);
        builder.lead_out(lead);
        let built = builder.build(closed);
        assert_eq!(built.diagnostics, [], "the samples are right");
        let contour = built.contour.expect("it has segments");
        ProgrammedContour {
            contour,
            side,
            radius,
            allowance: 0.0,
            unit: 1.0,
            orientation: OrientationSource::Given(0),
            curves: Vec::new(),
            leads_in: false,
            begins: ContourStart::Anew,
            end: ContourEnd::Off,
            blocks: [2, 9],
        }
    };
    vec![
        contour(&open, false, Side::Left, RadiusSource::Tool(7)),
        contour(&periodic, true, Side::Right, RadiusSource::Given(3.5)),
    ]
}
