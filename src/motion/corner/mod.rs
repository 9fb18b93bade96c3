//! Corners between lines, rounded by Pythagorean-hodograph curves.
//!
//! A line has no curvature, so a curve that leaves it with continuous jerk must have none either,
//! nor a derivative of it, where they meet. Of the curves of lowest degree that do, the one of
//! degree 13 with a balanced middle is bent least for its deviation.

mod family;
mod shape;

use glam::DVec3;

pub use family::CornerCurve;
use family::Series;
pub use shape::CornerShape;

use super::{Frame, Straight};

/// A rounded corner in its place, by arc length.
///
/// # Guarantees
/// It runs from the incoming line to the outgoing one, tangent to both, at the same distance from
/// the corner on either; curvature vanishes at both ends, and but for degree 5 its derivative too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    shape: CornerShape,
    /// Parametric speed at both ends [mm].
    scale: f64,
    /// The middle of the curve [mm].
    middle: DVec3,
    /// Unit tangent there.
    along: DVec3,
    /// Unit normal there, towards the centre of the bend.
    across: DVec3,
    /// Where it begins on the whole curve [mm].
    from: f64,
    /// Arc length [mm].
    pub(super) length: f64,
}

impl Corner {
    /// The curve that rounds the corner at `at` [mm] between two unit tangents, its ends `leg` [mm]
    /// from it; `None` where they do not turn, or go back.
    #[must_use]
    pub fn with_leg(
        curve: CornerCurve,
        at: DVec3,
        [incoming, outgoing]: [DVec3; 2],
        leg: f64,
    ) -> Option<Self> {
        let shape = CornerShape::between(curve, incoming, outgoing)?;
        let scale = leg / shape.leg();
        let across = (outgoing - incoming).try_normalize()?;
        Some(Self {
            shape,
            scale,
            middle: at + across * (scale * shape.deviation()),
            along: (incoming + outgoing).try_normalize()?,
            across,
            from: 0.0,
            length: scale * shape.length(),
        })
    }

    /// What it is by its turn alone.
    #[must_use]
    pub fn shape(&self) -> &CornerShape {
        &self.shape
    }

    /// Its scale [mm]: what lengths of its [shape](Self::shape) are multiplied by.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Arc length [mm], in closed form.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Point and derivatives at the arc length `s` [mm] from the start.
    ///
    /// The parameter is found by Newton's method on the arc length, which is a polynomial: two steps
    /// leave 3e-16 of the length for degree 13, whose parameter is almost the arc length itself.
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        let (root, length) = (self.shape.root(), self.shape.along(1.0));
        // Twice the distance from the middle over the scale; over the length it is x, almost.
        let whole: f64 = length.iter().sum();
        let wanted = 2.0 * (self.from + s) / self.scale - whole;
        let mut x = wanted / whole;
        for _ in 0..self.shape.curve.family().steps {
            let step = (x * value(&length, x * x) - wanted) / root.speed(x);
            x = (x - step).clamp(-1.1, 1.1);
            if step.abs() < 1e-16 {
                break;
            }
        }
        let y = x * x;
        let [along, across] = [
            0.5 * self.scale * x * (value(&length, y) - value(&self.shape.behind(), y)),
            self.scale * self.shape.sin * y * value(&self.shape.across(), y),
        ];
        let ([cos, sin], curvature, sharpness) = root.bend(x);
        let tangent = self.along * cos + self.across * sin;
        let normal = self.across * cos - self.along * sin;
        let curvature = curvature / self.scale;
        let sharpness = sharpness / (self.scale * self.scale);
        Frame {
            point: self.middle + self.along * along + self.across * across,
            tangent,
            curvature: normal * curvature,
            sharpness: normal * sharpness - tangent * (curvature * curvature),
        }
    }

    /// The part from one arc length to another [mm].
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        Self { from: self.from + from, length: to - from, ..*self }
    }

    /// The two legs that the whole curve rounds: to the corner, and from it.
    #[must_use]
    pub fn legs(&self) -> [Straight; 2] {
        let CornerShape { cos, sin, half_cos, .. } = self.shape;
        let length = self.scale * self.shape.leg();
        let corner = self.middle - self.across * (self.scale * self.shape.deviation());
        let [along, across] = [self.along * half_cos, self.across * (2.0 * sin * cos)];
        let (incoming, outgoing) = (along - across, along + across);
        [
            Straight { start: corner - incoming * length, tangent: incoming, length },
            Straight { start: corner, tangent: outgoing, length },
        ]
    }

    /// Its control points in Bernstein form [mm]: 14 for degree 13, of which the first four and the
    /// last four lie on the lines.
    ///
    /// The products of the coefficients of `w` are unit vectors at quarters of the turn, which sums
    /// of the tangents give without an angle.
    #[must_use]
    pub fn control_points(&self) -> Vec<DVec3> {
        let CornerShape { cos, sin, half_cos, .. } = self.shape;
        // At the whole, three quarters and a half of the turn.
        let half_sin = 2.0 * sin * cos;
        let turned = |c: f64, s: f64| self.along * c + self.across * s;
        let directions = [
            turned(half_cos, -half_sin),
            turned(cos, -sin),
            self.along,
            turned(cos, sin),
            turned(half_cos, half_sin),
        ];
        // The middle coefficient of degree 13, which makes |w| = 1 in the middle too.
        let middle = (16.0 - 11.0 * cos) / 5.0;
        let control = self.shape.curve.family().control;
        let degree = control.len() - 1;
        let leg = self.scale * self.shape.leg();
        let corner = self.middle - self.across * (self.scale * self.shape.deviation());
        let mut points = vec![corner - directions[0] * leg];
        let mut end = points[0];
        for k in 0..=2 * degree {
            let mut derivative = DVec3::ZERO;
            for (i, (a, angle, balanced)) in control.iter().enumerate() {
                let Some((b, other, also)) = k.checked_sub(i).and_then(|j| control.get(j)) else {
                    continue;
                };
                let weight = binomial(degree, i) * binomial(degree, k - i);
                let free = if *balanced { middle } else { 1.0 } * if *also { middle } else { 1.0 };
                derivative += directions[angle + other] * (weight * a * b * free);
            }
            end += derivative * (self.scale / (binomial(2 * degree, k) * (2 * degree + 1) as f64));
            points.push(end);
        }
        points
    }
}

/// A polynomial of `y` (Horner).
fn value(series: &Series, y: f64) -> f64 {
    let mut sum = 0.0;
    for c in series.iter().rev() {
        sum = sum * y + c;
    }
    sum
}

fn binomial(n: usize, k: usize) -> f64 {
    let mut product = 1.0;
    for i in 0..k {
        product = product * (n - i) as f64 / (i + 1) as f64;
    }
    product
}
