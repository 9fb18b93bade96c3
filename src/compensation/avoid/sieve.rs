//! Which raw pieces need a closer look, and how near places are to the contour.
//!
//! What the tree did not mark is clear. Of the rest most is plainly too near, deep inside a loop:
//! a piece whose hull lies within the tool about one point of the contour is dropped. Neighbours are
//! mostly cut by the same part of the contour, so that is tried first.

use glam::DVec2;

use super::cuts::Stretch;
use super::octants::Octants;
use super::tree::{Marks, OrderTree};
use super::units::{Kind, Piece, Workpiece};
use crate::compensation::offset::Tolerances;
use crate::contour::MoveCurve;
use crate::geometry::{Bounds, Cubic, direction};

/// Units to each side that are looked at to find the tame stretch around one.
const TAME_REACH: usize = 24;

/// How near the offset of a span is made where it is going to be cut or dropped, as a part of the
/// span's length.
const ROUGH: f64 = 0.01;

/// Units beside a piece of which it is kept which they are; of a long piece beside many they are looked
/// for at each place.
const MOST_BESIDE: usize = 64;

/// Whether a place of the raw path is clear of the contour.
#[derive(Debug)]
pub(super) struct Clearance<'a> {
    work: &'a Workpiece<'a>,
    tree: &'a OrderTree,
    /// Nearer than this is too near [mm].
    least: f64,
    /// The unit that was too near last; none at first.
    hint: usize,
    /// The stretch of units that the last place's unit is surely clear of, and that unit.
    tame: (usize, [usize; 2]),
    /// The last piece asked about, and the units that it may be too near to, but for the tame ones.
    beside: (usize, Vec<usize>),
}

impl<'a> Clearance<'a> {
    pub(super) fn new(work: &'a Workpiece<'a>, tree: &'a OrderTree, least: f64) -> Self {
        let (tame, beside) = ((usize::MAX, [0, 0]), (usize::MAX, Vec::new()));
        // The first unit may run in, and be no wall.
        Self { work, tree, least, hint: usize::MAX, tame, beside }
    }

    /// The tame stretch around a unit.
    pub(super) fn tame(&mut self, unit: usize) -> [usize; 2] {
        if self.tame.0 != unit {
            let range = self.work.range_of(unit);
            self.tame = (unit, self.tree.tame_around(unit, range, TAME_REACH));
        }
        self.tame.1
    }

    /// The fate of a piece that may be too near, and is off by up to `rough` [mm].
    pub(super) fn fate(&mut self, curve: &MoveCurve, unit: usize, rough: f64) -> Fate {
        if self.runs_back(unit, curve) || self.is_gouged(curve, rough) {
            Fate::Gouged
        } else {
            Fate::Open
        }
    }

    /// Whether a tool of `radius` [mm] that touches the contour beside a stretch fits in between.
    ///
    /// Offsets of splines are off by a part of the tolerance, so it is put to the contour itself.
    pub(super) fn fits_along(&mut self, stretch: &Stretch, radius: f64) -> bool {
        let Piece { curve, unit, .. } = &self.work.pieces[stretch.piece];
        let unit = *unit as usize;
        let Some(beside) = self.work.curve(unit) else { return false };
        [0.25, 0.5, 0.75].iter().any(|k| {
            let point = curve.point(stretch.from + (stretch.to - stretch.from) * k);
            let foot = beside.nearest(point).point;
            direction(point - foot).is_some_and(|out| self.is_clear(foot + out * radius, unit))
        })
    }

    /// Whether `point` of the path of `unit` is far enough from all of the contour.
    ///
    /// What the path of the unit cannot be too near to, the tame stretch around it, is passed over.
    fn is_clear(&mut self, point: DVec2, unit: usize) -> bool {
        let [from, to] = self.tame(unit);
        self.is_clear_except(point, [from, to])
    }

