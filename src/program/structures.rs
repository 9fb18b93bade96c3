//! SINUMERIK's control structures and subprograms.
//!
//! Siemens, SINUMERIK 840D sl / 828D, Programming Manual Job Planning 10/2015: repetition of program
//! sections in section 1.10, control structures in 1.11, subprograms in 1.24.
//! Loops are those of the outline with other names; what is here alone is FOR, which counts.

use super::cursor::Cursor;
use super::expression::{Fault, fault};
use super::flow::{Destination, Search, Span};
use super::lexer::{LineReader, quote};
use super::outline::{Mark, NONE, Outline, Step};
use super::parameters::{LOCALS, Setting, UNSET};
use super::run::{Frame, Place, Runner};
use super::spline_words::place_in;
use super::variables::argument;

/// The names that begin lines of the outline, and from which letter on a beginning and its end have
/// them in common.
const STRUCTURES: &str = "IF ELSE ENDIF WHILE ENDWHILE LOOP ENDLOOP REPEAT UNTIL FOR ENDFOR PROC";
const STEPS: [(Step, usize); 12] = [
    (Step::If, 2),
    (Step::Else, 4),
    (Step::EndIf, 5),
    (Step::LoopStart, 0),
    (Step::LoopEnd, 3),
    (Step::LoopStart, 0),
    (Step::LoopEnd, 3),
    (Step::LoopStart, 6),
    (Step::Until, 5),
    (Step::For, 3),
    (Step::EndFor, 6),
    (Step::Program, 4),
];

/// Names within lines.
const NAMES: &str = "GOTOF GOTOB GOTO IF CASE DEF PROC RET REPEAT REPEATB EXTERN";

/// Most repetitions of a section, and most runs of a subprogram that one call asks for.
const MOST_TIMES: f64 = 1e9;

/// The mark of a line that begins with the name of a program: `%_N_NAME_MPF`.
pub(super) fn program_name(mut cursor: Cursor, at: usize, line: u32) -> Option<Mark> {
    if !cursor.eat_all("%_N_") {
        return None;
    }
    let from = at + cursor.at();
    let name = cursor.identifier();
    let mut mark = Mark::plain(at, line, Step::Program);
    // What it ends with tells its kind: _MPF, _SPF.
    mark.label = [from, from + name.len().saturating_sub(4)];
    Some(mark)
}

/// Reads the name that makes a line one of the outline.
pub(super) fn structure(cursor: &mut Cursor, mark: &mut Mark) -> Option<()> {
    cursor.peek();
    let mut from = cursor.at();
    let mut name = cursor.identifier();
    if cursor.eat(b':') {
        // It was a label.
        cursor.peek();
        from = cursor.at();
        name = cursor.identifier();
    }
    let &(step, common) = STEPS.get(place_in(STRUCTURES, name)?)?;
    mark.step = step;
    mark.label = [mark.at + from + common, mark.at + from + name.len()];
    mark.after = mark.at + cursor.at();
    let ends = matches!(cursor.peek(), None | Some(b';'));
    match (step, common) {
        (Step::Program, _) => {
            let from = mark.at + cursor.at();
            mark.label = [from, from + cursor.identifier().len()];
        }
        // A jump.
        (Step::If, _) => {
            let code = cursor.rest().split(';').next().unwrap_or_default();
            if code.as_bytes().windows(4).any(|part| part.eq_ignore_ascii_case(b"GOTO")) {
                return None;
            }
        }
        // Of a section between labels.
        (Step::LoopStart, 6) if !ends => return None,
        (Step::LoopStart, _) if ends => mark.after = NONE,
        _ => {}
    }
    Some(())
}

