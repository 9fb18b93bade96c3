//! Reading a program of a million blocks: nanoseconds and bytes per block, beside crates that parse
//! the same text and do no more.
//!
//! g41's figures include what the blocks mean: modes, positions, a move for each.

use std::hint::black_box;
use std::time::Instant;

use g41::program::{Dialect, Program, Rules, interpret};
use peak_alloc::PeakAlloc;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

const BLOCKS: usize = 1_000_000;

const RUNS: usize = 5;

fn main() {
    let text = written();
    let megabytes = text.len() as f64 / 1e6;
    println!("{BLOCKS} blocks, {megabytes:.1} MB, best of {RUNS}");
    println!("| what | ns per block | bytes per block at most |");
    println!("| --- | --- | --- |");
    measure("g41: outline of the text", &text, |text| Program::parse(text, Dialect::Auto));
    measure("g41: read and interpreted", &text, |text| {
        let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
        assert!(read.items.len() >= BLOCKS, "{} items", read.items.len());
        read
    });
    measure("g41: as many blocks from a loop", LOOP, |text| {
        let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
        assert!(read.items.len() >= BLOCKS / 3, "{} items", read.items.len());
        read
    });
    measure("gcode 0.7: parsed", &text, |text| {
        gcode::parse(text).expect("it is a program").blocks.len()
    });
    measure("g-code 0.6: parsed", &text, |text| {
        g_code::parse::file_parser(text).expect("it is a program").iter().count()
    });
}

/// A million blocks run: two assignments or tests for each move.
const LOOP: &str = "G90 G21 F600\nG0 X0 Y0\n#1=0\no1 while [#1 LT 250000]\n#1=[#1+1]\n\
                    G1 X[10*sin[#1]] Y[#1/1000]\nX[#1*0.001]\no1 endwhile\nM2\n";

/// As post-processors write finishing passes.
fn written() -> String {
    let mut text = String::from("%\n(A LONG PROGRAM)\nG90 G21 G17\nS12000 M3\nF600\n");
    for i in 0..BLOCKS {
        let t = i as f64 * 1e-3;
        let [x, y, z] = [60.0 * t.sin(), 40.0 * (1.7 * t).cos(), -2.0 + (0.3 * t).sin()];
        text.push_str(&format!("N{} G1 X{x:.4} Y{y:.4}", i % 100_000));
        text.push_str(&if i % 4 == 0 { format!(" Z{z:.3}\n") } else { String::from("\n") });
    }
    // One of the crates wants the sign last.
    text.push_str("M30\n%");
    text
}

fn measure<T>(what: &str, text: &str, mut read: impl FnMut(&str) -> T) {
    let before = ALLOCATOR.current_usage();
    ALLOCATOR.reset_peak_usage();
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        black_box(read(black_box(text)));
        best = best.min(start.elapsed().as_nanos() as f64);
    }
    let bytes = (ALLOCATOR.peak_usage() - before) as f64;
    println!("| {what} | {:.0} | {:.0} |", best / BLOCKS as f64, bytes / BLOCKS as f64);
}
