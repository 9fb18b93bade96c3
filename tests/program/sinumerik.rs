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
        // By the manual's order comparisons bind least: 3 == (1 AND 3), and (3 > 1) or nothing.
        ("3==1 AND 3", false),
        ("NOT R1==0", true),
        // Equal to 12 digits is equal, whatever is asked.
        ("0.1+0.2==0.3", true),
        ("0.1+0.2>0.3", false),
        ("0.3>=0.1+0.2", true),
        ("1.00001==1", false),
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
        ["missing-subprogram"],
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

#[test]
fn loops_and_conditions_have_their_own_names() {
    // X of the moves, by hand.
    for (text, expected) in [
        ("FOR R1=1 TO 3\nX=R1*10\nENDFOR\nX=R1", &[10.0, 20.0, 30.0, 4.0][..]),
        ("FOR R1=5 TO 3\nX100\nENDFOR\nX1", &[1.0]),
        (
            "DEF INT II\nFOR II=2 TO R5+3\nFOR R2=1 TO 2\nX=II*10+R2\nENDFOR\nENDFOR",
            &[21.0, 22.0, 31.0, 32.0],
        ),
        ("WHILE R1<2\nR1=R1+1\nX=R1\nENDWHILE\nX9", &[1.0, 2.0, 9.0]),
        ("N10 again: while (R1 < 1)\nN20 R1=R1+1 ; once\nX=R1\nN30 endwhile", &[1.0]),
        ("REPEAT\nR1=R1+1\nX=R1\nUNTIL R1>=3", &[1.0, 2.0, 3.0]),
        ("REPEAT\nWHILE R1<2\nR1=R1+1\nX=R1\nENDWHILE\nR2=R2+1\nUNTIL R2==2\nX7", &[1.0, 2.0, 7.0]),
        ("LOOP\nR1=R1+1\nX=R1\nIF R1==2 GOTOF OUT\nENDLOOP\nOUT: X8", &[1.0, 2.0, 8.0]),
        ("R1=2\nIF R1==2\nX1\nELSE\nX2\nENDIF\nX3", &[1.0, 3.0]),
        ("R1=3\nIF NOT (R1<>2)\nX1\nELSE\nIF R1>2\nX4\nENDIF\nX2\nENDIF\nX3", &[4.0, 2.0, 3.0]),
        ("IF R1==1\nX1\nENDIF\nX3", &[3.0]),
        ("IF R1==1 GOTOF AA IF R1==0 GOTOF BB\nX9\nAA: X1\nBB: X2", &[2.0]),
        (
            "CASE R1+2 OF 1 GOTOF AA 2 GOTOF BB DEFAULT GOTOF CC\nAA: X1\nBB: X2\nCC: X3",
            &[2.0, 3.0],
        ),
        ("CASE(R1) OF 1 GOTOF AA DEFAULT GOTOF CC\nX9\nAA: X1\nCC: X3", &[3.0]),
        ("CASE R1 OF 1 GOTOF AA\nX9\nAA: X1", &[9.0, 1.0]),
    ] {
        let program = format!("R1=0 R2=0 R5=0\nG0\n{text}\nM30\n");
        assert_eq!(xs(&program, Sinumerik), expected, "{text}");
    }
    for text in ["WHILE R1<3\nX1\nENDLOOP", "FOR R1=1 TO 3\nX1", "ENDIF\nX1", "UNTIL R1>2\nX1"] {
        let program = format!("R1=5\nG0\n{text}\nM30\n");
        assert!(codes(&program, Sinumerik).contains(&"unmatched-flow"), "{text}");
    }
    for text in ["FOR R1=1\nX1\nENDFOR", "FOR 5 TO 6\nX1\nENDFOR", "FOR R1=1 TO\nX1\nENDFOR"] {
        let program = format!("G0\n{text}\nM30\n");
        assert_eq!(codes(&program, Sinumerik), ["bad-expression"], "{text}");
    }
    for text in [
        "LOOP\nG0 X1\nENDLOOP\n",
        "FOR R1=1 TO 1000000000\nENDFOR\n",
        "AA:\nREPEAT AA P=99999999\n",
    ] {
        let endless = Program::parse(text, Sinumerik);
        let options = RunOptions { most_blocks: 1000, ..RunOptions::default() };
        let mut runner = Runner::new(&endless, options);
        while runner.step(100) {}
        assert_eq!(runner.finish().diagnostics[0].code, "run-too-long", "bounded: {text}");
    }
}

