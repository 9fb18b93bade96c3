//! Ramps of velocity on a straight stretch: acceleration and jerk zero at both ends, snap bounded.

use super::law::{Phase, State};
use crate::geometry::nth_root;

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

/// The law over a length [mm] from rest to rest: ramp, cruise, ramp.
pub(in crate::motion) fn rest_to_rest(law: &mut Vec<Phase>, s: f64, length: f64, rates: &Rates) {
    let ramps = |velocity: f64| velocity * ramp_time(velocity, rates);
    let mut top = rates.velocity;
    if ramps(top) > length {
        // The length of both ramps grows with the velocity between them.
        let mut low = 0.0;
        for _ in 0..60 {
            let middle = 0.5 * (low + top);
            if ramps(middle) > length { top = middle } else { low = middle }
        }
        top = low;
    }
    if top <= 0.0 {
        return;
    }
    let on = add_ramp(law, s, 0.0, top, rates);
    let cruise = length - ramps(top);
    if cruise > 0.0 {
        law.push(Phase::of_snap(cruise / top, [on, top, 0.0, 0.0], 0.0));
    }
    add_ramp(law, on + cruise.max(0.0), top, 0.0, rates);
}
