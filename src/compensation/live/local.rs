//! A contour cut into blocks of spans, of which an edit makes anew those that it changes.

use glam::DVec2;

use super::blocks::{BLOCK, Block};
use super::joint::Joint;
use super::part::{End, Part, Pen};
use super::slots::Slots;
use crate::compensation::assemble::finest_tolerance;
use crate::compensation::{GougePolicy, Options};
use crate::contour::{Contour, ContourBuilder, MoveCurve, Segment, Shape, Tool};
use crate::geometry::{
    Bounds, ChangedSpans, CurveError, Least, SplineEdit, SplineEnds, in_range, sort_long,
};

/// Part of the tolerance below which a change is none. So small a change all but never makes the
/// pieces of a span others than they would be afresh.
const UNCHANGED: f64 = 1e-6;

/// A contour that can be edited locally: each described segment is one part.
#[derive(Debug, Clone)]
pub(super) struct Local {
    pub(super) parts: Vec<Part>,
    pub(super) tool: Tool,
    pub(super) options: Options,
    /// Whether its end is joined to its start.
    pub(super) closed: bool,
    /// Whether its last segment is the neighbour of its first.
    wraps: bool,
    /// Far ends of lead-in and lead-out [mm].
    pub(super) leads: [Option<DVec2>; 2],
    /// The blocks that they lead to and come from, where gouges are avoided.
    pub(super) led: [usize; 2],
    /// By which part of the tolerance the tool is smaller, where gouges are avoided.
    pub(super) smaller: f64,
    /// Where paths for it or for others got lost [mm].
    pub(super) lost: Vec<DVec2>,
    /// Largest distance of a chord from its curve [mm].
    pub(super) chord: f64,
    pub(super) blocks: Vec<Block>,
    /// Boxes around so many blocks and their paths each, where gouges are avoided.
    pub(super) yards: Vec<Bounds>,
    /// Joint `i` is before part `i`, the last behind the last part.
    pub(super) joints: Vec<Joint>,
    pub(super) dirty: Vec<usize>,
    stale: Vec<usize>,
    /// Farthest coordinate that the tolerance is good for [mm].
    farthest: f64,
}

/// Why an edit cannot be made locally; the whole contour is to be made afresh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct NotLocal;

impl From<CurveError> for NotLocal {
    fn from(_: CurveError) -> Self {
        Self
    }
}

impl Local {
    /// The parts of `contour`, and the polylines of the path and of the contour itself.
    pub(super) fn new(
        contour: &Contour,
        wraps: bool,
        tool: Tool,
        options: &Options,
        chord: f64,
        [path, outline]: [&mut Slots; 2],
    ) -> Self {
        let finest = finest_tolerance(contour, tool);
        let [lead_in, lead_out] = [contour.lead_in(), contour.lead_out()];
        let leads = [lead_in.map(|l| l.point), lead_out.map(|l| l.point)];
        let parts: Vec<Part> = contour.segments().iter().cloned().map(Part::new).collect();
        let mut local = Self {
            tool: if tool.radius() < finest { tool.without_radius() } else { tool },
            options: Options { tolerance: options.tolerance.max(finest), ..*options },
            closed: contour.is_closed() && leads.iter().all(Option::is_none),
            wraps,
            leads,
            led: [usize::MAX, 0],
            smaller: 0.0,
            lost: Vec::new(),
            chord,
            blocks: Vec::new(),
            yards: Vec::new(),
            joints: Vec::new(),
            dirty: Vec::new(),
            stale: Vec::new(),
            farthest: if finest < options.tolerance { options.tolerance * 1e11 } else { 0.0 },
            parts,
        };
        for (part, body) in local.parts.iter().enumerate() {
            let spans = body.spans();
            for first in (0..spans).step_by(BLOCK) {
                let count = BLOCK.min(spans - first);
                local.blocks.push(Block {
                    part,
                    first,
                    spans: count,
                    bounds: body.bounds(first, count),
                    path: Bounds::EMPTY,
                    breaks: Vec::new(),
                    dirty: false,
                });
            }
        }
        path.clear();
        outline.clear();
        if local.avoids() {
            for block in 0..local.blocks.len() {
                local.measure(block);
            }
            local.measure_yards();
            for (block, left) in local.cut_all().into_iter().enumerate() {
                local.blocks[block].breaks = left.breaks;
                path.push(&left.vertices);
            }
            local.joints.resize(local.parts.len() + 1, Joint::free());
        } else {
            for index in 0..=local.parts.len() {
                let joint = local.joint(index);
                local.joints.push(joint);
            }
            for block in 0..local.blocks.len() {
                path.push(&local.path_of(block));
            }
        }
        for block in 0..local.blocks.len() {
            outline.push(&local.outline_of(block));
        }
        local
    }

