//! Speed along a track.
//!
//! A run is what lies between two rests. Its first law accelerates evenly below the speeds that the
//! bends allow ([`reference`]); its time is then stretched and shrunk until some limit of velocity,
//! acceleration, jerk or snap holds at every place ([`retime`]), and once more by the time that came
//! out, with knots that are closer where the path turns quickly. What then exceeds a limit between
//! knots ([`verify`]) is sought again there with stricter limits, and at the last slowed down a little.
//!
//! Of a long run the beginning is planned with rest at the end of a window, whose last part, the head
//! of what follows, is planned again from the state that the tool is in when more is known. Where that
//! fails the tool does come to rest there.

mod banded;
mod course;
mod equations;
mod knots;
mod law;
mod limit;
mod ramp;
mod reference;
mod retime;
mod run;
mod spline;
mod stage;
mod textbook;
mod verify;

pub(super) use course::Course;
pub(super) use law::{Phase, length};
pub(super) use ramp::{Rates, cruise, ramp_time};
pub(super) use run::{law, law_from};
pub(super) use textbook::law as textbook;
