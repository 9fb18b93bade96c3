//! Where the offset of a cubic has a cusp: the roots of `1 − δ κ`.
//!
//! With `κ = (C' × C'') / |C'|³` the sign of `1 − δκ` is that of `|C'|³ − δ (C' × C'')`. Bounds of
//! both terms from Bernstein coefficients tell stretches of one sign, and those of its derivative
//! `3 |C'| (C' · C'') − δ (C' × C''')` stretches on which it has one root at most; what is left is
//! halved, so that no pair of cusps can hide between two samples.

use super::proof::range;
use crate::geometry::{Cubic, cross, halve};

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
    Terms::new(cubic, offset).collect(0.0, 1.0, 0, &mut undecided);
    let mut found: Vec<f64> = Vec::new();
    for Bracket { from, to, .. } in undecided {
        let (at_from, at_to) = (room(cubic, offset, from), room(cubic, offset, to));
        if (at_from < 0.0) != (at_to < 0.0) {
            let t = sign_change(cubic, offset, [from, to], [at_from, at_to]);
            if t > 0.0 && t < 1.0 && found.last().is_none_or(|&last| t > last) {
                found.push(t);
            }
        }
    }
    found
}

/// A stretch that may have a cusp.
struct Bracket {
    from: f64,
    to: f64,
    /// Whether it has one at most.
    one: bool,
}

/// What the Bernstein bounds tell of a stretch.
enum Sign {
    Positive,
    Negative,
    /// Changing at most once.
    Monotone,
    /// Too near zero to matter, over the whole stretch.
    Still,
    Unknown,
}

/// Both terms over a stretch, as Bernstein coefficients.
///
/// They are halved as they are: the control points of a short stretch have too few digits left to
/// tell its curvature.
#[derive(Clone, Copy)]
struct Terms {
    /// `|C'|²`, of degree 4.
    speed_squared: [f64; 5],
    /// `δ (C' × C'')`, of degree 2.
    bend: [f64; 3],
}

impl Terms {
    fn new(cubic: &Cubic, offset: f64) -> Self {
        let [d0, d1, d2] = cubic.hodograph();
        Self {
            speed_squared: [
                d0.dot(d0),
                d0.dot(d1),
                (d0.dot(d2) + 2.0 * d1.dot(d1)) / 3.0,
                d1.dot(d2),
                d2.dot(d2),
            ],
            bend: [
                offset * (2.0 * cross(d0, d1)),
                offset * cross(d0, d2),
                offset * (2.0 * cross(d1, d2)),
            ],
        }
    }

    /// Collects, in order, the smallest stretches whose sign the bounds do not tell.
    fn collect(&self, from: f64, to: f64, depth: u32, undecided: &mut Vec<Bracket>) {
        match self.sign() {
            Sign::Positive | Sign::Negative => {}
            Sign::Monotone => undecided.push(Bracket { from, to, one: true }),
            Sign::Unknown if depth < MAX_DEPTH => {
                let middle = 0.5 * (from + to);
                let (mut left, mut right) = (*self, *self);
                halve(&mut right.speed_squared, &mut left.speed_squared);
                halve(&mut right.bend, &mut left.bend);
                left.collect(from, middle, depth + 1, undecided);
                right.collect(middle, to, depth + 1, undecided);
            }
            Sign::Still | Sign::Unknown => match undecided.last_mut() {
                // Neighbours are one stretch, so that a root on their boundary is not lost.
                Some(last) if last.to == from && !last.one => last.to = to,
                _ => undecided.push(Bracket { from, to, one: false }),
            },
        }
    }

