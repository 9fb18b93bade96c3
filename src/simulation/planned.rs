//! A tool path in time: its moves, and the words between them that concern motion.

use super::passed_words::{for_words, widest_deviation};
use crate::contour::{AuxiliaryWords, Move, ToolPath};
use crate::motion::{Limits, LimitsError, MOST_SAMPLES, Motion, Planner, Violations};
use crate::program::ways;

/// Plans the motion along a tool path, from rest to rest, as its words have it: G4 P waits, G61.1 stops
/// at the end of each block, G61 keeps to the path exactly, G64 rounds corners again, with a P within
/// that deviation.
///
/// From one piece of a path to the next the tool goes by its [`ways`]. Where words give the coordinates
/// other numbers it stops, and goes on from where they say.
///
/// # Errors
/// [`LimitsError`] where a limit is not a positive number within reason, or where the period is so
/// short that there would be too many samples.
pub fn plan_path(path: &ToolPath, limits: &Limits) -> Result<PathMotion, LimitsError> {
    let mut course = Course {
        planner: Planner::new(limits)?,
        limits: *limits,
        motion: Motion::default(),
        least: 0.0,
    };
    let mut ways = ways(path);
    let mut planned = 0;
    let mut words = path.words.iter();
    let mut next = words.next();
    for (index, one) in path.moves.iter().enumerate() {
        while let Some(these) = next
            && these.before <= index
        {
            course.obey(these);
            next = words.next();
        }
        while let Some((to, way)) = ways.get_mut(planned)
            && *to == index
        {
            course.push(way)?;
            // From here on it is its number among all that is planned.
            *to += planned;
            planned += 1;
        }
        course.push(one)?;
    }
    while let Some(these) = next {
        course.obey(these);
        next = words.next();
    }
    course.planner.finish(&mut course.motion);
    course.check()?;
    Ok(PathMotion { motion: course.motion, ways })
}

/// The motion along a tool path.
#[derive(Debug, Clone, Default)]
pub struct PathMotion {
    /// The samples. Their `block` counts the ways between pieces of the path among its moves.
    motion: Motion,
    /// Those ways, each with its number in that count.
    ways: Vec<(usize, Move)>,
}

impl PathMotion {
    /// The samples; of their channels `block` is told by [`blocks`](Self::blocks).
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The index of the move of each sample; on the way between two pieces, of the one that follows.
    #[must_use]
    pub fn blocks(&self) -> Vec<u32> {
        let of = |planned: &u32| {
            let before = self.ways.partition_point(|(way, _)| *way < *planned as usize);
            u32::try_from(before).map_or(0, |before| planned - before)
        };
        self.motion.block.iter().map(of).collect()
    }

    /// Judges the motion along a path and between its pieces, by its samples; within the widest
    /// deviation that the limits or the path's words allow.
    #[must_use]
    pub fn violations(&self, path: &ToolPath, limits: &Limits) -> Violations {
        let limits = Limits { corner_deviation: widest_deviation(path, limits), ..*limits };
        if self.ways.is_empty() {
            return self.motion.violations(&path.moves, &limits);
        }
        let mut moves = Vec::with_capacity(path.moves.len() + self.ways.len());
        let mut ways = self.ways.iter().peekable();
        for one in &path.moves {
            while let Some((_, way)) = ways.next_if(|(number, _)| *number == moves.len()) {
                moves.push(*way);
            }
            moves.push(*one);
        }
        self.motion.violations(&moves, &limits)
    }
}

/// A path as it is planned.
struct Course {
    planner: Planner,
    limits: Limits,
    motion: Motion,
    /// The time that it takes at the least [s].
    least: f64,
}

impl Course {
    fn push(&mut self, one: &Move) -> Result<(), LimitsError> {
        let length = one.curve.length().max((one.heights[1] - one.heights[0]).abs());
        let velocity = match one.feed {
            Some(feed) if !one.rapid => feed * self.limits.feed_override,
            _ => self.limits.velocity,
        };
        self.least += length / velocity.min(self.limits.velocity);
        self.check()?;
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
        if words.reset.is_some_and(|reset| reset.moves == 0) {
            self.planner.jump();
        }
    }
}
