//! The course of a program: free moves, and contours between the words that switch compensation.
//!
//! Compensation begins with the first straight move after G41 or G42, the lead-in, and ends with
//! the first straight move after G40, the lead-out. What lies between is one contour; moves along
//! z and words that move nothing become its events. Everything else is free.

use glam::DVec2;

use super::corner_cuts::{CornerWord, PendingCorner};
use super::items::{
    ContourEnd, ContourStart, Item, OrientationSource, ProgrammedContour, RadiusSource,
};
use super::open::{LEAD_OUT, Open, changed, fault_of, line_of, placed, refuse_arc};
use super::report::Report;
use super::rules::{ControlWords, Rules};
use super::spline_words::end_heading;
use crate::contour::{Attributes, EventKind, Lead, MoveCurve, Reset, Shape, Side};
use crate::diagnostic::{Diagnostic, Origin, Severity};

/// Compensation as it is to be switched on.
#[derive(Debug, Clone, Copy)]
pub(super) struct SwitchOn {
    pub(super) side: Side,
    pub(super) radius: RadiusSource,
    /// Added to it [mm].
    pub(super) allowance: f64,
    pub(super) orientation: OrientationSource,
    pub(super) unit: f64,
    pub(super) origin: Origin,
}

/// The items of a program as they grow.
#[derive(Debug)]
pub(super) struct Course {
    pub(super) items: Vec<Item>,
    /// How many segments and events the contours among them have.
    segments: usize,
    pub(super) state: State,
    pub(super) rules: Rules,
    /// Compensation was switched off, and no straight move has followed yet.
    pub(super) needs_a_line: bool,
    /// A tool was changed beside the last contour: the program goes on from there.
    pub(super) is_beside: bool,
    /// The control has stopped at a curve that cannot be.
    pub(super) is_cut_off: bool,
    /// The unit of the program [mm].
    pub(super) unit: f64,
    /// The direction in the plane in which the last move ends, where it is known.
    pub(super) heading: Option<DVec2>,
    /// What the block at work asks of the corner at its end.
    pub(super) asked: Option<CornerWord>,
    /// The corner at the end of the last move, to be cut once the next one is known.
    pub(super) corner: Option<Box<PendingCorner>>,
    /// Line and first column of the blocks that a contour, or a move, is made of.
    pub(super) columns: Vec<(u32, u32)>,
}

#[derive(Debug)]
pub(super) enum State {
    /// No compensation.
    Off,
    /// G41 or G42 was read, its first straight move was not.
    Waiting(SwitchOn),
    /// In a contour.
    On(Box<Open>),
    /// G40 was read, its first straight move was not.
    Ending(Box<Open>),
}

impl Course {
    pub(super) fn new(rules: Rules) -> Self {
        Self {
            items: Vec::new(),
            segments: 0,
            state: State::Off,
            rules,
            needs_a_line: false,
            is_beside: false,
            is_cut_off: false,
            unit: 1.0,
            heading: None,
            asked: None,
            corner: None,
            columns: Vec::new(),
        }
    }

    /// How many moves and words there are, those of an open contour included.
    pub(super) fn len(&self) -> usize {
        let open = match &self.state {
            State::On(open) | State::Ending(open) => open.builder.len() + open.events.len(),
            State::Off | State::Waiting(_) => 0,
        };
        self.items.len() + self.segments + open
    }

    /// Whether moves are free, apart from a lead-in.
    pub(super) fn is_free(&self) -> bool {
        matches!(self.state, State::Off | State::Waiting(_))
    }

    /// The side of the tool, while compensation is on: its lead-in made and G40 not yet read.
    pub(super) fn side(&self) -> Option<Side> {
        match &self.state {
            State::On(open) => Some(open.switched_last().side),
            State::Off | State::Waiting(_) | State::Ending(_) => None,
        }
    }

