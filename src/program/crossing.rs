//! How the tool gets from one piece of a path to the next: up, across and down.
//!
//! Between two pieces lies what the tool must not touch, or they would be one. So it crosses at a
//! height that is known to be free, and where none is known no program is written for it.

use glam::DVec3;

use crate::contour::{Move, MoveCurve, Plane, Role, ToolPath};
use crate::geometry::Line;

/// Heights nearer than this are one [mm]: the last digit written.
const SAME_HEIGHT: f64 = 1e-4;

/// Distance from which on two moves do not follow each other [mm]: what rounding does not reach.
const GAP: f64 = 1e-6;

/// The moves that take the tool from one piece of a path to the next, each with the index of the move
/// that it leads to: up to the height at which the path itself has rapid moves, across, and down at
/// the feed of the program's own way down; where no such height is known, straight across.
///
/// Where words give the coordinates other numbers there is no way: the tool goes on from where they
/// say.
#[must_use]
pub fn ways(path: &ToolPath) -> Vec<(usize, Move)> {
    let mut crossing = Crossing::new(None, path);
    let mut words = path.words.iter();
    let mut next_words = words.next();
    let mut at: Option<DVec3> = None;
    let mut ways = Vec::new();
    for (index, next) in path.moves.iter().enumerate() {
        while let Some(these) = next_words
            && these.before <= index
        {
            // Where the words make moves, those take the tool there.
            if let Some(reset) = these.reset.filter(|reset| reset.moves == 0) {
                at = Some(reset.at);
            }
            next_words = words.next();
        }
        let [start, end] = ends(next);
        if let Some(at) = at
            && at.distance(start) > GAP
        {
            let height = crossing.height(at.z, start.z).unwrap_or(at.z.max(start.z));
            for step in crossing.way(at, next, height) {
                if ends(&step)[0] != ends(&step)[1] {
                    ways.push((index, step));
                }
            }
        }
        at = Some(end);
        crossing.passed(next);
    }
    ways
}

/// What is known about crossing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crossing {
    /// The height that the caller gave [mm].
    given: Option<f64>,
    /// The highest at which the program itself makes rapid moves, once it has said a height [mm].
    programmed: Option<f64>,
    /// The feed at which it last went straight down [mm/s].
    plunge: Option<f64>,
}

impl Crossing {
    pub(crate) fn new(given: Option<f64>, path: &ToolPath) -> Self {
        // Until the height first changes it is only assumed.
        let mut stated = false;
        let mut programmed: Option<f64> = None;
        // What words make themselves may be at heights of the machine.
        let mut made = path.words.iter().filter_map(|words| {
            let moves = words.reset?.moves;
            (moves > 0).then_some((words.before, words.before + moves))
        });
        let mut next = made.next();
        for (i, step) in path.moves.iter().enumerate() {
            if let Some((first, end)) = next
                && i >= first
            {
                if i + 1 == end {
                    next = made.next();
                }
                continue;
            }
            let [from, to] = ends(step);
            stated |= from.z != to.z;
            if stated && step.rapid {
                programmed = Some(programmed.map_or(to.z, |height| height.max(to.z)));
            }
        }
        Self { given, programmed, plunge: None }
    }

    /// The height at which the tool gets from one height to another [mm], if one is known.
    ///
    /// One that was given is taken at its word, though never below both. A program whose rapid moves
    /// are no higher than its cuts says nothing about what lies between them.
    pub(crate) fn height(&self, from: f64, to: f64) -> Option<f64> {
        let above = from.max(to);
        match self.given {
            Some(given) => Some(given.max(above)),
            None => self.programmed.filter(|height| *height > above + SAME_HEIGHT),
        }
    }

    /// The height that the caller gave, but not below `z` [mm].
    pub(super) fn given(&self, z: f64) -> Option<f64> {
        self.given.map(|given| given.max(z))
    }

    /// The way from a place to where `next` begins: up to a height [mm] that is not below either,
    /// across, and down, each of which may be no way at all; down at the feed at which the program
    /// itself last went down, since it goes slower into the material than along it.
    pub(crate) fn way(&self, from: DVec3, next: &Move, height: f64) -> [Move; 3] {
        let to = ends(next)[0];
        let (here, there) = (from.truncate(), to.truncate());
        let up = Move {
            curve: MoveCurve::Vertical(here),
            role: Role::Free,
            rapid: true,
            feed: None,
            plane: Plane::Xy,
            heights: [from.z, height],
            origin: next.origin,
        };
        let mut across = Move { heights: [height, height], ..up };
        if let Ok(line) = Line::new(here, there) {
            across.curve = MoveCurve::Line(line);
        }
        let feed = self.plunge.or(next.feed);
        let (curve, heights) = (MoveCurve::Vertical(there), [height, to.z]);
        [up, across, Move { curve, heights, rapid: next.rapid, feed, ..up }]
    }

    /// Learns from a move that is made.
    pub(crate) fn passed(&mut self, step: &Move) {
        let [from, to] = ends(step);
        if !step.rapid && to.z < from.z && (from.x, from.y) == (to.x, to.y) {
            self.plunge = step.feed.or(self.plunge);
        }
    }
}

/// Where a move starts and where it ends [mm].
pub(crate) fn ends(step: &Move) -> [DVec3; 2] {
    let [start, end] = step.heights;
    [step.plane.place(step.curve.start(), start), step.plane.place(step.curve.end(), end)]
}
