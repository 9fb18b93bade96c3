//! The judge: finds where a path cuts into its contour, anywhere.
//!
//! It asks one question of every point of a path, however it was made: is it nearer than the tool
//! radius to any point of the contour? Path and contour are cut into chords whose sagitta is known
//! ([`chord`]); a tree of boxes ([`tree`]) tells which pairs of chords may be too near, and only for
//! those the curves themselves are asked. No look-ahead: every move is held against the whole
//! contour. It shares nothing with `compensation`, whose work it judges.

mod check;
mod chord;
mod tree;

pub use check::check;
