//! The vertices of many blocks in one piece of memory: each block owns a slot with room to spare.
//!
//! Where a block needs more room than its slot has, the slots after it close up until there is
//! enough; so a change moves few vertices, however many there are. What a slot does not use repeats
//! its last vertex, so that the vertices of all slots are one polyline.

use std::ops::Range;

use glam::DVec2;

/// Vertices that a slot has beyond those it needs at first.
const SPARE: usize = 4;

/// A block's own vertices.
#[derive(Debug, Clone, Copy)]
struct Slot {
    /// Index of the first.
    at: usize,
    /// How many there are.
    room: usize,
    /// How many are not repeated ones.
    used: usize,
}

impl Slot {
    fn end(&self) -> usize {
        self.at + self.room
    }
}

/// Vertices in slots that adjoin each other.
#[derive(Debug, Clone, Default)]
pub(super) struct Slots {
    /// x and y of each vertex [mm].
    points: Vec<f64>,
    list: Vec<Slot>,
    /// Vertices that have changed since they were last asked for.
    changed: Range<usize>,
}

impl Slots {
    /// Forgets all slots.
    pub(super) fn clear(&mut self) {
        self.points.clear();
        self.list.clear();
        self.changed = 0..0;
    }

    /// x and y of each vertex [mm].
    pub(super) fn points(&self) -> &[f64] {
        &self.points
    }

    /// The vertices that have changed since `take_changed`.
    pub(super) fn changed(&self) -> Range<usize> {
        self.changed.clone()
    }

    /// Index of the first vertex of a slot.
    pub(super) fn start(&self, slot: usize) -> usize {
        self.list[slot].at
    }

    /// The slot that a vertex is in.
    pub(super) fn slot_of(&self, vertex: usize) -> usize {
        self.list.partition_point(|slot| slot.end() <= vertex)
    }

    /// The vertices that have changed since this was last asked.
    pub(super) fn take_changed(&mut self) -> Range<usize> {
        std::mem::take(&mut self.changed)
    }

    /// Adds a slot behind the last with room for some more vertices than these.
    pub(super) fn push(&mut self, vertices: &[DVec2]) {
        let (at, used) = (self.points.len() / 2, vertices.len());
        let room = used + used / 4 + SPARE;
        self.list.push(Slot { at, room, used: 0 });
        self.points.resize(2 * (at + room), 0.0);
        self.put(self.list.len() - 1, vertices);
    }

    /// Fills a slot with vertices, of which there is at least one.
    pub(super) fn put(&mut self, slot: usize, vertices: &[DVec2]) {
        if vertices.len() > self.list[slot].room {
            self.widen(slot, vertices.len() + vertices.len() / 8);
        }
        let Some(&last) = vertices.last() else { return };
        let own = &mut self.list[slot];
        own.used = vertices.len();
        let own = *own;
        let places = self.points[2 * own.at..2 * own.end()].chunks_exact_mut(2);
        for (k, place) in places.enumerate() {
            let vertex = vertices.get(k).copied().unwrap_or(last);
            (place[0], place[1]) = (vertex.x, vertex.y);
        }
        self.touch(own.at..own.end());
    }

    /// Cuts a slot in two, both of which are to be filled again.
    pub(super) fn split(&mut self, slot: usize) {
        let own = &mut self.list[slot];
        let (half, end) = (own.room / 2, own.end());
        (own.room, own.used) = (half, 0);
        let at = own.at + half;
        self.list.insert(slot + 1, Slot { at, room: end - at, used: 0 });
    }

    /// Gives the room of a slot to the one before it, or after the first, which is to be filled
    /// again.
    pub(super) fn remove(&mut self, slot: usize) {
        let gone = self.list.remove(slot);
        let heir = &mut self.list[slot.saturating_sub(1)];
        heir.at = heir.at.min(gone.at);
        heir.room += gone.room;
    }

