//! What programs mean, and what is reported of the rest.

mod meant;
mod reported;
mod sample;
