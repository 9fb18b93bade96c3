//! Taking away dead ends: short stretches past a crossing that lead nowhere.
//!
//! Past a crossing a strand becomes too near only gradually, so a stretch there may still count as
//! clear and end where nothing goes on. Where another strand leaves the same crossing the tool is to
//! follow that; and the same at starts, the other way round. Between walls that are nearly parallel
//! and a little less than the tool apart all of a strand may count as clear.

use super::chains::{NONE, neighbours};
use super::cuts::Stretch;
use super::units::Workpiece;
use crate::geometry::sort_pairs;

/// Removes dead ends of up to `longest` [mm], and longer ones where `reaches` says of no stretch
/// that the tool fits there exactly.
pub(super) fn remove_dead_ends(
    work: &Workpiece,
    stretches: &mut Vec<Stretch>,
    longest: f64,
    reaches: &mut dyn FnMut(&Stretch) -> bool,
) {
    if stretches.iter().all(|stretch| stretch.start.is_none()) {
        return;
    }
    let count = stretches.len();
    let (next, previous) = neighbours(work, stretches);
    let mut starts: Vec<(u32, usize)> = Vec::new();
    let mut ends: Vec<(u32, usize)> = Vec::new();
    for (k, stretch) in stretches.iter().enumerate() {
        starts.extend(stretch.start.map(|place| (place, k)));
        ends.extend(stretch.end.map(|place| (place, k)));
    }
    sort_pairs(&mut starts);
    sort_pairs(&mut ends);
    let mut dead = vec![false; count];
    for k in 0..count {
        for at_end in [true, false] {
            let (ahead, back, here) =
                if at_end { (&next, &previous, &starts) } else { (&previous, &next, &ends) };
            let is_dead_end = ahead[k] == NONE
                && match stretches[k].at(at_end).1 {
                    // A crossing that nothing else leaves, or that nothing else comes to.
                    Some(place) => at(here, place).next().is_none(),
                    None => stretches[k].is_loose(work, at_end),
                };
            if is_dead_end {
                let walk = Walk { stretches, work, back, here, longest, to_end: !at_end };
                walk.mark(k, reaches, &mut dead);
            }
        }
    }
    keep_alive(stretches, &dead);
}

/// Removes the stretches that are dead.
#[inline(never)]
pub(super) fn keep_alive(stretches: &mut Vec<Stretch>, dead: &[bool]) {
    let mut k = 0;
    stretches.retain(|_| {
        k += 1;
        !dead[k - 1]
    });
}

impl Stretch {
    /// The parameter at its start or end, and the crossing there.
    pub(super) fn at(&self, at_end: bool) -> (f64, Option<u32>) {
        if at_end { (self.to, self.end) } else { (self.from, self.start) }
    }

    /// Whether it starts or ends where its piece does not.
    pub(super) fn is_cut(&self, at_end: bool) -> bool {
        if at_end { self.to < 1.0 } else { self.from > 0.0 }
    }

    /// Whether it starts or ends where neither its contour nor, at a fence, the room for the tool does.
    #[inline(never)]
    pub(super) fn is_loose(&self, work: &Workpiece, at_end: bool) -> bool {
        let range = work.range_of(work.pieces[self.piece].unit as usize);
        let pieces = work.pieces_of_range(range);
        let outermost = if at_end { pieces.end - 1 } else { pieces.start };
        !self.is_cut(at_end) && (range.closed || outermost != self.piece)
    }
}

/// The entries of a sorted list for a place.
fn at(list: &[(u32, usize)], place: u32) -> impl Iterator<Item = usize> {
    let from = list.partition_point(|&(p, _)| p < place);
    list[from..].iter().take_while(move |&&(p, _)| p == place).map(|&(_, k)| k)
}

/// A walk back from a dead end.
struct Walk<'a> {
    stretches: &'a [Stretch],
    work: &'a Workpiece<'a>,
    /// For each stretch the one behind it, seen from the dead end; [`NONE`] where there is none.
    back: &'a [usize],
    /// What else begins at the crossings that the walk comes to.
    here: &'a [(u32, usize)],
    longest: f64,
    /// Whether it comes to the ends of stretches: the dead end is a start.
    to_end: bool,
}

impl Walk<'_> {
    /// Marks what leads from the nearest crossing with another way to the dead end at stretch `k`.
    #[inline(never)]
    fn mark(&self, mut k: usize, reaches: &mut dyn FnMut(&Stretch) -> bool, dead: &mut [bool]) {
        let first = k;
        let mut length = 0.0;
        // The farthest one asked about.
        let mut asked = NONE;
        loop {
            let stretch = &self.stretches[k];
            let curve = &self.work.pieces[stretch.piece].curve;
            length += curve.length() * (stretch.to - stretch.from);
            if dead[k] {
                return;
            }
            while length > self.longest && asked != k {
                asked = if asked == NONE { first } else { self.back[asked] };
                if asked == NONE || reaches(&self.stretches[asked]) {
                    return;
                }
            }
            let another = |other: usize| other != k && !dead[other];
            if stretch.at(self.to_end).1.is_some_and(|place| at(self.here, place).any(another)) {
                break;
            }
            k = self.back[k];
            if k == NONE || k == first {
                return;
            }
        }
        let mut end = first;
        dead[end] = true;
        while end != k {
            end = self.back[end];
            dead[end] = true;
        }
    }
}
