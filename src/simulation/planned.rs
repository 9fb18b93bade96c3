//! A tool path in time: its moves, and the words between them that concern motion.

use glam::DVec3;

use super::passed_words::for_words;
use crate::contour::{AuxiliaryWords, Move, MoveCurve, Plane, Role, ToolPath};
use crate::geometry::Line;
use crate::motion::{Limits, LimitsError, MOST_SAMPLES, Motion, Planner};

/// Distance from which on two moves do not follow each other [mm]: what rounding does not reach.
const GAP: f64 = 1e-6;

/// Plans the motion along a tool path, from rest to rest, as its words have it: G4 P waits, G61.1 stops
/// at the end of each block, G61 keeps to the path exactly, G64 rounds corners again, with a P within
/// that deviation.
///
/// From one piece of a path to the next the tool goes straight, at the velocity of the limits; where
/// words give the coordinates other numbers it stops, and goes on from where they say.
///
/// # Errors
/// [`LimitsError`] where a limit is not a positive number within reason, or where the period is so
/// short that there would be too many samples.
pub fn plan_path(path: &ToolPath, limits: &Limits) -> Result<Motion, LimitsError> {
    let mut course = Course {
        planner: Planner::new(limits)?,
        limits: *limits,
        motion: Motion::default(),
        moves: Vec::new(),
        at: None,
        least: 0.0,
    };
    let mut words = path.words.iter();
    let mut next = words.next();
    for (index, one) in (0..).zip(&path.moves) {
        while let Some(these) = next
            && these.before <= index as usize
        {
            course.obey(these);
            next = words.next();
        }
        course.go(one, index)?;
    }
    while let Some(these) = next {
        course.obey(these);
        next = words.next();
    }
    course.finish()
}

/// A path as it is planned.
struct Course {
    planner: Planner,
    limits: Limits,
    motion: Motion,
    /// The index of each move that the planner was given.
    moves: Vec<u32>,
    /// Where the tool is.
    at: Option<DVec3>,
    /// The time that it takes at the least [s].
    least: f64,
}

impl Course {
    /// One move, and the way to it.
    fn go(&mut self, one: &Move, index: u32) -> Result<(), LimitsError> {
        let start = one.plane.place(one.curve.start(), one.heights[0]);
        if let Some(at) = self.at
            && at.distance(start) > GAP
        {
            self.push(&straight(at, start, one), index)?;
        }
        self.at = Some(one.plane.place(one.curve.end(), one.heights[1]));
        self.push(one, index)
    }

    fn push(&mut self, one: &Move, index: u32) -> Result<(), LimitsError> {
        let length = one.curve.length().max((one.heights[1] - one.heights[0]).abs());
        let velocity = match one.feed {
            Some(feed) if !one.rapid => feed * self.limits.feed_override,
            _ => self.limits.velocity,
        };
        self.least += length / velocity.min(self.limits.velocity);
        self.check()?;
        self.moves.push(index);
        self.planner.push(one, &mut self.motion);
        Ok(())
    }

    /// That there are not too many samples.
    fn check(&self) -> Result<(), LimitsError> {
        let most = MOST_SAMPLES as f64;
        if self.least > most * self.limits.period || self.motion.len() >= MOST_SAMPLES {
            return Err(LimitsError { name: "period" });
        }
        Ok(())
    }

    /// Words between two moves.
    fn obey(&mut self, words: &AuxiliaryWords) {
        let mut command = 0.0;
        for_words(&words.words, &mut |letter, value| match letter {
            b'G' => {
                command = value;
                match (value * 10.0).round() {
                    610.0 => self.planner.blend(false, 0.0),
                    611.0 => self.planner.blend(true, 0.0),
                    640.0 => self.planner.blend(false, self.limits.corner_deviation),
                    _ => {}
                }
            }
            b'P' if command == 4.0 => {
                self.least += value;
                if self.check().is_ok() {
                    self.planner.pause(value, &mut self.motion);
                }
            }
            b'P' if command == 64.0 => self.planner.blend(false, value),
            b'M' | b'T' => command = 0.0,
            _ => {}
        });
        // Where the words make moves, those take the tool there.
        if let Some(reset) = words.reset.filter(|reset| reset.moves == 0) {
            self.planner.jump();
            self.at = Some(reset.at);
        }
    }

    fn finish(mut self) -> Result<Motion, LimitsError> {
        self.planner.finish(&mut self.motion);
        self.check()?;
        for block in &mut self.motion.block {
            let index = (*block as usize).min(self.moves.len() - 1);
            *block = self.moves[index];
        }
        Ok(self.motion)
    }
}

/// The way between two pieces, as a move before `next`.
fn straight(from: DVec3, to: DVec3, next: &Move) -> Move {
    let flat = Line::new(from.truncate(), to.truncate());
    let curve = flat.map_or(MoveCurve::Vertical(from.truncate()), MoveCurve::Line);
    Move {
        curve,
        role: Role::Free,
        rapid: true,
        feed: None,
        plane: Plane::Xy,
        heights: [from.z, to.z],
        origin: next.origin,
    }
}
