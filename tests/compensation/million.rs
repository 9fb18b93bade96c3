//! Avoidance on a million seeded contours, judged; a part of them in every test run.
//!
//! All of them, or any range of seeds, with as many threads as there are cores:
//! `G41_SEEDS=0..1000000 cargo test --release --test compensation million -- --ignored --nocapture`.
//! `G41_BRUTE=N` looks at every Nth by brute force too; 100 unless told. `G41_PRINTED=N` prints that
//! many faults of each kind, `G41_THREADS=N` works with that many threads. A range of one seed prints
//! the case, less the segments without which it fails just the same.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::families::Case;
use super::verdict::{Depth, Fault, faults, path_of};

const CASES: u64 = if cfg!(target_arch = "wasm32") { 100 } else { 2_000 };

/// Faults of the contour of a seed; none for one that cannot be built.
fn judged(seed: u64, depth: Depth) -> Vec<Fault> {
    faults_of(&Case::of(seed), depth)
}

fn faults_of(case: &Case, depth: Depth) -> Vec<Fault> {
    let Some(contour) = case.contour() else { return Vec::new() };
    let path = path_of(case, &contour);
    faults(case, &contour, &path, depth)
}

#[test]
fn the_first_of_a_million_contours_are_never_cut_and_all_reachable_is_reached() {
    for seed in 0..CASES {
        let found = judged(seed, if seed % 8 == 0 { Depth::Brute } else { Depth::Judged });
        assert!(found.is_empty(), "seed {seed}: {found:?} {:?}", Case::of(seed));
    }
}

#[cfg(not(target_arch = "wasm32"))]
mod whole {
    //! The program that runs any range of seeds.

    use std::collections::BTreeMap;
    use std::ops::Range;
    use std::panic::catch_unwind;
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
    use std::thread::{sleep, spawn};
    use std::time::{Duration, Instant};

    use super::super::families::Case;
    use super::super::verdict::{Depth, Fault, path_of};
    use super::{faults_of, judged};

    /// Longer than any contour of the families may take, on a machine that does other things too.
    const HANG: Duration = Duration::from_secs(10);

    /// Faults printed of each kind in each family, unless `G41_PRINTED` tells.
    const PRINTED: u64 = 4;

    struct Run {
        next: AtomicU64,
        end: u64,
        brute: u64,
        state: Mutex<State>,
    }

    #[derive(Default)]
    struct State {
        faults: BTreeMap<(&'static str, &'static str), u64>,
        cases: BTreeMap<&'static str, u64>,
        slowest: (Duration, u64),
        /// Seeds that are being worked on, and since when.
        busy: BTreeMap<u64, Instant>,
        /// Seeds given up on; their threads cannot be stopped.
        hanging: Vec<u64>,
        working: usize,
        printed: u64,
    }

    impl Run {
        fn state(&self) -> MutexGuard<'_, State> {
            self.state.lock().unwrap_or_else(PoisonError::into_inner)
        }

