//! Cutting the raw pieces that need it where they cross each other or a fence.

use glam::DVec2;

use super::fences::each_fence;
use super::sieve::{Clearance, Fate};
use super::tree::OrderTree;
use super::units::{Workpiece, index};
use crate::compensation::meet::meet;
use crate::contour::MoveCurve;
use crate::geometry::{BoxTree, sort_long};

/// Crossings nearer than this are one [mm]: where two pieces follow each other a crossing is found
/// on both.
pub(super) const SAME_PLACE: f64 = 1e-7;

/// A direction of length one, along which few places of programs lie beside each other: many do along
/// the axes.
const ASKEW: DVec2 = DVec2::new(0.540_302_305_868_139_8, 0.841_470_984_807_896_5);

/// What is so near as to have the same neighbours, as a part of that distance.
const NO_WAY: f64 = 1e-3;

/// Places examined on a stretch between two cuts beside its middle, to both sides of it from there.
/// The first ones are left out where it is shorter than the radius, and all on a short one that is not
/// cut at all, since its neighbours are examined too.
const EXAMINED: [[f64; 2]; 2] = [[0.25, 0.02], [0.75, 0.98]];

/// Halvings of a part of a stretch until a place is known to a millionth of it.
const HALVINGS: u32 = 20;

/// What counts as short, as a part of the tool radius.
const SHORT: f64 = 0.05;

/// A piece of raw path between two cuts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub(super) piece: usize,
    pub(super) from: f64,
    pub(super) to: f64,
    /// The crossing at its start, if one is there.
    pub(super) start: Option<u32>,
    /// The crossing at its end, if one is there.
    pub(super) end: Option<u32>,
}

impl Stretch {
    /// All of a piece.
    pub(super) fn whole(piece: usize) -> Self {
        Self { piece, from: 0.0, to: 1.0, start: None, end: None }
    }

    /// Appends its clear part.
    ///
    /// Mostly it is clear all along or nowhere. Where paths touch, or cross at no angle to speak of,
    /// a cut may be missing: the place between two of those examined is found by halving, and numbered
    /// as a crossing of its own. Beside a cut everything may count as clear, so the middle decides.
    fn examine(
        self,
        is_long: bool,
        is_clear: &mut dyn FnMut(f64) -> bool,
        flips: &mut u32,
        parts: &mut Vec<Self>,
    ) {
        let at = |k: f64| self.from + (self.to - self.from) * k;
        let middle = at(0.5);
        if !is_clear(middle) {
            return;
        }
        let mut part = self;
        for (side, places) in EXAMINED.iter().enumerate() {
            let mut clear = middle;
            for &k in &places[usize::from(!is_long)..] {
                let gouged = at(k);
                if is_clear(gouged) {
                    clear = gouged;
                    continue;
                }
                part.shorten(side > 0, [clear, gouged], is_clear, flips);
                break;
            }
        }
        parts.push(part);
    }

    /// Lets it end, or start, between a clear place and one that is gouged.
    #[inline(never)]
    fn shorten(
        &mut self,
        at_end: bool,
        [mut clear, mut gouged]: [f64; 2],
        is_clear: &mut dyn FnMut(f64) -> bool,
        flips: &mut u32,
    ) {
        for _ in 0..HALVINGS {
            let between = 0.5 * (clear + gouged);
            *(if is_clear(between) { &mut clear } else { &mut gouged }) = between;
        }
        if at_end {
            (self.to, self.end) = (clear, Some(*flips));
        } else {
            (self.from, self.start) = (clear, Some(*flips));
        }
        *flips += 1;
    }
}

/// A cut of a piece.
#[derive(Debug, Clone, Copy)]
struct Cut {
    piece: usize,
    t: f64,
    point: DVec2,
    /// Index of the crossing, none at a fence.
    crossing: Option<u32>,
}

/// What is asked of the whole workpiece.
pub(super) struct Survey<'a> {
    pub(super) work: &'a Workpiece<'a>,
    pub(super) tree: &'a OrderTree,
    pub(super) fates: &'a [Fate],
    /// Radius of the tool [mm].
    pub(super) radius: f64,
    /// What the offsets of splines may be off [mm].
    pub(super) tolerance: f64,
}

