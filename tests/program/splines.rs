//! Spline blocks of four families of controls: the curves that they mean, and those beside them.

use std::f64::consts::FRAC_1_SQRT_2;

use g41::compensation::{Options, compensate};
use g41::contour::{Contour, MoveCurve, Plane, Role, Tool};
use g41::geometry::{Cubic, Curve, EndCondition, Parameter, Spline, SplineEnds, akima};
use g41::program::{Dialect, Interpretation, Program, Rules, interpret};
use glam::{DVec2, dvec2};

use super::sample::{ERROR, INFO, WARNING, found, moves, only_contour};

fn read(text: &str, dialect: Dialect) -> Interpretation {
    interpret(&Program::parse(text, dialect), Rules::default())
}

/// The cubics of the free moves of a program.
fn cubics(read: &Interpretation) -> Vec<Cubic> {
    let cubic = |curve| if let MoveCurve::Cubic(cubic) = curve { Some(cubic) } else { None };
    moves(read).into_iter().filter_map(|found| cubic(found.curve)).collect()
}

/// The cubics of a program in which nothing worse than an approximation is found.
#[track_caller]
fn clean(text: &str, dialect: Dialect) -> Vec<Cubic> {
    let read = read(text, dialect);
    let faults: Vec<_> = read.diagnostics.iter().filter(|d| d.code != "approximated").collect();
    assert!(faults.is_empty(), "{text}\n{faults:?}");
    cubics(&read)
}

#[track_caller]
fn controls(cubic: &Cubic, expected: [[f64; 2]; 4]) {
    for (point, expected) in cubic.points.iter().zip(expected) {
        assert!(point.distance(expected.into()) < 1e-12, "{cubic:?} for {expected:?}");
    }
}

/// A curve by the recursion of Cox and de Boor.
fn defined(order: usize, knots: &[f64], points: &[([f64; 2], f64)], u: f64) -> DVec2 {
    fn basis(knots: &[f64], i: usize, order: usize, u: f64) -> f64 {
        let share = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
        match order {
            1 => f64::from(u8::from(knots[i] <= u && u < knots[i + 1])),
            _ => {
                share(u - knots[i], knots[i + order - 1] - knots[i]) * basis(knots, i, order - 1, u)
                    + share(knots[i + order] - u, knots[i + order] - knots[i + 1])
                        * basis(knots, i + 1, order - 1, u)
            }
        }
    }
    let (mut sum, mut total) = (DVec2::ZERO, 0.0);
    for (i, (point, weight)) in points.iter().enumerate() {
        let share = basis(knots, i, order, u) * weight;
        sum += DVec2::from(*point) * share;
        total += share;
    }
    sum / total
}

/// Largest distance of the curve by its definition from some cubics.
fn apart(cubics: &[Cubic], order: usize, knots: &[f64], points: &[([f64; 2], f64)]) -> f64 {
    let (from, to) = (knots[0], knots[knots.len() - 1]);
    let mut worst = 0.0_f64;
    for k in 0..1000 {
        let point = defined(order, knots, points, from + (to - from) * f64::from(k) / 1000.0);
        let distance = |cubic: &Cubic| cubic.nearest(point).distance;
        worst = worst.max(cubics.iter().map(distance).fold(f64::INFINITY, f64::min));
    }
    worst
}

#[test]
fn g5_is_a_cubic_and_the_next_one_goes_on_smoothly() {
    // An N, and another that goes on from it, by itself and by its mode alone.
    let first = "G21 G90 G17 F600\nG0 X2 Y1\nG5 I0 J6 P0 Q-6 X4 Y3\n";
    for second in ["G5 P1 Q-5 X6 Y5", "P1 Q-5 X6 Y5", "(on)\nM8\nX6 P1 Y5 Q-5"] {
        let curve = clean(&format!("{first}{second}\n"), Dialect::Auto);
        assert_eq!(curve.len(), 2, "{second}");
        controls(&curve[0], [[2.0, 1.0], [2.0, 7.0], [4.0, -3.0], [4.0, 3.0]]);
        controls(&curve[1], [[4.0, 3.0], [4.0, 9.0], [7.0, 0.0], [6.0, 5.0]]);
    }
    // In inches, incrementally, and mirrored.
    let curve = clean("G20 F20\nG0 X1 Y1\nG91 G5 I1 J0 P0 Q1 X2 Y-1\n", Dialect::Auto);
    controls(&curve[0], [[25.4, 25.4], [50.8, 25.4], [76.2, 25.4], [76.2, 0.0]]);
    let curve = clean("F9\nG0 X2 Y1\nG51.1 X0\nG5 I0 J6 P1 Q-6 X-4 Y3\n", Dialect::Fanuc);
    controls(&curve[0], [[2.0, 1.0], [2.0, 7.0], [3.0, -3.0], [4.0, 3.0]]);
}