    /// Compensation as it was switched on, its lead-in made or not, until G40 is read.
    pub(super) fn switched(&self) -> Option<SwitchOn> {
        match &self.state {
            State::Waiting(switched) => Some(*switched),
            State::On(open) => Some(open.switched_last()),
            State::Off | State::Ending(_) => None,
        }
    }

    /// The blocks that the curve just made comes from, one for each of its pieces.
    pub(super) fn name_blocks(&mut self, origins: &[Origin]) {
        match &mut self.state {
            State::Off | State::Waiting(_) => {
                for (item, origin) in self.items.iter_mut().rev().zip(origins.iter().rev()) {
                    let Item::Free(made) = item else { break };
                    let MoveCurve::Cubic(_) = made.curve else { break };
                    made.origin = *origin;
                }
            }
            State::On(open) | State::Ending(open) => {
                open.last_line = origins.last().map_or(open.last_line, |last| line_of(*last));
                if origins.len() > 1 {
                    open.curves.push(origins.to_vec());
                }
            }
        }
    }

    /// Words that move nothing.
    pub(super) fn words(&mut self, words: String, origin: Origin) {
        match &mut self.state {
            State::On(open) | State::Ending(open) => open.event(EventKind::Words(words), origin),
            _ => self.items.push(Item::Words { words, reset: None, origin }),
        }
    }

    /// Words, maybe none, after which the next move starts where it says; only outside a contour.
    pub(super) fn reset(&mut self, words: String, origin: Origin, reset: Reset) {
        if self.is_free() {
            self.items.push(Item::Words { words, reset: Some(reset), origin });
        } else if !words.is_empty() {
            self.words(words, origin);
        }
    }

    /// Ends the contour where it cannot go on as one; another one goes on from `at` [mm].
    pub(super) fn break_off(&mut self, at: DVec2, report: &mut Report) {
        match std::mem::replace(&mut self.state, State::Off) {
            State::On(open) => {
                let switched = open.switched_last();
                self.close(open, None, ContourEnd::Off, report);
                self.state = State::On(Open::new(switched, at, None, self.rules));
            }
            state => {
                self.state = state;
                self.end_without_line(ContourEnd::Off, report);
            }
        }
    }

    /// The machine waits for its operator (M0, M1, M60).
    pub(super) fn stop(&mut self, origin: Origin) {
        if let State::On(open) = &mut self.state {
            open.event(EventKind::Stop, origin);
        }
    }

    /// The control stops: of a contour that is open it makes what it is sure of.
    pub(super) fn cut_off(&mut self, report: &mut Report) {
        match std::mem::replace(&mut self.state, State::Off) {
            State::Off | State::Waiting(_) => {}
            State::On(open) => self.close(open, None, ContourEnd::CutOff, report),
            State::Ending(open) => self.close(open, None, ContourEnd::Off, report),
        }
    }

    /// A straight move between two points that differ [mm].
    pub(super) fn line(
        &mut self,
        mut from: DVec2,
        to: DVec2,
        mut attributes: Attributes,
        report: &mut Report,
    ) {
        let mut shape = Shape::Line { to };
        if !self.cut_corner(&mut from, &mut shape, &mut attributes, report) {
            return;
        }
        self.heading = end_heading(from, &shape);
        let corner = self.ends_in_corner(from, &shape, &attributes);
        match std::mem::replace(&mut self.state, State::Off) {
            State::Off => self.free_curve(from, shape, attributes, report),
            State::Waiting(switched) => {
                let lead_in = Lead { point: from, attributes };
                self.state = State::On(Open::new(switched, to, Some(lead_in), self.rules));
            }
            State::On(mut open) => {
                open.segment(shape.clone(), attributes);
                if let Some(next) = open.next.take() {
                    // The last block of the one radius is the first of the other.
                    self.close(open, None, ContourEnd::Tapers, report);
                    open = Open::new(next, from, None, self.rules);
                    open.begins = ContourStart::Tapers;
                    open.segment(shape, attributes);
                }
                self.state = State::On(open);
            }
            State::Ending(open) => {
                let lead = Lead { point: to, attributes };
                self.close(open, Some(lead), ContourEnd::Off, report);
            }
        }
        self.needs_a_line = false;
        self.wait_in_corner(corner, report);
    }

