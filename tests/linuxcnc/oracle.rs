//! Random programs against the rules of `LinuxCNC`, stated for themselves.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;
