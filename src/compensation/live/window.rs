//! Avoiding gouges around an edit: only where path and contour are near enough to what has changed.
//!
//! What is left of the path of some spans depends on the contour within the tool's radius of it,
//! and on the paths that cross it there, which belong to that same contour. So the blocks whose path
//! comes near to what has changed, before or now, are cut anew, and all blocks whose contour is near
//! to those paths take part in it. Nothing else is looked at but the boxes of the other blocks.

use glam::DVec2;

use super::Local;
use super::blocks::Block;
use super::part::{Part, Pen};
use super::slots::Slots;
use crate::compensation::avoid::{Whole, best_of, clear_path};
use crate::contour::{Attributes, Contour, Lead, Role, Segment};
use crate::diagnostic::Origin;
use crate::geometry::Bounds;

/// Distance from which on two stretches do not follow each other [mm].
const GAP: f64 = 1e-6;

fn meets_any(bounds: &Bounds, others: &[Bounds]) -> bool {
    others.iter().any(|other| other.meets(bounds))
}

/// What is left of the path of a block.
#[derive(Debug, Clone, Default)]
pub(super) struct Left {
    pub(super) vertices: Vec<DVec2>,
    /// Where a new stretch begins, the first apart.
    pub(super) breaks: Vec<u32>,
}

/// What cutting the paths of some blocks came to.
struct Cut {
    left: Vec<Left>,
    /// The blocks that the lead-in goes to and that the lead-out comes from.
    led: [usize; 2],
}

impl Local {
    /// Cuts the paths of all blocks.
    pub(super) fn cut_all(&mut self) -> Vec<Left> {
        let all: Vec<usize> = (0..self.blocks.len()).collect();
        let mut cuts = Vec::new();
        let best = best_of(&mut |smaller| {
            let (cut, lost) = self.cut(&all, &|_| true, smaller);
            cuts.push(cut);
            lost
        });
        let Cut { left, led } = cuts.swap_remove(best.index);
        (self.led, self.smaller, self.lost) = (led, best.smaller, best.lost);
        left
    }

    /// Cuts again what edits inside some boxes may have changed; returns the blocks concerned and what
    /// is left of them. None where that depends on more: where a lead goes to, or where a path gets lost
    /// and the tool may have to be smaller.
    pub(super) fn cut_around(&self, changed: &[Bounds]) -> Option<Vec<(usize, Left)>> {
        let reach = self.tool.radius() + self.options.usable_tolerance();
        let mut near = Vec::with_capacity(changed.len());
        let mut all = Bounds::EMPTY;
        for bounds in changed {
            near.push(bounds.inflated(reach));
            all = all.union(bounds.inflated(reach));
        }
        let concerned = self.blocks_near(&all, &|block| meets_any(&block.path, &near));
        let [led_in, led_out] = self.led;
        let before = concerned.first().is_some_and(|&first| first <= led_in);
        let behind = concerned.last().is_some_and(|&last| last >= led_out);
        if before && self.leads[0].is_some() || behind && self.leads[1].is_some() {
            return None;
        }
        near.clear();
        for &block in &concerned {
            let path = self.blocks[block].path.inflated(reach);
            near.push(path);
            all = all.union(path);
        }
        if self.lost.iter().any(|&place| meets_any(&Bounds::of([place]), &near)) {
            return None;
        }
        // Those concerned are among them: their contour is beside their path.
        let list = self.blocks_near(&all, &|block| meets_any(&block.bounds, &near));
        let is_concerned = |block: usize| concerned.binary_search(&block).is_ok();
        let (Cut { left, .. }, lost) = self.cut(&list, &is_concerned, self.smaller);
        if !lost.is_empty() {
            return None;
        }
        let mut cut = Vec::with_capacity(concerned.len());
        for (block, left) in list.into_iter().zip(left) {
            if is_concerned(block) {
                cut.push((block, left));
            }
        }
        Some(cut)
    }

