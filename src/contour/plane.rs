//! The plane in which a contour lies, and the third axis that stands on it.

use glam::{DVec2, DVec3};

/// A plane of two axes, as G17, G18 and G19 choose it. Seen from the positive side of its normal, a
/// turn from the first axis to the second is counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Plane {
    /// G17: x and y; the height is z.
    #[default]
    Xy,
    /// G18: z and x; the height is y.
    Zx,
    /// G19: y and z; the height is x.
    Yz,
}

impl Plane {
    /// The indices, in x, y, z, of its first and second axis and of its normal.
    #[must_use]
    pub fn axes(self) -> [usize; 3] {
        match self {
            Self::Xy => [0, 1, 2],
            Self::Zx => [2, 0, 1],
            Self::Yz => [1, 2, 0],
        }
    }

    /// The point in the plane, and the height above it, of a point of space [mm].
    #[must_use]
    pub fn split(self, point: DVec3) -> (DVec2, f64) {
        let [first, second, normal] = self.axes();
        (DVec2::new(point[first], point[second]), point[normal])
    }

    /// The point of space at a point of the plane and a height above it [mm].
    #[must_use]
    pub fn place(self, point: DVec2, height: f64) -> DVec3 {
        let [first, second, normal] = self.axes();
        let mut place = DVec3::ZERO;
        place[first] = point.x;
        place[second] = point.y;
        place[normal] = height;
        place
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_turn_right_handed_and_points_come_back() {
        for plane in [Plane::Xy, Plane::Zx, Plane::Yz] {
            let [x, y, up] = [(DVec2::X, 0.0), (DVec2::Y, 0.0), (DVec2::ZERO, 1.0)]
                .map(|(point, height)| plane.place(point, height));
            assert_eq!(x.cross(y), up, "{plane:?} is right-handed");
            let point = DVec3::new(1.0, 2.0, 3.0);
            let (flat, height) = plane.split(point);
            assert_eq!(plane.place(flat, height), point, "{plane:?} there and back");
        }
    }
}
