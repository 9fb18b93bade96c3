//! The options of a compensation, as JavaScript names them.

use wasm_bindgen::prelude::wasm_bindgen;

use super::names::{
    CornerName, GougeName, LeadName, OutputName, ProfileName, SplineName, corner_style,
    gouge_policy, lead_style, output, profile, spline_method,
};
use crate::compensation::{
    CornerStyle, GougePolicy, LeadStyle, Options, Output, Passes, SplineMethod, TangentBand,
};
use crate::simulation::Profile;

/// The options of a compensation as they are given; the rest is the profile's.
#[wasm_bindgen]
#[derive(Debug, Clone)]
pub struct Settings {
    profile: Option<Profile>,
    tolerance: Option<f64>,
    spline: Option<SplineMethod>,
    output: Option<Output>,
    corner: Option<CornerStyle>,
    lead: Option<LeadStyle>,
    tangent_band: Option<TangentBand>,
    gouge: Option<GougePolicy>,
    passes: Passes,
}

#[wasm_bindgen]
impl Settings {
    /// Takes `tolerance` [mm] and `tangent_band` [rad]; a negative band is the automatic one. With a
    /// `stepover` [mm] there are `passes`, or as many as there is room for.
    #[wasm_bindgen(constructor)]
    #[must_use]
    #[expect(
        clippy::too_many_arguments,
        reason = "an argument of the boundary is cheaper than a setter"
    )]
    pub fn new(
        profile_name: Option<ProfileName>,
        tolerance: Option<f64>,
        spline: Option<SplineName>,
        output_name: Option<OutputName>,
        corner: Option<CornerName>,
        lead: Option<LeadName>,
        tangent_band: Option<f64>,
        gouge: Option<GougeName>,
        passes: Option<u32>,
        stepover: Option<f64>,
    ) -> Self {
        let band = |band: f64| match band {
            0.0.. => TangentBand::Angle(band),
            _ => TangentBand::Auto,
        };
        Self {
            profile: profile_name.and_then(profile),
            tolerance,
            spline: spline.and_then(spline_method),
            output: output_name.and_then(output),
            corner: corner.and_then(corner_style),
            lead: lead.and_then(lead_style),
            tangent_band: tangent_band.map(band),
            gouge: gouge.and_then(gouge_policy),
            passes: match (passes, stepover) {
                (_, None) => Passes::One,
                (Some(count), Some(stepover)) => Passes::Several { count, stepover },
                (None, Some(stepover)) => Passes::All { stepover },
            },
        }
    }
}

impl Settings {
    /// What the core takes, where no other profile is named than `profile`.
    pub(super) fn into_options(self, profile: Profile) -> Options {
        let base = self.profile.unwrap_or(profile).options();
        Options {
            tolerance: self.tolerance.unwrap_or(base.tolerance),
            output: self.output.unwrap_or(base.output),
            corner: self.corner.unwrap_or(base.corner),
            spline: self.spline.unwrap_or(base.spline),
            lead: self.lead.unwrap_or(base.lead),
            tangent_band: self.tangent_band.unwrap_or(base.tangent_band),
            gouge: self.gouge.unwrap_or(base.gouge),
            passes: self.passes,
        }
    }
}
