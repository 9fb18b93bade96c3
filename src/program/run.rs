//! Running a program: block by block through an interpreter.

use super::interpret::{Flow, Interpreter};
use super::items::Item;
use super::reader::{Program, after_end};
use super::rules::Rules;
use crate::diagnostic::Diagnostic;

/// What a program means: its steps in order, and what was found on the way.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Interpretation {
    /// The steps of the program.
    pub items: Vec<Item>,
    /// What was found when reading and interpreting it, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

/// Interprets a program by the `rules` of a control.
#[must_use]
pub fn interpret(program: &Program, rules: Rules) -> Interpretation {
    let mut interpreter = Interpreter::new(rules);
    let mut blocks = program.blocks.iter();
    let mut last = None;
    for block in blocks.by_ref() {
        last = Some(block.origin());
        if block.skippable && rules.block_delete {
            continue;
        }
        if interpreter.block(block) == Flow::End {
            break;
        }
    }
    interpreter.finish_spline();
    interpreter.course.end(last, &mut interpreter.report);
    if let Some(block) = blocks.next().filter(|_| !interpreter.is_refused) {
        interpreter.report.push(after_end(block.line));
    }
    interpreter.report.extend(program.diagnostics.iter().cloned());
    Interpretation {
        items: interpreter.course.into_items(),
        diagnostics: interpreter.report.finish(),
    }
}
