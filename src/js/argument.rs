//! An argument that cannot be used, and the error that it becomes in JavaScript.

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

/// Thrown as the text `path␤must`, of which `lifecycle.js` makes an `Error`: making one here would
/// take bindings for all of JavaScript.
impl From<BadArgument> for JsValue {
    fn from(BadArgument { path, must }: BadArgument) -> Self {
        Self::from_str(&format!("{path}\n{must}"))
    }
}
