//! Speed along a track.

mod law;
mod ramp;

pub(super) use law::Phase;
pub(super) use ramp::{Rates, rest_to_rest};
