//! Motion along any path: pieces by arc length, corners rounded, speed planned, samples in time.
//!
//! This floor plans any path and never asks where it came from. Lengths are in mm, times in s.

mod blend;
mod by_length;
mod corner;
mod eased;
mod fit;
mod helix;
mod interpolation;
mod joint;
mod limits;
mod piece;
mod pieces;
mod plan;
mod quintic;
mod sample;
mod speed;
mod straight;
mod track;
mod unwound;
mod violations;

pub use by_length::ByLength;
pub use corner::{Corner, CornerCurve, CornerShape};
pub use eased::Eased;
pub use fit::{Fitted, Fitter};
pub use helix::Helix;
pub use interpolation::{StepRule, interpolate, lengths_at};
pub use joint::Joint;
pub use limits::{AxisLimits, CurvatureSteps, Limits, LimitsError, Mode};
pub use piece::{Frame, Piece};
pub use pieces::pieces;
pub use plan::{Planner, plan};
pub use quintic::Quintic;
pub use sample::{MOST_SAMPLES, Motion};
pub use straight::Straight;
pub use track::{Placed, Stretch, TrackBuilder, track};
pub use unwound::Unwound;
pub use violations::{Peak, Violations};
