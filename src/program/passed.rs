//! Words that move nothing, written for a target: as they are where it knows them, as what it
//! knows instead, or left out with a diagnostic, never silently.

use super::block_writer::{BlockWriter, Written, comment, push_length};
use super::number::{push_word, whole};
use super::target::Comments;
use crate::diagnostic::{Diagnostic, Origin, Severity};
use crate::geometry::{Decimal, parse_decimal};

/// Letters whose numbers are lengths.
const LENGTHS: &str = "XYZIJKRUVWQ";

/// How many words that are left out are told one by one.
const MOST_TOLD: usize = 100;

/// One word or comment of a text.
#[derive(Debug, Clone, Copy)]
pub(super) enum Token<'a> {
    Comment(&'a str),
    Word(char, f64),
}

impl<'a> Token<'a> {
    pub(super) fn is(&self, letter: char, number: f64) -> bool {
        matches!(self, Self::Word(found, value) if *found == letter && *value == number)
    }

    fn comment(&self) -> Option<&'a str> {
        match self {
            Self::Comment(text) => Some(text),
            Self::Word(..) => None,
        }
    }
}

/// A G or M word with the words that belong to it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Command<'a> {
    pub(super) value: f64,
    pub(super) parameters: &'a [Token<'a>],
    pub(super) origin: Origin,
}

impl Command<'_> {
    /// Adds it to a line.
    fn push(&self, line: &mut String, letter: char, out: &BlockWriter) {
        push_command(line, letter, self.value, self.parameters, out);
    }
}

/// Passes words on, and keeps what it has to say about them.
#[derive(Debug, Default)]
pub(super) struct Passing {
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Words that were told to be left out, with ten times their number.
    told: Vec<(char, i64)>,
    /// The spindle as it turns (M3, M4) and its speed, where they must be said together.
    pub(super) spindle: [Option<f64>; 2],
    /// The T word.
    pub(super) tool: Option<f64>,
    /// Whether a tool length that was left out would be in effect.
    no_length: bool,
    /// Whether all words of a text were written.
    complete: bool,
    /// Whether moves were left out from whose end the program goes on.
    pub(super) is_cut_off: bool,
}

impl Passing {
    /// Writes words; tells what became of them.
    pub(super) fn pass(&mut self, out: &mut BlockWriter, text: &str, origin: Origin) -> Written {
        self.complete = true;
        let tokens = tokens(text);
        let mut line = String::new();
        let mut comments: Vec<&str> = Vec::new();
        let mut says = true;
        let machine = tokens.iter().any(|token| token.is('G', 53.0));
        let mut i = 0;
        while let Some(&token) = tokens.get(i) {
            i += 1;
            let (letter, value) = match token {
                Token::Comment(text) => {
                    comments.push(text);
                    continue;
                }
                Token::Word(letter, value) => (letter, value),
            };
            let first = i;
            if matches!(letter, 'G' | 'M') {
                let with_speed = match letter {
                    'G' => matches!(tenths(value), 40 | 500 | 920 | 960),
                    _ => matches!(tenths(value), 30 | 40),
                };
                while let Some(Token::Word(next, _)) = tokens.get(i) {
                    let ends = match next {
                        'G' => !machine,
                        'S' => !with_speed,
                        'M' | 'T' => true,
                        _ => false,
                    };
                    if ends {
                        break;
                    }
                    i += 1;
                }
            }
            let command = Command { value, parameters: &tokens[first..i], origin };
            let states = letter == 'G' && matches!(tenths(value), 0 | 10) && !machine;
            if states || matches!(letter, 'A'..='C' | 'U'..='W') {
                out.words(&line);
                line.clear();
                self.axes(out, &tokens[first - 1..i], origin);
                continue;
            }
            if out.facts.klartext {
                let ahead = tokens.get(i..).unwrap_or_default();
                self.klartext(out, letter, command, ahead);
                continue;
            }
            match letter {
                'G' if machine => {
                    if out.facts.knows_g(530) {
                        command.push(&mut line, 'G', out);
                        out.forget_motion(find(command.parameters, 'F').is_some());
                    } else {
                        self.left_out('G', 53.0, origin);
                    }
                }
                'G' => self.g_word(&mut line, command, out),
                'M' if tenths(value) == 60 && !out.facts.knows_m(60) => {
                    out.written = [false; 3];
                    out.words(&line);
                    line.clear();
                    let all: Vec<&str> = tokens.iter().filter_map(Token::comment).collect();
                    finish(out, String::new(), &all);
                    says = false;
                    self.change_by_hand(out, origin);
                }
                'M' => self.m_word(&mut line, command, out),
                'T' => {
                    self.tool = Some(value);
                    if out.facts.tools {
                        push_command(&mut line, 'T', value, &[], out);
                    } else {
                        self.left_out('T', value, origin);
                    }
                }
                'S' if out.facts.single => {
                    // Said together with M3 or M4.
                    let turns = |token: &Token| token.is('M', 3.0) || token.is('M', 4.0);
                    self.spindle[1] = Some(value);
                    if let Some(turning) = self.spindle[0]
                        && !tokens[i..].iter().any(turns)
                    {
                        push_command(&mut line, 'M', turning, &[], out);
                        push_command(&mut line, 'S', value, &[], out);
                    }
                }
                'S' => push_command(&mut line, 'S', value, &[], out),
                _ => self.left_out(letter, value, origin),
            }
            if out.facts.single {
                out.words(&line);
                line.clear();
            }
        }
        finish(out, line, if says { &comments } else { &[] });
        match (tokens.is_empty(), self.complete) {
            (true, _) => Written::Nothing,
            (false, true) => Written::All,
            (false, false) => Written::LeftOut,
        }
    }

