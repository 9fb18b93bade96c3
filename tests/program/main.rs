//! What programs mean, and what is reported of the rest.

mod feeds;
mod meant;
mod planes;
mod reported;
mod sample;
