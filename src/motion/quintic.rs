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

/// Newton's steps from arc length to parameter. The start is off by what the speed varies by, at
/// most a half, and each step squares the error.
const STEPS: usize = 4;

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
    /// Where on the whole curve this part begins [mm].
    from: f64,
    /// Length of the whole curve [mm].
    whole: f64,
    /// Arc length [mm].
    pub(super) length: f64,
}

impl Quintic {
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
        let mut curve = Self { powers, speed, from: 0.0, whole: 0.0, length: 0.0 };
        curve.whole = curve.run(1.0)[0];
        curve.length = curve.whole;
        curve
    }

    /// The arc length of the whole curve up to `t` [mm], and the speed there.
    fn run(&self, t: f64) -> [f64; 2] {
        let (mut length, mut speed) = (0.0, 0.0);
        for (i, c) in self.speed.iter().enumerate().rev() {
            length = length * t + c / (i + 1) as f64;
            speed = speed * t + c;
        }
        [length * t, speed]
    }

    /// Point and derivatives at the arc length `s` [mm].
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        let s = self.from + s;
        let mut t = s / self.whole;
        for _ in 0..STEPS {
            let [length, speed] = self.run(t);
            t = (t - (length - s) / speed).clamp(-0.01, 1.01);
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

/// The polynomial at `t` and its first three derivatives (Horner's scheme, repeated).
fn derivatives(powers: &[DVec3; 6], t: f64) -> [DVec3; 4] {
    let mut values = [DVec3::ZERO; 4];
    for power in powers.iter().rev() {
        values[3] = values[3] * t + values[2];
        values[2] = values[2] * t + values[1];
        values[1] = values[1] * t + values[0];
        values[0] = values[0] * t + *power;
    }
    [values[0], values[1], values[2] * 2.0, values[3] * 6.0]
}
