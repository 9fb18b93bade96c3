//! Curves whose arc length has no closed form, traversed by it.
//!
//! A table holds the parameter and its first two derivatives at places along the curve; between
//! them a polynomial of degree 5 that matches both ends gives the parameter to about 1e-4, and a step
//! of Newton's method on the length from the place before, by quadrature, to about 1e-9.

use glam::{DVec2, DVec3};

use super::Frame;
use crate::contour::Plane;
use crate::geometry::{Arc, Cubic, MIN_LENGTH, gauss_legendre, perp, roots, sin_cos};

/// Largest relative error of the feed at the places where that of a polynomial of degree 5 peaks:
/// the step of Newton's method about squares it.
const FEED_ERROR: f64 = 1e-4;

/// How far the parameter keeps from a place where the derivative vanishes: the curve there is a
/// parabola in it, so what is left out is 1e-12 of the second derivative.
const CUSP_GAP: f64 = 1e-6;

/// A derivative below this part of the curve's size counts as vanishing.
const CUSP_EPSILON: f64 = 1e-6;

/// More places than any curve but one made of rounding needs.
const MANY_MARKS: usize = 1000;

/// A curve with its arc length.
#[derive(Debug, Clone, PartialEq)]
pub struct ByLength {
    course: Course,
    /// Climb per length, along the normal of the curve's plane.
    climb: DVec3,
    /// Length in the plane per length.
    level: f64,
    marks: Vec<Mark>,
    /// Where it begins on the curve that it is a part of [mm].
    from: f64,
    /// Arc length [mm].
    pub(super) length: f64,
}

/// The curve itself, by a parameter.
#[derive(Debug, Clone, PartialEq)]
enum Course {
    /// A polynomial: coefficients of the powers of the parameter, the constant first [mm].
    Polynomial(Vec<DVec3>),
    /// A turn about a centre whose radius grows evenly.
    Spiral {
        /// The centre [mm].
        center: DVec3,
        /// From the centre to the start, and the same turned by 90° in the sense of motion, of unit
        /// length.
        axes: [DVec3; 2],
        /// At the start and what it grows by [mm].
        radius: [f64; 2],
        /// The whole turn [rad].
        turn: f64,
    },
}

/// A place on the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Mark {
    /// Arc length in the plane [mm].
    s: f64,
    /// Parameter, and its first and second derivative by that length.
    t: [f64; 3],
}

impl ByLength {
    /// The polynomial with these coefficients of the powers of `t` in `[0, 1]`, the constant first
    /// [mm].
    #[must_use]
    pub fn of_polynomial(coefficients: Vec<DVec3>) -> Self {
        Self::measured(Course::Polynomial(coefficients), [0.0, 1.0], (DVec3::ZERO, 1.0))
    }

    /// The pieces of a cubic in its plane that climbs evenly with its length between two heights
    /// [mm]. It is cut at cusps, where it turns back; one without a length has none.
    #[must_use]
    pub fn of_cubic(cubic: &Cubic, plane: Plane, heights: [f64; 2]) -> Vec<Self> {
        let size = cubic.hull_length();
        if size < MIN_LENGTH {
            return Vec::new();
        }
        let [p0, p1, p2, p3] = cubic.points.map(|point| plane.place(point, heights[0]));
        let (second, third) = ((p2 - p1) - (p1 - p0), (p3 - p0) - (p2 - p1) * 3.0);
        let course = Course::Polynomial(vec![p0, (p1 - p0) * 3.0, second * 3.0, third]);
        let rise = heights[1] - heights[0];
        let climb = if rise == 0.0 {
            (DVec3::ZERO, 1.0)
        } else {
            let flat = cubic.length();
            let length = flat.hypot(rise);
            (plane.place(DVec2::ZERO, rise / length), flat / length)
        };
        // |r'|² is least where r'·r'' vanishes; the product of the hodograph, of degree 2, and of
        // its derivative, of degree 1, has the weights C(2,i) C(1,j)/C(3,i+j).
        let [d0, d1, d2] = cubic.hodograph();
        let (e0, e1) = (d1 - d0, d2 - d1);
        let stationary = [
            d0.dot(e0),
            (d0.dot(e1) + 2.0 * d1.dot(e0)) / 3.0,
            (2.0 * d1.dot(e1) + d2.dot(e0)) / 3.0,
            d2.dot(e1),
        ];
        let mut cuts = vec![0.0];
        for t in roots(&stationary) {
            let inside = t > CUSP_GAP && t < 1.0 - CUSP_GAP;
            if inside && cubic.derivative(t).length() < CUSP_EPSILON * size {
                cuts.push(t);
            }
        }
        cuts.push(1.0);
        let mut parts = Vec::new();
        let mut begun = 0.0;
        for pair in cuts.windows(2) {
            let gap = |t: f64| {
                if cubic.derivative(t).length() < CUSP_EPSILON * size { CUSP_GAP } else { 0.0 }
            };
            let range = [pair[0] + gap(pair[0]), pair[1] - gap(pair[1])];
            let mut part = Self::measured(course.clone(), range, climb);
            // Heights go on along all of the cubic.
            if let Course::Polynomial(coefficients) = &mut part.course {
                coefficients[0] += climb.0 * begun;
            }
            begun += part.length;
            if part.length >= MIN_LENGTH {
                parts.push(part);
            }
        }
        parts
    }

