//! Cutting the raw pieces where they cross each other or a fence.

use glam::DVec2;

use super::index::BoxTree;
use super::strands::Piece;
use crate::compensation::meet::meet;
use crate::contour::MoveCurve;

/// Crossings nearer than this are one [mm]: where two pieces follow each other a crossing is found
/// on both.
const SAME_PLACE: f64 = 1e-7;

/// Part of a piece between two cuts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arc {
    pub(super) piece: usize,
    pub(super) from: f64,
    pub(super) to: f64,
    /// The crossing at its start, if one is there.
    pub(super) start: Option<usize>,
    /// The crossing at its end, if one is there.
    pub(super) end: Option<usize>,
}

/// A cut of a piece.
#[derive(Debug, Clone, Copy)]
struct Cut {
    piece: usize,
    t: f64,
    point: DVec2,
    /// Index of the crossing, none at a fence.
    crossing: Option<usize>,
}

/// Cuts `pieces` at all crossings with each other and with `fences`; the arcs come in order.
pub(super) fn cut(pieces: &[Piece], fences: &[MoveCurve]) -> Vec<Arc> {
    let tree = BoxTree::new(pieces.iter().map(|p| p.curve.hull_bounds().inflated(SAME_PLACE)));
    let mut cuts: Vec<Cut> = Vec::new();
    let mut crossings = 0;
    for (i, piece) in pieces.iter().enumerate() {
        tree.meeting(&piece.curve.hull_bounds(), |j| {
            if j > i {
                for crossing in meet(&piece.curve, &pieces[j].curve).points() {
                    if is_shared_end(pieces, i, j, crossing.point) {
                        continue;
                    }
                    let number = Some(crossings);
                    crossings += 1;
                    let point = crossing.point;
                    cuts.push(Cut { piece: i, t: crossing.t, point, crossing: number });
                    cuts.push(Cut { piece: j, t: crossing.u, point, crossing: number });
                }
            }
            true
        });
    }
    for fence in fences {
        tree.meeting(&fence.hull_bounds(), |i| {
            for crossing in meet(&pieces[i].curve, fence).points() {
                cuts.push(Cut { piece: i, t: crossing.t, point: crossing.point, crossing: None });
            }
            true
        });
    }
    let places = merge_places(&mut cuts, crossings);
    let mut arcs = arcs(pieces, &mut cuts, &places);
    // A crossing where two pieces follow each other may be found on one of its two pieces only.
    for k in 0..arcs.len() {
        if let Some(next) = following(pieces, &arcs, k) {
            let place = arcs[k].end.or(arcs[next].start);
            (arcs[k].end, arcs[next].start) = (place, place);
        }
    }
    arcs
}

/// The arc that goes on where arc `k` ends, along the same strand.
pub(super) fn following(pieces: &[Piece], arcs: &[Arc], k: usize) -> Option<usize> {
    let next = if k + 1 < arcs.len() { k + 1 } else { 0 };
    let same = arcs[next].piece == arcs[k].piece && next > k;
    (same || pieces[arcs[k].piece].continues).then_some(next)
}

/// Whether a crossing of two pieces is only the end they share.
fn is_shared_end(pieces: &[Piece], i: usize, j: usize, point: DVec2) -> bool {
    let follows = |a: usize, b: usize| {
        pieces[a].continues
            && (b == a + 1 || (b == 0 && a == pieces.len() - 1))
            && pieces[a].curve.end().distance(point) <= SAME_PLACE
    };
    follows(i, j) || follows(j, i)
}

/// Gives crossings at the same place one number; returns the number of each crossing.
fn merge_places(cuts: &mut [Cut], crossings: usize) -> Vec<usize> {
    let mut number: Vec<usize> = (0..crossings).collect();
    cuts.sort_by(|a, b| a.point.x.total_cmp(&b.point.x));
    for i in 0..cuts.len() {
        let Some(here) = cuts[i].crossing else { continue };
        for other in &cuts[i + 1..] {
            if other.point.x - cuts[i].point.x > SAME_PLACE {
                break;
            }
            if let Some(there) = other.crossing
                && other.point.distance(cuts[i].point) <= SAME_PLACE
            {
                let (a, b) = (root(&number, here), root(&number, there));
                number[a.max(b)] = a.min(b);
            }
        }
    }
    (0..crossings).map(|k| root(&number, k)).collect()
}

fn root(number: &[usize], mut k: usize) -> usize {
    while number[k] != k {
        k = number[k];
    }
    k
}

/// The parts of every piece between its cuts.
fn arcs(pieces: &[Piece], cuts: &mut [Cut], places: &[usize]) -> Vec<Arc> {
    cuts.sort_by(|a, b| {
        (a.piece, a.t).partial_cmp(&(b.piece, b.t)).unwrap_or(std::cmp::Ordering::Equal)
    });
    let mut arcs = Vec::with_capacity(pieces.len() + cuts.len());
    let mut k = 0;
    for (index, piece) in pieces.iter().enumerate() {
        let length = piece.curve.length().max(SAME_PLACE);
        let mut arc = Arc { piece: index, from: 0.0, to: 1.0, start: None, end: None };
        while k < cuts.len() && cuts[k].piece == index {
            let cut = cuts[k];
            k += 1;
            let place = cut.crossing.map(|c| places[c]);
            // A cut on the last one adds its crossing to it.
            if (cut.t - arc.from) * length <= SAME_PLACE {
                arc.start = arc.start.or(place);
                continue;
            }
            arcs.push(Arc { to: cut.t, end: place, ..arc });
            arc = Arc { from: cut.t, start: place, ..arc };
        }
        if (1.0 - arc.from) * length > SAME_PLACE || arc.from == 0.0 {
            arcs.push(arc);
        } else if let Some(last) = arcs.last_mut().filter(|last| last.piece == index) {
            last.to = 1.0;
            last.end = last.end.or(arc.start);
        }
    }
    arcs
}
