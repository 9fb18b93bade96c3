//! A controller with nothing but the words that programs are written in. It shares no code with the
//! reader under test, and refuses what it does not know.

use std::f64::consts::TAU;

/// What a controller does with one program.
#[derive(Debug, Default)]
pub(crate) struct Run {
    /// The points that it passes, taken densely; a part begins wherever words have taken the tool,
    /// or its coordinates, elsewhere.
    pub(crate) points: Vec<[f64; 3]>,
    /// The words that move nothing, in order, as they stand.
    pub(crate) words: Vec<String>,
    /// Whether coordinates were other ones in between.
    pub(crate) reset: bool,
}

/// Runs a program, each block in so many steps.
///
/// # Panics
/// Where a block is not understood, or the radii of an arc disagree by more than `radii` mm.
#[must_use]
pub(crate) fn run(text: &str, steps: u32, radii: f64) -> Run {
    let mut run = Run { points: vec![[0.0; 3]], ..Run::default() };
    let (mut at, mut motion, mut plane) = ([0.0_f64; 3], 0.0, [0, 1, 2]);
    for line in text.lines() {
        let (code, comment) = split_comments(line);
        if !comment.is_empty() {
            run.words.push(comment);
        }
        if code == "%" || code.starts_with('O') {
            continue;
        }
        let words = words(&code);
        let mut to = at;
        let (mut center, mut control) = ([0.0; 3], [0.0; 2]);
        let mut moves = false;
        let place = place_words(&words);
        let dwells = words.contains(&('G', 4.0));
        for &(letter, value) in &words {
            match letter {
                'G' if value == 17.0 => plane = [0, 1, 2],
                'G' if value == 18.0 => plane = [2, 0, 1],
                'G' if value == 19.0 => plane = [1, 2, 0],
                'G' if [0.0, 1.0, 2.0, 3.0, 5.0, 2.2, 3.2].contains(&value) => motion = value,
                'G' if [20.0, 91.0, 41.0, 42.0].contains(&value) => panic!("not plain: {line}"),
                'X' | 'Y' | 'Z' if place.is_none() && !dwells => {
                    to["XYZ".find(letter).expect("an axis")] = value;
                    moves = true;
                }
                'I' | 'J' | 'K' => center["IJK".find(letter).expect("an axis")] = value,
                'P' if motion == 5.0 => control[0] = value,
                'Q' if motion == 5.0 => control[1] = value,
                'R' if motion == 2.2 || motion == 3.2 => control[0] = value,
                'N' | 'F' => {}
                _ => run.words.push(format!("{letter}{value}")),
            }
        }
        if let Some(sets) = place {
            run.reset = true;
            for (axis, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
                let value = words.iter().find(|word| word.0 == letter).map(|word| word.1);
                // G92 says what the coordinates are; the others leave them unknown.
                at[axis] = if sets { value.unwrap_or(at[axis]) } else { f64::NAN };
            }
            continue;
        }
        if !moves {
            continue;
        }
        let from = [0, 1, 2].map(|i| if at[i].is_nan() { to[i] } else { at[i] });
        let to = [0, 1, 2].map(|i| if to[i].is_nan() { 0.0 } else { to[i] });
        let from = [0, 1, 2].map(|i| if from[i].is_nan() { to[i] } else { from[i] });
        let [a, b, _] = plane;
        let flat = |point: [f64; 3]| [point[a], point[b]];
        let about = [from[a] + center[a], from[b] + center[b]];
        let ends = [flat(from), flat(to)];
        let turn = |clockwise| Turn { ends, center: about, clockwise, tolerance: radii, line };
        for i in 1..=steps {
            let t = f64::from(i) / f64::from(steps);
            let mut point = [0, 1, 2].map(|k| from[k] + (to[k] - from[k]) * t);
            if motion == 2.0 || motion == 3.0 {
                let [first, second] = turn(motion == 2.0).arc(t);
                point[plane[0]] = first;
                point[plane[1]] = second;
            } else if motion == 2.2 || motion == 3.2 {
                let [first, second] = turn(motion == 2.2).involute(t, control[0]);
                point[plane[0]] = first;
                point[plane[1]] = second;
            } else if motion == 5.0 {
                for k in 0..2 {
                    let [p1, p2] = [from[k] + center[k], to[k] + control[k]];
                    let s = 1.0 - t;
                    point[k] = s * s * s * from[k]
                        + 3.0 * s * s * t * p1
                        + 3.0 * s * t * t * p2
                        + t * t * t * to[k];
                }
            }
            run.points.push(point);
        }
        at = to;
    }
    run
}

