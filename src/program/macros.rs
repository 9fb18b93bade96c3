//! FANUC's calls: M98 and M99 of subprograms, G65 of macros with arguments; Haas' M97, of blocks in the
//! program itself.

use super::block::Word;
use super::flow::Destination;
use super::number::whole;
use super::outline::{Outline, Step};
use super::parameters::{LOCALS, Locals, UNSET};
use super::run::{Place, Runner};

/// The parameters that a macro has for itself: #1 to #33.
const ARGUMENTS: usize = 33;

/// Letters of arguments, at the places of the parameters that they set, from #1; G, L, N, O and P have
/// other meanings.
const LETTERS: &[u8; 26] = b"ABCIJKDEF H M   QRSTUVWXYZ";

/// In the old form of up to four digits, what stands before them tells how often.
const OLD_FORM: u32 = 10_000;

/// A call of a program, with arguments where it is a macro.
#[derive(Debug, Clone)]
pub(super) struct ProgramCall {
    number: Option<u32>,
    /// The number is that of a block of the same program.
    is_block: bool,
    times: Option<u32>,
    arguments: Option<Box<Locals>>,
    column: u32,
}

/// A word that calls or returns.
#[derive(Debug)]
pub(super) enum Call {
    /// M97, M98 and, with arguments, G65.
    Program(ProgramCall),
    /// G66: the same after each block that moves, until G67.
    Modal(ProgramCall),
    /// M99, to a block of the caller if it says so.
    Return { to: Option<Word> },
}

/// Whether an M word calls or returns; `LinuxCNC` has no M97.
pub(super) fn calls(number: f64, is_strict: bool) -> bool {
    matches!(whole(number), Some(98 | 99)) || number == 97.0 && !is_strict
}

impl Runner {
    /// Takes the call or return with its words out of the block.
    pub(super) fn take_call(&mut self) -> Option<Call> {
        let words = &mut self.block.words;
        let strict = self.options.rules.is_strict;
        let is_call = |w: &Word| match w.letter {
            'G' => matches!(whole(w.value), Some(65..=67)),
            'M' => calls(w.value, strict),
            _ => false,
        };
        let index = words.iter().position(is_call)?;
        let word = *words.get(index)?;
        let mut arguments = None;
        let mut taken = |letter: char| {
            let index = words.iter().position(|word| word.letter == letter)?;
            Some(words.remove(index))
        };
        if word.value == 67.0 {
            words.remove(index);
            self.modal_call = None;
            return None;
        }
        if word.value == 99.0 {
            let to = taken('P');
            taken('L');
            self.block.words.retain(|word| !is_call(word));
            return Some(Call::Return { to });
        }
        let mut number = taken('P').and_then(|word| whole(word.value));
        let mut is_block = word.letter == 'M' && word.value == 97.0;
        if number.is_none() && word.letter == 'M' && !strict {
            // M98 H.
            number = taken('H').and_then(|word| whole(word.value));
            is_block = true;
        }
        let times = taken('L').and_then(|word| whole(word.value));
        if word.letter == 'G' {
            let index = self.block.words.iter().position(is_call)?;
            arguments = Some(self.arguments(index + 1));
            self.block.words.truncate(index);
        } else {
            self.block.words.retain(|word| !is_call(word));
        }
        let call = ProgramCall { number, is_block, times, arguments, column: word.column };
        Some(if word.value == 66.0 { Call::Modal(call) } else { Call::Program(call) })
    }

    /// The parameters that the words from `first` on set. I, J and K may come several times; each
    /// group of them sets the next three.
    fn arguments(&mut self, first: usize) -> Box<Locals> {
        let mut locals = Box::new([UNSET; LOCALS]);
        let (mut group, mut last) = (0, 0);
        for word in self.block.words.get(first..).unwrap_or_default() {
            let place = LETTERS.iter().position(|letter| char::from(*letter) == word.letter);
            let Some(mut number) = place.map(|place| place + 1) else {
                let message = format!("the word {} is no argument of a macro", word.letter);
                let origin = self.block.origin_at(word.column);
                let hint = "it is left out";
                self.interpreter.report.error("word-not-understood", message, origin, hint);
                continue;
            };
            if matches!(word.letter, 'I' | 'J' | 'K') {
                group += usize::from(number <= last) * 3;
                last = number;
                number += group;
            }
            if let Some(local) = locals.get_mut(number) {
                *local = word.value;
            }
        }
        locals
    }

    /// Calls a subprogram, or returns from one.
    pub(super) fn call(&mut self, outline: &Outline, call: &Call) {
        match call {
            Call::Modal(call) => self.modal_call = Some(Box::new(call.clone())),
            Call::Program(ProgramCall { number, is_block, times, arguments, column }) => {
                let arguments = arguments.as_deref().map(|locals| (locals, ARGUMENTS));
                let found = match *number {
                    Some(number) if *is_block => {
                        self.calls_blocks = true;
                        let start = self.find_block(outline, f64::from(number));
                        start.map(|start| (start, times.unwrap_or(1)))
                    }
                    number => self.find_program(outline, number, *times),
                };
                let Some((start, times)) = found else {
                    let letter = if *is_block { 'N' } else { 'O' };
                    let name = number.map_or(String::from("without a number (P)"), |number| {
                        format!("{letter}{number}")
                    });
                    return self.no_subprogram(&name, *column);
                };
                if times > 0 {
                    self.enter(start, times, arguments, false);
                }
            }
            Call::Return { to } => {
                if self.frames.is_empty() {
                    if to.is_none() {
                        // In the main program it starts again from the beginning, without end.
                        let hint = "the program is run once";
                        let origin = self.block.origin();
                        let message = "M99 repeats the program without end";
                        self.interpreter.report.warning("endless-program", message, origin, hint);
                        self.end(true);
                    }
                } else {
                    if to.is_some()
                        && let Some(frame) = self.frames.last_mut()
                    {
                        frame.further = 0;
                    }
                    self.leave();
                }
                if let Some(word) = to {
                    self.go_to(outline, Destination::Number(word.value), word.column, "");
                }
            }
        }
    }

    /// After a block that moves, the macro of G66 is called; its own moves call none.
    pub(super) fn call_modal(&mut self, outline: &Outline) {
        let Some(call) = &self.modal_call else { return };
        if self.frames.iter().any(|frame| frame.is_modal) {
            return;
        }
        let (call, depth) = (Call::Program((**call).clone()), self.frames.len());
        self.call(outline, &call);
        if self.frames.len() > depth
            && let Some(frame) = self.frames.last_mut()
        {
            frame.is_modal = true;
        }
    }

    /// The first block of a program, and how often it is to be run: P and L, or the number's digits
    /// before the last four.
    fn find_program(
        &mut self,
        outline: &Outline,
        number: Option<u32>,
        times: Option<u32>,
    ) -> Option<(Place, u32)> {
        let mut number = number?;
        let mut times = times.unwrap_or(1);
        let (mut found, mut looked_at) = outline.find(Step::Program, &number.to_string());
        if found.is_none() && number >= OLD_FORM {
            (number, times) = (number % OLD_FORM, number / OLD_FORM);
            let further;
            (found, further) = outline.find(Step::Program, &number.to_string());
            looked_at += further;
        }
        self.count_labels(looked_at);
        let index = found?;
        let mark = outline.marks.get(index)?;
        Some((Place { at: mark.at, line: mark.line, mark: index }, times))
    }
}
