//! What speed is planned on: pieces of a track from rest to rest.

use crate::geometry::nth_root;
use crate::motion::{Frame, Joint, Limits, Piece, Placed};

/// Places on a curve where the speed that its bend allows is looked at.
const PLACES: u8 = 12;

/// How much less quickly a fitted piece turns than a rounded corner of its length.
const SMOOTH: f64 = 3.0;

/// A place of a course with what bounds the speed there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    /// Arc length from the start of the run [mm].
    pub(super) s: f64,
    /// Largest speed at the place, run through at constant speed [mm/s].
    pub(super) speed: f64,
    /// Largest speed from there to the next place, as programmed [mm/s].
    pub(super) cap: f64,
    /// Length that belongs together there [mm]: that of the piece.
    pub(super) length: f64,
}

/// A run: pieces that join smoothly, from rest to rest or from one long even stretch to another.
#[derive(Debug, Clone, Default)]
pub(in crate::motion) struct Course {
    pieces: Vec<Placed>,
    /// Arc length of the start of each piece [mm].
    from: Vec<f64>,
    /// Largest programmed speed on each piece [mm/s].
    caps: Vec<f64>,
    pub(super) places: Vec<Place>,
    /// Whether it does not begin and end at rest, but about at its cap.
    pub(in crate::motion) moving: [bool; 2],
    /// Arc length of all [mm].
    pub(in crate::motion) length: f64,
    /// About how long it takes [s].
    pub(in crate::motion) time: f64,
}

impl Course {
    /// Appends a piece.
    pub(in crate::motion) fn push(&mut self, placed: Placed, limits: &Limits) {
        let feed = if placed.rapid { placed.feed } else { placed.feed * limits.feed_override };
        let mut cap = feed.min(limits.velocity);
        if let (Some(axes), Piece::Straight(line)) = (&limits.axes, &placed.piece) {
            for axis in 0..3 {
                cap = cap.min(axes.velocity[axis] / line.tangent[axis].abs().max(1.0e-9));
            }
        }
        let length = placed.piece.length();
        let places = if matches!(placed.piece, Piece::Straight(_)) { 1 } else { PLACES };
        for place in 0..places {
            let on = length * f64::from(place) / f64::from(places);
            let mut speed = even_speed(&placed.piece.frame(on), limits).min(cap);
            if place == 0
                && let Some(before) = self.pieces.last()
            {
                speed = speed.min(before.end.speed(limits)).min(self.caps[self.caps.len() - 1]);
            }
            self.time += length / (f64::from(places) * speed);
            self.places.push(Place { s: self.length + on, speed, cap, length });
        }
        self.from.push(self.length);
        self.caps.push(cap);
        self.length += length;
        self.pieces.push(placed);
    }

    /// Its pieces, where each begins [mm], and the programmed speed on it [mm/s].
    pub(super) fn pieces(&self) -> impl Iterator<Item = (&Placed, f64, f64)> {
        (0..self.pieces.len()).map(|k| (&self.pieces[k], self.from[k], self.caps[k]))
    }

    /// Whether it has no piece.
    pub(in crate::motion) fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Empties it, and keeps its memory.
    pub(in crate::motion) fn clear(&mut self) {
        self.pieces.clear();
        self.from.clear();
        self.caps.clear();
        self.places.clear();
        (self.length, self.time) = (0.0, 0.0);
        self.moving = [false; 2];
    }

    /// Forgets the pieces that end before an arc length [mm]; returns how long they were.
    pub(in crate::motion) fn forget(&mut self, s: f64) -> f64 {
        let mut first = 0;
        self.find(s, &mut first);
        let gone = self.from[first];
        self.pieces.drain(..first);
        self.from.drain(..first);
        self.caps.drain(..first);
        let mut places = 0;
        while places + 1 < self.places.len() && self.places[places].s < gone {
            let [place, next] = [&self.places[places], &self.places[places + 1]];
            self.time -= (next.s - place.s) / place.speed;
            places += 1;
        }
        self.places.drain(..places);
        for from in &mut self.from {
            *from -= gone;
        }
        for place in &mut self.places {
            place.s -= gone;
        }
        self.length -= gone;
        self.moving[0] = false;
        gone
    }

    /// The programmed speed on its first piece [mm/s].
    pub(in crate::motion) fn cap(&self) -> f64 {
        self.caps.first().copied().unwrap_or(0.0)
    }

    /// The least even speed that the bends of its pieces allow [mm/s].
    pub(in crate::motion) fn slowest(&self, limits: &Limits) -> f64 {
        let mut slowest = f64::INFINITY;
        for placed in &self.pieces {
            slowest = slowest.min(even_speed(&placed.piece.frame(0.0), limits));
        }
        slowest
    }

    /// Moves `at` to the piece at the arc length `s` [mm].
    pub(in crate::motion) fn find(&self, s: f64, at: &mut usize) {
        while *at + 1 < self.from.len() && self.from[*at + 1] <= s {
            *at += 1;
        }
        while *at > 0 && self.from[*at] > s {
            *at -= 1;
        }
    }

    /// The length of a piece on which the path turns quickly [mm]; of others it is infinite.
    pub(super) fn turning(&self, at: usize) -> f64 {
        match &self.pieces[at].piece {
            Piece::Straight(_) | Piece::Helix(_) | Piece::Unwound(_) => f64::INFINITY,
            // One interval of a smooth spline turns by less than a rounded corner does.
            Piece::Quintic(quintic) => SMOOTH * quintic.length,
            piece => piece.length(),
        }
    }

    /// The arc length at which a piece starts [mm].
    pub(super) fn start(&self, at: usize) -> f64 {
        self.from[at]
    }

    /// The frame at `s` [mm], looked for from piece `at` on.
    pub(in crate::motion) fn frame(&self, s: f64, at: &mut usize) -> Frame {
        self.find(s, at);
        self.pieces[*at].piece.frame(s - self.from[*at])
    }

    /// The move of a piece.
    pub(in crate::motion) fn block(&self, at: usize) -> u32 {
        self.pieces[at].block
    }

    /// The least programmed speed between two arc lengths [mm], and the largest step of curvature.
    pub(super) fn between(&self, from: f64, to: f64, at: usize, limits: &Limits) -> (f64, bool) {
        let mut at = at;
        self.find(from, &mut at);
        let mut cap = self.caps[at];
        let mut steps = false;
        while at + 1 < self.from.len() && self.from[at + 1] < to {
            if let Joint::Step { curvature, .. } = self.pieces[at].end {
                steps |= curvature > 0.0;
                cap = cap.min(self.pieces[at].end.speed(limits));
            }
            at += 1;
            cap = cap.min(self.caps[at]);
        }
        (cap, steps)
    }
}

/// Acceleration across the path at speed 1: the curvature, of a curve by its arc length.
pub(super) fn across(frame: &Frame) -> f64 {
    frame.tangent.cross(frame.curvature).length() / frame.tangent.length()
}

/// The largest constant speed at a place of a curve, by chord error, acceleration and jerk [mm/s].
fn even_speed(frame: &Frame, limits: &Limits) -> f64 {
    let (bend, sharp) = (frame.curvature.length(), frame.sharpness.length());
    let mut speed = f64::INFINITY;
    if bend > 1.0e-12 {
        let chord = (8.0 * limits.chord_error / across(frame).max(1.0e-12)).sqrt() / limits.period;
        speed = chord.min((limits.acceleration / bend).sqrt());
    }
    if sharp > 1.0e-15 {
        speed = speed.min(nth_root(limits.jerk / sharp, 3));
    }
    speed
}
