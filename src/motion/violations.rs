//! The judge of motion: which limits its samples break, by code that shares none with the planner.
//!
//! What the samples say of themselves is held against the limits, and so are differences of their
//! positions. The n-th difference of a motion, divided by the n-th power of the period, is a weighted
//! mean of its n-th derivative (the weights are those of a B-spline), so it is beyond a limit only
//! where the derivative is.

use glam::DVec3;

use super::{Limits, Motion};
use crate::contour::{Move, MoveCurve};

/// What motion may not do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// The velocity of the limits [mm/s].
    Velocity,
    /// The programmed feed with its override [mm/s].
    Feed,
    /// The size of the acceleration [mm/s²].
    Acceleration,
    /// The size of the jerk [mm/s³].
    Jerk,
    /// The velocity of an axis [mm/s].
    AxisVelocity,
    /// The acceleration of an axis [mm/s²].
    AxisAcceleration,
    /// The jerk of an axis [mm/s³].
    AxisJerk,
    /// The distance from the path [mm].
    CornerDeviation,
    /// The gap between the path and the chord of a period [mm].
    ChordError,
    /// The distance of the last sample from the end of the path [mm].
    End,
}

/// How many limits there are.
const LIMITS: usize = 10;

/// A limit that is broken, where it is broken most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Violation {
    /// Which limit.
    pub limit: Limit,
    /// The value there, in the limit's unit.
    pub value: f64,
    /// What is allowed there.
    pub allowed: f64,
    /// When [s].
    pub time: f64,
    /// Index of the move.
    pub block: u32,
    /// How many samples break it.
    pub samples: usize,
}

/// Beyond a limit by this part of it counts as within: what rounding may add.
const SLACK: f64 = 1.0e-6;

/// Rounding of one coordinate, by its size; a third difference adds eight.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// How near the end of the path motion must end [mm].
const END: f64 = 1.0e-9;

/// Farther than this from the end of one move to the start of the next the coordinates jump [mm].
const GAP: f64 = 1.0e-6;

/// Moves on either side of that of a sample that it may be near to: a fitted curve runs past many.
const REACH: usize = 200;

/// The limits that the samples of a motion break, each once.
///
/// `moves` are those that the motion was planned along. A programmed feed that is broken only by a
/// millionth, or a limit by less than rounding may add, is not.
#[must_use]
pub fn violations(motion: &Motion, moves: &[Move], limits: &Limits) -> Vec<Violation> {
    let mut judge = Judge { motion, found: [None; LIMITS] };
    for index in 0..motion.len() {
        judge.channels(index, moves, limits);
        judge.deviation(index, moves, limits.corner_deviation);
    }
    judge.differences(moves, limits);
    judge.end(moves);
    judge.found.into_iter().flatten().collect()
}

struct Judge<'a> {
    motion: &'a Motion,
    found: [Option<Violation>; LIMITS],
}