impl LineReader<'_> {
    /// A name that changes the order of blocks or makes variables; false where it is another.
    pub(super) fn flow_name(&mut self, name: &str, from: usize) -> bool {
        let Some(found) = place_in(NAMES, name) else { return false };
        self.cursor.peek();
        let column = self.cursor.column(from);
        match found {
            0..=2 => {
                let search = [Search::Down, Search::Up, Search::DownThenUp][found];
                let label = self.span();
                self.jump = Some((Destination::Label(label, search), column));
                // Other conditions may follow.
                self.cursor.until(';');
            }
            // What follows counts only where it is true.
            3 if self.holds() => {}
            3 => self.pass_jump(),
            4 => self.choose(),
            5 => self.define(),
            6 => self.procedure(),
            7 => {
                self.jump = Some((Destination::Return, column));
                self.cursor.until(';');
            }
            8 | 9 => self.jump = Some((self.section(found == 9), column)),
            // It tells what a subprogram takes.
            _ => {
                self.cursor.until(';');
            }
        }
        true
    }

    /// The name that comes next.
    pub(super) fn span(&mut self) -> Span {
        let from = self.cursor.at();
        self.cursor.identifier();
        [from, self.cursor.at()]
    }

    /// Moves behind GOTOF and its like with their label.
    fn pass_jump(&mut self) {
        for _ in 0..2 {
            self.cursor.peek();
            self.cursor.identifier();
        }
    }

    /// CASE behind its name: up to the jump that its value chooses, or behind all of them.
    fn choose(&mut self) {
        let from = self.cursor.at();
        let chosen = self.expression(1).and_then(|value| {
            self.cursor.eat_all("OF");
            while !matches!(self.cursor.peek(), None | Some(b';')) {
                if self.cursor.eat_all("DEFAULT") || self.expression(1)? == value {
                    break;
                }
                self.pass_jump();
            }
            Ok(())
        });
        if let Err(fault) = chosen {
            self.report_fault(&fault, from, "the rest of the block is left out");
            self.cursor.skip_all();
        }
    }

    /// How often: `P3` or `P=3`; once without.
    fn times(&mut self) -> u32 {
        if !self.cursor.eat(b'P') {
            return 1;
        }
        self.cursor.eat(b'=');
        let times = self.argument().round().clamp(0.0, MOST_TIMES);
        super::number::whole(times).unwrap_or(0)
    }

    /// What stands behind REPEAT and REPEATB: one label or two, and how often.
    fn section(&mut self, is_block: bool) -> Destination {
        let mut labels = [[0; 2]; 2];
        for label in &mut labels {
            self.cursor.peek();
            let span = self.span();
            let name = self.cursor.since(span[0]);
            let number = name.strip_prefix(['P', 'p']);
            if number.is_some_and(|digits| digits.bytes().all(|digit| digit.is_ascii_digit())) {
                self.cursor.set(span[0]);
                break;
            }
            *label = span;
        }
        Destination::Section { labels, is_block, times: self.times() }
    }

    /// Reads FOR behind its name: whether the loop is run, for the first time or `again`.
    fn counts(&mut self, again: bool) -> Result<bool, Fault> {
        self.cursor.peek();
        let from = self.cursor.at();
        let target = self.variable()?;
        let expected = ("bad-expression", "FOR needs a variable, = and TO");
        if !self.cursor.eat(b'=') {
            return fault(expected, self.cursor.at());
        }
        let mut value = self.expression(1)?;
        if !self.cursor.eat_all("TO") {
            return fault(expected, self.cursor.at());
        }
        let last = self.expression(1)?;
        if again {
            value = self.parameter(&target, from)? + 1.0;
        }
        let column = self.cursor.column(from);
        self.settings.push(Setting { target, value, column });
        Ok(value <= last)
    }
}

impl Runner {
    /// FOR and ENDFOR.
    pub(super) fn count_loop(&mut self, outline: &Outline, here: Place) {
        let is_first = outline.marks.get(here.mark).is_some_and(|mark| mark.step == Step::For);
        let begin = if is_first { Some(here.mark) } else { outline.partner(here.mark) };
        let Some((begin, mark)) = begin.and_then(|begin| Some((begin, outline.marks.get(begin)?)))
        else {
            return;
        };
        let (text, _) = outline.line(mark.at);
        let cursor = Cursor::new(text, mark.after.saturating_sub(mark.at));
        let mut reader = self.reader(outline.dialect, cursor);
        let holds = match reader.counts(!is_first) {
            Ok(holds) => holds,
            Err(fault) => {
                reader.report_fault(&fault, fault.at, "the loop is left out");
                false
            }
        };
        self.assign();
        self.jump_behind(outline, if holds { Some(begin) } else { outline.partner(begin) });
    }

