//! From moves to motion.

use glam::DVec3;

use super::sample::Sample;
use super::speed::{Phase, Rates, rest_to_rest};
use super::{Helix, Limits, LimitsError, Motion, Piece, Straight, Unwound};
use crate::contour::{Move, MoveCurve};
use crate::geometry::nth_root;

/// Plans the motion along moves, from rest to rest.
///
/// # Errors
/// [`LimitsError`] where a limit is not a positive number within reason.
pub fn plan(moves: &[Move], limits: &Limits) -> Result<Motion, LimitsError> {
    let mut planner = Planner::new(limits)?;
    let mut motion = Motion::default();
    for one in moves {
        planner.push(one, &mut motion);
    }
    planner.finish(&mut motion);
    Ok(motion)
}

/// Plans moves as they come, and hands out samples as soon as nothing to come can change them.
#[derive(Debug, Clone)]
pub struct Planner {
    limits: Limits,
    block: u32,
    /// The time that the next run starts at [s].
    start: f64,
    /// The number of the next sample.
    next: u64,
    last: Option<DVec3>,
    law: Vec<Phase>,
}

impl Planner {
    /// A planner at rest, at time 0.
    ///
    /// # Errors
    /// [`LimitsError`] where a limit is not a positive number within reason.
    pub fn new(limits: &Limits) -> Result<Self, LimitsError> {
        limits.check()?;
        let limits = *limits;
        Ok(Self { limits, block: 0, start: 0.0, next: 0, last: None, law: Vec::new() })
    }

    /// Takes a move, which starts where the one before ends, and adds to `motion` the samples that are
    /// certain by now.
    pub fn push(&mut self, one: &Move, motion: &mut Motion) {
        let cap = match one.feed {
            Some(feed) if !one.rapid => feed * self.limits.feed_override,
            _ => self.limits.velocity,
        };
        let cap = cap.min(self.limits.velocity).max(1.0e-6);
        let place = |t: f64, point| {
            let [first, second] = one.heights;
            one.plane.place(point, first + (second - first) * t)
        };
        match &one.curve {
            MoveCurve::Arc(arc) => {
                let helix = Helix::of_arc(arc, one.plane, one.heights);
                self.run(&Piece::Helix(helix), cap, motion);
            }
            MoveCurve::Involute(involute) => {
                let unwound = Unwound::of_involute(involute, one.plane, one.heights);
                self.run(&Piece::Unwound(unwound), cap, motion);
            }
            MoveCurve::Cubic(cubic) => {
                let mut last = place(0.0, cubic.start());
                let (length, mut on) = (cubic.length(), 0.0);
                let mut flat = cubic.start();
                one.curve.flatten(self.limits.chord_error, &mut |point| {
                    on += flat.distance(point);
                    flat = point;
                    let next = place((on / length).min(1.0), point);
                    if let Some(line) = Straight::between(last, next) {
                        self.run(&Piece::Straight(line), cap, motion);
                    }
                    last = next;
                });
            }
            curve => {
                let (from, to) = (place(0.0, curve.start()), place(1.0, curve.end()));
                if let Some(line) = Straight::between(from, to) {
                    self.run(&Piece::Straight(line), cap, motion);
                }
            }
        }
        self.last = Some(place(1.0, one.curve.end()));
        self.block += 1;
    }

    /// From the next corner on: stops at the end of each move (G61.1), or rounds corners within a
    /// deviation [mm] (G64 P); with 0 the path is kept exactly (G61).
    pub fn blend(&mut self, exact_stop: bool, corner_deviation: f64) {
        self.limits.exact_stop = exact_stop;
        self.limits.corner_deviation = corner_deviation.max(0.0);
    }

    /// Comes to rest, and begins the next move wherever it does, at once: the coordinates are others.
    pub fn jump(&mut self) {
        self.last = None;
    }

    /// Stands still for a time [s], after the moves so far.
    pub fn pause(&mut self, seconds: f64, motion: &mut Motion) {
        if let Some(last) = self.last
            && seconds > 0.0
        {
            let piece = Piece::Straight(Straight { start: last, tangent: DVec3::X, length: 0.0 });
            self.law.clear();
            self.law.push(Phase::of_snap(seconds, [0.0; 4], 0.0));
            // The wait is that of the move before it.
            self.block = self.block.saturating_sub(1);
            self.sample(&piece, motion);
            self.block += 1;
        }
    }

    /// Comes to rest, and adds the last samples.
    pub fn finish(&mut self, motion: &mut Motion) {
        if let Some(last) = self.last
            && motion.time.last() != Some(&self.start)
        {
            let block = self.block.saturating_sub(1);
            motion.push(Sample { time: self.start, point: last, rates: [0.0; 4], block });
        }
        motion.duration = self.start;
    }

    /// From rest to rest along a piece.
    fn run(&mut self, piece: &Piece, cap: f64, motion: &mut Motion) {
        let limits = &self.limits;
        let mut rates = Rates {
            velocity: cap,
            acceleration: limits.acceleration,
            jerk: limits.jerk,
            snap: limits.snap(),
        };
        let bend = piece.frame(0.0).curvature.length();
        if bend > 0.0 {
            // With v²κ ≤ 0.36 A, v³κ² ≤ 0.216 J, 3 v a κ ≤ 0.5 J and j ≤ 0.5 J both vectors are within
            // their limits: 0.36² + 0.6² < 1, (0.5 + 0.216)² + 0.5² < 1.
            let jerk_cap = nth_root(limits.jerk / (bend * bend), 3);
            let chord = (8.0 * limits.chord_error / bend).sqrt() / limits.period;
            let velocity = (0.6 * (limits.acceleration / bend).sqrt().min(jerk_cap)).min(chord);
            rates.velocity = rates.velocity.min(velocity);
            let across = 0.5 * limits.jerk / (3.0 * rates.velocity * bend);
            rates.acceleration = (0.6 * rates.acceleration).min(across);
            rates.jerk *= 0.5;
        }
        self.law.clear();
        rest_to_rest(&mut self.law, 0.0, piece.length(), &rates);
        self.sample(piece, motion);
    }

    /// Takes samples of the law.
    fn sample(&mut self, piece: &Piece, motion: &mut Motion) {
        for phase in &self.law {
            let end = self.start + phase.duration;
            loop {
                let time = self.next as f64 * self.limits.period;
                if time >= end {
                    break;
                }
                let [s, v, a, j] = phase.at(time - self.start);
                let frame = piece.frame(s);
                let across = frame.curvature * (v * v);
                let jerk = frame.tangent * j
                    + frame.curvature * (3.0 * v * a)
                    + frame.sharpness * (v * v * v);
                motion.push(Sample {
                    time,
                    point: frame.point,
                    rates: [v, a, across.length(), jerk.length()],
                    block: self.block,
                });
                self.next += 1;
            }
            self.start = end;
        }
    }
}