impl Judge<'_> {
    /// Takes note of a value that is beyond what is allowed.
    fn hold(&mut self, limit: Limit, index: usize, value: f64, allowed: f64, slack: f64) {
        if value <= allowed + slack {
            return;
        }
        // What is not a number is no value that is allowed.
        let value = if value.is_finite() { value } else { f64::MAX };
        let place = &mut self.found[limit as usize];
        let samples = place.map_or(0, |found| found.samples) + 1;
        match place {
            Some(found) if found.value * allowed >= value * found.allowed => {
                found.samples = samples;
            }
            _ => {
                let (time, block) = (self.motion.time[index], self.motion.block[index]);
                *place = Some(Violation { limit, value, allowed, time, block, samples });
            }
        }
    }

    /// What a sample says of itself.
    fn channels(&mut self, index: usize, moves: &[Move], limits: &Limits) {
        let Motion { velocity, tangential_acceleration, normal_acceleration, jerk, .. } =
            self.motion;
        let (velocity, across) = (velocity[index], normal_acceleration[index]);
        let acceleration = tangential_acceleration[index].hypot(across);
        let sagitta = across * limits.period * limits.period / 8.0;
        let mut feed = f64::INFINITY;
        if let Some(Move { feed: Some(programmed), rapid: false, .. }) =
            moves.get(self.motion.block[index] as usize)
        {
            feed = programmed * limits.feed_override;
        }
        for (limit, value, allowed) in [
            (Limit::Velocity, velocity, limits.velocity),
            (Limit::Feed, velocity, feed),
            (Limit::Acceleration, acceleration, limits.acceleration),
            (Limit::Jerk, jerk[index], limits.jerk),
            (Limit::ChordError, sagitta, limits.chord_error),
        ] {
            self.hold(limit, index, value, allowed, SLACK * allowed);
        }
    }

    /// What differences of positions tell of the derivatives.
    fn differences(&mut self, moves: &[Move], limits: &Limits) {
        let motion = self.motion;
        // The last sample is at the end, which is no multiple of the period.
        let count = motion.len().saturating_sub(1);
        // First, second and third difference up to the sample before, and how many are known.
        let (mut last, mut known) = ([DVec3::ZERO; 4], 0);
        for index in 0..count {
            let point = motion.point(index);
            if index > 0 && jumps(moves, motion.block[index - 1], motion.block[index]) {
                known = 0;
            }
            let mut now = [point; 4];
            for order in 1..4 {
                now[order] = now[order - 1] - last[order - 1];
            }
            let mut power = 1.0;
            for (order, (limit, most)) in [
                (Limit::Velocity, limits.velocity),
                (Limit::Acceleration, limits.acceleration),
                (Limit::Jerk, limits.jerk),
            ]
            .into_iter()
            .enumerate()
            {
                power *= limits.period;
                if known <= order {
                    break;
                }
                let noise = 8.0 * ROUNDING * point.length() / power;
                let derivative = now[order + 1] / power;
                self.hold(limit, index, derivative.length(), most, SLACK * most + noise);
                let Some(axes) = &limits.axes else { continue };
                let (limit, most) = match order {
                    0 => (Limit::AxisVelocity, axes.velocity),
                    1 => (Limit::AxisAcceleration, axes.acceleration),
                    _ => (Limit::AxisJerk, axes.jerk),
                };
                for axis in 0..3 {
                    let allowed = most[axis];
                    let value = derivative[axis].abs();
                    self.hold(limit, index, value, allowed, SLACK * allowed + noise);
                }
            }
            last = now;
            known += 1;
        }
    }

    /// How far a sample is from the path.
    fn deviation(&mut self, index: usize, moves: &[Move], allowed: f64) {
        let block = self.motion.block[index] as usize;
        let point = self.motion.point(index);
        let slack = SLACK * allowed + END;
        let mut least = f64::INFINITY;
        for step in 0..=2 * REACH {
            // The move itself, then by turns those before and after it.
            let other =
                if step % 2 == 0 { block + step / 2 } else { block.wrapping_sub(step / 2 + 1) };
            if let Some(one) = moves.get(other) {
                least = least.min(distance(one, point));
            }
            if least <= allowed + slack {
                return;
            }
        }
        // Between two pieces of a path it is on no move.
        let starts =
            block.checked_sub(1).and_then(|before| moves.get(before)).zip(moves.get(block));
        if let Some((before, one)) = starts {
            least = least.min(to_line(point, end_of(before), start_of(one)));
        }
        self.hold(Limit::CornerDeviation, index, least, allowed, slack);
    }

    /// Where the motion ends.
    fn end(&mut self, moves: &[Move]) {
        let (Some(last), Some(index)) = (moves.last(), self.motion.len().checked_sub(1)) else {
            return;
        };
        let away = self.motion.point(index).distance(end_of(last));
        self.hold(Limit::End, index, away, END, 0.0);
        self.hold(Limit::Velocity, index, self.motion.velocity[index], 0.0, SLACK);
    }
}

/// Whether a move between two starts elsewhere than the one before it ends.
fn jumps(moves: &[Move], from: u32, to: u32) -> bool {
    for index in from..to {
        if let (Some(before), Some(one)) =
            (moves.get(index as usize), moves.get(index as usize + 1))
            && end_of(before).distance(start_of(one)) > GAP
        {
            return true;
        }
    }
    false
}

fn start_of(one: &Move) -> DVec3 {
    one.plane.place(one.curve.start(), one.heights[0])
}

fn end_of(one: &Move) -> DVec3 {
    one.plane.place(one.curve.end(), one.heights[1])
}

/// The distance of a point from a move; on a helix that of the point beside it, which is no nearer.
fn distance(one: &Move, point: DVec3) -> f64 {
    match &one.curve {
        MoveCurve::Line(_) | MoveCurve::Vertical(_) => to_line(point, start_of(one), end_of(one)),
        curve => {
            let [first, second] = one.heights;
            let (flat, _) = one.plane.split(point);
            let nearest = curve.nearest(flat);
            let height = first + (second - first) * nearest.t;
            one.plane.place(nearest.point, height).distance(point)
        }
    }
}

/// The distance of a point from the straight line between two.
fn to_line(point: DVec3, from: DVec3, to: DVec3) -> f64 {
    let along = to - from;
    let part = (point - from).dot(along) / along.length_squared();
    // Where both ends are one point this is not a number, and the start is as good as any.
    let part = if part > 0.0 { part.min(1.0) } else { 0.0 };
    point.distance(from + along * part)
}