#[test]
fn g5_lies_in_the_plane() {
    let read = read("F9\nG18\nG0 X2 Y5 Z1\nG5 I0 K6 P0 Q-6 X4 Z3\n", Dialect::Auto);
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    let last = *moves(&read).last().expect("a move");
    assert_eq!((last.plane, last.heights), (Plane::Zx, [5.0, 5.0]), "beside Y");
    // In the plane z comes first.
    controls(&cubics(&read)[0], [[1.0, 2.0], [7.0, 2.0], [-3.0, 4.0], [3.0, 4.0]]);
}

#[test]
fn g5_1_is_a_parabola() {
    // y = x² from -3 to 3: its control point is (0, -9).
    let curve = clean("F9\nG0 X-3 Y9\nG5.1 X3 I3 J-18\n", Dialect::Auto);
    for k in 0..=20 {
        let point = curve[0].point(f64::from(k) / 20.0);
        assert!((point.y - point.x * point.x).abs() < 1e-13, "{point}");
    }
    // Without I its control point is straight below.
    let curve = clean("F9\nG0 X0 Y0\nG5.1 X6 Y0 J-3\nX9 Y3 I3\n", Dialect::Auto);
    controls(&curve[0], [[0.0, 0.0], [0.0, -2.0], [2.0, -2.0], [6.0, 0.0]]);
    controls(&curve[1], [[6.0, 0.0], [8.0, 0.0], [9.0, 1.0], [9.0, 3.0]]);
}

#[test]
fn g5_2_is_a_nurbs_curve_of_evenly_spaced_knots() {
    let points = [
        ([0.0, 0.0], 1.0),
        ([0.0, 10.0], 1.0),
        ([20.0, 20.0], 1.0),
        ([20.0, 0.0], 1.0),
        ([0.0, 0.0], 2.0),
    ];
    let text = "G0 X0 Y0\nF600\nG5.2 P1 L3\nX0 Y10 P1\nX20 Y20\nX20 Y0 P1\nX0 Y0 P2\nG5.3\nG0 X5\n";
    let knots = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0];
    let curve = clean(text, Dialect::Auto);
    assert!(apart(&curve, 3, &knots, &points) <= 1e-4, "within the tolerance");
    assert_eq!(found(&read(text, Dialect::Auto)), [("approximated", INFO, 4, None)], "as told");
    let finer = Rules { curve_tolerance: 1e-7, ..Rules::default() };
    let read = interpret(&Program::parse(text, Dialect::Auto), finer);
    assert!(apart(&cubics(&read), 3, &knots, &points) <= 1e-7, "as fine as asked for");
    assert!(read.diagnostics[0].message.contains("0.0000001 mm"), "{}", read.diagnostics[0]);
    // Without weights it is a cubic spline exactly; the first block may have a point.
    let text = "F9\nG0 X1 Y2\nG5.2 X5 Y9 L4\nX12 Y-3\nX20 Y4 (hook)\nX22 Y14\nX9 Y18\nG5.3\n";
    let points = [
        ([1.0, 2.0], 1.0),
        ([5.0, 9.0], 1.0),
        ([12.0, -3.0], 1.0),
        ([20.0, 4.0], 1.0),
        ([22.0, 14.0], 1.0),
        ([9.0, 18.0], 1.0),
    ];
    let curve = clean(text, Dialect::Auto);
    assert_eq!(curve.len(), 3, "a cubic for each span");
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.0];
    assert!(apart(&curve, 4, &knots, &points) < 1e-12, "exactly");
    assert!(read_codes("F9\nG0 X1 Y2\nG5.2 X5 Y9 L4\nX12 Y-3\nX20 Y4\nG5.3\n").is_empty());
}

fn read_codes(text: &str) -> Vec<&'static str> {
    read(text, Dialect::Auto).diagnostics.iter().map(|found| found.code).collect()
}

