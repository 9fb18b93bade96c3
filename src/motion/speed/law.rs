//! Laws of motion: arc length over time as polynomials that join with continuous jerk.

/// Arc length over the time since its start, as a polynomial.
///
/// Ramps have a constant fourth derivative; phases of an improved law match position, velocity,
/// acceleration and jerk at both ends, for which degree 7 is needed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::motion) struct Phase {
    /// How long it lasts [s].
    pub(in crate::motion) duration: f64,
    /// Coefficients of the powers of time, from the constant on.
    pub(in crate::motion) powers: [f64; 8],
}

/// Arc length [mm], velocity, acceleration and jerk along the path.
pub(in crate::motion) type State = [f64; 4];

impl Phase {
    /// The state at a time since its start [s].
    pub(in crate::motion) fn at(&self, time: f64) -> State {
        let [mut s, mut v, mut a, mut j] = [0.0; 4];
        // Horner's rule carried out for the derivatives too: they come out divided by 1, 2 and 6.
        for power in self.powers.iter().rev() {
            j = j * time + a;
            a = a * time + v;
            v = v * time + s;
            s = s * time + power;
        }
        [s, v, 2.0 * a, 6.0 * j]
    }

    /// The phase of constant snap [mm/s⁴] from a state.
    pub(in crate::motion) fn of_snap(duration: f64, [s, v, a, j]: State, snap: f64) -> Self {
        let powers = [s, v, a / 2.0, j / 6.0, snap / 24.0, 0.0, 0.0, 0.0];
        Self { duration, powers }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_position() {
        let phase = Phase::of_snap(0.7, [1.0, 2.0, -3.0, 4.0], 5.0);
        let h = 1e-4;
        let (before, here, after) = (phase.at(0.3 - h), phase.at(0.3), phase.at(0.3 + h));
        for order in 1..4 {
            let slope = (after[order - 1] - before[order - 1]) / (2.0 * h);
            let scale = 1.0 + here[order].abs();
            assert!((slope - here[order]).abs() < 1e-5 * scale, "order {order}: {slope}");
        }
    }
}
