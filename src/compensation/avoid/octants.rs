//! Which way a curve heads, as a set of eighths of a circle.
//!
//! Sets of directions are joined with one operation and tell at once whether a stretch of a contour
//! turns by less than half a circle, which angles would cost arc tangents to tell.

use std::f64::consts::{FRAC_PI_4, TAU};

use glam::{DVec2, dvec2};

use crate::geometry::{Bounds, Cubic, perp, rotate};

/// A set of directions: bit `k` stands for the eighth from `45° k` to below `45° (k + 1)`, so that
/// opposite directions are four bits apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(in crate::compensation) struct Octants(u8);

/// √½, the coordinates of the diagonals.
const D: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Directions at the boundaries of the eighths, the first repeated as the last.
const RIMS: [DVec2; 9] = [
    dvec2(1.0, 0.0),
    dvec2(D, D),
    dvec2(0.0, 1.0),
    dvec2(-D, D),
    dvec2(-1.0, 0.0),
    dvec2(-D, -D),
    dvec2(0.0, -1.0),
    dvec2(D, -D),
    dvec2(1.0, 0.0),
];

impl Octants {
    /// Every direction.
    pub(super) const ALL: Self = Self(0xff);

    /// The eighth that a vector points into; none for a zero vector.
    pub(in crate::compensation) fn of(v: DVec2) -> Self {
        let (x, y) = (v.x, v.y);
        if x == 0.0 && y == 0.0 {
            return Self(0);
        }
        let k = if x > 0.0 && y >= 0.0 {
            u8::from(y >= x)
        } else if y > 0.0 {
            2 + u8::from(-x >= y)
        } else if x < 0.0 {
            4 + u8::from(y <= x)
        } else {
            6 + u8::from(x >= -y)
        };
        Self(1 << k)
    }

    /// The directions of a cubic and some between them.
    pub(in crate::compensation) fn of_cubic(cubic: &Cubic) -> Self {
        let [p0, p1, p2, p3] = cubic.points;
        Self::of(p1 - p0).union(Self::of(p2 - p1)).union(Self::of(p3 - p2))
    }

    /// The directions on the way round an outside corner, for a tool whose σ is `sign`.
    pub(in crate::compensation) fn of_turn(incoming: DVec2, outgoing: DVec2, sign: f64) -> Self {
        // Half way round, on the outside even where the tangents are opposite.
        let half_way = (perp(outgoing) - perp(incoming)) * sign;
        Self::of(incoming).union(Self::of(half_way)).union(Self::of(outgoing))
    }

    /// The directions of a curve that begins along `tangent` and turns one way by `turn` rad: those
    /// at its ends and at every eighth of a turn between them.
    pub(in crate::compensation) fn of_way(tangent: DVec2, turn: f64) -> Self {
        // More than a turn has all of them.
        let turn = turn.clamp(-TAU, TAU);
        let steps = (turn.abs() / FRAC_PI_4).ceil().max(1.0);
        let mut octants = Self::of(tangent);
        let mut k = 1.0;
        while k <= steps {
            octants = octants.union(Self::of(rotate(tangent, turn * (k / steps))));
            k += 1.0;
        }
        octants
    }

    pub(super) fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether all of them fit into half a circle: a curve that heads nowhere else never turns
    /// back.
    pub(in crate::compensation) fn is_narrow(self) -> bool {
        let wide = u32::from(self.0) * 0x0101;
        // Four eighths in a row free, somewhere round the circle.
        let free = !wide & 0xffff;
        (free & (free >> 1) & (free >> 2) & (free >> 3)) & 0xff != 0 || self.0 == 0
    }

    /// Whether they fit into a quarter of a circle, however that lies.
    pub(super) fn is_slender(self) -> bool {
        let wide = u32::from(self.0) * 0x0101;
        let free = !wide & 0xffff;
        let four = free & (free >> 1) & (free >> 2) & (free >> 3);
        (four & (four >> 2)) & 0xff != 0 || self.0 == 0
    }

    /// The set with all directions that a curve takes on its way from one of these to another.
    fn filled(self) -> Self {
        for first in 0..8 {
            let set = self.0.rotate_right(first);
            if set & 1 != 0 && set < 16 {
                let highest = set.ilog2();
                let all = (2_u8 << highest) - 1;
                return Self(all.rotate_left(first));
            }
        }
        // They do not fit into half a circle, so the way from one to another may be any.
        Self::ALL
    }

    /// The box of the unit vectors a quarter turn to the left of these directions, and of those
    /// between them.
    pub(super) fn left_normals(self) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        let all = self.filled();
        for (k, pair) in RIMS.windows(2).enumerate() {
            if all.0 & (1 << k) != 0 {
                bounds.add(pair[0].perp());
                bounds.add(pair[1].perp());
            }
        }
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    fn at(degrees: f64) -> DVec2 {
        DVec2::from_angle(degrees.to_radians())
    }

    #[test]
    fn each_direction_is_in_its_eighth() {
        for k in 0..8_u8 {
            for within in [1.0, 20.0, 44.0] {
                let angle = 45.0 * f64::from(k) + within;
                assert_eq!(Octants::of(at(angle)), Octants(1 << k), "{angle}°");
            }
            assert_eq!(Octants::of(RIMS[k as usize]), Octants(1 << k), "{}°", 45 * k);
        }
    }

    #[test]
    fn narrow_sets_are_those_within_half_a_circle() {
        for first in 0..8 {
            for width in 1..=8_u32 {
                let set = (0..width).fold(0_u8, |set, k| set | 1 << ((first + k) % 8));
                assert_eq!(Octants(set).is_narrow(), width <= 4, "{set:08b}");
                assert_eq!(Octants(set).is_slender(), width <= 2, "{set:08b}");
            }
        }
        assert!(!Octants(0b0001_0001).is_narrow(), "opposite directions");
    }

    #[test]
    fn the_way_between_two_directions_belongs_to_both() {
        for first in 0..8_u32 {
            for width in 1..=8_u32 {
                // The two ends of a fan, without what is between them.
                let ends = Octants(1_u8.rotate_left(first) | 1_u8.rotate_left(first + width - 1));
                let within = |k: u32| (k + 8 - first) % 8 < width;
                // A fan of more than half a circle may be the rest of it as well.
                let all = width > 4 && width < 6;
                let expected = (0..8)
                    .filter(|&k| match width {
                        1..=4 => within(k),
                        6..=8 => !within(k) || k == first || k == (first + width - 1) % 8,
                        _ => all,
                    })
                    .fold(0_u8, |set, k| set | 1 << k);
                assert_eq!(ends.filled(), Octants(expected), "{width} from {first}");
            }
        }
    }

    #[test]
    fn normals_of_a_set_are_in_their_box() {
        for degrees in 0..360 {
            let direction = at(f64::from(degrees) + 0.5);
            let bounds = Octants::of(direction).left_normals().inflated(1e-12);
            assert_eq!(bounds.distance(direction.perp()), 0.0, "{degrees}°");
        }
    }
}
