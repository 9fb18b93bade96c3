//! Stringing runs and transitions together to a tool path.

use glam::DVec2;

use super::corner::{Solved, solve};
use super::lead::{LeadSolution, lead_in, lead_out};
use super::path::{PathBuilder, between};
use super::report;
use super::run::{Run, with_start};
use super::transition::{Solution, Terminal, polyline};
use super::type_points::as_moves;
use super::whole::Trace;
use super::{CornerStyle, Options, SplineMethod};
use crate::contour::{
    Attributes, Contour, Lead, MoveCurve, Role, Tool, ToolPath, Transition, TransitionKind,
};
use crate::diagnostic::Diagnostic;
use crate::geometry::{Curve, Decimal};

/// The path of the centre of `tool` along `contour`.
///
/// The path of lines and arcs is exact, that of splines within `options.tolerance`, or within 1e-11
/// of its largest coordinate where that is more. It is what a
/// control without a look-ahead beyond the corner would cut. Gouges, of one segment, of one corner and
/// between any two parts of the contour, are reported in [`ToolPath::gouges`] and as diagnostics
/// with segments, point and depth. A contour that is closed, and has no lead-in or
/// lead-out, is joined at its start too, and its path ends where it starts.
#[must_use]
pub fn compensate(contour: &Contour, tool: Tool, options: &Options) -> ToolPath {
    let mut trace = Trace::default();
    let mut path = compensate_traced(contour, tool, options, &mut trace, 0);
    trace.report(&mut path, &[(contour, tool)], usable(contour, tool, options));
    path
}

/// The tolerance that can be kept, of which offsets may use up all [mm].
pub(super) fn usable(contour: &Contour, tool: Tool, options: &Options) -> f64 {
    options.usable_tolerance().max(finest_tolerance(contour, tool))
}

/// The path along one of several contours, behind `first_move` moves of others; gouges between
/// distant segments are left to `trace`.
pub(super) fn compensate_traced(
    contour: &Contour,
    tool: Tool,
    options: &Options,
    trace: &mut Trace,
    first_move: usize,
) -> ToolPath {
    let finest = finest_tolerance(contour, tool);
    // A radius that the coordinates have no digits for moves nothing.
    let tool = if tool.radius() < finest { tool.without_radius() } else { tool };
    let options = &Options { tolerance: options.tolerance.max(finest), ..*options };
    let mut runs: Vec<Run> = Vec::with_capacity(contour.segments().len());
    let mut spans = 0;
    for segment in contour.segments() {
        runs.push(Run::new(segment, tool, options));
        spans += match &segment.curve {
            Curve::Line(_) | Curve::Arc(_) | Curve::Involute(_) => 1,
            Curve::Spline(spline) => spline.pieces().len(),
        };
    }
    let leads = [contour.lead_in(), contour.lead_out()];
    let closed = contour.is_closed() && leads[0].or(leads[1]).is_none();
    let mut corners = Vec::with_capacity(runs.len());
    for pair in runs.windows(2) {
        corners.push(solve(&pair[0], &pair[1], tool, options, false));
    }
    let (first, last) = (&runs[0], &runs[runs.len() - 1]);
    let closing = closed.then(|| solve(last, first, tool, options, runs.len() == 1));
    let assembly = Assembly {
        contour,
        tool,
        options,
        runs: &runs,
        corners: &corners,
        closing: closing.as_ref(),
        lead_in: leads[0].map(|lead| {
            (lead, lead_in(lead.point, lead.attributes.wish.lead, first, tool, options))
        }),
        lead_out: leads[1].map(|lead| {
            let wish = lead.attributes.wish.lead;
            (lead, lead_out(last, lead.point, contour.wall(), wish, tool, options))
        }),
    };
    trace.begin(spans, first_move);
    let path = assembly.build(trace);
    trace.end(closed);
    path
}

/// The finest tolerance that the digits of the coordinates can keep [mm]: 1e-11 of the largest
/// coordinate of the path, which is 5 digits above its rounding.
pub(super) fn finest_tolerance(contour: &Contour, tool: Tool) -> f64 {
    let largest = |point: DVec2| point.abs().max_element();
    let mut farthest = largest(contour.start());
    for segment in contour.segments() {
        match &segment.curve {
            Curve::Line(line) => farthest = farthest.max(largest(line.end())),
            Curve::Arc(arc) => farthest = farthest.max(largest(arc.end()) + 2.0 * arc.radius()),
            Curve::Involute(involute) => {
                let bounds = involute.bounds();
                farthest = farthest.max(largest(bounds.min)).max(largest(bounds.max));
            }
            Curve::Spline(spline) => {
                for &point in spline.points() {
                    farthest = farthest.max(largest(point));
                }
            }
        }
    }
    1e-11 * (farthest + tool.radius())
}

