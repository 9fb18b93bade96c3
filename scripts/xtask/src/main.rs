//! Runs the wasm-bindgen tools that `Cargo.lock` pins: `xtask bindgen …` and `xtask test-runner …`.

use std::env;

use anyhow::bail;

fn main() -> anyhow::Result<()> {
    let mut arguments = env::args_os();
    let program = arguments.next();
    let tool = arguments.next().unwrap_or_default();
    let rest = program.into_iter().chain(arguments);
    match tool.to_str() {
        Some("bindgen") => wasm_bindgen_cli::wasm_bindgen::run_cli_with_args(rest),
        Some("test-runner") => wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(rest),
        _ => bail!("unknown tool {}: expected `bindgen` or `test-runner`", tool.display()),
    }
}
