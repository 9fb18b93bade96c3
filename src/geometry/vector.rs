//! The few vector operations of the plane that `glam` has under other names or not at all.

use glam::DVec2;

use super::sin_cos;

/// The left normal of `v`: `v` turned counter-clockwise by 90°.
#[must_use]
pub fn perp(v: DVec2) -> DVec2 {
    DVec2::new(-v.y, v.x)
}

/// The z component of `a × b`: positive where `b` points to the left of `a`.
#[must_use]
pub fn cross(a: DVec2, b: DVec2) -> f64 {
    a.x * b.y - a.y * b.x
}

/// The turn from direction `a` to direction `b`, in `(-π, π]` rad, positive to the left.
#[must_use]
pub fn turn(a: DVec2, b: DVec2) -> f64 {
    let angle = cross(a, b).atan2(a.dot(b));
    // atan2 gives −π for a negative zero; a reversal has one name only.
    if angle == -std::f64::consts::PI { std::f64::consts::PI } else { angle }
}

/// `v` turned counter-clockwise by `angle` rad.
#[must_use]
pub fn rotate(v: DVec2, angle: f64) -> DVec2 {
    let (sin, cos) = sin_cos(angle);
    DVec2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
}

/// The control points of a cubic as seen from `origin`.
#[must_use]
pub fn relative_to(origin: DVec2, [a, b, c, d]: [DVec2; 4]) -> [DVec2; 4] {
    [a - origin, b - origin, c - origin, d - origin]
}

/// The unit vector along `v`, or `None` where `v` is too short to have a direction.
#[must_use]
pub fn direction(v: DVec2) -> Option<DVec2> {
    v.try_normalize()
}
