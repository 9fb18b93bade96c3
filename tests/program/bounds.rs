//! Programs without end come to one, at a block that is named; and running in slices.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::fmt::Write;

use g41::diagnostic::Origin;
use g41::program::Rules;
use g41::program::{Dialect, Interpretation, Program, RunOptions, Runner, interpret};

use super::sample::moves;

fn run(text: &str, options: RunOptions) -> Interpretation {
    let mut runner = Runner::new(&Program::parse(text, Dialect::Auto), options);
    while runner.step(u64::MAX) {}
    runner.finish()
}

fn short() -> RunOptions {
    RunOptions {
        most_blocks: 10_000,
        most_text: 1_000_000,
        most_items: 1_000,
        ..RunOptions::default()
    }
}

#[test]
fn loops_without_end_end() {
    for (text, code, lines) in [
        ("G0 X1\no1 while [1]\n#1=2\no1 endwhile\n", "run-too-long", 2..=4),
        ("G0 X1\no1 while [1]\no1 endwhile\n", "run-too-long", 2..=3),
        ("G0 X1\no1 repeat [999999999]\n#1=2\no1 endrepeat\n", "run-too-long", 2..=4),
        ("G0 X1\no1 do\no1 while [1]\n", "run-too-long", 2..=3),
        ("G0 X1\nN5 GOTO 5\n", "run-too-long", 2..=2),
        ("G0 X1\nDO1\nEND1\n", "run-too-long", 2..=3),
        ("G91 G0 X1\no1 while [1]\nX1\no1 endwhile\n", "run-too-long", 2..=4),
        ("G91 G0 X1\no1 while [1]\n(A COMMENT)\no1 endwhile\n", "run-too-long", 2..=4),
        ("G91 G0 X1\no1 while [1]\nG5 X1 Y[#1]\n#1=[1-#1]\no1 endwhile\n", "run-too-long", 2..=5),
        ("o1 sub\nG0 X1\no1 call\no1 endsub\no1 call\n", "nested-too-deep", 3..=3),
        ("G0 X1\nM98 P5\nM30\nO5\nM98 P5\nM99\n", "nested-too-deep", 5..=5),
        ("o1 sub\no1 call\no1 call\no1 endsub\no1 call\n", "nested-too-deep", 2..=2),
    ] {
        let read = run(text, short());
        let found = read.diagnostics.iter().find(|d| d.code == code);
        let Some(Origin::Block { line, .. }) = found.and_then(|d| d.origin) else {
            panic!("{text}: {:?}", read.diagnostics);
        };
        assert!(lines.contains(&line), "{text}: line {line}");
        assert!(read.items.len() <= 1_100, "{text}: {} items", read.items.len());
    }
}

#[test]
fn a_loop_that_moves_nothing_ends_sooner() {
    let options = RunOptions { most_idle: 500, ..short() };
    let message = |text: &str| {
        let read = run(text, options);
        let found = read.diagnostics.iter().find(|found| found.code == "run-too-long");
        found.map_or(String::new(), |found| found.message.clone())
    };
    let endless = message("G0 X1\nN5 #1=#1+1\nIF [#1 GT 0] GOTO 5\nX2\nM30\n");
    assert_eq!(endless, "the program runs too many blocks without a move", "it only counts");
    let arcs = message("G0 X1\no1 while [1]\nG3 R5\no1 endwhile\n");
    assert_eq!(arcs, "the program runs too many blocks without a move", "arcs without a length");
    let counts = "G91 G0 X1\n#1=0\no1 while [#1 LT 150]\n#1=[#1+1]\no1 endwhile\nX1\n";
    assert_eq!(message(counts), "", "some calculation between moves");
}

#[test]
fn a_long_line_is_not_read_without_end() {
    let text = format!("o1 while [1]\n({})\no1 endwhile\n", "long ".repeat(2_000));
    let read = run(&text, short());
    assert_eq!(read.diagnostics.last().map(|d| d.code), Some("run-too-long"), "after 1 MB");
}

#[test]
fn there_may_be_a_thousand_names() {
    let mut text = String::new();
    for i in 0..2_000 {
        writeln!(text, "#<name{i}>={i}").expect("a string takes everything");
    }
    writeln!(text, "#<{}>=1", "n".repeat(200)).expect("a string takes everything");
    let read = run(&text, short());
    assert!(read.diagnostics.iter().all(|d| d.code == "too-many-parameters"), "{read:?}");
    assert_eq!(read.diagnostics.len(), 101, "the first hundred and a count");
}

#[test]
fn what_is_found_in_a_loop_is_told_once_and_counted() {
    let text = "#1=0\no1 repeat [50]\nG0 Y[1/0]\no1 endrepeat\nM2\n";
    let read = run(text, short());
    let messages: Vec<_> = read.diagnostics.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(messages.len(), 2, "{messages:?}");
    assert!(messages[1].starts_with("49 further"), "{messages:?}");
}

#[test]
fn slices_of_any_size_give_the_same() {
    let text = "#1=0\nG0 X0 Y-9\nG41 D1\no1 while [#1 LT 9]\n#1=[#1+1]\nG1 X#1 Y[#1 MOD 2] F100\n\
                o1 endwhile\nG40 Y-9\nM98 P7 L3\nM30\n\nO7\nG91 X1\nM99\n";
    let program = Program::parse(text, Dialect::Auto);
    let whole = interpret(&program, Rules::default());
    assert!(moves(&whole).len() > 3, "{whole:?}");
    for size in [1, 2, 7, 1_000] {
        let mut runner = Runner::new(&program, RunOptions::default());
        let mut progress = 0.0;
        while runner.step(size) {
            assert!(runner.progress() >= progress && runner.progress() <= 1.0, "it grows");
            progress = runner.progress();
        }
        assert_eq!(runner.progress(), 1.0, "at the end");
        assert_eq!(runner.finish(), whole, "slices of {size}");
    }
}

#[test]
fn what_was_run_until_a_stop_is_there() {
    let program = Program::parse("G0 X1\nX2\nX3\n", Dialect::Auto);
    let mut runner = Runner::new(&program, RunOptions::default());
    assert!(runner.step(2), "there is more");
    assert_eq!(moves(&runner.finish()).len(), 2, "as far as it was run");
}

#[test]
fn block_delete_skips_its_blocks_where_it_is_on() {
    let text = "G0 X1\n/X2\n/2 X3\nN5 /X4\n/o1 call\n/M30\nX5\nM30\no1 sub\nX9\no1 endsub\n";
    let on = run(
        text,
        RunOptions {
            rules: Rules { block_delete: true, ..Rules::default() },
            ..RunOptions::default()
        },
    );
    let xs =
        |read: &Interpretation| moves(read).iter().map(|m| m.curve.end().x).collect::<Vec<_>>();
    assert_eq!(xs(&on), [1.0, 5.0], "on");
    assert!(on.diagnostics.is_empty(), "{on:?}");
    let off = run(text, RunOptions::default());
    assert_eq!(xs(&off), [1.0, 2.0, 3.0, 4.0, 9.0], "off");
    assert!(off.diagnostics.iter().any(|d| d.code == "block-delete"), "it is said");
}
