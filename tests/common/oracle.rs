//! Curves evaluated in the plainest way, to judge those of the crate by.

use glam::DVec2;

use g41::contour::MoveCurve;
use g41::geometry::{Arc, Cubic, Curve, Involute, Line};

/// A curve of one piece.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Plain {
    Line(DVec2, DVec2),
    Arc {
        center: DVec2,
        radius: f64,
        from: f64,
        sweep: f64,
    },
    Bezier([DVec2; 4]),
    /// The end of a thread that comes off a circle, by so many radians from and to.
    Involute {
        center: DVec2,
        radius: f64,
        /// The angle at which the thread begins to come off.
        first: f64,
        counterclockwise: bool,
        from: f64,
        to: f64,
    },
    /// The equidistant of a cubic, so far to its left.
    Parallel([DVec2; 4], f64),
}

impl Plain {
    pub(crate) fn of_line(line: &Line) -> Self {
        Self::Line(line.start(), line.end())
    }

    pub(crate) fn of_arc(arc: &Arc) -> Self {
        let from = (arc.start() - arc.center()).to_angle();
        Self::Arc { center: arc.center(), radius: arc.radius(), from, sweep: arc.sweep() }
    }

    pub(crate) fn of_cubic(cubic: &Cubic) -> Self {
        Self::Bezier(cubic.points)
    }

    /// By its circle and its ends alone.
    pub(crate) fn of_involute(involute: &Involute) -> Self {
        let (center, radius) = (involute.center(), involute.base_radius());
        let [start, end] = [involute.start(), involute.end()].map(|point| point - center);
        let thread = |point: DVec2| (point.length_squared() - radius * radius).max(0.0).sqrt();
        let [from, to] = [start, end].map(|point| thread(point) / radius);
        let counterclockwise = (to > from) != involute.is_clockwise();
        let sense = if counterclockwise { 1.0 } else { -1.0 };
        // Seen from the centre the end of the thread lags behind where it leaves the circle.
        let first = start.to_angle() + sense * (from.atan() - from);
        Self::Involute { center, radius, first, counterclockwise, from, to }
    }

    /// The pieces of a programmed curve.
    pub(crate) fn of_curve(curve: &Curve) -> Vec<Self> {
        match curve {
            Curve::Line(line) => vec![Self::of_line(line)],
            Curve::Arc(arc) => vec![Self::of_arc(arc)],
            Curve::Spline(spline) => spline.pieces().iter().map(Self::of_cubic).collect(),
            Curve::Involute(involute) => vec![Self::of_involute(involute)],
        }
    }

    /// The curve of a move in the plane; `None` for one along z.
    pub(crate) fn of_move(curve: &MoveCurve) -> Option<Self> {
        match curve {
            MoveCurve::Line(line) => Some(Self::of_line(line)),
            MoveCurve::Arc(arc) => Some(Self::of_arc(arc)),
            MoveCurve::Cubic(cubic) => Some(Self::of_cubic(cubic)),
            MoveCurve::Involute(involute) => Some(Self::of_involute(involute)),
            MoveCurve::Vertical(_) => None,
        }
    }

    /// The samples that show all bends of an ordinary curve of this kind.
    pub(crate) fn samples(&self) -> usize {
        match self {
            Self::Line(..) => 16,
            Self::Arc { .. } | Self::Bezier(_) => 96,
            Self::Parallel(..) | Self::Involute { .. } => 192,
        }
    }

    pub(crate) fn point(&self, t: f64) -> DVec2 {
        match *self {
            Self::Line(a, b) => a + (b - a) * t,
            Self::Arc { center, radius, from, sweep } => {
                center + DVec2::from_angle(from + sweep * t) * radius
            }
            Self::Bezier([a, b, c, d]) => {
                let (e, f, g) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
                e.lerp(f, t).lerp(f.lerp(g, t), t)
            }
            Self::Involute { center, radius, first, counterclockwise, from, to } => {
                let roll = from + (to - from) * t;
                let sense = if counterclockwise { 1.0 } else { -1.0 };
                // Where the thread leaves the circle, and back along it.
                let leaves = DVec2::from_angle(first + sense * roll);
                center + leaves * radius - leaves.perp() * (sense * radius * roll)
            }
            Self::Parallel(cubic, offset) => {
                let curve = Self::Bezier(cubic);
                curve.point(t) + curve.derivative(t).normalize_or_zero().perp() * offset
            }
        }
    }

    /// First derivative by `t`; of an equidistant that of its cubic, which has its direction.
    pub(crate) fn derivative(&self, t: f64) -> DVec2 {
        match *self {
            Self::Line(a, b) => b - a,
            Self::Arc { radius, from, sweep, .. } => {
                DVec2::from_angle(from + sweep * t).perp() * radius * sweep
            }
            Self::Involute { radius, first, counterclockwise, from, to, .. } => {
                let roll = from + (to - from) * t;
                let sense = if counterclockwise { 1.0 } else { -1.0 };
                DVec2::from_angle(first + sense * roll) * (radius * roll * (to - from))
            }
            Self::Bezier([a, b, c, d]) | Self::Parallel([a, b, c, d], _) => {
                let (e, f, g) = (b - a, c - b, d - c);
                e.lerp(f, t).lerp(f.lerp(g, t), t) * 3.0
            }
        }
    }

