//! Holding every move against whole contours.

use glam::DVec2;

use super::bound::{is_exact, lower_bound};
use super::exact::approach;
use super::part::Part;
use crate::contour::{Contour, Gouge, GougeKind, Move, MoveCurve, Role, ToolPath};
use crate::diagnostic::Origin;
use crate::geometry::{Bounds, BoxTree, Curve, least};

/// Part of the tolerance to which distances are told from the limit: far above what rounding makes
/// of them, far below what anyone can see. Involutes are judged as cubics that use it up.
const SLACK: f64 = 1e-3;

/// The finest tolerance for such cubics [mm].
const FINEST: f64 = 1e-6;

/// Directions may be off by this part of the tolerance at the radius.
const ASKEW: f64 = 1e-4;

/// Part of the tolerance to which the deepest place of a gouge is known before it is followed to its
/// bottom.
const SETTLED: f64 = 1e-3;

/// Cells are halved until they are at most so many times as large as the stretch: larger ones make
/// looser bounds, smaller ones are many.
const COARSER: f64 = 4.0;

/// Longest stretch searched at once, as a part of the radius: short enough for its distance from one
/// piece to have one minimum where it cuts deep.
const LONGEST: f64 = 0.25;

/// Steps of the search for the deepest point: each keeps 0.618 of the stretch.
const SEARCH_STEPS: usize = 30;

/// Finds every stretch of `path` that comes nearer than `radius - tolerance` [mm] to any point of
/// `contour`, with its deepest point.
///
/// Moves along z and moves that are not compensated ([`Role::Free`]) are not judged. Path and
/// contour are taken as curves in the plane, involutes as cubics within a thousandth of the tolerance. Stretches that follow each other are one gouge, so a
/// path that cuts a wall along its length gives one. Depths are measured to the radius itself.
#[must_use]
pub fn check(contour: &Contour, path: &ToolPath, radius: f64, tolerance: f64) -> Vec<Gouge> {
    check_all(&[contour], path, radius, tolerance)
}

/// As [`check`], against several contours: a boundary and its islands.
#[must_use]
pub fn check_all(
    contours: &[&Contour],
    path: &ToolPath,
    radius: f64,
    tolerance: f64,
) -> Vec<Gouge> {
    let radius = radius.abs();
    let limit = radius - tolerance;
    let near = 0.5 * SLACK * tolerance.max(FINEST);
    let pieces = pieces(contours, near);
    // Nothing is nearer than nothing.
    if limit <= 0.0 || pieces.is_empty() {
        return Vec::new();
    }
    let mut boxes = Vec::with_capacity(pieces.len());
    for piece in &pieces {
        boxes.push(piece.bounds);
    }
    let tree = BoxTree::new(boxes);
    let mut judge = Judge {
        contours,
        pieces: &pieces,
        radius,
        limit,
        tolerance,
        cells: Vec::new(),
        path: MoveCurve::Vertical(DVec2::ZERO),
        origin: Origin::Segment(0),
        going: None,
        gouges: Vec::new(),
    };
    for one in &path.moves {
        if !is_judged(one) {
            judge.end();
            continue;
        }
        judge.origin = one.origin;
        if let MoveCurve::Involute(involute) = &one.curve {
            for cubic in involute.cubics(near) {
                judge.judge(MoveCurve::Cubic(cubic), &tree);
            }
        } else {
            judge.judge(one.curve, &tree);
        }
    }
    judge.end();
    judge.gouges
}

/// Whether a move can be held against the contour.
fn is_judged(one: &Move) -> bool {
    one.role != Role::Free && !matches!(one.curve, MoveCurve::Vertical(_))
}

/// One piece of a contour: a line, an arc or a cubic of a spline.
struct Piece {
    part: Part,
    bounds: Bounds,
    contour: usize,
    segment: usize,
}

/// The pieces of contours, with cubics nearer than `near` [mm] in the place of involutes.
fn pieces(contours: &[&Contour], near: f64) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (contour, of) in contours.iter().enumerate() {
        for (segment, programmed) in of.segments().iter().enumerate() {
            let mut add = |curve: MoveCurve| {
                let bounds = curve.hull_bounds();
                pieces.push(Piece { part: Part::new(curve), bounds, contour, segment });
            };
            match &programmed.curve {
                Curve::Involute(involute) => {
                    for cubic in involute.cubics(near) {
                        add(MoveCurve::Cubic(cubic));
                    }
                }
                Curve::Spline(spline) => {
                    for &cubic in spline.pieces() {
                        add(MoveCurve::Cubic(cubic));
                    }
                }
                curve => add(MoveCurve::of(curve, 0)),
            }
        }
    }
    pieces
}