    /// An arc or a spline.
    pub(super) fn curve(
        &mut self,
        mut from: DVec2,
        mut shape: Shape,
        mut attributes: Attributes,
        report: &mut Report,
    ) {
        if !self.cut_corner(&mut from, &mut shape, &mut attributes, report) {
            return;
        }
        let corner = self.ends_in_corner(from, &shape, &attributes);
        self.heading = end_heading(from, &shape);
        if let Shape::Bezier { controls } = &shape {
            // A block can make many of them.
            self.segments += controls.len() / 3;
        }
        let origin = attributes.origin;
        if let Some(fault) = fault_of(from, &shape, attributes, self.rules, self.unit) {
            self.found(fault, report);
            self.is_cut_off = true;
            return self.cut_off(report);
        }
        if self.needs_a_line {
            self.needs_a_line = false;
            refuse_arc(&mut self.items, from, &shape, origin);
        }
        match std::mem::replace(&mut self.state, State::Off) {
            State::Off => self.free_curve(from, shape, attributes, report),
            State::Waiting(switched) => {
                let leads_in = self.rules.any_lead;
                if !leads_in {
                    let message = "compensation is switched on before an arc or a spline";
                    let hint = "lead in with a straight move; LinuxCNC's profile leads in on arcs";
                    let code = "curved-lead-in";
                    report.push(placed(Severity::Error, code, message, origin, from, hint));
                }
                let mut open = Open::new(switched, from, None, self.rules);
                open.leads_in = leads_in;
                open.segment(shape, attributes);
                self.state = State::On(open);
            }
            State::On(mut open) => {
                if let Some(next) = open.next.take() {
                    report.push(changed("radius-changed", "the radius", next.origin, from));
                    self.close(open, None, ContourEnd::Off, report);
                    open = Open::new(next, from, None, self.rules);
                }
                open.segment(shape, attributes);
                self.state = State::On(open);
            }
            State::Ending(open) => {
                self.close(open, None, ContourEnd::Off, report);
                if self.rules.any_lead {
                    refuse_arc(&mut self.items, from, &shape, origin);
                } else {
                    let message = "compensation is switched off before an arc or a spline";
                    let code = "curved-lead-out";
                    report.push(placed(Severity::Error, code, message, origin, from, LEAD_OUT));
                }
                self.free_curve(from, shape, attributes, report);
            }
        }
        self.wait_in_corner(corner, report);
    }

    /// G41 or G42 at `at` [mm].
    pub(super) fn switch_on(&mut self, switched: SwitchOn, at: DVec2, report: &mut Report) {
        match std::mem::replace(&mut self.state, State::Off) {
            State::Off | State::Waiting(_) => self.state = State::Waiting(switched),
            State::On(mut open) => {
                open.next = None;
                let before = open.switched;
                if before.side == switched.side
                    && before.radius == switched.radius
                    && before.allowance == switched.allowance
                {
                    self.state = State::On(open);
                    return;
                }
                let control = self.rules.words;
                let same_side = before.side == switched.side;
                if control == ControlWords::Common {
                    let (code, what) = if same_side {
                        ("radius-changed", "the radius")
                    } else {
                        ("side-changed", "the side")
                    };
                    report.push(changed(code, what, switched.origin, at));
                }
                if open.builder.is_empty() {
                    open.switched = switched;
                } else if same_side && control != ControlWords::Common {
                    open.next = Some(switched);
                } else {
                    self.close(open, None, ContourEnd::Off, report);
                    open = Open::new(switched, at, None, self.rules);
                    if control == ControlWords::Fanuc {
                        open.begins = ContourStart::Crosses;
                    }
                }
                self.state = State::On(open);
            }
            State::Ending(open) => {
                if !self.rules.any_lead {
                    let message =
                        "compensation is switched off and on again without a move between";
                    let hint = "lead out with a straight move before G41 or G42";
                    let (code, origin) = ("no-lead-out", switched.origin);
                    report.push(placed(Severity::Warning, code, message, origin, at, hint));
                }
                self.close(open, None, ContourEnd::Off, report);
                self.state = State::Waiting(switched);
                self.needs_a_line = self.rules.any_lead;
            }
        }
    }

