//! What becomes of gouges: reported, avoided, or reason to make no path at all.

use g41::compensation::{GougePolicy, Options, avoid, compensate, compensate_all};
use g41::contour::{Contour, Side, Tool, ToolPath};
use g41::diagnostic::Severity;
use g41::gouge::check;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::sketch::{Sketch, arc, line};
use crate::common::{near, p};

/// A straight wall with a round groove of radius 4 mm in it, too tight for a tool of 5 mm above.
fn groove() -> Contour {
    let along = [line(p(16.0, 0.0)), arc(p(24.0, 0.0), p(20.0, 0.0), false), line(p(40.0, 0.0))];
    Sketch::open(p(0.0, 0.0), along).contour()
}

fn wall() -> Contour {
    Sketch::open(p(0.0, 30.0), [line(p(40.0, 30.0))]).contour()
}

fn tool(radius: f64) -> Tool {
    Tool::new(radius, Side::Left).expect("a radius")
}

fn with(gouge: GougePolicy, contours: &[&Contour]) -> ToolPath {
    let jobs: Vec<_> = contours.iter().map(|contour| (*contour, tool(5.0))).collect();
    compensate_all(&jobs, &Options { gouge, ..Options::default() })
}

#[test]
fn reporting_keeps_the_path_that_gouges() {
    let (groove, wall) = (groove(), wall());
    let path = with(GougePolicy::Report, &[&groove, &wall]);
    let options = Options::default();
    let mut apart = compensate(&groove, tool(5.0), &options);
    apart.append(compensate(&wall, tool(5.0), &options));
    assert_eq!(path.moves, apart.moves, "each contour's own path, in order");
    assert!(!path.gouges.is_empty(), "the groove is reported");
}

#[test]
fn avoiding_never_cuts_too_deep_and_tells_what_it_leaves() {
    let groove = groove();
    let path = with(GougePolicy::Avoid, &[&groove]);
    assert_eq!(path, avoid(&groove, tool(5.0), &Options::default()), "one contour");
    assert_eq!(check(&groove, &path, 5.0, 1e-3), [], "the judge");
    assert_eq!(path.uncut.len(), 1, "the groove");
}

#[test]
fn stopping_leaves_no_path_but_says_where_and_how_deep() {
    let (groove, wall) = (groove(), wall());
    let path = with(GougePolicy::Stop, &[&wall, &groove]);
    assert!(path.moves.is_empty() && path.transitions.is_empty(), "{:?}", path.moves);
    let deepest = path.gouges.iter().map(|gouge| gouge.depth).fold(0.0, f64::max);
    let last = path.diagnostics.last().expect("it says why");
    assert_eq!((last.code, last.severity), ("stopped", Severity::Error), "what it says");
    near(last.depth.expect("how deep"), deepest, 0.0, "depth");
    assert!(last.at.is_some() && last.origin.is_some() && !last.segments.is_empty(), "{last:?}");
}

#[test]
fn stopping_has_nothing_to_stop_where_nothing_is_gouged() {
    let wall = wall();
    let path = with(GougePolicy::Stop, &[&wall]);
    assert_eq!(path, with(GougePolicy::Report, &[&wall]), "the path as reported");
    assert_eq!(path.moves.len(), 1, "one move along the wall");
}
