//! SINUMERIK's names, jumps, dimensions and programmable frames.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::contour::MoveCurve;
use g41::program::Dialect::Sinumerik;
use g41::program::{Program, Rules, RunOptions, Runner, interpret};

use super::sample::{codes, steps, xs};

fn read(text: &str) -> g41::program::Interpretation {
    interpret(&Program::parse(text, Sinumerik), Rules::default())
}

/// What a program makes, and that nothing was said but what is left out for good.
fn clean(text: &str) -> Vec<String> {
    let read = read(text);
    assert!(read.diagnostics.iter().all(|d| d.code == "noted"), "{text}: {:?}", read.diagnostics);
    steps(&read)
}

#[test]
fn labels_are_found_downwards_and_upwards() {
    let text = "R1=0\nG0 X0\nG91\nAGAIN:\nX10\nR1=R1+1\nIF R1<3 GOTOB AGAIN\nGOTOF LAST\nX100\n\
                N50 LAST: X1\nM30\n";
    assert_eq!(xs(text, Sinumerik), [10.0, 20.0, 30.0, 31.0], "three times, and over X100");
    let numbers = "G0 X1\nGOTOF N30\nX100\nN30 X2\nM30\n";
    assert_eq!(xs(numbers, Sinumerik), [1.0, 2.0], "by the number of the block");
    for (condition, holds) in [
        ("R1==2", true),
        ("R1<>2", false),
        ("R1>=2", true),
        ("R1<=1", false),
        ("(R1>1) AND (R1<3)", true),
    ] {
        let text =
            format!("R1=2\nG0 X1\nIF {condition} GOTO ON\nG91\nX100\nG90\nON:\nG91 X1\nM30\n");
        let found = xs(&text, Sinumerik).last().copied();
        assert_eq!(found, Some(if holds { 2.0 } else { 102.0 }), "{condition}");
    }
    for text in ["G0 X1\nGOTOB ON\nON:\nM30\n", "ON:\nG0 X1\nGOTOF ON\nM30\n"] {
        assert_eq!(codes(text, Sinumerik), ["missing-block"], "the other way: {text}");
    }
    let endless = Program::parse("AB:\nG0 X1\nGOTOB AB\n", Sinumerik);
    let options = RunOptions { most_blocks: 1000, ..RunOptions::default() };
    let mut runner = Runner::new(&endless, options);
    while runner.step(100) {}
    assert_eq!(runner.finish().diagnostics[0].code, "run-too-long", "it has bounds");
}

#[test]
fn dimensions_count_for_one_word() {
    for (block, expected) in [
        ("G90 X=IC(5) Y=IC(-1)", "R 15 19 0"),
        ("G90 X=AC(5)", "R 5 20 0"),
        ("G91 X=AC(5) Y=IC(2)", "R 5 22 0"),
        ("G91 X=AC(2+3) Y1", "R 5 21 0"),
    ] {
        let made = clean(&format!("G0 X10 Y20 Z0\n{block}\nM30\n"));
        assert_eq!(made[1], expected, "{block}");
    }
    let by_centre = clean("G0 X10 Y0 Z0\nG3 X-10 Y0 I=AC(0) J=AC(0) F100\nM30\n");
    let by_offset = clean("G0 X10 Y0 Z0\nG3 X-10 Y0 I-10 J0 F100\nM30\n");
    assert_eq!(by_centre, by_offset, "the centre, and the way to it");
}

#[test]
fn frames_take_the_place_of_others_or_add_to_them() {
    // Places by hand: the point (1, 2, 0) in the frames.
    for (frames, expected) in [
        ("TRANS X10 Y5", "R 11 7 0"),
        ("TRANS X10\nTRANS Y5", "R 1 7 0"),
        ("TRANS X10\nATRANS Y5 Z3", "R 11 7 3"),
        ("TRANS X10\nTRANS", "R 1 2 0"),
        ("ROT RPL=90", "R -2 1 0"),
        ("ROT Z90", "R -2 1 0"),
        ("TRANS X10\nAROT RPL=90", "R 8 1 0"),
        ("ROT RPL=90\nATRANS X10", "R -2 11 0"),
        ("AROT RPL=30\nAROT RPL=60", "R -2 1 0"),
        ("TRANS X10\nROT RPL=90", "R -2 1 0"),
        ("MIRROR X0", "R -1 2 0"),
        ("ROT RPL=90\nAMIRROR X0", "R -2 -1 0"),
        ("MIRROR X0\nAROT RPL=90", "R 2 1 0"),
        ("MIRROR X0\nAMIRROR X0", "R 1 2 0"),
        ("SCALE X2 Y2", "R 2 4 0"),
        ("TRANS X10\nASCALE X2 Y2\nATRANS X1", "R 14 4 0"),
    ] {
        let made = clean(&format!("G0 X0 Y0 Z0\n{frames}\nX1 Y2 Z0\nM30\n"));
        assert_eq!(made[1], expected, "{frames}");
    }
    let tilted = "G0 X0 Y0 Z0\nROT X30\nX1\nM30\n";
    assert_eq!(codes(tilted, Sinumerik), ["not-supported"], "out of the plane");
    assert_eq!(codes("G0 X0 Y0 Z0\nSCALE X0\nX1\nM30\n", Sinumerik), ["bad-scale"], "no factor");
}

