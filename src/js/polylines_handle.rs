//! A handle from which JavaScript takes polylines, array by array.

use wasm_bindgen::prelude::wasm_bindgen;

use super::numbering::Numbering;
use super::polylines::Polylines;
use super::report::diagnostics_json;
use crate::diagnostic::Diagnostic;

/// Polylines to be taken, and what is wrong with the contours that they are of.
#[wasm_bindgen]
#[derive(Debug)]
pub struct PolylinesHandle {
    polylines: Polylines,
    diagnostics: Vec<Diagnostic>,
    numbering: Numbering,
}

impl PolylinesHandle {
    /// Polylines of what is known to be right, or was reported before.
    pub(super) fn new(polylines: Polylines) -> Self {
        Self::with_diagnostics(polylines, Vec::new(), Numbering::plain())
    }

    /// Polylines of contours whose segments are numbered so.
    pub(super) fn with_diagnostics(
        polylines: Polylines,
        diagnostics: Vec<Diagnostic>,
        numbering: Numbering,
    ) -> Self {
        Self { polylines, diagnostics, numbering }
    }
}

#[wasm_bindgen]
impl PolylinesHandle {
    /// `diagnostics` as JSON.
    #[must_use]
    pub fn diagnostics(&self) -> String {
        diagnostics_json(&self.diagnostics, &self.numbering)
    }

    /// `points3`, which is empty after it.
    #[wasm_bindgen(js_name = takePoints)]
    #[must_use]
    pub fn take_points(&mut self) -> Vec<f64> {
        std::mem::take(&mut self.polylines.points)
    }

    /// `starts`, which is empty after it.
    #[wasm_bindgen(js_name = takeStarts)]
    #[must_use]
    pub fn take_starts(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.polylines.starts)
    }

    /// `owners`, which is empty after it.
    #[wasm_bindgen(js_name = takeOwners)]
    #[must_use]
    pub fn take_owners(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.polylines.owners)
    }
}
