//! Building a contour from described segments, with a diagnostic for each that cannot be.
//!
//! Lines, arcs and involutes are made first, since a smooth spline takes its tangents from them. A segment
//! that cannot be made as described is replaced by a straight line to its end, or left out where
//! it has no length, so that the rest of the contour can still be seen; its diagnostic says so.

use glam::DVec2;

use super::{Attributes, Contour, Event, EventKind, Lead, Segment, Shape};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{
    Cubic, Curve, CurveError, Decimal, EndCondition, Line, MIN_LENGTH, Spline, SplineEnds, in_range,
};

/// A contour, unless nothing of it could be made, and what was found on the way.
#[derive(Debug, Clone, PartialEq)]
pub struct Built {
    /// The contour.
    pub contour: Option<Contour>,
    /// What was found.
    pub diagnostics: Vec<Diagnostic>,
}

/// Collects described segments and makes a contour of them.
#[derive(Debug, Clone)]
pub struct ContourBuilder {
    start: DVec2,
    described: Vec<(Shape, Attributes)>,
    lead_in: Option<Lead>,
    lead_out: Option<Lead>,
    wall: Option<DVec2>,
    events: Vec<Event>,
    /// How much the radii of arcs that are kept as they are stated may differ [mm].
    stated: Option<f64>,
}

impl ContourBuilder {
    /// A contour that starts at `start` [mm].
    #[must_use]
    pub fn new(start: DVec2) -> Self {
        Self {
            start,
            described: Vec::new(),
            lead_in: None,
            lead_out: None,
            wall: None,
            events: Vec::new(),
            stated: None,
        }
    }

    /// Leaves centre and ends of arcs as they are stated, though rounding may make their distances
    /// differ by `tolerance` [mm], or a thousandth; otherwise the centre moves to where it is equally
    /// far from both.
    pub fn keep_centers(&mut self, tolerance: f64) {
        self.stated = Some(tolerance);
    }

    /// Adds a segment.
    pub fn segment(&mut self, shape: Shape, attributes: Attributes) {
        self.described.push((shape, attributes));
    }

    /// Adds something that happens between the segments added so far and the next one.
    pub fn event(&mut self, kind: EventKind, origin: Origin) {
        self.events.push(Event { before: self.described.len(), origin, kind });
    }

    /// Adds a segment before what has happened since the last one was added.
    pub fn insert(&mut self, shape: Shape, attributes: Attributes) {
        let end = self.described.len();
        for event in self.events.iter_mut().filter(|event| event.before == end) {
            event.before += 1;
        }
        self.described.push((shape, attributes));
    }

    /// The last segment, to be changed.
    #[must_use]
    pub fn last_mut(&mut self) -> Option<&mut (Shape, Attributes)> {
        self.described.last_mut()
    }

    /// Lets the lead-out begin where the path meets that along a wall of this direction, which begins at
    /// the end.
    pub fn wall(&mut self, direction: DVec2) {
        self.wall = Some(direction);
    }

    /// Asks for a lead-in from `lead` to the start.
    pub fn lead_in(&mut self, lead: Lead) {
        self.lead_in = Some(lead);
    }

    /// Asks for a lead-out from the end to `lead`.
    pub fn lead_out(&mut self, lead: Lead) {
        self.lead_out = Some(lead);
    }

    /// Number of segments added so far.
    #[must_use]
    pub fn len(&self) -> usize {
        self.described.len()
    }