    /// A G word that is no motion.
    fn g_word(&mut self, line: &mut String, command: Command, out: &mut BlockWriter) {
        let Command { value, parameters, origin } = command;
        let number = tenths(value);
        let known = u32::try_from(number).is_ok_and(|number| out.facts.knows_g(number));
        if matches!(number, 430..=440) {
            self.no_length = !known;
        }
        if !known && matches!(number, 410..=421) {
            self.complete = false;
            let message = "the target knows no compensation, and the path is the contour itself";
            self.tell(
                Diagnostic::error("not-compensated", message)
                    .with_origin(origin)
                    .with_hint("compensate the program first, or write it for a control that does"),
            );
        } else if !known && matches!(number, 400 | 900 | 910) {
            // Nothing is on; of G28, which the other two stand around, it is told.
        } else if !known {
            self.left_out('G', value, origin);
        } else if matches!(number, 400..=421) {
            let mut words = String::new();
            command.push(&mut words, 'G', out);
            out.prefix(&words);
        } else if number == 920 && find(parameters, 'S').is_some() && !out.facts.tape {
            // The fastest speed of the spindle, where G92 knows axes alone.
            self.left_out('G', value, origin);
        } else if number == 490 && self.no_length {
            // What it would end has not begun, however often that is said.
        } else if number == 40 {
            let seconds = ['P', 'X', 'U', 'S'].into_iter().find_map(|word| find(parameters, word));
            push_command(line, 'G', 4.0, &[], out);
            push_command(line, out.facts.dwell, seconds.unwrap_or(0.0), &[], out);
        } else {
            // The value of G64 P is LinuxCNC's own.
            let alone = number == 640 && out.facts.tape;
            let mut kept = parameters.to_vec();
            if !out.facts.axes {
                for token in parameters {
                    if let Token::Word(letter @ ('A'..='C' | 'U'..='W'), value) = *token {
                        self.no_axis(letter, value, origin);
                    }
                }
                kept.retain(|token| !matches!(token, Token::Word('A'..='C' | 'U'..='W', _)));
                if kept.is_empty() && !parameters.is_empty() {
                    // G28 without axes would move all of them.
                    return;
                }
            }
            push_command(line, 'G', value, if alone { &[] } else { &kept }, out);
            if makes_moves(number) {
                out.forget_motion(true);
                // FANUC's lead of a thread is its feed.
                if number == 330 && out.facts.tape {
                    *line = line.replace('K', "F");
                }
            }
        }
    }

