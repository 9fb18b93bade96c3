//! Handles of tool paths and of flattened contours.

use js_sys::Array;
use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::move_records::{move_records, per_second};
use super::numbering::Numbering;
use super::polylines::Polylines;
use super::report::{diagnostics_json, gouges_json, transitions_json};
use crate::contour::ToolPath;
use crate::diagnostic::Diagnostic;
use crate::program::{EmitOptions, Emitted, Target, emit};

/// A tool path; `ToolPath` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ToolPathHandle {
    path: ToolPath,
    numbering: Numbering,
}

impl ToolPathHandle {
    /// Holds a path whose segments are numbered so.
    pub(super) fn new(path: ToolPath, numbering: Numbering) -> Self {
        Self { path, numbering }
    }
}

#[wasm_bindgen]
impl ToolPathHandle {
    /// `records()` of `types.d.ts`.
    #[must_use]
    pub fn records(&self) -> Vec<f64> {
        move_records(&self.path.moves, &self.numbering)
    }

    /// `transitions` as JSON.
    #[must_use]
    pub fn transitions(&self) -> String {
        transitions_json(&self.path.transitions, &self.numbering)
    }

    /// `diagnostics` as JSON.
    #[must_use]
    pub fn diagnostics(&self) -> String {
        diagnostics_json(&self.path.diagnostics, &self.numbering)
    }

    /// `gouges` as JSON.
    #[must_use]
    pub fn gouges(&self) -> String {
        gouges_json(&self.path.gouges, &self.numbering)
    }

    /// `[points3, starts, owners]` of `polylines` within `tolerance` [mm].
    ///
    /// # Errors
    /// Where the tolerance asks for too many vertices.
    #[wasm_bindgen(unchecked_return_type = "[Float64Array, Uint32Array, Uint32Array]")]
    pub fn polylines(&self, tolerance: f64) -> Result<Array, BadArgument> {
        Ok(Polylines::of_moves(&self.path.moves, tolerance)?.into_arrays())
    }

    /// `[text, diagnostics as JSON]` of the path as a program, within `tolerance` [mm], with
    /// `feed` [mm/min] where none is programmed.
    #[must_use]
    pub fn emit(&self, tolerance: f64, feed: Option<f64>) -> Vec<String> {
        let feed = feed.map(per_second);
        let options = EmitOptions { target: Target::Grbl, tolerance, feed };
        let Emitted { text, diagnostics } = emit(&self.path, &options);
        vec![text, diagnostics_json(&diagnostics, &self.numbering)]
    }
}

/// Contours as polylines, and what is wrong with them.
#[wasm_bindgen]
#[derive(Debug)]
pub struct FlattenedHandle {
    polylines: Polylines,
    diagnostics: Vec<Diagnostic>,
    numbering: Numbering,
}

impl FlattenedHandle {
    /// Holds polylines and diagnostics of contours whose segments are numbered so.
    pub(super) fn new(
        polylines: Polylines,
        diagnostics: Vec<Diagnostic>,
        numbering: Numbering,
    ) -> Self {
        Self { polylines, diagnostics, numbering }
    }
}

#[wasm_bindgen]
impl FlattenedHandle {
    /// `diagnostics` as JSON.
    #[must_use]
    pub fn diagnostics(&self) -> String {
        diagnostics_json(&self.diagnostics, &self.numbering)
    }

    /// `[points3, starts, owners]`, which ends the handle.
    #[wasm_bindgen(js_name = intoPolylines)]
    #[wasm_bindgen(unchecked_return_type = "[Float64Array, Uint32Array, Uint32Array]")]
    #[must_use]
    pub fn into_polylines(self) -> Array {
        self.polylines.into_arrays()
    }
}