    /// Whether the place at `t` of a piece is far enough from all of the contour but the tame stretch
    /// around its unit: what may be near is looked for once for all of the piece.
    pub(super) fn is_clear_on(&mut self, piece: usize, t: f64) -> bool {
        let Piece { curve, unit, .. } = &self.work.pieces[piece];
        let (point, tame) = (curve.point(t), self.tame(*unit as usize));
        if self.is_near_hint(point, tame) {
            return false;
        }
        if self.beside.0 != piece {
            let mut found = std::mem::take(&mut self.beside.1);
            found.clear();
            self.tree.near(&curve.hull_bounds(), self.least, &mut |unit| {
                if unit < tame[0] || unit >= tame[1] {
                    found.push(unit);
                }
                found.len() <= MOST_BESIDE
            });
            self.beside = (piece, found);
        }
        if self.beside.1.len() > MOST_BESIDE {
            return self.is_clear_of_all(point, tame);
        }
        let place = Bounds { min: point, max: point };
        let squared = self.least * self.least;
        for k in 0..self.beside.1.len() {
            let unit = self.beside.1[k];
            if self.tree.unit(unit).contour.gap_squared(&place) < squared
                && self.work.curve(unit).is_some_and(|curve| self.is_nearer(&curve, point))
            {
                self.hint = unit;
                return false;
            }
        }
        true
    }

    /// Whether `point` is far enough from all of the contour but the units of a stretch.
    pub(super) fn is_clear_except(&mut self, point: DVec2, except: [usize; 2]) -> bool {
        !self.is_near_hint(point, except) && self.is_clear_of_all(point, except)
    }

    /// Whether the unit that was too near last is so again, as a quick look tells.
    fn is_near_hint(&self, point: DVec2, [from, to]: [usize; 2]) -> bool {
        let hint = self.hint;
        (hint < from || hint >= to)
            && self.work.curve(hint).is_some_and(|curve| self.touches(&curve, point))
    }

    fn is_clear_of_all(&mut self, point: DVec2, [from, to]: [usize; 2]) -> bool {
        let mut nearer = None;
        let clear = self.tree.near(&Bounds { min: point, max: point }, self.least, &mut |unit| {
            let near = (unit < from || unit >= to)
                && self.work.curve(unit).is_some_and(|curve| self.is_nearer(&curve, point));
            if near {
                nearer = Some(unit);
            }
            !near
        });
        self.hint = nearer.unwrap_or(self.hint);
        clear
    }

    /// Whether an end or the middle of a curve is too near: the quick look.
    fn touches(&self, curve: &MoveCurve, point: DVec2) -> bool {
        let near = |p: DVec2| p.distance_squared(point) < self.least * self.least;
        self.least > 0.0 && landmarks(curve).into_iter().any(near)
    }

    /// Whether any point of a curve is too near.
    fn is_nearer(&self, curve: &MoveCurve, point: DVec2) -> bool {
        if self.least <= 0.0 {
            return false;
        }
        match curve {
            MoveCurve::Cubic(cubic) => match side_by_chord(cubic, point, self.least) {
                Some(nearer) => nearer,
                None => curve.nearest(point).distance < self.least,
            },
            _ => curve.nearest(point).distance < self.least,
        }
    }

    /// Whether a piece of the offset runs against its span: beyond a cusp. There the distance from
    /// the contour is greatest where the tool should touch it, so every place is too near; a crossing
    /// there is none that the tool could take. Of a span that turns far it is not told.
    fn runs_back(&self, unit: usize, curve: &MoveCurve) -> bool {
        if self.work.units[unit].kind != Kind::Segment {
            return false;
        }
        match (self.work.curve(unit), curve) {
            (Some(MoveCurve::Cubic(span)), MoveCurve::Cubic(piece)) => {
                let along = span.end() - span.start();
                self.tree.unit(unit).octants.is_slender()
                    && (piece.end() - piece.start()).dot(along) < 0.0
            }
            (Some(MoveCurve::Arc(arc)), MoveCurve::Arc(piece)) => {
                (arc.start() - arc.center()).dot(piece.start() - piece.center()) < 0.0
            }
            _ => false,
        }
    }

