//! What went wrong or deserves notice, where, and what to do about it.
//!
//! Every stage returns its output *and* a list of [`Diagnostic`]s; a mistake in a program or an
//! impossible piece of geometry never stops the work as a whole.

use std::fmt;

use glam::DVec2;

/// How much a diagnostic matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing; the path is what was asked for.
    Info,
    /// The path is usable but not what the program literally says.
    Warning,
    /// The path is wrong or missing at this place.
    Error,
}

/// The place in the input that a segment, a move or a diagnostic comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A block of a program.
    Block {
        /// Line of the text, counted from 1.
        line: u32,
        /// The N word, if the block has one.
        number: Option<u32>,
        /// Column of the word concerned, counted from 1 in characters.
        column: Option<u32>,
    },
    /// A segment of a contour given from code, counted from 0.
    Segment(u32),
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Block { line, number, column } => {
                write!(f, "line {line}")?;
                if let Some(number) = number {
                    write!(f, " (N{number})")?;
                }
                if let Some(column) = column {
                    write!(f, ", column {column}")?;
                }
                Ok(())
            }
            Self::Segment(index) => write!(f, "segment {index}"),
        }
    }
}

/// One finding of one stage.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// How much it matters.
    pub severity: Severity,
    /// Stable name in kebab-case, for programs to match on.
    pub code: &'static str,
    /// One lower-case sentence with the values, for people to read.
    pub message: String,
    /// What to do about it.
    pub hint: Option<String>,
    /// The point concerned, in program coordinates [mm].
    pub at: Option<DVec2>,
    /// The block or segment concerned.
    pub origin: Option<Origin>,
    /// How deep the tool cuts into material that should stay [mm].
    pub depth: Option<f64>,
    /// All segments concerned, where there is more than one.
    pub segments: Vec<Origin>,
}

// Never inlined: a hundred places make a diagnostic, none of them in a hurry, and each copy of
// these counts in WebAssembly.
impl Diagnostic {
    /// A finding that the user need not act on.
    pub fn info(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Info, code, message.into())
    }

    /// A finding after which the path is still usable.
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, message.into())
    }

    /// A finding after which the path is wrong or missing at this place.
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, message.into())
    }

    #[inline(never)]
    fn new(severity: Severity, code: &'static str, message: String) -> Self {
        Self {
            severity,
            code,
            message,
            hint: None,
            at: None,
            origin: None,
            depth: None,
            segments: Vec::new(),
        }
    }

    /// Adds what to do about it.
    #[inline(never)]
    #[must_use]
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// Adds the point concerned [mm].
    #[inline(never)]
    #[must_use]
    pub fn with_point(mut self, at: DVec2) -> Self {
        self.at = Some(at);
        self
    }

    /// Adds the block or segment concerned.
    #[inline(never)]
    #[must_use]
    pub fn with_origin(mut self, origin: Origin) -> Self {
        self.origin = Some(origin);
        self
    }

    /// Adds how deep the tool cuts into material that should stay [mm].
    #[inline(never)]
    #[must_use]
    pub fn with_depth(mut self, depth: f64) -> Self {
        self.depth = Some(depth);
        self
    }

    /// Adds all segments concerned.
    #[inline(never)]
    #[must_use]
    pub fn with_segments(mut self, segments: impl Into<Vec<Origin>>) -> Self {
        self.segments = segments.into();
        self
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(origin) = &self.origin {
            write!(f, "{origin}: ")?;
        }
        write!(f, "{} [{}]", self.message, self.code)
    }
}
