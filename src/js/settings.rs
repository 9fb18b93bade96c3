//! The options of a compensation, as JavaScript names them.

use wasm_bindgen::prelude::wasm_bindgen;

use super::names::{
    CornerName, GougeName, LeadName, SplineName, corner_style, gouge_policy, lead_style,
    spline_method,
};
use crate::compensation::{Options, Passes, TangentBand};

/// The options of a compensation; those that are not given are the core's.
#[wasm_bindgen]
#[derive(Debug, Clone)]
pub struct Settings {
    options: Options,
}

#[wasm_bindgen]
impl Settings {
    /// Takes `tolerance` [mm] and `tangent_band` [rad]; the band is automatic without a number.
    /// With a `stepover` [mm] there are `passes`, or as many as there is room for.
    #[wasm_bindgen(constructor)]
    #[must_use]
    #[expect(
        clippy::too_many_arguments,
        reason = "an argument of the boundary is cheaper than a setter"
    )]
    pub fn new(
        tolerance: Option<f64>,
        spline: Option<SplineName>,
        corner: Option<CornerName>,
        lead: Option<LeadName>,
        tangent_band: Option<f64>,
        gouge: Option<GougeName>,
        passes: Option<u32>,
        stepover: Option<f64>,
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
        if let Some(gouge) = gouge.and_then(gouge_policy) {
            options.gouge = gouge;
        }
        options.passes = match (passes, stepover) {
            (_, None) => Passes::One,
            (Some(count), Some(stepover)) => Passes::Several { count, stepover },
            (None, Some(stepover)) => Passes::All { stepover },
        };
        Self { options }
    }
}

impl Settings {
    /// What the core takes.
    pub(super) fn into_options(self) -> Options {
        self.options
    }
}