impl Survey<'_> {
    /// The stretches of the raw path that the tool can take, in order.
    pub(super) fn clear_stretches(&self, clearance: &mut Clearance) -> Vec<Stretch> {
        let (mut cuts, crossings) = self.cuts(clearance);
        let places = merge_places(&cuts, crossings);
        let mut stretches = self.stretches(&mut cuts, &places);
        // A crossing where two pieces follow each other may be found on one of the two only.
        for k in 0..stretches.len() {
            if (stretches[k].end.is_some()
                || stretches.get(k + 1).is_none_or(|s| s.start.is_some()))
                && let Some(next) = following(self.work, &stretches, k)
            {
                let place = stretches[k].end.or(stretches[next].start);
                (stretches[k].end, stretches[next].start) = (place, place);
            }
        }
        if !self.fates.contains(&Fate::Open) {
            return stretches;
        }
        let mut kept = Vec::with_capacity(stretches.len());
        let mut short = Vec::new();
        let mut flips = crossings;
        for stretch in stretches {
            if self.fates[stretch.piece] == Fate::Clear {
                kept.push(stretch);
                continue;
            }
            let curve = &self.work.pieces[stretch.piece].curve;
            let mut is_clear = |t: f64| clearance.is_clear_on(stretch.piece, t);
            let whole = stretch.from == 0.0 && stretch.to == 1.0;
            let size = curve.hull_bounds().size().max_element();
            if whole && size <= SHORT * self.radius {
                if is_clear(0.5) {
                    short.push(kept.len());
                    kept.push(stretch);
                }
            } else {
                let is_long = size > self.radius;
                stretch.examine(is_long, &mut is_clear, &mut flips, &mut kept);
            }
        }
        self.shorten_loose(&mut kept, &short, clearance, &mut flips);
        kept
    }

    /// Lets short stretches, of which the middle alone was examined, end where they become too near
    /// if nothing goes on there.
    fn shorten_loose(
        &self,
        stretches: &mut [Stretch],
        short: &[usize],
        clearance: &mut Clearance,
        flips: &mut u32,
    ) {
        for &k in short {
            let Stretch { piece, start, end, .. } = stretches[k];
            let mut is_clear = |t: f64| clearance.is_clear_on(piece, t);
            let goes_on = |k: usize| following(self.work, stretches, k).is_some();
            // What leads to the start of a contour, if anything does, lies at its end.
            let is_led = start.is_some() || k == 0 || goes_on(k - 1);
            let is_over = end.is_none() && !goes_on(k);
            if !is_led && !is_clear(0.0) {
                stretches[k].shorten(false, [0.5, 0.0], &mut is_clear, flips);
            }
            if is_over && !is_clear(1.0) {
                stretches[k].shorten(true, [0.5, 1.0], &mut is_clear, flips);
            }
        }
    }

    /// All cuts, and the number of crossings.
    fn cuts(&self, clearance: &mut Clearance) -> (Vec<Cut>, u32) {
        let pieces = &self.work.pieces;
        let (mut open, mut boxes) = (Vec::new(), Vec::new());
        for (i, piece) in pieces.iter().enumerate() {
            if self.fates[i] == Fate::Open {
                open.push(i);
                boxes.push(piece.curve.hull_bounds().inflated(SAME_PLACE));
            }
        }
        let tree = BoxTree::new(boxes);
        let mut cuts: Vec<Cut> = Vec::new();
        let mut crossings = 0;
        for &i in &open {
            let a = &pieces[i];
            let [from, to] = clearance.tame(a.unit as usize);
            tree.meeting(&a.curve.hull_bounds(), &mut |j| {
                let j = open[j];
                let b = &pieces[j];
                // Paths along one tame stretch do not cross.
                if j <= i || (from..to).contains(&(b.unit as usize)) || self.goes_on(i, j) {
                    return true;
                }
                for crossing in meet(&a.curve, &b.curve).points() {
                    if self.is_shared_end(i, j, crossing.point) {
                        continue;
                    }
                    let number = Some(crossings);
                    crossings += 1;
                    let point = crossing.point;
                    cuts.push(Cut { piece: i, t: crossing.t, point, crossing: number });
                    cuts.push(Cut { piece: j, t: crossing.u, point, crossing: number });
                }
                true
            });
        }
        if !open.is_empty() {
            let Self { work, tolerance, .. } = *self;
            each_fence(work, self.tree, &tree, tolerance, &mut |fence| {
                tree.meeting(&fence.hull_bounds(), &mut |i| {
                    let piece = open[i];
                    for crossing in meet(&pieces[piece].curve, fence).points() {
                        let (t, point) = (crossing.t, crossing.point);
                        cuts.push(Cut { piece, t, point, crossing: None });
                    }
                    true
                });
            });
        }
        (cuts, crossings)
    }

    /// Whether a crossing of two pieces is only the end they share.
    fn is_shared_end(&self, i: usize, j: usize, point: DVec2) -> bool {
        let follows = |a: usize, b: usize| {
            let piece = &self.work.pieces[a];
            piece.next as usize == b && piece.curve.end().distance(point) <= SAME_PLACE
        };
        follows(i, j) || follows(j, i)
    }

    /// Whether one of two pieces goes on where the other ends, with nothing of it beside that: no two
    /// cubics are dearer to cross than those that touch at an end.
    fn goes_on(&self, i: usize, j: usize) -> bool {
        let pieces = &self.work.pieces;
        let (a, b) = match [i, j].map(|k| pieces[k].next as usize) {
            [next, _] if next == j => (i, j),
            [_, next] if next == i => (j, i),
            _ => return false,
        };
        let (MoveCurve::Cubic(a), MoveCurve::Cubic(b)) = (&pieces[a].curve, &pieces[b].curve)
        else {
            return false;
        };
        let (place, along) = (b.start(), b.points[1] - b.start());
        let ahead = |p: &DVec2| (*p - place).dot(along);
        a.points[..3].iter().all(|p| ahead(p) < 0.0)
            && ahead(&a.end()) <= 0.0
            && b.points[1..].iter().all(|p| ahead(p) > 0.0)
    }

    /// The parts of every piece between its cuts, but for those that are too near all along.
    fn stretches(&self, cuts: &mut [Cut], places: &[u32]) -> Vec<Stretch> {
        sort_by_piece(cuts);
        let mut stretches = Vec::with_capacity(self.work.pieces.len() + cuts.len());
        let mut k = 0;
        for (index, fate) in self.fates.iter().enumerate() {
            let mut stretch = Stretch::whole(index);
            match fate {
                Fate::Gouged => continue,
                Fate::Clear => {
                    stretches.push(stretch);
                    continue;
                }
                Fate::Open => {}
            }
            if cuts.get(k).is_none_or(|cut| cut.piece != index) {
                stretches.push(stretch);
                continue;
            }
            let length = self.work.pieces[index].curve.length().max(SAME_PLACE);
            while k < cuts.len() && cuts[k].piece == index {
                let cut = cuts[k];
                k += 1;
                let place = cut.crossing.map(|c| places[c as usize]);
                // A cut on the last one adds its crossing to it.
                if (cut.t - stretch.from) * length <= SAME_PLACE {
                    stretch.start = stretch.start.or(place);
                    continue;
                }
                stretches.push(Stretch { to: cut.t, end: place, ..stretch });
                stretch = Stretch { from: cut.t, start: place, ..stretch };
            }
            if (1.0 - stretch.from) * length > SAME_PLACE || stretch.from == 0.0 {
                stretches.push(stretch);
            } else if let Some(last) = stretches.last_mut().filter(|last| last.piece == index) {
                last.to = 1.0;
                last.end = last.end.or(stretch.start);
            }
        }
        stretches
    }
}

