//! Running a program: one block after the other through an interpreter, within bounds.
//!
//! A block is read when its turn comes, since what its words say may depend on parameters. What
//! changes the order of blocks is told by the outline and done in `flow.rs`.

use std::sync::Arc;

use glam::DVec3;

use super::block::{Block, Word};
use super::cursor::Cursor;
use super::dialect::Dialect;
use super::interpret::{Flow, Interpreter};
use super::items::Item;
use super::lexer::LineReader;
use super::macros::ProgramCall;
use super::outline::{Outline, Step, after_end};
use super::parameters::{Locals, Parameters, Setting, Target};
use super::reader::Program;
use super::rules::Rules;
use crate::diagnostic::{Diagnostic, Origin};

/// Longest line that `LinuxCNC` reads [bytes].
const LONGEST_LINE: usize = 252;

/// What a program means: its steps in order, and what was found on the way.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Interpretation {
    /// The steps of the program.
    pub items: Vec<Item>,
    /// What was found when reading and interpreting it, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

/// How a program is run, and how far: a program of a few lines can go on forever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunOptions {
    /// How the control reads the words that concern compensation.
    pub rules: Rules,
    /// Most blocks to be run, each as often as it is.
    pub most_blocks: u64,
    /// Most blocks in a row that leave the tool where it is: a loop that only counts.
    pub most_idle: u64,
    /// Most text to be read, each line as often as it is [bytes].
    pub most_text: u64,
    /// Most moves and words to be made.
    pub most_items: usize,
    /// Deepest nesting of subprograms.
    pub deepest: usize,
}

impl Default for RunOptions {
    fn default() -> Self {
        Self {
            rules: Rules::default(),
            most_blocks: 20_000_000,
            most_idle: 2_000_000,
            most_text: 1 << 30,
            most_items: 3_000_000,
            deepest: 100,
        }
    }
}

/// Interprets a program by the `rules` of a control.
#[must_use]
pub fn interpret(program: &Program, rules: Rules) -> Interpretation {
    let mut runner = Runner::new(program, RunOptions { rules, ..RunOptions::default() });
    while runner.step(u64::MAX) {}
    runner.finish()
}

/// A place in the text, the beginning of a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// [bytes]
    pub(super) at: usize,
    /// Number of the line, counted from 1.
    pub(super) line: u32,
    /// The next mark of the outline.
    pub(super) mark: usize,
}

/// A subprogram that was called.
#[derive(Debug)]
pub(super) struct Frame {
    /// Where to go on behind the call.
    pub(super) back: Place,
    /// Its first block.
    pub(super) start: Place,
    /// How often it is to be run again.
    pub(super) further: u32,
    /// The parameters of its caller, and how many of them it has for itself.
    pub(super) saved: Option<(Box<Locals>, usize)>,
    /// What it was given, for when it is run again.
    pub(super) arguments: Option<Box<Locals>>,
    /// Whether it is ended by `endsub` instead of M99.
    pub(super) is_sub: bool,
    /// Whether G66 called it.
    pub(super) is_modal: bool,
    /// The line before which a section that is repeated ends; 0 for subprograms.
    pub(super) until: u32,
}

/// A repeat that goes on.
#[derive(Debug)]
pub(super) struct Repetition {
    pub(super) mark: usize,
    /// How often, this time included.
    pub(super) left: u32,
    /// How deep in subprograms.
    pub(super) depth: usize,
}

/// A program on its way through an interpreter, a slice at a time.
///
/// ```
/// use g41::program::{Dialect, Program, RunOptions, Runner};
///
/// let program = Program::parse("G91 G0\no1 repeat [3]\nX5\no1 endrepeat\nM2\n", Dialect::Auto);
/// let mut runner = Runner::new(&program, RunOptions::default());
/// while runner.step(1_000) {
///     assert!(runner.progress() <= 1.0, "for a progress bar");
/// }
/// assert_eq!(runner.finish().items.len(), 4, "three moves and M2");
/// ```
#[derive(Debug)]
pub struct Runner {
    pub(super) outline: Arc<Outline>,
    pub(super) options: RunOptions,
    pub(super) interpreter: Interpreter,
    pub(super) parameters: Parameters,
    pub(super) place: Place,
    pub(super) frames: Vec<Frame>,
    pub(super) repetitions: Vec<Repetition>,
    /// What G66 calls.
    pub(super) modal_call: Option<Box<ProgramCall>>,
    /// The block at work; kept for its memory.
    pub(super) block: Block,
    settings: Vec<Setting>,
    /// Where the numbered blocks are, once GOTO has asked for it: number, line, place.
    pub(super) numbered: Option<Vec<(u32, u32, usize)>>,
    /// Whether blocks of the program were called, which may stand behind its end.
    pub(super) calls_blocks: bool,
    pub(super) blocks: u64,
    /// Where the program is, and after how many blocks that last changed.
    went: (DVec3, u64),
    text: u64,
    /// How far the text was read at least [bytes].
    farthest: usize,
    last: Option<Origin>,
    pub(super) ended: bool,
    /// The block that is not run, by the count of blocks, and why not.
    fault: Option<(u64, Diagnostic)>,
}

