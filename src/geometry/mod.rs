//! Curves and numbers in the plane: it knows points and parameters, no tools, feeds or blocks.
//!
//! Lengths are in mm, angles in rad and counter-clockwise positive. A curve is traversed by a
//! parameter `t` in `[0, 1]`; the left normal of a tangent `T` is `perp(T) = (-Ty, Tx)`, and
//! curvature is positive where the curve turns left.

mod akima;
mod arc;
mod arc_fit;
mod arc_proof;
mod bernstein;
mod bounds;
mod box_tree;
mod corner_cut;
mod cubic;
mod curve;
mod decimal;
mod flatten;
mod golden;
pub mod intersect;
mod involute;
mod length;
mod line;
mod nearest;
mod nth_root;
mod nurbs;
mod sine;
mod sort;
mod spline;
mod spline_edit;
mod spline_rows;
mod tridiagonal;
mod vector;

pub use akima::akima;
pub use arc::{Arc, RadiusForm};
pub use arc_fit::{ArcOrLine, fit_arcs};
pub use bernstein::{halve, roots};
pub use bounds::Bounds;
pub use box_tree::{BoxTree, FAN, TOLD_BY, is_tangled, visit_leaves};
pub use corner_cut::{CornerCut, CornerMeasure, CornerSize, cut_corner};
pub use cubic::Cubic;
pub use curve::{Curve, CurveError, MAX_COORDINATE, MIN_LENGTH, in_range};
pub use decimal::{Decimal, parse_decimal, push_fixed};
pub use flatten::{flatten_arc, flatten_cubic};
pub use golden::least;
pub use involute::Involute;
pub use length::gauss_legendre;
pub use line::Line;
pub use nearest::Nearest;
pub use nth_root::nth_root;
pub use nurbs::{Nurbs, NurbsError};
pub use sine::sin_cos;
pub use sort::{sort_long, sort_pairs, sort_short};
pub use spline::{EndCondition, Parameter, Spline, SplineEnds};
pub use spline_edit::{ChangedSpans, Least, SplineEdit};
pub use vector::{cross, direction, perp, relative_to, rotate, turn};
