//! A diagnostic reads as one line: where, what, and its code.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::diagnostic::{Diagnostic, Origin};

#[test]
fn a_place_in_a_program_is_named_as_its_writer_sees_it() {
    let origin = Origin::Block { line: 4, number: Some(40), column: Some(7) };
    let diagnostic = Diagnostic::error("no-end", "the arc has no end").with_origin(origin);
    assert_eq!(
        diagnostic.to_string(),
        "line 4 (N40), column 7: the arc has no end [no-end]",
        "all that is known of the place"
    );
    let origin = Origin::Block { line: 4, number: None, column: None };
    assert_eq!(origin.to_string(), "line 4", "nothing that is not known");
    assert_eq!(Origin::Segment(2).to_string(), "segment 2", "a contour from code has no lines");
}

#[test]
fn a_finding_without_a_place_begins_with_its_message() {
    let diagnostic = Diagnostic::info("empty", "the program is empty");
    assert_eq!(diagnostic.to_string(), "the program is empty [empty]", "no place, no colon");
}
