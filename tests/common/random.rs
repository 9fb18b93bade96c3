//! Seeded random numbers: the same cases on every machine.

use std::f64::consts::TAU;

use glam::DVec2;

/// The generator splitmix64 (Steele, Lea and Flood 2014).
#[derive(Debug, Clone)]
pub(crate) struct Random {
    state: u64,
}

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In `[0, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In `[from, to)`.
    pub(crate) fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }

    /// In `0..count`.
    #[expect(clippy::cast_possible_truncation, reason = "less than count")]
    pub(crate) fn index(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    pub(crate) fn coin(&mut self) -> bool {
        self.bits() & 1 == 1
    }

    /// −1 or 1.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.coin() { 1.0 } else { -1.0 }
    }

    /// In the square of half-width `reach` about the origin.
    pub(crate) fn point(&mut self, reach: f64) -> DVec2 {
        DVec2::new(self.within(-reach, reach), self.within(-reach, reach))
    }

    /// A unit vector of any direction.
    pub(crate) fn direction(&mut self) -> DVec2 {
        DVec2::from_angle(self.within(0.0, TAU))
    }
}
