//! The raw material: what the contours are made of, and their whole offsets before anything is cut.
//!
//! Every place that a tool beside a contour can take, touching it, lies on the whole offset of some
//! line, arc or span of a spline, or on the arc about some outside corner. At an inside corner the
//! two offsets cross; no way round it exists, so the raw path breaks there.

use glam::DVec2;

use super::octants::Octants;
use super::points::{SHORTEST, ends, shaping, shaping_spans};
use super::sieve::{Fate, tolerances};
use super::tree::{Node, OrderTree, Range};
use crate::compensation::corner::classify_sharply;
use crate::compensation::offset::{
    ArcOffset, Tolerances, offset_arc, offset_line, offset_span_roughly,
};
use crate::compensation::run::with_start;
use crate::compensation::{CornerStyle, Options};
use crate::contour::{Contour, Corner, CornerKind, MoveCurve, Segment, Tool, TransitionKind};
use crate::geometry::{Arc, Bounds, Curve, MIN_LENGTH, direction, perp};

/// A contour and the tool that is to run along it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Job<'a> {
    pub(super) contour: &'a Contour,
    pub(super) tool: Tool,
    /// The first segment that is a wall, and the one behind the last.
    pub(super) walls: [usize; 2],
}

impl<'a> Job<'a> {
    /// A contour all of which is wall.
    pub(super) fn new(contour: &'a Contour, tool: Tool) -> Self {
        Self { contour, tool, walls: [0, contour.segments().len()] }
    }

    /// Whether some of it only runs in or out, and may be cut.
    pub(super) fn runs_over(&self) -> bool {
        self.walls != [0, self.contour.segments().len()]
    }

    /// Whether its end is joined to its start.
    pub(super) fn is_closed(&self) -> bool {
        let contour = self.contour;
        contour.is_closed() && contour.lead_in().is_none() && contour.lead_out().is_none()
    }
}

/// What a unit is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// A line, an arc, or the span of a spline.
    Segment,
    /// An outside corner, by its index.
    Corner(u32),
    /// An inside corner, or the gap between two contours.
    Break,
}

/// A line, an arc, the span of a spline, or a corner behind one of those.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unit {
    pub(super) kind: Kind,
    /// Index of the contour.
    pub(super) job: u32,
    /// Index of the segment on its contour, or of the one that leads to the corner.
    pub(super) segment: u32,
    /// Index of the span on its spline.
    pub(super) span: u32,
    /// Where its pieces end in the list of all.
    pub(super) pieces_end: u32,
}

/// One piece of raw path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) curve: MoveCurve,
    pub(super) unit: u32,
    /// The piece of the same contour that starts where it ends; [`NONE`] at an inside corner.
    pub(super) next: u32,
}

/// No index.
pub(super) const NONE: u32 = u32::MAX;

/// An outside corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct OutsideCorner {
    pub(super) corner: Corner,
    pub(super) kind: TransitionKind,
    pub(super) angle: f64,
    /// Whether straight moves are wanted round it.
    pub(super) by_lines: bool,
}

/// All contours with their raw paths.
#[derive(Debug)]
pub(super) struct Workpiece<'a> {
    pub(super) jobs: &'a [Job<'a>],
    pub(super) units: Vec<Unit>,
    pub(super) pieces: Vec<Piece>,
    pub(super) corners: Vec<OutsideCorner>,
    /// The units of each contour.
    pub(super) ranges: Vec<Range>,
    /// The widest gap in a raw path, or in what it follows, that was closed [mm].
    pub(super) gap: f64,
}

