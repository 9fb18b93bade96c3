//! Programs as `LinuxCNC` compensates them, against coordinates from outside this crate.

#[path = "../common/mod.rs"]
mod common;

mod documented;
mod oracle;
mod outputs;
mod printed;
mod refused;
mod run;