#[test]
fn variables_have_names_kinds_and_fields() {
    for (text, expected) in [
        ("DEF REAL WIDTH=2.5, _D\n_D=WIDTH*2\nX=_D+width", 7.5),
        ("DEF INT CNT=2.6\nX=CNT", 3.0),
        ("DEF INT CNT\nCNT=7/2\nX=CNT", 4.0),
        ("DEF BOOL OK=TRUE\nIF OK AND NOT FALSE\nX=1\nENDIF", 1.0),
        ("DEF REAL TAB[3], MAT[2,2]\nTAB[1]=5 MAT[1,0]=2\nX=TAB[1]+MAT[1,0]*10+TAB[2]", 25.0),
        ("R10=4 R[3+2]=6\nX=R[R10+1]+R10", 10.0),
        ("X=7 DIV 2+7 MOD 4", 6.0),
        ("R1=1.5EX2 R2=-25EX-1\nX=R1+R2", 147.5),
        ("X=ROUND(2.5)+TRUNC(-2.5)+POT(3)+SQRT(16)+ABS(-1)", 15.0),
        ("X=ATAN2(1,1)+SIN(30)+COS(60)+TAN(45)", 47.0),
    ] {
        let program = format!("G0\n{text}\nM30\n");
        assert_eq!(xs(&program, Sinumerik), [expected], "{text}");
    }
    for quiet in
        ["EXTERN SUB1(VAR REAL[3], INT)\nG0 X1\nM30\n", "G0 X1 M1=3 S1=900\nS3=100 M3=5\nM30\n"]
    {
        clean(quiet);
    }
    assert_eq!(codes("G0 X1\nX=WIDTH\nM30\n", Sinumerik), ["unset-parameter"], "never defined");
    assert_eq!(codes("G0 X1\nWIDTH=5\nM30\n", Sinumerik), ["unknown-name"], "set, not defined");
    assert_eq!(codes("DEF STRING[9] AA\nG0 X1\nM30\n", Sinumerik), ["unknown-name"], "no number");
    assert_eq!(codes("$TC_DP6[1,1]=5\nG0 X1\nM30\n", Sinumerik), ["left-out"], "the machine's");
}

#[test]
fn subprograms_are_called_by_name() {
    let file = "%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\nR1=1\nG0 X1\nHOLE\nL20 P2\nRECT(3,R1+4)\nX9\nM30\n\
                %_N_HOLE_SPF\nX10\nM17\n%_N_L20_SPF\nG91 X1\nG90\nRET\n\
                %_N_RECT_SPF\nPROC RECT(REAL AA, INT BB) SAVE\nDEF REAL CC\nCC=AA*BB\nX=CC\nR1=5\nM30\n";
    assert_eq!(xs(file, Sinumerik), [1.0, 10.0, 11.0, 12.0, 15.0, 9.0], "each by its name");
    let deep = "PROC MAIN\nG0 X1\nOUTER(2)\nX9\nM30\nPROC OUTER(REAL AA)\nINNER(AA+1)\nX=AA\nM17\n\
                PROC INNER(REAL AA)\nX=AA\nM17\n";
    assert_eq!(xs(deep, Sinumerik), [1.0, 3.0, 2.0, 9.0], "their variables are their own");
    assert_eq!(
        codes("G0 X1\nOTHER(5)\nL7\nX2\nM30\n", Sinumerik),
        ["missing-subprogram", "missing-subprogram"],
        "files of their own"
    );
    let after = "%\nG0 X1\nGOTOF AA\n%\n%_N_SUB1_SPF\nAA: X2\n";
    assert_eq!(
        codes(after, Sinumerik),
        ["missing-block", "after-end"],
        "behind the end is nothing"
    );
    let own = "G0 X1\nSUB1\nM30\n%_N_SUB1_SPF\nSUB1\nM17\n";
    assert_eq!(codes(own, Sinumerik), ["nested-too-deep"], "one that calls itself");
}

