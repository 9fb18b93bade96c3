//! What a program itself asks of corners and leads, on controls that have words for it.

/// How the corner at the start of a segment is to be gone round, if it is an outside one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CornerWish {
    /// As is chosen for the whole contour.
    #[default]
    AsChosen,
    /// By straight moves (G25 of ISG and Beckhoff controls).
    Linear,
    /// By an arc about it (their G26; FANUC's G39).
    Arc,
    /// By a conic between the arc, 0, and the intersection of both offsets, 100 (SINUMERIK's G450
    /// with DISC).
    Conic(u8),
    /// To where both offsets meet (SINUMERIK's G451).
    Intersection,
}

/// How a lead is to join the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LeadWish {
    /// As is chosen for the whole contour.
    #[default]
    AsChosen,
    /// Straight to beside the start of the first segment (NORM of SINUMERIK, G138 of ISG).
    Perpendicular,
    /// Round an outside corner, as any other (KONT, G139).
    Round,
}

/// What a program asks of the corner at the start of a segment, or of a lead.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wish {
    /// Of the corner.
    pub corner: CornerWish,
    /// Of a lead.
    pub lead: LeadWish,
}
