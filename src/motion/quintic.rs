//! A polynomial of degree five in space by arc length.

use glam::DVec3;

use super::Frame;

/// Where the speed of the curve is taken to find its length: Chebyshev's points of the second kind
/// on `[0, 1]`, between which a polynomial through its values errs least.
const NODES: [f64; NODE_COUNT] = [
    0.0,
    0.038_060_233_744_356_62,
    0.146_446_609_406_726_24,
    0.308_658_283_817_455_1,
    0.5,
    0.691_341_716_182_544_9,
    0.853_553_390_593_273_8,
    0.961_939_766_255_643_4,
    1.0,
];
const NODE_COUNT: usize = 9;

/// How far the speed by the polynomial may be off the true one, in parts of it: a third difference of
/// positions a millisecond apart sees a step of it a million times as large.
const FEED_ERROR: f64 = 1e-7;

/// The least part of the largest speed that a curve of even speed has.
const EVEN: f64 = 0.7;

/// Most of Newton's steps from arc length to parameter; most often one does. The start is a polynomial
/// of degree five with the right speed and its change at both ends, and each step about squares the
/// error.
const STEPS: usize = 4;

/// A step after which the error is below 1e-10 of the length.
const LAST_STEP: f64 = 1.0e-5;

/// What the integrals of powers are divided by, inverted: divisions take long.
const SHARES: [f64; NODE_COUNT] = {
    let mut shares = [0.0; NODE_COUNT];
    let mut i = 0;
    while i < NODE_COUNT {
        shares[i] = 1.0 / (i + 1) as f64;
        i += 1;
    }
    shares
};

/// A curve `r(t) = Σ cᵢ tⁱ` in space, or a part of it.
///
/// Its speed by `t` must be positive and vary little: the length is that of a polynomial through
/// nine values of it, which is off by 1e-9 of the length where the speed varies by a third.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quintic {
    /// Coefficients by ascending powers of `t` [mm].
    powers: [DVec3; 6],
    /// Those of the speed `|dr/dt|` [mm].
    speed: [f64; NODE_COUNT],
    /// How `t` differs from the part of the length: its slopes at both ends, and what brings its
    /// second derivatives there.
    start: [f64; 4],
    /// Where on the whole curve this part begins [mm].
    from: f64,
    /// Length of the whole curve [mm].
    whole: f64,
    /// Arc length [mm].
    pub(super) length: f64,
}

impl Quintic {
    /// The curve with the given coefficients, if its speed varies little enough for the length.
    pub(super) fn of_even_powers(powers: [DVec3; 6]) -> Option<Self> {
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for t in NODES {
            let speed = derivatives(&powers, t)[1].length();
            (least, most) = (least.min(speed), most.max(speed));
        }
        if least <= EVEN * most {
            return None;
        }
        let curve = Self::of_powers(powers);
        // Where the speed bends sharply its polynomial is off between the values, most near the ends.
        for t in
            [0.5 * (NODES[0] + NODES[1]), 0.5 * (NODES[3] + NODES[4]), 0.5 * (NODES[7] + NODES[8])]
        {
            let speed = derivatives(&powers, t)[1].length();
            if (curve.run(t)[1] - speed).abs() > FEED_ERROR * speed {
                return None;
            }
        }
        Some(curve)
    }

    /// The curve with the given coefficients by ascending powers of `t` in `[0, 1]` [mm].
    #[must_use]
    pub fn of_powers(powers: [DVec3; 6]) -> Self {
        // Newton's divided differences, and from them the powers.
        let mut speed = NODES.map(|t| derivatives(&powers, t)[1].length());
        for order in 1..NODE_COUNT {
            for i in (order..NODE_COUNT).rev() {
                speed[i] = (speed[i] - speed[i - 1]) / (NODES[i] - NODES[i - order]);
            }
        }
        for first in (0..NODE_COUNT - 1).rev() {
            for i in first..NODE_COUNT - 1 {
                speed[i] -= NODES[first] * speed[i + 1];
            }
        }
        let mut curve = Self { powers, speed, start: [0.0; 4], from: 0.0, whole: 0.0, length: 0.0 };
        let [length, end] = curve.run(1.0);
        curve.whole = length;
        // With p = s/L: dt/dp = L/v, and d²t/dp² = −(L/v)² v'/v.
        let mut change = 0.0;
        for (i, power) in speed.iter().enumerate() {
            change += i as f64 * power;
        }
        let (first, last) = (length / speed[0], length / end);
        let early = -first * first * speed[1] / speed[0];
        let late = -last * last * change / end;
        let (a, b) = (first - 1.0, last - 1.0);
        curve.start = [a, b, 0.5 * early + 2.0 * a + b, 0.5 * late - a - 2.0 * b];
        curve.length = curve.whole;
        curve
    }

    /// The arc length of the whole curve up to `t` [mm], and the speed there.
    fn run(&self, t: f64) -> [f64; 2] {
        // Even and odd powers apart: two chains of half the length.
        let square = t * t;
        let (mut length, mut speed) = ([0.0; 2], [0.0; 2]);
        for i in (0..NODE_COUNT).rev() {
            let odd = i % 2;
            length[odd] = length[odd] * square + self.speed[i] * SHARES[i];
            speed[odd] = speed[odd] * square + self.speed[i];
        }
        [(length[0] + length[1] * t) * t, speed[0] + speed[1] * t]
    }

    /// Point and derivatives at the arc length `s` [mm].
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        let s = self.from + s;
        let part = s / self.whole;
        let [first, last, early, late] = self.start;
        let rest = 1.0 - part;
        let both = part * rest;
        let slopes = rest * first - part * last;
        let mut t = part + both * (slopes + both * (rest * early + part * late));
        for _ in 0..STEPS {
            let [length, speed] = self.run(t);
            let step = (length - s) / speed;
            t = (t - step).clamp(-0.01, 1.01);
            if step.abs() < LAST_STEP {
                break;
            }
        }
        let [point, first, second, third] = derivatives(&self.powers, t);
        Frame::of_derivatives(point, [first, second, third])
    }

    /// The part from one arc length to another [mm].
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        Self { from: self.from + from, length: to - from, ..*self }
    }
}

/// The polynomial at `t` and its first three derivatives: Horner's scheme again and again, each time
/// one coefficient shorter.
fn derivatives(powers: &[DVec3; 6], t: f64) -> [DVec3; 4] {
    let mut values = *powers;
    for order in 0..4 {
        for i in (order..5).rev() {
            values[i] += values[i + 1] * t;
        }
    }
    [values[0], values[1], values[2] * 2.0, values[3] * 6.0]
}
