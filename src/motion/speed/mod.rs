//! Speed along a track.
//!
//! A run is what lies between two rests. Its first law accelerates evenly below the speeds that the
//! bends allow ([`reference`]); its time is then stretched and shrunk until some limit of velocity,
//! acceleration, jerk or snap holds at every place ([`retime`]), and once more by the time that came
//! out, which puts knots where the time goes. What then exceeds a limit between knots ([`verify`]) is
//! made stricter there and, at the last, taken out of the whole run by a factor on time.

mod banded;
mod course;
mod law;
mod ramp;
mod reference;
mod retime;
mod run;
mod spline;
mod textbook;
mod verify;

pub(super) use course::Course;
pub(super) use law::Phase;
pub(super) use ramp::{Rates, cruise, ramp_time};
pub(super) use run::law;
pub(super) use textbook::law as textbook;
