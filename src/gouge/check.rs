//! Holding every move against the whole contour.

use glam::DVec2;

use super::chord::{Chord, Piece, chords, pieces};
use super::tree::Tree;
use crate::contour::{Contour, Gouge, GougeKind, Move, Role, ToolPath};
use crate::diagnostic::Origin;
use crate::geometry::least;

/// Part of the tolerance that the sagittas of path and contour may take up each.
const SAGITTA_SHARE: f64 = 0.25;

/// Longest stretch of the path judged at once, as a part of the radius: short enough for its
/// distance from one piece to have one minimum where it cuts deep.
const LONGEST: f64 = 0.25;

/// Most parts of one chord: reached only where the radius is absurdly small for its length.
const MAX_PARTS: f64 = 10_000.0;

/// Steps of the search for the deepest point on a stretch that cuts too deep: each keeps 0.618 of
/// the stretch, so 40 leave 4e-9 of it.
const SEARCH_STEPS: usize = 40;

/// Finds every stretch of `path` that comes nearer than `radius - tolerance` [mm] to any point of
/// `contour`, with its deepest point.
///
/// Moves along z and moves that are not compensated ([`Role::Free`]) are not judged. Path and
/// contour are taken as curves in the plane. Stretches that follow each other are one gouge, so a
/// path that cuts a wall along its length gives one. Depths are measured to the radius itself.
#[must_use]
pub fn check(contour: &Contour, path: &ToolPath, radius: f64, tolerance: f64) -> Vec<Gouge> {
    let radius = radius.abs();
    let pieces = pieces(contour);
    let sagitta = SAGITTA_SHARE * tolerance;
    let mut all = Vec::new();
    for (index, piece) in (0_u32..).zip(&pieces) {
        chords(&piece.curve, index, sagitta, f64::INFINITY, &mut all);
    }
    let judge = Judge { contour, pieces: &pieces, tree: Tree::new(all), radius, tolerance };
    judge.judge(path, sagitta)
}

struct Judge<'a> {
    contour: &'a Contour,
    pieces: &'a [Piece],
    tree: Tree,
    radius: f64,
    tolerance: f64,
}

/// What a stretch of the path comes to.
enum Verdict {
    /// Nowhere too near.
    Clear,
    /// Too near, but no deeper than what is known.
    NoDeeper,
    /// Too near, and deeper.
    Deeper(Cut),
}

/// A place where the path is too near.
#[derive(Debug, Clone, Copy)]
struct Cut {
    depth: f64,
    at: DVec2,
    segment: usize,
}