    /// G40.
    pub(super) fn switch_off(&mut self, origin: Origin) {
        self.state = match std::mem::replace(&mut self.state, State::Off) {
            State::Off | State::Waiting(_) => State::Off,
            State::On(mut open) | State::Ending(mut open) => {
                open.last_line = line_of(origin);
                open.known(Some(origin), self.rules);
                State::Ending(open)
            }
        };
    }

    /// The direction of a wall behind the contour that is ended.
    pub(super) fn wall(&mut self, direction: DVec2) {
        if let State::On(open) = &mut self.state {
            open.builder.wall(direction);
        }
    }

    /// The end of the program, at `origin`: an open contour ends here.
    pub(super) fn end(&mut self, origin: Option<Origin>, report: &mut Report) {
        self.leave_corner(report);
        match std::mem::replace(&mut self.state, State::Off) {
            State::Off | State::Waiting(_) => {}
            State::Ending(open) => self.close(open, None, ContourEnd::Off, report),
            State::On(mut open) => {
                let mut diagnostic =
                    Diagnostic::warning("compensation-left-on", "the program ends without G40")
                        .with_hint("lead out with G40 and a straight move");
                diagnostic.origin = origin;
                report.push(diagnostic);
                let end = if self.is_cut_off { ContourEnd::CutOff } else { ContourEnd::Off };
                open.known(origin.filter(|_| end == ContourEnd::Off), self.rules);
                self.close(open, None, end, report);
            }
        }
    }

    pub(super) fn into_items(self) -> Vec<Item> {
        self.items
    }

    /// Makes the contour, or free moves where there is nothing to compensate.
    pub(super) fn close(
        &mut self,
        mut open: Box<Open>,
        lead_out: Option<Lead>,
        end: ContourEnd,
        report: &mut Report,
    ) {
        self.is_beside = end == ContourEnd::Beside;
        if self.rules.any_lead && open.builder.is_empty() {
            open.lead_becomes_contour(self.rules);
        }
        let mut last_line = open.last_line;
        if let Some(lead) = lead_out {
            open.builder.lead_out(lead);
            last_line = line_of(lead.attributes.origin);
        }
        if !open.builder.is_empty() {
            self.segments += open.builder.len() + open.events.len();
            let built = open.builder.build(false);
            for found in built.diagnostics {
                self.found(found, report);
            }
            if let Some(contour) = built.contour {
                self.items.push(Item::Contour(Box::new(ProgrammedContour {
                    contour,
                    side: open.switched.side,
                    radius: open.switched.radius,
                    allowance: open.switched.allowance,
                    unit: open.switched.unit,
                    orientation: open.switched.orientation,
                    curves: open.curves,
                    leads_in: open.leads_in,
                    begins: open.begins,
                    end,
                    blocks: [line_of(open.switched.origin), last_line],
                })));
                return;
            }
        }
        let message = "there is nothing to compensate between switching on and off";
        let hint = "its moves are left as programmed";
        report.warning("empty-compensation", message, open.switched.origin, hint);
        let at = open.start;
        if let Some(lead) = open.lead_in {
            self.free_line(lead.point, at, &lead.attributes);
        }
        for (kind, origin) in open.events {
            match kind {
                EventKind::Words(words) => {
                    self.items.push(Item::Words { words, reset: None, origin });
                }
                EventKind::Vertical(attributes) => self.free(MoveCurve::Vertical(at), &attributes),
                EventKind::Stop => {}
            }
        }
        if let Some(lead) = lead_out {
            self.free_line(at, lead.point, &lead.attributes);
        }
    }
}