/// Everything solved, to be strung together.
struct Assembly<'a> {
    contour: &'a Contour,
    tool: Tool,
    options: &'a Options,
    runs: &'a [Run<'a>],
    /// Corner `i` lies between the runs `i` and `i + 1`.
    corners: &'a [Solved],
    closing: Option<&'a Solved>,
    lead_in: Option<(&'a Lead, LeadSolution)>,
    lead_out: Option<(&'a Lead, LeadSolution)>,
}

impl Assembly<'_> {
    fn build(&self, trace: &mut Trace) -> ToolPath {
        let mut builder = PathBuilder::default();
        // At most three moves are inserted at a corner.
        let mut count = 0;
        for run in self.runs {
            count += run.pieces.len() + 3;
        }
        builder.path.moves.reserve_exact(count);
        self.add_lead_in(&mut builder);
        for (i, run) in self.runs.iter().enumerate() {
            if i > 0 {
                self.add_events(&mut builder, i);
                self.add_corner(&mut builder, &self.corners[i - 1], [i - 1, i], trace);
            }
            self.add_run(&mut builder, i, run, trace);
        }
        self.add_events(&mut builder, self.runs.len());
        if let Some(closing) = self.closing {
            self.add_corner(&mut builder, closing, [self.runs.len() - 1, 0], trace);
        }
        self.add_lead_out(&mut builder);
        builder.path
    }

    /// Attributes of run `i`.
    fn attributes(&self, i: usize) -> &Attributes {
        &self.runs[i].segment.attributes
    }

    fn add_lead_in(&self, builder: &mut PathBuilder) {
        let Some((lead, solved)) = &self.lead_in else {
            self.add_events(builder, 0);
            return;
        };
        let point = self.contour.start();
        if lead.point.distance(point) < self.tool.radius() {
            let code = "short-lead-in";
            self.short_lead(
                builder,
                lead,
                point,
                code,
                "lead-in",
                "start farther from the contour",
            );
        }
        builder.line_to(lead.point, solved.end, Role::LeadIn, &lead.attributes);
        self.add_events(builder, 0);
        Self::add_lead_corner(
            builder,
            solved,
            &between(&lead.attributes, self.attributes(0)),
            point,
        );
    }

    fn add_lead_out(&self, builder: &mut PathBuilder) {
        let Some((lead, solved)) = &self.lead_out else { return };
        let last = self.attributes(self.runs.len() - 1);
        let point = self.contour.end();
        if lead.point.distance(point) < self.tool.radius() {
            let code = "short-lead-out";
            self.short_lead(builder, lead, point, code, "lead-out", "end farther from the contour");
        }
        Self::add_lead_corner(builder, solved, &between(last, &lead.attributes), point);
        builder.line_to(solved.end, lead.point, Role::LeadOut, &lead.attributes);
    }

    /// Reports a lead between the contour and a place where the tool still cuts into it.
    fn short_lead(
        &self,
        builder: &mut PathBuilder,
        lead: &Lead,
        corner: DVec2,
        code: &'static str,
        which: &str,
        hint: &str,
    ) {
        let message = format!(
            "the {which} is {} mm long, shorter than the tool radius ({} mm)",
            Decimal::of(lead.point.distance(corner)),
            Decimal::of(self.tool.radius())
        );
        builder.path.diagnostics.push(
            Diagnostic::warning(code, message)
                .with_point(lead.point)
                .with_origin(lead.attributes.origin)
                .with_hint(hint),
        );
    }

    fn add_lead_corner(
        builder: &mut PathBuilder,
        solved: &LeadSolution,
        attributes: &Attributes,
        corner: DVec2,
    ) {
        if let Some((kind, angle)) = solved.corner {
            builder.path.transitions.push(Transition {
                kind,
                angle,
                corner,
                construction: solved.solution.construction.clone(),
                origin: attributes.origin,
            });
        }
        builder.moves(&solved.solution.inserted, solved.role, attributes);
    }

    fn add_events(&self, builder: &mut PathBuilder, before: usize) {
        let start = self.runs[0].ends[0];
        // They are in order, and there may be as many as segments.
        let events = self.contour.events();
        let first = events.partition_point(|event| event.before < before);
        for event in events[first..].iter().take_while(|event| event.before == before) {
            builder.path.happen(event, start);
        }
    }

    /// The transition between two runs, and what is to be said about it.
    fn add_corner(
        &self,
        builder: &mut PathBuilder,
        solved: &Solved,
        [i, j]: [usize; 2],
        trace: &mut Trace,
    ) {
        let Solved::Transition { kind, angle, solution, missed } = solved else { return };
        let (incoming, outgoing) = (&self.runs[i], &self.runs[j]);
        let attributes = between(self.attributes(i), self.attributes(j));
        let corner = incoming.segment.curve.end();
        if *missed {
            let near: Vec<MoveCurve> = Self::near_corner(solution, incoming, outgoing);
            let segments = [incoming.segment, outgoing.segment];
            let tolerance = self.options.usable_tolerance();
            report::missed_corner(&mut builder.path, corner, segments, &near, self.tool, tolerance);
        }
        if *kind == TransitionKind::Elongated
            && incoming.polygon.is_some()
            && outgoing.polygon.is_some()
        {
            builder.path.diagnostics.push(
                Diagnostic::info(
                    "splines-meet-elongated",
                    "two splines meet in an elongated corner; they are generally one spline",
                )
                .with_point(corner)
                .with_origin(attributes.origin)
                .with_hint("leave out the repeated type point if no corner is meant"),
            );
        }
        builder.path.transitions.push(Transition {
            kind: *kind,
            angle: *angle,
            corner,
            construction: solution.construction.clone(),
            origin: attributes.origin,
        });
        builder.moves(&solution.inserted, Role::Transition, &attributes);
        let moves_end = builder.path.moves.len();
        if *kind == TransitionKind::Shortened {
            trace.inside_corner(moves_end);
        } else {
            let sign = self.tool.side().sign();
            let directions = [corner, incoming.tangents[1], outgoing.tangents[0]];
            let tame = match self.options.corner_of(&outgoing.segment.attributes) {
                CornerStyle::Linear => *kind == TransitionKind::Elongated,
                CornerStyle::Arc => true,
                CornerStyle::Intersection | CornerStyle::Conic(_) => false,
            };
            trace.corner(directions, sign, &solution.inserted, moves_end, tame);
        }
    }

    /// The moves beside a corner whose offsets do not meet: the nearest piece of each.
    fn near_corner(solution: &Solution, incoming: &Run, outgoing: &Run) -> Vec<MoveCurve> {
        let mut near = solution.inserted.clone();
        if let (Terminal::To(v), Terminal::To(_)) = (solution.incoming, solution.outgoing) {
            near.extend(polyline(&[incoming.ends[0], v, outgoing.ends[1]]));
        } else {
            near.extend(incoming.pieces.last());
            near.extend(outgoing.pieces.first());
        }
        near
    }

    /// The terminals of run `i`.
    fn terminals(&self, i: usize) -> [Terminal; 2] {
        let last = self.runs.len() - 1;
        let start = if i > 0 {
            self.outgoing_terminal(&self.corners[i - 1], i - 1)
        } else if let Some((_, lead)) = &self.lead_in {
            lead.solution.outgoing
        } else {
            self.closing.map_or(Terminal::Whole, |solved| self.outgoing_terminal(solved, last))
        };
        let incoming = |solved: &Solved| match solved {
            Solved::Tangent => Terminal::Whole,
            Solved::Transition { solution, .. } => solution.incoming,
        };
        let end = if i < last {
            incoming(&self.corners[i])
        } else if let Some((_, lead)) = &self.lead_out {
            lead.solution.incoming
        } else {
            self.closing.map_or(Terminal::Whole, incoming)
        };
        [start, end]
    }

    /// How the run after run `i` starts.
    fn outgoing_terminal(&self, solved: &Solved, i: usize) -> Terminal {
        match solved {
            Solved::Tangent => Terminal::Moved(self.runs[i].ends[1]),
            Solved::Transition { solution, .. } => solution.outgoing,
        }
    }

    /// The moves of run `i`, and what is to be said about them.
    fn add_run(&self, builder: &mut PathBuilder, i: usize, run: &Run, trace: &mut Trace) {
        let tolerance = self.options.usable_tolerance();
        let attributes = self.attributes(i);
        let [start, end] = self.terminals(i);
        if run.polygon.is_some() {
            self.add_type_points(builder, i, [start, end], trace);
            return;
        }
        if let (Curve::Spline(_), SplineMethod::TypePoints) =
            (&run.segment.curve, self.options.spline)
        {
            builder.path.diagnostics.push(
                Diagnostic::info("no-type-points", "the spline has no type points to move")
                    .with_origin(attributes.origin)
                    .with_hint("its offset is exact"),
            );
        }
        let whole = run.is_whole(start, end);
        let (cut, backwards) = if whole { (Vec::new(), false) } else { run.between(start, end) };
        let moves = if whole { &run.pieces } else { &cut };
        let around = i.saturating_sub(1)..(i + 2).min(self.runs.len());
        let segments: Vec<_> = self.runs[around].iter().map(|run| run.segment).collect();
        for bend in &run.bends(self.tool.offset()) {
            // Where nothing is cut away and there is no neighbour, it is the cut.
            let cut = if whole && segments.len() == 1 {
                *bend
            } else {
                report::as_cut(bend, moves, run.segment, &segments, self.tool, tolerance)
            };
            if cut.depth > tolerance {
                report::bend(&mut builder.path, &cut, attributes.origin, self.tool);
            }
        }
        if backwards {
            report::backwards(
                &mut builder.path,
                &segments,
                run.segment,
                moves,
                self.tool,
                tolerance,
            );
        }
        let first = builder.path.moves.len();
        builder.moves(moves, Role::Segment, attributes);
        if let (true, Terminal::Moved(point), Some(first)) =
            (whole, start, builder.path.moves.get_mut(first))
        {
            first.curve = with_start(&first.curve, point);
        }
        // Where a gap to the move before was bridged there is one move more.
        let first = builder.path.moves.len().saturating_sub(moves.len());
        // Cut back at its ends, a run has fewer moves than pieces.
        let skipped = match start {
            Terminal::At(place) => place.piece,
            Terminal::Whole | Terminal::To(_) | Terminal::Moved(_) => 0,
        };
        let moves_of = |span: usize| match run.spans.get(span) {
            Some(end) => {
                let to = (end.pieces as usize).saturating_sub(skipped).min(moves.len());
                (to, end.fits && !backwards)
            }
            None => (moves.len(), run.bends(self.tool.offset()).is_empty() && !backwards),
        };
        trace.segment(number(i), run.segment, moves, first, &moves_of);
    }

    /// The spline through moved type points, and how far it is off.
    fn add_type_points(
        &self,
        builder: &mut PathBuilder,
        i: usize,
        terminals: [Terminal; 2],
        trace: &mut Trace,
    ) {
        let run = &self.runs[i];
        let Some(polygon) = &run.polygon else { return };
        let attributes = &run.segment.attributes;
        let origin = attributes.origin;
        let moved = match polygon.moved(terminals[0], terminals[1]) {
            Ok(moved) => moved,
            Err(error) => {
                // Moved points that fall together: the exact offset stands in.
                builder.path.diagnostics.push(
                    Diagnostic::error(
                        "type-points-collapse",
                        format!("the moved type points make no spline: {error}"),
                    )
                    .with_point(run.segment.curve.start())
                    .with_origin(origin)
                    .with_hint("use a smaller tool, or spline: \"exact\""),
                );
                let exact = Options { spline: SplineMethod::Exact, ..*self.options };
                let run = Run::new(run.segment, self.tool, &exact);
                let (moves, _) = run.between(Terminal::Whole, Terminal::Whole);
                builder.moves(&moves, Role::Segment, attributes);
                return;
            }
        };
        if let Some(span) = polygon.turned_span(&moved) {
            let point = polygon.spline().points()[span];
            builder.path.diagnostics.push(
                Diagnostic::error(
                    "type-points-turn",
                    format!("the moved type points {span} and {} change their order: the tool does not fit between them", span + 1),
                )
                .with_point(point)
                .with_origin(origin)
                .with_hint("use a smaller tool, or fewer type points in the bend"),
            );
        }
        let moves = as_moves(&moved);
        for bend in &run.bends(self.tool.offset()) {
            let cut = report::as_moved(bend, &moves, run.segment, self.tool);
            if cut.depth > self.options.usable_tolerance() {
                report::bend(&mut builder.path, &cut, origin, self.tool);
            }
        }
        let (deviation, at) = polygon.deviation(&moved);
        builder.path.diagnostics.push(
            Diagnostic::info(
                "type-points-deviation",
                format!("the spline through the moved type points is up to {} mm off the true equidistant", Decimal::new(deviation, 6)),
            )
            .with_point(at)
            .with_depth(deviation)
            .with_origin(origin),
        );
        builder.moves(&moves, Role::Segment, attributes);
        let first = builder.path.moves.len() - moves.len().min(builder.path.moves.len());
        let fits = run.bends(self.tool.offset()).is_empty();
        trace.segment(number(i), run.segment, &moves, first, &|span| (span + 1, fits));
    }
}

/// The index of a segment, of which memory ends long before its range does.
fn number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
