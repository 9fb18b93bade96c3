//! What a machine can do, and how far its path may leave the programmed one.

use std::error::Error;
use std::fmt;

use super::CornerCurve;

/// Limits of each of the axes x, y and z, beside those of the vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisLimits {
    /// Largest velocity [mm/s].
    pub velocity: [f64; 3],
    /// Largest acceleration [mm/s²].
    pub acceleration: [f64; 3],
    /// Largest jerk [mm/s³].
    pub jerk: [f64; 3],
}

/// How speed is planned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// As fast as the limits allow, and within them.
    #[default]
    Fast,
    /// CN patent, Shanghai University of Engineering Science, 2022, to the letter: one quintic of
    /// velocity between the midpoints of corners. It breaks limits, and reports which.
    Textbook,
}

/// What to do where a line runs into an arc, and curvature has a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CurvatureSteps {
    /// Round them within the corner deviation.
    #[default]
    Round,
    /// Keep the path and slow down, so that the step of the acceleration is one that the jerk and
    /// its change allow in a period.
    Slow,
    /// Keep the path and stop.
    Stop,
}

/// What the planner holds to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest velocity [mm/s].
    pub velocity: f64,
    /// Largest size of the acceleration vector [mm/s²].
    pub acceleration: f64,
    /// Largest size of the jerk vector [mm/s³].
    pub jerk: f64,
    /// How far rounding may leave a corner [mm]; 0 stops at each (G61).
    pub corner_deviation: f64,
    /// Largest gap between the path and the chord of a period [mm].
    pub chord_error: f64,
    /// Interpolation period [s].
    pub period: f64,
    /// Largest rate of the jerk [mm/s⁴]; without one, it reaches its limit in five periods.
    pub snap: Option<f64>,
    /// How speed is planned.
    pub mode: Mode,
    /// Limits of single axes.
    pub axes: Option<AxisLimits>,
    /// Factor on programmed feeds, rapids excepted; 1 is 100 %.
    pub feed_override: f64,
    /// What to do at steps of curvature.
    pub curvature_steps: CurvatureSteps,
    /// The curve that rounds corners.
    pub corner: CornerCurve,
    /// Stop at the end of each block (G61) instead of rounding corners (G64).
    pub exact_stop: bool,
    /// Fit curves to runs of straight moves, within the corner deviation: a path of short moves is
    /// slow without (COMPCAD and COMPOF of other controls). Without, and in textbook mode, corners are
    /// rounded one by one.
    pub fit: bool,
}

impl Default for Limits {
    /// Those of a small mill: 200 mm/s, 2000 mm/s², 5e4 mm/s³, 0.05 mm, 1 µm, 1 ms.
    fn default() -> Self {
        Self {
            velocity: 200.0,
            acceleration: 2000.0,
            jerk: 5.0e4,
            corner_deviation: 0.05,
            chord_error: 1.0e-3,
            period: 1.0e-3,
            snap: None,
            mode: Mode::Fast,
            axes: None,
            feed_override: 1.0,
            curvature_steps: CurvatureSteps::Round,
            corner: CornerCurve::Eased,
            exact_stop: false,
            fit: true,
        }
    }
}

impl Limits {
    /// The largest rate of the jerk [mm/s⁴].
    #[must_use]
    pub fn snap(&self) -> f64 {
        self.snap.unwrap_or(self.jerk / (5.0 * self.period))
    }

    /// What the acceleration may step by where the curvature does [mm/s²]: most of half of what the
    /// jerk, or the change of the jerk, makes of it in a period.
    pub(super) fn step(&self) -> f64 {
        0.4 * self.jerk.min(self.snap() * self.period) * self.period
    }

    /// That each can be held to.
    ///
    /// # Errors
    /// [`LimitsError`] names the first that is not a positive number in its range.
    pub fn check(&self) -> Result<(), LimitsError> {
        // The ranges keep every quotient and power of the planner far from overflow.
        let mut numbers = [
            ("velocity", self.velocity, 1.0e-6, 1.0e6),
            ("acceleration", self.acceleration, 1.0e-6, 1.0e9),
            ("jerk", self.jerk, 1.0e-6, 1.0e12),
            ("chordError", self.chord_error, 1.0e-9, 1.0e3),
            ("period", self.period, 1.0e-6, 1.0),
            ("snap", self.snap(), 1.0e-6, 1.0e18),
            ("feedOverride", self.feed_override, 1.0e-3, 1.0e2),
            ("cornerDeviation", self.corner_deviation, 0.0, 1.0e3),
        ]
        .to_vec();
        if let Some(axes) = &self.axes {
            for axis in 0..3 {
                numbers.push(("axes.velocity", axes.velocity[axis], 1.0e-6, 1.0e6));
                numbers.push(("axes.acceleration", axes.acceleration[axis], 1.0e-6, 1.0e9));
                numbers.push(("axes.jerk", axes.jerk[axis], 1.0e-6, 1.0e12));
            }
        }
        for (name, value, least, most) in numbers {
            if !(least..=most).contains(&value) {
                return Err(LimitsError { name });
            }
        }
        Ok(())
    }
}

/// A limit that cannot be held to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LimitsError {
    /// Its name, as JavaScript has it.
    pub name: &'static str,
}

impl fmt::Display for LimitsError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name)?;
        formatter.write_str(" must be a positive number within reason")
    }
}

impl Error for LimitsError {}
