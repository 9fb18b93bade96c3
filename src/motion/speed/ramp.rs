//! Ramps of velocity where a path has little to say: acceleration and jerk zero at both ends, snap bounded.

use glam::DVec3;

use super::law::{Phase, State};
use crate::geometry::nth_root;
use crate::motion::Limits;

/// Halvings that find the speed of a law too short for the largest.
const HALVINGS: u32 = 60;

/// Bounds of the rates along a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::motion) struct Rates {
    /// Of the velocity [mm/s].
    pub(in crate::motion) velocity: f64,
    /// Of the acceleration [mm/s²].
    pub(in crate::motion) acceleration: f64,
    /// Of the jerk [mm/s³].
    pub(in crate::motion) jerk: f64,
    /// Of the snap [mm/s⁴].
    pub(in crate::motion) snap: f64,
}

impl Rates {
    /// Those along a line in the direction of a unit tangent, at most at the speed `cap` [mm/s].
    pub(in crate::motion) fn along(tangent: DVec3, cap: f64, limits: &Limits) -> Self {
        let (mut acceleration, mut jerk) = (limits.acceleration, limits.jerk);
        if let Some(axes) = &limits.axes {
            for axis in 0..3 {
                let share = tangent[axis].abs().max(1.0e-9);
                acceleration = acceleration.min(axes.acceleration[axis] / share);
                jerk = jerk.min(axes.jerk[axis] / share);
            }
        }
        Self { velocity: cap, acceleration, jerk, snap: limits.snap() }
    }

    /// All of them by a factor.
    pub(in crate::motion) fn by(self, factor: f64) -> Self {
        Self {
            velocity: self.velocity * factor,
            acceleration: self.acceleration * factor,
            jerk: self.jerk * factor,
            snap: self.snap * factor,
        }
    }
}

/// The times of a ramp: jerk rises for `rise`, stays for `stay` and falls; acceleration then stays
/// for `hold`, and falls as it rose.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Times {
    rise: f64,
    stay: f64,
    hold: f64,
}

impl Times {
    /// The shortest ramp over a difference of velocities [mm/s].
    ///
    /// With `j = S rise` the acceleration reaches `j (rise + stay)` and the difference is that times
    /// `2 rise + stay + hold`.
    fn of(difference: f64, rates: &Rates) -> Self {
        let Rates { acceleration, jerk, snap, .. } = *rates;
        let rise = (jerk / snap).min((acceleration / snap).sqrt());
        let peak = snap * rise;
        let stay = (acceleration / peak - rise).max(0.0);
        let most = peak * (rise + stay) * (2.0 * rise + stay);
        if difference >= most {
            let top = peak * (rise + stay);
            return Self { rise, stay, hold: difference / top - 2.0 * rise - stay };
        }
        let least = 2.0 * snap * rise * rise * rise;
        if difference <= least {
            return Self { rise: nth_root(difference / (2.0 * snap), 3), stay: 0.0, hold: 0.0 };
        }
        // peak (rise + stay)(2 rise + stay) = difference, quadratic in rise + stay.
        let sum = f64::midpoint(-rise, (rise * rise + 4.0 * difference / peak).sqrt());
        Self { rise, stay: sum - rise, hold: 0.0 }
    }

    fn total(&self) -> f64 {
        2.0 * (2.0 * self.rise + self.stay) + self.hold
    }
}

/// The time of the shortest ramp over a difference of velocities [mm/s].
pub(in crate::motion) fn ramp_time(difference: f64, rates: &Rates) -> f64 {
    Times::of(difference.abs(), rates).total()
}

/// Adds the phases of a ramp to `law`, from the arc length `s` [mm]; returns where it ends.
fn add_ramp(law: &mut Vec<Phase>, s: f64, from: f64, to: f64, rates: &Rates) -> f64 {
    let times = Times::of((to - from).abs(), rates);
    let snap = rates.snap * (to - from).signum();
    let Times { rise, stay, hold } = times;
    let mut state: State = [s, from, 0.0, 0.0];
    let steps = [
        (rise, snap),
        (stay, 0.0),
        (rise, -snap),
        (hold, 0.0),
        (rise, -snap),
        (stay, 0.0),
        (rise, snap),
    ];
    for (duration, snap) in steps {
        if duration > 0.0 {
            let phase = Phase::of_snap(duration, state, snap);
            state = phase.at(duration);
            law.push(phase);
        }
    }
    // What ramps add up to is exact by symmetry.
    s + 0.5 * (from + to) * times.total()
}

/// The law over a length [mm] between two speeds: ramp, cruise, ramp. It cruises at the speed of the
/// rates, or as fast as there is room for.
pub(in crate::motion) fn cruise(
    s: f64,
    length: f64,
    [from, to]: [f64; 2],
    rates: &Rates,
) -> Vec<Phase> {
    let ramps = |top: f64| {
        0.5 * ((from + top) * ramp_time(top - from, rates)
            + (top + to) * ramp_time(top - to, rates))
    };
    let mut low = from.max(to);
    let mut top = rates.velocity.max(low);
    if ramps(top) > length {
        // The ways of ramps grow with their speed: halved until nothing is left between.
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, top);
            if ramps(middle) > length { top = middle } else { low = middle }
        }
        top = low;
    }
    let mut law = Vec::new();
    let on = add_ramp(&mut law, s, from, top, rates);
    let left = (length - ramps(top)).max(0.0);
    law.push(Phase::of_snap(left / top.max(f64::MIN_POSITIVE), [on, top, 0.0, 0.0], 0.0));
    add_ramp(&mut law, on + left, top, to, rates);
    law
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cruise_ends_where_and_as_it_is_to_and_keeps_its_rates() {
        let rates = Rates { velocity: 50.0, acceleration: 900.0, jerk: 3.0e4, snap: 5.0e6 };
        for (length, speeds) in [
            (40.0, [0.0, 0.0]),
            (40.0, [10.0, 49.0]),
            (40.0, [49.5, 3.0]),
            (40.0, [50.0, 50.0]),
            (0.3, [0.0, 0.0]),
            (1e-6, [0.0, 0.0]),
            (1.5, [10.0, 3.0]),
        ] {
            let law = cruise(2.0, length, speeds, &rates);
            let mut last = [2.0, speeds[0], 0.0, 0.0];
            for phase in &law {
                for (found, meant) in phase.at(0.0).into_iter().zip(last) {
                    assert!((found - meant).abs() < 1e-6 * (1.0 + meant.abs()), "{speeds:?}");
                }
                last = phase.at(phase.duration);
                assert!(last[1] < 50.0 + 1e-9 && last[2].abs() < 900.0 + 1e-6, "{speeds:?}");
                assert!(last[3].abs() < 3.0e4 + 1e-6, "{speeds:?}: jerk {}", last[3]);
            }
            assert!((last[0] - 2.0 - length).abs() < 1e-9, "{speeds:?} ends at {}", last[0]);
            assert!((last[1] - speeds[1]).abs() < 1e-9, "{speeds:?} ends at {}", last[1]);
        }
    }
}