/// Whether words take the tool or its coordinates elsewhere, and whether they say where (G92).
fn place_words(words: &[(char, f64)]) -> Option<bool> {
    words.iter().find_map(|&(letter, value)| match letter {
        'G' if value == 92.0 => Some(true),
        'G' if (53.0..60.0).contains(&value)
            || [10.0, 28.0, 30.0, 92.1, 92.2, 92.3].contains(&value) =>
        {
            Some(false)
        }
        _ => None,
    })
}

/// A block that turns about a centre, in its plane.
struct Turn<'a> {
    ends: [[f64; 2]; 2],
    center: [f64; 2],
    clockwise: bool,
    /// What its ends may be off [mm].
    tolerance: f64,
    line: &'a str,
}

impl Turn<'_> {
    /// Direction and distance of both ends from the centre.
    fn polar(&self) -> [(f64, f64); 2] {
        let [x, y] = self.center;
        self.ends.map(|p| ((p[1] - y).atan2(p[0] - x), (p[0] - x).hypot(p[1] - y)))
    }

    fn arc(&self, t: f64) -> [f64; 2] {
        let [(start, r0), (end, r1)] = self.polar();
        let mut turn = end - start;
        if self.clockwise && turn >= -1e-12 {
            turn -= TAU;
        } else if !self.clockwise && turn <= 1e-12 {
            turn += TAU;
        }
        let off = (r0 - r1).abs();
        assert!(off < self.tolerance, "radii disagree by {off}: {}", self.line);
        let (at, r) = (start + turn * t, r0 + (r1 - r0) * t);
        [self.center[0] + r * at.cos(), self.center[1] + r * at.sin()]
    }

    /// A thread of a circle, as FANUC's manual of the 30i draws it: from its end at the start to that
    /// at the end, what the end is off spread over the way.
    fn involute(&self, t: f64, radius: f64) -> [f64; 2] {
        let (polar, line) = (self.polar(), self.line);
        let far = polar.map(|(_, far)| far);
        assert!(far[0] >= radius && far[1] >= radius, "an end is inside the base circle: {line}");
        let threads = far.map(|far| (far * far - radius * radius).sqrt() / radius);
        let sense = if (threads[1] > threads[0]) == self.clockwise { -1.0 } else { 1.0 };
        // Where the thread of each end begins to come off.
        let first = [0, 1].map(|i| polar[i].0 + sense * (threads[i].atan() - threads[i]));
        let off = (first[1] - first[0] + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
        let away = (radius * off).abs();
        assert!(away < self.tolerance, "{away} mm off the involute: {line}");
        let thread = threads[0] + (threads[1] - threads[0]) * t;
        let leaves = first[0] + off * t + sense * thread;
        let along = sense * thread * radius;
        [
            self.center[0] + radius * leaves.cos() + along * leaves.sin(),
            self.center[1] + radius * leaves.sin() - along * leaves.cos(),
        ]
    }
}

/// The code of a line, and its comments with what encloses them.
fn split_comments(line: &str) -> (String, String) {
    let (mut code, mut comment) = (String::new(), String::new());
    let mut inside = None;
    for letter in line.chars() {
        match inside {
            Some(end) => {
                comment.push(letter);
                if letter == end {
                    inside = None;
                }
            }
            None if letter == '(' || letter == ';' => {
                comment.push(letter);
                inside = Some(if letter == '(' { ')' } else { '\n' });
            }
            None => code.push(letter),
        }
    }
    (code.trim().into(), comment)
}

fn words(code: &str) -> Vec<(char, f64)> {
    let word = |word: &str| {
        let number = word[1..].parse().unwrap_or_else(|_| panic!("no number: {word} in {code}"));
        (word.chars().next().expect("a word has a letter"), number)
    };
    code.split_whitespace().map(word).collect()
}
