//! Reading programs, and picking out what they mean.

use g41::contour::Move;
use g41::diagnostic::{Diagnostic, Origin, Severity};
use g41::program::{Dialect, Interpretation, Item, Program, ProgrammedContour, Rules, interpret};
use glam::DVec2;

pub(crate) fn read(text: &str) -> Interpretation {
    interpret(&Program::parse(text, Dialect::Auto), Rules::default())
}

pub(crate) fn read_as_fanuc(text: &str) -> Interpretation {
    interpret(&Program::parse(text, Dialect::Fanuc), Rules::default())
}

/// Reads a program in which nothing is to be found fault with.
pub(crate) fn read_clean(text: &str) -> Interpretation {
    let read = read(text);
    assert!(read.diagnostics.is_empty(), "{text}\n{:?}", read.diagnostics);
    read
}

pub(crate) fn moves(read: &Interpretation) -> Vec<Move> {
    let free = |item: &Item| if let Item::Free(found) = item { Some(*found) } else { None };
    read.items.iter().filter_map(free).collect()
}

/// Where the moves of a program end in the plane, in which nothing is to be found fault with.
pub(crate) fn ends(text: &str, dialect: Dialect) -> Vec<[f64; 2]> {
    let read = interpret(&Program::parse(text, dialect), Rules::default());
    assert!(read.diagnostics.is_empty(), "{text}\n{:?}", read.diagnostics);
    moves(&read).iter().map(|m| m.curve.end().to_array()).collect()
}

/// X at the ends of the moves, rounded to nanometres.
pub(crate) fn xs(text: &str, dialect: Dialect) -> Vec<f64> {
    ends(text, dialect).iter().map(|end| (end[0] * 1e6).round() / 1e6).collect()
}

/// The codes of what is found.
pub(crate) fn codes(text: &str, dialect: Dialect) -> Vec<&'static str> {
    let read = interpret(&Program::parse(text, dialect), Rules::default());
    read.diagnostics.iter().map(|diagnostic| diagnostic.code).collect()
}

pub(crate) fn contours(read: &Interpretation) -> Vec<&ProgrammedContour> {
    fn contour(item: &Item) -> Option<&ProgrammedContour> {
        if let Item::Contour(found) = item { Some(&**found) } else { None }
    }
    read.items.iter().filter_map(contour).collect()
}

/// The words passed on, without the resets that have none.
pub(crate) fn words(read: &Interpretation) -> Vec<&str> {
    fn words(item: &Item) -> Option<&str> {
        if let Item::Words { words, .. } = item { Some(words) } else { None }
    }
    read.items.iter().filter_map(words).filter(|words| !words.is_empty()).collect()
}

/// Where the moves end in space, with an `R` for rapid ones, and the words between them.
pub(crate) fn steps(read: &Interpretation) -> Vec<String> {
    let number = |value: f64| g41::geometry::Decimal::new(value, 6).to_string();
    let mut steps = Vec::new();
    for item in &read.items {
        match item {
            Item::Free(found) => {
                let end = found.plane.place(found.curve.end(), found.heights[1]);
                let [x, y, z] = end.to_array().map(number);
                steps.push(format!("{}{x} {y} {z}", if found.rapid { "R " } else { "" }));
            }
            Item::Words { words, .. } if words.is_empty() => {}
            Item::Words { words, .. } => steps.push(words.clone()),
            Item::Contour(_) => steps.push("contour".into()),
        }
    }
    steps
}

pub(crate) fn only_contour(read: &Interpretation) -> &ProgrammedContour {
    let contours = contours(read);
    assert_eq!(contours.len(), 1, "{:?}", read.items);
    contours[0]
}

/// Code, severity, line and column of each diagnostic.
pub(crate) fn found(read: &Interpretation) -> Vec<(&str, Severity, u32, Option<u32>)> {
    let place = |diagnostic: &Diagnostic| match diagnostic.origin {
        Some(Origin::Block { line, column, .. }) => (line, column),
        _ => (0, None),
    };
    let entry = |d| (place(d), d);
    let entries = read.diagnostics.iter().map(entry);
    entries.map(|((line, column), d)| (d.code, d.severity, line, column)).collect()
}

pub(crate) fn near(a: DVec2, b: [f64; 2]) -> bool {
    a.distance(DVec2::from(b)) < 1e-9
}

pub(crate) const ERROR: Severity = Severity::Error;
pub(crate) const WARNING: Severity = Severity::Warning;
pub(crate) const INFO: Severity = Severity::Info;
