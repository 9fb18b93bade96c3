//! The floors of the crate: a file imports only from floors below its own, opens with a sentence,
//! and is short enough to be read.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// The modules at the root of the crate, and of those the ones that each may import from.
///
/// Siblings on a floor do not know each other, and `gouge` so shares nothing with `compensation`:
/// the judge is not the accused.
const FLOORS: [(&str, &[&str]); 9] = [
    ("diagnostic", &[]),
    ("geometry", &[]),
    ("contour", &["diagnostic", "geometry"]),
    ("program", &["diagnostic", "geometry", "contour"]),
    ("compensation", &["diagnostic", "geometry", "contour"]),
    ("gouge", &["diagnostic", "geometry", "contour"]),
    ("motion", &["diagnostic", "geometry", "contour"]),
    ("simulation", &BELOW_SIMULATION),
    ("js", &BELOW_JS),
];
const BELOW_SIMULATION: [&str; 7] =
    ["diagnostic", "geometry", "contour", "program", "compensation", "gouge", "motion"];
const BELOW_JS: [&str; 8] = [
    "diagnostic",
    "geometry",
    "contour",
    "program",
    "compensation",
    "gouge",
    "motion",
    "simulation",
];

/// Crates that only the boundary to JavaScript may name.
const BOUNDARY_CRATES: [&str; 5] =
    ["js_sys", "serde", "serde_wasm_bindgen", "wasm_bindgen", "web_sys"];

/// What a reader takes in at a sitting; tests at the end of a file come on top.
const MAX_LINES: usize = 500;

#[test]
fn every_file_keeps_to_its_floor() {
    let faults: Vec<String> = sources().iter().flat_map(|(path, text)| check(path, text)).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn the_plain_library_depends_on_glam_alone() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).expect("the manifest is there");
    let (_, rest) = manifest.split_once("\n[dependencies]\n").expect("there are dependencies");
    for line in rest.lines().take_while(|line| !line.starts_with('[')) {
        let required = line.contains('=') && !line.starts_with('#') && !line.contains("optional");
        assert!(!required || line.starts_with("glam "), "not optional: {line}");
    }
}

#[test]
fn an_import_from_above_is_found_in_every_form() {
    for text in [
        "use crate::compensation::Offset;",
        "use crate::{geometry::Line, compensation};",
        "use crate::{geometry::*, compensation as c};",
        "use super::super::compensation::Offset;",
        "use super::{super::compensation::Offset, Line};",
        "fn f() { crate::compensation::offset() }",
        "fn f() { assert!(matches!(x, crate::compensation::X)) }",
        "mod tests { use super::super::super::compensation; }",
        "mod tests { fn f() { super::super::super::compensation::f() } }",
        "pub(in crate::compensation) fn f() {}",
    ] {
        let faults = check("geometry/line.rs", &format!("//! A line.\n{text}\n"));
        assert_eq!(faults.len(), 1, "{text}: {faults:?}");
        assert!(faults[0].contains("compensation"), "{text}: {faults:?}");
    }
}

#[test]
fn siblings_do_not_know_each_other() {
    for sibling in ["program", "compensation", "gouge", "motion"] {
        let text = format!("//! A file.\nuse crate::{sibling}::Thing;\n");
        for (module, _) in FLOORS {
            let allowed = ["simulation", "js", sibling].contains(&module);
            let faults = check(&format!("{module}/file.rs"), &text);
            assert_eq!(faults.is_empty(), allowed, "{module} uses {sibling}: {faults:?}");
        }
    }
}