impl<'a> Workpiece<'a> {
    /// The raw paths along `jobs`, and what the tree is to know of each unit.
    pub(super) fn new(jobs: &'a [Job<'a>], options: &Options) -> (Self, Vec<Node>) {
        // A corner behind each segment, and what parts contours.
        let units = |job: &Job| {
            let segments = job.contour.segments();
            segments.iter().map(spans_of).sum::<usize>() + segments.len() + 2
        };
        let count = jobs.iter().map(units).sum();
        let work = Self {
            jobs,
            units: Vec::with_capacity(count),
            // More than one a unit where there are cusps.
            pieces: Vec::with_capacity(count + count / 4),
            corners: Vec::new(),
            ranges: Vec::with_capacity(jobs.len()),
            gap: 0.0,
        };
        let mut maker = Maker { work, nodes: Vec::with_capacity(count), scratch: Vec::new() };
        for (index, job) in (0..).zip(jobs) {
            maker.job(index, job, options);
        }
        (maker.work, maker.nodes)
    }

    /// The segment that a unit belongs to, or that leads to it.
    pub(super) fn segment(&self, unit: usize) -> &'a Segment {
        let unit = &self.units[unit];
        &self.jobs[unit.job as usize].contour.segments()[unit.segment as usize]
    }

    /// The unit's part of the contour; none for a break.
    pub(super) fn curve(&self, unit: usize) -> Option<MoveCurve> {
        let Unit { kind, span, .. } = *self.units.get(unit)?;
        match kind {
            Kind::Segment => Some(MoveCurve::of(&self.segment(unit).curve, span as usize)),
            Kind::Corner(index) => {
                Some(MoveCurve::Vertical(self.corners[index as usize].corner.point))
            }
            Kind::Break => None,
        }
    }

    /// The pieces of a unit, as indices.
    pub(super) fn pieces_of(&self, unit: usize) -> std::ops::Range<usize> {
        let from = if unit > 0 { self.units[unit - 1].pieces_end } else { 0 };
        from as usize..self.units[unit].pieces_end as usize
    }

    /// The units of the contour that a unit is part of.
    pub(super) fn range_of(&self, unit: usize) -> Range {
        self.ranges[self.units[unit].job as usize]
    }

    /// Offsets the spans again that have open pieces, within `tolerance` [mm], and joins
    /// all pieces over gaps of up to `gap` [mm]. Returns what `fates` tells of each piece that is not
    /// new, and [`Fate::Open`] for those that are.
    pub(super) fn refine(
        &mut self,
        tolerance: f64,
        gap: f64,
        tree: &OrderTree,
        fates: &[Fate],
    ) -> Vec<Fate> {
        let former = std::mem::take(&mut self.pieces);
        self.pieces.reserve(former.len() + former.len() / 8);
        let mut now = Vec::with_capacity(former.len() + former.len() / 8);
        let (mut from, mut scratch) = (0, Vec::new());
        let mut before = None;
        for unit in 0..self.units.len() {
            let to = self.units[unit].pieces_end as usize;
            if fates[from..to].contains(&Fate::Open)
                && let Some(MoveCurve::Cubic(cubic)) = self.curve(unit)
            {
                let offset = self.jobs[self.units[unit].job as usize].tool.offset();
                // The first span of a spline goes on from nothing.
                let inside = unit > 0 && {
                    let (last, this) = (&self.units[unit - 1], &self.units[unit]);
                    last.kind == Kind::Segment && last.segment == this.segment
                };
                scratch.clear();
                let tolerances =
                    Tolerances { roughness: 0.0, ..tolerances(tree.unit(unit).octants, tolerance) };
                let before = before.filter(|_| inside);
                offset_span_roughly(&cubic, offset, tolerances, before, &mut scratch);
                for &curve in &scratch {
                    self.pieces.push(Piece { curve, unit: index(unit), next: NONE });
                    now.push(Fate::Open);
                }
            } else {
                self.pieces.extend_from_slice(&former[from..to]);
                now.extend_from_slice(&fates[from..to]);
            }
            if to > from {
                before = Some(former[to - 1].curve.end());
            }
            from = to;
            self.units[unit].pieces_end = index(self.pieces.len());
        }
        for range in self.ranges.clone() {
            self.join(range, gap);
        }
        now
    }

    /// Joins the pieces of one contour.
    ///
    /// Units that follow each other directly meet tangentially, so the gap between their offsets,
    /// of rounding and of the tangent band, is closed by moving the start of the second. Elsewhere
    /// pieces that do not meet are parted by an inside corner.
    fn join(&mut self, range: Range, tolerance: f64) {
        let indices = self.pieces_of_range(range);
        let base = index(indices.start);
        let pieces = &mut self.pieces[indices];
        let Some(last) = pieces.len().checked_sub(1) else { return };
        for a in 0..last + usize::from(range.closed) {
            let b = if a < last { a + 1 } else { 0 };
            let (end, start) = (pieces[a].curve.end(), pieces[b].curve.start());
            let gap = end.distance(start);
            let (unit, next) = (pieces[a].unit as usize, pieces[b].unit as usize);
            let direct =
                next <= unit + 1 && b > a || b <= a && unit + 1 == range.to && next == range.from;
            if direct && gap > 0.0 && gap <= tolerance {
                pieces[b].curve = with_start(&pieces[b].curve, end);
                self.gap = self.gap.max(gap);
            }
            let joins = gap <= 2.0 * MIN_LENGTH || direct && gap <= tolerance;
            pieces[a].next = if joins { base + index(b) } else { NONE };
        }
    }

    /// The pieces of a contour, as indices.
    pub(super) fn pieces_of_range(&self, range: Range) -> std::ops::Range<usize> {
        self.pieces_of(range.from).start..self.pieces_of(range.to - 1).end
    }
}

/// An index of a list; memory ends long before its range does.
pub(super) fn index(value: usize) -> u32 {
    u32::try_from(value).unwrap_or(NONE)
}