    /// Whether no segment was added yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.described.is_empty()
    }

    /// Where the contour starts [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.start
    }

    /// Lets the contour start elsewhere [mm].
    pub fn move_start(&mut self, to: DVec2) {
        self.start = to;
    }

    /// The segments added so far.
    #[must_use]
    pub fn described(&self) -> &[(Shape, Attributes)] {
        &self.described
    }

    /// The shape of segment `i`, to be changed.
    #[must_use]
    pub fn shape_mut(&mut self, i: usize) -> Option<&mut Shape> {
        self.described.get_mut(i).map(|(shape, _)| shape)
    }

    /// Makes the contour.
    #[must_use]
    pub fn build(self, closed: bool) -> Built {
        let mut diagnostics = Vec::new();
        if !in_range(self.start) {
            let error = CurveError::OutOfRange { point: self.start };
            return Built { contour: None, diagnostics: vec![diagnose(&error, None)] };
        }
        let mut slots = self.lines_and_arcs(&mut diagnostics);
        self.splines(&mut slots, closed, &mut diagnostics);
        let mut segments = Vec::with_capacity(slots.len());
        // Segments left out shift what happens before the later ones.
        let mut index_after = Vec::with_capacity(slots.len() + 1);
        for (slot, (_, attributes)) in slots.into_iter().zip(&self.described) {
            index_after.push(segments.len());
            match slot {
                Slot::Made(curve) => segments.push(Segment { curve, attributes: *attributes }),
                Slot::Chain(splines) => {
                    for spline in splines {
                        let curve = Curve::Spline(spline);
                        segments.push(Segment { curve, attributes: *attributes });
                    }
                }
                Slot::Spline { .. } | Slot::LeftOut => {}
            }
        }
        index_after.push(segments.len());
        let mut events = self.events;
        for event in &mut events {
            event.before = index_after[event.before];
        }
        if segments.is_empty() {
            diagnostics.push(
                Diagnostic::error("empty-contour", "the contour has no segment with a length")
                    .with_point(self.start),
            );
            return Built { contour: None, diagnostics };
        }
        let end = segments[segments.len() - 1].curve.end();
        let mut closed = closed;
        if closed && end.distance(self.start) > MIN_LENGTH {
            diagnostics.push(
                Diagnostic::error(
                    "not-closed",
                    format!(
                        "the closed contour ends {} mm from its start",
                        Decimal::new(end.distance(self.start), 6)
                    ),
                )
                .with_point(end)
                .with_origin(segments[segments.len() - 1].attributes.origin)
                .with_hint("add a segment back to the start; until then it is treated as open"),
            );
            closed = false;
        }
        let Self { lead_in, lead_out, wall, .. } = self;
        let contour = Contour { segments, closed, lead_in, lead_out, wall, events };
        Built { contour: Some(contour), diagnostics }
    }

    /// Makes lines, arcs and involutes, and leaves splines for later.
    fn lines_and_arcs(&self, diagnostics: &mut Vec<Diagnostic>) -> Vec<Slot> {
        let mut from = self.start;
        let mut slots = Vec::with_capacity(self.described.len());
        for (shape, attributes) in &self.described {
            let made = match shape {
                Shape::Spline(spline) => {
                    slots.push(Slot::Spline { from });
                    from = last_in_range(&spline.points).unwrap_or(from);
                    continue;
                }
                Shape::Bezier { controls } => match chain(from, controls) {
                    Ok(splines) => {
                        from = controls[controls.len() - 1];
                        slots.push(Slot::Chain(splines));
                        continue;
                    }
                    Err(error) => Err(error),
                },
                _ => shape.curve(from, self.stated),
            };
            let slot = match made {
                Ok(curve) => Slot::Made(curve),
                Err(error) => {
                    diagnostics.push(diagnose(&error, Some(attributes.origin)).with_point(from));
                    replacement(from, shape.end())
                }
            };
            if let Slot::Made(curve) = &slot {
                from = curve.end();
            }
            slots.push(slot);
        }
        slots
    }

    /// Makes the splines, whose smooth ends follow their neighbours.
    fn splines(&self, slots: &mut [Slot], closed: bool, diagnostics: &mut Vec<Diagnostic>) {
        for i in 0..slots.len() {
            let (Slot::Spline { from }, (Shape::Spline(shape), attributes)) =
                (&slots[i], &self.described[i])
            else {
                continue;
            };
            let origin = attributes.origin;
            let points = usable_points(*from, &shape.points, origin, diagnostics);
            let ends = self.spline_ends(i, closed, &|neighbour, at_end| {
                let Slot::Made(curve) = &slots[neighbour] else { return None };
                let tangent = || curve.tangent(at_end);
                (!matches!(curve, Curve::Spline(_))).then(tangent)
            });
            slots[i] = match Spline::through(points, ends, shape.parameter) {
                Ok(spline) => Slot::Made(Curve::Spline(spline)),
                Err(error) => {
                    diagnostics.push(diagnose(&error, Some(origin)).with_point(*from));
                    replacement(*from, last_in_range(&shape.points))
                }
            };
        }
    }

    /// How described segment `i`, a spline, ends; `tangent_of` gives the tangent of a neighbour at
    /// its start (0) or end (1), if that is no spline.
    pub(crate) fn spline_ends(
        &self,
        i: usize,
        closed: bool,
        tangent_of: &dyn Fn(usize, f64) -> Option<DVec2>,
    ) -> SplineEnds {
        let Shape::Spline(shape) = &self.described[i].0 else { return SplineEnds::NATURAL };
        let last = self.described.len() - 1;
        if shape.periodic.unwrap_or(closed && last == 0) {
            return SplineEnds::Periodic;
        }
        let before = if i > 0 { Some(i - 1) } else { closed.then_some(last) };
        let after = if i < last { Some(i + 1) } else { closed.then_some(0) };
        let end_condition = |given: Option<DVec2>, neighbour: Option<usize>, at_end| {
            let smooth = || neighbour.filter(|_| shape.smooth).and_then(|n| tangent_of(n, at_end));
            let usable = |tangent: &DVec2| tangent.try_normalize().is_some();
            given
                .filter(usable)
                .or_else(smooth)
                .map_or(EndCondition::Natural, EndCondition::Tangent)
        };
        SplineEnds::Open {
            start: end_condition(shape.start_tangent, before, 1.0),
            end: end_condition(shape.end_tangent, after, 0.0),
        }
    }
}