    /// An M word, M6 where it is not known apart.
    fn m_word(&mut self, line: &mut String, command: Command, out: &mut BlockWriter) {
        let Command { value, parameters, origin } = command;
        let number = tenths(value);
        out.has_ended |= matches!(number, 20 | 300);
        if out.facts.single && matches!(number, 30 | 40) {
            self.spindle[0] = Some(value);
            self.spindle[1] = find(parameters, 'S').or(self.spindle[1]);
            push_command(line, 'M', value, &[], out);
            if let Some(speed) = self.spindle[1] {
                push_command(line, 'S', speed, &[], out);
            }
        } else if u32::try_from(number).is_ok_and(|number| out.facts.knows_m(number)) {
            if number == 50 {
                self.spindle[0] = None;
            }
            if matches!(number, 0 | 10 | 60 | 600 | 6000) {
                // The operator may move the machine.
                out.written = [false; 3];
            }
            command.push(line, 'M', out);
        } else if out.facts.single && matches!(number, 20 | 300) {
            // The end of the text is the end of the program.
            self.tell(
                Diagnostic::info(
                    "noted",
                    "the program ends with its text: the target knows no M2 or M30",
                )
                .with_origin(origin),
            );
        } else {
            self.left_out('M', value, origin);
        }
    }

    /// What stands for M6 where that is not known.
    fn change_by_hand(&mut self, out: &mut BlockWriter, origin: Origin) {
        let pause = out.facts.pause;
        // Tools with a name have no number.
        let tool = self.tool.filter(|tool| *tool != 0.0);
        let change = tool.map_or("change of tool".into(), |tool| {
            format!("change to tool {}", Decimal::of(tool))
        });
        out.comment(&change);
        out.words(pause);
        let message = format!("{pause} waits for the {change}: the target knows no M6");
        self.tell(Diagnostic::info("tool-change", message).with_origin(origin));
    }

    /// Says that a word is left out, once.
    pub(super) fn left_out(&mut self, letter: char, value: f64, origin: Origin) {
        self.complete = false;
        let word = (letter, tenths(value));
        self.is_cut_off |= letter == 'G' && makes_moves(word.1);
        if self.told.contains(&word) || self.told.len() > MOST_TOLD {
            return;
        }
        self.told.push(word);
        let message =
            format!("{letter}{} is left out: the target does not know it", Decimal::of(value));
        let missing = letter == 'G' && makes_moves(word.1);
        let (severity, hint) = if missing {
            (Severity::Error, "the written program ends before it; choose another target")
        } else {
            (Severity::Warning, "do on the machine what it would do")
        };
        let left_out = Diagnostic::warning("left-out", message).with_origin(origin);
        self.diagnostics.push(Diagnostic { severity, ..left_out.with_hint(hint) });
    }

    /// Axes that a block states, or that are to move with the next one.
    fn axes(&mut self, out: &mut BlockWriter, tokens: &[Token], origin: Origin) {
        for token in tokens {
            if let Token::Word(letter @ ('A'..='C' | 'U'..='W'), value) = *token {
                if out.facts.axes {
                    out.also(letter, value);
                } else {
                    self.no_axis(letter, value, origin);
                }
            }
        }
        if let Some(motion) = find(tokens, 'G') {
            let axis = |letter| find(tokens, letter);
            let motion = if motion == 0.0 { '0' } else { '1' };
            out.state(motion, [axis('X'), axis('Y'), axis('Z')], axis('F'));
        }
    }

