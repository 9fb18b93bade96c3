//! Taking away dead ends: short stretches past a crossing that lead nowhere.
//!
//! Past a crossing a strand becomes too near only gradually, so a stretch there may still count as
//! clear and end where nothing goes on. Where another strand leaves the same crossing the tool is to
//! follow that; and the same at starts, the other way round. Between walls that are nearly parallel
//! and a little less than the tool apart all of a strand may count as clear.

use super::cuts::{Stretch, following};
use super::index::sort_places;
use super::units::Workpiece;

/// Removes dead ends of up to `longest` [mm], and longer ones where `reaches` says of no stretch
/// that the tool fits there exactly.
pub(super) fn remove_dead_ends(
    work: &Workpiece,
    stretches: &mut Vec<Stretch>,
    longest: f64,
    reaches: &mut dyn FnMut(&Stretch) -> bool,
) {
    let count = stretches.len();
    let mut next = vec![None; count];
    let mut previous = vec![None; count];
    let mut starts: Vec<(u32, usize)> = Vec::new();
    let mut ends: Vec<(u32, usize)> = Vec::new();
    for k in 0..count {
        next[k] = following(work, stretches, k);
        if let Some(to) = next[k] {
            previous[to] = Some(k);
        }
        starts.extend(stretches[k].start.map(|place| (place, k)));
        ends.extend(stretches[k].end.map(|place| (place, k)));
    }
    if starts.is_empty() {
        return;
    }
    sort_places(&mut starts);
    sort_places(&mut ends);
    let mut dead = vec![false; count];
    for k in 0..count {
        let stretch = &stretches[k];
        if next[k].is_none() && stretch.end.is_none() && stretch.ends_in_nothing(work) {
            let walk = Walk { stretches, work, back: &previous, here: &starts, longest };
            walk.mark(k, |s| s.start, reaches, &mut dead);
        }
        if previous[k].is_none() && stretch.start.is_none() && stretch.starts_from_nothing(work) {
            let walk = Walk { stretches, work, back: &next, here: &ends, longest };
            walk.mark(k, |s| s.end, reaches, &mut dead);
        }
        // A crossing that nothing else leaves, or that nothing else comes to, is the same.
        let alone = |list: &[(u32, usize)], place: u32| at(list, place).next().is_none();
        if next[k].is_none() && stretch.end.is_some_and(|place| alone(&starts, place)) {
            let walk = Walk { stretches, work, back: &previous, here: &starts, longest };
            walk.mark(k, |s| s.start, reaches, &mut dead);
        }
        if previous[k].is_none() && stretch.start.is_some_and(|place| alone(&ends, place)) {
            let walk = Walk { stretches, work, back: &next, here: &ends, longest };
            walk.mark(k, |s| s.end, reaches, &mut dead);
        }
    }
    let mut k = 0;
    stretches.retain(|_| {
        k += 1;
        !dead[k - 1]
    });
}

impl Stretch {
    /// Whether it ends where neither its contour nor, at a fence, the room for the tool does.
    pub(super) fn ends_in_nothing(&self, work: &Workpiece) -> bool {
        self.to == 1.0 && {
            let unit = work.pieces[self.piece].unit as usize;
            let range = work.range_of(unit);
            range.closed || work.pieces_of_range(range).end != self.piece + 1
        }
    }

    /// The same for its start.
    pub(super) fn starts_from_nothing(&self, work: &Workpiece) -> bool {
        self.from == 0.0 && {
            let unit = work.pieces[self.piece].unit as usize;
            let range = work.range_of(unit);
            range.closed || work.pieces_of_range(range).start != self.piece
        }
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
    /// For each stretch the one behind it, seen from the dead end.
    back: &'a [Option<usize>],
    /// What else begins at the crossings that the walk comes to.
    here: &'a [(u32, usize)],
    longest: f64,
}

impl Walk<'_> {
    /// Marks what leads from the nearest crossing with another way to the dead end at stretch `k`.
    fn mark(
        &self,
        mut k: usize,
        place: impl Fn(&Stretch) -> Option<u32>,
        reaches: &mut dyn FnMut(&Stretch) -> bool,
        dead: &mut [bool],
    ) {
        let first = k;
        let mut length = 0.0;
        // The farthest one asked about.
        let mut asked = None;
        loop {
            let stretch = &self.stretches[k];
            let curve = &self.work.pieces[stretch.piece].curve;
            length += curve.length() * (stretch.to - stretch.from);
            if dead[k] {
                return;
            }
            while length > self.longest && asked != Some(k) {
                asked = asked.map_or(Some(first), |k| self.back[k]);
                if asked.is_none_or(|k| reaches(&self.stretches[k])) {
                    return;
                }
            }
            let another = |other: usize| other != k && !dead[other];
            if place(stretch).is_some_and(|place| at(self.here, place).any(another)) {
                break;
            }
            let Some(behind) = self.back[k].filter(|&behind| behind != first) else { return };
            k = behind;
        }
        let mut end = first;
        dead[end] = true;
        while end != k
            && let Some(behind) = self.back[end]
        {
            end = behind;
            dead[end] = true;
        }
    }
}
