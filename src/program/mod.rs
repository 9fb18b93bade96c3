//! G-code: reading programs, interpreting them to contours, writing tool paths as programs.
//!
//! Reading never fails as a whole: [`interpret`] returns what it understood and a diagnostic for
//! everything else. Inches, mm/min and line numbers exist on this floor only. It does not know how
//! contours are compensated.
//!
//! [`Program::parse`] finds the dialect and the outline of the text, subprograms and loops. A
//! [`Runner`] reads one block after the other when its turn comes, with the parameters as they are
//! by then, and hands it to an interpreter, which knows the modes of a control and makes moves and
//! contours of it. Parameters that depend on these the interpreter tells. The run ends with the
//! program or at a bound of [`RunOptions`].

mod arcs;
mod assumed;
mod auxiliary;
mod axes;
mod bezier;
mod block;
mod block_writer;
mod coordinates;
mod corner_cuts;
mod corner_words;
mod course;
mod crossing;
mod cursor;
mod cycles;
mod dialect;
mod drilling;
mod emit;
mod explained;
mod expression;
mod feed;
mod flow;
mod frame;
mod free_moves;
mod functions;
mod g_words;
mod interpret;
mod involutes;
mod items;
mod klartext;
mod lexer;
mod macros;
mod modal;
mod modes;
mod moves;
mod number;
mod open;
mod other_moves;
mod outline;
mod parameters;
mod passed;
mod patterns;
mod pending_spline;
mod points;
mod programmed;
mod reader;
mod report;
mod rules;
mod run;
mod sinumerik;
mod spline_blocks;
mod spline_words;
mod structures;
mod switch;
mod system;
mod target;
mod transforms;
mod type_points;
mod variables;
mod words;

pub use block::{Block, Word};
pub use crossing::ways;
pub use dialect::Dialect;
pub use emit::{EmitOptions, Emitted, SplineOutput, emit};
pub use items::{
    ContourEnd, ContourStart, Item, OrientationSource, ProgrammedContour, RadiusSource,
};
pub use programmed::programmed_path;
pub use reader::Program;
pub use rules::{ControlWords, Rules};
pub use run::{Interpretation, RunOptions, Runner, interpret};
pub use target::Target;
