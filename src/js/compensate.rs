//! Compensation and flattening of contours given as records.

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::contour_records::read_contours;
use super::polylines::Polylines;
use super::polylines_handle::PolylinesHandle;
use super::settings::Settings;
use super::tool_path::ToolPathHandle;
use crate::compensation::compensate_all;
use crate::contour::{Contour, ToolPath};
use crate::diagnostic::Origin;
use crate::simulation::Profile;

/// Compensates the contours of `records`; the tool of `settings` stands for what they say.
///
/// # Errors
/// Where a record is wrong, or a contour is left without a side or a radius.
#[wasm_bindgen(js_name = compensateContours)]
pub fn compensate_contours(
    records: &[f64],
    settings: Settings,
) -> Result<ToolPathHandle, BadArgument> {
    let (contours, numbering) = read_contours(records)?;
    let mut found = Vec::new();
    let mut jobs = Vec::new();
    for contour in contours {
        let tool = settings.tool(contour.side, contour.radius)?;
        let mut built = contour.build();
        found.append(&mut built.diagnostics);
        jobs.extend(built.contour.map(|contour| (contour, tool)));
    }
    let options = settings.into_options(Profile::default());
    let jobs: Vec<_> = jobs.iter().map(|(contour, tool)| (contour, *tool)).collect();
    let mut path = ToolPath { diagnostics: found, ..ToolPath::default() };
    path.append(compensate_all(&jobs, &options));
    Ok(ToolPathHandle::new(path, numbering))
}

/// The polylines of the contours of `records`, within `tolerance` [mm].
///
/// # Errors
/// Where a record is wrong, or the tolerance asks for too many vertices.
#[wasm_bindgen(js_name = flattenContours)]
pub fn flatten_contours(records: &[f64], tolerance: f64) -> Result<PolylinesHandle, BadArgument> {
    let (contours, numbering) = read_contours(records)?;
    let mut polylines = Polylines::default();
    let mut diagnostics = Vec::new();
    for contour in contours {
        let mut built = contour.build();
        diagnostics.append(&mut built.diagnostics);
        let contour = built.contour.as_ref();
        polylines.contour(contour, tolerance, |i| described_index(contour, i))?;
    }
    Ok(PolylinesHandle::with_diagnostics(polylines, diagnostics, numbering))
}

/// The number that a made segment has among the described ones, of which some may be left out.
fn described_index(contour: Option<&Contour>, made: usize) -> u32 {
    match contour.map(|contour| contour.segments()[made].attributes.origin) {
        Some(Origin::Segment(number)) => number,
        Some(Origin::Block { .. }) | None => 0,
    }
}
