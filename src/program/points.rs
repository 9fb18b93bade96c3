//! Lengths without a point, which controls of FANUC's may count in thousandths.
//!
//! FANUC, Series 30i Parameter Manual: bit 0 (DPI) of parameter 3401 tells whether a number without a
//! point counts least increments, as it does by default, or whole units, as on a pocket calculator.

use super::dialect::Dialect;
use super::lexer::{LineReader, quote};
use crate::diagnostic::{Diagnostic, Severity};

/// Beyond most machines, if it counts whole units.
const LARGE: f64 = 1000.0;

/// What the lengths of a program look like.
#[derive(Debug, Default)]
pub(super) struct Points {
    /// One has a point.
    pointed: bool,
    /// The first without one, until it is told.
    bare: Option<Diagnostic>,
    /// It was found.
    found: bool,
}

impl LineReader<'_> {
    /// Tells once of lengths without a point, where others have one or they are large; the value.
    pub(super) fn pointed(&mut self, letter: u8, value: f64, point: bool, from: usize) -> f64 {
        let is_length = matches!(letter, b'X'..=b'Z' | b'I'..=b'K' | b'R');
        if self.dialect != Dialect::Fanuc || !is_length || value == 0.0 || self.calls {
            return value;
        }
        // Of a dwell it is known what the number counts.
        let dwells = self.block.words.iter().any(|word| word.letter == 'G' && word.value == 4.0);
        let points = &mut self.interpreter.points;
        points.pointed |= point;
        if !point && !points.found && !dwells {
            points.found = true;
            let text = quote(self.cursor.since(from).trim_end());
            let message = format!("{text} has no point; it counts whole units here");
            let hint = "a control may count thousandths of them: write points";
            let at = self.block.origin_at(self.cursor.column(from));
            let told = Diagnostic::error("no-point", message).with_origin(at).with_hint(hint);
            points.bare = Some(Diagnostic { severity: Severity::Warning, ..told });
        }
        if (points.pointed || !point && value.abs() >= LARGE)
            && let Some(told) = points.bare.take()
        {
            self.interpreter.report.push(told);
        }
        value
    }
}
