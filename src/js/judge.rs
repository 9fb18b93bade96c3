//! Judging paths against the contours that they are of.

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::contour_records::read_contours;
use super::report::gouges_json;
use super::tool_path::ToolPathHandle;
use crate::gouge::check;

/// The gouges of `path`, made by a tool of `radius` [mm], in the contours of `records`, as JSON; what
/// is less deep than `tolerance` [mm] is none. Without a radius it is the one that the contours name.
///
/// # Errors
/// Where a record is wrong, or it is not said which radius is meant.
#[wasm_bindgen(js_name = checkContours)]
pub fn check_contours(
    records: &[f64],
    path: &ToolPathHandle,
    radius: Option<f64>,
    tolerance: f64,
) -> Result<String, BadArgument> {
    let (contours, numbering) = read_contours(records)?;
    let mut gouges = Vec::new();
    let first = contours.first().and_then(|contour| contour.radius);
    for contour in contours {
        let named = contour.radius.filter(|named| Some(*named) == first);
        let radius = radius.or(named).ok_or_else(|| {
            BadArgument::new("options.radius", "be given, since the contours do not say one radius")
        })?;
        // What is wrong with a contour is said where it is compensated.
        if let Some(contour) = &contour.build().contour {
            gouges.append(&mut check(contour, path.path(), radius, tolerance));
        }
    }
    Ok(gouges_json(&gouges, &numbering))
}