    /// Whether gouges are avoided.
    pub(super) fn avoids(&self) -> bool {
        self.options.gouge == GougePolicy::Avoid
    }

    /// The blocks of a part.
    pub(super) fn blocks_of(&self, part: usize) -> &[Block] {
        let from = self.blocks.partition_point(|block| block.part < part);
        let to = self.blocks.partition_point(|block| block.part <= part);
        &self.blocks[from..to]
    }

    /// The block of a span.
    pub(super) fn block_of(&self, part: usize, span: usize) -> usize {
        let past = |block: &Block| {
            block.part < part || (block.part == part && block.first + block.spans <= span)
        };
        self.blocks.partition_point(past)
    }

    /// What counts as a change.
    fn least(&self) -> Least {
        let by = UNCHANGED * self.options.usable_tolerance();
        Least { beside: self.tool.radius(), by }
    }

    /// Whether a point can be had without a coarser tolerance.
    fn checked(&self, point: DVec2) -> Result<(), NotLocal> {
        let reach = point.abs().max_element() + 3.0 * self.tool.radius();
        if in_range(point) && reach < self.farthest { Ok(()) } else { Err(NotLocal) }
    }

    /// Moves type point `index` of a spline, its start being 0.
    pub(super) fn move_type_point(
        &mut self,
        part: usize,
        index: usize,
        to: DVec2,
    ) -> Result<(), NotLocal> {
        self.checked(to)?;
        let least = self.least();
        let changed = self.spline(part)?.move_point(index, to, least)?;
        self.touch(part, changed);
        Ok(())
    }

    /// Inserts a type point before the one at `index`.
    pub(super) fn insert_type_point(
        &mut self,
        part: usize,
        index: usize,
        point: DVec2,
    ) -> Result<(), NotLocal> {
        self.checked(point)?;
        let least = self.least();
        let block = self.block_of(part, index - 1);
        let changed = self.spline(part)?.insert_point(index, point, least)?;
        self.blocks[block].spans += 1;
        for block in self.blocks[block + 1..].iter_mut().take_while(|block| block.part == part) {
            block.first += 1;
        }
        self.shift_ends(part, index - 1, 1);
        self.touch(part, changed);
        Ok(())
    }

    /// Removes an inner type point.
    pub(super) fn remove_type_point(&mut self, part: usize, index: usize) -> Result<(), NotLocal> {
        let least = self.least();
        let block = self.block_of(part, index);
        let spline = self.spline(part)?;
        // A spline with fewer points may be none.
        if spline.points().len() < 6 {
            return Err(NotLocal);
        }
        let changed = self.spline(part)?.remove_point(index, least)?;
        self.blocks[block].spans -= 1;
        for block in self.blocks[block + 1..].iter_mut().take_while(|block| block.part == part) {
            block.first -= 1;
        }
        self.shift_ends(part, index, -1);
        // It may be empty now, and so not be found again.
        self.mark(block);
        self.touch(part, changed);
        Ok(())
    }

