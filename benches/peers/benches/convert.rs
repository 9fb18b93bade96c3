//! Nanoseconds and bytes per block of the way from a program's text to the text of its compensated
//! path, beside the crate `gcode` that only parses the same text; natively and as WebAssembly.
#![cfg_attr(target_arch = "wasm32", no_main)]

use std::fmt::Write;
use std::hint::black_box;

use g41::compensation::Options;
use g41::program::{Dialect, EmitOptions, Program, Rules, emit, interpret};
use g41::simulation::{Tools, compensate_program};
use peak_alloc::PeakAlloc;
use peers::race::{now, print};

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    table();
}

#[cfg(target_arch = "wasm32")]
#[wasm_bindgen_test::wasm_bindgen_test]
fn print_table() {
    table();
}

fn table() {
    print("| program, blocks | read | compensate | write | all | bytes | `gcode` parses | bytes |");
    print("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for count in [10_000, 100_000, 1_000_000] {
        row("parts", &parts(count));
    }
    for count in [10_000, 100_000, 1_000_000] {
        row("one contour", &one_contour(count));
    }
}

fn row(name: &str, text: &str) {
    let blocks = text.lines().count() as f64;
    let before = ALLOCATOR.current_usage();
    ALLOCATOR.reset_peak_usage();
    let start = busy();
    let mut last = start;
    let mut step = || {
        let now = busy();
        (now - std::mem::replace(&mut last, now)) / blocks
    };
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let reading = step();
    let path = compensate_program(&read, &Tools::all(1.0), &Options::default());
    let compensating = step();
    let written = black_box(emit(&path, &EmitOptions::default()));
    let writing = step();
    let all = (busy() - start) / blocks;
    let peak = (ALLOCATOR.peak_usage() - before) as f64 / blocks;
    assert!(written.text.lines().count() as f64 > 0.9 * blocks, "it is all there");
    drop((read, path, written));
    ALLOCATOR.reset_peak_usage();
    let start = busy();
    let parsed = black_box(gcode::parse(text).expect("it is G-code"));
    let theirs = (busy() - start) / blocks;
    let their_peak = (ALLOCATOR.peak_usage() - before) as f64 / blocks;
    drop(parsed);
    print(&format!(
        "| {name} {blocks} | {reading:.0} | {compensating:.0} | {writing:.0} | {all:.0} | {peak:.0} | {theirs:.0} | {their_peak:.0} |"
    ));
}

/// Processor time of this thread where the system tells it, else the time by the clock [ns].
fn busy() -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanos = told.and_then(|text| text.split(' ').next()?.parse().ok());
    nanos.unwrap_or_else(now)
}

/// Parts on a grid: each a rounded outline with G41, an engraved spline, and 60 blocks of a surface.
fn parts(blocks: usize) -> String {
    let mut text = String::from("G21 G90 G17\nM3 S12000\nG0 Z5\n");
    let (mut count, mut part) = (3, 0);
    while count < blocks {
        let (x, y) = (f64::from(part % 100) * 60.0, f64::from(part / 100) * 60.0);
        part += 1;
        let at = |dx: f64, dy: f64| format!("X{:.4} Y{:.4}", x + dx, y + dy);
        let outline = format!(
            "G0 {}\nG1 Z-2 F200\nG41 D1 G1 {} F600\nG1 {}\nG2 {} R5\nG1 {}\nG2 {} I5 J0\nG1 {}\n\
             G2 {} R5\nG1 {}\nG2 {} R5\nG40 G1 {}\nG0 Z5\n",
            at(-10.0, -10.0),
            at(0.0, 5.0),
            at(0.0, 35.0),
            at(5.0, 40.0),
            at(30.0, 40.0),
            at(35.0, 45.0),
            at(45.0, 45.0),
            at(50.0, 40.0),
            at(50.0, 5.0),
            at(45.0, 0.0),
            at(40.0, -12.0),
        );
        text.push_str(&outline);
        count += outline.lines().count();
        let _ = write!(text, "G0 {}\nG1 Z-0.5 F200\nG05 {} F900\n", at(10.0, 10.0), at(14.0, 16.0));
        for i in 2..=5 {
            let i = f64::from(i);
            let _ = writeln!(text, "{}", at(10.0 + 4.0 * i, 10.0 + 6.0 * (i % 2.0)));
        }
        text.push_str("G0 Z5\n");
        count += 8;
        for i in 0..60 {
            let i = f64::from(i);
            let place = at(5.0 + 0.6 * i, 20.0 + (0.3 * i).sin());
            let _ = writeln!(text, "G1 {place} Z{:.4}", 2.0 * (0.1 * i).cos());
        }
        text.push_str("G0 Z5\n");
        count += 61;
    }
    text.push_str("M5\nM30\n");
    text
}

/// One compensated contour of short lines round a wave.
fn one_contour(blocks: usize) -> String {
    let mut text =
        String::from("G21 G90 G17\nG0 X-10 Y-10 Z5\nG1 Z-1 F200\nG41 D1 G1 X0 Y0 F600\n");
    for i in 1..blocks {
        let x = 0.5 * i as f64;
        let _ = writeln!(text, "X{x:.4} Y{:.4}", 10.0 * (0.05 * x).sin());
    }
    text.push_str("G40 G1 Y-20\nM30\n");
    text
}