    /// A subprogram by its name.
    pub(super) fn call_named(&mut self, outline: &Outline, text: &str, name: Span, column: u32) {
        let [from, to] = name;
        let name = text.get(from..to).unwrap_or_default();
        let (found, looked_at) = outline.find(Step::Program, name);
        self.count_labels(looked_at);
        let Some((index, mark)) = found.and_then(|index| Some((index, outline.marks.get(index)?)))
        else {
            return self.no_subprogram(&quote(name), column);
        };
        let mut reader = self.reader(outline.dialect, Cursor::new(text, to));
        let values = reader.call_arguments();
        let times = reader.times();
        let values = values.unwrap_or_else(|fault| {
            reader.report_fault(&fault, fault.at, "the call has no arguments");
            Vec::new()
        });
        let start = Place { at: mark.at, line: mark.line, mark: index };
        if times > 0 && self.enter(start, times, Some((&[UNSET; LOCALS], 0)), false) {
            for (i, value) in values.into_iter().enumerate() {
                self.parameters.set_name(argument(i + 1), value);
            }
        }
    }

    /// M17, RET, and M2 or M30 of a subprogram.
    pub(super) fn return_named(&mut self) {
        while self.frames.pop_if(|frame| frame.until > 0).is_some() {}
        if self.frames.is_empty() {
            self.end(true);
        } else {
            self.leave();
        }
    }

    /// The block with a label (`NAME:`), or with a number where it is one behind N.
    pub(super) fn find_label(
        &mut self,
        outline: &Outline,
        text: &str,
        [from, to]: Span,
        search: Search,
    ) -> Option<Place> {
        let label = text.get(from..to).unwrap_or_default();
        let here = self.place.at;
        let (mut found, mut looked_at) = (None, 0);
        let bounds = outline.program_around(here.saturating_sub(1));
        let (mut at, mut line) = (outline.first, 1_u32);
        while at < bounds.1 && !(search == Search::Up && at >= here) {
            let (text, next) = outline.line(at);
            looked_at += 1;
            let within = at >= if search == Search::Down { here } else { bounds.0 };
            if within && is_labelled(text, label) {
                found = Some(Place { at, line, mark: outline.mark_from(at) });
                if at >= here {
                    break;
                }
            }
            (at, line) = (next, line.saturating_add(1));
        }
        self.count_labels(looked_at);
        found
    }

    /// Where a section between labels begins, and the line before which it ends.
    pub(super) fn find_section(
        &mut self,
        outline: &Outline,
        text: &str,
        [first, last]: [Span; 2],
        is_block: bool,
    ) -> Option<(Place, u32)> {
        let here = self.block.line;
        let whole = !is_block && last == [0; 2];
        let search = if whole { Search::Up } else { Search::DownThenUp };
        let start = self.find_label(outline, text, first, search)?;
        let until = if whole {
            here
        } else if is_block {
            start.line.saturating_add(1)
        } else {
            self.find_label(outline, text, last, Search::DownThenUp)?.line.saturating_add(1)
        };
        Some((start, until))
    }

    /// Runs a section again.
    pub(super) fn repeat_section(&mut self, start: Place, until: u32, times: u32) {
        if times > 0
            && self.enter(start, times, None, false)
            && let Some(Frame { until: end, .. }) = self.frames.last_mut()
        {
            *end = until;
        }
    }
}

/// Whether a line has such a label, or such a number with its N.
fn is_labelled(text: &str, label: &str) -> bool {
    let mut cursor = Cursor::new(text, 0);
    loop {
        cursor.peek();
        let name = cursor.identifier();
        let is_number = name.starts_with(['N', 'n'])
            && name.len() > 1
            && name.bytes().skip(1).all(|digit| digit.is_ascii_digit());
        if name.eq_ignore_ascii_case(label) && (is_number || cursor.eat(b':')) {
            return true;
        }
        if !is_number {
            return false;
        }
    }
}
