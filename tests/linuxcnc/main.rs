//! Programs as `LinuxCNC` compensates them, against coordinates from outside this crate.

#[path = "../common/mod.rs"]
mod common;

mod documented;
mod language;
mod oracle;
mod outputs;
mod refused;
mod run;
