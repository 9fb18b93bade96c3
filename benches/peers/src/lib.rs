//! What the comparisons with other libraries share: curves, competitors, and the race between them.

pub mod competitors;
pub mod curves;
pub mod race;
