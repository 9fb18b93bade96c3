//! Stringing the stretches that the tool can follow together, in program order.
//!
//! Where a strand becomes too near to the contour it crosses another one that comes out clear
//! there: the tool changes over. So every end of a clear stretch is the start of another, and the
//! stretches close up to loops, or to one path from the start to the end of an open contour.

use glam::DVec2;

use super::Whole;
use super::cuts::{Stretch, following, sort_along};
use super::dead_ends::keep_alive;
use super::sieve::{Clearance, Fate};
use super::units::Workpiece;
use crate::geometry::sort_pairs;

/// Stretches that follow each other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    /// Indices of the stretches, in order.
    pub(super) stretches: Vec<usize>,
    /// Whether the last leads back to the first.
    pub(super) closed: bool,
}

/// Nothing follows, or comes before.
pub(super) const NONE: usize = usize::MAX;

/// The chains of clear `stretches`, ordered by where they begin; gaps of up to `gap` [mm] are none.
pub(super) fn chains(
    work: &Workpiece,
    stretches: &[Stretch],
    gap: f64,
    clearance: &mut Clearance,
) -> Vec<Chain> {
    let (next, previous) = links(work, stretches, gap, clearance);
    // Open chains lead on from their starts; what is left are loops.
    let mut is_looped = vec![true; stretches.len()];
    for (first, &before) in previous.iter().enumerate() {
        let mut last = if before == NONE { first } else { NONE };
        while last != NONE && is_looped[last] {
            is_looped[last] = false;
            last = next[last];
        }
    }
    let mut used = vec![false; stretches.len()];
    let mut chains = Vec::new();
    for first in 0..stretches.len() {
        if used[first] || previous[first] != NONE && !is_looped[first] {
            continue;
        }
        let mut chain = Chain { stretches: Vec::new(), closed: false };
        let mut last = first;
        while last != NONE && !used[last] {
            used[last] = true;
            chain.stretches.push(last);
            last = next[last];
        }
        chain.closed = last == first;
        chains.push(chain);
    }
    chains
}

/// The chain of each contour where all pieces are clear and follow each other: nothing is cut then, and
/// there is nothing to look for.
pub(super) fn whole_chains(work: &Workpiece, fates: &[Fate]) -> Option<Vec<Chain>> {
    if !fates.iter().all(|fate| *fate == Fate::Clear) {
        return None;
    }
    let mut chains = Vec::with_capacity(work.ranges.len());
    for range in &work.ranges {
        let stretches: Vec<usize> = work.pieces_of_range(*range).collect();
        let (&first, &last) = (stretches.first()?, stretches.last()?);
        let next = |k: usize| work.pieces[k].next as usize;
        let is_whole =
            (first..last).all(|k| next(k) == k + 1) && (!range.closed || next(last) == first);
        if !is_whole {
            return None;
        }
        chains.push(Chain { stretches, closed: range.closed });
    }
    Some(chains)
}

/// Removes the stretches of open chains where the tool fits exactly nowhere, of which `reaches`
/// tells: between walls that are a little less than the tool apart, and lead nowhere. So it does with
/// those of up to `stray` [mm] of which both ends got lost. Returns whether there were any.
pub(super) fn remove_unreached(
    work: &Workpiece,
    stretches: &mut Vec<Stretch>,
    chains: &[Chain],
    stray: f64,
    whole: &Whole,
    reaches: &mut dyn FnMut(&Stretch) -> bool,
) -> bool {
    let mut dead = Vec::new();
    for chain in chains {
        let list = &chain.stretches;
        let length = |&k: &usize| {
            let Stretch { piece, from, to, .. } = stretches[k];
            work.pieces[piece].curve.length() * (to - from)
        };
        let is_stray = lost_ends(work, stretches, chain, whole).len() == 2
            && list.iter().map(length).sum::<f64>() <= stray;
        if !chain.closed && (is_stray || !list.iter().any(|&k| reaches(&stretches[k]))) {
            dead.resize(stretches.len(), false);
            for &k in list {
                dead[k] = true;
            }
        }
    }
    if dead.is_empty() {
        return false;
    }
    keep_alive(stretches, &dead);
    true
}

