//! Fitting: runs of short lines become curves whose curvature and its derivative are continuous.
//!
//! A planner that rounds the corners of a dense polygon one by one has but half a leg for each, so
//! that the path gets slower the finer it is. So the polygon is taken for what it stands for: a
//! curve that it follows within a tolerance. In order:
//!
//! 1. [`thin`]: points are dropped that the rest passes closely, as they come;
//! 2. [`layout`]: what stays a corner (to be rounded, or to stop in), what stays a straight line,
//!    and how fine the spline must be in between;
//! 3. [`tube`]: the smoothest quintic spline inside a tube round the polygon, proved to lie in it.
//!
//! Splines are C⁴ inside and join straight lines with curvature and its first two derivatives zero.
//! A window of bounded length moves along the path. What it has handed out stays; the spline goes on
//! from there as smoothly as inside.

mod banded;
mod basis;
mod layout;
mod section;
mod thin;
mod tube;

use glam::DVec3;

use self::layout::Vertex;
use self::section::Start;
use self::thin::Sleeve;
use super::Piece;

/// The part of the tolerance that thinning may take, twice (at the end of a path).
const THINNING: f64 = 1.0 / 24.0;

/// Corners of the thinned polygon that are looked at together.
const WINDOW: usize = 384;

/// Points kept that one leg of the coarse polygon may stand for.
const MOST_FINE: usize = 256;

/// The part of the tolerance to which the polygon is looked at without its noise.
const COARSE: f64 = 1.2;

/// How far the place moves on, per length, where a leg leads back along the coarse polygon.
const BACKWARD: f64 = 1e-3;

/// Points that one leg of the thinned polygon may stand for.
const MOST_POINTS: usize = 4096;

/// One curve of the fitted path.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// The curve.
    pub piece: Piece,
    /// Where each block that it stands for ends on it [mm of arc length], and which; at least one,
    /// and the last ends with the piece or goes on after it.
    pub blocks: Vec<(f64, u32)>,
    /// The lowest feed of those blocks [mm/s].
    pub feed: f64,
    /// How far it may be from the given path [mm].
    pub off: f64,
    /// Whether it goes on from the piece before with the same tangent, curvature and derivative of
    /// the curvature; else they meet in a corner.
    pub smooth: bool,
}

/// Where a block ends.
#[derive(Debug, Clone, Copy)]
struct Mark {
    /// Along the thinned polygon [mm]; by its own measure as long as that is not known.
    place: f64,
    /// Which block.
    block: u32,
    /// Its feed [mm/s].
    feed: f64,
}

/// Takes the straight moves of a path one by one and hands out the fitted path.
///
/// No point of the one is farther from the other than the tolerance; both have the same ends.
#[derive(Debug, Clone)]
pub struct Fitter {
    /// How far the fitted path may be from the given one [mm].
    tolerance: f64,
    sleeve: Sleeve,
    /// The last point given [mm].
    last: DVec3,
    /// Blocks since the last point kept, their places measured from it in the sleeve's measure.
    pending: Vec<Mark>,
    /// The second thinning, which looks at the points kept coarsely: the noise is not seen.
    coarse: Sleeve,
    /// The points kept since the last corner of that, their places measured from it along them.
    fine: Vec<Vertex>,
    /// The blocks that end there, in the same measure.
    fine_marks: Vec<Mark>,
    /// Corners of the thinned polygon from the leg that the fitted path has come to.
    vertices: Vec<Vertex>,
    /// The blocks that end after it.
    marks: Vec<Mark>,
    /// The index of the last corner of the coarse polygon, and where the one before was [mm].
    corner: (usize, DVec3),
    start: Start,
    /// How many corners to wait for.
    wait: usize,
}

impl Fitter {
    /// A fitter of the path that begins at a point, within the tolerance [mm], which is positive.
    #[must_use]
    pub fn new(start: DVec3, tolerance: f64) -> Self {
        Self {
            tolerance,
            sleeve: Sleeve::new(start, tolerance * THINNING),
            last: start,
            pending: Vec::new(),
            coarse: Sleeve::new(start, tolerance * COARSE),
            fine: Vec::new(),
            fine_marks: Vec::new(),
            vertices: vec![Vertex { point: start, place: 0.0, turn: 0.0, exact: false }],
            marks: Vec::new(),
            corner: (0, start),
            start: Start::Corner { smooth: false },
            wait: WINDOW,
        }
    }

