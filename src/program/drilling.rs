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

impl Drill {
    /// An argument, counted from 0, that was given and is not 0.
    fn given(&self, i: usize) -> Option<f64> {
        self.arguments.get(i).copied().filter(|value| value.is_finite() && *value != 0.0)
    }
}

impl Interpreter {
    /// A hole where the block has led to, if it asks for one, or `moved` after MCALL.
    pub(super) fn drill(&mut self, block: &Block, words: &mut Words, moved: bool) {
        let Some(drill) = self.modal.drill else { return };
        match words.take('i') {
            Some(word) if word.value != 0.0 => return,
            Some(_) => self.modal.drill = None,
            None if !moved => return,
            None => {}
        }
        let unit = self.modal.unit();
        let plane = |i: usize| drill.arguments.get(i).map_or(f64::NAN, |value| value * unit);
        let length = |i: usize| drill.given(i).map(|value| value * unit);
        // Depths that count from the reference plane go before those that do not.
        let reference = plane(1);
        let depth = |i: usize| length(i + 1).map_or(plane(i), |depth| reference - depth.abs());
        let (bottom, retract) = (depth(3), reference + length(2).unwrap_or(0.0).abs());
        let clear = plane(0).max(retract);
        let compensates = self.course.switched().is_some();
        if compensates || self.modal.feed.is_inverse_time() || !bottom.lt(&retract) {
            let message = format!("CYCLE{} is not possible here", drill.number);
            let hint = "it needs G40, no G93, and a depth below its reference plane";
            return self.error("cycle-not-possible", message, block.start(), hint);
        }
        let at = self.modal.frame.unmap(self.modal.position);
        let hole = Hole { block, at, retract, bottom, clear };
        let mut down = Axes::default();
        down.words[self.modal.plane.axes()[2]] = block.words.first();
        self.cycle_to(block, &down, at, retract, true);
        let mut dwell = drill.given(5);
        if drill.number == 83 {
            dwell = drill.given(8);
            let first = reference - depth(5);
            let first = if first > 0.0 { first } else { reference - bottom };
            self.steps(&hole, &drill, [reference, first], dwell);
        }
        self.go(&hole, bottom, false);
        if drill.number > 81 {
            self.wait(&hole, dwell);
        }
        self.go(&hole, clear, true);
    }

    /// The steps of a deep hole but the last: the first, then each shorter than the one before.
    fn steps(&mut self, hole: &Hole, drill: &Drill, [from, first]: [f64; 2], dwell: Option<f64>) {
        let unit = self.modal.unit();
        let less = drill.given(7).unwrap_or(0.0);
        let least = drill.given(13).map_or(0.0, |least| least * unit).max(less * unit);
        let least = if less == 0.0 { first } else { least.min(first) };
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
        let back = drill.given(14).map_or(CHIP_RETRACT, |back| back.abs() * unit);
        let clearance = ((from - hole.bottom) / 50.0).clamp(CLEARANCE, 7.0);
        let (mut depth, mut step) = (from - first, first);
        while depth > hole.bottom + MIN_LENGTH {
            self.go(hole, depth, false);
            self.wait(hole, dwell);
            if drill.given(11).is_some() {
                self.go(hole, hole.retract, true);
                self.wait(hole, drill.given(9));
                self.go(hole, depth + clearance, true);
            } else {
                self.go(hole, depth + back, false);
            }
            // By an amount, or by a factor.
            let shorter = if less < 0.0 { step * -less } else { step - less * unit };
            step = shorter.min(step).max(least);
            let rest = depth - hole.bottom;
            if less > 0.0 && rest > step && rest < 2.0 * step {
                step = 0.5 * rest;
            }
            depth -= step;
        }
    }

    pub(super) fn wait(&mut self, hole: &Hole, seconds: Option<f64>) {
        if let Some(seconds) = seconds.filter(|seconds| *seconds > 0.0) {
            self.say(hole, &format!("G4 {}", text_of('P', seconds)));
        }
    }
}
