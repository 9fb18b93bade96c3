//! Gouges between distant segments of a path that is left as it is.
//!
//! The tree over the contour in program order (`avoid::tree`) tells which moves may be too near to
//! which part of the contour; mostly there are none. Those are held against each other move by
//! move.

use glam::DVec2;

use super::avoid::octants::Octants;
use super::avoid::tree::{Limits, Node, OrderTree, Range};
use super::meet::meet;
use super::report;
use crate::contour::{Contour, Gouge, GougeKind, MoveCurve, Segment, Tool, ToolPath};
use crate::diagnostic::Origin;
use crate::geometry::{Bounds, Curve};

/// Steps from curve to curve until the nearest places are found; each roughly squares the error
/// where one of them is straight.
const STEPS: usize = 12;

/// Part of its depth that a report about a segment or a corner must have named for a local gouge to
/// count as told: such reports sample.
const KNOWN: f64 = 0.95;

/// Part of the contour, with the moves along it.
#[derive(Debug, Clone, Copy)]
struct Unit {
    /// Index of the contour.
    job: u32,
    /// Index of the segment; none for a corner.
    segment: Option<u32>,
    /// Index of the span on its spline.
    span: u32,
    /// The moves along it: from the end of those of the unit before to here.
    moves_end: usize,
}

/// Follows paths along their contours while they are made.
#[derive(Debug, Default)]
pub(super) struct Trace {
    units: Vec<Unit>,
    nodes: Vec<Node>,
    ranges: Vec<Range>,
    /// For each contour, how many moves the paths before it have.
    first_moves: Vec<usize>,
}

/// A place where the path is too near.
#[derive(Debug, Clone, Copy)]
struct Cut {
    depth: f64,
    at: DVec2,
    /// Index of the unit whose move cuts.
    from: usize,
    /// Index of the unit that is cut.
    into: usize,
}

impl Trace {
    /// A contour begins, of so many spans, behind so many moves.
    pub(super) fn begin(&mut self, spans: usize, first_move: usize) {
        self.units.reserve(spans);
        self.nodes.reserve(spans);
        let from = self.units.len();
        self.ranges.push(Range { from, to: from, closed: false });
        self.first_moves.push(first_move);
    }

    /// The contour ends; where it is closed, at its start.
    pub(super) fn end(&mut self, closed: bool) {
        let to = self.units.len();
        if let Some(range) = self.ranges.last_mut() {
            (range.to, range.closed) = (to, closed);
        }
        let moves_end = self.units.last().map_or(0, |unit| unit.moves_end);
        self.inside_corner(moves_end);
    }

    fn add(&mut self, unit: Unit, node: Node) {
        let fits = node.fits && node.octants.is_narrow();
        let job = u32::try_from(self.ranges.len() - 1).unwrap_or(u32::MAX);
        self.units.push(Unit { job, ..unit });
        self.nodes.push(Node { fits, ..node });
    }

    /// An outside corner that the moves up to `moves_end` go round; `tame` tells that the textbook
    /// proves them clear of both neighbours.
    pub(super) fn corner(
        &mut self,
        [point, incoming, outgoing]: [DVec2; 3],
        sign: f64,
        moves: &[MoveCurve],
        moves_end: usize,
        tame: bool,
    ) {
        let path = MoveCurve::hulls(moves);
        let octants = Octants::of_turn(incoming, outgoing, sign);
        let contour = Bounds::of([point]);
        self.add(
            Unit { job: 0, segment: None, span: 0, moves_end },
            Node { contour, path, octants, fits: tame },
        );
    }

    /// An inside corner.
    pub(super) fn inside_corner(&mut self, moves_end: usize) {
        self.add(Unit { job: 0, segment: None, span: 0, moves_end }, Node::BREAK);
    }