#[test]
fn sections_are_repeated() {
    for (text, expected) in [
        ("AA: X1\nX2\nREPEAT AA P=2\nX3", &[1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 3.0][..]),
        ("AA: X1\nX2\nBB: X3\nX4\nREPEAT AA BB\nX5", &[1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 3.0, 5.0]),
        ("X0.5\nG91\nN10 AA: X1\nX2\nREPEATB AA P=2\nX3", &[0.5, 1.5, 3.5, 4.5, 5.5, 8.5]),
        ("GOTOF ON\nAA: X1\nX2\nBB:\nON: REPEAT AA BB P=1\nX3", &[1.0, 2.0, 3.0]),
    ] {
        assert_eq!(xs(&format!("G0\n{text}\nM30\n"), Sinumerik), expected, "{text}");
    }
    assert_eq!(codes("G0 X1\nREPEAT ZZ P=3\nM30\n", Sinumerik), ["missing-block"], "no label");
}

#[test]
fn points_are_told_about_a_pole() {
    for (blocks, expected) in [
        ("G111 X10 Y5\nAP=90 RP=3", "R 10 8 0"),
        ("G111 X10 Y5\nAP=0 RP=3\nAP=180", "R 7 5 0"),
        ("G110 X1 Y1\nAP=270 RP=1", "R 2 1 0"),
        ("G111 X10 Y5\nG112 X1\nRP=2 AP=0", "R 13 5 0"),
        ("RP=2 AP=30\nAP=IC(60)", "R 0 2 0"),
        ("G111 X10\nAP=90 RP=4 Z3", "R 10 4 3"),
        ("TRANS X100\nG111 X10\nRP=1 AP=0", "R 111 0 0"),
        ("G18 G111 Z10\nAP=90 RP=1", "R 1 1 10"),
    ] {
        let made = clean(&format!("G0 X1 Y1 Z0\n{blocks}\nM30\n"));
        assert_eq!(
            made.iter().rev().find(|step| !step.starts_with('M')).map(String::as_str),
            Some(expected),
            "{blocks}"
        );
    }
    let arc = arcs("G0 X20 Y0 Z0\nG111 X10 Y0\nG3 AP=90 RP=10 F100\nM30\n");
    assert_eq!(arc, [(10.0, 0.0, false)], "the pole is the centre");
}

