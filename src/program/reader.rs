//! A program as a text that is ready to run.

use std::sync::Arc;

use super::dialect::Dialect;
use super::outline::Outline;

/// The text of a program and where its subprograms and loops are. Its blocks are read as it runs.
///
/// Copies share the text.
#[derive(Debug, Clone)]
pub struct Program {
    pub(super) outline: Arc<Outline>,
}

impl Program {
    /// Reads the outline of a program. What is wrong with it, [`super::interpret`] reports.
    #[must_use]
    pub fn parse(text: &str, dialect: Dialect) -> Self {
        Self::from_text(text.to_owned(), dialect)
    }

    /// The same of a text that it keeps instead of a copy.
    #[must_use]
    pub fn from_text(text: String, dialect: Dialect) -> Self {
        Self { outline: Arc::new(Outline::new(text, dialect)) }
    }

    /// The dialect that it is read in; [`Dialect::Auto`] where its text shows no sign of any.
    #[must_use]
    pub fn dialect(&self) -> Dialect {
        self.outline.dialect
    }
}