impl Judge<'_> {
    fn judge(&self, path: &ToolPath, sagitta: f64) -> Vec<Gouge> {
        let mut gouges = Vec::new();
        // The gouge that is still going on: its deepest cut, and the origin of the move there.
        let mut going: Option<(Cut, Origin)> = None;
        let mut stretch = Vec::new();
        for (index, one) in (0_u32..).zip(&path.moves) {
            if !is_judged(one) {
                gouges.extend(going.take().map(|cut| self.gouge(cut)));
                continue;
            }
            stretch.clear();
            self.stretches(one, index, sagitta, &mut stretch);
            for chord in &stretch {
                match self.verdict(one, chord, going.map_or(0.0, |(cut, _)| cut.depth)) {
                    Verdict::Clear => gouges.extend(going.take().map(|cut| self.gouge(cut))),
                    Verdict::NoDeeper => {}
                    Verdict::Deeper(cut) => going = Some((cut, one.origin)),
                }
            }
        }
        gouges.extend(going.map(|cut| self.gouge(cut)));
        gouges
    }

    /// Chords of a move: long ones where they are clear as they are, short ones elsewhere.
    fn stretches(&self, one: &Move, index: u32, sagitta: f64, stretches: &mut Vec<Chord>) {
        let mut long = Vec::new();
        chords(&one.curve, index, sagitta, f64::INFINITY, &mut long);
        for chord in long {
            let count = (chord.start.distance(chord.end) / (LONGEST * self.radius)).ceil();
            let count = count.clamp(1.0, MAX_PARTS);
            if count == 1.0 || self.is_clear(&chord) {
                stretches.push(chord);
                continue;
            }
            let [from, to] = chord.range;
            let mut part = Chord { end: chord.start, range: [from, from], ..chord };
            let mut k = 0.0;
            while k < count {
                k += 1.0;
                let last = k == count;
                let t = if last { to } else { from + (to - from) * (k / count) };
                let end = if last { chord.end } else { one.curve.point(t) };
                part = Chord { start: part.end, end, range: [part.range[1], t], ..chord };
                stretches.push(part);
            }
        }
    }

    /// Whether all of a chord's stretch is surely far enough from everything.
    fn is_clear(&self, chord: &Chord) -> bool {
        let limit = self.radius - self.tolerance;
        let reach = limit + chord.sagitta + SAGITTA_SHARE * self.tolerance;
        let mut clear = true;
        self.tree.near(&chord.bounds(), reach, |other| {
            clear = clear && chord.distance(other) >= limit + chord.sagitta + other.sagitta;
        });
        clear
    }

    /// Judges one chord's stretch of a move, where a cut of depth `known` is known already.
    fn verdict(&self, one: &Move, chord: &Chord, known: f64) -> Verdict {
        let limit = self.radius - self.tolerance;
        let mut verdict = Verdict::Clear;
        let mut deepest = known;
        let mut searched = None;
        let reach = limit + chord.sagitta + SAGITTA_SHARE * self.tolerance;
        self.tree.near(&chord.bounds(), reach, |other| {
            let distance = chord.distance(other);
            let bend = chord.sagitta + other.sagitta;
            if distance >= limit + bend {
                return;
            }
            // Surely too near, and surely not deeper than what is known: nothing to search for.
            if distance + bend < limit && distance - bend >= self.radius - deepest {
                if matches!(verdict, Verdict::Clear) {
                    verdict = Verdict::NoDeeper;
                }
                return;
            }
            // Chords of one piece ask for the same search.
            if searched == Some(other.curve) {
                return;
            }
            searched = Some(other.curve);
            let piece = &self.pieces[other.curve as usize];
            let (distance, at) = self.nearest_approach(one, chord.range, piece);
            let depth = self.radius - distance;
            if distance < limit && depth > deepest {
                deepest = depth;
                verdict = Verdict::Deeper(Cut { depth, at, segment: piece.segment });
            } else if distance < limit && matches!(verdict, Verdict::Clear) {
                verdict = Verdict::NoDeeper;
            }
        });
        verdict
    }

    /// Least distance between a stretch of a move and a piece, and the point of the piece.
    ///
    /// Golden-section search between the stretch's ends: it is a chord long, so the distance has one
    /// minimum on it or hardly changes.
    fn nearest_approach(&self, one: &Move, range: [f64; 2], piece: &Piece) -> (f64, DVec2) {
        let at = |t: f64| piece.curve.nearest(one.curve.point(t));
        let enough = 1e-3 * self.tolerance;
        let nearest = at(least(range, SEARCH_STEPS, enough, &mut |t| at(t).distance));
        (nearest.distance, nearest.point)
    }

    /// The report of a gouge: local where the move follows the segment it cuts or its neighbour.
    fn gouge(&self, (cut, origin): (Cut, Origin)) -> Gouge {
        let segments = self.contour.segments();
        let follows = |index: usize| segments[index].attributes.origin == origin;
        let last = segments.len() - 1;
        let around = |index: usize| {
            let wraps = self.contour.is_closed();
            let before = if index > 0 { Some(index - 1) } else { wraps.then_some(last) };
            let after = if index < last { Some(index + 1) } else { wraps.then_some(0) };
            [before, Some(index), after]
        };
        let local = around(cut.segment).into_iter().flatten().any(follows);
        let cut_origin = segments[cut.segment].attributes.origin;
        let mut concerned = vec![cut_origin];
        if origin != cut_origin {
            concerned.push(origin);
        }
        Gouge {
            kind: if local { GougeKind::Curvature } else { GougeKind::Bottleneck },
            at: cut.at,
            depth: cut.depth,
            segments: concerned,
        }
    }
}

/// Whether a move can be held against the contour.
fn is_judged(one: &Move) -> bool {
    one.role != Role::Free && !matches!(one.curve, crate::contour::MoveCurve::Vertical(_))
}
