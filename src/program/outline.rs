//! The outline of a program: where its subprograms and loops begin and end.
//!
//! It is read from the text before anything runs, so that a jump knows where it leads to. Only the
//! beginnings of lines are looked at.

use super::cursor::Cursor;
use super::dialect::Dialect;
use super::report::Report;
use super::structures::{program_name, structure};
use crate::diagnostic::{Diagnostic, Origin};

/// Deepest nesting of loops and conditions; deeper ones are reported.
const DEEPEST: usize = 100;

/// No partner, or no arguments.
pub(super) const NONE: usize = usize::MAX;

/// What a line does to the order of blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    Sub,
    EndSub,
    Call,
    Return,
    Do,
    While,
    EndWhile,
    If,
    ElseIf,
    Else,
    EndIf,
    Repeat,
    EndRepeat,
    Break,
    Continue,
    /// FANUC's program number, or SINUMERIK's name of one.
    Program,
    /// FANUC's `WHILE […] DO1` or `DO1`.
    LoopStart,
    /// FANUC's `END1`.
    LoopEnd,
    /// SINUMERIK's `UNTIL …`.
    Until,
    /// SINUMERIK's `FOR …=… TO …`.
    For,
    EndFor,
    /// An O word of which nothing is understood.
    Unknown,
}

/// The words after the number or name of an O word.
const STEPS: [(&str, Step); 15] = [
    ("SUB", Step::Sub),
    ("ENDSUB", Step::EndSub),
    ("CALL", Step::Call),
    ("RETURN", Step::Return),
    ("DO", Step::Do),
    ("WHILE", Step::While),
    ("ENDWHILE", Step::EndWhile),
    ("IF", Step::If),
    ("ELSEIF", Step::ElseIf),
    ("ELSE", Step::Else),
    ("ENDIF", Step::EndIf),
    ("REPEAT", Step::Repeat),
    ("ENDREPEAT", Step::EndRepeat),
    ("BREAK", Step::Break),
    ("CONTINUE", Step::Continue),
];

/// A line that changes the order of blocks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    /// Where the line begins [bytes].
    pub(super) at: usize,
    /// Its number, counted from 1.
    pub(super) line: u32,
    /// Where its arguments begin [bytes].
    pub(super) after: usize,
    pub(super) step: Step,
    /// The number, name or expression after O, or of DO and END [bytes].
    pub(super) label: [usize; 2],
    /// The mark that belongs to it: the end of a beginning, the next branch of a condition, the
    /// loop of a break.
    partner: usize,
}