impl Runner {
    /// A program before its first block.
    #[must_use]
    pub fn new(program: &Program, options: RunOptions) -> Self {
        Self::along(Arc::clone(&program.outline), options)
    }

    fn along(outline: Arc<Outline>, options: RunOptions) -> Self {
        let place = Place { at: outline.first, line: 1, mark: 0 };
        let mut interpreter = Interpreter::new(options.rules);
        interpreter.dialect = outline.dialect;
        Self {
            outline,
            options,
            interpreter,
            parameters: Parameters::default(),
            place,
            frames: Vec::new(),
            repetitions: Vec::new(),
            modal_call: None,
            block: Block::default(),
            settings: Vec::new(),
            numbered: None,
            calls_blocks: false,
            blocks: 0,
            went: (DVec3::ZERO, 0),
            text: 0,
            farthest: 0,
            last: None,
            ended: false,
            fault: None,
        }
    }

    /// Runs up to `lines` lines; false once the program has ended.
    pub fn step(&mut self, lines: u64) -> bool {
        let outline = Arc::clone(&self.outline);
        for _ in 0..lines {
            if self.ended {
                // The words of that block should have been looked at before it was run.
                let Some(fault) = self.interpreter.fault.take() else { break };
                let fault = Some((self.blocks, fault));
                *self = Self { fault, ..Self::along(Arc::clone(&outline), self.options) };
            }
            self.line(&outline);
        }
        !self.ended || self.interpreter.fault.is_some()
    }

