//! What programs mean, and what is reported of the rest.

mod bounds;
mod expressions;
mod feeds;
mod flow;
mod macros;
mod meant;
mod planes;
mod reported;
mod sample;
