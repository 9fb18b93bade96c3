//! Where stages meet: a program and its tools become one tool path, and a path is judged.

mod ahead;
mod avoided;
mod beside;
mod changes;
mod judge;
mod lap_by_lap;
mod passed_words;
mod planned;
mod profile;
mod program_path;
mod spline_blocks;
mod tools;
mod walls;

pub use judge::check_program;
pub use passed_words::tool_changes;
pub use planned::{PathMotion, plan_path};
pub use profile::Profile;
pub use program_path::{ProgramCompensation, compensate_program};
pub use tools::{ListedTool, ToolSize, Tools};
