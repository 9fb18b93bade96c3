//! Judging paths against the contours that they are of.

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::contour_records::read_contours;
use super::report::gouges_json;
use super::tool_path::ToolPathHandle;
use crate::gouge::check_all;

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
    let mut named = radius.or(contours.first().and_then(|contour| contour.radius));
    let mut built = Vec::with_capacity(contours.len());
    for contour in contours {
        if radius.is_none() && contour.radius != named {
            named = None;
        }
        // What is wrong with a contour is said where it is compensated.
        built.extend(contour.build().contour);
    }
    let radius = named.ok_or_else(|| {
        BadArgument::new("options.radius", "be given, since the contours do not say one radius")
    })?;
    let contours: Vec<_> = built.iter().collect();
    Ok(gouges_json(&check_all(&contours, path.path(), radius, tolerance), &numbering))
}
