//! Bytes per type point of the way from raw type points to the path: what is held at the worst
//! moment, and what the path itself takes.

use std::hint::black_box;

use peak_alloc::PeakAlloc;
use peers::curves::{spiral, wave};

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

fn main() {
    println!("bytes per type point, type points themselves apart");
    println!("| curve, r | contour | path | peak |");
    println!("| --- | --- | --- | --- |");
    for make in [wave, spiral] {
        for n in [100, 1_000, 10_000, 100_000] {
            let sample = make(n);
            for radius in sample.radii {
                let before = ALLOCATOR.current_usage();
                let per = |bytes: usize| (bytes - before) as f64 / n as f64;
                let contour = sample.contour();
                let held = per(ALLOCATOR.current_usage());
                drop(contour);
                ALLOCATOR.reset_peak_usage();
                let path = black_box(sample.avoided(radius, 1e-3));
                let (peak, now) = (per(ALLOCATOR.peak_usage()), per(ALLOCATOR.current_usage()));
                drop(path);
                println!("| {} {n}, r {radius} | {held:.0} | {now:.0} | {peak:.0} |", sample.name);
            }
        }
    }
}
