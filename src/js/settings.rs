//! The options of a compensation, as JavaScript names them.

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::names::{
    CornerName, GougeName, LeadName, OutputName, ProfileName, SideName, SplineName,
};
use crate::compensation::{
    CornerStyle, GougePolicy, LeadStyle, Options, Output, Passes, SplineMethod, TangentBand,
};
use crate::contour::{Side, Tool};
use crate::simulation::Profile;

/// The options of a compensation as they are given; the rest is the profile's.
#[wasm_bindgen]
#[derive(Debug, Clone)]
pub struct Settings {
    side: Option<Side>,
    radius: Option<f64>,
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
    /// Takes a tool's `radius` [mm], `tolerance` [mm] and `tangent_band` [rad]; a negative band is the automatic one. With a
    /// `stepover` [mm] there are `passes`, or as many as there is room for.
    #[wasm_bindgen(constructor)]
    #[must_use]
    #[expect(
        clippy::too_many_arguments,
        reason = "an argument of the boundary is cheaper than a setter"
    )]
    pub fn new(
        side: Option<SideName>,
        radius: Option<f64>,
        profile: Option<ProfileName>,
        tolerance: Option<f64>,
        spline: Option<SplineName>,
        output: Option<OutputName>,
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
            side: side.and_then(SideName::meaning),
            radius,
            profile: profile.and_then(ProfileName::meaning),
            tolerance,
            spline: spline.and_then(SplineName::meaning),
            output: output.and_then(OutputName::meaning),
            corner: corner.and_then(CornerName::meaning),
            lead: lead.and_then(LeadName::meaning),
            tangent_band: tangent_band.map(band),
            gouge: gouge.and_then(GougeName::meaning),
            passes: match (passes, stepover) {
                (_, None) => Passes::One,
                (Some(count), Some(stepover)) => Passes::Several { count, stepover },
                (None, Some(stepover)) => Passes::All { stepover },
            },
        }
    }
}

impl Settings {
    /// The radius of tools that are not listed [mm].
    pub(super) fn radius(&self) -> Option<f64> {
        self.radius
    }

    /// The tool of a contour that says this of it.
    pub(super) fn tool(
        &self,
        own_side: Option<Side>,
        own_radius: Option<f64>,
    ) -> Result<Tool, BadArgument> {
        let side = self.side.or(own_side).ok_or_else(|| missing("options.side"))?;
        let radius = self.radius.or(own_radius).ok_or_else(|| missing("options.radius"))?;
        Tool::new(radius, side)
            .ok_or_else(|| BadArgument::new("options.radius", "be at most 1e7 mm"))
    }

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

fn missing(path: &str) -> BadArgument {
    BadArgument::new(path, "be given, since the contour does not say it")
}
