//! A handle of a program that was read.

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::emit_settings::EmitSettings;
use super::numbering::Numbering;
use super::polylines::Polylines;
use super::polylines_handle::PolylinesHandle;
use super::programmed::contours_json;
use super::report::{diagnostics_json, gouges_json};
use super::tool_path::ToolPathHandle;
use crate::program::{
    Dialect, Interpretation, Item, ProgrammedContour, RadiusSource, programmed_path,
};
use crate::simulation::{ListedTool, Profile, ToolSize, Tools, check_program};

/// A program that was read and understood; `Program` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ProgramHandle {
    interpretation: Interpretation,
    profile: Profile,
    dialect: Dialect,
}

impl ProgramHandle {
    /// Holds what was read as `dialect` by the rules of `profile`.
    pub(super) fn new(interpretation: Interpretation, profile: Profile, dialect: Dialect) -> Self {
        Self { interpretation, profile, dialect }
    }

    /// What it holds.
    pub(super) fn interpretation(&self) -> &Interpretation {
        &self.interpretation
    }

    /// The profile that `compensate` follows where it is told no other.
    pub(super) fn profile(&self) -> Profile {
        self.profile
    }

    fn contours(&self) -> impl Iterator<Item = &ProgrammedContour> {
        self.interpretation.items.iter().filter_map(|item| match item {
            Item::Contour(contour) => Some(&**contour),
            Item::Free(_) | Item::Words { .. } => None,
        })
    }
}

#[wasm_bindgen]
impl ProgramHandle {
    /// The place of `dialect` among the names of `options.js`.
    #[must_use]
    pub fn dialect(&self) -> u8 {
        self.dialect as u8
    }

    /// `diagnostics` as JSON.
    #[must_use]
    pub fn diagnostics(&self) -> String {
        diagnostics_json(&self.interpretation.diagnostics, &Numbering::plain())
    }

    /// `contours` as JSON.
    #[wasm_bindgen(js_name = contours)]
    #[must_use]
    pub fn contours_as_json(&self) -> String {
        contours_json(self.contours())
    }

    /// `polylines` within `tolerance` [mm].
    ///
    /// # Errors
    /// Where the tolerance asks for too many vertices.
    pub fn polylines(&self, tolerance: f64) -> Result<PolylinesHandle, BadArgument> {
        let mut polylines = Polylines::default();
        let mut first = 0;
        for ProgrammedContour { contour, .. } in self.contours() {
            polylines.contour(Some(contour), tolerance, |i| first + owner(i))?;
            first += owner(contour.segments().len());
        }
        Ok(PolylinesHandle::new(polylines))
    }

    /// `tools`: the numbers of the tools that contours call.
    #[must_use]
    pub fn tools(&self) -> Vec<u32> {
        let mut numbers = Vec::new();
        for programmed in self.contours() {
            if let RadiusSource::Tool(number) = programmed.radius
                && !numbers.contains(&number)
            {
                numbers.push(number);
            }
        }
        numbers
    }

    /// `[text, diagnostics as JSON]` of the program as it is programmed, compensation left to the
    /// control.
    #[must_use]
    pub fn emit(&self, settings: EmitSettings) -> Vec<String> {
        settings.write(&programmed_path(&self.interpretation), &Numbering::plain())
    }

    /// The gouges of `path`, as JSON; what is less deep than `tolerance` [mm] is none. The tools are
    /// those of `compensate`.
    #[must_use]
    pub fn check(
        &self,
        path: &ToolPathHandle,
        tools: &[f64],
        radius: Option<f64>,
        tolerance: f64,
    ) -> String {
        let tools = tool_table(tools, radius);
        let gouges = check_program(&self.interpretation, path.path(), &tools, tolerance);
        gouges_json(&gouges, &Numbering::plain())
    }
}

/// The tools of four numbers each: its own, whether the next is a diameter in the unit of the program
/// or else a radius [mm], that, and the orientation; and of `radius` for all others.
pub(super) fn tool_table(numbers: &[f64], radius: Option<f64>) -> Tools {
    let mut tools = Tools { listed: Vec::new(), default_radius: radius };
    for tool in numbers.chunks_exact(4) {
        // The numbers are whole, as `tools.js` has checked.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "see above")]
        let (number, orientation) = (tool[0] as u32, tool[3] as u8);
        let size =
            if tool[1] == 0.0 { ToolSize::Radius(tool[2]) } else { ToolSize::Diameter(tool[2]) };
        tools.listed.push(ListedTool { number, size, orientation });
    }
    tools
}

/// An index of a segment as JavaScript gets it; no program has so many.
fn owner(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
