//! Limits judged from the samples and the moves alone, by code that shares nothing with the planner.
//!
//! Rates are differences of the sampled points, and the channels of the samples where those are
//! larger. A difference of order n over a period is a mean of the derivative over n periods, so what
//! stays within its limits never exceeds them here.

use glam::DVec3;

use super::{Limits, Motion};
use crate::contour::{Move, MoveCurve};
use crate::geometry::least;

/// How many moves on either side of the one that a sample names are looked at, at most, for the
/// nearest point.
const MOST_NEIGHBOURS: usize = 256;

/// The largest value of something, and its limit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Peak {
    /// The largest value.
    pub value: f64,
    /// The limit, in the same unit.
    pub limit: f64,
    /// When it is reached [s].
    pub time: f64,
}

impl Peak {
    /// The value over its limit; 0 where there is no limit.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        if self.limit > 0.0 { self.value / self.limit } else { 0.0 }
    }

    fn meet(&mut self, value: f64, limit: f64, time: f64) {
        if value * self.limit > self.value * limit || self.limit == 0.0 || value.is_nan() {
            *self = Self { value, limit, time };
        }
    }
}

/// What a motion asks of the machine, and how far it leaves its path.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Violations {
    /// Size of the velocity [mm/s].
    pub velocity: Peak,
    /// Speed on a move with a feed, beside that feed with the override [mm/s].
    pub feed: Peak,
    /// Size of the acceleration [mm/s²].
    pub acceleration: Peak,
    /// Size of the jerk [mm/s³].
    pub jerk: Peak,
    /// Size of the change of the jerk over a period [mm/s³].
    pub jerk_change: Peak,
    /// Velocity, acceleration and jerk of each axis that has limits, from x on.
    pub axes: Vec<[Peak; 3]>,
    /// Distance of samples from the programmed path, and of corners from the samples [mm].
    pub deviation: Peak,
    /// Gap between the path and the chord of a period [mm].
    pub chord_error: Peak,
    /// Distance of the last sample from the end of the last move [mm].
    pub end: f64,
}

impl Violations {
    /// The largest of all ratios to limits.
    #[must_use]
    pub fn worst(&self) -> f64 {
        let mut worst = 0.0_f64;
        let peaks = [
            self.velocity,
            self.feed,
            self.acceleration,
            self.jerk,
            self.jerk_change,
            self.deviation,
            self.chord_error,
        ];
        for peak in peaks.iter().chain(self.axes.iter().flatten()) {
            worst = worst.max(if peak.value.is_nan() { f64::INFINITY } else { peak.ratio() });
        }
        worst
    }
}

impl Motion {
    /// Judges the motion along moves by its samples.
    #[must_use]
    pub fn violations(&self, moves: &[Move], limits: &Limits) -> Violations {
        let mut found = Violations::default();
        if limits.axes.is_some() {
            found.axes = vec![[Peak::default(); 3]; 3];
        }
        self.judge_rates(moves, limits, &mut found);
        self.judge_feed(moves, limits, &mut found);
        self.judge_path(moves, limits, &mut found);
        if let (Some(last), false) = (moves.last(), self.is_empty()) {
            found.end = self.point(self.len() - 1).distance(ends(last)[1]);
        }
        found
    }

    fn judge_rates(&self, moves: &[Move], limits: &Limits, found: &mut Violations) {
        let period = limits.period;
        // Differences of orders 0 to 3, the newest of each.
        let mut last = [DVec3::ZERO; 4];
        // The first sample since the coordinates jumped.
        let mut first = 0;
        for k in 0..self.len() {
            let time = self.time[k];
            if k > 0 && jumps(moves, self.block[k - 1], self.block[k]) {
                first = k;
            }
            let across = self.normal_acceleration[k];
            let channels =
                [self.velocity[k], self.tangential_acceleration[k].hypot(across), self.jerk[k]];
            let chord = across * period * period / 8.0;
            found.chord_error.meet(chord, limits.chord_error, time);
            let sizes = [limits.velocity, limits.acceleration, limits.jerk];
            let mut rates = [&mut found.velocity, &mut found.acceleration, &mut found.jerk];
            for ((peak, channel), limit) in rates.iter_mut().zip(channels).zip(sizes) {
                peak.meet(channel, limit, time);
            }
            // The last sample is at the end, and not at a multiple of the period.
            if k + 1 == self.len() {
                break;
            }
            let before = last;
            last[0] = self.point(k);
            for order in 1..4.min(k - first + 1) {
                last[order] = (last[order - 1] - before[order - 1]) / period;
                rates[order - 1].meet(last[order].length(), sizes[order - 1], time);
                if let (Some(axes), [x, y, z]) = (&limits.axes, found.axes.as_mut_slice()) {
                    let single = [axes.velocity, axes.acceleration, axes.jerk][order - 1];
                    for (axis, peaks) in [x, y, z].into_iter().enumerate() {
                        peaks[order - 1].meet(last[order][axis].abs(), single[axis], time);
                    }
                }
            }
            if k >= first + 2 {
                // The sagitta of a chord: the second difference across it over 8.
                let way = last[1].length_squared().max(f64::MIN_POSITIVE);
                let bend = last[2] - last[1] * (last[2].dot(last[1]) / way);
                let gap = bend.length() * period * period / 8.0;
                found.chord_error.meet(gap, limits.chord_error, time);
            }
            if k >= first + 4 {
                let change = (last[3] - before[3]).length();
                found.jerk_change.meet(change, limits.snap() * period, time);
            }
        }
    }

