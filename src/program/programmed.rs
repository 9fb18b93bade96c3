//! A program as it is programmed: its contours with the words that leave compensation to the control
//! that will run it.

use glam::DVec2;

use super::arcs::CENTER;
use super::auxiliary::append_word;
use super::items::{ContourEnd, Item, ProgrammedContour, RadiusSource};
use super::number::push_word;
use super::run::Interpretation;
use crate::contour::{
    Attributes, AuxiliaryWords, CornerWish, EventKind, Lead, Move, MoveCurve, Role, Side, ToolPath,
};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Curve, Line, turn};

/// Length of the vector that tells a direction [mm]: rounded to micrometres it is exact enough.
const VECTOR: f64 = 10.0;

/// Turns below this are no corners [rad].
const LEAST_TURN: f64 = 0.01;

/// The path of the programmed contours themselves, G41 or G42 before each and G40 behind it, for a
/// control that compensates itself ([`emit`](super::emit) writes it).
#[must_use]
pub fn programmed_path(interpretation: &Interpretation) -> ToolPath {
    let mut path = ToolPath::default();
    path.diagnostics.clone_from(&interpretation.diagnostics);
    for item in &interpretation.items {
        match item {
            Item::Free(free) => path.moves.push(*free),
            Item::Words { words, reset, origin } => path.words.push(AuxiliaryWords {
                before: path.moves.len(),
                words: words.clone(),
                reset: *reset,
                origin: *origin,
            }),
            Item::Contour(programmed) => contour(programmed, &mut path),
        }
    }
    path
}

fn contour(programmed: &ProgrammedContour, path: &mut ToolPath) {
    let contour = &programmed.contour;
    let origin = |line| Origin::Block { line, number: None, column: None };
    let (on, off) = (origin(programmed.blocks[0]), origin(programmed.blocks[1]));
    words(path, switch_on(programmed), on);
    if let Some(lead) = contour.lead_in() {
        lead_move(path, lead, Role::LeadIn, |lead| Line::new(lead, contour.start()));
    }
    let mut events = contour.events().iter().peekable();
    // A segment on which the radius changes is told by the contour that follows.
    let tapers = programmed.end == ContourEnd::Tapers;
    let segments = &contour.segments()[..contour.segments().len() - usize::from(tapers)];
    for index in 0..=segments.len() {
        while let Some(event) = events.next_if(|event| event.before <= index) {
            match &event.kind {
                EventKind::Words(text) => words(path, text.clone(), event.origin),
                EventKind::Vertical(attributes) => {
                    let at = match index.checked_sub(1).and_then(|i| contour.segments().get(i)) {
                        Some(segment) => segment.curve.end(),
                        None => contour.start(),
                    };
                    push(path, MoveCurve::Vertical(at), Role::Segment, attributes);
                }
                EventKind::Stop => {}
            }
        }
        let Some(segment) = segments.get(index) else { break };
        corner(programmed, index, path);
        match &segment.curve {
            Curve::Line(line) => {
                push(path, MoveCurve::Line(*line), Role::Segment, &segment.attributes);
            }
            Curve::Arc(arc) => push(path, MoveCurve::Arc(*arc), Role::Segment, &segment.attributes),
            Curve::Involute(involute) => {
                push(path, MoveCurve::Involute(*involute), Role::Segment, &segment.attributes);
            }
            Curve::Spline(spline) => {
                for cubic in spline.pieces() {
                    push(path, MoveCurve::Cubic(*cubic), Role::Segment, &segment.attributes);
                }
            }
        }
    }
    if tapers {
        return;
    }
    let mut text = String::from("G40");
    if let Some(wall) = contour.wall() {
        let [first, second, _] = contour.segments()[0].attributes.plane.axes();
        append_word(&mut text, CENTER[first], wall.x);
        append_word(&mut text, CENTER[second], wall.y);
    }
    words(path, text, off);
    if programmed.allowance != 0.0 {
        let message = "the allowance (OFFN) is left out: the control will not know it";
        path.diagnostics.push(
            Diagnostic::error("left-out", message)
                .with_origin(on)
                .with_hint("add it to the radius of the tool on the machine"),
        );
    }
    if let Some(lead) = contour.lead_out() {
        lead_move(path, lead, Role::LeadOut, |lead| Line::new(contour.end(), lead));
    }
}

/// What is asked of the corner at the start of a segment: FANUC's G39 asks for an arc.
fn corner(programmed: &ProgrammedContour, index: usize, path: &mut ToolPath) {
    let contour = &programmed.contour;
    let segments = contour.segments();
    let Attributes { wish, origin, plane, .. } = segments[index].attributes;
    let before = match index.checked_sub(1) {
        Some(before) => segments[before].curve.tangent(1.0),
        None => contour.lead_in().map_or(DVec2::ZERO, |lead| contour.start() - lead.point),
    };
    let along = segments[index].curve.tangent(0.0);
    let left = programmed.side == Side::Left;
    let turned = if left { -turn(before, along) } else { turn(before, along) };
    // Only outside corners are gone round.
    if turned < LEAST_TURN {
        return;
    }
    match wish.corner {
        CornerWish::AsChosen | CornerWish::Linear => {}
        CornerWish::Arc => {
            let mut text = String::from("G39");
            let [first, second, _] = plane.axes();
            append_word(&mut text, CENTER[first], VECTOR * along.x);
            append_word(&mut text, CENTER[second], VECTOR * along.y);
            words(path, text, origin);
        }
        CornerWish::Conic(_) | CornerWish::Intersection => {
            let message = "how the corner is gone round (G450, G451) is left out";
            let hint = "the control does it in its own way";
            let found = Diagnostic::warning("left-out", message);
            path.diagnostics.push(found.with_origin(origin).with_hint(hint));
        }
    }
}

/// The words that switch compensation on.
fn switch_on(programmed: &ProgrammedContour) -> String {
    let left = programmed.side == Side::Left;
    let mut text = String::new();
    match programmed.radius {
        RadiusSource::Tool(number) => {
            text.push_str(if left { "G41 " } else { "G42 " });
            push_word(&mut text, 'D', f64::from(number));
        }
        RadiusSource::Given(radius) => {
            text.push_str(if left { "G41.1 " } else { "G42.1 " });
            push_word(&mut text, 'D', 2.0 * radius);
        }
    }
    text
}

fn words(path: &mut ToolPath, words: String, origin: Origin) {
    path.words.push(AuxiliaryWords { before: path.moves.len(), words, reset: None, origin });
}

fn lead_move<E>(
    path: &mut ToolPath,
    lead: &Lead,
    role: Role,
    line: impl Fn(DVec2) -> Result<Line, E>,
) {
    let curve = line(lead.point).map_or(MoveCurve::Vertical(lead.point), MoveCurve::Line);
    push(path, curve, role, &lead.attributes);
}

fn push(path: &mut ToolPath, curve: MoveCurve, role: Role, attributes: &Attributes) {
    let Attributes { origin, feed, rapid, plane, heights, .. } = *attributes;
    path.moves.push(Move { curve, role, rapid, feed, plane, heights, origin });
}
