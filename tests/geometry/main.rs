//! Plane geometry against closed forms and brute force.

#[path = "../common/mod.rs"]
mod common;

mod akima;
mod arc_fit;
mod arcs;
mod bounds;
mod chains;
mod corner_cuts;
mod flatten;
mod intersections;
mod involutes;
mod lengths;
mod nearest;
mod nurbs;
mod roots;
mod shapes;
mod spline_edits;
mod splines;
