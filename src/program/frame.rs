//! From programmed coordinates to program coordinates: what G16, G52, G68, G51 and G51.1 do.
//!
//! The order is that of FANUC: first mirrored, then scaled, then turned, and what comes of it
//! counts from the local origin.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use crate::contour::Plane;
use crate::geometry::rotate;

/// Polar coordinates (G16): the first axis of the plane is a radius, the second an angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Polar {
    /// The pole in the plane, in programmed coordinates [mm].
    pub(super) pole: DVec2,
    /// The angle in effect [rad].
    pub(super) angle: f64,
}

/// What stands between the numbers of the words and those of the active coordinate system.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    /// G52: the local origin [mm].
    pub(super) local: DVec3,
    /// G51.1: where each axis is mirrored [mm].
    pub(super) mirror: [Option<f64>; 3],
    /// G51: the factor of each axis.
    pub(super) factors: DVec3,
    /// G51: the point that scaling leaves where it is [mm].
    pub(super) fixed: DVec3,
    /// G68: the plane, its point that stays [mm], and the angle [rad].
    pub(super) rotation: Option<(Plane, DVec2, f64)>,
    /// G16.
    pub(super) polar: Option<Polar>,
}

impl Frame {
    pub(super) fn new() -> Self {
        Self {
            local: DVec3::ZERO,
            mirror: [None; 3],
            factors: DVec3::ONE,
            fixed: DVec3::ZERO,
            rotation: None,
            polar: None,
        }
    }

    /// The program coordinates of a programmed point [mm].
    pub(super) fn map(&self, mut point: DVec3) -> DVec3 {
        self.mirrored(&mut point);
        point = self.fixed + (point - self.fixed) * self.factors;
        self.turned(&mut point, 1.0);
        point + self.local
    }

    /// The programmed coordinates of a point in program coordinates [mm].
    pub(super) fn unmap(&self, point: DVec3) -> DVec3 {
        let mut point = point - self.local;
        self.turned(&mut point, -1.0);
        point = self.fixed + (point - self.fixed) / self.factors;
        self.mirrored(&mut point);
        point
    }

    fn mirrored(&self, point: &mut DVec3) {
        for i in 0..3 {
            if let Some(at) = self.mirror[i] {
                point[i] = 2.0 * at - point[i];
            }
        }
    }

    fn turned(&self, point: &mut DVec3, sign: f64) {
        if let Some((plane, center, angle)) = self.rotation {
            let (flat, height) = plane.split(*point);
            *point = plane.place(center + rotate(flat - center, sign * angle), height);
        }
    }

    /// Whether left is right in the plane: arcs turn the other way, and compensation changes sides.
    pub(super) fn flips(&self, plane: Plane) -> bool {
        let [first, second, _] = plane.axes();
        let turned = |i: usize| (self.factors[i] < 0.0) != self.mirror[i].is_some();
        turned(first) != turned(second)
    }

    /// The factor of lengths in the plane; `None` where circles do not stay circles.
    pub(super) fn factor(&self, plane: Plane) -> Option<f64> {
        let [first, second, _] = plane.axes();
        let [a, b] = [self.factors[first].abs(), self.factors[second].abs()];
        let stays = self.rotation.is_none_or(|(turned, ..)| turned == plane);
        (a == b && stays).then_some(a)
    }
}

/// The point at `radius` [mm] and `angle` [rad] from `pole`.
pub(super) fn polar_point(pole: DVec2, radius: f64, angle: f64) -> DVec2 {
    pole + rotate(DVec2::new(radius, 0.0), angle)
}

/// An angle as programmed [rad].
pub(super) fn radians(degrees: f64) -> f64 {
    degrees * (PI / 180.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_mapped_comes_back() {
        let mut frame = Frame::new();
        frame.local = DVec3::new(10.0, -3.0, 2.0);
        frame.mirror = [Some(4.0), None, None];
        frame.factors = DVec3::new(2.0, 2.0, -0.5);
        frame.fixed = DVec3::new(1.0, 2.0, 3.0);
        frame.rotation = Some((Plane::Xy, DVec2::new(5.0, 6.0), 0.7));
        let point = DVec3::new(-7.0, 8.0, 9.0);
        assert!(frame.unmap(frame.map(point)).distance(point) < 1e-12, "{frame:?}");
        assert!(frame.flips(Plane::Xy) && frame.flips(Plane::Yz), "one axis of each is mirrored");
        assert_eq!(frame.factor(Plane::Xy), Some(2.0), "circles stay circles");
        assert_eq!(frame.factor(Plane::Yz), None, "and do not");
    }
}
