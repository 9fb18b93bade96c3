//! Avoiding gouges on the whole contour: what the tool can reach without cutting too deep.
//!
//! 1. The whole offsets of all segments and the ways round outside corners make the raw pieces
//!    (`strands`); with them come fences, where the other side and the free ends of the contour
//!    become too near.
//! 2. All crossings of raw pieces with each other and with fences are found (`cuts`). Between two
//!    cuts a piece is either clear of the contour all along or too near all along, so a few places
//!    tell (`clearance`).
//! 3. What is clear is strung together at the crossings (`chains`).
//! 4. What was cut out bounds the material that is not reached (`uncut`).

mod chains;
mod clearance;
mod cuts;
mod index;
mod strands;
mod uncut;

use self::chains::{Chain, chains};
use self::clearance::Clearance;
use self::cuts::{Arc, cut};
use self::strands::{Leads, Piece, fences, strands};
use self::uncut::uncut;
use super::assemble::finest_tolerance;
use super::lead::{LeadSolution, lead_in, lead_out};
use super::path::PathBuilder;
use super::run::{Run, part};
use super::{Options, SplineMethod};
use crate::contour::{Contour, Lead, Role, Tool, ToolPath};
use crate::diagnostic::Diagnostic;

/// Part of the tolerance that offsets may use up.
const OFFSET_SHARE: f64 = 0.4;

/// Part of the tolerance by which a place may be too near and still count as clear: more than
/// offsets use up, or the path itself would not be clear; less than all of it, since a stretch may
/// come nearer between the places examined.
const CLEAR_SHARE: f64 = 0.45;

/// Places examined on a stretch between two cuts.
const EXAMINED: [f64; 3] = [0.5, 0.25, 0.75];

/// The path of the centre of `tool` along `contour` without what it cannot reach.
///
/// The tool never comes nearer than `radius − tolerance` to any point of the contour, looked at as a
/// whole; leads apart, which are as programmed. Splines are offset exactly, whatever
/// `options.spline` says. Where the tool does not fit between distant segments the path falls into
/// several pieces, ordered by where they begin on the contour; a closed contour gives closed
/// pieces. [`ToolPath::uncut`] tells what is not reached. Nothing reachable gives an empty path and
/// a diagnostic.
#[must_use]
pub fn avoid(contour: &Contour, tool: Tool, options: &Options) -> ToolPath {
    let tolerance = options.usable_tolerance().max(finest_tolerance(contour, tool));
    let options =
        &Options { tolerance: OFFSET_SHARE * tolerance, spline: SplineMethod::Exact, ..*options };
    let closed = contour.is_closed() && contour.lead_in().is_none() && contour.lead_out().is_none();
    let runs: Vec<Run> =
        contour.segments().iter().map(|segment| Run::new(segment, tool, options)).collect();
    let (first, last) = (&runs[0], &runs[runs.len() - 1]);
    let leads = [
        contour.lead_in().map(|lead| (lead, lead_in(lead.point, first, tool, options))),
        contour.lead_out().map(|lead| (lead, lead_out(last, lead.point, tool, options))),
    ];
    let solutions = Leads {
        lead_in: leads[0].as_ref().map(|(_, solved)| &solved.solution),
        lead_out: leads[1].as_ref().map(|(_, solved)| &solved.solution),
    };
    let pieces = strands(&runs, closed, solutions, tool, options);
    let arcs = cut(&pieces, &fences(&runs, closed, tool, options));
    let clearance = Clearance::new(contour);
    let limit = tool.radius() - CLEAR_SHARE * tolerance;
    let is_clear = |arc: &Arc| {
        EXAMINED.into_iter().all(|k| {
            let t = arc.from + (arc.to - arc.from) * k;
            clearance.is_clear(pieces[arc.piece].curve.point(t), limit)
        })
    };
    let clear: Vec<bool> = arcs.iter().map(is_clear).collect();
    let mut assembly = Assembly { contour, runs: &runs, pieces: &pieces, arcs: &arcs, events: 0 };
    let mut builder = PathBuilder::default();
    let chains = chains(&pieces, &arcs, &clear);
    assembly.build(&chains, &leads, &mut builder);
    builder.path.uncut = uncut(&runs, &pieces, &arcs, &clear, tool, tolerance);
    if chains.is_empty() {
        builder.path.diagnostics.push(
            Diagnostic::error("nothing-reachable", "the tool fits nowhere along the contour")
                .with_point(contour.start())
                .with_origin(first.segment.attributes.origin)
                .with_hint("use a smaller tool, or the other side"),
        );
    }
    builder.path
}

/// Strings chains together.
struct Assembly<'a> {
    contour: &'a Contour,
    runs: &'a [Run<'a>],
    pieces: &'a [Piece],
    arcs: &'a [Arc],
    /// Events that have happened already.
    events: usize,
}

impl Assembly<'_> {
    fn build(
        &mut self,
        chains: &[Chain],
        [lead_in, lead_out]: &[Option<(&Lead, LeadSolution)>; 2],
        builder: &mut PathBuilder,
    ) {
        for (k, chain) in chains.iter().enumerate() {
            if let Some((lead, _)) = lead_in.as_ref().filter(|_| k == 0) {
                let start = self.point(chain.arcs[0], false);
                builder.line_to(lead.point, start, Role::LeadIn, &lead.attributes);
            }
            self.add(chain, builder);
            if let Some((lead, _)) = lead_out.as_ref().filter(|_| k + 1 == chains.len()) {
                let end = self.point(chain.arcs[chain.arcs.len() - 1], true);
                builder.line_to(end, lead.point, Role::LeadOut, &lead.attributes);
            }
        }
        self.events_before(usize::MAX, builder);
    }

    /// Start or end of an arc [mm].
    fn point(&self, arc: usize, at_end: bool) -> glam::DVec2 {
        let arc = &self.arcs[arc];
        self.pieces[arc.piece].curve.point(if at_end { arc.to } else { arc.from })
    }

    /// Appends the moves of a chain.
    fn add(&mut self, chain: &Chain, builder: &mut PathBuilder) {
        let mut k = 0;
        while k < chain.arcs.len() {
            let arc = self.arcs[chain.arcs[k]];
            let mut to = arc.to;
            k += 1;
            // Arcs of one piece that follow each other are one move.
            while let Some(next) = chain.arcs.get(k).map(|&next| self.arcs[next])
                && next.piece == arc.piece
                && next.from == to
            {
                to = next.to;
                k += 1;
            }
            let piece = &self.pieces[arc.piece];
            self.events_before(piece.run, builder);
            let attributes = &self.runs[piece.run].segment.attributes;
            if let Some(curve) = part(&piece.curve, arc.from, to) {
                builder.piece(curve, piece.role, attributes);
            }
        }
    }

    /// Lets happen what is programmed up to the start of a segment and has not happened yet.
    fn events_before(&mut self, segment: usize, builder: &mut PathBuilder) {
        let start = self.runs[0].ends[0];
        while let Some(event) = self.contour.events().get(self.events)
            && event.before <= segment
        {
            builder.event(event, start);
            self.events += 1;
        }
    }
}