/// What has become of a described segment.
enum Slot {
    /// It is this curve.
    Made(Curve),
    /// It is these splines, one after the other.
    Chain(Vec<Spline>),
    /// It is a spline from this point, to be made once its neighbours are.
    Spline { from: DVec2 },
    /// It has no length, so there is no segment.
    LeftOut,
}

/// The splines that cubic Bézier curves from a point make.
fn chain(mut from: DVec2, controls: &[DVec2]) -> Result<Vec<Spline>, CurveError> {
    if !controls.len().is_multiple_of(3) || controls.is_empty() {
        let count = controls.len();
        return Err(CurveError::TooFewPoints { count, least: (count / 3 + 1) * 3 });
    }
    if let Some(&point) = controls.iter().find(|&&point| !in_range(point)) {
        return Err(CurveError::OutOfRange { point });
    }
    let mut cubics = Vec::with_capacity(controls.len() / 3);
    for control in controls.chunks_exact(3) {
        cubics.push(Cubic::new(from, control[0], control[1], control[2]));
        from = control[2];
    }
    Spline::of_cubics(&cubics)
}

/// A straight line in the place of a segment that cannot be made, where it has a length.
fn replacement(from: DVec2, to: Option<DVec2>) -> Slot {
    match to.filter(|&to| in_range(to)).map(|to| Line::new(from, to)) {
        Some(Ok(line)) => Slot::Made(Curve::Line(line)),
        _ => Slot::LeftOut,
    }
}

/// The last point if it can be used at all.
fn last_in_range(points: &[DVec2]) -> Option<DVec2> {
    points.iter().rev().copied().find(|&p| in_range(p))
}

/// The start and the points after it, without those that repeat the one before.
fn usable_points(
    start: DVec2,
    points: &[DVec2],
    origin: Origin,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<DVec2> {
    let mut usable = Vec::with_capacity(points.len() + 1);
    usable.push(start);
    for (i, &point) in points.iter().enumerate() {
        let previous = usable[usable.len() - 1];
        if previous.distance(point) < MIN_LENGTH {
            diagnostics.push(
                diagnose(&CurveError::CoincidentPoints { index: i + 1 }, Some(origin))
                    .with_point(point)
                    .with_hint("the second of them is left out"),
            );
        } else if in_range(point) {
            usable.push(point);
        } else {
            diagnostics.push(diagnose(&CurveError::OutOfRange { point }, Some(origin)));
        }
    }
    usable
}

/// The diagnostic for a curve that cannot be made.
fn diagnose(error: &CurveError, origin: Option<Origin>) -> Diagnostic {
    let message = error.to_string();
    let diagnostic = match error {
        CurveError::OutOfRange { .. } => Diagnostic::error("out-of-range", message),
        CurveError::ZeroLength => {
            Diagnostic::warning("zero-length", message).with_hint("the segment is left out")
        }
        CurveError::RadiiDisagree { .. } => Diagnostic::error("radii-disagree", message)
            .with_hint("check the centre (I, J); a straight line stands in its place"),
        CurveError::RadiusTooSmall { .. } => Diagnostic::error("radius-too-small", message)
            .with_hint("a straight line stands in its place"),
        CurveError::FullCircleByRadius => Diagnostic::error("full-circle-by-radius", message)
            .with_hint("give the centre instead of the radius"),
        CurveError::TooFewPoints { .. } => Diagnostic::error("too-few-points", message)
            .with_hint("a straight line stands in its place"),
        CurveError::CoincidentPoints { .. } => Diagnostic::warning("coincident-points", message),
        CurveError::NotClosed => Diagnostic::error("not-closed", message)
            .with_hint("let its last point be its first; a straight line stands in its place"),
        CurveError::NoBaseCircle { .. } => Diagnostic::error("no-base-circle", message)
            .with_hint("check the base radius (R); a straight line stands in its place"),
        CurveError::InsideBaseCircle { .. } => Diagnostic::error("inside-base-circle", message)
            .with_hint("check the centre (I, J) and R; a straight line stands in its place"),
        CurveError::OffInvolute { .. } => Diagnostic::error("off-involute", message).with_hint(
            "check the end, the centre (I, J) and R; a straight line stands in its place",
        ),
    };
    match origin {
        Some(origin) => diagnostic.with_origin(origin),
        None => diagnostic,
    }
}
