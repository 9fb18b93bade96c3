//! What changes the order of blocks: O words, FANUC's loops, GOTO, the end of a subprogram.

use super::cursor::Cursor;
use super::outline::{Outline, Step};
use super::parameters::{LOCALS, Locals};
use super::run::{Frame, Place, Repetition, Runner};
use crate::geometry::sort_long;

/// How many labels are looked at in the time of a block.
const LABELS_A_BLOCK: usize = 20;

/// The parameters that a subprogram of RS274/NGC has for itself: #1 to #30.
const ARGUMENTS: usize = 30;

/// Most repetitions; the bounds of the run end them earlier.
const MOST_TIMES: f64 = 1e9;

/// From where to where a name reaches in its line [bytes].
pub(super) type Span = [usize; 2];

/// Where a GOTO leads to.
#[derive(Debug, Clone, Copy)]
pub(super) enum Destination {
    /// The block with a number.
    Number(f64),
    /// SINUMERIK's block with a label, or a number behind N.
    Label(Span, Search),
    /// SINUMERIK's subprogram, whose arguments stand behind its name.
    Program(Span),
    /// SINUMERIK's section of the program between labels, the last included, once more; without one
    /// the block of the first where it `is_block`, else up to here.
    Section { labels: [Span; 2], is_block: bool, times: u32 },
    /// Back from SINUMERIK's subprogram.
    Return,
}

/// Where the block is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Search {
    Down,
    Up,
    DownThenUp,
}

/// What stands behind an O word.
struct Arguments {
    holds: bool,
    value: Option<f64>,
    locals: Locals,
}

