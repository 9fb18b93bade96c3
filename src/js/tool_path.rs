//! A handle of a tool path.

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::move_records::{move_records, per_second};
use super::numbering::Numbering;
use super::polylines::Polylines;
use super::polylines_handle::PolylinesHandle;
use super::report::{diagnostics_json, gouges_json, loops_json, transitions_json, uncut_json};
use crate::contour::ToolPath;
use crate::program::{EmitOptions, Emitted, SplineOutput, Target, emit};

/// A tool path; `ToolPath` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ToolPathHandle {
    path: ToolPath,
    numbering: Numbering,
}

impl ToolPathHandle {
    /// What it holds.
    pub(super) fn path(&self) -> &ToolPath {
        &self.path
    }

    /// Holds a path whose segments are numbered so.
    pub(super) fn new(path: ToolPath, numbering: Numbering) -> Self {
        Self { path, numbering }
    }
}

#[wasm_bindgen]
impl ToolPathHandle {
    /// The number of moves.
    #[must_use]
    pub fn count(&self) -> usize {
        self.path.moves.len()
    }

    /// `records()` of `types.d.ts`, of the moves from one index to another.
    #[must_use]
    pub fn records(&self, from: usize, to: usize) -> Vec<f64> {
        move_records(part(&self.path.moves, from, to), &self.numbering)
    }

    /// `transitions` from one index to another, as JSON.
    #[must_use]
    pub fn transitions(&self, from: usize, to: usize) -> String {
        transitions_json(part(&self.path.transitions, from, to), &self.numbering)
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

    /// `loops` as JSON.
    #[must_use]
    pub fn loops(&self) -> String {
        loops_json(&self.path.loops)
    }

    /// `uncut` as JSON, its outlines apart.
    #[must_use]
    pub fn uncut(&self) -> String {
        uncut_json(&self.path.uncut, &self.numbering)
    }

    /// The outlines of `uncut`, one after the other: `x0, y0, x1, y1, …`.
    #[must_use]
    pub fn outlines(&self) -> Vec<f64> {
        let mut outlines = Vec::new();
        for region in &self.path.uncut {
            for vertex in &region.outline {
                outlines.extend_from_slice(&vertex.to_array());
            }
        }
        outlines
    }

    /// `polylines` within `tolerance` [mm].
    ///
    /// # Errors
    /// Where the tolerance asks for too many vertices.
    pub fn polylines(&self, tolerance: f64) -> Result<PolylinesHandle, BadArgument> {
        Ok(PolylinesHandle::new(Polylines::of_moves(&self.path.moves, tolerance)?))
    }

    /// `[text, diagnostics as JSON]` of the path as a program for `target`, within `tolerance`
    /// [mm], with `feed` [mm/min] where none is programmed, and `clearance` [mm] between pieces.
    #[must_use]
    pub fn emit(
        &self,
        target: &str,
        tolerance: f64,
        native: bool,
        feed: Option<f64>,
        clearance: Option<f64>,
        explain: bool,
    ) -> Vec<String> {
        let options = emit_options(target, tolerance, native, feed, clearance, explain);
        written(&self.path, &options, &self.numbering)
    }
}

/// The options of writing a program, as JavaScript gives them.
pub(super) fn emit_options(
    target: &str,
    tolerance: f64,
    native: bool,
    feed: Option<f64>,
    clearance: Option<f64>,
    explain: bool,
) -> EmitOptions {
    EmitOptions {
        target: Target::named(target).unwrap_or_default(),
        tolerance,
        splines: if native { SplineOutput::Native } else { SplineOutput::Arcs },
        feed: feed.map(per_second),
        clearance,
        explain,
    }
}

/// `[text, diagnostics as JSON]` of a path as a program.
pub(super) fn written(
    path: &ToolPath,
    options: &EmitOptions,
    numbering: &Numbering,
) -> Vec<String> {
    let Emitted { text, diagnostics } = emit(path, options);
    vec![text, diagnostics_json(&diagnostics, numbering)]
}

/// The items from one index to another, as far as there are any.
fn part<T>(items: &[T], from: usize, to: usize) -> &[T] {
    items.get(from..to.min(items.len())).unwrap_or_default()
}
