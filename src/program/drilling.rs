//! SINUMERIK's drilling cycles, expanded: CYCLE81, CYCLE82 and CYCLE83, and MCALL.
//!
//! Siemens, SINUMERIK 840D/840Di/810D, Programming Guide Cycles 11/2002, section 2.1: arguments,
//! sequence of moves, and the steps of deep holes. A cycle drills where the tool is; after MCALL it does
//! so behind every block that moves in the plane.

use super::auxiliary::word as text_of;
use super::axes::Axes;
use super::block::Block;
use super::cycles::Hole;
use super::interpret::Interpreter;
use super::lexer::LineReader;
use super::spline_words::place_in;
use super::words::Words;
use crate::geometry::MIN_LENGTH;

/// Most steps of one hole.
const MOST: f64 = 1e4;

/// How far a step of chip breaking goes back unless an argument says so [mm].
const CHIP_RETRACT: f64 = 1.0;

/// How far above the bottom the next step of a deep hole begins, up to 30 mm of depth [mm].
const CLEARANCE: f64 = 0.6;

/// What a cycle does to every hole, in the order of its arguments [mm, s].
#[derive(Debug, Clone, Copy)]
pub(super) struct Drill {
    number: usize,
    /// NaN for those that are left out.
    arguments: [f64; 17],
}

impl LineReader<'_> {
    /// MCALL and the cycles that are read; false for others.
    pub(super) fn drilling_cycle(&mut self, name: &str, from: usize) -> bool {
        let at = self.cursor.at();
        let is_modal = name.eq_ignore_ascii_case("MCALL");
        let mut cycle = name;
        if is_modal {
            self.interpreter.modal.drill = None;
            if matches!(self.cursor.peek(), None | Some(b';')) {
                return true;
            }
            cycle = self.cursor.identifier();
        }
        let Some(number) = place_in("CYCLE81 CYCLE82 CYCLE83", cycle) else {
            if is_modal {
                self.unknown_name(cycle, at);
            }
            return is_modal;
        };
        let mut drill = Drill { number: 81 + number, arguments: [f64::NAN; 17] };
        match self.call_arguments() {
            Ok(values) => {
                for (argument, value) in drill.arguments.iter_mut().zip(values) {
                    *argument = value;
                }
                self.interpreter.modal.drill = Some(drill);
                self.push('i', f64::from(u8::from(is_modal)), from);
            }
            Err(fault) => self.report_fault(&fault, from, "no hole is made"),
        }
        true
    }
}

impl Interpreter {
    /// A hole where the block has led to, if it asks for one, or `moved` after MCALL.
    pub(super) fn drill(&mut self, block: &Block, words: &mut Words, moved: bool) {
        let Some(Drill { number, arguments }) = self.modal.drill else { return };
        match words.take('i') {
            Some(word) if word.value != 0.0 => return,
            Some(_) => self.modal.drill = None,
            None if !moved => return,
            None => {}
        }
        let unit = self.modal.unit();
        let mut given = arguments;
        for (i, value) in given.iter_mut().enumerate() {
            // Times and kinds are no lengths.
            *value = match i {
                _ if value.is_nan() => 0.0,
                8..=12 | 15.. => *value,
                _ => *value * unit,
            };
        }
        let [up, reference, aside, bottom, depth, first_at, first, less, at_bottom, ..] = given;
        let [.., at_top, _, out, _, least, back, _, _] = given;
        // Depths that count from the reference plane go before those that do not.
        let bottom = if depth == 0.0 { bottom } else { reference - depth.abs() };
        let told = |i: usize| !arguments.get(i).is_none_or(|value| value.is_nan());
        let first = match first.abs() {
            0.0 if told(5) => reference - first_at,
            first => first,
        };
        let retract = reference + aside.abs();
        let possible =
            (depth != 0.0 || told(3)) && bottom < retract && !self.modal.feed.is_inverse_time();
        if !possible || self.course.switched().is_some() {
            let message = format!("CYCLE{number} is not possible here");
            let hint = "it needs G40, no G93, and a depth below its reference plane";
            return self.error("cycle-not-possible", message, block.start(), hint);
        }
        let at = self.modal.frame.unmap(self.modal.position);
        let hole = Hole { block, at, retract, bottom, clear: up.max(retract) };
        let mut down = Axes::default();
        down.words[self.modal.plane.axes()[2]] = block.words.first();
        self.cycle_to(block, &down, at, retract, true);
        let mut dwell = if number == 82 { first_at / unit } else { 0.0 };
        if number == 83 {
            dwell = at_bottom;
            let first = if first > 0.0 { first } else { reference - bottom };
            let back = if back == 0.0 { CHIP_RETRACT } else { back.abs() };
            let back = if out == 0.0 { Some(back) } else { None };
            self.steps(&hole, [reference, first, less, least], [dwell, at_top], back);
        }
        self.go(&hole, bottom, false);
        self.wait(&hole, dwell);
        self.go(&hole, hole.clear, true);
    }

    /// The steps of a deep hole but the last: the `first`, then each shorter than the one before by
    /// `less` or, where that is negative, by its factor, but never than that or the `least`. Between
    /// them it goes `back` a little, or else out of the hole.
    fn steps(
        &mut self,
        hole: &Hole,
        [from, first, less, least]: [f64; 4],
        [at_bottom, at_top]: [f64; 2],
        back: Option<f64>,
    ) {
        let least = if less == 0.0 { first } else { least.max(less).min(first) };
        let count = (from - hole.bottom) / least;
        if !count.lt(&MOST) {
            let message = "the steps of the cycle are too small";
            let hint = "give DAM, or for a factor the least step too; the hole is made in one step";
            return self.error("bad-peck", message, hole.block.start(), hint);
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
        if !self.may_expand(hole.block, count as u32) {
            return;
        }
        let clearance = ((from - hole.bottom) / 50.0).clamp(CLEARANCE, 7.0);
        let (mut depth, mut step) = (from - first, first);
        while depth > hole.bottom + MIN_LENGTH {
            self.go(hole, depth, false);
            self.wait(hole, at_bottom);
            if let Some(back) = back {
                self.go(hole, depth + back, false);
            } else {
                self.go(hole, hole.retract, true);
                self.wait(hole, at_top);
                self.go(hole, depth + clearance, true);
            }
            let shorter = if less < 0.0 { step * -less / self.modal.unit() } else { step - less };
            step = shorter.min(step).max(least);
            let rest = depth - hole.bottom;
            if less > 0.0 && rest > step && rest < 2.0 * step {
                step = 0.5 * rest;
            }
            depth -= step;
        }
    }

    pub(super) fn wait(&mut self, hole: &Hole, seconds: f64) {
        if seconds > 0.0 {
            self.say(hole, &format!("G4 {}", text_of('P', seconds)));
        }
    }
}