        fn work(&self) {
            loop {
                let seed = self.next.fetch_add(1, Ordering::Relaxed);
                if seed >= self.end {
                    self.state().working -= 1;
                    return;
                }
                let since = Instant::now();
                self.state().busy.insert(seed, since);
                let depth =
                    if seed.is_multiple_of(self.brute) { Depth::Brute } else { Depth::Judged };
                let found = catch_unwind(|| {
                    judged(seed, depth).into_iter().map(|f| (f.name(), f.to_string())).collect()
                })
                .unwrap_or_else(|_| vec![("panic", "panic".into())]);
                let mut state = self.state();
                if state.busy.remove(&seed).is_none() {
                    // Given up on; another thread works in the place of this one.
                    return;
                }
                state.slowest = state.slowest.max((since.elapsed(), seed));
                state.record(seed, found);
            }
        }
    }

    impl State {
        fn record(&mut self, seed: u64, found: Vec<(&'static str, String)>) {
            let family = Case::of(seed).family;
            *self.cases.entry(family).or_default() += 1;
            for (name, text) in found {
                let count = self.faults.entry((family, name)).or_default();
                *count += 1;
                if *count <= self.printed {
                    println!("seed {seed}, {family}: {text}");
                }
            }
        }

        /// Gives up on what takes too long; returns how many threads that costs.
        fn give_up(&mut self) -> usize {
            let late = |(seed, since): (&u64, &Instant)| (since.elapsed() > HANG).then_some(*seed);
            let hanging: Vec<u64> = self.busy.iter().filter_map(late).collect();
            for &seed in &hanging {
                self.busy.remove(&seed);
                self.hanging.push(seed);
                self.record(seed, vec![("hang", format!("takes more than {HANG:?}"))]);
            }
            hanging.len()
        }

        fn report(&self, taken: Duration) {
            println!("\n| family | contours | faults |\n| --- | --- | --- |");
            for (family, cases) in &self.cases {
                let of_family: Vec<String> = self
                    .faults
                    .iter()
                    .filter(|((of, _), _)| of == family)
                    .map(|((_, name), count)| format!("{count} {name}"))
                    .collect();
                let faults =
                    if of_family.is_empty() { "none".into() } else { of_family.join(", ") };
                println!("| {family} | {cases} | {faults} |");
            }
            let ((slowest, seed), total) = (self.slowest, self.cases.values().sum::<u64>());
            println!("\n{total} contours in {taken:.0?}, the slowest {slowest:.0?} (seed {seed})");
            println!("faults: {}", self.faults.values().sum::<u64>());
        }
    }

    fn range() -> Range<u64> {
        let text = std::env::var("G41_SEEDS").unwrap_or_else(|_| "0..1000000".into());
        let (from, to) = text.split_once("..").expect("G41_SEEDS is FROM..TO");
        from.parse().expect("a seed")..to.parse().expect("a seed")
    }

    /// The case without the segments that its fault does not need.
    fn reduced(mut case: Case) -> Case {
        let name_of = |case: &Case| faults_of(case, Depth::Brute).first().map(Fault::name);
        let Some(name) = name_of(&case) else { return case };
        let mut index = 0;
        while index < case.sketch.shapes.len() {
            let mut less = case.clone();
            less.sketch.shapes.remove(index);
            // Arcs whose start moved are no arcs any more.
            let whole = less.contour().is_some_and(|contour| {
                contour.segments().len() == less.sketch.shapes.len()
                    && contour.is_closed() == case.sketch.closed
            });
            if whole && name_of(&less) == Some(name) {
                case = less;
            } else {
                index += 1;
            }
        }
        case
    }

    fn number(name: &str, otherwise: u64) -> u64 {
        std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(otherwise)
    }

    #[test]
    #[ignore = "runs for as long as a million contours take"]
    fn all_seeds() {
        let seeds = range();
        if seeds.end - seeds.start == 1 {
            let case = Case::of(seeds.start);
            let started = Instant::now();
            let moves = case.contour().map_or(0, |contour| path_of(&case, &contour).moves.len());
            println!("{moves} moves in {:?}", started.elapsed());
            let case = reduced(case);
            println!("{case:?}\n{:?}", faults_of(&case, Depth::Brute));
        }
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let workers = number("G41_THREADS", cores as u64);
        let run = Arc::new(Run {
            next: AtomicU64::new(seeds.start),
            end: seeds.end,
            brute: number("G41_BRUTE", 100).max(1),
            state: Mutex::new(State {
                printed: number("G41_PRINTED", PRINTED),
                ..State::default()
            }),
        });
        let start = || {
            run.state().working += 1;
            let run = Arc::clone(&run);
            spawn(move || run.work());
        };
        let started = Instant::now();
        let hook = std::panic::take_hook();
        std::panic::set_hook(Box::new(|said| println!("{said}")));
        (0..workers).for_each(|_| start());
        while run.state().working > 0 {
            sleep(Duration::from_millis(100));
            let lost = run.state().give_up();
            for _ in 0..lost {
                run.state().working -= 1;
                start();
            }
        }
        std::panic::set_hook(hook);
        let state = run.state();
        state.report(started.elapsed());
        assert!(state.faults.is_empty(), "there are faults");
    }
}
