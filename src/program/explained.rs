//! Why a move that was not programmed is there, as a comment before it.

use std::f64::consts::PI;

use crate::contour::{Move, Role, Transition, TransitionKind};
use crate::geometry::Decimal;

/// How many transitions are looked through for the one of a move. They stand in the order of the
/// moves, and those in between have inserted nothing.
const LOOK_AHEAD: usize = 200;

/// The transitions of a path as its moves come by.
#[derive(Debug)]
pub(super) struct Explanations<'a> {
    transitions: &'a [Transition],
    /// The move before.
    last: Option<&'a Move>,
}

impl<'a> Explanations<'a> {
    pub(super) fn new(transitions: &'a [Transition]) -> Self {
        Self { transitions, last: None }
    }

    /// Why `next` is there, if that is not programmed and was not said at the move before.
    pub(super) fn why(&mut self, next: &'a Move) -> Option<String> {
        let last = self.last.replace(next);
        if last.is_some_and(|last| (last.role, last.origin) == (next.role, next.origin)) {
            return None;
        }
        match next.role {
            Role::Segment | Role::Free => None,
            Role::LeadIn => Some("lead-in: compensation is switched on".into()),
            Role::LeadOut => Some("lead-out: compensation is switched off".into()),
            Role::Link => Some("link: to the next pass".into()),
            Role::Transition => Some(self.transition(next)),
        }
    }

    fn transition(&mut self, next: &Move) -> String {
        let of_corner =
            |t: &Transition| t.origin == next.origin && t.kind != TransitionKind::Shortened;
        let found = self.transitions.iter().take(LOOK_AHEAD).position(of_corner);
        let Some((index, transition)) = found.and_then(|i| Some((i, self.transitions.get(i)?)))
        else {
            return "joins two pieces of the path: what lay between does not fit".into();
        };
        self.transitions = &self.transitions[index + 1..];
        let kind = match transition.kind {
            TransitionKind::Shortened => "shortened",
            TransitionKind::Elongated => "elongated",
            TransitionKind::Inserted => "inserted",
        };
        let [x, y] = transition.corner.to_array().map(Decimal::of);
        let [first, second, _] = next.plane.axes().map(|axis| ["X", "Y", "Z"][axis]);
        let angle = Decimal::new(transition.angle * 180.0 / PI, 1);
        format!("{kind}: corner of {angle} deg at {first}{x} {second}{y}")
    }
}
