//! Cubics that follow the offset of a cubic.
//!
//! Both share end points and end tangents with the offset. The plain one has its end derivatives
//! too, `O' = C' (1 − δκ)`: its error falls with the fourth power of its length. The collocated one
//! gives those lengths up to be at distance δ at two inner points, and its error falls with the
//! sixth power.

use glam::DVec2;

use super::proof::{Comparison, Speed, by_length};
use crate::geometry::{Cubic, cross, perp};

/// Inner points at which the collocated cubic is at distance δ: near the roots of the error's
/// leading term, by trial on waves and spirals.
const COLLOCATED: [f64; 2] = [0.3, 0.7];

/// Largest relative change of a handle in one step; a larger one means that the step is lost, as at
/// inflections, where the handles hardly move the curve sideways.
const LARGEST_STEP: f64 = 0.25;

/// Steps of Newton's method for the collocated piece.
const STEPS: usize = 3;

/// Speed at an end, as a share of the largest control vector of `C'`, up to which the curve counts
/// as standing still.
const STANDS_STILL: f64 = 1e-7;

/// A cubic to be offset, whole.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source {
    pub(super) cubic: Cubic,
    pub(super) speed: Speed,
    /// δ [mm], positive to the left.
    pub(super) offset: f64,
}

/// Point and derivative of the offset at a parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    pub(super) point: DVec2,
    derivative: DVec2,
}

impl End {
    /// The same, by a parameter of a half.
    pub(super) fn of_half(self) -> Self {
        Self { derivative: self.derivative * 0.5, ..self }
    }
}

/// The cubic with the given ends and end derivatives.
pub(super) fn hermite([start, end]: [End; 2]) -> Cubic {
    Cubic::hermite(start.point, start.derivative, end.point, end.derivative)
}

/// What the distance of a place near the offset is measured from: the frame of the curve at a
/// parameter.
#[derive(Debug, Clone, Copy)]
struct Site {
    t: f64,
    /// [mm]
    point: DVec2,
    tangent: DVec2,
    /// Half the curvature of the offset [1/mm].
    half_curvature: f64,
}

impl Source {
    pub(super) fn new(cubic: Cubic, offset: f64) -> Self {
        Self { cubic, speed: Speed::new(cubic.hodograph()), offset }
    }

    /// A piece that follows the offset, to be compared with it.
    pub(super) fn compared<'a>(&'a self, piece: &'a Cubic) -> Comparison<'a> {
        Comparison::new(&self.cubic, &self.speed, piece, self.offset)
    }

    /// A bound of the distance of the offset and a piece that is very short, or infinite [mm].
    pub(super) fn by_length(&self, piece: &Cubic) -> f64 {
        by_length(&self.cubic, &self.speed.hodograph, piece, self.offset)
    }

    /// A part of it.
    pub(super) fn part(&self, from: f64, to: f64) -> Self {
        let cubic = self.cubic.part(from, to);
        Self { cubic, speed: self.speed.part(from, to), offset: self.offset }
    }

    /// Both halves.
    pub(super) fn halves(&self) -> [Self; 2] {
        let (left, right) = self.cubic.split(0.5);
        let speeds = [self.speed.part(0.0, 0.5), self.speed.part(0.5, 1.0)];
        [
            Self { cubic: left, speed: speeds[0], offset: self.offset },
            Self { cubic: right, speed: speeds[1], offset: self.offset },
        ]
    }

    /// Point and derivative of the offset at `t`.
    pub(super) fn end(&self, t: f64) -> End {
        let [first, half_second] = self.speed.derivatives(t);
        let speed = first.length();
        let point = self.cubic.point(t);
        // Where the curve stands still its tangent is that of the way on; the offset stands too.
        if speed * speed <= STANDS_STILL * STANDS_STILL * self.speed.squared[1] {
            let inside = if t < 1.0 { t + 1e-6 } else { 1.0 - 1e-6 };
            let along = self.speed.derivatives(inside)[0].normalize_or(DVec2::X);
            return End { point: point + perp(along) * self.offset, derivative: DVec2::ZERO };
        }
        let per_speed = 1.0 / speed;
        let sideways = self.offset * per_speed;
        let bend = 2.0 * cross(first, half_second) * (per_speed * per_speed);
        End { point: point + perp(first) * sideways, derivative: first * (1.0 - sideways * bend) }
    }

    /// The cubic with the ends and end tangents of `hermite` that is at distance δ at the
    /// collocated points; `None` where there is none near it.
    pub(super) fn collocated(&self, hermite: &Cubic) -> Option<Cubic> {
        let [p0, p1, p2, p3] = hermite.points;
        let (mut a, mut b) = (p1 - p0, p3 - p2);
        let [near, far] = COLLOCATED;
        let sites = [self.site(near)?, self.site(far)?];
        // Newton's method in the factors of both handles.
        for _ in 0..STEPS {
            let piece = Cubic::new(p0, p0 + a, p3 - b, p3);
            let [first, second] = sites.map(|site| {
                let (s, t) = (1.0 - site.t, site.t);
                let (error, normal) = self.excess(&site, piece.point(t));
                [3.0 * t * s * s * a.dot(normal), -3.0 * t * t * s * b.dot(normal), error]
            });
            let per_determinant = 1.0 / (first[0] * second[1] - first[1] * second[0]);
            let change_a = (second[2] * first[1] - first[2] * second[1]) * per_determinant;
            let change_b = (first[2] * second[0] - second[2] * first[0]) * per_determinant;
            let step = change_a.abs().max(change_b.abs());
            if step.is_nan() || step > LARGEST_STEP {
                return None;
            }
            a *= 1.0 + change_a;
            b *= 1.0 + change_b;
        }
        Some(Cubic::new(p0, p0 + a, p3 - b, p3))
    }

    /// The frame at `t`; `None` where the offset turns back or stands still.
    fn site(&self, t: f64) -> Option<Site> {
        let [first, half_second] = self.speed.derivatives(t);
        let speed = first.length();
        let curvature = 2.0 * cross(first, half_second) / (speed * speed * speed);
        let room = 1.0 - self.offset * curvature;
        (room > 0.0).then(|| Site {
            t,
            point: self.cubic.point(t),
            tangent: first / speed,
            half_curvature: 0.5 * curvature / room,
        })
    }

    /// How much farther than δ a place near the offset is from the curve, signed to the left, and
    /// the normal at its foot: by the osculating circle of the offset.
    fn excess(&self, site: &Site, place: DVec2) -> (f64, DVec2) {
        let away = place - site.point;
        let slip = away.dot(site.tangent);
        let normal = perp(site.tangent);
        let turned = normal - site.tangent * (2.0 * site.half_curvature * slip);
        (away.dot(normal) - self.offset - site.half_curvature * slip * slip, turned)
    }
}
