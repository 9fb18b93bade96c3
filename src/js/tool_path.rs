//! A handle of a tool path.

use std::rc::Rc;

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
#[cfg(feature = "js")]
use super::emit_settings::EmitSettings;
#[cfg(feature = "js")]
use super::move_records::add_record;
use super::move_records::move_records;
use super::names::List;
use super::numbering::Numbering;
use super::polylines::Polylines;
use super::polylines_handle::PolylinesHandle;
use super::report::{diagnostics_json, gouges_json, loops_json, transitions_json, uncut_json};
use crate::contour::ToolPath;
#[cfg(feature = "js")]
use crate::program::ways;

/// A tool path; `ToolPath` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ToolPathHandle {
    path: Rc<ToolPath>,
    numbering: Numbering,
}

impl ToolPathHandle {
    /// What it holds.
    pub(super) fn path(&self) -> &ToolPath {
        &self.path
    }

    /// The same, for a handle that may outlive this one.
    pub(super) fn shared(&self) -> Rc<ToolPath> {
        Rc::clone(&self.path)
    }

    /// Holds a path whose segments are numbered so.
    pub(super) fn new(path: ToolPath, numbering: Numbering) -> Self {
        Self { path: Rc::new(path), numbering }
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

    /// The items of a list from one index to another, as JSON; regions without their outlines.
    #[must_use]
    pub fn report(&self, list: List, from: usize, to: usize) -> String {
        let Self { path, numbering } = self;
        match list {
            List::Transitions => transitions_json(part(&path.transitions, from, to), numbering),
            List::Diagnostics => diagnostics_json(part(&path.diagnostics, from, to), numbering),
            List::Gouges => gouges_json(part(&path.gouges, from, to), numbering),
            List::Loops => loops_json(part(&path.loops, from, to)),
            List::Uncut => uncut_json(part(&path.uncut, from, to), numbering),
        }
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

    /// The moves of `ways` as `records()` of `types.d.ts`, each behind the index of the move that it
    /// leads to.
    #[cfg(feature = "js")]
    #[must_use]
    pub fn ways(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        for (to, way) in ways(&self.path) {
            numbers.push(to as f64);
            add_record(&mut numbers, &way, &self.numbering);
        }
        numbers
    }

    /// `[text, diagnostics as JSON]` of the path as a program.
    #[cfg(feature = "js")]
    #[must_use]
    pub fn emit(&self, settings: EmitSettings) -> Vec<String> {
        settings.write(&self.path, &self.numbering)
    }
}

/// The items from one index to another, as far as there are any.
fn part<T>(items: &[T], from: usize, to: usize) -> &[T] {
    items.get(from..to.min(items.len())).unwrap_or_default()
}