    /// Cuts the paths of some blocks, in order, as if there were no others; tells what is left of
    /// those that are asked for, and which of their ends got lost.
    fn cut(
        &self,
        list: &[usize],
        wanted: &dyn Fn(usize) -> bool,
        smaller: f64,
    ) -> (Cut, Vec<DVec2>) {
        let mut left = vec![Left::default(); list.len()];
        let runs = self.runs(list);
        let is_wanted = |origin: Origin| match origin {
            Origin::Segment(block) => wanted(block as usize),
            Origin::Block { .. } => false,
        };
        let (closed, has_spline) = (self.closed, self.has_spline());
        let whole = Whole { closed, has_spline, counts: &is_wanted, tells_uncut: false };
        let (path, lost) = clear_path(&runs, self.tool, &self.options, &whole, smaller);
        // What leads from the last segment to the lead-out names the first of its run.
        let led_out = runs.iter().find(|run| run.lead_out().is_some()).map(|run| {
            let segments = run.segments();
            [segments[0].attributes.origin, segments[segments.len() - 1].attributes.origin]
        });
        let (mut before, mut led) = (None, [usize::MAX, 0]);
        let mut pen = Pen { chord: self.chord, vertices: Vec::new() };
        let (mut last, mut end) = (None, None);
        for step in &path.moves {
            let mut origin = step.origin;
            if let Some([first, last]) = led_out
                && (step.role, origin, before) == (Role::Transition, first, Some(last))
            {
                origin = last;
            }
            before = Some(origin);
            let Origin::Segment(block) = origin else { continue };
            let Ok(k) = list.binary_search(&(block as usize)) else { continue };
            match step.role {
                Role::LeadIn => led[0] = usize::MAX,
                Role::LeadOut => led[1] = last.map_or(0, |k: usize| list[k]),
                _ if led[0] == usize::MAX => led[0] = list[k],
                _ => {}
            }
            let start = step.curve.start();
            let follows =
                end.is_some_and(|end: DVec2| end.distance(start) <= GAP) && last == Some(k);
            (last, end) = (Some(k), Some(step.curve.end()));
            if !wanted(block as usize) {
                continue;
            }
            let own = &mut left[k];
            if !follows && !own.vertices.is_empty() {
                own.breaks.push(u32::try_from(own.vertices.len()).unwrap_or(u32::MAX));
            }
            std::mem::swap(&mut pen.vertices, &mut own.vertices);
            if !follows {
                pen.vertices.push(start);
            }
            pen.curve(&step.curve);
            std::mem::swap(&mut pen.vertices, &mut own.vertices);
        }
        for (own, &block) in left.iter_mut().zip(list) {
            if own.vertices.is_empty() {
                // Nothing is left: a piece without length, where the block begins.
                let Block { part, first, .. } = self.blocks[block];
                own.vertices.push(self.parts[part].section(first, 1).curve.start());
            }
        }
        (Cut { left, led }, lost)
    }

    fn has_spline(&self) -> bool {
        self.parts.iter().any(|part| matches!(part, Part::Spline(..)))
    }

    /// Stretches of the contour made of blocks that follow each other; the segments of each are
    /// the blocks, which they name as their origin.
    fn runs(&self, list: &[usize]) -> Vec<Contour> {
        let count = self.blocks.len();
        let follows = |a: usize, b: usize| a + 1 == b || self.closed && a + 1 == count && b == 0;
        let whole = list.len() == count && self.closed;
        // A stretch may go on from the last block to the first.
        let first = if whole {
            0
        } else {
            (0..list.len())
                .find(|&k| !follows(list[(k + list.len() - 1) % list.len()], list[k]))
                .unwrap_or(0)
        };
        let mut runs = Vec::new();
        let mut segments: Vec<Segment> = Vec::new();
        let mut leads = [None, None];
        for k in 0..list.len() {
            let block = list[(first + k) % list.len()];
            let Block { part, first: span, spans, .. } = self.blocks[block];
            let mut segment = self.parts[part].section(span, spans);
            let origin = Origin::Segment(u32::try_from(block).unwrap_or(u32::MAX));
            segment.attributes = Attributes::at(origin);
            let lead = |point| Lead { point, attributes: segment.attributes };
            if block == 0 {
                leads[0] = self.leads[0].map(lead);
            }
            if block + 1 == count {
                leads[1] = self.leads[1].map(lead);
            }
            segments.push(segment);
            let next = list[(first + k + 1) % list.len()];
            if k + 1 == list.len() || !follows(block, next) {
                let segments = std::mem::take(&mut segments);
                runs.push(Contour::of_segments(segments, whole, std::mem::take(&mut leads)));
            }
        }
        runs
    }

    /// Brings the starts of pieces up to date where vertices of blocks have changed.
    pub(super) fn update_starts(&self, path: &Slots, starts: &mut Vec<u32>) {
        let changed = path.changed();
        if changed.is_empty() {
            return;
        }
        let from = path.slot_of(changed.start);
        let to = (path.slot_of(changed.end - 1) + 2).min(self.blocks.len());
        let place = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        let low = starts.partition_point(|&start| start < place(path.start(from)));
        let end = if to < self.blocks.len() { path.start(to) } else { path.points().len() / 2 };
        let high = starts.partition_point(|&start| start < place(end));
        let vertex = |i: usize| DVec2::new(path.points()[2 * i], path.points()[2 * i + 1]);
        let after = starts.split_off(high);
        starts.truncate(low);
        for block in from..to {
            let at = path.start(block);
            if at == 0 || vertex(at - 1).distance(vertex(at)) > GAP {
                starts.push(place(at));
            }
            for &k in &self.blocks[block].breaks {
                starts.push(place(at) + k);
            }
        }
        starts.extend_from_slice(&after);
    }
}
