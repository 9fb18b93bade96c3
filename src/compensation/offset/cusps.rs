//! Where the offset of a cubic has a cusp: the roots of `1 − δ κ`.
//!
//! With `κ = (C' × C'') / |C'|³` the sign of `1 − δκ` is that of `|C'|³ − δ (C' × C'')`. Bounds of
//! both terms from Bernstein coefficients tell whole stretches of one sign; what is left is halved,
//! so that no pair of cusps can hide between two samples.

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
            bend: [2.0 * cross(d0, d1), cross(d0, d2), 2.0 * cross(d1, d2)].map(|b| offset * b),
        }
    }

    /// Collects, in order, the smallest stretches whose sign the bounds do not tell.
    fn collect(&self, from: f64, to: f64, depth: u32, undecided: &mut Vec<(f64, f64)>) {
        match self.sign() {
            Sign::Positive | Sign::Negative => {}
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
                Some(last) if last.1 == from => last.1 = to,
                _ => undecided.push((from, to)),
            },
        }
    }

    /// Sign of `|C'|³ − δ (C' × C'')` over the whole stretch, from bounds of both terms.
    fn sign(&self) -> Sign {
        let range = |values: &[f64]| {
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            (least, values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
        };
        let (slowest, fastest) = range(&self.speed_squared);
        let (least, most) = range(&self.bend);
        // Speed cubed, from its square.
        let cubed = |squared: f64| squared * squared.sqrt();
        let (slowest, fastest) = (cubed(slowest.max(0.0)), cubed(fastest));
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
