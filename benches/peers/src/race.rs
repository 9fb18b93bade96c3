//! Competitors taking turns, so that a machine's moods fall on all alike; on any machine with a clock.

use std::hint::black_box;

/// What one competitor took and made.
#[derive(Debug, Clone, Default)]
pub struct Timed {
    nanoseconds: Vec<f64>,
    pub pieces: usize,
}

impl Timed {
    /// Median of its runs [ns].
    #[must_use]
    pub fn median(&self) -> f64 {
        let mut sorted = self.nanoseconds.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
    }
}

/// Runs the competitors in turn after a run of each to warm up; each tells how many pieces it made.
///
/// One that takes `patience` [ns] in all is not run again, and the others go on without it.
pub fn race<const N: usize>(
    runs: usize,
    patience: f64,
    mut competitors: [&mut dyn FnMut() -> usize; N],
) -> [Timed; N] {
    let mut timed = [(); N].map(|()| Timed::default());
    let mut spent = [0.0; N];
    for run in 0..=runs {
        for ((competitor, timed), spent) in competitors.iter_mut().zip(&mut timed).zip(&mut spent) {
            if *spent > patience {
                continue;
            }
            let start = now();
            timed.pieces = black_box(competitor());
            let taken = now() - start;
            *spent += taken;
            // The first run warms up, unless there is time for one only.
            if run > 0 || *spent > patience {
                timed.nanoseconds.push(taken);
            }
        }
    }
    timed
}

#[cfg(not(target_arch = "wasm32"))]
pub fn print(line: &str) {
    println!("{line}");
}

/// Nanoseconds since the first call.
#[cfg(not(target_arch = "wasm32"))]
#[must_use]
pub fn now() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64() * 1e9
}

#[cfg(target_arch = "wasm32")]
pub use in_wasm::{now, print};

#[cfg(target_arch = "wasm32")]
mod in_wasm {
    //! The clock and the console of the host.

    use wasm_bindgen::prelude::wasm_bindgen;

    #[wasm_bindgen]
    extern "C" {
        #[wasm_bindgen(js_namespace = performance, js_name = now)]
        fn milliseconds() -> f64;
        #[wasm_bindgen(js_namespace = console, js_name = log)]
        pub fn print(line: &str);
    }

    /// Nanoseconds.
    #[must_use]
    pub fn now() -> f64 {
        milliseconds() * 1e6
    }
}