    /// Whether the path has come to a point [mm].
    #[must_use]
    pub fn is_at(&self, point: DVec3) -> bool {
        self.last == point
    }

    /// Takes a straight move: where it ends [mm], its block and its feed [mm/s]. What is certain by
    /// now of the fitted path is added to `out`.
    pub fn line(&mut self, end: DVec3, block: u32, feed: f64, out: &mut Vec<Fitted>) {
        if end == self.last {
            // It goes nowhere, and takes no time.
            return;
        }
        let admitted = match self.sleeve.admit(end) {
            Some(_) if self.pending.len() >= MOST_POINTS && !self.sleeve.is_empty() => None,
            admitted => admitted,
        };
        let place = admitted.unwrap_or_else(|| {
            self.keep(self.last);
            self.sleeve.restart(self.last);
            self.sleeve.admit(end).unwrap_or(0.0)
        });
        self.pending.push(Mark { place, block, feed });
        self.last = end;
        if self.vertices.len() >= self.wait {
            self.advance(false, out);
            self.wait = WINDOW.max(2 * self.vertices.len());
        }
    }

    /// Ends the path: the rest of it is added to `out`, and the next one begins where it ended.
    pub fn finish(&mut self, out: &mut Vec<Fitted>) {
        if self.sleeve.is_empty() && self.fine.len() > 1 {
            // What is left is too short to have a direction: the leg before ends in it.
            self.fine.pop();
        }
        self.keep(self.last);
        self.close();
        self.advance(true, out);
        *self = Self::new(self.last, self.tolerance);
    }

    /// Keeps a point, and gives the blocks since the one before their places.
    fn keep(&mut self, point: DVec3) {
        if self.fine.len() >= MOST_FINE || self.coarse.admit(point).is_none() {
            self.close();
            self.coarse.admit(point);
        }
        let from = self.fine.last().copied().unwrap_or(Vertex {
            point: self.vertices[self.vertices.len() - 1].point,
            place: 0.0,
            turn: 0.0,
            exact: false,
        });
        let exact = self.pending.len() == 1;
        let place = from.place + point.distance(from.point);
        let reach = self.pending.last().map_or(0.0, |mark| mark.place);
        for mark in self.pending.drain(..) {
            let part = if reach > 0.0 { (mark.place / reach).min(1.0) } else { 1.0 };
            self.fine_marks.push(Mark { place: from.place + part * (place - from.place), ..mark });
        }
        self.fine.push(Vertex { point, place, turn: 0.0, exact });
    }

    /// Closes a leg of the coarse polygon: the points kept get their places along it. Noise makes
    /// the polygon long, but not the coarse one, and not the curve that follows both.
    fn close(&mut self) {
        let Some(last) = self.fine.last() else { return };
        let end = last.point;
        let from = self.vertices[self.vertices.len() - 1];
        let chord = end - from.point;
        let length = chord.length();
        // The turn at the corner before is known now.
        let (before, at) = (from.point - self.corner.1, self.corner.0);
        if at > 0 {
            let turn = before.cross(chord).length().atan2(before.dot(chord));
            self.vertices[at].turn = turn;
        }
        let (mut mark, mut old, mut place) = (0, 0.0, from.place);
        for (i, fine) in self.fine.iter().enumerate() {
            let along =
                if length > 0.0 { (fine.point - from.point).dot(chord) / length } else { 0.0 };
            let along = if i + 1 == self.fine.len() { length } else { along.min(length) };
            let before = self.vertices[self.vertices.len() - 1].point;
            let next = (from.place + along).max(place + BACKWARD * fine.point.distance(before));
            if next <= place {
                continue;
            }
            while mark < self.fine_marks.len() && self.fine_marks[mark].place <= fine.place {
                let given = self.fine_marks[mark];
                let part = (given.place - old) / (fine.place - old).max(f64::MIN_POSITIVE);
                self.marks.push(Mark { place: place + part.min(1.0) * (next - place), ..given });
                mark += 1;
            }
            (old, place) = (fine.place, next);
            self.vertices.push(Vertex { place, ..*fine });
        }
        self.corner = (self.vertices.len() - 1, from.point);
        self.fine.clear();
        self.fine_marks.clear();
        self.coarse.restart(end);
    }
}
