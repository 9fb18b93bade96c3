//! What programs mean, and what is reported of the rest.

#[path = "../common/mod.rs"]
mod common;

mod bounds;
mod corner_cuts;
mod cycles;
mod expressions;
mod feeds;
mod flow;
mod frames;
mod involutes;
mod macros;
mod meant;
mod order;
mod passed;
mod patterns;
mod planes;
mod posts;
mod refused;
mod reported;
mod sample;
mod sinumerik;
mod splines;