#[test]
fn g06_2_is_a_nurbs_curve_with_its_knots() {
    // A quarter of a circle of 30 mm, as FANUC has it.
    let half = format!("{FRAC_1_SQRT_2:.12}");
    let text = format!(
        "G0 X30 Y0\nG06.2 P3 K0 X30 Y0 R1 F600\nK0 X30 Y30 R{half}\nK0 X0 Y30 R1\nK1\nK1\nK1\n\
         G1 X-10\n"
    );
    let curve = clean(&text, Dialect::Auto);
    for cubic in &curve {
        for k in 0..=10 {
            let radius = cubic.point(f64::from(k) / 10.0).length();
            assert!((radius - 30.0).abs() < 1e-4, "{radius}");
        }
    }
    assert!(curve[curve.len() - 1].end().distance(dvec2(0.0, 30.0)) < 1e-12, "its end");
    // Of the third degree unless P says otherwise, without weights, with uneven knots; the first
    // control point is where the tool is, and the curve ends with as many knots as its order.
    let text = "F9\nG0 X0 Y0\nG06.2 K0\nX10 Y12 K0\nX22 Y-8 K0\nX30 Y0 K0\nX41 Y3 K2\nX50 Y10 K3\n\
                K7\nK7\nK7\nK7\nM5\n";
    let points = [
        ([0.0, 0.0], 1.0),
        ([10.0, 12.0], 1.0),
        ([22.0, -8.0], 1.0),
        ([30.0, 0.0], 1.0),
        ([41.0, 3.0], 1.0),
        ([50.0, 10.0], 1.0),
    ];
    let knots = [0.0, 0.0, 0.0, 0.0, 2.0, 3.0, 7.0, 7.0, 7.0, 7.0];
    let curve = clean(text, Dialect::Auto);
    assert_eq!(curve.len(), 3, "a cubic for each span");
    assert!(apart(&curve, 4, &knots, &points) < 1e-12, "exactly");
    // Without its knot the first block has that of the second.
    let curve = clean(&text.replace("G06.2 K0", "G06.2"), Dialect::Auto);
    assert!(apart(&curve, 4, &knots, &points) < 1e-12, "the same");
    // LinuxCNC says with Q how the feed is kept, and two curves may follow each other.
    let curve = clean(
        "F9\nG0 X0 Y0\nG6.2 P3 Q1 K0 X0 Y0\nX4 Y8 K0\nX8 Y0 K0\nK1\nK1\nK1\n\
         P3 K0 X8 Y0\nX12 Y-8 K0\nX16 Y0 K0\nK1\nK1\nK1\n",
        Dialect::Auto,
    );
    assert_eq!(curve.len(), 2, "two parabolas");
    assert!(curve[1].point(0.5).distance(dvec2(12.0, -4.0)) < 1e-12, "the second");
    // Somewhere else the tool goes to the first control point by itself.
    let read =
        read(&text.replace("G0 X0 Y0\nG06.2 K0", "G0 X0 Y-9\nG06.2 K0 X0 Y0"), Dialect::Auto);
    assert_eq!(found(&read), [("nurbs-start", WARNING, 3, Some(1))], "as told");
    assert_eq!(moves(&read).len(), 5, "a rapid, a line and the curve");
    assert!(apart(&cubics(&read), 4, &knots, &points) < 1e-12, "the same curve");
}

#[test]
fn g06_1_passes_its_points() {
    let points = vec![dvec2(0.0, 0.0), dvec2(8.0, 5.0), dvec2(20.0, 2.0), dvec2(26.0, 9.0)];
    let rest = "\nX8 Y5\nX20 Y2\nX26 Y9\nG0 X40\n";
    for (word, start) in
        [("G06.1", EndCondition::Natural), ("G06.1 X0 Y3", EndCondition::Tangent(dvec2(0.0, 3.0)))]
    {
        let ends = SplineEnds::Open { start, end: EndCondition::Natural };
        let spline = Spline::through(points.clone(), ends, Parameter::Chord).expect("a spline");
        let curve = clean(&format!("F9\nG0 X0 Y0\n{word}{rest}"), Dialect::Auto);
        assert_eq!(curve, spline.pieces(), "{word}");
    }
}

#[test]
fn the_parameter_of_splines_through_points_is_a_rule() {
    let text = "F9\nG0 X0 Y0\nG05 X1 Y0\nX10 Y6\nX12 Y0\n";
    let points = vec![dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(10.0, 6.0), dvec2(12.0, 0.0)];
    for parameter in [Parameter::Chord, Parameter::Centripetal] {
        let rules = Rules { parameter, ..Rules::default() };
        let read = interpret(&Program::parse(text, Dialect::Auto), rules);
        let spline = Spline::through(points.clone(), SplineEnds::NATURAL, parameter);
        assert_eq!(cubics(&read), spline.expect("a spline").pieces(), "{parameter:?}");
    }
}

