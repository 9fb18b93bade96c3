//! A handle of the motion along a tool path.

use std::rc::Rc;

use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::contour_records::read_contours;
use super::report::violations_json;
use super::tool_path::ToolPathHandle;
use crate::contour::{Contour, ToolPath};
use crate::geometry::Curve;
use crate::motion::{
    AxisLimits, CornerCurve, CurvatureSteps, Limits, LimitsError, Mode, StepRule, interpolate,
    lengths_at,
};
use crate::simulation::{PathMotion, plan_path, tool_changes};

/// Motion in time; `Motion` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct MotionHandle {
    planned: PathMotion,
    path: Rc<ToolPath>,
    limits: Limits,
}

/// Plans the motion along a path; the numbers are those that `limits.js` packs.
///
/// # Errors
/// Where a limit is not a positive number within reason.
#[wasm_bindgen(js_name = planMotion)]
pub fn plan_motion(path: &ToolPathHandle, numbers: &[f64]) -> Result<MotionHandle, BadArgument> {
    let limits = limits_of(numbers);
    let planned = plan_path(path.path(), &limits).map_err(bad)?;
    Ok(MotionHandle { planned, path: path.shared(), limits })
}

/// A spline in more steps than these is a mistake in their unit.
const MOST_STEPS: f64 = 1e6;

/// Steps of `step` [mm] along the first spline of contours by a rule, as `interpolate.js` numbers it: x, y
/// and the arc length from the start [mm] of each point.
///
/// # Errors
/// Where a record is wrong, there is no spline, or a step is too short for it.
#[wasm_bindgen(js_name = stepSpline)]
pub fn step_spline(
    records: &[f64],
    step: f64,
    rule: u8,
    corrections: u8,
) -> Result<Vec<f64>, BadArgument> {
    let rule = match rule {
        0 => StepRule::TaylorFirst,
        1 => StepRule::TaylorSecond,
        2 => StepRule::RungeKutta,
        3 => StepRule::PredictorCorrector(corrections),
        _ => StepRule::ArcLength(corrections),
    };
    for contour in read_contours(records)?.0 {
        for segment in contour.build().contour.iter().flat_map(Contour::segments) {
            if let Curve::Spline(spline) = &segment.curve {
                if spline.length() > MOST_STEPS * step {
                    return Err(BadArgument::new("step", "be a millionth of the spline at least"));
                }
                let found = interpolate(spline, step, rule);
                let mut points = Vec::with_capacity(3 * found.len());
                for (&t, length) in found.iter().zip(lengths_at(spline, &found)) {
                    let point = spline.point(t);
                    points.extend([point.x, point.y, length]);
                }
                return Ok(points);
            }
        }
    }
    Err(BadArgument::new("contour.segments", "hold a spline"))
}

/// The tools of a path by number, each after the index of its first move.
#[wasm_bindgen(js_name = toolChanges)]
#[must_use]
pub fn tools_of(path: &ToolPathHandle) -> Vec<f64> {
    let mut numbers = Vec::new();
    for (from, tool) in tool_changes(path.path()) {
        numbers.push(from as f64);
        numbers.push(tool);
    }
    numbers
}

#[wasm_bindgen]
impl MotionHandle {
    /// `duration` [s].
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.planned.motion().duration
    }

    /// The number of samples.
    #[must_use]
    pub fn count(&self) -> usize {
        self.planned.motion().len()
    }

    /// One of the channels, in the order of `motion.js`.
    #[must_use]
    pub fn channel(&self, index: u32) -> Vec<f64> {
        let motion = self.planned.motion();
        match index {
            0 => &motion.time,
            1 => &motion.x,
            2 => &motion.y,
            3 => &motion.z,
            4 => &motion.velocity,
            5 => &motion.tangential_acceleration,
            6 => &motion.normal_acceleration,
            _ => &motion.jerk,
        }
        .clone()
    }

    /// `violations` as JSON.
    #[must_use]
    pub fn violations(&self) -> String {
        let found = self.planned.violations(&self.path, &self.limits);
        violations_json(&found, self.duration())
    }

    /// `step` where ways are counted, else `block`.
    #[must_use]
    pub fn block(&self, counts_ways: bool) -> Vec<u32> {
        if counts_ways { self.planned.motion().block.clone() } else { self.planned.blocks() }
    }
}

/// Limits from numbers in the order of `limits.js`: NaN stands for a snap that is not given, and the
/// axes may be missing.
fn limits_of(numbers: &[f64]) -> Limits {
    let at = |index: usize| numbers.get(index).copied().unwrap_or_default();
    let three = |first: usize| [at(first), at(first + 1), at(first + 2)];
    Limits {
        velocity: at(0),
        acceleration: at(1),
        jerk: at(2),
        corner_deviation: at(3),
        chord_error: at(4),
        period: at(5),
        snap: (!at(6).is_nan()).then_some(at(6)),
        feed_override: at(7),
        mode: if at(8) > 0.0 { Mode::Textbook } else { Mode::Fast },
        curvature_steps: match at(9) {
            ..0.5 => CurvatureSteps::Round,
            0.5..1.5 => CurvatureSteps::Slow,
            _ => CurvatureSteps::Stop,
        },
        corner: match at(10) {
            ..0.5 => CornerCurve::Eased,
            0.5..1.5 => CornerCurve::Ph13,
            1.5..2.5 => CornerCurve::Ph11,
            2.5..3.5 => CornerCurve::Ph9,
            _ => CornerCurve::Ph5,
        },
        exact_stop: at(11) > 0.0,
        fit: true,
        axes: (numbers.len() > 12).then(|| AxisLimits {
            velocity: three(12),
            acceleration: three(15),
            jerk: three(18),
        }),
    }
}

fn bad(LimitsError { name }: LimitsError) -> BadArgument {
    let must = match name {
        "period" => {
            "be a positive number within reason, longer where a motion has more than 8 million samples"
        }
        "cornerDeviation" => "be at least 0 and within reason",
        _ => "be a positive number within reason",
    };
    BadArgument::new(format!("limits.{name}"), must)
}
