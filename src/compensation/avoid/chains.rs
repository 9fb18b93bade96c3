//! Stringing the arcs that the tool can follow together, in program order.
//!
//! Where a strand becomes too near to the contour it crosses another one that comes out clear
//! there: the tool changes over. So every end of a clear stretch is the start of another, and the
//! stretches close up to loops, or to one path from the start to the end of an open contour.

use super::cuts::{Arc, following};
use super::strands::Piece;

/// Arcs that follow each other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    /// Indices of the arcs, in order.
    pub(super) arcs: Vec<usize>,
    /// Whether the last leads back to the first.
    pub(super) closed: bool,
}

/// The chains of the arcs that are `clear`, ordered by their first arc.
pub(super) fn chains(pieces: &[Piece], arcs: &[Arc], clear: &[bool]) -> Vec<Chain> {
    let mut starting: Vec<Vec<usize>> = Vec::new();
    for (k, arc) in arcs.iter().enumerate() {
        if let Some(place) = arc.start {
            if starting.len() <= place {
                starting.resize(place + 1, Vec::new());
            }
            starting[place].push(k);
        }
    }
    let successor = |k: usize, used: &[bool], first: usize| {
        let free = |&n: &usize| clear[n] && (!used[n] || n == first);
        let along = following(pieces, arcs, k).filter(free);
        along.or_else(|| {
            let place = arcs[k].end?;
            starting.get(place)?.iter().copied().find(free)
        })
    };
    let mut used = vec![false; arcs.len()];
    let mut chains: Vec<Chain> = Vec::new();
    for first in 0..arcs.len() {
        if !clear[first] || used[first] {
            continue;
        }
        let mut chain = Chain { arcs: vec![first], closed: false };
        used[first] = true;
        let mut last = first;
        while let Some(next) = successor(last, &used, first) {
            if next == first {
                chain.closed = true;
                break;
            }
            used[next] = true;
            chain.arcs.push(next);
            last = next;
        }
        // A chain begun in its middle is completed by the one that leads to it.
        let continued = chains.iter().position(|later| {
            !chain.closed && !later.closed && leads_to(pieces, arcs, last, later.arcs[0])
        });
        match continued {
            Some(index) => {
                let rest = chains.remove(index);
                chain.arcs.extend(rest.arcs);
                chain.closed = leads_to(pieces, arcs, chain.arcs[chain.arcs.len() - 1], first);
                chains.insert(index, chain);
            }
            None => chains.push(chain),
        }
    }
    chains
}

/// Whether arc `b` can follow arc `a`.
fn leads_to(pieces: &[Piece], arcs: &[Arc], a: usize, b: usize) -> bool {
    following(pieces, arcs, a) == Some(b) || (arcs[a].end.is_some() && arcs[a].end == arcs[b].start)
}
