//! From a contour to the path of the tool centre.
//!
//! Each segment becomes a run, its whole offset (`offset`). Each corner between two runs is
//! classified and solved on the *whole* offsets (`corner`, `transition`): it tells where both
//! runs end and which moves stand between them. Last, the runs are cut or run on to their two
//! ends and strung together with what was inserted (`assemble`). No step looks further than the
//! two segments of a corner. `avoid` does: from the same runs and corners it makes the path that never
//! comes too near to any point of the contour. `policy` chooses between the two.

mod as_arcs;
mod assemble;
mod avoid;
mod beyond;
mod corner;
mod lead;
mod links;
mod live;
mod lookahead;
mod meet;
mod offset;
mod options;
mod passes;
mod path;
mod policy;
mod report;
mod run;
mod transition;
mod type_points;
mod whole;

pub use assemble::compensate;
pub use avoid::{avoid, avoid_all};
pub use live::{EditError, LiveContour, Update};
pub use lookahead::{Passage, look_ahead};
pub use offset::{ProvedPiece, proved_offset};
pub use options::{
    CornerStyle, GougePolicy, LeadStyle, MIN_TOLERANCE, Options, Output, Passes, SplineMethod,
    TangentBand,
};
pub use policy::{
    clear_beside, compensate_all, compensate_beside, compensate_locally, refuse_gouges,
};
