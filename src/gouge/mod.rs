//! The judge: finds where a path cuts into its contour, anywhere.
//!
//! It asks one question of every point of a path, however it was made: is it nearer than the tool
//! radius to any point of the contour? A tree of boxes tells which pieces of the contour a move may be
//! too near to. Of such a pair a lower bound of the distance is taken: exact for lines
//! and arcs ([`exact`]), of high order for cubics ([`bound`]), so a move that follows its segment
//! is proved to be clear as a whole. Only where that does not settle it are the curves ([`part`])
//! halved. No look-ahead: every move is held against the whole contour. It shares nothing with
//! `compensation`, whose work it judges, but `geometry`.

mod bound;
mod check;
mod exact;
mod part;

pub use check::{check, check_all};