    /// The arc that winds in or out evenly to its end, climbing evenly between two heights [mm].
    #[must_use]
    pub fn of_winding_arc(arc: &Arc, plane: Plane, heights: [f64; 2]) -> Self {
        let (out, end) = (arc.start() - arc.center(), arc.end() - arc.center());
        let radius = out.length();
        let axis = out / radius;
        let course = Course::Spiral {
            center: plane.place(arc.center(), heights[0]),
            axes: [axis, perp(axis) * arc.sweep().signum()].map(|axis| plane.place(axis, 0.0)),
            radius: [radius, end.length() - radius],
            turn: arc.sweep().abs(),
        };
        let mut whole = Self::measured(course, [0.0, 1.0], (DVec3::ZERO, 1.0));
        let flat = whole.length;
        whole.length = flat.hypot(heights[1] - heights[0]);
        whole.level = flat / whole.length;
        whole.climb = plane.place(DVec2::ZERO, (heights[1] - heights[0]) / whole.length);
        whole
    }

    /// Point and derivatives at the arc length `s` [mm] from the start; a step of `s` is one of the
    /// curve to 1e-9 of it.
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        let s = s + self.from;
        let flat = s * self.level;
        let [point, first, second, third] = self.course.derivatives(self.parameter(flat));
        let mut frame = Frame::of_derivatives(point, [first, second, third]);
        let square = self.level * self.level;
        frame.point += self.climb * s;
        frame.tangent = frame.tangent * self.level + self.climb;
        frame.curvature *= square;
        frame.sharpness *= square * self.level;
        frame
    }

    /// The part from one arc length to another [mm].
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        Self { from: self.from + from, length: to - from, ..self.clone() }
    }

    /// The parameter at a length in the plane [mm].
    fn parameter(&self, s: f64) -> f64 {
        let next = self.marks.partition_point(|mark| mark.s <= s);
        let next = next.clamp(1, self.marks.len() - 1);
        let from = &self.marks[next - 1];
        let t = inverse(from, &self.marks[next], s)[0];
        // Always one step: where their number changed, what they leave would jump.
        let reached = from.s + gauss_legendre(from.t[0], t, &mut |t| self.course.speed(t));
        t + (s - reached) / self.course.speed(t)
    }

    /// Measures a course over a range of its parameter; `climb` and `level` as in the fields.
    fn measured(course: Course, [start, end]: [f64; 2], (climb, level): (DVec3, f64)) -> Self {
        let size = gauss_legendre(start, end, &mut |t| course.speed(t));
        let mut marks = vec![course.mark(start, 0.0)];
        let mut last = marks[0];
        let mut step = 0.25 * (end - start);
        let mut at = start;
        while at < end {
            let to = if at + 1.01 * step >= end { end } else { at + step };
            let middle = f64::midpoint(at, to);
            let whole = gauss_legendre(at, to, &mut |t| course.speed(t));
            let halves = gauss_legendre(at, middle, &mut |t| course.speed(t))
                + gauss_legendre(middle, to, &mut |t| course.speed(t));
            let next = course.mark(to, last.s + halves);
            // Below the least step the parameter has too few digits left to be told apart; a curve
            // that none of them satisfies is passed in a thousand more.
            let least = if marks.len() < MANY_MARKS { 1e-9 } else { 1e-3 };
            let good = step < least
                || ((whole - halves).abs() <= 1e-13 * size && course.is_even(&last, &next));
            if good {
                marks.push(next);
                last = next;
                at = to;
                step *= 1.5;
            } else {
                step *= 0.6;
            }
        }
        let length = last.s / level;
        Self { course, climb, level, marks, from: 0.0, length }
    }
}