    /// Points at `count` + 1 even parameters.
    pub(crate) fn sampled(&self, count: usize) -> Vec<DVec2> {
        (0..=count).map(|i| self.point(i as f64 / count as f64)).collect()
    }

    /// Distance from `point` by dense sampling and golden sections around every sample that could
    /// be nearest.
    pub(crate) fn distance(&self, point: DVec2, count: usize) -> f64 {
        let at = |t: f64| self.point(t).distance(point);
        let n = count as f64;
        let sampled: Vec<f64> = (0..=count).map(|i| at(i as f64 / n)).collect();
        let mut best = f64::INFINITY;
        for i in 0..=count {
            let before = if i > 0 { sampled[i - 1] } else { f64::INFINITY };
            let after = if i < count { sampled[i + 1] } else { f64::INFINITY };
            if sampled[i] <= before && sampled[i] <= after {
                let low = i.saturating_sub(1) as f64 / n;
                let high = (i + 1).min(count) as f64 / n;
                best = best.min(sampled[i]).min(golden_minimum(at, low, high));
            }
        }
        best
    }
}

/// Distances from a set of curves, by dense sampling and golden sections.
pub(crate) struct Field {
    curves: Vec<Plain>,
    blocks: Vec<Block>,
}

/// Samples in a block, its first counting for the block before.
const SIZE: usize = 16;

/// Successive samples of one curve and a circle around them.
struct Block {
    curve: usize,
    from: f64,
    step: f64,
    points: Vec<DVec2>,
    center: DVec2,
    radius: f64,
    /// Largest distance of successive samples.
    gap: f64,
}

impl Field {
    /// Of `curves`, each with as many samples as show all its bends.
    pub(crate) fn new(curves: impl IntoIterator<Item = (Plain, usize)>) -> Self {
        let mut field = Self { curves: Vec::new(), blocks: Vec::new() };
        for (index, (curve, samples)) in curves.into_iter().enumerate() {
            let count = samples.div_ceil(SIZE);
            let step = 1.0 / (count * SIZE) as f64;
            for block in 0..count {
                let from = (block * SIZE) as f64 * step;
                let points: Vec<DVec2> =
                    (0..=SIZE).map(|i| curve.point(from + i as f64 * step)).collect();
                let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
                let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
                let gap = points.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
                let center = low.midpoint(high);
                let radius = center.distance(high) + gap;
                field.blocks.push(Block { curve: index, from, step, points, center, radius, gap });
            }
            field.curves.push(curve);
        }
        field
    }

    /// Distance of `point` from the nearest point of all curves.
    pub(crate) fn distance(&self, point: DVec2) -> f64 {
        let mut sampled = f64::INFINITY;
        for block in &self.blocks {
            sampled = sampled.min(block.center.distance(point) + block.radius);
        }
        let mut candidates = Vec::new();
        for block in &self.blocks {
            if block.center.distance(point) - block.radius > sampled {
                continue;
            }
            let mut distances = [f64::INFINITY; SIZE + 1];
            for (distance, sample) in distances.iter_mut().zip(&block.points) {
                *distance = sample.distance(point);
            }
            for (i, &here) in distances.iter().enumerate() {
                let before = if i > 0 { distances[i - 1] } else { f64::INFINITY };
                let after = distances.get(i + 1).copied().unwrap_or(f64::INFINITY);
                if here <= before && here <= after && here <= sampled + block.gap {
                    sampled = sampled.min(here);
                    candidates.push((here, block, i));
                }
            }
        }
        let mut best = sampled;
        for (here, block, i) in candidates {
            if here <= sampled + block.gap {
                if let Plain::Line(a, b) = self.curves[block.curve] {
                    let along = (point - a).dot(b - a) / (b - a).length_squared();
                    best = best.min(point.distance(a.lerp(b, along.clamp(0.0, 1.0))));
                    continue;
                }
                let t = block.from + i as f64 * block.step;
                let (low, high) = ((t - block.step).max(0.0), (t + block.step).min(1.0));
                let at = |t: f64| self.curves[block.curve].point(t).distance(point);
                best = best.min(golden_minimum(at, low, high));
            }
        }
        best
    }
}

/// The least value of a function with one minimum in `[low, high]`.
pub(crate) fn golden_minimum(f: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (low, high);
    let (mut c, mut d) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut at_c, mut at_d) = (f(c), f(d));
    let mut best = f(low).min(f(high));
    for _ in 0..45 {
        best = best.min(at_c).min(at_d);
        if at_c < at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - ratio * (b - a);
            at_c = f(c);
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + ratio * (b - a);
            at_d = f(d);
        }
    }
    best.min(at_c).min(at_d)
}
