//! What the comparisons with other libraries share: curves, competitors, the race between them, and
//! the truth they are held against.

pub mod competitors;
pub mod curves;
#[path = "../../../tests/common/double.rs"]
mod double;
#[path = "../../../tests/common/equidistant.rs"]
mod equidistant;
pub mod outlines;
pub mod race;
pub mod truth;
#[path = "../../../tests/common/curves.rs"]
mod type_points;
