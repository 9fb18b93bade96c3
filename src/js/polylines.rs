//! Curves as polylines: pieces without a gap, one vertex after the other.

use glam::DVec3;

use super::argument::BadArgument;
use crate::contour::{Contour, Move, MoveCurve};

/// Most vertices in one answer. A path of a hundred thousand moves has some millions at a
/// micrometre; far beyond that, memory ends.
const MAX_VERTICES: usize = 1 << 23;

/// Distance from which on two moves do not follow each other [mm]: a nanometre, which no machine
/// resolves, and which rounding of coordinates does not reach.
const GAP: f64 = 1e-6;

/// Polylines of several pieces.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Polylines {
    /// x, y and z of each vertex [mm].
    pub(super) points: Vec<f64>,
    /// Index of the first vertex of each piece.
    pub(super) starts: Vec<u32>,
    /// For each vertex, the index of the curve whose chord ends there; for the first of a piece,
    /// that of the curve which begins there.
    pub(super) owners: Vec<u32>,
}

impl Polylines {
    /// The polylines of moves that follow each other without a gap or a rapid move.
    pub(super) fn of_moves(moves: &[Move], tolerance: f64) -> Result<Self, BadArgument> {
        let mut polylines = Self::default();
        let mut end = None;
        for (owner, step) in (0..).zip(moves) {
            if step.rapid {
                end = None;
                continue;
            }
            let place = |point, height| step.plane.place(point, height);
            let start = place(step.curve.start(), step.heights[0]);
            if !end.is_some_and(|end: DVec3| end.distance(start) <= GAP) {
                polylines.begin();
                polylines.add(start, owner);
            }
            let from = polylines.owners.len();
            let mut add = |point| polylines.add(place(point, step.heights[1]), owner);
            step.curve.flatten(tolerance, &mut add);
            polylines.spread_height(from, step);
            polylines.check()?;
            end = Some(place(step.curve.end(), step.heights[1]));
        }
        Ok(polylines)
    }

    /// Begins a piece with the polyline of a contour, which stays empty where there is none; each
    /// segment has the number that `number` gives it.
    pub(super) fn contour(
        &mut self,
        contour: Option<&Contour>,
        tolerance: f64,
        number: impl Fn(usize) -> u32,
    ) -> Result<(), BadArgument> {
        self.begin();
        let segments = contour.map_or(&[][..], Contour::segments);
        for (i, segment) in segments.iter().enumerate() {
            let (plane, [height, end]) = (segment.attributes.plane, segment.attributes.heights);
            if i == 0 {
                self.add(plane.place(segment.curve.start(), height), number(i));
            }
            let mut add = |point| self.add(plane.place(point, end), number(i));
            segment.curve.flatten(tolerance, &mut add);
            self.check()?;
        }
        Ok(())
    }

    fn begin(&mut self) {
        self.starts.push(index(self.owners.len()));
    }

    fn add(&mut self, point: DVec3, owner: u32) {
        self.points.extend(point.to_array());
        self.owners.push(owner);
    }

    /// Gives the vertices of a move, from vertex `from` on, heights that change evenly along it.
    fn spread_height(&mut self, from: usize, step: &Move) {
        let [start, end] = step.heights;
        let [.., normal] = step.plane.axes();
        let count = self.owners.len() - from;
        if start == end {
            return;
        }
        for i in 0..count {
            // Chords of one move have the same step of its parameter, or turn by the same angle.
            let t = (i + 1) as f64 / count as f64;
            let t = match &step.curve {
                MoveCurve::Involute(involute) => involute.length_share(t),
                _ => t,
            };
            self.points[3 * (from + i) + normal] =
                if i + 1 == count { end } else { start + (end - start) * t };
        }
    }

    fn check(&self) -> Result<(), BadArgument> {
        if self.owners.len() <= MAX_VERTICES {
            return Ok(());
        }
        Err(BadArgument::new("tolerance", "be larger: the polylines have too many vertices"))
    }
}

/// An index as JavaScript gets it; [`MAX_VERTICES`] keeps it in range.
fn index(value: usize) -> u32 {
    u32::try_from(value).unwrap_or(u32::MAX)
}
