//! The law of the textbook: one quintic of velocity from midpoint to midpoint of the corners.
//!
//! CN patent, Shanghai University of Engineering Science, 2022, "一种用于非直线路径的刀轴速度插补方法
//! 及数控加工设备", steps S4 and S5. It is kept as it is: its speed at a corner takes no account of how
//! curvature changes, so jerk exceeds its limit, and a unit is never faster than the faster of its
//! ends, so long lines take long.

use super::course::Course;
use super::law::Phase;
use super::ramp::{Rates, cruise};
use crate::geometry::nth_root;
use crate::motion::{Frame, Limits, Piece};

/// The law of a run from rest to rest.
pub(in crate::motion) fn law(course: &Course, limits: &Limits) -> Vec<Phase> {
    // Where a unit ends, and how fast.
    let mut nodes = vec![[0.0, 0.0]];
    for (placed, from, cap) in course.pieces() {
        if !matches!(placed.piece, Piece::Straight(_)) {
            let middle = 0.5 * placed.piece.length();
            nodes.push([from + middle, speed(&placed.piece.frame(middle), limits).min(cap)]);
        }
    }
    nodes.push([course.length, 0.0]);
    let mut law = Vec::new();
    for pair in nodes.windows(2) {
        let ([from, start], [to, end]) = (pair[0], pair[1]);
        let length = to - from;
        if start + end > 0.0 {
            law.push(quintic(from, length, start, end));
        } else {
            // Between two rests a quintic of velocity stays at rest: the patent knows no such unit.
            let rates = Rates {
                velocity: limits.velocity.min(course.cap()),
                acceleration: limits.acceleration,
                jerk: limits.jerk,
                snap: limits.snap(),
            };
            law.extend(cruise(from, length, [0.0, 0.0], &rates));
        }
    }
    law
}

/// `V = min{ Vmax, (2/Ts) √(1/κ² − (1/κ − γ)²), √(Amax/κ), ∛(Jmax/κ²) }`, claim 5.
fn speed(frame: &Frame, limits: &Limits) -> f64 {
    let bend = frame.curvature.length().max(1.0e-12);
    let radius = 1.0 / bend;
    let gap = limits.chord_error.min(radius);
    // 1/κ² − (1/κ − γ)² = γ (2/κ − γ).
    let chord = 2.0 / limits.period * (gap * (2.0 * radius - gap)).sqrt();
    let jerk = nth_root(limits.jerk * radius * radius, 3);
    limits.velocity.min(chord).min((limits.acceleration * radius).sqrt()).min(jerk)
}

/// `V = Vs + (Ve − Vs)(10 τ³ − 15 τ⁴ + 6 τ⁵)`, which takes `T = 2 S/(Vs + Ve)` over a length S.
fn quintic(s: f64, length: f64, start: f64, end: f64) -> Phase {
    let time = 2.0 * length / (start + end);
    let change = (end - start) / (time * time * time);
    let powers =
        [s, start, 0.0, 0.0, 2.5 * change, -3.0 * change / time, change / (time * time), 0.0];
    Phase { duration: time, powers }
}