/// The text of a program with its outline.
#[derive(Debug, Default)]
pub(super) struct Outline {
    pub(super) text: String,
    pub(super) dialect: Dialect,
    /// The lines that change the order, in order.
    pub(super) marks: Vec<Mark>,
    /// Those among them that begin a subprogram or a program.
    named: Vec<usize>,
    /// Where the first line begins [bytes]: behind the mark of Unicode files.
    pub(super) first: usize,
    /// Where the program ends: at the second `%`, or with the text [bytes].
    pub(super) end: usize,
    /// What was found.
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl Outline {
    pub(super) fn new(text: String, dialect: Dialect) -> Self {
        let dialect = dialect.of(&text);
        let mut report = Report::default();
        let mut outline = Self { end: text.len(), text, dialect, ..Self::default() };
        outline.first = if outline.text.starts_with('\u{feff}') { 3 } else { 0 };
        outline.read(&mut report);
        outline.join(&mut report);
        outline.diagnostics = report.finish();
        outline
    }

    /// The line that begins at `at`, and where the next one does. Lines end in LF, CR LF or, in old
    /// files, CR alone.
    pub(super) fn line(&self, at: usize) -> (&str, usize) {
        let rest = self.text.get(at..self.end).unwrap_or_default();
        let is_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        match rest.as_bytes().iter().position(is_end) {
            None => (rest, self.end),
            Some(length) => {
                let line = rest.get(..length).unwrap_or_default();
                let both = rest.as_bytes().get(length..length + 2) == Some(b"\r\n");
                (line, at + length + if both { 2 } else { 1 })
            }
        }
    }

    /// Collects the marks.
    fn read(&mut self, report: &mut Report) {
        let (mut at, mut line) = (self.first, 1_u32);
        let (mut opened, mut words, mut end) = (false, false, None);
        while at < self.end {
            let (text, next) = self.line(at);
            let mut cursor = Cursor::new(text, 0);
            let named = if self.dialect == Dialect::Sinumerik {
                program_name(cursor.clone(), at, line)
            } else {
                None
            };
            match cursor.peek() {
                None => {}
                Some(_) if end.is_some() => {
                    report.push(after_end(line));
                    break;
                }
                Some(_) if named.is_some() => self.marks.extend(named),
                // Comments may stand before the first.
                Some(b'%') if !opened && !words => opened = true,
                Some(b'%') => end = Some(at),
                Some(_) => {
                    if !words && is_klartext(Cursor::new(text, 0)) {
                        let origin = Origin::Block { line, number: None, column: None };
                        let hint = "have it written as G-code, ISO, by what has made it";
                        let message = "the program is in Heidenhain's conversational language";
                        report.error("not-supported", message, origin, hint);
                        end = Some(self.first);
                        break;
                    }
                    words |= !is_comment(text);
                    if let Some(mark) = mark(cursor, at, line, self.dialect) {
                        // PROC tells the name of a file once more.
                        if self.dialect == Dialect::Sinumerik
                            && mark.step == Step::Program
                            && let Some(last) = self.marks.last()
                            && last.step == Step::Program
                            && self.same(last, &mark)
                        {
                            self.marks.pop();
                        }
                        self.marks.push(mark);
                    }
                }
            }
            (at, line) = (next, line.saturating_add(1));
        }
        self.end = end.unwrap_or(self.end);
    }

    /// The label of a mark.
    pub(super) fn label(&self, mark: &Mark) -> &str {
        self.text.get(mark.label[0]..mark.label[1]).unwrap_or_default()
    }

    /// Whether two marks have one label.
    fn same(&self, a: &Mark, b: &Mark) -> bool {
        same_label(self.label(a), self.label(b))
    }

    /// Finds the partners.
    fn join(&mut self, report: &mut Report) {
        let mut open: Vec<usize> = Vec::new();
        for index in 0..self.marks.len() {
            let Some(&mark) = self.marks.get(index) else { break };
            // The beginnings that it continues or ends.
            let ends: &[Step] = match mark.step {
                Step::Sub | Step::Program => {
                    self.named.push(index);
                    self.unclosed(&mut open, 0, report);
                    if mark.step == Step::Sub {
                        open.push(index);
                    }
                    continue;
                }
                Step::EndSub => &[Step::Sub],
                Step::ElseIf | Step::Else => &[Step::If, Step::ElseIf],
                Step::EndIf => &[Step::If, Step::ElseIf, Step::Else],
                Step::EndWhile => &[Step::While],
                Step::EndRepeat => &[Step::Repeat],
                Step::LoopEnd | Step::Until => &[Step::LoopStart],
                Step::EndFor => &[Step::For],
                Step::While => &[Step::Do],
                Step::Break | Step::Continue => &[Step::While, Step::Do, Step::Repeat],
                Step::If | Step::Do | Step::Repeat | Step::LoopStart | Step::For => &[],
                Step::Call | Step::Return | Step::Unknown => continue,
            };
            let belongs = |&&begin: &&usize| {
                self.marks.get(begin).is_some_and(|b| ends.contains(&b.step) && self.same(b, &mark))
            };
            let found = open.iter().rev().take(DEEPEST).position(|begin| belongs(&begin));
            let leaves = matches!(mark.step, Step::Break | Step::Continue);
            match found {
                Some(back) => {
                    let depth = open.len() - 1 - back;
                    let begin = open.get(depth).copied().unwrap_or(NONE);
                    // Branches lead downwards only.
                    if !matches!(mark.step, Step::ElseIf | Step::Else | Step::EndIf) {
                        self.set_partner(index, begin);
                    }
                    if leaves {
                        continue;
                    }
                    self.unclosed(&mut open, depth + 1, report);
                    open.pop();
                    self.set_partner(begin, index);
                    if matches!(mark.step, Step::ElseIf | Step::Else) {
                        open.push(index);
                    }
                }
                // A while without do, and all beginnings.
                None if mark.step == Step::While || ends.is_empty() => {
                    if open.len() == DEEPEST {
                        self.complain(index, "is nested too deep", report);
                    } else {
                        open.push(index);
                    }
                }
                None => self.complain(index, "has no beginning", report),
            }
        }
        self.unclosed(&mut open, 0, report);
    }

    fn set_partner(&mut self, index: usize, partner: usize) {
        if let Some(mark) = self.marks.get_mut(index) {
            mark.partner = partner;
        }
    }

    /// Reports and forgets the beginnings above `depth`.
    fn unclosed(&self, open: &mut Vec<usize>, depth: usize, report: &mut Report) {
        while open.len() > depth
            && let Some(index) = open.pop()
        {
            self.complain(index, "has no end", report);
        }
    }

    fn complain(&self, index: usize, what: &str, report: &mut Report) {
        if let Some(mark) = self.marks.get(index) {
            let label: String = self.label(mark).chars().take(20).collect();
            let origin = Origin::Block { line: mark.line, number: None, column: None };
            let message = format!("the loop, condition or subprogram {label} {what}");
            report.error("unmatched-flow", message, origin, "the word is left out");
        }
    }

    /// The partner of a mark.
    pub(super) fn partner(&self, index: usize) -> Option<usize> {
        self.marks.get(index).map(|mark| mark.partner).filter(|&partner| partner != NONE)
    }

    /// The mark at or after a place.
    pub(super) fn mark_from(&self, at: usize) -> usize {
        self.marks.partition_point(|mark| mark.at < at)
    }

    /// The mark of the subprogram (O… sub) or program (O…) with a label, and how many were looked
    /// at.
    pub(super) fn find(&self, step: Step, label: &str) -> (Option<usize>, usize) {
        for (looked_at, &index) in self.named.iter().enumerate() {
            if let Some(mark) = self.marks.get(index)
                && mark.step == step
                && same_label(self.label(mark), label)
            {
                return (Some(index), looked_at);
            }
        }
        (None, self.named.len())
    }

    /// Whether `index` is the first program number of the text.
    pub(super) fn is_first_program(&self, index: usize) -> bool {
        let is_program = |&&i: &&usize| self.marks.get(i).is_some_and(|m| m.step == Step::Program);
        self.named.iter().find(is_program) == Some(&index)
    }

    /// From where to where the program reaches in which a place lies [bytes].
    pub(super) fn program_around(&self, at: usize) -> (usize, usize) {
        let (mut from, mut to) = (0, self.end);
        for mark in self.named.iter().filter_map(|&index| self.marks.get(index)) {
            if mark.step == Step::Program {
                if mark.at > at {
                    to = mark.at;
                    break;
                }
                from = mark.at;
            }
        }
        (from, to)
    }
}

impl Mark {
    pub(super) fn plain(at: usize, line: u32, step: Step) -> Self {
        Self { at, line, after: at, step, label: [at; 2], partner: NONE }
    }
}

/// The diagnostic for text that no control reads.
pub(super) fn after_end(line: u32) -> Diagnostic {
    Diagnostic::warning("after-end", "the program has ended; what follows is not read")
        .with_origin(Origin::Block { line, number: None, column: None })
        .with_hint("put subprograms into the program where they are called")
}

/// The mark of a line, if it is one.
fn mark(mut cursor: Cursor, at: usize, line: u32, dialect: Dialect) -> Option<Mark> {
    if cursor.eat(b'/') {
        while matches!(cursor.peek(), Some(b'0'..=b'9')) {
            cursor.skip();
        }
    }
    if cursor.eat(b'N') {
        while matches!(cursor.peek(), Some(b'0'..=b'9' | b'.')) {
            cursor.skip();
        }
    }
    let mut mark = Mark::plain(at, line, Step::Unknown);
    let fanuc = matches!(dialect, Dialect::Auto | Dialect::Fanuc);
    match cursor.peek()? {
        _ if dialect == Dialect::Sinumerik => structure(&mut cursor, &mut mark)?,
        c if c == b'O' || c == b':' && fanuc => {
            cursor.skip();
            o_word(&mut cursor, &mut mark)?;
            mark.after = at + cursor.at();
        }
        b'W' | b'D' if fanuc => {
            // Two letters may stand for the word.
            if cursor.eat_all("WHILE[") || cursor.eat_all("WH[") {
                mark.after = at + cursor.at() - 1;
                skip_bracket(&mut cursor);
                if !cursor.eat_all("DO") {
                    return None;
                }
            } else if cursor.eat_all("DO") {
                mark.after = NONE;
            } else {
                return None;
            }
            mark.step = Step::LoopStart;
            mark.label = label(&mut cursor, at)?;
        }
        b'E' if fanuc && cursor.eat_all("END") => {
            mark.step = Step::LoopEnd;
            mark.label = label(&mut cursor, at)?;
            mark.after = at + cursor.at();
        }
        _ => return None,
    }
    Some(mark)
}

/// The digits that come next.
fn label(cursor: &mut Cursor, at: usize) -> Option<[usize; 2]> {
    cursor.peek();
    let from = cursor.at();
    cursor.digits()?;
    Some([at + from, at + cursor.at()])
}

/// The label and the word after O; `None` where it is a word without number.
fn o_word(cursor: &mut Cursor, mark: &mut Mark) -> Option<()> {
    let at = mark.at;
    let first = cursor.peek()?;
    let from = cursor.at();
    match first {
        b'<' => {
            cursor.until('>');
            cursor.eat(b'>');
        }
        b'[' => {
            cursor.skip();
            skip_bracket(cursor);
        }
        b'#' => {
            cursor.skip();
            match cursor.peek()? {
                b'<' => {
                    cursor.until('>');
                    cursor.eat(b'>');
                }
                _ => {
                    cursor.digits()?;
                }
            }
        }
        b'0'..=b'9' => {
            while matches!(cursor.peek(), Some(b'0'..=b'9')) {
                cursor.skip();
            }
        }
        _ => return None,
    }
    mark.label = [at + from, at + cursor.at()];
    let number = first.is_ascii_digit();
    mark.step = if number { Step::Program } else { Step::Unknown };
    for (name, step) in STEPS {
        let before = cursor.at();
        if cursor.eat_all(name) {
            // ELSE begins ELSEIF.
            if !cursor.peek().is_some_and(|c| c.is_ascii_alphabetic()) {
                mark.step = step;
                break;
            }
            cursor.set(before);
        }
    }
    Some(())
}

/// Moves behind the bracket that was opened.
fn skip_bracket(cursor: &mut Cursor) {
    let mut depth = 1_u32;
    for (i, byte) in cursor.rest().bytes().enumerate() {
        match byte {
            b'[' => depth += 1,
            b']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            cursor.set(cursor.at() + i + 1);
            return;
        }
    }
    cursor.skip_all();
}

/// Whether two labels are the same: numbers by their value, names apart from space and case.
fn same_label(a: &str, b: &str) -> bool {
    plain(a).eq(plain(b))
}

/// The characters of a label that count.
fn plain(label: &str) -> impl Iterator<Item = u8> {
    let digits = label.starts_with(|c: char| c.is_ascii_digit());
    let label = if digits { label.trim_start_matches('0') } else { label };
    let bytes = label.bytes().filter(|byte| !byte.is_ascii_whitespace());
    bytes.map(|byte| byte.to_ascii_lowercase())
}

/// Whether a line begins a program in Heidenhain's own language.
fn is_klartext(mut cursor: Cursor) -> bool {
    cursor.digits();
    cursor.eat_all("BEGINPGM")
}

/// Whether a line consists of comments.
fn is_comment(line: &str) -> bool {
    let mut rest = line.trim_start();
    while let Some(comment) = rest.strip_prefix('(') {
        match comment.split_once(')') {
            Some((_, after)) => rest = after.trim_start(),
            None => return true,
        }
    }
    rest.is_empty() || rest.starts_with(';')
}
