//! What planning a motion costs: time per block and per sample, and memory where samples are taken
//! away as they come. `cargo bench --package peers --bench motion`; `benches/motion.mjs` has the same
//! as WebAssembly.

use std::f64::consts::TAU;
use std::time::{SystemTime, UNIX_EPOCH};

use g41::contour::{Move, MoveCurve, Plane, Role};
use g41::diagnostic::Origin;
use g41::geometry::Line;
use g41::motion::{Limits, Motion, Planner};
use glam::DVec2;
use peak_alloc::PeakAlloc;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Most samples that are kept before they are taken away.
const KEPT: usize = 4096;

type Shape = fn(u32) -> DVec2;

fn main() {
    let shapes: [(&str, Shape); 3] = [
        ("waves, points 0.2 mm apart", waves),
        ("blocks of 3 to 8 mm", corners),
        ("stairs", stairs),
    ];
    println!("| path | blocks | motion, s | samples | µs a block | MB at most |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for (name, shape) in shapes {
        let counts: &[u32] = if std::env::args().any(|word| word == "rates") {
            &[]
        } else if name.starts_with("waves") {
            &[10_000, 100_000, 1_000_000]
        } else {
            &[1_000]
        };
        for count in counts {
            streamed(name, shape, *count);
        }
    }
    println!("\n| path | samples at 50 kHz | millions of samples a second |\n| --- | --- | --- |");
    rate("a line", |k| DVec2::new(f64::from(k) * 4000.0, 0.0), 1);
    for (name, shape) in shapes {
        rate(name, shape, if name.starts_with("waves") { 2000 } else { 100 });
    }
}

/// Plans blocks as they come, and keeps few samples.
fn streamed(name: &str, shape: Shape, count: u32) {
    let before = ALLOCATOR.current_usage_as_mb();
    ALLOCATOR.reset_peak_usage();
    let begun = now();
    let Ok(mut planner) = Planner::new(&Limits::default()) else { return };
    let (mut motion, mut samples) = (Motion::default(), 0);
    for k in 0..count {
        planner.push(&line(shape(k), shape(k + 1)), &mut motion);
        if motion.len() > KEPT {
            samples += motion.len();
            motion.clear_samples();
        }
    }
    planner.finish(&mut motion);
    samples += motion.len();
    let each = (now() - begun) * 1e6 / f64::from(count);
    let memory = ALLOCATOR.peak_usage_as_mb() - before;
    println!("| {name} | {count} | {:.1} | {samples} | {each:.1} | {memory:.2} |", motion.duration);
}

/// Samples in a second: what four times as many samples of the same law take longer, in memory that
/// is there already.
fn rate(name: &str, shape: Shape, count: u32) {
    let moves: Vec<Move> = (0..count).map(|k| line(shape(k), shape(k + 1))).collect();
    let limits = Limits::default();
    let mut found = Vec::new();
    for period in [2e-5, 5e-6] {
        let limits = Limits { period, snap: Some(limits.snap()), chord_error: 1.0, ..limits };
        let (mut best, mut samples) = (f64::INFINITY, 0);
        let mut motion = Motion::default();
        for _ in 0..3 {
            motion.clear_samples();
            let begun = now();
            let Ok(mut planner) = Planner::new(&limits) else { return };
            for one in &moves {
                planner.push(one, &mut motion);
            }
            planner.finish(&mut motion);
            best = best.min(now() - begun);
            samples = motion.len();
        }
        found.push((samples as f64, best));
    }
    let [(few, short), (many, long)] = found[..] else { return };
    println!("| {name} | {few} | {:.1} |", (many - few) / (long - short) * 1e-6);
}

/// Time on the processor where the system tells it [s]: a machine may be busy with much else.
fn now() -> f64 {
    let told = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let spent = told.split(' ').next().and_then(|text| text.parse::<f64>().ok());
    let clock =
        || SystemTime::now().duration_since(UNIX_EPOCH).map_or(0.0, |time| time.as_secs_f64());
    spent.map_or_else(clock, |nanoseconds| nanoseconds * 1e-9)
}

/// Lines of waves beside each other.
fn waves(k: u32) -> DVec2 {
    let (row, on) = (k / 500, k % 500);
    let on = if row % 2 == 0 { on } else { 499 - on };
    let x = 0.2 * f64::from(on);
    DVec2::new(x, f64::from(row % 500) * 0.5 + 2.0 * (x * TAU / 40.0).sin())
}

/// Corners of all angles.
fn corners(k: u32) -> DVec2 {
    let spread = |k: u32| f64::from(k.wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 24);
    let angle = TAU * spread(k);
    DVec2::new(f64::from(k % 100) * 4.0, f64::from(k / 100) * 0.3)
        + DVec2::from_angle(angle) * (1.0 + spread(k + 7))
}

/// Right angles, 5 mm apart.
fn stairs(k: u32) -> DVec2 {
    DVec2::new(f64::from(k.div_ceil(2)), f64::from(k / 2)) * 5.0
}

fn line(from: DVec2, to: DVec2) -> Move {
    Move {
        curve: Line::new(from, to).map_or(MoveCurve::Vertical(from), MoveCurve::Line),
        role: Role::Free,
        rapid: false,
        feed: None,
        plane: Plane::Xy,
        heights: [0.0; 2],
        origin: Origin::Segment(0),
    }
}
