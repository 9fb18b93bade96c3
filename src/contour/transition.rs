//! A transition: how the offsets of two segments are joined at a corner.

use glam::DVec2;

use crate::diagnostic::Origin;

/// The three transitions of "Tool radius compensation algorithm of spline curve", 2.3.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TransitionKind {
    /// Inside corner: both offsets are cut back to their intersection.
    Shortened,
    /// Obtuse outside corner: both offsets run on to their intersection.
    Elongated,
    /// Acute outside corner: further moves are inserted.
    Inserted,
}

/// One transition and how it was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Transition {
    /// Which of the three.
    pub kind: TransitionKind,
    /// Angle between the segments on the workpiece side, α [rad].
    pub angle: f64,
    /// The programmed corner [mm].
    pub corner: DVec2,
    /// The points of its construction by name [mm], in the order in which they are found: `P` the
    /// corner, `N1` and `N2` the tool centres at the ends of both offsets, `V` the vertex of the
    /// transition vector, `A1` and `A2` the ends of the inserted straight move.
    pub construction: Vec<(&'static str, DVec2)>,
    /// The segment or block that leads out of the corner.
    pub origin: Origin,
}