impl Runner {
    /// Runs a line that is a mark of the outline.
    pub(super) fn flow(&mut self, outline: &Outline, here: Place, text: &str) {
        let Some(&mark) = outline.marks.get(here.mark) else { return };
        if matches!(mark.step, Step::For | Step::EndFor) {
            return self.count_loop(outline, here);
        }
        let has_condition =
            matches!(mark.step, Step::If | Step::ElseIf | Step::While | Step::Until)
                || mark.step == Step::LoopStart && mark.after != usize::MAX;
        // A branch that is reached from above ends the condition, whatever it would ask.
        let asks = has_condition && mark.step != Step::ElseIf;
        let Some(Arguments { holds, value, locals }) = self.arguments_of(outline, here, text, asks)
        else {
            return;
        };
        if !self.block.comments.is_empty() {
            self.run_block();
        }
        let partner = outline.partner(here.mark);
        match mark.step {
            Step::Call => self.call_sub(outline, here, &locals),
            Step::EndSub | Step::Return => self.end_sub(value),
            Step::Sub => self.jump_behind(outline, partner),
            Step::If if !holds => self.next_branch(outline, partner),
            Step::ElseIf | Step::Else => {
                let mut end = partner;
                while let Some(index) = end
                    && outline.marks.get(index).is_some_and(|mark| mark.step != Step::EndIf)
                {
                    self.blocks += 1;
                    end = outline.partner(index);
                }
                self.jump_behind(outline, end);
            }
            Step::While if partner.is_some_and(|index| index < here.mark) => {
                if holds {
                    self.jump_behind(outline, partner);
                }
            }
            Step::While | Step::LoopStart if has_condition && !holds => {
                self.jump_behind(outline, partner);
            }
            Step::Until if holds => {}
            Step::EndWhile | Step::LoopEnd | Step::Until => self.jump_to(outline, partner),
            Step::Repeat => {
                let times = value.unwrap_or(0.0).round().min(MOST_TIMES);
                if times >= 1.0 && partner.is_some() {
                    #[expect(
                        clippy::cast_possible_truncation,
                        clippy::cast_sign_loss,
                        reason = "at least 1, at most 1e9"
                    )]
                    let left = times as u32;
                    self.forget_repetition(here.mark);
                    let depth = self.frames.len();
                    self.repetitions.push(Repetition { mark: here.mark, left, depth });
                } else {
                    self.jump_behind(outline, partner);
                }
            }
            Step::EndRepeat => self.repeat(outline, partner),
            Step::Break | Step::Continue if self.breaks_repeat(outline, partner) => {}
            Step::Break => {
                if let Some(start) = partner {
                    self.forget_repetition(start);
                    self.jump_behind(outline, outline.partner(start));
                }
            }
            Step::Continue => {
                if let Some(start) = partner {
                    // Where the loop asks whether it goes on.
                    let asks = outline.marks.get(start).is_some_and(|m| m.step == Step::While);
                    self.jump_to(outline, if asks { partner } else { outline.partner(start) });
                }
            }
            Step::Unknown => {
                let hint = "the block is left out; O needs sub, call, if, while, do or repeat";
                let origin = self.block.origin_at(1);
                let message = "the O word says nothing that is known";
                self.interpreter.error("unknown-flow", message, origin, hint);
            }
            // Conditions that hold, beginnings that ask nothing, and what counts for itself.
            Step::For
            | Step::EndFor
            | Step::If
            | Step::EndIf
            | Step::While
            | Step::Do
            | Step::LoopStart
            | Step::Program => {}
        }
    }

    /// Reads what stands behind an O word or its like; `None` where the block is to be skipped.
    fn arguments_of(
        &mut self,
        outline: &Outline,
        here: Place,
        text: &str,
        asks: bool,
    ) -> Option<Arguments> {
        let mark = outline.marks.get(here.mark)?;
        let mut arguments = Arguments { holds: false, value: None, locals: [0.0; LOCALS] };
        let mut reader = self.reader(outline.dialect, Cursor::new(text, 0));
        if !reader.head() {
            return None;
        }
        reader.cursor.set(mark.after.saturating_sub(here.at).min(text.len()));
        let bracket = reader.cursor.peek() == Some(b'[');
        match mark.step {
            _ if asks => arguments.holds = reader.holds(),
            Step::Repeat => arguments.value = Some(reader.argument()),
            Step::EndSub | Step::Return if bracket => arguments.value = Some(reader.argument()),
            Step::Call => {
                for slot in arguments.locals.iter_mut().skip(1).take(ARGUMENTS) {
                    if reader.cursor.peek() != Some(b'[') {
                        break;
                    }
                    *slot = reader.argument();
                }
            }
            _ => {}
        }
        if mark.step == Step::LoopStart && reader.cursor.eat_all("DO") {
            reader.cursor.digits();
        }
        // The condition of a branch that is not asked for may say what it likes.
        if mark.step != Step::ElseIf {
            reader.only_comments();
        }
        Some(arguments)
    }

    /// Goes on at a mark.
    fn jump_to(&mut self, outline: &Outline, mark: Option<usize>) {
        if let Some(index) = mark
            && let Some(mark) = outline.marks.get(index)
        {
            self.place = Place { at: mark.at, line: mark.line, mark: index };
        }
    }

    /// Goes on behind a mark. Where there is none the outline has complained already.
    pub(super) fn jump_behind(&mut self, outline: &Outline, mark: Option<usize>) {
        if let Some(place) = mark.and_then(|index| behind(outline, index)) {
            self.place = place;
        }
    }

    /// After a condition that does not hold: the next branch that does, if any.
    fn next_branch(&mut self, outline: &Outline, mut branch: Option<usize>) {
        while let Some(index) = branch
            && let Some(mark) = outline.marks.get(index)
        {
            self.blocks += 1;
            if mark.step == Step::ElseIf {
                let (text, _) = outline.line(mark.at);
                let cursor = Cursor::new(text, mark.after.saturating_sub(mark.at));
                self.block.clear(mark.line);
                let holds = self.reader(outline.dialect, cursor).holds();
                if !holds {
                    branch = outline.partner(index);
                    continue;
                }
            }
            self.jump_behind(outline, branch);
            return;
        }
    }

    /// Whether break or continue stands in a repeat, where a control that is strict has none.
    fn breaks_repeat(&mut self, outline: &Outline, start: Option<usize>) -> bool {
        let mark = start.and_then(|index| outline.marks.get(index));
        let breaks =
            self.options.rules.is_strict && mark.is_some_and(|mark| mark.step == Step::Repeat);
        if breaks {
            let origin = self.block.origin_at(1);
            self.interpreter.refuse("break and continue are for while and do", origin);
        }
        breaks
    }

    fn forget_repetition(&mut self, mark: usize) {
        let depth = self.frames.len();
        if let Some(i) = self.repetitions.iter().position(|r| r.mark == mark && r.depth == depth) {
            self.repetitions.truncate(i);
        }
    }

    /// The end of a repeat that began at `start`.
    fn repeat(&mut self, outline: &Outline, start: Option<usize>) {
        let Some(start) = start else { return };
        let depth = self.frames.len();
        let found = self.repetitions.iter_mut().find(|r| r.mark == start && r.depth == depth);
        if let Some(repetition) = found {
            repetition.left -= 1;
            if repetition.left > 0 {
                self.jump_behind(outline, Some(start));
            } else {
                self.forget_repetition(start);
            }
        }
    }

    /// `o… call`.
    fn call_sub(&mut self, outline: &Outline, here: Place, arguments: &Locals) {
        let Some(mark) = outline.marks.get(here.mark) else { return };
        let written = outline.label(mark);
        let mut label = written.trim();
        let computed;
        if label.starts_with(['#', '[']) {
            let value = self.reader(outline.dialect, Cursor::new(label, 0)).argument();
            computed = super::number::whole(value.round()).map_or(String::new(), |n| n.to_string());
            label = &computed;
        }
        let (found, looked_at) = outline.find(Step::Sub, label);
        self.count_labels(looked_at);
        let start = found.and_then(|index| behind(outline, index));
        let Some(start) = start else {
            let label = super::lexer::quote(label);
            return self.no_subprogram(&label, 1);
        };
        if self.enter(start, 1, Some((arguments, ARGUMENTS)), true) {
            self.set_returned(0.0, 0.0);
        }
    }

    /// A subprogram is called that the text does not have.
    pub(super) fn no_subprogram(&mut self, name: &str, column: u32) {
        let message = format!("the subprogram {name} is not in the text");
        let hint = "the call is left out; put the subprogram into the text";
        let origin = self.block.origin_at(column);
        self.interpreter.error("missing-subprogram", message, origin, hint);
    }

    /// Looking for a label takes time, too.
    pub(super) fn count_labels(&mut self, looked_at: usize) {
        self.blocks += (looked_at / LABELS_A_BLOCK) as u64;
    }

    /// Enters a subprogram; false where subprograms are nested too deep, which ends the run.
    pub(super) fn enter(
        &mut self,
        start: Place,
        times: u32,
        arguments: Option<(&Locals, usize)>,
        is_sub: bool,
    ) -> bool {
        if self.frames.len() >= self.options.deepest {
            self.stop("nested-too-deep", "subprograms call each other too deep");
            return false;
        }
        let saved = arguments.map(|(locals, count)| (self.parameters.enter(locals, count), count));
        let arguments = arguments.filter(|_| times > 1).map(|(locals, _)| Box::new(*locals));
        let further = times.saturating_sub(1);
        let back = self.place;
        let until = 0;
        self.frames.push(Frame {
            back,
            start,
            further,
            saved,
            arguments,
            is_sub,
            is_modal: false,
            until,
        });
        self.place = start;
        true
    }

    /// `endsub` and `return`, maybe with a value.
    fn end_sub(&mut self, value: Option<f64>) {
        if !self.frames.last().is_some_and(|frame| frame.is_sub) {
            let hint = "the word is left out";
            let origin = self.block.origin_at(1);
            let message = "there is no subprogram to return from";
            self.interpreter.error("unmatched-flow", message, origin, hint);
            return;
        }
        self.leave();
        if let Some(value) = value {
            self.set_returned(value, 1.0);
        }
    }

    fn set_returned(&mut self, value: f64, returned: f64) {
        for (name, value) in [("_value", value), ("_value_returned", returned)] {
            self.parameters.set_name(name.to_owned(), value);
        }
    }

    /// The end of a subprogram: again, or back to where it was called.
    pub(super) fn leave(&mut self) {
        let depth = self.frames.len();
        self.repetitions.retain(|repetition| repetition.depth < depth);
        let Some(frame) = self.frames.last_mut() else { return };
        if frame.further > 0 {
            frame.further -= 1;
            self.place = frame.start;
            if let (Some((_, count)), Some(arguments)) = (&frame.saved, &frame.arguments) {
                self.parameters.set_locals(arguments, *count);
            }
            return;
        }
        if let Some(frame) = self.frames.pop() {
            self.place = frame.back;
            if let Some((saved, count)) = frame.saved {
                self.parameters.leave(&saved, count);
            }
        }
    }

    /// The text ends, which is the end of the program but should not be that of a subprogram.
    pub(super) fn end_of_text(&mut self) {
        if self.frames.is_empty() {
            // A control that stops waits for more.
            self.interpreter.course.is_cut_off |= self.options.rules.is_strict;
            self.end(false);
        } else {
            self.unfinished();
        }
    }

    /// A subprogram that has no end returns.
    fn unfinished(&mut self) {
        let hint = "it returns here; end it with M99 or endsub";
        let origin = self.block.origin();
        let message = "the subprogram has no end";
        self.interpreter.report.warning("unfinished-subprogram", message, origin, hint);
        if let Some(frame) = self.frames.last_mut() {
            frame.further = 0;
        }
        self.leave();
    }

    /// A program number: the title of the program, or the end of the one before it.
    pub(super) fn begins_program(&mut self, outline: &Outline, here: Place) -> bool {
        if let Some(frame) = self.frames.last() {
            // A call leads to the number.
            if frame.is_sub || frame.start.at == here.at {
                return true;
            }
            self.unfinished();
            return false;
        }
        if outline.is_first_program(here.mark) {
            return true;
        }
        let hint = "it ends here; end it with M30";
        let message = "another program begins before this one has ended";
        let origin = self.block.origin();
        self.interpreter.report.warning("no-program-end", message, origin, hint);
        self.end(false);
        false
    }

    /// GOTO: on to another block.
    pub(super) fn go_to(&mut self, outline: &Outline, to: Destination, column: u32, text: &str) {
        let found = match to {
            Destination::Number(number) => self.find_block(outline, number),
            Destination::Label(label, search) => self.find_label(outline, text, label, search),
            Destination::Program(name) => return self.call_named(outline, text, name, column),
            Destination::Section { labels, is_block, times } => {
                match self.find_section(outline, text, labels, is_block) {
                    Some((start, until)) => return self.repeat_section(start, until, times),
                    None => None,
                }
            }
            Destination::Return => return self.return_named(),
        };
        if let Some(place) = found {
            self.place = place;
            return;
        }
        let message = "the program has no block with this number or label";
        let origin = self.block.origin_at(column);
        let hint = "the program goes on with the next block";
        self.interpreter.error("missing-block", message, origin, hint);
    }

    /// The block with a number, first downwards, then from the beginning of the program.
    pub(super) fn find_block(&mut self, outline: &Outline, number: f64) -> Option<Place> {
        let numbered = self.numbered.get_or_insert_with(|| numbered(outline));
        let here = self.place.at;
        let (from, to) = outline.program_around(here.saturating_sub(1));
        let wanted = number.round();
        let first = numbered.partition_point(|label| f64::from(label.0) < wanted);
        let labels = numbered.get(first..).unwrap_or_default();
        let labels = labels.iter().take_while(|label| f64::from(label.0) == wanted);
        let mut found = None;
        for label in labels.filter(|label| (from..to).contains(&label.2)) {
            self.blocks += 1;
            if label.2 >= here {
                found = Some(label);
                break;
            }
            found = found.or(Some(label));
        }
        let &(_, line, at) = found?;
        Some(Place { at, line, mark: outline.mark_from(at) })
    }
}

/// The place behind a mark.
pub(super) fn behind(outline: &Outline, index: usize) -> Option<Place> {
    let mark = outline.marks.get(index)?;
    let (_, at) = outline.line(mark.at);
    Some(Place { at, line: mark.line.saturating_add(1), mark: index + 1 })
}

/// The blocks with N in order of their number and then of the text: number, line, place.
fn numbered(outline: &Outline) -> Vec<(u32, u32, usize)> {
    let mut labels = Vec::new();
    let (mut at, mut line) = (outline.first, 1_u32);
    while at < outline.end {
        let (text, next) = outline.line(at);
        let mut cursor = Cursor::new(text, 0);
        if cursor.eat(b'/') {
            while matches!(cursor.peek(), Some(b'0'..=b'9')) {
                cursor.skip();
            }
        }
        if cursor.eat(b'N')
            && let Some(number) = cursor.digits()
        {
            labels.push((number, line, at));
        }
        (at, line) = (next, line.saturating_add(1));
    }
    sort_long(&mut labels, |a, b| a < b);
    labels
}
