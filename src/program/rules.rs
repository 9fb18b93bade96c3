//! How a control reads the words that concern compensation.

/// What differs from control to control. By default everything that has a meaning is read, as the
/// textbook's machine does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rules {
    /// An arc may be the first move of compensation.
    pub arc_lead_in: bool,
}