    /// How much of the text was reached, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        if self.ended {
            return 1.0;
        }
        self.farthest as f64 / self.outline.end.max(1) as f64
    }

    /// What the program means, as far as it was run.
    #[must_use]
    pub fn finish(mut self) -> Interpretation {
        if self.interpreter.fault.is_some() {
            while self.step(u64::MAX) {}
        }
        let interpreter = &mut self.interpreter;
        interpreter.finish_spline();
        interpreter.course.end(self.last, &mut interpreter.report);
        interpreter.report.extend(self.outline.diagnostics.iter().cloned());
        interpreter.course.items.truncate(interpreter.made);
        Interpretation {
            items: self.interpreter.course.into_items(),
            diagnostics: self.interpreter.report.finish(),
        }
    }

    /// Runs one line.
    fn line(&mut self, outline: &Outline) {
        let here = self.place;
        if self.frames.last().is_some_and(|frame| frame.until == here.line) {
            self.blocks += 1;
            if self.within_bounds() {
                self.leave();
            }
            return;
        }
        if here.at >= outline.end {
            self.end_of_text();
            return;
        }
        let (text, next) = outline.line(here.at);
        self.farthest = self.farthest.max(next);
        self.place.at = next;
        self.place.line = here.line.saturating_add(1);
        let mark = outline.marks.get(here.mark).filter(|mark| mark.at == here.at);
        if mark.is_some() {
            self.place.mark += 1;
        }
        let mut cursor = Cursor::new(text, 0);
        let first = cursor.peek();
        if first.is_none() || first == Some(b'%') && mark.is_none() {
            return;
        }
        self.blocks += 1;
        self.text = self.text.saturating_add(text.len() as u64);
        self.block.clear(here.line);
        if !self.within_bounds() {
            return;
        }
        if self.options.rules.is_strict && text.trim_ascii().len() > LONGEST_LINE {
            let message = "the line has more than 252 characters";
            self.interpreter.error("line-too-long", message, self.block.origin(), "");
            self.ended = true;
            return;
        }
        match mark {
            Some(mark) if mark.step != Step::Program => {
                self.flow(outline, here, text);
                self.ended |= self.interpreter.is_refused;
            }
            _ => {
                if mark.is_some() && !self.begins_program(outline, here) {
                    return;
                }
                if first != Some(b'%') {
                    self.plain(outline, cursor, text);
                }
            }
        }
    }

    /// Reads a line that does not change the order of blocks by itself, and runs it.
    fn plain(&mut self, outline: &Outline, cursor: Cursor, text: &str) {
        let mut reader = self.reader(outline.dialect, cursor);
        if reader.head() {
            reader.elements();
        }
        let (jump, calls) = (reader.jump, reader.calls);
        if self.options.rules.block_delete && self.block.skippable {
            return;
        }
        let call = if calls { self.take_call() } else { None };
        if self.frames.last().is_some_and(|frame| frame.start.line == self.block.line) {
            // The number of a subprogram is no title.
            self.block.words.retain(|word| word.letter != 'O');
        }
        self.run_block();
        self.assign();
        let moves = |word: &Word| matches!(word.letter, 'X' | 'Y' | 'Z');
        if self.modal_call.is_some()
            && !self.ended
            && call.is_none()
            && self.block.words.iter().any(moves)
        {
            self.call_modal(outline);
        }
        if let Some(call) = call
            && !self.ended
        {
            self.call(outline, &call);
        }
        if let Some((to, column)) = jump {
            self.go_to(outline, to, column, text);
        }
    }

    /// What reads from a line into the block.
    pub(super) fn reader<'a>(&'a mut self, dialect: Dialect, cursor: Cursor<'a>) -> LineReader<'a> {
        self.settings.clear();
        LineReader {
            cursor,
            dialect,
            parameters: &self.parameters,
            interpreter: &mut self.interpreter,
            block: &mut self.block,
            settings: &mut self.settings,
            depth: 0,
            block_delete: self.options.rules.block_delete,
            jump: None,
            calls: false,
        }
    }

    /// Hands the block to the interpreter.
    pub(super) fn run_block(&mut self) {
        self.last = Some(self.block.origin());
        if self.fault.as_ref().is_some_and(|(blocks, _)| *blocks == self.blocks)
            && let Some((_, fault)) = self.fault.take()
        {
            self.interpreter.stop_at(fault);
            self.ended = true;
            return;
        }
        if self.interpreter.block(&self.block) == Flow::End {
            self.end(true);
        }
    }

    /// The assignments of the block take effect.
    pub(super) fn assign(&mut self) {
        for Setting { target, value, column } in self.settings.drain(..) {
            let origin = self.block.origin_at(column);
            let report = &mut self.interpreter.report;
            match target {
                Target::Number(3000) if self.outline.dialect == Dialect::Fanuc => {
                    let hint = "what follows is not run; see the comment in the block";
                    report.error("program-alarm", "the program raises an alarm", origin, hint);
                    self.ended = true;
                }
                Target::Number(number) => self.parameters.set_number(number, value),
                Target::Whole(name) => self.parameters.make_whole(&name),
                Target::Name(name) => {
                    if !self.parameters.set_name(name, value) {
                        let message =
                            "more than 1000 named parameters, or a name beyond 100 letters";
                        report.error("too-many-parameters", message, origin, "it is not set");
                    }
                }
            }
        }
    }

    /// Whether the run may go on; else it ends here.
    fn within_bounds(&mut self) -> bool {
        let options = &self.options;
        let here = self.interpreter.modal.position;
        if here != self.went.0 {
            self.went = (here, self.blocks);
        }
        let message = if self.blocks > options.most_blocks {
            "the program runs too many blocks"
        } else if self.blocks - self.went.1 > options.most_idle {
            "the program runs too many blocks without a move"
        } else if self.text > options.most_text {
            "the program reads its lines too often"
        } else if self.interpreter.len() > options.most_items {
            "the program makes too many moves"
        } else {
            return true;
        };
        self.stop("run-too-long", message);
        false
    }

    /// Ends the run at the block.
    pub(super) fn stop(&mut self, code: &'static str, message: &str) {
        let hint = "it ends here; look for a loop or a subprogram without end";
        self.interpreter.error(code, message, self.block.origin(), hint);
        self.ended = true;
    }

    /// The program ends, by M2 or M30 if `stated`; text that follows should be subprograms.
    pub(super) fn end(&mut self, stated: bool) {
        self.ended = true;
        let outline = Arc::clone(&self.outline);
        let stated = stated && !self.interpreter.is_refused && !self.calls_blocks;
        while stated && self.place.at < outline.end {
            let (text, next) = outline.line(self.place.at);
            if !text.trim().is_empty() {
                let at = self.place.at;
                let mark = outline.marks.get(outline.mark_from(at)).filter(|m| m.at == at);
                if !mark.is_some_and(|m| matches!(m.step, Step::Sub | Step::Program)) {
                    self.interpreter.report.push(after_end(self.place.line));
                }
                return;
            }
            self.place.at = next;
            self.place.line = self.place.line.saturating_add(1);
        }
    }
}