    /// A segment: `moves_of` tells for each span where the moves along it end in `moves`, the first
    /// of which has the index `first` on the path of its contour, and whether the tool fits there.
    pub(super) fn segment(
        &mut self,
        index: u32,
        segment: &Segment,
        moves: &[MoveCurve],
        first: usize,
        moves_of: &dyn Fn(usize) -> (usize, bool),
    ) {
        let mut add = |span: u32, from: usize, contour: Bounds, octants: Octants| {
            let (to, fits) = moves_of(span as usize);
            let along = moves.get(from..to).unwrap_or(&[]);
            let path = MoveCurve::hulls(along);
            let unit = Unit { job: 0, segment: Some(index), span, moves_end: first + to };
            self.add(unit, Node { contour, path, octants, fits });
            to
        };
        match &segment.curve {
            Curve::Line(line) => {
                add(0, 0, line.bounds(), Octants::of(line.vector()));
            }
            Curve::Arc(arc) => {
                add(0, 0, arc.bounds(), Octants::of_way(arc.tangent(0.0), arc.sweep()));
            }
            Curve::Involute(involute) => {
                let octants = Octants::of_way(involute.tangent(0.0), involute.turn());
                add(0, 0, involute.bounds(), octants);
            }
            Curve::Spline(spline) => {
                let mut from = 0;
                for (span, cubic) in (0..).zip(spline.pieces()) {
                    let octants = Octants::of_cubic(cubic);
                    from = add(span, from, cubic.hull_bounds(), octants);
                }
            }
        }
    }

    /// Reports the gouges between distant parts of the contours in `path`, and those that no report
    /// about a segment or a corner has named yet.
    pub(super) fn report(mut self, path: &mut ToolPath, jobs: &[(&Contour, Tool)], tolerance: f64) {
        let radius = jobs[0].1.radius();
        let least = radius - tolerance;
        if least <= 0.0 {
            return;
        }
        let mut tree = OrderTree::new(std::mem::take(&mut self.nodes));
        let marks = tree.marks(&self.ranges, Limits { reach: least, least: 0.0 });
        let Self { units, ranges, .. } = &self;
        let watch = Watch { units, tree: &tree, jobs, ranges, radius, least };
        let mut cuts = Vec::new();
        for (range, &first) in self.ranges.iter().zip(&self.first_moves) {
            let mut going: Option<Cut> = None;
            let mut hint = None;
            let mut from = first;
            for unit in range.from..range.to {
                let to = first + self.units[unit].moves_end;
                let moves = path.moves.get(from..to).unwrap_or(&[]);
                from = to.max(from);
                if !marks.is_suspect(unit) {
                    cuts.extend(going.take());
                    continue;
                }
                for one in moves {
                    let deepest = watch.deepest(&one.curve, unit, hint);
                    hint = deepest.map(|cut| cut.into);
                    match (deepest, &mut going) {
                        (Some(cut), Some(known)) if cut.depth > known.depth => *known = cut,
                        (Some(_), Some(_)) => {}
                        (Some(cut), None) => going = Some(cut),
                        (None, _) => cuts.extend(going.take()),
                    }
                }
            }
            cuts.extend(going);
        }
        for cut in &cuts {
            watch.tell(cut, path);
        }
    }
}

/// What is asked while the path is held against the contour.
struct Watch<'a> {
    units: &'a [Unit],
    tree: &'a OrderTree,
    jobs: &'a [(&'a Contour, Tool)],
    ranges: &'a [Range],
    radius: f64,
    least: f64,
}

