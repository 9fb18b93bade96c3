//! From chains to moves.

use glam::DVec2;

use super::chains::Chain;
use super::cuts::{SAME_PLACE, Stretch};
use super::sieve::Clearance;
use super::units::{Kind, OutsideCorner, Workpiece, corner_of, index};
use crate::compensation::Options;
use crate::compensation::corner::classify_sharply;
use crate::compensation::path::{PathBuilder, between};
use crate::compensation::run::part;
use crate::compensation::transition::CornerFrame;
use crate::contour::{
    Attributes, Corner, CornerKind, Lead, Move, MoveCurve, Role, Tool, Transition, TransitionKind,
};
use crate::geometry::{Curve, Line, sort_pairs};

/// Places examined on each straight move round a corner.
const EXAMINED: u32 = 16;

/// Strings chains together.
pub(super) struct Stitcher<'a> {
    pub(super) work: &'a Workpiece<'a>,
    /// None where every piece is whole, and each a stretch.
    pub(super) stretches: &'a [Stretch],
    pub(super) clearance: Clearance<'a>,
    pub(super) options: &'a Options,
    pub(super) builder: PathBuilder,
    /// For each contour, how many of its events have happened already.
    pub(super) events: Vec<usize>,
}

impl Stitcher<'_> {
    pub(super) fn build(&mut self, chains: &[Chain]) {
        self.builder.path.moves.reserve(chains.iter().map(|chain| chain.stretches.len()).sum());
        let jobs = self.work.jobs;
        // The contours that chains start and end on, in which order they come, and which are loops.
        let mut jobs_of = Vec::with_capacity(chains.len());
        let mut order = Vec::with_capacity(chains.len());
        let mut looped = Vec::with_capacity(chains.len());
        for (k, chain) in chains.iter().enumerate() {
            let list = &chain.stretches;
            let start = self.job(list[0]);
            // Loops of a contour come before what its leads belong to: from where the lead-out goes, the
            // program goes on.
            let is_led = !chain.closed || self.has_end(chain, start);
            jobs_of.push([start, self.job(list[list.len() - 1])]);
            order.push((index(2 * start + usize::from(is_led)), k));
            looped.push(!is_led);
        }
        sort_pairs(&mut order);
        let all_loops = |job| (0..chains.len()).all(|k| jobs_of[k][0] != job || looped[k]);
        let mut led = vec![false; jobs.len()];
        for (place, &(_, k)) in order.iter().enumerate() {
            let (chain, [job, end]) = (&chains[k], jobs_of[k]);
            let leads_in = !led[job] && (!looped[k] || all_loops(job));
            if let Some(lead) = jobs[job].contour.lead_in().filter(|_| leads_in) {
                let to = self.point(chain.stretches[0], false);
                self.lead(lead, lead.point, to, Role::LeadIn);
            }
            led[job] |= leads_in;
            self.add(chain);
            let is_last = !order[place + 1..].iter().any(|&(_, later)| jobs_of[later][1] == end);
            if let Some(lead) = jobs[end].contour.lead_out().filter(|_| is_last) {
                let from = self.point(chain.stretches[chain.stretches.len() - 1], true);
                self.lead(lead, from, lead.point, Role::LeadOut);
            }
        }
        for job in 0..jobs.len() {
            self.events_before(job, usize::MAX, None);
        }
    }

    /// Whether an end of its contour is on a chain: an open contour may close by touching itself.
    fn has_end(&self, chain: &Chain, job: usize) -> bool {
        let pieces = self.work.pieces_of_range(self.work.ranges[job]);
        let [first, last] = [chain.stretches[0], chain.stretches[chain.stretches.len() - 1]]
            .map(|k| self.stretch(k));
        first.piece == pieces.start && first.from == 0.0
            || last.piece + 1 == pieces.end && last.to == 1.0
    }

    fn lead(&mut self, lead: &Lead, from: DVec2, to: DVec2, role: Role) {
        let heights = lead.attributes.heights;
        let curve = match Line::new(from, to) {
            Ok(line) => MoveCurve::Line(line),
            Err(_) if heights[0] != heights[1] => MoveCurve::Vertical(from),
            Err(_) => return,
        };
        self.builder.piece(curve, role, &lead.attributes, heights);
    }

    #[inline]
    fn stretch(&self, k: usize) -> Stretch {
        self.stretches.get(k).copied().unwrap_or(Stretch::whole(k))
    }

    fn unit(&self, k: usize) -> usize {
        self.work.pieces[self.stretch(k).piece].unit as usize
    }

    fn job(&self, k: usize) -> usize {
        self.work.units[self.unit(k)].job as usize
    }

    /// Start or end of a stretch [mm].
    fn point(&self, k: usize, at_end: bool) -> DVec2 {
        let stretch = self.stretch(k);
        let t = if at_end { stretch.to } else { stretch.from };
        self.work.pieces[stretch.piece].curve.point(t)
    }

    /// Appends the moves of a chain.
    fn add(&mut self, chain: &Chain) {
        let list = &chain.stretches;
        let mut first_move = self.builder.path.moves.len();
        let mut k = 0;
        // Where the next move starts, if that is not where its piece does.
        let mut start = None;
        while k < list.len() {
            let stretch = self.stretch(list[k]);
            let piece = &self.work.pieces[stretch.piece];
            let unit = piece.unit as usize;
            let before = if k > 0 { Some(list[k - 1]) } else { None };
            let mut to = stretch.to;
            k += 1;
            // Stretches of one piece that follow each other are one move.
            while let Some(next) = list.get(k).map(|&next| self.stretch(next))
                && next.piece == stretch.piece
                && next.from == to
            {
                to = next.to;
                k += 1;
            }
            if let Some(before) = before
                && self.work.pieces[self.stretch(before).piece].next as usize != stretch.piece
            {
                self.report_shortened(before, list[k - 1]);
            }
            let of = self.work.units[unit];
            let segment = self.work.segment(unit);
            self.events_before(of.job as usize, of.segment as usize, Some(list[0]));
            if before.is_none() {
                first_move = self.builder.path.moves.len();
            }
            if let Kind::Corner(index) = of.kind {
                let after = list.get(k).or(list.first().filter(|_| chain.closed)).copied();
                let whole = stretch.from == 0.0 && to == 1.0;
                let corner = self.work.corners[index as usize];
                let attributes = self.corner_attributes(unit);
                self.report_corner(&corner, unit, &attributes);
                let neighbours = [before, after].map(|n| n.filter(|&n| self.is_beside(n, unit)));
                if whole && let Some(points) = self.straight_round(&corner, unit) {
                    start = self.add_straight(&points, neighbours, &attributes);
                } else if let Some(curve) = part(&piece.curve, stretch.from, to) {
                    let heights = attributes.heights;
                    self.push(curve, Role::Transition, &attributes, [heights[0]; 2], first_move);
                }
                continue;
            }
            let heights = [stretch.from, to].map(|t| self.height(stretch.piece, unit, t));
            let mut curve = part(&piece.curve, stretch.from, to);
            if let (Some(from), Some(MoveCurve::Line(line))) = (start.take(), &curve) {
                curve = Line::new(from, line.end()).ok().map(MoveCurve::Line).or(curve);
            }
            if let Some(curve) = curve {
                self.push(curve, Role::Segment, &segment.attributes, heights, first_move);
            }
        }
        // The corner at the end of a loop: its first move starts there.
        if let Some(from) = start
            && let Some(Move { curve: MoveCurve::Line(line), .. }) =
                self.builder.path.moves.get_mut(first_move)
            && let Ok(longer) = Line::new(from, line.end())
        {
            *line = longer;
        }
        // A loop may close over a gap too.
        let moves = &self.builder.path.moves[first_move..];
        if let ([first, ..], [.., last]) = (moves, moves)
            && chain.closed
            && last.curve.end().distance(first.curve.start()) > SAME_PLACE
            && let Ok(line) = Line::new(last.curve.end(), first.curve.start())
        {
            let (role, attributes) = (last.role, self.work.segment(self.unit(list[0])).attributes);
            let height = attributes.heights[0];
            self.builder.piece(MoveCurve::Line(line), role, &attributes, [height; 2]);
        }
    }

    /// Appends a move of a chain whose first move has the index `first`; a gap to the move before,
    /// which is far within the tolerance, is bridged.
    fn push(
        &mut self,
        curve: MoveCurve,
        role: Role,
        attributes: &Attributes,
        heights: [f64; 2],
        first: usize,
    ) {
        let moves = &self.builder.path.moves;
        if let Some(last) = moves.last().filter(|_| moves.len() > first)
            && last.curve.end().distance(curve.start()) > SAME_PLACE
            && let Ok(line) = Line::new(last.curve.end(), curve.start())
        {
            self.builder.piece(MoveCurve::Line(line), role, attributes, [heights[0]; 2]);
        }
        self.builder.piece(curve, role, attributes, heights);
    }

    /// Whether a stretch is the straight neighbour of a corner, whole at its side.
    fn is_beside(&self, k: usize, corner: usize) -> bool {
        let stretch = self.stretch(k);
        let unit = self.unit(k);
        let range = self.work.range_of(corner);
        let after = if corner + 1 < range.to { corner + 1 } else { range.from };
        let beside =
            unit + 1 == corner && stretch.to == 1.0 || unit == after && stretch.from == 0.0;
        let is_line = matches!(self.work.pieces[stretch.piece].curve, MoveCurve::Line(_));
        beside && is_line && self.work.units[unit].kind == Kind::Segment
    }

    /// The straight way round an outside corner, where that is asked for and clear.
    fn straight_round(&mut self, corner: &OutsideCorner, unit: usize) -> Option<Vec<DVec2>> {
        if !corner.by_lines {
            return None;
        }
        let frame = CornerFrame::new(&corner.corner, self.tool(unit));
        let (points, spared) = if corner.kind == TransitionKind::Elongated {
            // Clear of the tame stretch around it, as the tree's proof has it.
            (vec![frame.n1, frame.v(), frame.n2], self.clearance.tame(unit))
        } else {
            (vec![frame.n1, frame.a1(), frame.a2(), frame.n2], [unit, unit])
        };
        for pair in points.windows(2) {
            for k in 1..=EXAMINED {
                let at = pair[0].lerp(pair[1], f64::from(k) / f64::from(EXAMINED));
                if !self.clearance.is_clear_except(at, spared) {
                    return None;
                }
            }
        }
        Some(points)
    }

    /// Appends the straight way round a corner; the moves of straight neighbours run on instead of
    /// getting another move. Returns where a straight neighbour behind is to start.
    fn add_straight(
        &mut self,
        points: &[DVec2],
        [before, after]: [Option<usize>; 2],
        attributes: &Attributes,
    ) -> Option<DVec2> {
        let mut points = points;
        if before.is_some()
            && let Some(Move { curve: MoveCurve::Line(line), role: Role::Segment, .. }) =
                self.builder.path.moves.last_mut()
            && line.end().distance(points[0]) <= SAME_PLACE
            && let Ok(longer) = Line::new(line.start(), points[1])
        {
            *line = longer;
            points = &points[1..];
        }
        let mut start = None;
        if after.is_some() {
            points = &points[..points.len() - 1];
            start = points.last().copied();
        }
        for pair in points.windows(2) {
            if let Ok(line) = Line::new(pair[0], pair[1]) {
                let line = MoveCurve::Line(line);
                self.builder.piece(line, Role::Transition, attributes, [attributes.heights[0]; 2]);
            }
        }
        start
    }

    fn tool(&self, unit: usize) -> Tool {
        self.work.jobs[self.work.units[unit].job as usize].tool
    }

    /// What a move round a corner carries.
    fn corner_attributes(&self, unit: usize) -> Attributes {
        let of = self.work.units[unit];
        let segments = self.work.jobs[of.job as usize].contour.segments();
        let range = self.work.range_of(unit);
        let incoming = &segments[of.segment as usize].attributes;
        if unit == range.from {
            // Between the lead-in and the first segment.
            return Attributes { heights: [incoming.heights[0]; 2], ..*incoming };
        }
        let next = (of.segment as usize + 1) % segments.len();
        between(incoming, &segments[next].attributes)
    }

    fn report_corner(&mut self, corner: &OutsideCorner, unit: usize, attributes: &Attributes) {
        let frame = CornerFrame::new(&corner.corner, self.tool(unit));
        let mut construction = frame.construction();
        if corner.kind == TransitionKind::Elongated {
            construction.push(("V", frame.v()));
        } else {
            construction.extend([("A1", frame.a1()), ("A2", frame.a2())]);
        }
        self.report(corner.corner, corner.kind, corner.angle, construction, attributes);
    }

    /// The inside corner between two stretches that do not follow each other, if they are the moves
    /// beside one.
    fn report_shortened(&mut self, before: usize, after: usize) {
        let (a, b) = (self.unit(before), self.unit(after));
        let range = self.work.range_of(a);
        let step = |at: usize| if at + 1 < range.to { at + 1 } else { range.from };
        let gap = step(a);
        if self.work.units[gap].kind != Kind::Break || step(gap) != b {
            return;
        }
        let (incoming, outgoing) = (self.work.segment(a), self.work.segment(b));
        let (Some(last), Some(first)) = (self.work.curve(a), self.work.curve(b)) else { return };
        let corner = corner_of(&last, &first);
        let tool = self.tool(a);
        if let (CornerKind::Transition { kind, angle }, _) =
            classify_sharply(&corner, last.length().min(first.length()), tool, self.options)
        {
            let mut construction = CornerFrame::new(&corner, tool).construction();
            construction.push(("V", self.point(after, false)));
            let attributes = between(&incoming.attributes, &outgoing.attributes);
            self.report(corner, kind, angle, construction, &attributes);
        }
    }

    fn report(
        &mut self,
        corner: Corner,
        kind: TransitionKind,
        angle: f64,
        construction: Vec<(&'static str, DVec2)>,
        attributes: &Attributes,
    ) {
        self.builder.path.transitions.push(Transition {
            kind,
            angle,
            corner: corner.point,
            construction,
            origin: attributes.origin,
        });
    }

    /// Height of the tool at a parameter of a piece [mm]: it changes evenly along the segment.
    fn height(&self, piece: usize, unit: usize, t: f64) -> f64 {
        let segment = self.work.segment(unit);
        let [from, to] = segment.attributes.heights;
        if from == to {
            return to;
        }
        let pieces = self.work.pieces_of(unit);
        let local = ((piece - pieces.start) as f64 + t) / pieces.len() as f64;
        let along = match &segment.curve {
            Curve::Line(_) | Curve::Arc(_) | Curve::Involute(_) => local,
            Curve::Spline(spline) => {
                spline.parameter_at(self.work.units[unit].span as usize, local)
            }
        };
        from + (to - from) * along
    }

    /// Lets happen what is programmed up to the start of a segment and has not happened yet, where the
    /// tool is; at the start of the stretch `first`, or of the contour, if it is nowhere yet.
    fn events_before(&mut self, job: usize, segment: usize, first: Option<usize>) {
        let contour = self.work.jobs[job].contour;
        while let Some(event) = contour.events().get(self.events[job])
            && event.before <= segment
        {
            let start = first.map_or(contour.start(), |first| self.point(first, false));
            self.builder.path.happen(event, start);
            self.events[job] += 1;
        }
    }
}
