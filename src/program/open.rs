//! A contour of a program as it grows, from its lead-in on.

use glam::DVec2;

use super::course::SwitchOn;
use super::items::{ContourEnd, ContourStart, Item};
use super::modal::INCH;
use super::rules::Rules;
use crate::contour::{ARC_TOLERANCE, Attributes, ContourBuilder, EventKind, Lead, Shape};
use crate::diagnostic::{Diagnostic, Origin, Severity};

/// A contour whose end is not known yet.
#[derive(Debug)]
pub(super) struct Open {
    pub(super) switched: SwitchOn,
    /// Compensation from the next move on, where it has changed.
    pub(super) next: Option<SwitchOn>,
    pub(super) builder: ContourBuilder,
    pub(super) start: DVec2,
    pub(super) lead_in: Option<Lead>,
    pub(super) leads_in: bool,
    pub(super) begins: ContourStart,
    /// The events once more, for when no contour comes of it.
    pub(super) events: Vec<(EventKind, Origin)>,
    /// Of each spline of several blocks, those of its pieces.
    pub(super) curves: Vec<Vec<Origin>>,
    pub(super) last_line: u32,
}

impl Open {
    pub(super) fn new(
        switched: SwitchOn,
        start: DVec2,
        lead_in: Option<Lead>,
        rules: Rules,
    ) -> Box<Self> {
        let mut builder = builder_at(start, rules);
        let mut last_line = line_of(switched.origin);
        if let Some(lead) = lead_in {
            builder.lead_in(lead);
            last_line = line_of(lead.attributes.origin);
        }
        Box::new(Self {
            switched,
            next: None,
            builder,
            start,
            lead_in,
            leads_in: false,
            begins: ContourStart::Anew,
            events: Vec::new(),
            curves: Vec::new(),
            last_line,
        })
    }

    /// Compensation as its words have it now.
    pub(super) fn switched_last(&self) -> SwitchOn {
        self.next.unwrap_or(self.switched)
    }

    pub(super) fn segment(&mut self, shape: Shape, attributes: Attributes) {
        self.builder.segment(shape, attributes);
        self.last_line = line_of(attributes.origin);
    }

    /// The lead-in is all that there is of the contour.
    pub(super) fn lead_becomes_contour(&mut self, rules: Rules) {
        let Some(Lead { point, attributes }) = self.lead_in else { return };
        self.builder = builder_at(point, rules);
        self.builder.segment(Shape::Line { to: self.start }, attributes);
        for (kind, origin) in &self.events {
            self.builder.event(kind.clone(), *origin);
        }
        self.leads_in = true;
    }

    /// At this block a control that looks ahead knows where its last move ends.
    pub(super) fn known(&mut self, origin: Option<Origin>, rules: Rules) {
        if let Some(origin) = origin.filter(|_| rules.any_lead) {
            self.event(EventKind::Stop, origin);
        }
    }

    pub(super) fn event(&mut self, kind: EventKind, origin: Origin) {
        self.builder.event(kind.clone(), origin);
        self.events.push((kind, origin));
        self.last_line = line_of(origin);
    }
}

/// How much the radii of an arc may differ as `LinuxCNC` has it [mm]: a tenth as many inches as
/// millimetres.
pub(super) fn arc_tolerance(unit: f64) -> f64 {
    if unit > 1.0 { 0.1 * ARC_TOLERANCE * unit } else { ARC_TOLERANCE }
}

/// A contour that starts at `start` [mm]; of arcs as they are stated, their faults were found before.
pub(super) fn builder_at(start: DVec2, rules: Rules) -> ContourBuilder {
    let mut builder = ContourBuilder::new(start);
    if rules.any_lead {
        builder.keep_centers(arc_tolerance(INCH));
    }
    builder
}

/// Why a control that stops at every fault cannot make a curve as it is described, in a program whose
/// unit is `unit` [mm].
pub(super) fn fault_of(
    from: DVec2,
    shape: &Shape,
    attributes: Attributes,
    rules: Rules,
    unit: f64,
) -> Option<Diagnostic> {
    if !rules.is_strict {
        return None;
    }
    let mut builder = ContourBuilder::new(from);
    builder.keep_centers(arc_tolerance(unit));
    builder.segment(shape.clone(), attributes);
    builder.build(false).diagnostics.into_iter().find(|found| found.severity == Severity::Error)
}

/// The line of a block.
pub(super) fn line_of(origin: Origin) -> u32 {
    match origin {
        Origin::Block { line, .. } => line,
        Origin::Segment(index) => index,
    }
}

/// An arc may not follow G40, unless there was no radius to compensate.
pub(super) fn refuse_arc(items: &mut [Item], from: DVec2, shape: &Shape, origin: Origin) {
    if !matches!(shape, Shape::Arc { .. } | Shape::ArcByRadius { .. }) {
        return;
    }
    let last = items.iter_mut().rev().find_map(|item| match item {
        Item::Contour(contour) => Some(contour),
        Item::Free(_) | Item::Words { .. } => None,
    });
    if let Some(contour) = last {
        let message = "the first move without compensation is an arc";
        contour.end = ContourEnd::Refused(Box::new(placed(
            Severity::Error,
            "curved-lead-out",
            message,
            origin,
            from,
            LEAD_OUT,
        )));
    }
}

/// Compensation changes while it is on, where no control is known to have rules for it.
pub(super) fn changed(code: &'static str, what: &str, origin: Origin, at: DVec2) -> Diagnostic {
    let message = format!("{what} changes while compensation is on");
    let hint = "the tool goes straight to its new place beside this point; lead out (G40) and in \
                again to keep it off the part";
    placed(Severity::Warning, code, &message, origin, at, hint)
}

/// What to do before a curve that may not follow G40.
pub(super) const LEAD_OUT: &str = "lead out with a straight move (G00 or G01) first";

/// What is found at a block and a point of the plane [mm].
#[inline(never)]
pub(super) fn placed(
    severity: Severity,
    code: &'static str,
    message: &str,
    origin: Origin,
    at: DVec2,
    hint: &str,
) -> Diagnostic {
    let found = Diagnostic::error(code, message);
    Diagnostic { severity, ..found }.with_origin(origin).with_point(at).with_hint(hint)
}