    /// Takes over what is described of the segments around `part`, which or whose end has changed.
    pub(super) fn refresh(
        &mut self,
        described: &ContourBuilder,
        part: usize,
    ) -> Result<(), NotLocal> {
        let count = self.parts.len();
        let wraps = self.wraps;
        let around = |by: usize| {
            let index = part + count + by - 1;
            let inside = wraps || (count..2 * count).contains(&index);
            inside.then_some(index % count)
        };
        // Lines and arcs first: the ends of splines follow them.
        for by in 1..3 {
            let Some(index) = around(by) else { continue };
            if !matches!(described.described()[index].0, Shape::Spline(_)) {
                self.refresh_plain(described, index)?;
            }
        }
        for by in 0..4 {
            let Some(index) = around(by) else { continue };
            self.refresh_spline(described, index)?;
        }
        Ok(())
    }

    fn refresh_plain(&mut self, described: &ContourBuilder, index: usize) -> Result<(), NotLocal> {
        let start = self.start_of(described, index)?;
        let (shape, attributes) = &described.described()[index];
        self.checked(start)?;
        self.checked(shape.end().ok_or(NotLocal)?)?;
        let mut alone = ContourBuilder::new(start);
        alone.segment(shape.clone(), *attributes);
        let built = alone.build(false);
        let [segment] = built.contour.as_ref().map_or(&[][..], Contour::segments) else {
            return Err(NotLocal);
        };
        if !built.diagnostics.is_empty() || !matches!(self.parts[index], Part::Plain(_)) {
            return Err(NotLocal);
        }
        // An arc that is not as far from its centre at both ends may end elsewhere, where the contour
        // may not close.
        if shape.end() != Some(segment.curve.end()) {
            return Err(NotLocal);
        }
        self.parts[index] = Part::Plain(Segment::clone(segment));
        self.touch(index, ChangedSpans { first: 0, count: 1 });
        Ok(())
    }

    /// Lets a spline begin where it is described to, and end as its neighbours make it.
    fn refresh_spline(&mut self, described: &ContourBuilder, index: usize) -> Result<(), NotLocal> {
        let Part::Spline(spline, _) = &self.parts[index] else { return Ok(()) };
        let (start, last) = (self.start_of(described, index)?, spline.spans());
        let end = described.described()[index].0.end().ok_or(NotLocal)?;
        let tangent_of = |part: usize, at_end| self.parts[part].plain_tangent(at_end);
        let ends = described.spline_ends(index, self.wraps, &tangent_of);
        let is_periodic = |ends: SplineEnds| ends == SplineEnds::Periodic;
        if is_periodic(ends) != is_periodic(spline.ends()) {
            return Err(NotLocal);
        }
        for (point, to) in [(0, start), (last, end)] {
            if self.spline(index)?.points()[point] != to {
                self.move_type_point(index, point, to)?;
            }
        }
        let least = self.least();
        if let Some(changed) = self.spline(index)?.set_ends(ends, least) {
            self.touch(index, changed);
        }
        Ok(())
    }

    /// Where a described segment starts [mm].
    fn start_of(&self, described: &ContourBuilder, index: usize) -> Result<DVec2, NotLocal> {
        let Some(before) = index.checked_sub(1) else { return Ok(described.start()) };
        match &self.parts[before] {
            Part::Plain(segment) => Ok(segment.curve.end()),
            Part::Spline(..) => described.described()[before].0.end().ok_or(NotLocal),
        }
    }

    fn spline(&mut self, part: usize) -> Result<&mut SplineEdit, NotLocal> {
        match &mut self.parts[part] {
            Part::Spline(spline, _) => Ok(spline),
            Part::Plain(_) => Err(NotLocal),
        }
    }

