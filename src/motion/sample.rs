//! Motion in time: samples at multiples of the interpolation period.

use std::fmt::Write;

use glam::DVec3;

use crate::geometry::Decimal;

/// Most samples of one motion: more than two hours at a millisecond. They take 600 MB, and what would
/// come after them is left out.
pub const MOST_SAMPLES: usize = 1 << 23;

/// Where the tool is, and how fast, at multiples of the interpolation period from 0, and at the
/// end.
///
/// # Guarantees
/// All channels have one length.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Motion {
    /// Time [s].
    pub time: Vec<f64>,
    /// Position along x [mm].
    pub x: Vec<f64>,
    /// Position along y [mm].
    pub y: Vec<f64>,
    /// Position along z [mm].
    pub z: Vec<f64>,
    /// Speed along the path [mm/s].
    pub velocity: Vec<f64>,
    /// Acceleration along the path [mm/s²].
    pub tangential_acceleration: Vec<f64>,
    /// Size of the acceleration across the path [mm/s²].
    pub normal_acceleration: Vec<f64>,
    /// Size of the jerk vector [mm/s³].
    pub jerk: Vec<f64>,
    /// Index of the move.
    pub block: Vec<u32>,
    /// Time of the whole motion [s].
    pub duration: f64,
}

/// One sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// Time [s].
    pub(super) time: f64,
    /// Position [mm].
    pub(super) point: DVec3,
    /// Speed, tangential and normal acceleration, jerk.
    pub(super) rates: [f64; 4],
    /// Index of the move.
    pub(super) block: u32,
}

impl Motion {
    /// How many samples there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.time.is_empty()
    }

    /// The position of a sample [mm].
    #[must_use]
    pub fn point(&self, index: usize) -> DVec3 {
        DVec3::new(self.x[index], self.y[index], self.z[index])
    }

    /// Removes the samples and keeps their memory; the duration goes on.
    pub fn clear_samples(&mut self) {
        self.block.clear();
        for channel in self.channels_mut() {
            channel.clear();
        }
    }

    pub(super) fn push(&mut self, sample: Sample) {
        if self.len() >= MOST_SAMPLES {
            return;
        }
        let [velocity, tangential, normal, jerk] = sample.rates;
        let row = [
            sample.time,
            sample.point.x,
            sample.point.y,
            sample.point.z,
            velocity,
            tangential,
            normal,
            jerk,
        ];
        for (channel, value) in self.channels_mut().into_iter().zip(row) {
            channel.push(value);
        }
        self.block.push(sample.block);
    }

    fn channels_mut(&mut self) -> [&mut Vec<f64>; 8] {
        [
            &mut self.time,
            &mut self.x,
            &mut self.y,
            &mut self.z,
            &mut self.velocity,
            &mut self.tangential_acceleration,
            &mut self.normal_acceleration,
            &mut self.jerk,
        ]
    }

    /// The samples as comma-separated values, a line each, under a line of names.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut text = String::from(
            "time,x,y,z,velocity,tangentialAcceleration,normalAcceleration,jerk,block\n",
        );
        for index in 0..self.len() {
            let row = [
                self.time[index],
                self.x[index],
                self.y[index],
                self.z[index],
                self.velocity[index],
                self.tangential_acceleration[index],
                self.normal_acceleration[index],
                self.jerk[index],
                f64::from(self.block[index]),
            ];
            for (column, value) in row.into_iter().enumerate() {
                if column > 0 {
                    text.push(',');
                }
                let _ = write!(text, "{}", Decimal::new(value, 9));
            }
            text.push('\n');
        }
        text
    }
}