impl Watch<'_> {
    /// The contour along a unit.
    fn curve(&self, unit: usize) -> Option<MoveCurve> {
        let Unit { job, segment, span, .. } = self.units[unit];
        let segment = &self.jobs[job as usize].0.segments()[segment? as usize];
        Some(MoveCurve::of(&segment.curve, span as usize))
    }

    /// The units of the contour that a unit is part of.
    fn range(&self, unit: usize) -> Range {
        self.ranges[self.units[unit].job as usize]
    }

    /// Where the segment of a unit was programmed; a corner counts to the segment before it.
    fn origin(&self, unit: usize) -> Origin {
        let from = self.range(unit).from;
        let before = (from..=unit).rev().find_map(|at| self.units[at].segment);
        let segments = self.jobs[self.units[unit].job as usize].0.segments();
        segments[before.unwrap_or(0) as usize].attributes.origin
    }

    /// Where a move along a unit cuts deepest, if it is too near anywhere; `hint` may be the unit that
    /// the move before cut deepest.
    fn deepest(&self, one: &MoveCurve, unit: usize, hint: Option<usize>) -> Option<Cut> {
        let [tame_from, tame_to] = self.tree.tame_around(unit, self.range(unit), usize::MAX);
        let bounds = one.hull_bounds();
        let middle = one.point(0.5);
        // No point of it is farther from there.
        let half = bounds.span_squared(&Bounds { min: middle, max: middle }).sqrt();
        let (mut deepest, mut last) = (None, None);
        let mut look = |other: usize, deepest: &mut Option<Cut>| {
            let curve = self.curve(other).filter(|_| !(tame_from..tame_to).contains(&other));
            // Of laps that lie on each other one is enough.
            let Some(curve) = curve.filter(|curve| last != Some(*curve)) else { return true };
            last = Some(curve);
            let known = deepest.map_or(self.radius - self.least, |cut| cut.depth);
            let reach = self.radius - known;
            // Not even their boxes come as near, or not all that is about its middle.
            if bounds.gap_squared(&curve.hull_bounds()) >= reach * reach
                || curve.nearest(middle).distance - half >= reach
            {
                return true;
            }
            let (distance, at) = approach(one, &curve);
            let depth = self.radius - distance;
            if depth > known {
                *deepest = Some(Cut { depth, at, from: unit, into: other });
            }
            // Nothing is deeper than what the path crosses.
            distance > 0.0
        };
        if let Some(hint) = hint {
            for other in hint.saturating_sub(1)..self.units.len().min(hint + 2) {
                look(other, &mut deepest);
            }
        }
        let reach = deepest.map_or(self.least, |cut| self.radius - cut.depth);
        self.tree.near(&bounds, reach, &mut |other| look(other, &mut deepest));
        deepest
    }

    /// Reports a cut, unless it is a local one that was reported already.
    fn tell(&self, cut: &Cut, path: &mut ToolPath) {
        let local = self.is_local(cut);
        let known = |gouge: &Gouge| {
            gouge.at.distance(cut.at) <= 2.0 * self.radius && gouge.depth >= KNOWN * cut.depth
        };
        if local && path.gouges.iter().any(known) {
            return;
        }
        let (mover, into) = (self.origin(cut.from), self.origin(cut.into));
        let kind = if local { GougeKind::Curvature } else { GougeKind::Bottleneck };
        report::too_near(path, kind, cut.at, cut.depth, [mover, into]);
    }

    /// Whether the way along the contour from where the tool should be to where it cuts is at most
    /// half a circle of the tool.
    fn is_local(&self, cut: &Cut) -> bool {
        if self.units[cut.from].job != self.units[cut.into].job {
            return false;
        }
        let range = self.range(cut.from);
        let most = std::f64::consts::PI * self.radius;
        let within = |mut at: usize, to: usize| {
            let mut length = 0.0;
            while at != to && length <= most {
                at += 1;
                if at == range.to {
                    if !range.closed {
                        return false;
                    }
                    at = range.from;
                }
                if at != to {
                    length += self.tree.unit(at).contour_size();
                }
            }
            length <= most
        };
        within(cut.from, cut.into) || within(cut.into, cut.from)
    }
}

/// The least distance of two curves [mm] as stepping from one to the other finds it, and the place on
/// the second.
fn approach(a: &MoveCurve, b: &MoveCurve) -> (f64, DVec2) {
    if let Some(crossing) = meet(a, b).points().first() {
        return (0.0, crossing.point);
    }
    let landmarks = |curve: &MoveCurve| [curve.point(0.0), curve.point(0.5), curve.point(1.0)];
    let mut best = (f64::INFINITY, b.start());
    for point in landmarks(b) {
        let distance = a.nearest(point).distance;
        if distance < best.0 {
            best = (distance, point);
        }
    }
    for point in landmarks(a) {
        let nearest = b.nearest(point);
        if nearest.distance < best.0 {
            best = (nearest.distance, nearest.point);
        }
    }
    for _ in 0..STEPS {
        let nearest = b.nearest(a.nearest(best.1).point);
        if nearest.distance >= best.0 - 1e-9 {
            break;
        }
        best = (nearest.distance, nearest.point);
    }
    best
}
