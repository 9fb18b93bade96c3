//! The options of a compensation, as JavaScript names them.

use wasm_bindgen::prelude::wasm_bindgen;

use super::names::{CornerName, LeadName, SplineName, corner_style, lead_style, spline_method};
use crate::compensation::{Options, TangentBand};

/// The options of a compensation; those that are not given are the core's.
#[wasm_bindgen]
#[derive(Debug, Clone)]
pub struct Settings {
    options: Options,
}

#[wasm_bindgen]
impl Settings {
    /// Takes `tolerance` [mm] and `tangent_band` [rad]; the band is automatic without a number.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(
        tolerance: Option<f64>,
        spline: Option<SplineName>,
        corner: Option<CornerName>,
        lead: Option<LeadName>,
        tangent_band: Option<f64>,
    ) -> Self {
        let mut options = Options::default();
        if let Some(tolerance) = tolerance {
            options.tolerance = tolerance;
        }
        if let Some(spline) = spline.and_then(spline_method) {
            options.spline = spline;
        }
        if let Some(corner) = corner.and_then(corner_style) {
            options.corner = corner;
        }
        if let Some(lead) = lead.and_then(lead_style) {
            options.lead = lead;
        }
        if let Some(band) = tangent_band {
            options.tangent_band = TangentBand::Angle(band);
        }
        Self { options }
    }
}

impl Settings {
    /// What the core takes.
    pub(super) fn into_options(self) -> Options {
        self.options
    }
}
