//! Compensation with one block of look-ahead, as `LinuxCNC` does it.
//!
//! A move waits, with its end beside the end of its own segment, until the next segment is known;
//! what happens between the two, words and moves along the normal of the plane, waits behind it.
//! The next segment then tells where all of them end: where they are, or, into an inside corner,
//! where the two offsets meet (`corner`). Nothing looks further, and nothing gives way: where the
//! tool does not fit by these rules the control stops, and so does the path.
//!
//! The rules are those of `LinuxCNC`'s interpreter, put as geometry: the lead-in ends beside its own
//! end; outside corners are gone round by an arc, by a straight line where the next move is rapid;
//! a turn within the tangent band is no corner, and the next move runs from where the one before
//! ended, a little off its own offset; inserted moves take the feed of the next segment and keep
//! their height.

mod corner;
mod lead;
mod plain;
mod queue;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec2;

use self::corner::{Flank, InsideCorner};
use self::queue::{Pending, Queue, Shape};
use super::{CornerStyle, Options};
use crate::contour::{
    Attributes, Contour, EventKind, Lead, Role, Side, Tool, ToolPath, Transition, TransitionKind,
};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Arc, Curve, direction, perp, turn};

/// How little what is as long as the tool radius may seem longer, by turning inches into mm [mm]; and
/// how much it is longer than one from a table, which the control itself makes a trifle smaller.
const SAME_LENGTH: f64 = 1e-9;

/// Slowest feed of a move whose time is programmed, in units of the program per minute.
const SLOWEST: f64 = 0.1;

/// Seconds in a minute.
const MINUTE: f64 = 60.0;

/// How a program switches compensation on and off, beyond the leads of its contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// The first segment is itself the lead-in: an arc, or all that there is.
    pub leads_in: bool,
    /// The control stops in the middle: the move that waits is never made.
    pub is_cut_off: bool,
    /// From the centre of the tool's tip to the point whose coordinates are programmed, as lathe
    /// tools have it [mm].
    pub tip: DVec2,
    /// The unit of the program [mm].
    pub unit: f64,
    /// The tool radius is from a table, not from the program itself.
    pub is_listed: bool,
}

impl Passage {
    /// The share by which the control makes a radius from a table smaller.
    fn smaller(&self) -> f64 {
        if self.is_listed { 1e-13 } else { 0.0 }
    }
}

impl Default for Passage {
    fn default() -> Self {
        Self { leads_in: false, is_cut_off: false, tip: DVec2::ZERO, unit: 1.0, is_listed: false }
    }
}

/// Why the control stops: a code, and what is wrong.
struct Refused(&'static str, &'static str);

/// The path of `tool` along `contour` with one block of look-ahead, and whether the control makes
/// it to the end; where it stops there is an error.
///
/// A contour without a lead-in begins beside its first segment.
#[must_use]
pub fn look_ahead(
    contour: &Contour,
    tool: Tool,
    options: &Options,
    passage: &Passage,
) -> (ToolPath, bool) {
    let mut control = Control::new(contour, tool, options, *passage);
    if tool.radius() == 0.0 {
        control.as_programmed(contour);
        return (control.queue.path, !passage.is_cut_off);
    }
    let finished = match control.run(contour) {
        Ok(()) => !passage.is_cut_off,
        Err(Refused(code, message)) => {
            control.queue.path.diagnostics.push(
                Diagnostic::error(code, message)
                    .with_origin(control.origin)
                    .with_point(control.programmed)
                    .with_hint("the control stops here, and so does the path"),
            );
            false
        }
    };
    (control.queue.path, finished)
}

/// The state of the control.
struct Control<'a> {
    tool: Tool,
    options: &'a Options,
    passage: Passage,
    queue: Queue,
    /// Where the program is [mm].
    programmed: DVec2,
    /// Where the tool is beside that point while the end of its move is open [mm].
    at: DVec2,
    /// The block in hand.
    origin: Origin,
}

/// A segment as its start and its end are to the tool.
struct Outgoing {
    tangent: DVec2,
    normal: DVec2,
    /// The programmed end [mm].
    end: DVec2,
    /// The end beside it [mm].
    beside: DVec2,
    flank: Flank,
    shape: Shape,
}

