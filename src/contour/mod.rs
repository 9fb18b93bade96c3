//! What is programmed and what comes out: contours, corners and tools; tool paths, moves and
//! transitions.
//!
//! A contour is the boundary of the part, a tool path is where the tool centre goes. This floor
//! only describes them: it knows no G-code, and how one becomes the other is not its business.

mod builder;
mod corner;
mod plane;
mod segment;
mod shape;
mod stated;
mod tool;
mod tool_path;
mod transition;
mod walls;
mod wish;

pub use builder::{Built, ContourBuilder};
pub use corner::{Corner, CornerKind};
pub use plane::Plane;
pub use segment::{Attributes, Contour, Event, EventKind, Lead, Segment};
pub use shape::{ARC_TOLERANCE, RELATIVE_ARC_TOLERANCE, Shape, SplineShape};
pub use tool::{Side, Tool};
pub use tool_path::{
    AuxiliaryWords, Gouge, GougeKind, Move, MoveCurve, PathLoop, Reset, Role, ToolPath, Uncut,
};
pub use transition::{Transition, TransitionKind};
pub use walls::Walls;
pub use wish::{CornerWish, LeadWish, Wish};
