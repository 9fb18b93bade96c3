//! What programs mean, and what is reported of the rest.

mod bounds;
mod cycles;
mod expressions;
mod feeds;
mod flow;
mod frames;
mod macros;
mod meant;
mod order;
mod passed;
mod planes;
mod reported;
mod sample;
mod splines;