const POINTS: [DVec2; 5] =
    [dvec2(0.0, 0.0), dvec2(10.0, 8.0), dvec2(25.0, 4.0), dvec2(33.0, 12.0), dvec2(50.0, 6.0)];

/// A SINUMERIK program whose spline of a kind passes, or is drawn by, the points; up along x before
/// and down along y behind.
fn named(kind: &str, end: &str) -> String {
    format!(
        "N10 G1 X-20 Y0 F600\nN20 X0\nN30 {kind} X10 Y8\nN40 X25 Y4\nN50 X33 Y12\nN60 X50 Y6 {end}\n\
         N70 G1 Y-10\nM30\n"
    )
}

/// The boundary words, and what they mean.
fn boundaries() -> [(&'static str, &'static str, [EndCondition; 2]); 5] {
    let before = EndCondition::Tangent(DVec2::X);
    let behind = EndCondition::Tangent(-DVec2::Y);
    [
        ("", "", [before, behind]),
        ("BNAT ", "ENAT", [EndCondition::Natural; 2]),
        ("BAUTO ", "EAUTO", [EndCondition::NotAKnot; 2]),
        ("BTAN ", "ENAT", [before, EndCondition::Natural]),
        ("BAUTO ETAN ", "", [EndCondition::NotAKnot, behind]),
    ]
}

#[test]
fn aspline_is_akimas_curve() {
    for (begin, end, conditions) in boundaries() {
        let curve = clean(&named(&format!("{begin}ASPLINE"), end), Dialect::Auto);
        let expected = akima(&POINTS, conditions);
        assert_eq!(curve.len(), 4, "{begin}{end}");
        for (cubic, expected) in curve.iter().zip(&expected) {
            controls(cubic, expected.points.map(|point| point.to_array()));
        }
    }
}

#[test]
fn cspline_is_the_cubic_spline() {
    for (begin, end, [start, behind]) in boundaries() {
        let curve = clean(&named(&format!("{begin}CSPLINE"), end), Dialect::Auto);
        let ends = SplineEnds::Open { start, end: behind };
        let expected = Spline::through(POINTS.to_vec(), ends, Parameter::Chord).expect("a spline");
        assert_eq!(curve.len(), 4, "{begin}{end}");
        for (cubic, expected) in curve.iter().zip(expected.pieces()) {
            controls(cubic, expected.points.map(|point| point.to_array()));
        }
    }
}

#[test]
fn tangents_are_those_of_arcs_too() {
    // An arc to the left into the spline, and one to the right out of it.
    let text = "G1 X-10 Y-10 F600\nG3 X0 Y0 I0 J10\nCSPLINE X10 Y12\nX20 Y10\nG2 X30 Y0 CR=10\n";
    let curve = clean(text, Dialect::Sinumerik);
    assert!(curve[0].tangent(0.0).distance(DVec2::Y) < 1e-12, "up: {}", curve[0].tangent(0.0));
    assert!(curve[1].tangent(1.0).distance(DVec2::X) < 1e-9, "level: {}", curve[1].tangent(1.0));
    let by_center = text.replace("CR=10", "I0 J-10");
    assert_eq!(clean(&by_center, Dialect::Sinumerik).len(), 2, "the same by its centre");
}

#[test]
fn bspline_is_drawn_by_its_points() {
    let weighted = |weights: [f64; 5]| -> Vec<([f64; 2], f64)> {
        POINTS.iter().zip(weights).map(|(point, weight)| (point.to_array(), weight)).collect()
    };
    let curve = clean(&named("BSPLINE", ""), Dialect::Auto);
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 2.0];
    assert!(apart(&curve, 4, &knots, &weighted([1.0; 5])) < 1e-12, "of the third degree");
    let text =
        named("BSPLINE SD=2 PL=2", "").replace("Y4", "Y4 PW=2.5 PL=1").replace("Y12", "Y12 PL=3");
    let knots = [0.0, 0.0, 0.0, 2.0, 3.0, 6.0, 6.0, 6.0];
    let curve = clean(&text, Dialect::Auto);
    let points = weighted([1.0, 1.0, 2.5, 1.0, 1.0]);
    assert!(apart(&curve, 3, &knots, &points) <= 1e-4, "with a weight and intervals");
}

