//! Where the offset of a cubic has a cusp: the roots of `1 − δ κ`.
//!
//! With `κ = (C' × C'') / |C'|³` the sign of `1 − δκ` is that of `|C'|³ − δ (C' × C'')`. Bounds of
//! both terms from Bernstein coefficients tell whole stretches of one sign; what is left is halved,
//! so that no pair of cusps can hide between two samples.

use crate::geometry::{Cubic, cross};

/// Where `|1 − δκ|` stays below this the offset all but stands still, whatever its sign: it moves by
/// a millionth of the curve's length.
const STILL: f64 = 1e-6;

/// Halvings until an undecided stretch counts as a point: 2⁻²⁶ of a cubic. A pair of cusps nearer
/// than that bounds a gouge shallower than any tolerance.
const MAX_DEPTH: u32 = 26;

/// `|C'|³ − δ (C' × C'')` at `t`: negative where the tool does not fit.
pub(super) fn room(cubic: &Cubic, offset: f64, t: f64) -> f64 {
    let first = cubic.derivative(t);
    let speed = first.length();
    speed * speed * speed - offset * cross(first, cubic.second_derivative(t))
}

/// Parameters in `(0, 1)`, ascending, at which `1 − δκ` of `cubic` changes its sign.
pub(super) fn cusps(cubic: &Cubic, offset: f64) -> Vec<f64> {
    let mut undecided = Vec::new();
    collect(cubic, offset, 0.0, 1.0, 0, &mut undecided);
    let mut found: Vec<f64> = Vec::new();
    for (from, to) in undecided {
        let (at_from, at_to) = (room(cubic, offset, from), room(cubic, offset, to));
        if at_from * at_to < 0.0 {
            let t = bisect(cubic, offset, (from, at_from), to);
            if t > 0.0 && t < 1.0 && found.last().is_none_or(|&last| t > last) {
                found.push(t);
            }
        }
    }
    found
}

/// What the Bernstein bounds tell of a stretch.
enum Sign {
    Positive,
    Negative,
    /// Too near zero to matter, over the whole stretch.
    Still,
    Unknown,
}

/// Collects, in order, the smallest stretches whose sign the bounds do not tell.
fn collect(
    cubic: &Cubic,
    offset: f64,
    from: f64,
    to: f64,
    depth: u32,
    undecided: &mut Vec<(f64, f64)>,
) {
    let sign = sign(cubic, offset);
    match sign {
        Sign::Positive | Sign::Negative => {}
        Sign::Unknown if depth < MAX_DEPTH => {
            let middle = 0.5 * (from + to);
            let (left, right) = cubic.split(0.5);
            collect(&left, offset, from, middle, depth + 1, undecided);
            collect(&right, offset, middle, to, depth + 1, undecided);
        }
        Sign::Still | Sign::Unknown => match undecided.last_mut() {
            // Neighbours are one stretch, so that a root on their boundary is not lost.
            Some(last) if last.1 == from => last.1 = to,
            _ => undecided.push((from, to)),
        },
    }
}

/// Sign of `|C'|³ − δ (C' × C'')` over the whole cubic, from bounds of both terms.
fn sign(cubic: &Cubic, offset: f64) -> Sign {
    let d = cubic.hodograph();
    // C' × C'' has the Bernstein coefficients 2 d0×d1, d0×d2, 2 d1×d2.
    let bends = [2.0 * cross(d[0], d[1]), cross(d[0], d[2]), 2.0 * cross(d[1], d[2])]
        .map(|bend| offset * bend);
    let most = bends.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let least = bends.into_iter().fold(f64::INFINITY, f64::min);
    // |C'| is at least its part along the chord, and at most the longest control vector.
    let chord = (cubic.end() - cubic.start()).normalize_or_zero();
    let slowest = d.iter().map(|v| v.dot(chord)).fold(f64::INFINITY, f64::min).max(0.0);
    let fastest = d.iter().map(|v| v.length()).fold(0.0, f64::max);
    let (slowest, fastest) = (slowest.powi(3), fastest.powi(3));
    if slowest > most {
        Sign::Positive
    } else if fastest < least {
        Sign::Negative
    } else if (fastest - least).max(most - slowest) < STILL * slowest {
        Sign::Still
    } else {
        Sign::Unknown
    }
}

/// The sign change in a bracket of which one value is known.
fn bisect(cubic: &Cubic, offset: f64, from: (f64, f64), to: f64) -> f64 {
    let (mut low, at_low) = from;
    let mut high = to;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if room(cubic, offset, middle) * at_low > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