    /// Whether all of a piece is too near, as far as a quick look tells.
    fn is_gouged(&mut self, curve: &MoveCurve, rough: f64) -> bool {
        let hull = hull(curve);
        // What is beside it is mostly cut by the same part of the contour, or by what is beside that.
        let hint = self.hint;
        for near in [hint, hint.wrapping_add(1), hint.wrapping_sub(1)] {
            if self.covers(near, &hull, rough) {
                self.hint = near;
                return true;
            }
        }
        let middle = curve.point(0.5);
        let place = Bounds { min: middle, max: middle };
        let half = hull.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
        let mut by = None;
        self.tree.near(&place, self.least - half - rough, &mut |unit| {
            if self.covers(unit, &hull, rough) {
                by = Some(unit);
            }
            by.is_none()
        });
        self.hint = by.unwrap_or(self.hint);
        by.is_some()
    }

    /// Whether a tool about one point of a unit's contour holds all of a hull and `rough` around it.
    fn covers(&self, unit: usize, hull: &[DVec2; 4], rough: f64) -> bool {
        let least = self.least - rough;
        let squared = least * least;
        let holds = |at: DVec2| hull.iter().all(|p| p.distance_squared(at) < squared);
        least > 0.0 && self.work.curve(unit).is_some_and(|c| landmarks(&c).into_iter().any(holds))
    }
}

/// Both ends and the middle of a curve.
fn landmarks(curve: &MoveCurve) -> [DVec2; 3] {
    [curve.start(), curve.point(0.5), curve.end()]
}

/// Four points whose hull holds a curve.
fn hull(curve: &MoveCurve) -> [DVec2; 4] {
    match curve {
        MoveCurve::Cubic(cubic) => cubic.points,
        MoveCurve::Line(line) => [line.start(), line.start(), line.end(), line.end()],
        MoveCurve::Arc(_) | MoveCurve::Involute(_) | MoveCurve::Vertical(_) => {
            let Bounds { min, max } = curve.bounds();
            [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)]
        }
    }
}

/// Whether a cubic is nearer to `point` than `distance`, where the distance from its chord tells:
/// the curve is no farther from the chord than its control points.
fn side_by_chord(cubic: &Cubic, point: DVec2, distance: f64) -> Option<bool> {
    let [p0, p1, p2, p3] = cubic.points;
    let from_chord = |p: DVec2| {
        let chord = p3 - p0;
        let along = (p - p0).dot(chord) / chord.length_squared();
        (p0 + chord * along.clamp(0.0, 1.0)).distance(p)
    };
    let (off, gap) = (from_chord(p1).max(from_chord(p2)), from_chord(point));
    if gap - off >= distance {
        Some(false)
    } else if gap + off < distance {
        Some(true)
    } else {
        None
    }
}

/// How near the offset of a span that heads so is made where it is going to be cut or dropped.
///
/// Where it turns but little the pieces between its cusps run back and are dropped, whatever they are.
pub(super) fn tolerances(octants: Octants, fitting: f64) -> Tolerances {
    let [roughness, tight] =
        if octants.is_slender() { [ROUGH, f64::INFINITY] } else { [0.0, fitting] };
    Tolerances { fitting, roughness, tight }
}

/// The fate of a raw piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fate {
    /// Clear all along, and crossed nowhere where that would matter.
    Clear,
    /// May be clear in parts: to be cut and examined.
    Open,
    /// Too near all along.
    Gouged,
}

/// Tells the fate of every piece.
pub(super) fn sieve(
    work: &Workpiece,
    marks: &Marks,
    clearance: &mut Clearance,
    tolerance: f64,
) -> Vec<Fate> {
    let mut fates = vec![Fate::Clear; work.pieces.len()];
    for unit in (0..work.units.len()).filter(|&unit| marks.is_suspect(unit)) {
        let pieces = work.pieces_of(unit);
        if marks.is_gouged(unit) {
            fates[pieces].fill(Fate::Gouged);
            continue;
        }
        // Beside cusps the pieces are rough.
        let mut rough = 0.0;
        if !clearance.tree.unit(unit).fits
            && let Some(MoveCurve::Cubic(cubic)) = work.curve(unit)
        {
            rough = tolerances(clearance.tree.unit(unit).octants, tolerance).beside_cusps(&cubic);
        }
        for piece in pieces {
            fates[piece] = clearance.fate(&work.pieces[piece].curve, unit, rough);
        }
    }
    fates
}
