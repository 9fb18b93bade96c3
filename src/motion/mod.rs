//! Motion along any path: pieces by arc length, corners rounded, speed planned, samples in time.
//!
//! This floor plans any path and never asks where it came from. Lengths are in mm, times in s.

mod corner;
mod helix;
mod piece;
mod straight;

pub use corner::{Corner, CornerCurve, CornerShape};
pub use helix::Helix;
pub use piece::{Frame, Piece};
pub use straight::Straight;
