//! How a control reads the words that concern compensation.

/// What differs from control to control. By default everything that has a meaning is read, as the
/// textbook's machine does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a rule of its own")]
pub struct Rules {
    /// Any move leads in, an arc too, and any straight one leads out, along the normal of the plane
    /// or of no length too; arcs are taken as they are stated.
    pub any_lead: bool,
    /// What may not change while compensation is on ends the program where it is asked for.
    pub is_strict: bool,
    /// Without a D word, and with D0, the tool is the one that the last M6 put into the spindle.
    pub spindle_tool: bool,
    /// Blocks that begin with / are left out: the switch of the control is on.
    pub block_delete: bool,
}
