//! The boundary to JavaScript: converts, calls, converts.
//!
//! Numbers cross as typed arrays: contours come in as records ([`contour_records`]), moves go out as
//! records ([`move_records`]), curves as polylines. The few reports (diagnostics, transitions,
//! gouges, programmed contours) cross as JSON text, which is small, fast to parse and testable
//! without a JavaScript engine. Millimetres per second become millimetres per minute here. What
//! JavaScript sees is not this but `api.js`, whose types are in `types.d.ts`.
//!
//! The feature `contour-js` alone builds a boundary without programs, G-code and motion, which
//! `contour.js` loads: half of the whole.

#![cfg_attr(not(feature = "js"), allow(dead_code, reason = "what the whole uses"))]

mod argument;
mod compensate;
mod contour_records;
#[cfg(feature = "js")]
mod emit_settings;
mod json;
mod judge;
mod live;
#[cfg(feature = "js")]
mod motion;
mod move_records;
mod names;
mod numbering;
mod polylines;
mod polylines_handle;
#[cfg(feature = "js")]
mod program;
#[cfg(feature = "js")]
mod programmed;
mod report;
mod settings;
#[cfg(feature = "js")]
mod slices;
mod tool_path;

pub use argument::BadArgument;
pub use compensate::{compensate_contours, flatten_contours};
#[cfg(feature = "js")]
pub use emit_settings::EmitSettings;
pub use judge::check_contours;
pub use live::LiveHandle;
#[cfg(feature = "js")]
pub use motion::{MotionHandle, plan_motion, step_spline, tools_of};
pub use move_records::STRIDE as RECORD_STRIDE;
pub use names::{
    CornerName, DialectName, Edit, GougeName, LeadName, List, OutputName, ParameterName,
    ProfileName, SideName, SplineName, TargetName, WrittenName,
};
pub use numbering::Numbering;
pub use polylines_handle::PolylinesHandle;
#[cfg(feature = "js")]
pub use program::ProgramHandle;
#[cfg(feature = "js")]
pub use programmed::contours_json;
pub use report::{
    diagnostics_json, gouges_json, loops_json, transitions_json, uncut_json, violations_json,
};
pub use settings::Settings;
#[cfg(feature = "js")]
pub use slices::{CompensationHandle, ReaderHandle};
pub use tool_path::ToolPathHandle;

use wasm_bindgen::prelude::wasm_bindgen;

/// Takes less code than the standard library's; two-level segregated fit, in constant time.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: rlsf::SmallGlobalTlsf = rlsf::SmallGlobalTlsf::new();

/// The version of the package.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