/// Curves of every form under G41, each with the tool of 3 mm.
fn forms() -> Vec<(String, Dialect)> {
    let led = |blocks: &str| {
        format!("G0 X-20 Y-9\nG41 D1 G1 X-10 Y0 F600\nX0\n{blocks}\nG40 G1 X90 Y40\nM30\n")
    };
    let form = |blocks: &str| (led(blocks), Dialect::Auto);
    let sinumerik = |blocks: &str| (led(blocks), Dialect::Sinumerik);
    vec![
        form("G5 I20 J0 P-20 Q0 X60 Y15"),
        form("G5 I20 J0 P-10 Q-5 X30 Y15\nP-10 Q4 X60 Y20"),
        form("G5.1 I30 J0 X60 Y20"),
        form("G5.2 P1 L3\nX20 Y0 P1\nX40 Y18 P0.6\nX60 Y20 P1\nG5.3"),
        form("G5.2 P1 L4\nX20 Y0 P1\nX40 Y18 P2\nX60 Y20 P1\nX80 Y25\nG5.3"),
        form(
            "G6.2 P4 Q1 K0 X0 Y0 R1\nX20 Y0 K0\nX40 Y18 K0 R1.5\nX60 Y20 K0\nX80 Y25 K1\nK2\nK2\nK2\nK2",
        ),
        form("G06.1 X1 Y0\nX20 Y2\nX40 Y10\nX60 Y11"),
        form("G05 X20 Y2\nX40 Y10\nX60 Y11"),
        sinumerik("ASPLINE X20 Y2\nX40 Y10\nX60 Y11"),
        sinumerik("BSPLINE X20 Y0 PW=1.4\nX40 Y10\nX60 Y11"),
        sinumerik("BTAN CSPLINE EAUTO X20 Y2\nX40 Y10\nX60 Y11\nX70 Y14"),
        sinumerik("CSPLINE X20 Y2\nX40 Y10\nX60 Y11"),
    ]
}

/// Dense points of the curves of a contour, and where the tool belongs beside its splines.
fn beside(contour: &Contour, offset: f64) -> [Vec<DVec2>; 2] {
    let (mut own, mut truth) = (Vec::new(), Vec::new());
    for segment in contour.segments() {
        for k in 0..=2000 {
            let t = f64::from(k) / 2000.0;
            own.push(segment.curve.point(t));
        }
        if let Curve::Spline(spline) = &segment.curve {
            for cubic in spline.pieces() {
                for k in 0..=300 {
                    let t = f64::from(k) / 300.0;
                    let normal = cubic.derivative(t).normalize().perp();
                    truth.push(cubic.point(t) + normal * offset);
                }
            }
        }
    }
    [own, truth]
}

#[test]
fn every_form_stands_under_compensation() {
    for (text, dialect) in forms() {
        for text in [text.clone(), text.replace("G41", "G42")] {
            let read = read(&text, dialect);
            let faults: Vec<_> = read.diagnostics.iter().filter(|d| d.severity > INFO).collect();
            assert!(faults.is_empty(), "{text}\n{faults:?}");
            let programmed = only_contour(&read);
            let tool = Tool::new(3.0, programmed.side).expect("a radius");
            let path = compensate(&programmed.contour, tool, &Options::default());
            let [own, truth] = beside(&programmed.contour, tool.offset());
            assert!(!truth.is_empty(), "{text}: a spline is there");
            let mut vertices = Vec::new();
            for step in path.moves.iter().filter(|step| step.role == Role::Segment) {
                vertices.push(step.curve.start());
                step.curve.flatten(1e-5, &mut |point| vertices.push(point));
            }
            for vertex in &vertices {
                let reach = own.iter().map(|point| point.distance(*vertex));
                let reach = reach.fold(f64::INFINITY, f64::min);
                assert!(reach > 3.0 - 2e-3, "{text}: {reach} at {vertex}");
            }
            for point in truth.iter().step_by(10) {
                let to = |step: &g41::contour::Move| step.curve.nearest(*point).distance;
                let off = path.moves.iter().map(to).fold(f64::INFINITY, f64::min);
                assert!(off < 1.1e-3, "{text}: {off:e} beside {point}");
            }
        }
    }
}