#[test]
fn imports_from_below_and_from_beside_pass() {
    for text in [
        "use crate::geometry::Line;",
        "use crate::diagnostic::{Diagnostic, Origin};",
        "use super::tool::Tool;",
        "use super::super::geometry::Line;",
        "use crate::contour::Segment;",
        "// use crate::compensation;\nconst S: &str = \"crate::compensation\";",
        "mod tests { use super::*; use super::super::Contour; }",
        "pub(crate) fn f() { self::compensation::f() }",
    ] {
        let faults = check("contour/corner.rs", &format!("//! A corner.\n{text}\n"));
        assert_eq!(faults, Vec::<String>::new(), "{text}");
    }
    let glob = check("diagnostic.rs", "//! A file.\nuse super::*;\n");
    assert_eq!(glob.len(), 1, "a glob of the root brings in every floor: {glob:?}");
    let list = "//! The crate.\npub mod compensation;\npub use crate::js::version;\n";
    assert_eq!(check("lib.rs", list), Vec::<String>::new(), "the root may name every module");
}

#[test]
fn only_the_boundary_names_its_crates() {
    for text in ["use serde::Serialize;", "#[derive(serde::Serialize)] struct S;"] {
        let text = format!("//! A file.\n{text}\n");
        assert_eq!(check("contour/tool.rs", &text).len(), 1, "{text}");
        assert_eq!(check("js/dto.rs", &text), Vec::<String>::new(), "{text}");
    }
}

#[test]
fn a_file_without_a_place_or_a_sentence_or_an_end_is_found() {
    assert_eq!(check("helpers.rs", "//! Helpers.\n").len(), 1, "not a floor");
    assert_eq!(check("contour/tool.rs", "use crate::geometry::Line;\n").len(), 1, "no sentence");
    assert_eq!(check("contour/tool.rs", "//! the tool\n").len(), 1, "no full stop");
    let long = format!("//! Long.\n{}", "\n".repeat(MAX_LINES));
    assert_eq!(check("contour/tool.rs", &long).len(), 1, "too long");
    let tested = format!("//! Short.\n#[cfg(test)]\nmod tests {{}}\n{}", "\n".repeat(MAX_LINES));
    assert_eq!(check("contour/tool.rs", &tested), Vec::<String>::new(), "the tests do not count");
}

#[test]
fn what_the_shipped_wasm_cannot_print_is_found() {
    let text = "//! A file.\nfn f(x: f64) -> String { format!(\"{x:?}\") }\n";
    assert_eq!(check("contour/tool.rs", text).len(), 1, "{text}");
    let text = "//! A file.\nfn f(x: f64) { debug_assert!(x > 0.0, \"{x:?}\") }\n";
    assert_eq!(check("contour/tool.rs", text), Vec::<String>::new(), "no release has it");
}

/// What is wrong with a file, given by its path below `src` and its text.
fn check(path: &str, text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    if !opens_with_a_sentence(text) {
        faults.push(format!("{path}: does not open with a sentence after `//!`"));
    }
    let lines = text.lines().take_while(|line| !line.starts_with("#[cfg(test)]")).count();
    if lines > MAX_LINES {
        faults.push(format!("{path}: {lines} lines before its tests, at most {MAX_LINES}"));
    }
    let before_tests = text.lines().take(lines);
    for line in before_tests.filter(|line| !line.trim_start().starts_with("//")) {
        if [":?}", ":x}", ":X}"].iter().any(|form| line.contains(form)) && !line.contains("assert")
        {
            faults
                .push(format!("{path}: scripts/trim.mjs takes out what prints `{}`", line.trim()));
        }
    }
    let module = module_path(path);
    let Some(floor) = module.first() else {
        return faults;
    };
    let Some((_, below)) = FLOORS.iter().find(|(name, _)| name == floor) else {
        faults.push(format!("{path}: `{floor}` is on no floor"));
        return faults;
    };
    let tokens: TokenStream = text.parse().unwrap_or_else(|error| panic!("{path}: {error}"));
    for name in root_names(tokens.clone(), &module) {
        if name != *floor && !below.contains(&name.as_str()) {
            faults.push(format!("{path}: `{floor}` must not know `{name}`"));
        }
    }
    for name in BOUNDARY_CRATES {
        if floor != "js" && mentions(tokens.clone(), name) {
            faults.push(format!("{path}: `{floor}` must not know the crate `{name}`"));
        }
    }
    faults
}

