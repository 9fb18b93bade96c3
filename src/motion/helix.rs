//! A circular arc or a helix by arc length.

use glam::{DVec2, DVec3};

use super::Frame;
use crate::contour::Plane;
use crate::geometry::{Arc, perp, sin_cos};

/// A circular arc in space, or a helix where it climbs along its axis.
///
/// # Guarantees
/// Radius and length are positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    /// Its centre at the height of the start [mm].
    center: DVec3,
    /// From the centre to the start [mm].
    radius: DVec3,
    /// The same turned by 90° in the sense of motion [mm].
    ahead: DVec3,
    /// Climb per length [1], along the axis: the sine of the angle of climb.
    climb: DVec3,
    /// Angle per length [rad/mm].
    rate: f64,
    /// Arc length [mm].
    pub(super) length: f64,
}

impl Helix {
    /// The arc in its plane, climbing evenly from the first height to the second [mm].
    ///
    /// An arc that [winds](Arc::winding) in or out is taken as the circle of its start.
    #[must_use]
    pub fn of_arc(arc: &Arc, plane: Plane, heights: [f64; 2]) -> Self {
        let flat = arc.length();
        let rise = heights[1] - heights[0];
        let length = flat.hypot(rise);
        let radius = arc.start() - arc.center();
        Self {
            center: plane.place(arc.center(), heights[0]),
            radius: plane.place(radius, 0.0),
            ahead: plane.place(perp(radius) * arc.sweep().signum(), 0.0),
            climb: plane.place(DVec2::ZERO, rise / length),
            rate: arc.sweep().abs() / length,
            length,
        }
    }

    /// Point and derivatives at the arc length `s` [mm]. The error of the point is that of
    /// rounding: about 1e-16 of the distance from the origin and of the radius per turn.
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        let (sin, cos) = sin_cos(s * self.rate);
        let out = self.radius * cos + self.ahead * sin;
        let on = self.ahead * cos - self.radius * sin;
        let square = self.rate * self.rate;
        Frame {
            point: self.center + out + self.climb * s,
            tangent: on * self.rate + self.climb,
            curvature: out * -square,
            sharpness: on * (-square * self.rate),
        }
    }

    /// The part from one arc length to another [mm].
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        let (sin, cos) = sin_cos(from * self.rate);
        Self {
            center: self.center + self.climb * from,
            radius: self.radius * cos + self.ahead * sin,
            ahead: self.ahead * cos - self.radius * sin,
            length: to - from,
            ..*self
        }
    }
}
