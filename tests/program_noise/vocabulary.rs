//! What programs of noise are made of: seeded letters, words, curves, lines of the language.

use std::fmt::Write;

/// A seeded generator of the splitmix kind: short, and good enough to mix letters.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }

    pub(crate) fn pick<'a>(&mut self, from: &[&'a str]) -> &'a str {
        let index = usize::try_from(self.below(from.len() as u64)).expect("an index");
        from[index]
    }
}
/// Bytes of every kind, as far as they are text.
pub(crate) fn bytes(random: &mut Random, length: usize) -> String {
    let bytes: Vec<u8> = (0..length).map(|_| random.next().to_le_bytes()[0]).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Letters, digits and signs that programs consist of, in no order.
pub(crate) fn characters(random: &mut Random, length: usize) -> String {
    const ALPHABET: &[u8] = b"GGGXXYYZIJRNMSTFDPQ0123456789..-- \n\n(;)%#[]/OA";
    let pick = |random: &mut Random| {
        let index = usize::try_from(random.below(ALPHABET.len() as u64)).expect("an index");
        char::from(ALPHABET[index])
    };
    (0..length).map(|_| pick(random)).collect()
}

/// Proper words in no order.
pub(crate) fn words(random: &mut Random, count: usize) -> String {
    const WORDS: [&str; 112] = [
        "G0", "G1", "G1", "G1", "G2", "G3", "G05", "G05", "G17", "G18", "G20", "G21", "G40", "G40",
        "G41", "G42", "G41", "G41.1", "G42.1", "G90", "G91", "G90.1", "G91.1", "G4", "G28", "G81",
        "G80", "G5.1", "G92", "G53", "M3", "M6", "M0", "T1", "S900", "F600", "F0", "D1", "D2",
        "(c)", "/", "G10", "G43", "G64", "G93", "G94", "G54", "M8", "G19", "G15", "G16", "G50",
        "G51", "G50.1", "G51.1", "G52", "G55", "G68", "G69", "G7", "G8", "G73", "G74", "G76",
        "G83", "G84", "G86", "G87", "G88", "G89", "G92.1", "G92.2", "G92.3", "G95", "G96", "G97",
        "G98", "G99", "G28.1", "G53", "L2", "L20", "P1", "G49", "G33", "G33.1", "G38.2", "G38.5",
        "G31", "G60", "G67", "G12.1", "G13.1", "G30", "G28", "B5", "C-3", "U2", "V1", "W-1", "K1",
        "G70", "G71", "G461", "G22", "G103", "G110", "G154", "G187", "G505", "M97", "M98",
    ];
    const LETTERS: [&str; 15] =
        ["X", "Y", "X", "Y", "X", "Y", "Z", "I", "J", "R", "P", "Q", "K", "L", "A"];
    const NUMBERS: [&str; 14] = [
        "0",
        "1",
        "-1",
        "10",
        "10.5",
        "-7.25",
        "3",
        "25",
        "1e5",
        "",
        "1000000000",
        "0.00001",
        "-0.0000000001",
        "999999999",
    ];
    let mut text = String::new();
    for _ in 0..count {
        if random.below(3) == 0 {
            text.push_str(random.pick(&WORDS));
        } else {
            text.push_str(random.pick(&LETTERS));
            let usual = random.below(20) > 0;
            text.push_str(random.pick(if usual { &NUMBERS[..8] } else { &NUMBERS[8..] }));
        }
        text.push(if random.below(4) == 0 { '\n' } else { ' ' });
    }
    text
}

/// Blocks of curves, and words between them, in no order.
pub(crate) fn curves(random: &mut Random, count: usize) -> String {
    const HEADS: [&str; 58] = [
        "G5",
        "G5.1",
        "G5.2",
        "G5.2 P1 L3",
        "G5.3",
        "G5.3",
        "G6.1",
        "G6.2 P3",
        "G6.2 P4 Q1",
        "G6.2",
        "ASPLINE",
        "BSPLINE",
        "BSPLINE SD=2",
        "CSPLINE",
        "BAUTO",
        "BNAT",
        "ETAN",
        "ENAT CSPLINE",
        "G1",
        "G2 CR=5",
        "G41 D1 G1",
        "G40",
        "G18",
        "G17",
        "G91",
        "G90",
        "G20",
        "G21",
        "G51.1",
        "M3",
        "G93 F2",
        "G4 P1",
        "TRANS",
        "ATRANS",
        "ROT RPL=30",
        "AROT RPL=-100",
        "MIRROR",
        "AMIRROR",
        "ASCALE",
        "SCALE",
        "IF R1==0 GOTOF AB",
        "AB:",
        "G1 X=IC(1) Y=AC(3)",
        "CYCLE800()",
        "CT",
        "CIP I1=1 J1=-2",
        "G3 AR=90",
        "G2 TURN=2",
        "G111 X5 Y2",
        "G110 AP=30 RP=4",
        "AP=50 RP=10",
        "RP=IC(3)",
        "G3 AP=-80",
        "MCALL CYCLE83(9,0,1,-7,,-3,,0.8,,,1,1)",
        "MCALL",
        "CYCLE82(9,0,1,,4,0.2)",
        "AA:",
        "REPEATB AA P=2",
    ];
    const WORDS: [&str; 14] =
        ["X", "Y", "X", "Y", "X", "Y", "Z", "I", "J", "P", "Q", "K", "R", "L"];
    const NUMBERS: [&str; 12] =
        ["0", "1", "2", "3", "-4", "10.5", "-7.25", "25", "1e3", "0.001", "9999999", "1000000000"];
    let mut text = String::from("G0 X0 Y0\nF600\n");
    for _ in 0..count {
        if random.below(3) == 0 {
            text.push_str(random.pick(&HEADS));
            text.push(' ');
        }
        for _ in 0..random.below(5) {
            let named = ["PW=", "PL="];
            let usual = random.below(12) > 0;
            text.push_str(if usual { random.pick(&WORDS) } else { random.pick(&named) });
            text.push_str(random.pick(&NUMBERS[..if usual { 8 } else { 12 }]));
            text.push(' ');
        }
        text.push('\n');
    }
    text
}

/// A value as expressions have it, nested up to `depth`.
pub(crate) fn value(random: &mut Random, depth: u64) -> String {
    const SIMPLE: [&str; 24] = [
        "1",
        "2",
        "0",
        "0.5",
        "-3",
        "10.25",
        "1000000",
        "#1",
        "#2",
        "#3",
        "#100",
        "#<a>",
        "#<_b>",
        "##1",
        "#[1+1]",
        "#5420",
        "#5421",
        "#<_x>",
        "#0",
        "#<_value>",
        "R1",
        "",
        "1..2",
        "#5221",
    ];
    const OPERATORS: [&str; 17] = [
        "+", "-", "*", "/", "**", " MOD ", " EQ ", " NE ", " GT ", " GE ", " LT ", " LE ", " AND ",
        " OR ", " XOR ", "", "(",
    ];
    const FUNCTIONS: [&str; 20] = [
        "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "SQRT", "ABS", "EXP", "LN", "FIX", "FUP",
        "ROUND", "BIN", "BCD", "POW", "EXISTS", "NOSUCH", "atan2", "-",
    ];
    match random.below(if depth == 0 { 3 } else { 8 }) {
        0..=3 => random.pick(&SIMPLE).to_owned(),
        4 | 5 => {
            let operator = random.pick(&OPERATORS);
            format!("[{}{operator}{}]", value(random, depth - 1), value(random, depth - 1))
        }
        6 => {
            let function = random.pick(&FUNCTIONS);
            let second = random.pick(&["", "", "", "/[2]", ",3]", "]"]);
            format!("{function}[{}]{second}", value(random, depth - 1))
        }
        _ => format!("[{}", value(random, depth - 1)),
    }
}

/// One line of a program in no dialect and all of them.
pub(crate) fn line(random: &mut Random) -> String {
    let label = random.pick(&["1", "2", "3", "<a>", "<B >", "[#1]", "#2", "1"]);
    let number = random.pick(&["1", "2", "10", "20", "5"]);
    let mut value = |depth| value(random, depth);
    let [a, b, c] = [value(3), value(2), value(1)];
    match random.below(46) {
        0 => format!("o{label} sub"),
        1 => format!("o{label} endsub {a}"),
        2 | 3 => format!("o{label} call [{a}] [{b}]"),
        4 => format!("o{label} return [{a}]"),
        5 => format!("o{label} if [{a}]"),
        6 => format!("o{label} elseif [{a}]"),
        7 => format!("o{label} else"),
        8 | 9 => format!("o{label} endif"),
        10 => format!("o{label} while [{a}]"),
        11 | 12 => format!("o{label} endwhile"),
        13 => format!("o{label} do"),
        14 => format!("o{label} repeat [{b}]"),
        15 | 16 => format!("o{label} endrepeat"),
        17 => format!("o{label} {}", random.pick(&["break", "continue", "", "nosuch"])),
        18 => format!("O{number} ({a})"),
        19 => format!("M98 P{number} L{b}"),
        20 => random.pick(&["M99", "M99 P10", "M30", "%", "M2", "/M99"]).to_owned(),
        21 => {
            let call = random.pick(&["G65", "G65", "G66", "G67 G66"]);
            format!("{call} P{number} A{a} I{b} I{c} X{c}")
        }
        22 => format!("IF [{a}] GOTO {number}"),
        23 => format!("IF [{a}] THEN #{number}={b}"),
        24 => format!("WHILE [{a}] DO{number}"),
        25 => format!("{}{number}", random.pick(&["END", "DO", "GOTO"])),
        26 => format!("#{number}={a}"),
        27 => format!("#<{}>={a} #1={b}", random.pick(&["a", "_b", "c d", "_x"])),
        28 => {
            let word = random.pick(&["", "KONTT", "NORM", "OFFN=1", "G41", "G40 I1 J2 G1"]);
            format!("R{number}={a} X={b} {word}")
        }
        29 => format!("N{number} G91 G1 X{a} F{b}"),
        30 => format!("G{} X{a} Y{b} R{c}", random.pick(&["0", "1", "2", "3", "5", "81"])),
        31 => format!("{} {}", words(random, 4).replace('\n', " "), a),
        33 => format!("WHILE {a}<{b}"),
        34 => random.pick(&["ENDWHILE", "ENDFOR", "ENDLOOP", "ENDIF", "ELSE"]).to_owned(),
        35 => format!("FOR R{number}={a} TO {b}"),
        36 => random.pick(&["LOOP", "REPEAT", "ENDFOR", "ENDIF", "AA: BB:"]).to_owned(),
        37 => format!("UNTIL R{number}=={a}"),
        38 => format!("IF R{number}<>{a}"),
        39 => format!("CASE {a} OF {b} GOTOF AA DEFAULT GOTO BB"),
        40 => format!("DEF {} AA={a}, BB[3], CC", random.pick(&["INT", "REAL", "BOOL"])),
        41 => format!("AA={a} BB[{b}]=AA*2 R[{c}]=CC"),
        42 => format!("{} SUB1({a},,{b}) P{number}", random.pick(&["", "PROC", "MCALL"])),
        43 => random.pick(&["%_N_SUB1_SPF", "PROC SUB1(REAL AA)", "M17", "RET"]).to_owned(),
        44 => format!(
            "{} AA {} P={number}",
            random.pick(&["REPEAT", "REPEATB"]),
            random.pick(&["", "BB"])
        ),
        32 => format!("/{number} G0 X{a} (c) ; {b}"),
        _ => characters(random, 12),
    }
}

/// Involutes of circles of any size, tight and far unwound, whose ends are on them, or nearly.
pub(crate) fn involutes(random: &mut Random, count: usize) -> String {
    let unit = |random: &mut Random| random.below(1 << 53) as f64 / (1_u64 << 53) as f64;
    let mut text = String::from("G21 G90\nG0 X-30 Y-30\nG1 F600\n");
    for _ in 0..count {
        let radius = 10_f64.powf(6.0 * unit(random) - 3.0);
        let most = [0.1, 1.0, 3.0, 9.0][usize::try_from(random.below(4)).expect("an index")];
        let (first, sense) = (7.0 * unit(random), if random.below(2) == 0 { 1.0 } else { -1.0 });
        let at = |roll: f64| {
            let (sin, cos) = (first + sense * roll).sin_cos();
            let thread = sense * roll;
            [radius * (cos + thread * sin), radius * (sin - thread * cos)]
        };
        let start = if random.below(4) == 0 { 0.0 } else { most * unit(random) };
        let end = if random.below(4) == 0 { 0.0 } else { most * unit(random) };
        let off = [0.0, 1e-3, 1e-2, 1.0][usize::try_from(random.below(4)).expect("an index")];
        let ([x0, y0], [x1, y1]) = (at(start), at(end));
        let word = if (end > start) == (sense > 0.0) { "G3.2" } else { "G2.2" };
        let side = random.pick(&["G41 D1", "G42 D1", "", ""]);
        let _ = writeln!(text, "G1 {side} X{x0:.4} Y{y0:.4}");
        let _ =
            writeln!(text, "{word} X{:.4} Y{y1:.4} I{:.4} J{:.4} R{radius:.4}", x1 + off, -x0, -y0);
        let _ = writeln!(text, "G1 {} X{} Y{}", random.pick(&["", "G40"]), x1 + 5.0, y1 - 3.0);
    }
    text
}

/// Lines and arcs with corners to be rounded and chamfered, in the words of FANUC or of SINUMERIK, and
/// words between them.
pub(crate) fn corners(random: &mut Random, count: usize) -> String {
    const FANUC: [&str; 5] = [",R", ",C", ",R", ",C", ",A"];
    const SINUMERIK: [&str; 6] = ["RND=", "CHR=", "CHF=", "RND=", "RNDM=", "FRC="];
    const BETWEEN: [&str; 14] = [
        "M8", "G4 P1", "(c)", "G40", "G41 D1", "G42 D2", "Z1", "G91", "G90", "G93", "G94",
        "G28 Z0", "G18", "G17",
    ];
    let fanuc = random.below(2) == 0;
    let mut text = String::from(if fanuc { "G0 X0 Y0 F600\n" } else { "G0 X=0 Y0 F600\n" });
    for _ in 0..count {
        if random.below(5) == 0 {
            text.push_str(random.pick(&BETWEEN));
            text.push(if random.below(2) == 0 { '\n' } else { ' ' });
        }
        let motion = random.pick(&["G1", "G1", "G1", "G2", "G3", "G0", ""]);
        let [x, y] = [random.below(9) * 10, random.below(9) * 10];
        let _ = write!(text, "{motion} X{x} Y{y}");
        if motion == "G2" || motion == "G3" {
            let _ = write!(text, " {}{}", if fanuc { "R" } else { "CR=" }, 40 + random.below(60));
        }
        if random.below(3) > 0 {
            let word = if fanuc { random.pick(&FANUC) } else { random.pick(&SINUMERIK) };
            let size = random.pick(&["0", "1", "2.5", "5", "10", "30", "-1", "0.000001", "1e3"]);
            let _ = write!(text, " {word}{size}");
        }
        text.push('\n');
    }
    text
}
