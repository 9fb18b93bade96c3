//! Tool radius compensation of contours made of lines, arcs and splines through type points.

pub mod compensation;
pub mod contour;
pub mod diagnostic;
pub mod geometry;
#[cfg(feature = "js")]
pub mod js;
