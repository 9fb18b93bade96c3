//! Programs of our own, and the moves that the interpreter of `LinuxCNC` 2.9 printed for them: with
//! compensation in `outputs.txt`, and in `language.txt` expressions, arcs, coordinate systems, cycles, O
//! words, spellings and the order within blocks.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::program::Dialect;

use super::printed::{Compared, compare};

fn assert_same(compared: &Compared) {
    let Compared { programs, faults, .. } = compared;
    assert!(faults.is_empty(), "{} of {programs} differ\n{}", faults.len(), faults.join("\n\n"));
}

#[test]
fn every_program_gives_what_linuxcnc_prints() {
    let compared = compare(include_str!("outputs.txt"), Dialect::Auto);
    assert_same(&compared);
    let Compared { programs, stops, moves, .. } = compared;
    assert!(programs >= 600 && stops >= 100 && moves >= 3_000, "{programs} {stops} {moves}");
}

#[test]
fn programs_are_read_as_linuxcnc_reads_them() {
    let compared = compare(include_str!("language.txt"), Dialect::LinuxCnc);
    assert_same(&compared);
    assert!(compared.programs >= 300, "only {}", compared.programs);
}

/// A file that `scripts/linuxcnc.mjs` has made, in the variable `G41_PRINTED`.
#[cfg(not(target_arch = "wasm32"))]
#[test]
#[ignore = "needs a file of its own"]
fn a_file_of_programs_gives_what_linuxcnc_printed() {
    let name = std::env::var("G41_PRINTED").expect("G41_PRINTED names a file");
    let text = std::fs::read_to_string(&name).expect("it can be read");
    let compared = compare(&text, Dialect::Auto);
    assert_same(&compared);
    println!("{} programs, {} refused", compared.programs, compared.stops);
}
