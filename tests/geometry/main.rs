//! Plane geometry against closed forms and brute force.

#[path = "../common/mod.rs"]
mod common;

mod arc_fit;
mod arcs;
mod bounds;
mod flatten;
mod intersections;
mod lengths;
mod nearest;
mod roots;
mod shapes;
mod spline_edits;
mod splines;
