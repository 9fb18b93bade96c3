//! Motion along paths against closed forms, brute force and the samples alone.

#[path = "../common/mod.rs"]
mod common;

mod corners;
mod fit;
mod interpolation;
mod involutes;
mod lengths;
mod limits;
mod optima;
mod optimum;
mod shapes;
mod times;
mod tracks;
