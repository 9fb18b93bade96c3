//! Offsets and inside corners by brute force: dense samples of `C + σ r N`.

use g41::contour::Side;
use g41::geometry::Curve;
use glam::DVec2;

/// The true offset of a segment as dense samples.
#[derive(Debug, Clone)]
pub(crate) struct Offset {
    pub(crate) points: Vec<DVec2>,
    /// Largest σκ: the tool fits where it is less than 1/r.
    pub(crate) bend: f64,
}

impl Offset {
    pub(crate) fn new(curve: &Curve, side: Side, radius: f64, samples: usize) -> Self {
        let offset = side.sign() * radius;
        let mut points = Vec::with_capacity(samples + 1);
        let mut bend = f64::NEG_INFINITY;
        for i in 0..=samples {
            let t = i as f64 / samples as f64;
            points.push(curve.point(t) + curve.tangent(t).perp() * offset);
            bend = bend.max(side.sign() * curve.curvature(t));
        }
        Self { points, bend }
    }
}

/// A place where two sampled offsets cross.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crossing {
    /// Sample of the incoming offset, between two.
    pub(crate) incoming: f64,
    /// Sample of the outgoing offset.
    pub(crate) outgoing: f64,
    /// Sine of the angle in which they cross.
    pub(crate) sine: f64,
    pub(crate) point: DVec2,
}

/// Of the crossings that turn as an inside corner does, the last along the incoming offset.
pub(crate) fn inside_corner(incoming: &Offset, outgoing: &Offset, side: Side) -> Option<Crossing> {
    const BLOCK: usize = 16;
    let boxes = |points: &[DVec2]| -> Vec<(DVec2, DVec2)> {
        (0..(points.len() - 1).div_ceil(BLOCK))
            .map(|k| &points[k * BLOCK..((k + 1) * BLOCK + 1).min(points.len())])
            .map(|part| {
                let low = part.iter().copied().fold(DVec2::INFINITY, DVec2::min);
                (low, part.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max))
            })
            .collect()
    };
    let (a, b) = (&incoming.points, &outgoing.points);
    let (boxes_a, boxes_b) = (boxes(a), boxes(b));
    let mut last: Option<Crossing> = None;
    for (i, (low_a, high_a)) in boxes_a.iter().enumerate() {
        for (j, (low_b, high_b)) in boxes_b.iter().enumerate() {
            if !(low_a.cmple(*high_b).all() && low_b.cmple(*high_a).all()) {
                continue;
            }
            for k in i * BLOCK..((i + 1) * BLOCK).min(a.len() - 1) {
                for l in j * BLOCK..((j + 1) * BLOCK).min(b.len() - 1) {
                    let (va, vb, w) = (a[k + 1] - a[k], b[l + 1] - b[l], b[l] - a[k]);
                    let area = va.perp_dot(vb);
                    let (s, t) = (w.perp_dot(vb) / area, w.perp_dot(va) / area);
                    if !((0.0..1.0).contains(&s) && (0.0..1.0).contains(&t)) {
                        continue;
                    }
                    let sine = side.sign() * area / (va.length() * vb.length());
                    let at = k as f64 + s;
                    if sine > 0.0 && last.is_none_or(|c| at > c.incoming) {
                        let point = a[k] + va * s;
                        last = Some(Crossing { incoming: at, outgoing: l as f64 + t, sine, point });
                    }
                }
            }
        }
    }
    last
}