impl<'a> Control<'a> {
    fn new(contour: &Contour, tool: Tool, options: &'a Options, passage: Passage) -> Self {
        let start = contour.lead_in().map_or(contour.start(), |lead| lead.point);
        Self {
            tool,
            options,
            passage,
            queue: Queue::new(start, passage.tip, passage.unit),
            programmed: start,
            at: start,
            origin: contour.segments()[0].attributes.origin,
        }
    }

    fn run(&mut self, contour: &Contour) -> Result<(), Refused> {
        let segments = contour.segments();
        let mut leads_in = self.passage.leads_in;
        if let Some(lead) = contour.lead_in() {
            self.lead_in(contour.start(), &lead.attributes)?;
            leads_in = false;
        } else if !leads_in {
            let tangent = segments[0].curve.tangent(0.0);
            self.at += perp(tangent) * self.tool.offset();
            self.queue.begin(self.at);
        }
        let mut events = contour.events().iter().peekable();
        // Full circles of an arc of several turns, and where it starts.
        let (mut turns, mut height, mut time) = (0, 0.0, 0.0);
        for (index, next) in (0..).zip(segments.iter().map(Some).chain([None])) {
            while let Some(event) = events.next_if(|event| event.before <= index) {
                self.origin = event.origin;
                match &event.kind {
                    EventKind::Words(_) => self.queue.words(event),
                    EventKind::Stop => self.flush()?,
                    EventKind::Vertical(attributes) => {
                        let attributes = self.timed(attributes, climb(attributes).abs());
                        let (to, along) = (self.at, DVec2::ZERO);
                        let shape = Shape::Line { along };
                        self.queue.push(Pending { to, shape, attributes, role: Role::Segment });
                    }
                }
            }
            let Some(segment) = next else { break };
            let mut attributes = segment.attributes;
            self.origin = attributes.origin;
            if turns > 0 {
                attributes.heights[0] = height;
                attributes.time = attributes.time.map(|last| last + time);
            }
            // A full circle that the next segment goes on with names a column.
            if let Origin::Block { column: Some(_), .. } = attributes.origin {
                turns += 1;
                height = attributes.heights[0];
                time = attributes.time.unwrap_or(0.0);
                continue;
            }
            let turns = std::mem::take(&mut turns);
            match &segment.curve {
                Curve::Line(line) if leads_in => self.lead_in(line.end(), &attributes)?,
                Curve::Arc(arc) if leads_in => self.arc_lead_in(arc, turns, &attributes)?,
                Curve::Line(line) => {
                    let length = line.length().hypot(climb(&attributes));
                    let attributes = self.timed(&attributes, length);
                    let outgoing = self.line(line.end());
                    self.segment(&outgoing, &attributes)?;
                }
                Curve::Arc(arc) => {
                    let length = helix(arc, turns, &attributes);
                    let attributes = self.timed(&attributes, length);
                    let outgoing = self.arc(arc, turns)?;
                    self.segment(&outgoing, &attributes)?;
                }
                Curve::Spline(_) | Curve::Involute(_) => return self.refuse_curve(&attributes),
            }
            leads_in = false;
        }
        if self.passage.is_cut_off {
            return Ok(());
        }
        if let Some(Lead { attributes, .. }) = contour.lead_out() {
            self.origin = attributes.origin;
        }
        self.flush()?;
        if let Some(Lead { point, attributes }) = contour.lead_out() {
            let length = self.programmed.distance(*point).hypot(climb(attributes));
            let attributes = self.timed(attributes, length);
            self.queue.lead_out(*point, attributes);
        }
        Ok(())
    }

    fn refuse_curve(&mut self, attributes: &Attributes) -> Result<(), Refused> {
        self.origin = attributes.origin;
        Err(Refused("spline-refused", "the control does not compensate splines"))
    }

    /// The end of what waits stays as it is.
    fn flush(&mut self) -> Result<(), Refused> {
        self.queue.end_at(self.at)?;
        self.queue.release();
        Ok(())
    }

