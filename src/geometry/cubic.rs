//! A cubic Bézier curve.

use glam::DVec2;

use super::{Bounds, Nearest, bernstein, cross, length::arc_length, relative_to};

/// A cubic Bézier curve: one span of a spline, or one piece of its offset.
///
/// Any four finite points are a cubic; it may have a cusp or stand still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cubic {
    /// The four control points [mm]; the first and the last lie on the curve.
    pub points: [DVec2; 4],
}

impl Cubic {
    /// The cubic with the given control points [mm].
    #[must_use]
    pub fn new(p0: DVec2, p1: DVec2, p2: DVec2, p3: DVec2) -> Self {
        Self { points: [p0, p1, p2, p3] }
    }

    /// The cubic from `start` to `end` with the given derivatives there [mm].
    #[must_use]
    pub fn hermite(
        start: DVec2,
        start_derivative: DVec2,
        end: DVec2,
        end_derivative: DVec2,
    ) -> Self {
        Self::new(start, start + start_derivative / 3.0, end - end_derivative / 3.0, end)
    }

    /// Where the curve begins [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.points[0]
    }

    /// Where the curve ends [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        self.points[3]
    }

    /// The point at `t`; exact at both ends.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        let [p0, p1, p2, p3] = self.points;
        let s = 1.0 - t;
        p0 * (s * s * s) + p1 * (3.0 * s * s * t) + p2 * (3.0 * s * t * t) + p3 * (t * t * t)
    }

    /// First derivative by `t`.
    #[must_use]
    pub fn derivative(&self, t: f64) -> DVec2 {
        let [d0, d1, d2] = self.hodograph();
        let s = 1.0 - t;
        d0 * (s * s) + d1 * (2.0 * s * t) + d2 * (t * t)
    }

    /// Second derivative by `t`.
    #[must_use]
    pub fn second_derivative(&self, t: f64) -> DVec2 {
        let [d0, d1, d2] = self.hodograph();
        ((d1 - d0) * (1.0 - t) + (d2 - d1) * t) * 2.0
    }

    /// Control vectors of the first derivative, a quadratic Bézier curve.
    #[must_use]
    pub fn hodograph(&self) -> [DVec2; 3] {
        let [p0, p1, p2, p3] = self.points;
        [(p1 - p0) * 3.0, (p2 - p1) * 3.0, (p3 - p2) * 3.0]
    }

    /// Unit tangent at `t`, in the direction of motion.
    ///
    /// Where the derivative vanishes it is the direction in which the curve goes on, or comes from
    /// at `t = 1`; +x for a cubic that stands still.
    #[must_use]
    pub fn tangent(&self, t: f64) -> DVec2 {
        let first = self.derivative(t);
        // 1e-9 of the control polygon: below it the direction is made of rounding.
        let least = 1e-9 * self.hull_length();
        if first.length() > least {
            return first.normalize();
        }
        let [p0, p1, p2, p3] = self.points;
        let ahead = if t < 1.0 {
            let rest = [p1, p2, p3];
            let here = self.point(t);
            if t == 0.0 {
                rest.into_iter().find(|p| p.distance(here) > least).map(|p| p - here)
            } else {
                Some(self.second_derivative(t))
            }
        } else {
            [p2, p1, p0].into_iter().find(|p| p.distance(p3) > least).map(|p| p3 - p)
        };
        ahead.and_then(DVec2::try_normalize).unwrap_or(DVec2::X)
    }

    /// Curvature at `t` [1/mm], positive to the left; zero where the derivative vanishes.
    #[must_use]
    pub fn curvature(&self, t: f64) -> f64 {
        let first = self.derivative(t);
        let speed = first.length();
        if speed == 0.0 { 0.0 } else { cross(first, self.second_derivative(t)) / speed.powi(3) }
    }

    /// Length of the control polygon: an upper bound of the arc length [mm].
    #[must_use]
    pub fn hull_length(&self) -> f64 {
        let [p0, p1, p2, p3] = self.points;
        p0.distance(p1) + p1.distance(p2) + p2.distance(p3)
    }

    /// Arc length [mm], to about 1e-12 of it.
    #[must_use]
    pub fn length(&self) -> f64 {
        arc_length(self)
    }

    /// The same curve run the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [p0, p1, p2, p3] = self.points;
        Self::new(p3, p2, p1, p0)
    }

    /// Both parts of the curve cut at `t` (de Casteljau).
    #[must_use]
    pub fn split(&self, t: f64) -> (Self, Self) {
        let [p0, p1, p2, p3] = self.points;
        let (a, b, c) = (p0.lerp(p1, t), p1.lerp(p2, t), p2.lerp(p3, t));
        let (d, e) = (a.lerp(b, t), b.lerp(c, t));
        let middle = d.lerp(e, t);
        (Self::new(p0, a, d, middle), Self::new(middle, e, c, p3))
    }

    /// The part of the curve from `from` to `to`; run backwards where `to < from`.
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        if to < from {
            return self.part(to, from).reversed();
        }
        let end = if to >= 1.0 { *self } else { self.split(to).0 };
        if from <= 0.0 || to == 0.0 { end } else { end.split((from / to).min(1.0)).1 }
    }

    /// The smallest box around the curve.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::of([self.start(), self.end()]);
        let [d0, d1, d2] = self.hodograph();
        for t in bernstein::roots(&[d0.x, d1.x, d2.x]) {
            bounds.add(self.point(t));
        }
        for t in bernstein::roots(&[d0.y, d1.y, d2.y]) {
            bounds.add(self.point(t));
        }
        bounds
    }

    /// The box around the control points: quicker than [`bounds`](Self::bounds), not smaller.
    #[must_use]
    pub fn hull_bounds(&self) -> Bounds {
        let [start, p1, p2, p3] = self.points;
        let mut bounds = Bounds { min: start, max: start };
        bounds.add(p1);
        bounds.add(p2);
        bounds.add(p3);
        bounds
    }

    /// The point of the curve nearest to `point`: the best root of `(C − P) · C' = 0`, a
    /// polynomial of degree 5, or an end.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> Nearest {
        let c = relative_to(point, self.points);
        let d = self.hodograph();
        // Product of Bernstein forms of degree 3 and 2: weights C(3,i) C(2,j) / C(5,i+j).
        let mut product = [0.0; 6];
        for (i, (ci, wi)) in c.iter().zip([1.0, 3.0, 3.0, 1.0]).enumerate() {
            for (j, (dj, wj)) in d.iter().zip([1.0, 2.0, 1.0]).enumerate() {
                product[i + j] += wi * wj * ci.dot(*dj);
            }
        }
        for (value, binomial) in product.iter_mut().zip([1.0, 5.0, 10.0, 10.0, 5.0, 1.0]) {
            *value /= binomial;
        }
        let ends =
            Nearest::new(0.0, self.start(), point).or_nearer(Nearest::new(1.0, self.end(), point));
        bernstein::roots(&product)
            .into_iter()
            .map(|t| Nearest::new(t, self.point(t), point))
            .fold(ends, Nearest::or_nearer)
    }

    /// Moves the start by `by`, keeping its derivative there [mm].
    #[must_use]
    pub fn with_start_moved(mut self, by: DVec2) -> Self {
        self.points[0] += by;
        self.points[1] += by;
        self
    }
}