fn spans_of(segment: &Segment) -> usize {
    match &segment.curve {
        Curve::Line(_) | Curve::Arc(_) | Curve::Involute(_) => 1,
        Curve::Spline(spline) => spline.pieces().len(),
    }
}

/// A workpiece in the making.
struct Maker<'a> {
    work: Workpiece<'a>,
    nodes: Vec<Node>,
    /// Pieces of one span.
    scratch: Vec<MoveCurve>,
}

impl Maker<'_> {
    fn job(&mut self, number: u32, job: &Job, options: &Options) {
        let (contour, tool) = (job.contour, job.tool);
        let segments = contour.segments();
        let shortest = SHORTEST * options.usable_tolerance();
        let kept = shaping(segments, shortest);
        if kept.len() < segments.len() {
            // A run of short ones before the start of the contour, and one behind it.
            self.work.gap = self.work.gap.max(2.0 * shortest);
        }
        let ends = |segment: usize| ends(&segments[segment].curve, shortest);
        let first_unit = self.work.units.len();
        let is_wall = |segment: usize| (job.walls[0]..job.walls[1]).contains(&segment);
        let mut unit = Unit { kind: Kind::Break, job: number, segment: 0, span: 0, pieces_end: 0 };
        let attributes = |i: usize| &segments[i].attributes;
        if let Some(lead) = contour.lead_in()
            && options.lead_of(lead.attributes.wish.lead).goes_round()
            && let Some(along) = direction(contour.start() - lead.point)
        {
            let first = ends(kept[0])[0];
            let corner = Corner {
                point: contour.start(),
                incoming: along,
                outgoing: first.tangent(0.0),
                incoming_curvature: 0.0,
                outgoing_curvature: curvature(&first, 0.0),
            };
            let corner = (corner, options.corner_of(attributes(kept[0])));
            self.corner(unit, corner, first.length(), tool, options);
            if !is_wall(kept[0]) {
                self.open_up(first_unit);
            }
        }
        for (k, &i) in kept.iter().enumerate() {
            let segment = &segments[i];
            unit.segment = index(i);
            let first_node = self.nodes.len();
            self.segment(unit, segment, tool, options);
            let last = ends(i)[1];
            if !is_wall(i) {
                self.open_up(first_node);
            }
            let corner_node = self.nodes.len();
            let next = kept.get(k + 1).or(kept.first().filter(|_| job.is_closed()));
            if let Some(&next) = next {
                let first = ends(next)[0];
                let length = last.length().min(first.length());
                let corner = (corner_of(&last, &first), options.corner_of(attributes(next)));
                self.corner(unit, corner, length, tool, options);
            } else if let Some(lead) = contour.lead_out()
                && options.lead_of(lead.attributes.wish.lead).goes_round()
                && let Some(corner) = corner_to(&last, lead.point)
            {
                let corner = (corner, options.corner_of(attributes(i)));
                self.corner(unit, corner, last.length(), tool, options);
            }
            if !is_wall(i) && !next.is_some_and(|&next| is_wall(next)) {
                self.open_up(corner_node);
            }
        }
        let to = self.work.units.len();
        let range = Range { from: first_unit, to, closed: job.is_closed() };
        self.work.ranges.push(range);
        self.work.join(range, options.usable_tolerance());
        self.add(Unit { kind: Kind::Break, ..unit }, Node::BREAK);
    }

    fn add(&mut self, unit: Unit, node: Node) {
        let pieces_end = index(self.work.pieces.len());
        self.work.units.push(Unit { pieces_end, ..unit });
        self.nodes.push(node);
    }

    /// From this node on nothing is wall.
    fn open_up(&mut self, from: usize) {
        for node in &mut self.nodes[from..] {
            node.contour = Bounds::EMPTY;
        }
    }

    /// Appends pieces of the next unit; returns the box around them.
    fn pieces(&mut self, curves: &[MoveCurve]) -> Bounds {
        let unit = index(self.work.units.len());
        let mut bounds = Bounds::EMPTY;
        for &curve in curves {
            bounds = bounds.union(curve.hull_bounds());
            self.work.pieces.push(Piece { curve, unit, next: NONE });
        }
        bounds
    }

    fn segment(&mut self, unit: Unit, segment: &Segment, tool: Tool, options: &Options) {
        let unit = Unit { kind: Kind::Segment, ..unit };
        let offset = tool.offset();
        match &segment.curve {
            Curve::Line(line) => {
                let curve = offset_line(line, offset).map(MoveCurve::Line);
                let path = self.pieces(curve.as_slice());
                let octants = Octants::of(line.vector());
                self.add(unit, Node { contour: line.bounds(), path, octants, fits: true });
            }
            Curve::Arc(arc) => {
                let (curve, fits) = match offset_arc(arc, offset) {
                    ArcOffset::Arc(arc) => (Some(MoveCurve::Arc(arc)), true),
                    ArcOffset::Point => (None, true),
                    ArcOffset::Reversed(arc, _) => (Some(MoveCurve::Arc(arc)), false),
                };
                let path = self.pieces(curve.as_slice());
                let octants = Octants::of_way(arc.tangent(0.0), arc.sweep());
                self.add(unit, Node { contour: arc.bounds(), path, octants, fits });
            }
            Curve::Spline(spline) => {
                let mut before = None;
                let mut scratch = std::mem::take(&mut self.scratch);
                let fitting = options.usable_tolerance();
                let spans = shaping_spans(spline.pieces(), SHORTEST * fitting);
                if spans.len() < spline.pieces().len() {
                    self.work.gap = self.work.gap.max(2.0 * SHORTEST * fitting);
                }
                for span in spans {
                    let cubic = &spline.pieces()[span];
                    scratch.clear();
                    let octants = Octants::of_cubic(cubic);
                    let tolerances = tolerances(octants, fitting);
                    let fits = offset_span_roughly(cubic, offset, tolerances, before, &mut scratch);
                    before = scratch.last().map_or(before, |last| Some(last.end()));
                    let mut path = self.pieces(&scratch);
                    if !fits {
                        path = path.inflated(tolerances.beside_cusps(cubic));
                    }
                    let fits = fits && octants.is_narrow();
                    let contour = cubic.hull_bounds();
                    self.add(
                        Unit { span: index(span), ..unit },
                        Node { contour, path, octants, fits },
                    );
                }
                self.scratch = scratch;
            }
            // It was made a spline before.
            Curve::Involute(_) => {}
        }
    }

    /// The way round a corner behind a segment, where there is one; `length` is that of the shorter
    /// curve at it [mm].
    fn corner(
        &mut self,
        unit: Unit,
        (corner, style): (Corner, CornerStyle),
        length: f64,
        tool: Tool,
        options: &Options,
    ) {
        let (CornerKind::Transition { kind, angle }, depth) =
            classify_sharply(&corner, length, tool, options)
        else {
            return;
        };
        self.work.gap = self.work.gap.max(depth);
        if kind == TransitionKind::Shortened {
            self.add(unit, Node::BREAK);
            return;
        }
        let [n1, n2] = [corner.incoming, corner.outgoing]
            .map(|tangent| corner.point + perp(tangent) * tool.offset());
        let arc = corner_arc(n1, n2, &corner, tool.offset() > 0.0);
        let path = self.pieces(arc.as_slice());
        let index = index(self.work.corners.len());
        let by_lines = style == CornerStyle::Linear;
        self.work.corners.push(OutsideCorner { corner, kind, angle, by_lines });
        let sign = tool.side().sign();
        let octants = Octants::of_turn(corner.incoming, corner.outgoing, sign);
        let contour = Bounds::of([corner.point]);
        let node = Node { contour, path, octants, fits: true };
        self.add(Unit { kind: Kind::Corner(index), ..unit }, node);
    }
}