    fn line(&self, end: DVec2) -> Outgoing {
        let along = end - self.programmed;
        let tangent = along.normalize_or_zero();
        let normal = perp(tangent) * self.tool.side().sign();
        Outgoing {
            tangent,
            normal,
            end,
            beside: end + normal * self.tool.radius(),
            flank: Flank::Line,
            shape: Shape::Line { along },
        }
    }

    fn arc(&self, arc: &Arc, turns: u32) -> Result<Outgoing, Refused> {
        let (end, center, clockwise) = (arc.end(), arc.center(), arc.is_clockwise());
        let (radius, is_inside) = (self.tool.radius(), self.is_inside(clockwise));
        let end_radius = center.distance(end);
        if is_inside && end_radius <= self.least_length() {
            return Err(TOO_TIGHT);
        }
        // From the tool into the part, where the tool is outside.
        let to_tool = if is_inside { 1.0 } else { -1.0 };
        let normal = direction(center - self.programmed).ok_or(TOO_TIGHT)? * to_tool;
        Ok(Outgoing {
            tangent: perp(normal) * -self.tool.side().sign(),
            normal,
            end,
            beside: end + (center - end) * (to_tool * radius / end_radius),
            flank: Flank::Arc {
                center,
                radius: end_radius - to_tool * radius,
                clockwise,
                is_inside,
            },
            shape: Shape::Arc { center, clockwise, sweep: arc.sweep(), turns },
        })
    }

    /// What has to be longer than the tool radius is longer than this [mm].
    fn least_length(&self) -> f64 {
        let more = match self.passage {
            Passage { is_listed: true, .. } => -SAME_LENGTH,
            Passage { unit, .. } if unit <= 1.0 => 0.0,
            Passage { .. } => SAME_LENGTH,
        };
        self.tool.radius() + more
    }

    /// Whether the tool is on the inside of an arc.
    fn is_inside(&self, clockwise: bool) -> bool {
        (self.tool.side() == Side::Left) != clockwise
    }

    /// A segment that is not the lead-in.
    fn segment(&mut self, outgoing: &Outgoing, attributes: &Attributes) -> Result<(), Refused> {
        let corner = self.programmed;
        let incoming_normal = (self.at - corner) / self.tool.radius();
        let sign = self.tool.side().sign();
        let incoming = perp(incoming_normal) * -sign;
        // How far the contour turns away from the tool, from a quarter turn towards it on.
        let mut away = -sign * turn(incoming, outgoing.tangent);
        if away < -FRAC_PI_2 {
            away += TAU;
        }
        let band = self.options.band(self.tool.radius());
        let before = self.queue.front().map(|shape| self.flank(&shape));
        let turns_back = (away - PI).abs() < band;
        let is_concave = away < -band
            || away > PI + band
            || match (&outgoing.flank, &before) {
                // Back along a wall that an arc has come up to from outside, or the other way round:
                // the tool stays above the arc.
                (Flank::Arc { is_inside, .. }, _) => turns_back && !is_inside,
                (Flank::Line, Some(Flank::Arc { is_inside, .. })) => {
                    away > PI - band && !is_inside && self.queue.is_waiting()
                }
                (Flank::Line, _) => false,
            };
        if let Some(before) = before {
            if is_concave {
                let inside = InsideCorner {
                    point: corner,
                    // What it just touches it then meets.
                    tool_radius: self.tool.radius() * (1.0 - self.passage.smaller()),
                    tangents: [incoming, outgoing.tangent],
                    normals: [incoming_normal, outgoing.normal],
                };
                let met = inside.meet([before, outgoing.flank])?;
                self.queue.end_at(met)?;
                self.transition(TransitionKind::Shortened, away, corner, ("V", met), attributes);
            } else if away > band {
                if matches!(outgoing.flank, Flank::Line) {
                    self.queue.end_at(self.at)?;
                } else {
                    self.queue.release();
                }
                self.go_round(away, outgoing, attributes);
            } else {
                self.queue.release();
                self.queue.begin(self.at);
            }
        }
        (self.programmed, self.at) = (outgoing.end, outgoing.beside);
        self.queue.push(Pending {
            to: outgoing.beside,
            shape: outgoing.shape,
            attributes: *attributes,
            role: Role::Segment,
        });
        Ok(())
    }

