//! Corners and leads of a contour that is edited: each is solved on the spans near it alone.
//!
//! An outside corner depends on the spans that meet in it. An inside corner is cut back to where
//! the offsets cross; that is looked for on the spans near the corner first, and on as many more
//! as have boxes near enough for another crossing.

use glam::DVec2;

use super::Local;
use super::blocks::Block;
use super::part::{End, Part, Spot};
use crate::compensation::corner::{Solved, solve};
use crate::compensation::lead::{LeadSolution, lead_in, lead_out};
use crate::compensation::run::Run;
use crate::compensation::transition::Terminal;
use crate::contour::{LeadWish, MoveCurve, Segment, TransitionKind};
use crate::geometry::{Bounds, ChangedSpans};

/// Spans on each side of an inside corner that are looked at first.
const NEAR: usize = 24;

/// Where a part begins, and the one before it ends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Joint {
    /// How the incoming part ends.
    pub(super) incoming: End,
    /// How the outgoing part begins.
    pub(super) outgoing: End,
    /// Where a lead comes from and turns into the corner [mm].
    pub(super) before: Vec<DVec2>,
    /// Moves between the two.
    pub(super) inserted: Vec<MoveCurve>,
    /// Where the corner ends and a lead leads to [mm].
    pub(super) after: Vec<DVec2>,
    /// How many spans before and behind it it depends on.
    reach: [usize; 2],
}

impl Joint {
    /// An end of an open contour.
    pub(super) fn free() -> Self {
        Self {
            incoming: End::Whole,
            outgoing: End::Whole,
            before: Vec::new(),
            inserted: Vec::new(),
            after: Vec::new(),
            reach: [1, 1],
        }
    }

    /// Whether it depends on spans of the part before it, of which there are so many.
    pub(super) fn follows(&self, changed: ChangedSpans, spans: usize) -> bool {
        // Spans that go on from the last to the first reach both ends.
        changed.first + changed.count + self.reach[0] > spans
    }

    /// Whether it depends on spans of the part behind it.
    pub(super) fn precedes(&self, changed: ChangedSpans, spans: usize) -> bool {
        changed.first < self.reach[1] || changed.first + changed.count > spans
    }
}

/// Spans of a part, made a segment of their own.
struct Section {
    part: usize,
    first: usize,
    segment: Segment,
}

impl Local {
    /// Solves the joint before part `index`, or behind the last.
    pub(super) fn joint(&self, index: usize) -> Joint {
        let count = self.parts.len();
        let ends = index == 0 || index == count;
        match &self.leads[usize::from(index > 0)] {
            Some(point) if ends => self.lead(index, *point),
            None if ends && !self.closed => Joint::free(),
            _ => self.corner((index + count - 1) % count, index % count),
        }
    }

    fn lead(&self, index: usize, point: DVec2) -> Joint {
        let mut joint = Joint::free();
        if index == 0 {
            let section = self.section(0, 0, 1);
            let run = Run::new(&section.segment, self.tool, &self.options);
            let LeadSolution { end, solution, .. } =
                lead_in(point, LeadWish::AsChosen, &run, self.tool, &self.options);
            joint.before = vec![point, end];
            joint.outgoing = self.end(solution.outgoing, &section, &run);
            joint.inserted = solution.inserted;
        } else {
            let section = self.section(index - 1, self.parts[index - 1].spans() - 1, 1);
            let run = Run::new(&section.segment, self.tool, &self.options);
            let LeadSolution { end, solution, .. } =
                lead_out(&run, point, None, LeadWish::AsChosen, self.tool, &self.options);
            joint.incoming = self.end(solution.incoming, &section, &run);
            joint.inserted = solution.inserted;
            joint.after = vec![end, point];
        }
        joint
    }

