//! A circular arc, up to a full circle, of either sense.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::{Bounds, CurveError, MIN_LENGTH, Nearest, curve::checked_point, perp, rotate, turn};

/// A circular arc, up to a full circle, of either sense.
///
/// # Guarantees
/// Start, end and centre are finite and at most 1e9 mm. The
/// radius is at least [`MIN_LENGTH`] and the distance of both ends from the centre, up to rounding;
/// of one that winds in or out it is that of its start.
/// The sweep is in `[-2π, 2π]` and not zero; the length is at least [`MIN_LENGTH`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    start: DVec2,
    end: DVec2,
    center: DVec2,
    radius: f64,
    sweep: f64,
}

/// No program rounds its coordinates to less than this; what radii differ by less is noise [mm].
const LEAST_ROUNDING: f64 = 1e-7;

/// Which of the two arcs of a given radius is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RadiusForm {
    /// At most half a circle: the R word is positive.
    Minor,
    /// At least half a circle: the R word is negative.
    Major,
}

impl Arc {
    /// The arc from `start` to `end` about `center` [mm]; a full circle where start and end
    /// coincide.
    ///
    /// Programs round coordinates, so the two radii may differ by up to `tolerance` [mm]; the
    /// centre is then moved to the nearest point that is equally far from both ends. Where that is
    /// farther than the radii differ, on an arc of more than half a circle, the end is moved onto
    /// the circle about the centre instead, unless the tolerance is infinite.
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`], [`CurveError::ZeroLength`] where the centre is on the start, or
    /// [`CurveError::RadiiDisagree`].
    pub fn from_center(
        start: DVec2,
        end: DVec2,
        center: DVec2,
        clockwise: bool,
        tolerance: f64,
    ) -> Result<Self, CurveError> {
        for point in [start, end, center] {
            checked_point(point)?;
        }
        let radii = (start.distance(center), end.distance(center));
        if (radii.0 - radii.1).abs() > tolerance {
            return Err(CurveError::RadiiDisagree { start: radii.0, end: radii.1 });
        }
        if radii.0 < MIN_LENGTH || radii.1 < MIN_LENGTH {
            return Err(CurveError::ZeroLength);
        }
        let full_turn = if clockwise { -TAU } else { TAU };
        if start.distance(end) < MIN_LENGTH {
            return Ok(Self { start, end, center, radius: radii.0, sweep: full_turn });
        }
        // The nearest centre equally far from both ends: the foot on their perpendicular bisector.
        let middle = start.midpoint(end);
        let along = (end - start).normalize();
        let shift = (center - middle).dot(along);
        let sweep = sweep_between(start - center, end - center, clockwise);
        let apart = (radii.0 - radii.1).abs().max(LEAST_ROUNDING);
        if sweep.abs() > PI && shift.abs() > apart && tolerance.is_finite() {
            // Between ends that are close, a micrometre of radius turns the bisector by degrees,
            // and most of the circle would be somewhere else.
            let end = center + (end - center) * (radii.0 / radii.1);
            return Ok(Self { start, end, center, radius: radii.0, sweep });
        }
        let center = center - along * shift;
        let radius = start.distance(center);
        if radius < MIN_LENGTH {
            return Err(CurveError::ZeroLength);
        }
        let sweep = sweep_between(start - center, end - center, clockwise);
        Ok(Self { start, end, center, radius, sweep })
    }

    /// The arc from `start` to `end` about `center` [mm] as it is stated, a full turn where start and
    /// end coincide. Where the end is not as far from the centre as the start, it winds in or out by
    /// that much, of which only its end point tells.
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`], or [`CurveError::ZeroLength`] where the centre is on the start.
    pub fn winding(
        start: DVec2,
        end: DVec2,
        center: DVec2,
        clockwise: bool,
    ) -> Result<Self, CurveError> {
        for point in [start, end, center] {
            checked_point(point)?;
        }
        let radius = start.distance(center);
        if radius < MIN_LENGTH {
            return Err(CurveError::ZeroLength);
        }
        let sweep = if start.distance(end) < MIN_LENGTH {
            if clockwise { -TAU } else { TAU }
        } else {
            sweep_between(start - center, end - center, clockwise)
        };
        Ok(Self { start, end, center, radius, sweep })
    }

    /// The arc of `radius` [mm] from `start` to `end`; two circles pass through both, and `form`
    /// tells which is meant.
    ///
    /// The radius may be less than half the distance of the ends by up to `tolerance` [mm], as
    /// rounding of a half circle makes it; it then is a half circle.
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`], [`CurveError::FullCircleByRadius`] or
    /// [`CurveError::RadiusTooSmall`].
    pub fn from_radius(
        start: DVec2,
        end: DVec2,
        radius: f64,
        form: RadiusForm,
        clockwise: bool,
        tolerance: f64,
    ) -> Result<Self, CurveError> {
        checked_point(start)?;
        checked_point(end)?;
        let half_chord = 0.5 * start.distance(end);
        if half_chord < 0.5 * MIN_LENGTH {
            return Err(CurveError::FullCircleByRadius);
        }
        if radius.is_nan() || radius < half_chord - tolerance {
            return Err(CurveError::RadiusTooSmall { radius, least: half_chord });
        }
        let to_center = (radius * radius - half_chord * half_chord).max(0.0).sqrt();
        // A counter-clockwise arc of less than half a circle has its centre on the left of its chord.
        let on_the_left = clockwise == (form == RadiusForm::Major);
        let left = perp(end - start) / (2.0 * half_chord);
        let side = if on_the_left { to_center } else { -to_center };
        let center = start.midpoint(end) + left * side;
        Self::from_center(start, end, center, clockwise, f64::INFINITY)
    }

    /// The arc that starts at `start`, turns about `center` by `sweep` rad in `[-2π, 2π]`.
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`] or [`CurveError::ZeroLength`].
    pub fn from_sweep(start: DVec2, center: DVec2, sweep: f64) -> Result<Self, CurveError> {
        checked_point(start)?;
        checked_point(center)?;
        let radius = start.distance(center);
        if radius < MIN_LENGTH || radius * sweep.abs() < MIN_LENGTH || sweep.is_nan() {
            return Err(CurveError::ZeroLength);
        }
        let sweep = sweep.clamp(-TAU, TAU);
        let end = if sweep.abs() == TAU { start } else { center + rotate(start - center, sweep) };
        checked_point(end)?;
        Ok(Self { start, end, center, radius, sweep })
    }

    /// Where the arc begins [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.start
    }

    /// Where the arc ends [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        self.end
    }

    /// The centre of its circle [mm].
    #[must_use]
    pub fn center(&self) -> DVec2 {
        self.center
    }

    /// The radius of its circle [mm].
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The angle it turns by [rad], positive counter-clockwise.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        self.sweep
    }

    /// Whether it runs clockwise, as G2 does.
    #[must_use]
    pub fn is_clockwise(&self) -> bool {
        self.sweep < 0.0
    }

    /// Whether it is a full circle.
    #[must_use]
    pub fn is_full_circle(&self) -> bool {
        self.sweep.abs() == TAU
    }

    /// The point at `t`; exact at both ends. Values outside `[0, 1]` lie on the circle.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        if t == 0.0 {
            self.start
        } else if t == 1.0 {
            self.end
        } else {
            self.center + rotate(self.start - self.center, t * self.sweep)
        }
    }

    /// Unit tangent at `t`.
    #[must_use]
    pub fn tangent(&self, t: f64) -> DVec2 {
        perp(self.point(t) - self.center).normalize() * self.sweep.signum()
    }

    /// Curvature [1/mm], positive where the arc turns left.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.sweep.signum() / self.radius
    }

    /// Arc length [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.radius * self.sweep.abs()
    }

    /// The parameter at which the arc, run on to a full turn, meets the ray from its centre
    /// through `point`: in `[0, 2π / |sweep|)`, so beyond 1 off the arc.
    #[must_use]
    pub fn parameter(&self, point: DVec2) -> f64 {
        let angle = turn(self.start - self.center, point - self.center) * self.sweep.signum();
        let angle = if angle < 0.0 { angle + TAU } else { angle };
        angle / self.sweep.abs()
    }

    /// Like [`parameter`](Self::parameter), but a point off the arc by at most `slack` [mm]
    /// counts as the end it is next to; `None` where it is farther off.
    #[must_use]
    pub fn parameter_within(&self, point: DVec2, slack: f64) -> Option<f64> {
        let t = self.parameter(point);
        if t <= 1.0 {
            return Some(t);
        }
        let slack = slack / self.length();
        let full_turn = TAU / self.sweep.abs();
        match (t - 1.0 <= slack, full_turn - t <= slack) {
            (true, true) if full_turn - t < t - 1.0 => Some(0.0),
            (true, _) => Some(1.0),
            (false, true) => Some(0.0),
            (false, false) => None,
        }
    }

    /// The smallest box around the arc.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::of([self.start, self.end]);
        for axis in [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y] {
            let extreme = self.center + axis * self.radius;
            if self.parameter(extreme) <= 1.0 {
                bounds.add(extreme);
            }
        }
        bounds
    }

    /// The same arc run the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { start: self.end, end: self.start, sweep: -self.sweep, ..*self }
    }

    /// Both parts of the arc cut at `t`, strictly inside `(0, 1)`.
    ///
    /// # Errors
    /// [`CurveError::ZeroLength`] where a part would have no length.
    pub fn split(&self, t: f64) -> Result<(Self, Self), CurveError> {
        let middle = self.point(t);
        let first = Self { end: middle, sweep: self.sweep * t, ..*self };
        let second = Self { start: middle, sweep: self.sweep * (1.0 - t), ..*self };
        if first.length() < MIN_LENGTH || second.length() < MIN_LENGTH {
            return Err(CurveError::ZeroLength);
        }
        Ok((first, second))
    }

    /// The point of the arc nearest to `point`; its start for the centre, which has no nearest.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> Nearest {
        let ends =
            Nearest::new(0.0, self.start, point).or_nearer(Nearest::new(1.0, self.end, point));
        let t = self.parameter(point);
        if t > 1.0 || point == self.center {
            return ends;
        }
        let foot = self.center + (point - self.center).normalize() * self.radius;
        Nearest::new(t, foot, point).or_nearer(ends)
    }
}

/// The angle from the radius to the start to that to the end, in the sense given.
fn sweep_between(start: DVec2, end: DVec2, clockwise: bool) -> f64 {
    let swept = turn(start, end);
    match (clockwise, swept > 0.0) {
        (false, true) | (true, false) => swept,
        (false, false) => swept + TAU,
        (true, true) => swept - TAU,
    }
}
