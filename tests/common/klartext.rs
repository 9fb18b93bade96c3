//! A controller that knows a few blocks of Heidenhain's conversational language. It shares no code
//! with what writes them, and refuses what it does not know.

use std::f64::consts::{PI, TAU};

use crate::controller::Run;

/// Runs a program, each block in so many steps.
///
/// # Panics
/// Where a block is not understood or not numbered on, where a spline does not begin within a
/// micrometre of where the tool is, or the radii of an arc disagree by more than `radii` mm.
#[must_use]
#[expect(clippy::too_many_lines, reason = "one arm for each kind of block")]
pub(crate) fn run(text: &str, steps: u32, radii: f64) -> Run {
    let mut run = Run { points: vec![[0.0; 3]], ..Run::default() };
    let (mut at, mut center) = ([0.0_f64; 3], [None; 3]);
    let joined = text.replace("~\n", "");
    let count = joined.lines().count();
    for (number, line) in joined.lines().enumerate() {
        let (label, block) = line.split_once(' ').expect("a block has a number");
        assert_eq!(label.parse(), Ok(number), "{line}");
        let ends = number == 0 || number + 1 == count;
        assert_eq!(block.contains(" PGM "), ends, "the program has its first and last: {line}");
        let words: Vec<&str> = block.split_whitespace().collect();
        let number_of = |word: &str, prefix: &str| -> f64 {
            let digits = word.strip_prefix(prefix).expect("it has its letter");
            assert!(digits.starts_with(['+', '-']), "{line}: {word}");
            digits.parse().unwrap_or_else(|_| panic!("no number: {line}: {word}"))
        };
        let find = |prefix: &str| {
            words[1..].iter().find(|word| word.starts_with(prefix)).map(|w| number_of(w, prefix))
        };
        let moves = matches!(words[0], "L" | "CC" | "C" | "CP" | "SPL");
        let axes = ["X", "Y", "Z"].map(|axis| {
            if !moves {
                return None;
            }
            let of_axis = |word: &&&str| word.starts_with(axis);
            words[1..].iter().find(of_axis).map(|word| number_of(word, axis))
        });
        let to = [0, 1, 2].map(|i| axes[i].unwrap_or(at[i]));
        let from = at;
        let mut add = |point: &dyn Fn(f64) -> [f64; 3]| {
            for i in 1..=steps {
                run.points.push(point(f64::from(i) / f64::from(steps)));
            }
        };
        let known = |word: &&str| {
            let number = word.trim_start_matches(|c: char| c.is_ascii_uppercase());
            let is_axis = "XYZABCUVW".contains(&word[..1]) && number.starts_with(['+', '-']);
            let is_feed = word.starts_with('F') && number.parse::<f64>().is_ok();
            is_axis || is_feed || ["R0", "RL", "RR", "FMAX", "M91"].contains(word)
        };
        assert!(words[0] != "L" || words[1..].iter().all(known), "{line}");
        match words[0] {
            "L" if words.contains(&"M91") => run.reset = true,
            "L" => {
                add(&|t| [0, 1, 2].map(|i| from[i] + (to[i] - from[i]) * t));
                at = to;
            }
            "CC" => center = axes,
            "C" | "CP" => {
                let [a, b, normal] = match center {
                    [Some(_), Some(_), None] => [0, 1, 2],
                    [Some(_), None, Some(_)] => [2, 0, 1],
                    [None, Some(_), Some(_)] => [1, 2, 0],
                    _ => panic!("no centre in a plane: {line}"),
                };
                let middle = [center[a].expect("known"), center[b].expect("known")];
                let angle = |p: [f64; 3]| (p[b] - middle[1]).atan2(p[a] - middle[0]);
                let radius = |p: [f64; 3]| (p[a] - middle[0]).hypot(p[b] - middle[1]);
                let clockwise = words.contains(&"DR-");
                assert!(clockwise != words.contains(&"DR+"), "{line}");
                let (start, r) = (angle(from), radius(from));
                let (sweep, climb) = if words[0] == "CP" {
                    let sweep = find("IPA").expect("a helix turns") * PI / 180.0;
                    assert_eq!(sweep < 0.0, clockwise, "{line}");
                    (sweep, find(["IX", "IY", "IZ"][normal]).expect("a helix climbs"))
                } else {
                    assert!(axes[a].is_some() && axes[b].is_some(), "{line}");
                    assert!((radius(to) - r).abs() < radii, "radii disagree: {line}");
                    let sweep = angle(to) - start;
                    let turned = match (clockwise, sweep) {
                        (true, 0.0..) => sweep - TAU,
                        (false, ..=0.0) => sweep + TAU,
                        _ => sweep,
                    };
                    (turned, 0.0)
                };
                let point = |t: f64| {
                    let mut point = from;
                    point[a] = middle[0] + r * (start + sweep * t).cos();
                    point[b] = middle[1] + r * (start + sweep * t).sin();
                    point[normal] += climb * t;
                    point
                };
                add(&point);
                at = if words[0] == "C" { to } else { point(1.0) };
            }
            "SPL" => {
                let powers = ["X", "Y"].map(|axis| {
                    ["K3", "K2", "K1"].map(|k| find(&format!("{k}{axis}")).expect("all are there"))
                });
                // The parameter runs from 1 to 0.
                let point = |t: f64| {
                    let mut point = to;
                    for (i, [k3, k2, k1]) in powers.into_iter().enumerate() {
                        let t = 1.0 - t;
                        point[i] += ((k3 * t + k2) * t + k1) * t;
                    }
                    point
                };
                for (start, from) in point(0.0).into_iter().zip(from).take(2) {
                    assert!((start - from).abs() < 1e-3, "it starts elsewhere: {line}");
                }
                add(&point);
                at = to;
            }
            "BEGIN" | "END" | "TOOL" | "CYCL" | "M2" | "M30" => run.words.push(block.into()),
            word if word.starts_with(['M', ';']) => run.words.push(block.into()),
            _ => panic!("not understood: {line}"),
        }
    }
    run
}