    /// Gives a slot room for `wanted` vertices at the cost of those after it.
    fn widen(&mut self, slot: usize, wanted: usize) {
        let missing = wanted - self.list[slot].room;
        let mut found = 0;
        let mut last = slot;
        while found < missing && last + 1 < self.list.len() {
            last += 1;
            found += self.list[last].room - self.list[last].used;
        }
        // Behind the last slot there is room without end.
        let added = missing.saturating_sub(found);
        if added > 0 {
            let room = self.points.len() + 2 * added;
            self.points.resize(room, 0.0);
            self.list[last].room += added;
        }
        let end = self.list[last].end();
        let mut free_from = end;
        let mut spare = found.saturating_sub(missing);
        for k in (slot + 1..=last).rev() {
            let own = &mut self.list[k];
            // The last keeps what is not needed.
            let kept = own.used + std::mem::take(&mut spare);
            let from = own.at;
            own.at = free_from - kept;
            own.room = kept;
            let (at, used) = (own.at, own.used);
            self.points.copy_within(2 * from..2 * (from + used), 2 * at);
            if used > 0 {
                let tail = 2 * (at + used);
                let [x, y] = [self.points[tail - 2], self.points[tail - 1]];
                for place in self.points[tail..2 * free_from].chunks_exact_mut(2) {
                    place.copy_from_slice(&[x, y]);
                }
            }
            free_from = at;
        }
        let own = &mut self.list[slot];
        own.room = free_from - own.at;
        let from = own.at;
        self.touch(from..end);
    }

    fn touch(&mut self, range: Range<usize>) {
        self.changed = if self.changed.is_empty() {
            range
        } else {
            self.changed.start.min(range.start)..self.changed.end.max(range.end)
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(from: usize, count: usize) -> Vec<DVec2> {
        (0..count).map(|k| DVec2::new((from + k) as f64, from as f64)).collect()
    }

    /// The vertices without those that repeat the one before.
    fn distinct(slots: &Slots) -> Vec<DVec2> {
        let mut vertices: Vec<DVec2> =
            slots.points().chunks_exact(2).map(|xy| DVec2::new(xy[0], xy[1])).collect();
        vertices.dedup();
        vertices
    }

    #[test]
    fn slots_that_grow_and_shrink_keep_their_vertices_in_order() {
        let mut slots = Slots::default();
        let mut held: Vec<Vec<DVec2>> = (0..20).map(|k| run(100 * k, 10)).collect();
        for vertices in &held {
            slots.push(vertices);
        }
        slots.take_changed();
        let mut state = 1_usize;
        for step in 0..2000 {
            state = state.wrapping_mul(1_103_515_245).wrapping_add(12345) % (1 << 31);
            let k = (state >> 8) % held.len();
            let count = 1 + (state >> 16) % 40;
            let before = slots.points().to_vec();
            held[k] = run(100 * (step % 97) + 7, count);
            slots.put(k, &held[k]);
            let mut expected = held.concat();
            expected.dedup();
            assert_eq!(distinct(&slots), expected, "step {step}");
            let changed = slots.take_changed();
            for (i, pair) in slots.points().chunks_exact(2).enumerate() {
                let same = before.get(2 * i..2 * i + 2) == Some(pair);
                assert!(same || changed.contains(&i), "step {step}: vertex {i} is not told");
            }
            let adjoin = slots.list.windows(2).all(|pair| pair[0].end() == pair[1].at);
            assert!(adjoin, "slots adjoin in step {step}");
        }
    }

    #[test]
    fn slots_can_be_cut_in_two_and_removed() {
        let mut slots = Slots::default();
        for k in 0..4 {
            slots.push(&run(100 * k, 10));
        }
        slots.split(1);
        slots.put(1, &run(100, 3));
        slots.put(2, &run(103, 30));
        let mut expected = run(0, 10);
        expected.extend(run(100, 3));
        expected.extend(run(103, 30));
        expected.extend(run(200, 10));
        expected.extend(run(300, 10));
        assert_eq!(distinct(&slots), expected, "after the cut");
        slots.remove(0);
        slots.put(0, &run(100, 3));
        slots.remove(3);
        slots.put(2, &run(200, 10));
        assert_eq!(distinct(&slots), expected[10..expected.len() - 10], "first and last removed");
    }
}