    /// Notes that some spans of a part, and what depends on them, are to be made anew.
    fn touch(&mut self, part: usize, changed: ChangedSpans) {
        let spans = self.parts[part].spans();
        let mut k = 0;
        while k < changed.count {
            let block = self.block_of(part, (changed.first + k) % spans);
            self.mark(block);
            let Block { first, spans: own, .. } = self.blocks[block];
            k += first + own - (changed.first + k) % spans;
        }
        let count = self.parts.len();
        if self.joints[part].precedes(changed, spans) {
            self.stale.extend([part, if part == 0 { count } else { part }]);
        }
        if self.joints[part + 1].follows(changed, spans) {
            self.stale.extend([part + 1, if part + 1 == count { 0 } else { part + 1 }]);
        }
    }

    pub(super) fn mark(&mut self, block: usize) {
        if !std::mem::replace(&mut self.blocks[block].dirty, true) {
            self.dirty.push(block);
        }
    }

    /// Keeps the ends of a part in their places when a span from `from` on is inserted or removed.
    fn shift_ends(&mut self, part: usize, from: usize, by: isize) {
        let shift = |end: &mut End| {
            if let End::At(spot, _) = end
                && spot.span >= from
            {
                spot.span = spot.span.saturating_add_signed(by);
            }
        };
        shift(&mut self.joints[part].outgoing);
        shift(&mut self.joints[part + 1].incoming);
    }

    /// Makes everything anew that an edit has changed.
    pub(super) fn update(
        &mut self,
        [path, outline]: [&mut Slots; 2],
        starts: &mut Vec<u32>,
    ) -> Result<(), NotLocal> {
        let dirty = self.dirty.clone();
        // What has been near to the contour before is as much concerned as what is now.
        let mut changed = Vec::with_capacity(dirty.len());
        for block in dirty {
            let before = self.blocks[block].bounds;
            self.measure(block);
            changed.push(before.union(self.blocks[block].bounds));
        }
        let mut stale = std::mem::take(&mut self.stale);
        if self.avoids() {
            stale.clear();
        }
        sort_long(&mut stale, |a, b| a < b);
        stale.dedup();
        for index in stale {
            let joint = self.joint(index);
            if joint != self.joints[index] {
                self.replace(index, joint);
            }
        }
        let drawn = self.tidied([&mut *path, &mut *outline]);
        let avoids = self.avoids();
        for &block in &drawn {
            self.blocks[block].dirty = false;
            outline.put(block, &self.outline_of(block));
            if !avoids {
                path.put(block, &self.path_of(block));
            }
        }
        if avoids && !drawn.is_empty() {
            for (block, left) in self.cut_around(&changed).ok_or(NotLocal)? {
                self.blocks[block].breaks = left.breaks;
                path.put(block, &left.vertices);
            }
        }
        if avoids {
            self.update_starts(path, starts);
        }
        Ok(())
    }

    fn path_of(&self, block: usize) -> Vec<DVec2> {
        let Block { part, first, spans, .. } = self.blocks[block];
        let body = &self.parts[part];
        let (start, end) = (&self.joints[part], &self.joints[part + 1]);
        let mut pen = Pen { chord: self.chord, vertices: Vec::new() };
        if part == 0 && first == 0 {
            for &point in &start.before {
                pen.to(point);
            }
            if !self.closed {
                moves(&start.inserted, &mut pen);
            }
        }
        let ends = [start.outgoing, end.incoming];
        body.offset([first, spans], ends, self.tool, &self.options, &mut pen);
        if first + spans == body.spans() {
            moves(&end.inserted, &mut pen);
            for &point in &end.after {
                pen.to(point);
            }
        }
        pen.vertices
    }

    fn outline_of(&self, block: usize) -> Vec<DVec2> {
        let Block { part, first, spans, .. } = self.blocks[block];
        let mut pen = Pen { chord: self.chord, vertices: Vec::new() };
        self.parts[part].outline(first, spans, &mut pen);
        pen.vertices
    }
}

fn moves(inserted: &[MoveCurve], pen: &mut Pen) {
    for piece in inserted {
        pen.curve(piece);
    }
}