#[test]
fn drilling_cycles_are_expanded() {
    let drill = |cycle: &str| clean(&format!("G0 X1 Y2 Z10\nF100\n{cycle}\nM30\n"));
    for (cycle, expected) in [
        ("CYCLE81(10,0,2,-5)", &["R 1 2 2", "1 2 -5", "R 1 2 10"][..]),
        ("CYCLE81(8,1,2,,5)", &["R 1 2 3", "1 2 -4", "R 1 2 8"]),
        ("CYCLE82(10,0,2,-5,,1.5)", &["R 1 2 2", "1 2 -5", "G4 P1.5", "R 1 2 10"]),
        (
            "CYCLE83(10,0,2,-10,,-4,,0,,,1,0)",
            &["R 1 2 2", "1 2 -4", "1 2 -3", "1 2 -8", "1 2 -7", "1 2 -10", "R 1 2 10"],
        ),
        (
            "CYCLE83(10,0,2,-10,,,6,2,,,1,1)",
            &["R 1 2 2", "1 2 -6", "R 1 2 2", "R 1 2 -5.4", "1 2 -10", "R 1 2 10"],
        ),
        ("CYCLE83(12,5,1,-1,,,,1,,,1,0)", &["R 1 2 6", "1 2 -1", "R 1 2 12"]),
        (
            "CYCLE83 (10,0,2,-5,,,2,-1,0,0,1,0,,2,1,0,0)",
            &["R 1 2 2", "1 2 -2", "1 2 -1", "1 2 -4", "1 2 -3", "1 2 -5", "R 1 2 10"],
        ),
        ("G91\nCYCLE81(10,0,2,-5)", &["R 1 2 2", "1 2 -5", "R 1 2 10"]),
    ] {
        let made = drill(cycle);
        assert_eq!(made[1..made.len() - 1], *expected, "{cycle}");
    }
    let modal = drill("MCALL CYCLE81(10,0,2,-5)\nX5\nTRANS X10\nY3\nMCALL\nX7");
    let expected = [
        "R 5 2 10",
        "R 5 2 2",
        "5 2 -5",
        "R 5 2 10",
        "R 5 3 10",
        "R 5 3 2",
        "5 3 -5",
        "R 5 3 10",
        "R 17 3 10",
    ];
    assert_eq!(modal[1..modal.len() - 1], expected, "behind every block that moves, until MCALL");
    for (cycle, code) in [
        ("CYCLE81(10,0,2,5)", "cycle-not-possible"),
        ("CYCLE81(10)", "cycle-not-possible"),
        ("CYCLE83(10,0,2,-10,,-4,,-0.5)", "bad-peck"),
        ("CYCLE84(10,0,2,-10)", "missing-subprogram"),
        ("MCALL CYCLE84(10,0,2,-10)", "unknown-name"),
        ("CYCLE81(10,0,2,-5", "bad-expression"),
    ] {
        let program = format!("G0 X1 Y2 Z10\nF100\n{cycle}\nM30\n");
        assert_eq!(codes(&program, Sinumerik), [code], "{cycle}");
    }
}

#[test]
fn a_variable_with_the_name_of_an_address_hides_it() {
    for (lines, expected) in [
        ("DEF INT I\nI=I+1\nI=I+1\nG0 X=I Y0 Z0", "R 2 0 0"),
        ("DEF REAL J=3, K\nK = J*2\nG0 X=K Y0 Z0", "R 6 0 0"),
        ("DEF REAL X1\nX1=X1+7\nG0 X=X1 Y0 Z0", "R 7 0 0"),
        ("DEF INT A[3]\nA[1]=4\nG0 X=A[1] Y0 Z0", "R 4 0 0"),
        ("DEF INT I\nAGAIN:\nI=I+1\nIF I<5 GOTOB AGAIN\nG0 X=I Y0 Z0", "R 5 0 0"),
        ("DEF INT I\nWHILE I<3\nI=I+1\nENDWHILE\nG0 X=I Y0 Z0", "R 3 0 0"),
        // The variable that has another name hides nothing.
        ("DEF INT NO\nNO=4\nG0 X=NO Y0 Z=1", "R 4 0 1"),
    ] {
        let read = read(&format!("{lines}\nM30\n"));
        assert_eq!(steps(&read)[0], expected, "{lines}: {:?}", read.diagnostics);
        let told = if lines.contains("NO") { None } else { Some("short-name") };
        let codes: Vec<_> = read.diagnostics.iter().map(|d| d.code).collect();
        let others = codes.iter().any(|code| Some(*code) != told);
        assert!(!others && codes.is_empty() == told.is_none(), "{lines}: {codes:?}");
    }
}

#[test]
fn assignments_of_a_block_act_from_left_to_right_which_is_told() {
    for (block, expected, told) in [
        ("R1=5 R2=R1*2", 10.0, true),
        ("R1=5 R1=R1+1 R2=R1", 6.0, true),
        ("R3=5 R2=R1*2", 2.0, false),
        ("R2=R1 R1=5", 1.0, false),
    ] {
        let text = format!("R1=1\n{block}\nG0 X=R2\nM30\n");
        let read = read(&text);
        assert_eq!(steps(&read)[0], format!("R {expected} 0 0"), "{block}");
        let codes: Vec<_> = read.diagnostics.iter().map(|d| d.code).collect();
        assert_eq!(codes.contains(&"order-of-assignments"), told, "{block}: {codes:?}");
    }
    assert_eq!(codes("R1=1 G0 X=R1\nM30\n", Sinumerik), ["order-of-assignments"], "a word too");
}