/// The arc about a corner.
pub(super) fn corner_arc(
    from: DVec2,
    to: DVec2,
    corner: &Corner,
    clockwise: bool,
) -> Option<MoveCurve> {
    Arc::from_center(from, to, corner.point, clockwise, f64::INFINITY).ok().map(MoveCurve::Arc)
}

fn curvature(curve: &MoveCurve, t: f64) -> f64 {
    match curve {
        MoveCurve::Line(_) | MoveCurve::Vertical(_) => 0.0,
        MoveCurve::Arc(arc) => arc.curvature(),
        MoveCurve::Cubic(cubic) => cubic.curvature(t),
        MoveCurve::Involute(involute) => involute.curvature(t),
    }
}

/// The corner between two curves.
pub(super) fn corner_of(incoming: &MoveCurve, outgoing: &MoveCurve) -> Corner {
    Corner {
        point: incoming.end(),
        incoming: incoming.tangent(1.0),
        outgoing: outgoing.tangent(0.0),
        incoming_curvature: curvature(incoming, 1.0),
        outgoing_curvature: curvature(outgoing, 0.0),
    }
}

/// The corner between the end of the contour and the lead-out.
fn corner_to(incoming: &MoveCurve, to: DVec2) -> Option<Corner> {
    let point = incoming.end();
    let outgoing = direction(to - point)?;
    Some(Corner {
        point,
        incoming: incoming.tangent(1.0),
        outgoing,
        incoming_curvature: curvature(incoming, 1.0),
        outgoing_curvature: 0.0,
    })
}
