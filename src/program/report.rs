//! A list of diagnostics that stays short however bad the program is.

use crate::diagnostic::{Diagnostic, Origin, Severity};
use crate::geometry::sort_short;

/// How many diagnostics of one code are listed; the rest are only counted, so that a file of
/// noise gives a list that can be read and sent on.
const MOST_OF_A_CODE: u32 = 100;

/// Collects diagnostics, the first hundred of each code, each once however often its block is run.
#[derive(Debug, Default)]
pub(super) struct Report {
    diagnostics: Vec<Diagnostic>,
    counts: Vec<Count>,
}

/// How often a code was found.
#[derive(Debug)]
struct Count {
    /// How often in all.
    found: u32,
    /// How many of these are listed.
    listed: u32,
    /// The first that is not listed; until there is one, the first of all.
    first: Diagnostic,
}

impl Report {
    pub(super) fn push(&mut self, diagnostic: Diagnostic) {
        let Some(count) = self.counts.iter_mut().find(|count| count.first.code == diagnostic.code)
        else {
            self.counts.push(Count { found: 1, listed: 1, first: diagnostic.clone() });
            self.diagnostics.push(diagnostic);
            return;
        };
        let none_left_out = count.found == count.listed;
        count.found = count.found.saturating_add(1);
        let repeats = |listed: &Diagnostic| {
            listed.origin == diagnostic.origin
                && listed.code == diagnostic.code
                && listed.message == diagnostic.message
        };
        if count.listed < MOST_OF_A_CODE && !self.diagnostics.iter().rev().any(repeats) {
            count.listed += 1;
            self.diagnostics.push(diagnostic);
        } else if none_left_out {
            count.first = diagnostic;
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
        self.list(Severity::Error, code, message.into(), origin, hint);
    }

    /// Reports what may not be what is meant, and what to do about it.
    pub(super) fn warning(
        &mut self,
        code: &'static str,
        message: impl Into<String>,
        origin: Origin,
        hint: &str,
    ) {
        self.list(Severity::Warning, code, message.into(), origin, hint);
    }

    #[inline(never)]
    fn list(
        &mut self,
        severity: Severity,
        code: &'static str,
        message: String,
        origin: Origin,
        hint: &str,
    ) {
        let found = Diagnostic::error(code, message);
        self.push(Diagnostic { severity, ..found }.with_origin(origin).with_hint(hint));
    }

    pub(super) fn extend(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        for diagnostic in diagnostics {
            self.push(diagnostic);
        }
    }

    /// The diagnostics in the order of the text, those without a place last.
    pub(super) fn finish(mut self) -> Vec<Diagnostic> {
        for Count { found, listed, first } in self.counts {
            if found > listed {
                let further = found - listed;
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
    fn what_is_found_again_at_the_same_place_is_only_counted() {
        let mut report = Report::default();
        for line in [1, 2, 1, 1, 2, 1] {
            let origin = Origin::Block { line, number: None, column: None };
            report.push(Diagnostic::error("noise", "noise").with_origin(origin));
        }
        let diagnostics = report.finish();
        assert_eq!(diagnostics.len(), 3, "one of each line, one for the rest: {diagnostics:?}");
        assert!(diagnostics[1].message.starts_with("4 further"), "{}", diagnostics[1]);
    }

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