    fn judge_feed(&self, moves: &[Move], limits: &Limits, found: &mut Violations) {
        for k in 0..self.len() {
            let Some(one) = moves.get(self.block[k] as usize) else { continue };
            if let Some(feed) = one.feed.filter(|_| !one.rapid) {
                found.feed.meet(self.velocity[k], feed * limits.feed_override, self.time[k]);
            }
        }
    }

    fn judge_path(&self, moves: &[Move], limits: &Limits, found: &mut Violations) {
        let Some(most) = moves.len().checked_sub(1) else { return };
        // What rounding leaves of a path that is kept exactly.
        let limit = limits.corner_deviation.max(1.0e-6);
        for k in 0..self.len() {
            let (point, block) = (self.point(k), (self.block[k] as usize).min(most));
            let mut near = distance(&moves[block], point, limit);
            for step in 1..=MOST_NEIGHBOURS {
                if near <= limit || step > most {
                    break;
                }
                near = near.min(distance(&moves[block.saturating_sub(step)], point, limit));
                near = near.min(distance(&moves[(block + step).min(most)], point, limit));
            }
            found.deviation.meet(near, limit, self.time[k]);
        }
        // The samples that pass each corner are those of both of its moves.
        let mut from = 0;
        for (index, one) in moves.iter().enumerate() {
            while from < self.len() && (self.block[from] as usize) < index {
                from += 1;
            }
            let corner = ends(one)[1];
            let mut near = f64::INFINITY;
            let mut time = 0.0;
            for k in from.saturating_sub(1)..self.len().saturating_sub(1) {
                let here = to_line(self.point(k), self.point(k + 1), corner);
                if here < near {
                    (near, time) = (here, self.time[k]);
                }
                if self.block[k] as usize > index + 1 && near <= limit
                    || self.block[k] as usize > index + MOST_NEIGHBOURS
                {
                    break;
                }
            }
            // A fitted curve may count to any of the moves that it runs along.
            let mut k = from;
            while near > limit && k > 0 && self.block[k - 1] as usize + MOST_NEIGHBOURS > index {
                k -= 1;
                let here = to_line(self.point(k), self.point((k + 1).min(self.len() - 1)), corner);
                if here < near {
                    (near, time) = (here, self.time[k]);
                }
            }
            if near.is_finite() {
                found.deviation.meet(near, limit + limits.chord_error, time);
            }
        }
    }
}

/// Whether a move between two begins elsewhere than the one before it ends, by more than rounding.
fn jumps(moves: &[Move], from: u32, to: u32) -> bool {
    for index in from as usize..to as usize {
        if let (Some(before), Some(one)) = (moves.get(index), moves.get(index + 1))
            && ends(before)[1].distance(ends(one)[0]) > 1.0e-6
        {
            return true;
        }
    }
    false
}

/// Where a move begins and ends [mm].
fn ends(one: &Move) -> [DVec3; 2] {
    [
        one.plane.place(one.curve.start(), one.heights[0]),
        one.plane.place(one.curve.end(), one.heights[1]),
    ]
}

/// The distance of a point from a straight line between two others [mm].
fn to_line(start: DVec3, end: DVec3, point: DVec3) -> f64 {
    let along = end - start;
    let square = along.length_squared();
    let t = if square > 0.0 { ((point - start).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
    point.distance(start + along * t)
}

/// The distance of a point from a move [mm]; where a bend climbs, one within `enough` may be too large.
fn distance(one: &Move, point: DVec3, enough: f64) -> f64 {
    if let MoveCurve::Line(_) | MoveCurve::Vertical(_) = &one.curve {
        let [start, end] = ends(one);
        return to_line(start, end, point);
    }
    let (flat, height) = one.plane.split(point);
    let [low, high] = one.heights;
    let mut off = |t: f64| {
        let climbed = low + (high - low) * t;
        one.plane.place(one.curve.point(t), climbed).distance(point)
    };
    // Between the place that is nearest in the plane, and the one at the height.
    let mut along = one.curve.nearest(flat).t;
    if high != low && off(along) > enough {
        let up = ((height - low) / (high - low)).clamp(0.0, 1.0);
        along = least([along.min(up), along.max(up)], 60, 1e-9, &mut off);
    }
    off(along)
}
