//! Polylines within a tolerance of arcs and cubics.

use glam::DVec2;

use super::{Arc, Cubic};

/// Most chords one curve is cut into; reached only by tolerances far below a nanometre.
const MAX_CHORDS: f64 = 1e6;

/// Calls `add` with points along `arc` after its start, up to and with its end, whose chords are
/// within `tolerance` [mm] of it.
pub fn flatten_arc(arc: &Arc, tolerance: f64, add: &mut dyn FnMut(DVec2)) {
    // Sagitta of a chord over the angle 2a: R (1 − cos a) ≤ tolerance, where
    // (1 − cos a) / (1 + cos a) = tan²(a/2).
    let rise = (tolerance / arc.radius()).clamp(1e-15, 1.0);
    let quarter_angle = (rise / (2.0 - rise)).sqrt().atan();
    let chords = (arc.sweep().abs() / (4.0 * quarter_angle)).ceil().clamp(1.0, MAX_CHORDS);
    let mut i = 1.0;
    while i < chords {
        add(arc.point(i / chords));
        i += 1.0;
    }
    add(arc.end());
}

/// Calls `add` with points along `cubic` after its start, up to and with its end, whose chords
/// are within `tolerance` [mm] of it.
pub fn flatten_cubic(cubic: &Cubic, tolerance: f64, add: &mut dyn FnMut(DVec2)) {
    // Wang's bound for equal steps: n² ≥ max|C''| / (8 tolerance); C'' is linear in t, so its
    // largest value stands at an end.
    let bend = cubic.second_derivative(0.0).length().max(cubic.second_derivative(1.0).length());
    let chords = (bend / (8.0 * tolerance)).sqrt().ceil().clamp(1.0, MAX_CHORDS);
    let mut i = 1.0;
    while i < chords {
        add(cubic.point(i / chords));
        i += 1.0;
    }
    add(cubic.end());
}