    /// What waits as an inside corner sees it.
    fn flank(&self, shape: &Shape) -> Flank {
        match *shape {
            Shape::Line { .. } => Flank::Line,
            Shape::Arc { center, clockwise, .. } => Flank::Arc {
                center,
                radius: center.distance(self.at),
                clockwise,
                is_inside: self.is_inside(clockwise),
            },
        }
    }

    /// Round an outside corner, to beside the start of the next segment.
    fn go_round(&mut self, away: f64, outgoing: &Outgoing, attributes: &Attributes) {
        let (corner, radius) = (self.programmed, self.tool.radius());
        let (from, to) = (self.at, corner + outgoing.normal * radius);
        let heights = [attributes.heights[0]; 2];
        let between = Attributes { heights, ..*attributes };
        let straight = |to| {
            let (shape, role) = (Shape::Line { along: DVec2::ZERO }, Role::Transition);
            Pending { to, shape, attributes: between, role }
        };
        let kind =
            if away > FRAC_PI_2 { TransitionKind::Inserted } else { TransitionKind::Elongated };
        self.transition(kind, away, corner, ("N2", to), attributes);
        if attributes.rapid {
            self.queue.push(straight(to));
        } else if self.options.corner == CornerStyle::Arc {
            let clockwise = self.tool.side() == Side::Left;
            let sweep = if clockwise { -away } else { away };
            let shape = Shape::Arc { center: corner, clockwise, sweep, turns: 0 };
            self.queue.push(Pending { to, shape, attributes: between, role: Role::Transition });
        } else {
            let n1 = from - corner;
            if kind == TransitionKind::Elongated {
                let sum = n1 + (to - corner);
                let scale = 2.0 * radius * radius / sum.length_squared();
                self.queue.push(straight(corner + sum * scale));
            } else {
                let sign = self.tool.side().sign();
                self.queue.push(straight(from - perp(n1) * sign));
                self.queue.push(straight(to + perp(to - corner) * sign));
            }
            self.queue.push(straight(to));
        }
        self.queue.release();
        self.queue.begin(to);
    }

    fn transition(
        &mut self,
        kind: TransitionKind,
        away: f64,
        corner: DVec2,
        last: (&'static str, DVec2),
        attributes: &Attributes,
    ) {
        let angle = PI - away;
        let angle = if angle < 0.0 { angle + TAU } else { angle };
        self.queue.path.transitions.push(Transition {
            kind,
            angle,
            corner,
            construction: vec![("P", corner), ("N1", self.at), last],
            origin: attributes.origin,
        });
    }

    /// The attributes with the feed that a programmed time makes of a programmed `length` [mm]: what
    /// compensation adds or takes away is not counted.
    fn timed(&self, attributes: &Attributes, length: f64) -> Attributes {
        let mut attributes = *attributes;
        if let Some(time) = attributes.time.take() {
            attributes.feed = Some((length / time).max(SLOWEST * self.passage.unit / MINUTE));
        }
        attributes
    }
}

/// The tool is wider than the arc that it is inside of.
const TOO_TIGHT: Refused = Refused("arc-refused", "the tool does not fit into the arc");

/// How much a move changes its height [mm].
fn climb(attributes: &Attributes) -> f64 {
    attributes.heights[1] - attributes.heights[0]
}

/// Length of an arc or helix as programmed, after as many full circles [mm].
fn helix(arc: &Arc, turns: u32, attributes: &Attributes) -> f64 {
    (arc.length() + f64::from(turns) * TAU * arc.radius()).hypot(climb(attributes))
}

/// How far an arc turns from one radius to the other, positive counter-clockwise; all round where
/// they are the same [rad].
fn swept(from: DVec2, to: DVec2, clockwise: bool) -> f64 {
    let turned = turn(from, to);
    match clockwise {
        false if turned <= 0.0 => turned + TAU,
        true if turned >= 0.0 => turned - TAU,
        _ => turned,
    }
}