/// The stretch that goes on where stretch `k` ends, along the same contour.
pub(super) fn following(work: &Workpiece, stretches: &[Stretch], k: usize) -> Option<usize> {
    let this = &stretches[k];
    let ahead = stretches.get(k + 1);
    if this.to < 1.0 {
        return ahead.filter(|s| s.piece == this.piece && s.from == this.to).map(|_| k + 1);
    }
    let next = work.pieces[this.piece].next as usize;
    if next > this.piece {
        // The very next, unless there is none.
        return ahead.filter(|s| s.piece == next && s.from == 0.0).map(|_| k + 1);
    }
    // The end of a closed contour goes on at its start.
    let first = stretches.partition_point(|stretch| stretch.piece < next);
    stretches.get(first).filter(|s| s.piece == next && s.from == 0.0).map(|_| first)
}

/// Sorts cuts by piece and parameter; there may be very many.
fn sort_by_piece(cuts: &mut [Cut]) {
    sort_long(cuts, |a, b| (a.piece, a.t) < (b.piece, b.t));
}

/// Sorts indices by how far each is along something.
#[inline(never)]
pub(super) fn sort_along(list: &mut [(f64, usize)]) {
    sort_long(list, |a, b| a.0 < b.0);
}

/// Gives crossings at the same place one number; returns the number of each crossing.
fn merge_places(cuts: &[Cut], crossings: u32) -> Vec<u32> {
    let mut number: Vec<usize> = (0..crossings as usize).collect();
    let mut places = Vec::with_capacity(number.len());
    let mut order = Vec::with_capacity(number.len());
    for cut in cuts {
        // Each is on two pieces.
        if cut.crossing.is_some_and(|crossing| places.len() == crossing as usize) {
            order.push((cut.point.dot(ASKEW), places.len()));
            places.push(cut.point);
        }
    }
    sort_along(&mut order);
    for (i, &(along, here)) in order.iter().enumerate() {
        for &(other_along, there) in &order[i + 1..] {
            if other_along - along > SAME_PLACE {
                break;
            }
            let off = places[there].distance(places[here]);
            if off <= SAME_PLACE {
                let (a, b) = (root(&mut number, here), root(&mut number, there));
                number[a.max(b)] = a.min(b);
            }
            // What else is near to this one is near to that too.
            if off <= NO_WAY * SAME_PLACE {
                break;
            }
        }
    }
    (0..places.len()).map(|k| index(root(&mut number, k))).collect()
}

fn root(number: &mut [usize], mut k: usize) -> usize {
    while number[k] != k {
        // Halves the way for those who ask later.
        number[k] = number[number[k]];
        k = number[k];
    }
    k
}