    /// Programs for machines with more axes often do no more than to set them to 0.
    fn no_axis(&mut self, letter: char, value: f64, origin: Origin) {
        self.complete = false;
        let word = (letter, i64::from(value != 0.0));
        if !self.told.contains(&word) {
            self.told.push(word);
            let (severity, what, hint) = if value == 0.0 {
                (Severity::Warning, "its zeros", "the axis is taken to be at 0")
            } else {
                (Severity::Error, "its moves", "the part will not be as programmed")
            };
            let message = format!("the target has no axis {letter}: {what} are left out");
            let left_out = Diagnostic::warning("left-out", message).with_origin(origin);
            self.tell(Diagnostic { severity, ..left_out.with_hint(hint) });
        }
    }

    fn tell(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() <= MOST_TOLD {
            self.diagnostics.push(diagnostic);
        }
    }
}

/// Comments stand behind the words; alone where only `;` begins one.
fn finish(out: &mut BlockWriter, mut line: String, comments: &[&str]) {
    let style = out.facts.comments;
    for text in comments {
        let inner = text.strip_prefix(['(', ';']).unwrap_or(text);
        let inner = inner.strip_suffix(')').filter(|_| text.starts_with('(')).unwrap_or(inner);
        if style == Comments::Semicolon {
            out.words(&line);
            line.clear();
            out.comment(inner);
            continue;
        }
        if !line.is_empty() {
            line.push(' ');
        }
        if style == Comments::Both {
            line.push_str(text);
        } else {
            line.push_str(&comment(style, inner));
        }
    }
    if line.starts_with('(') {
        out.line_of_comments(&line);
    } else {
        out.words(&line);
    }
}

/// The number of the program that words begin with, as a comment has it.
pub(super) fn program_number(words: &str) -> Option<u32> {
    let digits = words.strip_prefix("(O")?.split(')').next()?;
    parse_decimal(digits).and_then(whole)
}

/// Whether a G word, by ten times its number, cuts a thread or probes.
fn makes_moves(tenths: i64) -> bool {
    matches!(tenths, 310 | 330 | 331 | 382..=385 | 760)
}

/// Whether words choose a coordinate system.
pub(super) fn has_frame(words: &str) -> bool {
    tokens(words).iter().any(|token| match token {
        Token::Word('G', value) => matches!(tenths(*value), 540..=593 | 920),
        _ => false,
    })
}

/// The words and comments of a text that the reader made.
fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(letter) = rest.chars().next() {
        let is_number = |c: u8| c.is_ascii_digit() || matches!(c, b'+' | b'-' | b'.');
        // Bytes, since slices of text bring the wording of their panics into the wasm.
        let mut end = letter.len_utf8();
        for &byte in rest.as_bytes().get(end..).unwrap_or_default() {
            let ends = match letter {
                ';' => false,
                '(' => byte == b')',
                _ => !is_number(byte),
            };
            end += usize::from(!ends || letter == '(');
            if ends {
                break;
            }
        }
        let (token, tail) = rest.split_at_checked(end).unwrap_or((rest, ""));
        if matches!(letter, ';' | '(') {
            tokens.push(Token::Comment(token));
        } else if let Some(value) = token.get(1..).and_then(parse_decimal) {
            tokens.push(Token::Word(letter, value));
        }
        rest = tail.trim_start();
    }
    tokens
}

pub(super) fn find(tokens: &[Token], letter: char) -> Option<f64> {
    tokens.iter().find_map(|token| match token {
        Token::Word(found, value) if *found == letter => Some(*value),
        _ => None,
    })
}

pub(super) fn push_command(
    line: &mut String,
    letter: char,
    value: f64,
    parameters: &[Token],
    out: &BlockWriter,
) {
    if !line.is_empty() {
        line.push(' ');
    }
    // Not `contains`, which searches for other letters as for a text, by the code of a long search.
    if LENGTHS.chars().any(|length| length == letter) {
        push_length(line, letter, out.units(value), out.facts);
    } else {
        push_word(line, letter, value);
    }
    for parameter in parameters {
        if let Token::Word(letter, value) = *parameter {
            push_command(line, letter, value, &[], out);
        }
    }
}

/// Ten times the number of a word.
pub(super) fn tenths(value: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "at most 1e10")]
    let tenths = (value * 10.0).round() as i64;
    tenths
}
