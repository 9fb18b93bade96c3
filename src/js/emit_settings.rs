//! The options of writing a program, as JavaScript names them.

use wasm_bindgen::prelude::wasm_bindgen;

use super::move_records::per_second;
use super::names::{TargetName, WrittenName};
use super::numbering::Numbering;
use super::report::diagnostics_json;
use crate::contour::ToolPath;
use crate::program::{EmitOptions, Emitted, emit};

/// How a program is written.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy)]
pub struct EmitSettings {
    options: EmitOptions,
}

#[wasm_bindgen]
impl EmitSettings {
    /// Takes `tolerance` [mm], `feed` [mm/min] where none is programmed, and `clearance` [mm] between
    /// pieces.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(
        target: Option<TargetName>,
        tolerance: f64,
        splines: Option<WrittenName>,
        feed: Option<f64>,
        clearance: Option<f64>,
        explain: bool,
    ) -> Self {
        let options = EmitOptions {
            target: target.and_then(TargetName::meaning).unwrap_or_default(),
            tolerance,
            splines: splines.and_then(WrittenName::meaning).unwrap_or_default(),
            feed: feed.map(per_second),
            clearance,
            explain,
        };
        Self { options }
    }
}

impl EmitSettings {
    /// `[text, diagnostics as JSON]` of a path as a program.
    pub(super) fn write(&self, path: &ToolPath, numbering: &Numbering) -> Vec<String> {
        let Emitted { text, diagnostics } = emit(path, &self.options);
        vec![text, diagnostics_json(&diagnostics, numbering)]
    }
}
