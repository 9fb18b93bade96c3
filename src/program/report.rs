//! A list of diagnostics that stays short however bad the program is.

use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::sort_short;

/// How many diagnostics of one code are listed; the rest are only counted, so that a file of
/// noise gives a list that can be read and sent on.
const MOST_OF_A_CODE: u32 = 100;

/// Collects diagnostics, the first hundred of each code.
#[derive(Debug, Default)]
pub(super) struct Report {
    diagnostics: Vec<Diagnostic>,
    /// For each code how many there were, and the first that was not listed.
    counts: Vec<(u32, Diagnostic)>,
}

impl Report {
    pub(super) fn push(&mut self, diagnostic: Diagnostic) {
        let seen = self.counts.iter_mut().find(|(_, first)| first.code == diagnostic.code);
        match seen {
            None => {
                self.counts.push((1, diagnostic.clone()));
                self.diagnostics.push(diagnostic);
            }
            Some((count, first)) => {
                *count = count.saturating_add(1);
                if *count <= MOST_OF_A_CODE {
                    self.diagnostics.push(diagnostic);
                } else if *count == MOST_OF_A_CODE + 1 {
                    *first = diagnostic;
                }
            }
        }
    }

    /// Reports what cannot be done as programmed, and what is done instead.
    pub(super) fn error(
        &mut self,
        code: &'static str,
        message: impl Into<String>,
        origin: Origin,
        hint: &str,
    ) {
        self.push(Diagnostic::error(code, message).with_origin(origin).with_hint(hint));
    }

    /// Reports what may not be what is meant, and what to do about it.
    pub(super) fn warning(
        &mut self,
        code: &'static str,
        message: impl Into<String>,
        origin: Origin,
        hint: &str,
    ) {
        self.push(Diagnostic::warning(code, message).with_origin(origin).with_hint(hint));
    }

    pub(super) fn extend(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        for diagnostic in diagnostics {
            self.push(diagnostic);
        }
    }

    /// The diagnostics in the order of the text, those without a place last.
    pub(super) fn finish(mut self) -> Vec<Diagnostic> {
        for (count, first) in self.counts {
            if count > MOST_OF_A_CODE {
                let further = count - MOST_OF_A_CODE;
                let message = format!("{further} further like this; the first: {}", first.message);
                self.diagnostics.push(Diagnostic { message, ..first });
            }
        }
        sort_short(&mut self.diagnostics, |diagnostic| match diagnostic.origin {
            Some(Origin::Block { line, column, .. }) => (line, column.unwrap_or(0)),
            _ => (u32::MAX, 0),
        });
        self.diagnostics
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_is_listed_a_hundred_times_and_then_counted() {
        let mut report = Report::default();
        for line in 1..=1000 {
            let origin = Origin::Block { line, number: None, column: None };
            report.push(Diagnostic::error("noise", "noise").with_origin(origin));
        }
        report.push(Diagnostic::info("other", "another code"));
        let diagnostics = report.finish();
        assert_eq!(diagnostics.len(), 102, "100, one for the rest, one other");
        assert!(diagnostics[100].message.starts_with("900 further"), "{}", diagnostics[100]);
    }
}
