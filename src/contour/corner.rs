//! A corner: where two segments meet, and which transition the tool takes there.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec2;

use super::{Side, TransitionKind};
use crate::geometry::turn;

/// How far below 90° an angle still counts as 90° [rad]: right angles of rounded coordinates are
/// meant as such, and both formulas agree there.
const RIGHT_ANGLE_BAND: f64 = 1e-9;

/// Where two segments meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// The point where they meet [mm].
    pub point: DVec2,
    /// Unit tangent of the incoming segment at its end: T1.
    pub incoming: DVec2,
    /// Unit tangent of the outgoing segment at its start: T2.
    pub outgoing: DVec2,
    /// Curvature of the incoming segment at its end [1/mm].
    pub incoming_curvature: f64,
    /// Curvature of the outgoing segment at its start [1/mm].
    pub outgoing_curvature: f64,
}

/// What a corner is to a tool on one side of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CornerKind {
    /// The turn is within the tangent band: no transition.
    Tangent,
    /// The offsets are joined by a transition.
    Transition {
        /// Which of the three.
        kind: TransitionKind,
        /// Angle on the workpiece side, α [rad].
        angle: f64,
    },
}

impl Corner {
    /// The turn φ from the incoming to the outgoing tangent, in `(-π, π]` rad.
    #[must_use]
    pub fn turn(&self) -> f64 {
        turn(self.incoming, self.outgoing)
    }

    /// The angle α between the segments on the workpiece side, in `[0, 2π]` rad.
    ///
    /// α = π + σφ ("Tool radius compensation algorithm of spline curve", 2.3). At a reversal, a
    /// turn within `band` rad of ±π, the tangents do not tell the two limits apart: the workpiece
    /// is a spike (0) unless the segments bend towards the tool side, `σ(κ1 + κ2) < 0`, where it
    /// is a slit (2π).
    #[must_use]
    pub fn angle(&self, side: Side, band: f64) -> f64 {
        let turn = self.turn();
        if PI - turn.abs() > band {
            return PI + side.sign() * turn;
        }
        let bend = side.sign() * (self.incoming_curvature + self.outgoing_curvature);
        if bend < 0.0 { TAU } else { 0.0 }
    }

    /// What the corner is to a tool on `side`, where turns of up to `band` rad are tangent.
    #[must_use]
    pub fn kind(&self, side: Side, band: f64) -> CornerKind {
        if self.turn().abs() <= band {
            return CornerKind::Tangent;
        }
        let angle = self.angle(side, band);
        let kind = if angle >= PI {
            TransitionKind::Shortened
        } else if angle >= FRAC_PI_2 - RIGHT_ANGLE_BAND {
            TransitionKind::Elongated
        } else {
            TransitionKind::Inserted
        };
        CornerKind::Transition { kind, angle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(incoming_degrees: f64, outgoing_degrees: f64) -> Corner {
        let unit = |degrees: f64| DVec2::from_angle(degrees.to_radians());
        Corner {
            point: DVec2::ZERO,
            incoming: unit(incoming_degrees),
            outgoing: unit(outgoing_degrees),
            incoming_curvature: 0.0,
            outgoing_curvature: 0.0,
        }
    }

    fn kind(corner: &Corner, side: Side) -> TransitionKind {
        match corner.kind(side, 1e-9) {
            CornerKind::Transition { kind, .. } => kind,
            CornerKind::Tangent => panic!("corner {corner:?} has no transition"),
        }
    }

    #[test]
    fn the_turn_alone_decides_the_kind() {
        // Turns to the left are inside corners for a tool on the left (article, 2.3).
        for (turn, left, right) in [
            (30.0, TransitionKind::Shortened, TransitionKind::Elongated),
            (90.0, TransitionKind::Shortened, TransitionKind::Elongated),
            (91.0, TransitionKind::Shortened, TransitionKind::Inserted),
            (-30.0, TransitionKind::Elongated, TransitionKind::Shortened),
            (-90.0, TransitionKind::Elongated, TransitionKind::Shortened),
            (-179.0, TransitionKind::Inserted, TransitionKind::Shortened),
        ] {
            for first in [0.0, 37.0, 180.0, 271.0] {
                let corner = corner(first, first + turn);
                assert_eq!(kind(&corner, Side::Left), left, "turn {turn}° from {first}°, left");
                assert_eq!(kind(&corner, Side::Right), right, "turn {turn}° from {first}°, right");
            }
        }
    }

    #[test]
    fn a_reversal_is_a_spike_or_a_slit_by_its_bend() {
        let mut reversal = corner(0.0, 180.0);
        assert_eq!(kind(&reversal, Side::Left), TransitionKind::Inserted, "line and line");
        assert_eq!(kind(&reversal, Side::Right), TransitionKind::Inserted, "line and line");
        // Both arcs turn right: the slit between them is on the left.
        reversal.incoming_curvature = -0.1;
        reversal.outgoing_curvature = -0.1;
        assert_eq!(kind(&reversal, Side::Left), TransitionKind::Shortened, "slit");
        assert_eq!(kind(&reversal, Side::Right), TransitionKind::Inserted, "spike");
    }

    #[test]
    fn a_turn_within_the_band_is_tangent() {
        assert_eq!(corner(0.0, 1.0).kind(Side::Left, 0.02), CornerKind::Tangent, "1° in 0.02 rad");
    }
}
