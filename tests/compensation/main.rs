//! Compensation against closed forms, brute force, a control's rule table and symmetries.

#[path = "../common/mod.rs"]
mod common;

mod arcs_only;
mod attributes;
mod avoided;
mod brute;
mod closed_forms;
mod control_corners;
mod corners;
mod deviation;
mod families;
mod fuzz;
mod given_cubics;
mod gouges;
mod inside_corners;
mod involutes;
mod judge;
mod judged;
mod leads;
mod live;
mod million;
mod nearly;
mod pockets;
mod policies;
mod proved;
mod radii;
mod random_contours;
mod reversals;
mod sketch;
mod splines;
mod symmetries;
mod table;
mod true_errors;
mod type_points;
mod verdict;
mod walls;
mod whole_contour;