#[test]
fn what_makes_no_curve_is_reported_and_a_line_stands_in() {
    let cases = [
        ("G5 X9 Y9 P1 Q1", "bezier-without-start"),
        ("G5 X9 Y9 I1 P1 Q1", "bezier-without-start"),
        ("G5 X5 Y5 I1 J1 P1 Q1\nG1 X9 Y9\nG5 X9 Y9 P1 Q1", "bezier-without-start"),
        ("G5.1 X9 Y9 I0 J0", "bezier-without-start"),
        ("G5.1 X9 Y9", "bezier-without-start"),
        ("G5.2 L5\nX4 Y4\nX9 Y9\nG5.3", "bad-nurbs"),
        ("G5.2 L2.5\nX4 Y4\nX9 Y9\nG5.3", "bad-nurbs"),
        ("G5.2 L99\nX4 Y4\nX9 Y9\nG5.3", "bad-nurbs"),
        ("G5.2\nX4 Y4 P-1\nX9 Y9\nG5.3", "bad-nurbs"),
        ("G5.2 P0\nX4 Y4\nX9 Y9\nG5.3", "bad-nurbs"),
        ("G5.2\nX4 Y4\nX9 Y9\nG1 X9 Y9", "nurbs-not-closed"),
        ("G5.2\nX4 Y4\nX9 Y9", "nurbs-not-closed"),
        ("G5.2\nX4 Y4\nP2\nX9 Y9\nG5.3", "bad-nurbs"),
        ("G1 X9 Y9\nG5.3", "nurbs-not-open"),
        ("G6.2 P3 K0\nX4 Y4 K0\nX9 Y9 K0\nK1\nK1", "bad-nurbs"),
        ("G6.2 P3 K0\nX4 Y4 K0\nX9 Y9\nK1\nK1\nK1", "bad-nurbs"),
        ("G6.2 P3 K0\nX4 Y4 K0\nX9 Y9 K0\nK1\nK0.5\nK1", "bad-nurbs"),
        ("G6.2 P3 K0\nX4 Y4 K0\nX9 Y9 K0\nK1\nK2\nK3", "bad-nurbs"),
        ("G6.2 P1 K0\nX4 Y4 K0\nX9 Y9 K0\nK1\nK1\nK1", "bad-nurbs"),
        ("G6.2 P3 K0\nX4 Y4 K0 R-1\nX9 Y9 K0\nK1\nK1\nK1", "bad-nurbs"),
        ("G5 X9 Y9 Z2 I1 J1 P1 Q1", "z-in-spline"),
        ("G06.1\nX9 Y9", "too-few-points"),
    ];
    for (blocks, code) in cases {
        let text = format!("F600\nG0 X0 Y0\n{blocks}\nM30\n");
        let read = read(&text, Dialect::Auto);
        let errors: Vec<_> = read.diagnostics.iter().filter(|d| d.severity == ERROR).collect();
        assert_eq!(errors.iter().map(|d| d.code).collect::<Vec<_>>(), [code], "{blocks}");
        let last = moves(&read).last().map(|found| found.curve.end());
        assert_eq!(last, Some(dvec2(9.0, 9.0)), "{blocks}: it leads there all the same");
    }
    let text = "G1 X0 Y0 F9\nBSPLINE SD=5 X9 Y9\nM30\n";
    assert_eq!(found(&read(text, Dialect::Sinumerik)), [("bad-nurbs", ERROR, 2, None)], "a degree");
    let text = "G1 X0 Y0 F9\nX5 PW=2\nASPLINX X9 Y9\n";
    let read = read(text, Dialect::Sinumerik);
    let codes: Vec<_> = found(&read).iter().map(|f| f.0).collect();
    assert_eq!(codes, ["word-not-understood", "unknown-name"], "words without a spline");
}

#[test]
fn a_strict_control_stops_at_a_spline_under_compensation() {
    let rules = Rules { is_strict: true, ..Rules::default() };
    let text = "G0 X0 Y0\nG41 D1 G1 X10 F60\nX20\nG5 X40 Y10 I10 J0 P-10 Q0\nG1 X50\n";
    let read = interpret(&Program::parse(text, Dialect::LinuxCnc), rules);
    assert_eq!(found(&read), [("refused", ERROR, 4, Some(1))], "{:?}", read.diagnostics);
    let text = "F60\nG0 X0 Y0\nG5 X10 Y5\n";
    let read = interpret(&Program::parse(text, Dialect::LinuxCnc), rules);
    assert_eq!(found(&read), [("refused", ERROR, 3, Some(1))], "type points it has none");
}
