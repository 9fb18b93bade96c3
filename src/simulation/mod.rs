//! Where stages meet: a program and its tools become one tool path.

mod program_path;
mod tools;

pub use program_path::compensate_program;
pub use tools::Tools;