    /// Sign of `|C'|³ − δ (C' × C'')` over the whole stretch, from bounds of both terms.
    fn sign(&self) -> Sign {
        let [slowest, fastest] = range(&self.speed_squared);
        let [least, most] = range(&self.bend);
        let (slow, fast) = (slowest.max(0.0).sqrt(), fastest.sqrt());
        // Speed cubed.
        let (slowest, fastest) = (slowest.max(0.0) * slow, fastest * fast);
        if slowest > most {
            Sign::Positive
        } else if fastest < least {
            Sign::Negative
        } else if (fastest - least).max(most - slowest) < STILL * slowest {
            Sign::Still
        } else if self.is_monotone(slow, fast) {
            Sign::Monotone
        } else {
            Sign::Unknown
        }
    }

    /// Whether the derivative `3 |C'| (C' · C'') − δ (C' × C''')` keeps its sign, from bounds of
    /// its terms.
    fn is_monotone(&self, slowest: f64, fastest: f64) -> bool {
        let s = &self.speed_squared;
        let [b0, b1, b2] = self.bend;
        // (|C'|²)' = 2 C' · C'', of degree 3 by differences.
        let [least, most] = range(&[s[1] - s[0], s[2] - s[1], s[3] - s[2], s[4] - s[3]]);
        let [least_turn, most_turn] = range(&[b1 - b0, b2 - b1]);
        let low = 6.0 * least * if least > 0.0 { slowest } else { fastest };
        let high = 6.0 * most * if most > 0.0 { fastest } else { slowest };
        low > 2.0 * most_turn || high < 2.0 * least_turn
    }
}

/// The sign change in a bracket with the given values at its ends: regula falsi in the Illinois
/// variant, and halving where that does not come in.
fn sign_change(cubic: &Cubic, offset: f64, ends: [f64; 2], values: [f64; 2]) -> f64 {
    let ([mut low, mut high], [mut at_low, mut at_high]) = (ends, values);
    let mut kept_low = None;
    for step in 0..60 {
        let secant = (low * at_high - high * at_low) / (at_high - at_low);
        let inside = secant > low && secant < high && step < 20;
        let t = if inside { secant } else { 0.5 * (low + high) };
        if t <= low || t >= high || high - low < 1e-15 {
            break;
        }
        let here = room(cubic, offset, t);
        if here == 0.0 {
            return t;
        }
        if (here < 0.0) == (at_low < 0.0) {
            // An end that stays put twice gets half its weight, or it would stay for ever.
            if kept_low == Some(false) {
                at_high *= 0.5;
            }
            (low, at_low, kept_low) = (t, here, Some(false));
        } else {
            if kept_low == Some(true) {
                at_low *= 0.5;
            }
            (high, at_high, kept_low) = (t, here, Some(true));
        }
    }
    if at_low.abs() < at_high.abs() { low } else { high }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn every_sign_change_is_found() {
        let waves =
            Cubic::new(dvec2(0.0, 0.0), dvec2(9.0, 14.0), dvec2(2.0, -13.0), dvec2(12.0, 1.0));
        let bend = Cubic::new(
            dvec2(-9.872_191_518_302_12, 4.119_486_998_370_604),
            dvec2(-5.483_318_893_854_202, 2.450_149_946_181_077),
            dvec2(-1.094_446_269_406_285_8, 0.780_812_893_991_549_7),
            dvec2(2.641_752_254_374_071_5, 3.391_736_675_041_763_7),
        );
        for cubic in [waves, bend, waves.reversed(), bend.reversed()] {
            for offset in [-30.0, -17.0, -3.0, -0.5, 0.5, 3.0, 17.0, 30.0] {
                let signs: Vec<bool> =
                    (0..=1000).map(|k| room(&cubic, offset, f64::from(k) / 1000.0) > 0.0).collect();
                let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
                let found = cusps(&cubic, offset);
                assert_eq!(found.len(), changes, "cusps {found:?} of {cubic:?} at {offset}");
                for t in found {
                    let scale = room(&cubic, offset, t - 1e-3).abs();
                    let here = room(&cubic, offset, t).abs();
                    assert!(here < 1e-9 * scale.max(1.0), "a cusp at {t} with room {here}");
                }
            }
        }
    }
}
