//! How two pieces of a track meet, and how fast what is not smooth may be passed.

use super::{Frame, Limits};

/// How two pieces of a track meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Joint {
    /// Direction, curvature and its derivative go on.
    Smooth,
    /// Only the direction goes on.
    Step {
        /// Size of the step of `dT/ds` [1/mm]: acceleration steps by it times `v²`.
        curvature: f64,
        /// Size of the step of `d²T/ds²` [1/mm²]: jerk steps by it times `v³`.
        sharpness: f64,
    },
    /// The tool comes to rest.
    Stop,
}

/// Differences that count as none: at 500 mm/s and 1 kHz they are steps of the acceleration and the
/// jerk of 1e-3 of what a fast machine may do.
const SAME_DIRECTION: f64 = 1e-9;
const SAME_CURVATURE: f64 = 1e-8;
const SAME_SHARPNESS: f64 = 1e-6;

/// Periods that a blend lasts for at least; what a tool is past before is a step however it is rounded.
const LEAST_PERIODS: f64 = 4.0;

/// The part of a step of acceleration that a slight turn may add.
const SLIGHT: f64 = 0.1;

impl Joint {
    /// How two frames at the same place meet; a change of direction is a stop.
    pub(super) fn between(end: &Frame, start: &Frame) -> Self {
        if (start.tangent - end.tangent).length() > SAME_DIRECTION {
            return Self::Stop;
        }
        Self::step(end, start)
    }

    fn step(end: &Frame, start: &Frame) -> Self {
        let curvature = (start.curvature - end.curvature).length();
        let sharpness = (start.sharpness - end.sharpness).length();
        if curvature <= SAME_CURVATURE && sharpness <= SAME_SHARPNESS {
            Self::Smooth
        } else {
            Self::Step { curvature, sharpness }
        }
    }

    /// The same, but a step in place of a stop where the path turns by so little that at a feed [mm/s]
    /// the velocity changes by no more in a period than a small part of a step of acceleration is.
    pub(super) fn or_slight_turn(
        self,
        end: &Frame,
        start: &Frame,
        feed: f64,
        limits: &Limits,
    ) -> Self {
        let turn = (start.tangent - end.tangent).length();
        let most = SLIGHT * limits.step() * limits.period;
        if self == Self::Stop && turn * feed.min(limits.velocity) <= most {
            Self::step(end, start)
        } else {
            self
        }
    }

    /// Whether the curvature is another after it.
    pub(super) fn is_step_of_curvature(&self) -> bool {
        matches!(self, Self::Step { curvature, .. } if *curvature > SAME_CURVATURE)
    }

    /// Whether a blend of a length [mm] in its place lasts for some periods at the speed that it allows
    /// itself.
    pub(super) fn is_eased_by(&self, length: f64, limits: &Limits) -> bool {
        !self.is_step_of_curvature() || length > LEAST_PERIODS * limits.period * self.speed(limits)
    }

    /// The largest speed over it, where the tool does not rest [mm/s].
    pub(super) fn speed(&self, limits: &Limits) -> f64 {
        match self {
            Self::Step { curvature, .. } if *curvature > 0.0 => (limits.step() / curvature).sqrt(),
            _ => f64::INFINITY,
        }
    }
}
