//! Reading a whole program: never failing, always saying what was not understood.

use super::block::Block;
use super::dialect::Dialect;
use super::lexer::{Line, read_line};
use super::report::Report;
use crate::diagnostic::{Diagnostic, Origin};

/// A program as read: blocks of words, not yet their meaning.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Program {
    /// Its blocks in order; blank lines are left out.
    pub blocks: Vec<Block>,
    /// What could not be read.
    pub diagnostics: Vec<Diagnostic>,
}

impl Program {
    /// Reads a program. What cannot be read is left out, with a diagnostic that says where.
    #[must_use]
    pub fn parse(text: &str, dialect: Dialect) -> Self {
        let _ = dialect.of(text);
        let mut report = Report::default();
        let mut blocks = Vec::new();
        let mut opened = false;
        let mut ended = false;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        // Lines end in LF, CR LF or, in old files, CR alone.
        let lines =
            text.split('\n').flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'));
        for (line, text) in (1_u32..).zip(lines) {
            if ended {
                if !text.trim().is_empty() {
                    report.push(after_end(line));
                    break;
                }
                continue;
            }
            match read_line(text, line, &mut report) {
                Line::Blank => {}
                // Comments may stand before the first.
                Line::Percent if !opened && blocks.iter().all(is_comment) => opened = true,
                Line::Percent => ended = true,
                Line::Block(block) => blocks.push(block),
            }
        }
        Self { blocks, diagnostics: report.finish() }
    }
}

/// Whether a block says nothing to a control.
fn is_comment(block: &Block) -> bool {
    block.words.is_empty()
}

/// The diagnostic for text that no control reads.
pub(super) fn after_end(line: u32) -> Diagnostic {
    Diagnostic::warning("after-end", "the program has ended; what follows is not read")
        .with_origin(Origin::Block { line, number: None, column: None })
        .with_hint("put subprograms into the program where they are called")
}
