//! Time per block of fitting curves to dense paths: `cargo bench --bench fit`.

use std::f64::consts::TAU;
use std::time::Instant;

use g41::motion::Fitter;
use glam::{DVec3, dvec3};

fn main() {
    let spiral = |count: u32| {
        let at = |i: u32| {
            let angle = 12.0 * TAU * (f64::from(i) / f64::from(count)).sqrt();
            let radius = 5.0 + 45.0 * angle / (12.0 * TAU);
            dvec3(radius * angle.cos(), radius * angle.sin(), 0.0)
        };
        (0..=count).map(at).collect::<Vec<DVec3>>()
    };
    for count in [1_000, 10_000, 100_000, 1_000_000] {
        let points = spiral(count);
        let begun = Instant::now();
        let mut fitter = Fitter::new(points[0], 0.05);
        let (mut fitted, mut pieces) = (Vec::new(), 0);
        for (block, point) in (0..).zip(&points[1..]) {
            fitter.line(*point, block, 100.0, &mut fitted);
            pieces += fitted.len();
            fitted.clear();
        }
        fitter.finish(&mut fitted);
        pieces += fitted.len();
        let each = begun.elapsed().as_secs_f64() * 1e6 / f64::from(count);
        println!("spiral of {count} blocks: {pieces} pieces, {each:.3} µs a block");
    }
}