/// Which ends of a chain [mm] are neither an end of an open contour nor where the other side or the
/// free end of one stands in the way; nothing can be there but where a closed contour crosses
/// itself.
pub(super) fn lost_ends(
    work: &Workpiece,
    stretches: &[Stretch],
    chain: &Chain,
    whole: &Whole,
) -> Vec<DVec2> {
    let list = &chain.stretches;
    let mut lost = Vec::new();
    for at_end in [false, true] {
        let stretch = &stretches[list[if at_end { list.len() - 1 } else { 0 }]];
        let piece = &work.pieces[stretch.piece];
        let (t, place) = stretch.at(at_end);
        let is_closed = whole.closed || work.range_of(piece.unit as usize).closed;
        let is_lost = place.is_some()
            || stretch.is_cut(at_end) && is_closed
            || stretch.is_loose(work, at_end);
        if !chain.closed
            && is_lost
            && (whole.counts)(work.segment(piece.unit as usize).attributes.origin)
        {
            lost.push(piece.curve.point(t));
        }
    }
    lost
}

/// For each stretch the one that goes on along the same contour where it ends, and the one that it goes on
/// from; [`NONE`] where there is none.
pub(super) fn neighbours(work: &Workpiece, stretches: &[Stretch]) -> (Vec<usize>, Vec<usize>) {
    let mut next = vec![NONE; stretches.len()];
    let mut previous = vec![NONE; stretches.len()];
    for (k, next) in next.iter_mut().enumerate() {
        if let Some(to) = following(work, stretches, k) {
            (*next, previous[to]) = (to, k);
        }
    }
    (next, previous)
}

/// For each stretch the one that follows it, and the one that it follows.
fn links(
    work: &Workpiece,
    stretches: &[Stretch],
    gap: f64,
    clearance: &mut Clearance,
) -> (Vec<usize>, Vec<usize>) {
    let (mut next, mut previous) = neighbours(work, stretches);
    // What starts at a crossing without following anything, by its crossing.
    let mut starting: Vec<(u32, usize)> = Vec::new();
    for (k, stretch) in stretches.iter().enumerate() {
        if let Some(place) = stretch.start.filter(|_| previous[k] == NONE) {
            starting.push((place, k));
        }
    }
    sort_pairs(&mut starting);
    for k in 0..stretches.len() {
        if let Some(place) = stretches[k].end.filter(|_| next[k] == NONE) {
            let from = starting.partition_point(|&(at, _)| at < place);
            let mut here = starting[from..].iter().take_while(|&&(at, _)| at == place);
            if let Some(&(_, to)) = here.find(|&&(_, to)| previous[to] == NONE) {
                (next[k], previous[to]) = (to, k);
            }
        }
    }
    bridge(work, stretches, gap, clearance, &mut next, &mut previous);
    (next, previous)
}

/// Links ends to starts that are no farther than `gap` [mm] from them, where the way there is clear
/// but for a part of the tolerance: where a loop is too small, or two paths cross at too small an
/// angle, for the crossing to be told.
fn bridge(
    work: &Workpiece,
    stretches: &[Stretch],
    gap: f64,
    clearance: &mut Clearance,
    next: &mut [usize],
    previous: &mut [usize],
) {
    let point = |k: usize, t: f64| work.pieces[stretches[k].piece].curve.point(t);
    let mut starting: Vec<(f64, usize)> = Vec::new();
    for (k, stretch) in stretches.iter().enumerate() {
        if previous[k] == NONE && (stretch.is_cut(false) || stretch.is_loose(work, false)) {
            starting.push((point(k, stretch.from).x, k));
        }
    }
    sort_along(&mut starting);
    for (k, stretch) in stretches.iter().enumerate() {
        if next[k] != NONE || !(stretch.is_cut(true) || stretch.is_loose(work, true)) {
            continue;
        }
        let end = point(k, stretch.to);
        let from = starting.partition_point(|&(x, _)| x < end.x - gap);
        let mut nearest = (gap, NONE);
        for &(_, to) in starting[from..].iter().take_while(|&&(x, _)| x <= end.x + gap) {
            let start = point(to, stretches[to].from);
            let off = start.distance(end);
            let mut is_clear = || {
                let place = |k: u32| end.lerp(start, 0.25 * f64::from(k));
                (0..=4).all(|k| clearance.is_clear_except(place(k), [0, 0]))
            };
            if off <= nearest.0 && previous[to] == NONE && to != k && is_clear() {
                nearest = (off, to);
            }
        }
        if nearest.1 != NONE {
            (next[k], previous[nearest.1]) = (nearest.1, k);
        }
    }
}
