//! An argument that cannot be used, and the error that it becomes in JavaScript.

use js_sys::{Error, Reflect};
use wasm_bindgen::JsValue;

/// An argument that cannot be used: where it is, and what is wrong with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BadArgument {
    /// Its place among the arguments, as in `[17]` or `options.side`.
    pub path: String,
    /// What it should be, after "must".
    pub must: String,
}

impl BadArgument {
    /// An argument at `path` that must be otherwise.
    pub fn new(path: impl Into<String>, must: impl Into<String>) -> Self {
        Self { path: path.into(), must: must.into() }
    }
}

impl From<BadArgument> for JsValue {
    fn from(argument: BadArgument) -> Self {
        let BadArgument { path, must } = argument;
        let error = Error::new(&format!("{path} must {must}"));
        for (name, value) in [("code", "bad-argument"), ("path", &path)] {
            // Setting a property of a fresh error cannot fail.
            let _ = Reflect::set(&error, &name.into(), &value.into());
        }
        error.into()
    }
}
