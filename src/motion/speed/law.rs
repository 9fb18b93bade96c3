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
        let mut values = self.powers;
        // Horner's rule again and again, each time one power shorter: it leaves the derivatives,
        // divided by 1, 1, 2 and 6.
        for order in 0..4 {
            for i in (order..7).rev() {
                values[i] += values[i + 1] * time;
            }
        }
        let [s, v, a, j, ..] = values;
        [s, v, 2.0 * a, 6.0 * j]
    }

    /// The phase of constant snap [mm/s⁴] from a state.
    pub(in crate::motion) fn of_snap(duration: f64, [s, v, a, j]: State, snap: f64) -> Self {
        let powers = [s, v, a / 2.0, j / 6.0, snap / 24.0, 0.0, 0.0, 0.0];
        Self { duration, powers }
    }

    /// The phase of degree 7 between two states.
    ///
    /// Of `s(τ) − Σ known powers` the four open coefficients follow from the state at the end; with
    /// `d` its distance from what the known powers give there, scaled by powers of the duration, they
    /// are the rows of the inverse of the matrix of falling factorials.
    pub(in crate::motion) fn between(duration: f64, from: State, to: State) -> Self {
        let mut phase = Self::of_snap(duration, from, 0.0);
        let [s, v, a, j] = phase.at(duration);
        let h = duration;
        let d = [to[0] - s, (to[1] - v) * h, (to[2] - a) * h * h, (to[3] - j) * h * h * h];
        let rows = [
            [35.0, -15.0, 2.5, -1.0 / 6.0],
            [-84.0, 39.0, -7.0, 0.5],
            [70.0, -34.0, 6.5, -0.5],
            [-20.0, 10.0, -2.0, 1.0 / 6.0],
        ];
        let mut scale = h * h * h;
        for (row, power) in rows.iter().zip(&mut phase.powers[4..]) {
            scale *= h;
            *power = (row[0] * d[0] + row[1] * d[1] + row[2] * d[2] + row[3] * d[3]) / scale;
        }
        phase
    }

    /// The same, slower by a factor on time of at least 1.
    pub(in crate::motion) fn stretched(&self, factor: f64) -> Self {
        let mut phase = *self;
        phase.duration *= factor;
        let mut scale = 1.0;
        for power in &mut phase.powers {
            *power *= scale;
            scale /= factor;
        }
        phase
    }
}

/// How long a law lasts [s].
pub(in crate::motion) fn length(law: &[Phase]) -> f64 {
    let mut time = 0.0;
    for phase in law {
        time += phase.duration;
    }
    time
}

/// The state of a law at a time since its start [s], or at its end.
pub(in crate::motion) fn state_at(law: &[Phase], time: f64) -> State {
    let mut left = time;
    let mut state = [0.0; 4];
    for phase in law {
        if left <= phase.duration {
            return phase.at(left);
        }
        left -= phase.duration;
        state = phase.at(phase.duration);
    }
    state
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_phase_between_states_has_them_at_its_ends() {
        let (from, to) = ([1.0, 2.0, -3.0, 4.0], [5.0, 0.5, 6.0, -70.0]);
        let phase = Phase::between(0.7, from, to);
        for (time, state) in [(0.0, from), (0.7, to)] {
            for (found, meant) in phase.at(time).into_iter().zip(state) {
                let rounding = 1e-12 * (10.0 + meant.abs());
                assert!((found - meant).abs() < rounding, "at {time}: {found} is {meant}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_position() {
        let phase = Phase::between(0.7, [1.0, 2.0, -3.0, 4.0], [5.0, 0.5, 6.0, -70.0]);
        let h = 1e-4;
        let (before, here, after) = (phase.at(0.3 - h), phase.at(0.3), phase.at(0.3 + h));
        for order in 1..4 {
            let slope = (after[order - 1] - before[order - 1]) / (2.0 * h);
            let scale = 1.0 + here[order].abs();
            assert!((slope - here[order]).abs() < 1e-5 * scale, "order {order}: {slope}");
        }
    }

    #[test]
    fn stretching_time_divides_the_rates_by_its_powers() {
        let phase = Phase::between(0.7, [1.0, 2.0, -3.0, 4.0], [5.0, 0.5, 6.0, -70.0]);
        let slow = phase.stretched(2.0);
        let (a, b) = (phase.at(0.3), slow.at(0.6));
        for (order, scale) in [1.0, 2.0, 4.0, 8.0].into_iter().enumerate() {
            assert!((b[order] * scale - a[order]).abs() < 1e-9, "order {order}");
        }
    }
}