/// A part of a piece that a stretch of the path may be too near to.
#[derive(Clone, Copy)]
struct Cell {
    part: Part,
    piece: usize,
    /// No point of the stretch is nearer [mm].
    least: f64,
}

/// The deepest place of a gouge.
#[derive(Debug, Clone, Copy)]
struct Cut {
    distance: f64,
    at: DVec2,
    piece: usize,
    /// The move, and the stretch of it where the search ended.
    path: MoveCurve,
    span: [f64; 2],
    origin: Origin,
}

struct Judge<'a> {
    contours: &'a [&'a Contour],
    pieces: &'a [Piece],
    radius: f64,
    /// Nearer than this is too near [mm].
    limit: f64,
    tolerance: f64,
    /// A stack: those of a stretch lie above those of the stretch that it is a half of.
    cells: Vec<Cell>,
    /// The move that is judged, and where it comes from.
    path: MoveCurve,
    origin: Origin,
    /// The deepest place so far of the gouge that is still going on.
    going: Option<Cut>,
    gouges: Vec<Gouge>,
}

impl Judge<'_> {
    /// Holds a curve of the path against all pieces.
    fn judge(&mut self, curve: MoveCurve, tree: &BoxTree) {
        self.path = curve;
        let part = Part::new(curve);
        let enough = self.limit - SLACK * self.tolerance;
        let bounds = curve.hull_bounds();
        tree.meeting(&bounds.inflated(enough), &mut |index| {
            let Piece { part: piece, bounds: around, .. } = &self.pieces[index];
            if around.gap_squared(&bounds) < enough * enough
                && around.distance(part.middle) < enough + part.reach
            {
                self.sift(&part, Cell { part: *piece, piece: index, least: 0.0 }, enough);
            }
            true
        });
        self.stretch(&part, 0, true);
        self.cells.clear();
    }

    /// Keeps what of a cell may be nearer than `enough`, in cells no larger than the stretch.
    fn sift(&mut self, part: &Part, mut cell: Cell, enough: f64) {
        cell.least = lower_bound(part, &cell.part, enough, ASKEW * self.tolerance);
        if cell.least >= enough {
            return;
        }
        let is_cubic = matches!(cell.part.curve, MoveCurve::Cubic(_));
        // A path may have moves of a nanometre, and cells as short would be without number.
        let halves = if is_cubic && cell.part.reach > COARSER * part.reach {
            self.halves(&cell.part)
        } else {
            None
        };
        match halves {
            Some(halves) => {
                for half in halves {
                    self.sift(part, Cell { part: half, ..cell }, enough);
                }
            }
            None => self.cells.push(cell),
        }
    }

    /// Judges a stretch of the path against the cells from `from` on, which alone it may be too near
    /// to; `sifted` tells that they were sifted for it.
    fn stretch(&mut self, part: &Part, mut from: usize, sifted: bool) {
        if !sifted {
            let to = self.cells.len();
            for index in from..to {
                let cell = self.cells[index];
                self.sift(part, cell, self.limit - SLACK * self.tolerance);
            }
            from = to;
        }
        if self.cells.len() == from {
            self.end();
            return;
        }
        if self.is_too_near_throughout(part, from) {
            self.deepen(part, from);
        } else {
            match self.halves(part) {
                Some(halves) => {
                    for half in &halves {
                        self.stretch(half, from, false);
                    }
                }
                None => self.decide(part, from),
            }
        }
        self.cells.truncate(from);
    }

    /// The halves of a part; none where it is so short that samples tell all.
    ///
    /// The second derivative of the distance along a path of curvature κ is at most κ + 1/d, so
    /// between samples it dips by no more than the square of their distance times that.
    fn halves(&self, part: &Part) -> Option<[Part; 2]> {
        let is_short = 64.0 * (2.0 * part.reach).powi(2) < self.limit * self.tolerance
            && 64.0 * part.sagitta < self.tolerance;
        if is_short { None } else { part.halves() }
    }

    /// Whether one point of the contour is too near to all of a stretch.
    fn is_too_near_throughout(&self, part: &Part, from: usize) -> bool {
        let middle = part.curve.point(0.5);
        let cells = &self.cells[from..];
        let off = |cell: &Cell| cell.part.middle.distance_squared(middle);
        let likely = cells.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        likely.is_some_and(|cell| part.farthest(cell.part.curve.nearest(middle).point) < self.limit)
            || cells.iter().any(|cell| part.farthest(cell.part.curve.point(0.5)) < self.limit)
    }

    /// A stretch so short that samples tell all of it.
    fn decide(&mut self, part: &Part, from: usize) {
        let mut nearest: Option<Cut> = None;
        for index in from..self.cells.len() {
            let best = nearest.map_or(self.limit, |cut| cut.distance);
            let cell = self.cells[index];
            nearest = self.search(part, cell.piece, best).or(nearest);
        }
        match nearest {
            Some(cut) => self.cut(cut),
            None => self.end(),
        }
    }

    /// Looks for the deepest place of a stretch that is too near throughout.
    fn deepen(&mut self, part: &Part, from: usize) {
        if 2.0 * part.reach > LONGEST * self.radius
            && let Some(halves) = part.halves()
        {
            for half in &halves {
                self.deepen(half, from);
            }
            return;
        }
        // What is probably nearest comes first, and shows that most of the others are not.
        let middle = part.curve.point(0.5);
        let near = |cell: &Cell| cell.part.middle.distance(middle) - cell.part.reach;
        let to = self.cells.len();
        let first =
            (from..to).min_by(|&a, &b| near(&self.cells[a]).total_cmp(&near(&self.cells[b])));
        let mut searched = None;
        for index in first.into_iter().chain(from..to) {
            let cell = self.cells[index];
            let enough = self.best() - SETTLED * self.tolerance;
            // Cells of one piece ask for the same search.
            if cell.least >= enough
                || searched == Some(cell.piece)
                || lower_bound(part, &cell.part, enough, 0.0) >= enough
            {
                continue;
            }
            if is_exact(part, &cell.part) {
                let (distance, at) = approach(&part.curve, &cell.part.curve);
                self.cut(Cut { distance, at, ..self.cut_at(part, cell.piece) });
            } else if let Some(cut) = self.search(part, cell.piece, self.best()) {
                self.cut(cut);
            }
            searched = Some(cell.piece);
        }
        // All of it is too near, so a place is to be named.
        if self.going.is_none()
            && let Some(index) = first
        {
            self.cut(self.search_of(part, self.cells[index].piece));
        }
    }

    /// The deepest distance known of the gouge that is going on.
    fn best(&self) -> f64 {
        self.going.map_or(self.limit, |cut| cut.distance)
    }

    /// Notes a place where the path is too near.
    fn cut(&mut self, cut: Cut) {
        if self.going.is_none_or(|going| cut.distance < going.distance) {
            self.going = Some(cut);
        }
    }

    /// A cut of no depth where a stretch may cut a piece.
    fn cut_at(&self, part: &Part, piece: usize) -> Cut {
        let (path, span, origin) = (self.path, part.span, self.origin);
        Cut { distance: f64::INFINITY, at: DVec2::ZERO, piece, path, span, origin }
    }

    /// The place of a stretch that is nearest to a piece, if it is nearer than `best`.
    fn search(&self, part: &Part, piece: usize, best: f64) -> Option<Cut> {
        Some(self.search_of(part, piece)).filter(|found| found.distance < best)
    }

    fn search_of(&self, part: &Part, piece: usize) -> Cut {
        let fine = SETTLED * self.tolerance;
        self.nearest(self.cut_at(part, piece), &part.curve, [0.0, 1.0], fine)
    }

    /// Where a stretch of a curve is nearest to a piece, by golden sections until the distance [mm]
    /// is as `fine`.
    fn nearest(&self, cut: Cut, curve: &MoveCurve, range: [f64; 2], fine: f64) -> Cut {
        let at = |t: f64| self.pieces[cut.piece].part.curve.nearest(curve.point(t));
        let nearest = at(least(range, SEARCH_STEPS, fine, &mut |t| at(t).distance));
        Cut { distance: nearest.distance, at: nearest.point, ..cut }
    }

    /// Ends the gouge that is going on, if there is one.
    ///
    /// It is local where the move follows the segment it cuts or its neighbour.
    fn end(&mut self) {
        let Some(mut cut) = self.going.take() else { return };
        // To the bottom: what was known was known to a part of its depth.
        let bottom = self.nearest(cut, &cut.path, cut.span, 0.0);
        if bottom.distance < cut.distance {
            cut = bottom;
        }
        let piece = &self.pieces[cut.piece];
        let contour = self.contours[piece.contour];
        let segments = contour.segments();
        let follows = |index: usize| segments[index].attributes.origin == cut.origin;
        let (index, last) = (piece.segment, segments.len() - 1);
        let wraps = contour.is_closed();
        let before = if index > 0 { Some(index - 1) } else { wraps.then_some(last) };
        let after = if index < last { Some(index + 1) } else { wraps.then_some(0) };
        let local = [before, Some(index), after].into_iter().flatten().any(follows);
        let cut_origin = segments[index].attributes.origin;
        let mut concerned = vec![cut_origin];
        if cut.origin != cut_origin {
            concerned.push(cut.origin);
        }
        self.gouges.push(Gouge {
            kind: if local { GougeKind::Curvature } else { GougeKind::Bottleneck },
            at: cut.at,
            depth: self.radius - cut.distance,
            segments: concerned,
        });
    }
}
