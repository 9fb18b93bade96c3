//! Long work in slices: reading a program, and compensating it.

use wasm_bindgen::prelude::wasm_bindgen;

use super::names::{DialectName, ParameterName, ProfileName};
use super::numbering::Numbering;
use super::program::{ProgramHandle, tool_table};
use super::settings::Settings;
use super::tool_path::ToolPathHandle;
use crate::program::{Dialect, Program, Rules, RunOptions, Runner};
use crate::simulation::{Profile, ProgramCompensation};

/// A program that is being read; `ProgramReader` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ReaderHandle {
    runner: Runner,
    profile: Profile,
    dialect: Dialect,
}

#[wasm_bindgen]
impl ReaderHandle {
    /// A program before its first block.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(
        text: String,
        dialect: Option<DialectName>,
        profile: Option<ProfileName>,
        block_delete: bool,
        parameter: Option<ParameterName>,
        curve_tolerance: f64,
    ) -> Self {
        let dialect = dialect.and_then(DialectName::meaning).unwrap_or_default();
        let profile = profile.and_then(ProfileName::meaning).unwrap_or_default();
        let parameter = parameter.and_then(ParameterName::meaning).unwrap_or_default();
        let rules = Rules { block_delete, parameter, curve_tolerance, ..profile.rules() };
        let dialect = rules.dialect(dialect, &text);
        let program = Program::from_text(text, dialect);
        let runner = Runner::new(&program, RunOptions { rules, ..RunOptions::default() });
        Self { runner, profile, dialect }
    }

    /// Reads so many lines; false once there are none left.
    pub fn step(&mut self, lines: u32) -> bool {
        self.runner.step(lines.into())
    }

    /// How much was read, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.runner.progress()
    }

    /// The program, as far as it was read.
    #[must_use]
    pub fn finish(self) -> ProgramHandle {
        ProgramHandle::new(self.runner.finish(), self.profile, self.dialect)
    }
}

/// A program that is being compensated; `ProgramCompensation` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct CompensationHandle {
    compensation: ProgramCompensation,
}

#[wasm_bindgen]
impl CompensationHandle {
    /// A program before its first block, with `tools`, as `tools.js` packs them, and that of
    /// `settings` for all others.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(program: &ProgramHandle, tools: &[f64], settings: Settings) -> Self {
        let tools = tool_table(tools, settings.radius());
        let options = settings.into_options(program.profile());
        let compensation = ProgramCompensation::new(program.interpretation(), tools, &options);
        Self { compensation }
    }

    /// Compensates about so many blocks of the same program; false once there are none left.
    pub fn step(&mut self, program: &ProgramHandle, blocks: usize) -> bool {
        self.compensation.step(program.interpretation(), blocks)
    }

    /// How much was compensated, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.compensation.progress()
    }

    /// The path, as far as it was made.
    #[must_use]
    pub fn finish(self) -> ToolPathHandle {
        ToolPathHandle::new(self.compensation.finish(), Numbering::plain())
    }
}