/// Whether the `//!` comment at the head begins with a sentence, on as many lines as it takes.
fn opens_with_a_sentence(text: &str) -> bool {
    let head: Vec<&str> = text.lines().map_while(|line| line.strip_prefix("//! ")).collect();
    head.join(" ").contains('.')
}

/// The modules from the root of the crate down to a file.
fn module_path(path: &str) -> Vec<String> {
    let path = path.trim_end_matches(".rs").trim_end_matches("/mod");
    path.split('/').filter(|part| *part != "lib").map(str::to_owned).collect()
}

/// What the tokens of a module name in the root of the crate, by `crate::…` or `super::…`.
fn root_names(tokens: TokenStream, module: &[String]) -> Vec<String> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut found = Vec::new();
    let mut rest = tokens.as_slice();
    while let [head, tail @ ..] = rest {
        rest = tail;
        match head {
            TokenTree::Ident(word) if word == "crate" => rest = follow(tail, &[], &mut found),
            TokenTree::Ident(word) if word == "super" => {
                rest = follow(tail, parent(module), &mut found);
            }
            TokenTree::Ident(word) if word == "mod" => {
                if let [TokenTree::Ident(name), TokenTree::Group(body), tail @ ..] = rest {
                    let inner = [module, &[name.to_string()]].concat();
                    found.extend(root_names(body.stream(), &inner));
                    rest = tail;
                }
            }
            TokenTree::Group(group) => found.extend(root_names(group.stream(), module)),
            _ => {}
        }
    }
    found
}

/// Follows a path on from the module that it has reached, to the end of what decides which module
/// of the root it names; returns the tokens after that. A glob of the root is named `*`.
fn follow<'a>(
    mut rest: &'a [TokenTree],
    mut reached: &[String],
    found: &mut Vec<String>,
) -> &'a [TokenTree] {
    while let [TokenTree::Punct(first), TokenTree::Punct(second), next, tail @ ..] = rest
        && first.as_char() == ':'
        && second.as_char() == ':'
    {
        rest = tail;
        match next {
            TokenTree::Ident(word) if word == "super" => reached = parent(reached),
            TokenTree::Group(list) if list.delimiter() == Delimiter::Brace => {
                for item in items(list.stream()) {
                    follow(&item, reached, found);
                }
                return rest;
            }
            name => {
                found.push(reached.first().cloned().unwrap_or_else(|| name.to_string()));
                return rest;
            }
        }
    }
    rest
}

/// The items of the braces of a `use`, each with the `::` that stands before the braces.
fn items(list: TokenStream) -> Vec<Vec<TokenTree>> {
    let colons: TokenStream = "::".parse().expect("two colons are tokens");
    let colons: Vec<TokenTree> = colons.into_iter().collect();
    let tokens: Vec<TokenTree> = list.into_iter().collect();
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(p) if p.as_char() == ',');
    tokens.split(is_comma).map(|item| [&colons, item].concat()).collect()
}

fn parent(module: &[String]) -> &[String] {
    module.split_last().map_or(module, |(_, parent)| parent)
}

/// Whether an identifier stands anywhere among the tokens.
fn mentions(tokens: TokenStream, name: &str) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Ident(word) => word == name,
        TokenTree::Group(group) => mentions(group.stream(), name),
        _ => false,
    })
}

/// Every source file of the crate: its path below `src`, with `/` on every system, and its text.
fn sources() -> Vec<(String, String)> {
    let source = root().join("src");
    let mut folders = vec![source.clone()];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("the folder can be read") {
            let path = entry.expect("the entry can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("the file is text");
                let relative = path.strip_prefix(&source).expect("the file lies below src");
                files.push((relative.to_string_lossy().replace('\\', "/"), text));
            }
        }
    }
    assert!(files.len() > 10, "the crate has more files than {}", files.len());
    files.sort();
    files
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}