#[test]
fn what_moves_nothing_is_noted_and_what_is_unknown_said_once() {
    let text = "G500 G64 SOFT FFWON\nCYCLE832(0.01,1,1)\nCYCLE800()\nFGROUP(X,Y)\nLIMS=3000\n\
                WORKPIECE(,,,\"BOX\")\nSTOPRE\nG0 G60 X1 COMPCAD Y2\nM30\n";
    let read = read(text);
    assert!(read.diagnostics.iter().all(|d| d.code == "noted"), "{:?}", read.diagnostics);
    assert!(steps(&read).iter().any(|step| step.starts_with("R 1 2")), "{:?}", steps(&read));
    assert_eq!(
        codes("G0 X1\nPOCKET3(50,0,2,-5) X3\nG1 X5 F10\nM30\n", Sinumerik),
        ["unknown-name"],
        "a cycle"
    );
    assert_eq!(
        codes("G0 X1\nT=\"MILL 10\" D1\nM30\n", Sinumerik),
        ["tool-name"],
        "a tool by its name"
    );
}

#[test]
fn exact_stop_makes_no_rapid() {
    let made = clean("G0 X0 Y0 Z0\nG1 G60 X5 F100\nM30\n");
    assert_eq!(made[1], "5 0 0", "{made:?}");
}

/// Centres and senses of the arcs of a program.
fn arcs(text: &str) -> Vec<(f64, f64, bool)> {
    let round = |value: f64| (value * 1e9).round() / 1e9 + 0.0;
    let found = super::sample::moves(&read(text));
    let arc = |one: &g41::contour::Move| match one.curve {
        MoveCurve::Arc(arc) => {
            Some((round(arc.center().x), round(arc.center().y), arc.is_clockwise()))
        }
        _ => None,
    };
    found.iter().filter_map(arc).collect()
}

#[test]
fn arcs_by_tangent_point_and_angle() {
    // By hand: quarters and halves of circles of 10 mm.
    for (block, expected) in [
        ("CT X20 Y10", (10.0, 10.0, false)),
        ("CT X20 Y-10", (10.0, -10.0, true)),
        ("CT X10 Y20", (10.0, 10.0, false)),
        ("CIP X10 Y20 I1=20 J1=10", (10.0, 10.0, false)),
        ("CIP X10 Y20 I1=0 J1=10", (10.0, 10.0, true)),
        ("G91 CIP X0 Y20 I1=10 J1=10", (10.0, 10.0, false)),
        ("G3 X20 Y10 AR=90", (10.0, 10.0, false)),
        ("G2 X20 Y10 AR=270", (10.0, 10.0, true)),
        ("G3 I0 J10 AR=90", (10.0, 10.0, false)),
        ("G3 X20 Y10 I=AC(10) J=AC(10)", (10.0, 10.0, false)),
    ] {
        let text = format!("G0 X0 Y0 Z0\nG1 X10 F100\n{block}\nM30\n");
        assert_eq!(arcs(&text), [expected], "{block}");
    }
    let turned = read("G0 X0 Y0 Z0\nG1 X10 F100\nG3 I0 J10 AR=90\nX0\nM30\n");
    assert_eq!(steps(&turned)[2], "20 10 0", "where the angle ends: {:?}", steps(&turned));
    let helix = arcs("G0 X0 Y0 Z0\nG1 X10 F100\nG3 X20 Y10 Z-6 I0 J10 TURN=2\nM30\n");
    assert_eq!(helix.len(), 3, "two whole turns more");
    assert_eq!(arcs("G0 X0 Y0 Z0\nG1 X10 F100\nCT X20 Y0\nM30\n").len(), 0, "straight on");
}