    fn corner(&self, a: usize, b: usize) -> Joint {
        let (all_a, all_b) = (self.parts[a].spans(), self.parts[b].spans());
        let mut reach = [1, 1];
        loop {
            let whole = a == b && reach[0] + reach[1] > all_a;
            if whole {
                reach = [all_a, all_a];
            }
            let sections =
                [self.section(a, all_a - reach[0], reach[0]), self.section(b, 0, reach[1])];
            let incoming = Run::new(&sections[0].segment, self.tool, &self.options);
            let outgoing = Run::new(&sections[1].segment, self.tool, &self.options);
            let solved = solve(&incoming, &outgoing, self.tool, &self.options, whole);
            let (solution, missed) = match solved {
                Solved::Tangent => {
                    let outgoing = End::Moved(incoming.ends[1]);
                    return Joint { outgoing, reach, ..Joint::free() };
                }
                Solved::Transition { kind, solution, missed, .. } => {
                    let settled = kind != TransitionKind::Shortened || whole;
                    (solution, (!settled).then_some(missed))
                }
            };
            let end = self.end(solution.incoming, &sections[0], &incoming);
            let Some(missed) = missed else {
                let outgoing = self.end(solution.outgoing, &sections[1], &outgoing);
                let inserted = solution.inserted;
                return Joint { incoming: end, outgoing, inserted, reach, ..Joint::free() };
            };
            let known = reach;
            if reach == [1, 1] {
                reach = [NEAR.min(all_a), NEAR.min(all_b)];
            } else {
                let from = match end {
                    End::At(spot, _) => spot.span,
                    _ => all_a - reach[0],
                };
                reach = self.more(a, b, reach, from, missed);
            }
            if reach == known {
                // An edit anywhere may bring a crossing where there was none, or an earlier one on
                // the outgoing part.
                let everywhere = self.is_long(a) || self.is_long(b);
                let reach = [
                    if missed && everywhere { all_a } else { reach[0] },
                    if everywhere { all_b } else { reach[1] },
                ];
                let outgoing = self.end(solution.outgoing, &sections[1], &outgoing);
                let inserted = solution.inserted;
                return Joint { incoming: end, outgoing, inserted, reach, ..Joint::free() };
            }
        }
    }

    fn is_long(&self, part: usize) -> bool {
        self.parts[part].spans() > NEAR
    }

    /// How many spans on each side of an inside corner must be looked at, where `reach` were, and
    /// those of part `a` from `from` on count.
    fn more(&self, a: usize, b: usize, reach: [usize; 2], from: usize, missed: bool) -> [usize; 2] {
        let (all_a, all_b) = (self.parts[a].spans(), self.parts[b].spans());
        let margin = 2.0 * (self.tool.radius() + self.options.usable_tolerance());
        let [mut tail, mut head] = reach;
        let near_tail = self.parts[a].bounds(from, all_a - from).inflated(margin);
        for block in self.blocks_of(b) {
            let end = block.first + block.spans;
            if end > head && block.bounds.meets(&near_tail) {
                head = end;
            }
        }
        if missed && tail < all_a {
            let whole = self.blocks_of(b).iter().map(|block| block.bounds);
            let near = whole.fold(Bounds::EMPTY, Bounds::union).inflated(margin);
            let beyond = |block: &&Block| block.first < all_a - tail && block.bounds.meets(&near);
            if let Some(block) = self.blocks_of(a).iter().rev().find(beyond) {
                tail = (all_a - block.first).max(2 * tail).min(all_a);
            }
        }
        // Twice as many at least, so that a long stretch is not approached span by span.
        if head > reach[1] {
            head = head.max(2 * reach[1]).min(all_b);
        }
        [tail, head]
    }

    fn section(&self, part: usize, first: usize, count: usize) -> Section {
        Section { part, first, segment: self.parts[part].section(first, count) }
    }

    /// An end found on a section of a part, as an end of the part.
    fn end(&self, terminal: Terminal, section: &Section, run: &Run) -> End {
        let place = match terminal {
            Terminal::Whole => return End::Whole,
            Terminal::To(point) => return End::To(point),
            Terminal::Moved(point) => return End::Moved(point),
            Terminal::At(place) => place,
        };
        let point = run.pieces[place.piece].point(place.t);
        let spot = match &self.parts[section.part] {
            Part::Plain(_) => {
                Spot { span: 0, back: run.pieces.len() - 1 - place.piece, t: place.t }
            }
            Part::Spline(..) => {
                let up_to = |span: usize| run.spans[span].pieces as usize;
                let span = run.spans.partition_point(|end| end.pieces as usize <= place.piece);
                Spot { span: section.first + span, back: up_to(span) - 1 - place.piece, t: place.t }
            }
        };
        End::At(spot, point)
    }
}
