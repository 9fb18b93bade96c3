//! Stringing the stretches that the tool can follow together, in program order.
//!
//! Where a strand becomes too near to the contour it crosses another one that comes out clear
//! there: the tool changes over. So every end of a clear stretch is the start of another, and the
//! stretches close up to loops, or to one path from the start to the end of an open contour.

use super::cuts::{Stretch, following};
use super::units::Workpiece;
use crate::geometry::sort_long;

/// Stretches that follow each other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    /// Indices of the stretches, in order.
    pub(super) stretches: Vec<usize>,
    /// Whether the last leads back to the first.
    pub(super) closed: bool,
}

/// Nothing follows.
const NONE: usize = usize::MAX;

/// The chains of clear `stretches`, ordered by where they begin.
pub(super) fn chains(work: &Workpiece, stretches: &[Stretch]) -> Vec<Chain> {
    let (next, has_previous) = links(work, stretches);
    let mut used = vec![false; stretches.len()];
    let mut chains = Vec::new();
    // Open chains from their starts; what is left are loops.
    for open in [true, false] {
        for first in 0..stretches.len() {
            if used[first] || open && has_previous[first] {
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
    }
    sort_long(&mut chains, |a, b| a.stretches[0] < b.stretches[0]);
    chains
}

/// For each stretch the one that follows it, and whether it follows one.
fn links(work: &Workpiece, stretches: &[Stretch]) -> (Vec<usize>, Vec<bool>) {
    let mut next: Vec<usize> =
        (0..stretches.len()).map(|k| following(work, stretches, k).unwrap_or(NONE)).collect();
    let mut has_previous = vec![false; stretches.len()];
    for &to in next.iter().filter(|&&to| to != NONE) {
        has_previous[to] = true;
    }
    // What starts at a crossing without following anything, by its crossing.
    let mut starting: Vec<(u32, usize)> = Vec::new();
    for (k, stretch) in stretches.iter().enumerate() {
        if let Some(place) = stretch.start.filter(|_| !has_previous[k]) {
            starting.push((place, k));
        }
    }
    sort_long(&mut starting, |a, b| a < b);
    for k in 0..stretches.len() {
        if let Some(place) = stretches[k].end.filter(|_| next[k] == NONE) {
            let from = starting.partition_point(|&(at, _)| at < place);
            let mut here = starting[from..].iter().take_while(|&&(at, _)| at == place);
            if let Some(&(_, to)) = here.find(|&&(_, to)| !has_previous[to]) {
                has_previous[to] = true;
                next[k] = to;
            }
        }
    }
    (next, has_previous)
}