impl Course {
    /// Point and derivatives by the parameter, up to the third.
    fn derivatives(&self, t: f64) -> [DVec3; 4] {
        match self {
            Self::Polynomial(coefficients) => {
                // Horner's rule carried on for the derivatives, which come out over 1, 2 and 6.
                let mut d = [DVec3::ZERO; 4];
                for c in coefficients.iter().rev() {
                    d[3] = d[3] * t + d[2];
                    d[2] = d[2] * t + d[1];
                    d[1] = d[1] * t + d[0];
                    d[0] = d[0] * t + *c;
                }
                [d[0], d[1], d[2] * 2.0, d[3] * 6.0]
            }
            Self::Spiral { center, axes, radius, turn } => {
                let (sin, cos) = sin_cos(t * turn);
                let out = axes[0] * cos + axes[1] * sin;
                let on = axes[1] * cos - axes[0] * sin;
                let r = radius[0] + radius[1] * t;
                let grows = radius[1];
                // out' = turn on, on' = −turn out.
                [
                    *center + out * r,
                    out * grows + on * (r * turn),
                    on * (2.0 * grows * turn) - out * (r * turn * turn),
                    (out * (3.0 * grows) + on * (r * turn)) * (-turn * turn),
                ]
            }
        }
    }

    /// Parametric speed [mm].
    fn speed(&self, t: f64) -> f64 {
        match self {
            Self::Polynomial(coefficients) => {
                let mut sum = DVec3::ZERO;
                for (power, c) in coefficients.iter().enumerate().skip(1).rev() {
                    sum = sum * t + *c * power as f64;
                }
                sum.length()
            }
            Self::Spiral { .. } => self.derivatives(t)[1].length(),
        }
    }

    /// The place at a parameter whose length is known; `dt/ds = 1/σ`, `d²t/ds² = −σ'/σ³`.
    fn mark(&self, t: f64, s: f64) -> Mark {
        let [_, first, second, _] = self.derivatives(t);
        let square = first.length_squared();
        let speed = square.sqrt();
        Mark { s, t: [t, 1.0 / speed, -first.dot(second) / (square * square)] }
    }

    /// Whether the feed between two places is even: the error of a polynomial of degree 5 that
    /// matches both ends twice grows like `x³ (1 − x)³`, fastest at `x = (1 ± 1/√5)/2`.
    fn is_even(&self, from: &Mark, to: &Mark) -> bool {
        let mut even = true;
        for x in [0.276, 0.724] {
            let [t, rate] = inverse(from, to, from.s + x * (to.s - from.s));
            even &= (rate * self.speed(t) - 1.0).abs() <= FEED_ERROR;
        }
        even
    }
}

/// The parameter, and its derivative, at a length between two places: the polynomial of degree 5
/// that matches both.
fn inverse(from: &Mark, to: &Mark, s: f64) -> [f64; 2] {
    let span = to.s - from.s;
    let x = (s - from.s) / span;
    let [first, second] = [from.t[1] * span, 0.5 * from.t[2] * span * span];
    let gap = to.t[0] - from.t[0] - first - second;
    let slope = to.t[1] * span - first - 2.0 * second;
    let bend = to.t[2] * span * span - 2.0 * second;
    let c3 = 10.0 * gap - 4.0 * slope + 0.5 * bend;
    let c4 = -15.0 * gap + 7.0 * slope - bend;
    let c5 = 6.0 * gap - 3.0 * slope + 0.5 * bend;
    let t = from.t[0] + x * (first + x * (second + x * (c3 + x * (c4 + x * c5))));
    let rate = first + x * (2.0 * second + x * (3.0 * c3 + x * (4.0 * c4 + x * 5.0 * c5)));
    [t, rate / span]
}
