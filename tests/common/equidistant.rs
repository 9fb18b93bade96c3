//! How far a path really is from the true equidistant of a chain of cubics, in twice the digits.

use glam::DVec2;

use super::double::Double;

/// A cubic by its control points [mm].
pub(crate) type Bezier = [DVec2; 4];

/// Dense feet tried on a span where the way from the last one fails.
const DENSE: u32 = 64;

/// Levels of dense feet, each of 16 times the density.
const LEVELS: usize = 4;

/// Spans tried before and after the last one, where a path may have turned back at a cusp.
const AROUND: usize = 1;

/// A chain of cubics and the signed distance of its equidistant, positive to the left [mm].
#[derive(Debug)]
pub(crate) struct Equidistant<'a> {
    pub(crate) spans: &'a [Bezier],
    pub(crate) offset: f64,
    pub(crate) closed: bool,
    /// Distance from which on a foot is looked for in another way too [mm]: near cusps, where it
    /// stands still and jumps, the way from the last one may lead to a wrong one.
    pub(crate) doubt: f64,
}

/// A parameter of the chain: that of the foot of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Foot {
    pub(crate) span: usize,
    pub(crate) t: f64,
}

pub(crate) fn point([a, b, c, d]: &Bezier, t: f64) -> DVec2 {
    let (e, f, g) = (a.lerp(*b, t), b.lerp(*c, t), c.lerp(*d, t));
    e.lerp(f, t).lerp(f.lerp(g, t), t)
}

fn derivative([a, b, c, d]: &Bezier, t: f64) -> DVec2 {
    let (e, f, g) = (*b - *a, *c - *b, *d - *c);
    e.lerp(f, t).lerp(f.lerp(g, t), t) * 3.0
}

fn second_derivative([a, b, c, d]: &Bezier, t: f64) -> DVec2 {
    let (e, f, g) = (*b - *a, *c - *b, *d - *c);
    ((f - e) * (1.0 - t) + (g - f) * t) * 6.0
}

type Vector = [Double; 2];

fn zip(a: Vector, b: Vector, f: impl Fn(Double, Double) -> Double) -> Vector {
    [f(a[0], b[0]), f(a[1], b[1])]
}

fn mix(a: Vector, b: Vector, t: Double) -> Vector {
    zip(a, b, |a, b| a + (b - a) * t)
}

fn exact(p: DVec2) -> Vector {
    [p.x.into(), p.y.into()]
}

/// Point and a third of the derivative in twice the digits (de Casteljau).
fn evaluate(cubic: &Bezier, t: f64) -> (Vector, Vector) {
    let t = Double::from(t);
    let [a, b, c, d] = cubic.map(exact);
    let (e, f, g) = (mix(a, b, t), mix(b, c, t), mix(c, d, t));
    let (h, i) = (mix(e, f, t), mix(f, g, t));
    (mix(h, i, t), zip(i, h, |i, h| i - h))
}

impl Equidistant<'_> {
    /// Distance of the point at `u` of a piece from the equidistant's point over `foot` [mm].
    fn distance_at(&self, piece: &Bezier, u: f64, foot: Foot) -> f64 {
        let (center, _) = evaluate(piece, u);
        let (point, ahead) = evaluate(&self.spans[foot.span], foot.t);
        let [x, y] = zip(center, point, |a, b| a - b);
        let [dx, dy] = ahead;
        let speed = (dx * dx + dy * dy).sqrt();
        let across = (dx * y - dy * x) / speed - Double::from(self.offset);
        let along = (dx * x + dy * y) / speed;
        (across * across + along * along).sqrt().value()
    }

    /// The foot of `center`, followed from that of a point nearby by Newton's method for
    /// `(P − C) · C' = 0`, over joints of the chain.
    fn follow(&self, center: DVec2, mut foot: Foot) -> Option<Foot> {
        let last = self.spans.len() - 1;
        for _ in 0..12 {
            let span = &self.spans[foot.span];
            let (first, away) = (derivative(span, foot.t), center - point(span, foot.t));
            let slope = away.dot(second_derivative(span, foot.t)) - first.length_squared();
            let step = -away.dot(first) / slope;
            if !step.is_finite() {
                return None;
            }
            foot.t += step.clamp(-0.5, 0.5);
            if step.abs() < 1e-12 {
                foot.t = foot.t.clamp(0.0, 1.0);
                return Some(foot);
            }
            if foot.t > 1.0 + 1e-12 {
                if foot.span < last || self.closed {
                    foot = Foot {
                        span: if foot.span < last { foot.span + 1 } else { 0 },
                        t: foot.t - 1.0,
                    };
                } else {
                    foot.t = 1.0;
                }
            } else if foot.t < -1e-12 {
                if foot.span > 0 || self.closed {
                    foot = Foot {
                        span: if foot.span > 0 { foot.span - 1 } else { last },
                        t: foot.t + 1.0,
                    };
                } else {
                    foot.t = 0.0;
                }
            }
        }
        None
    }

    fn place(&self, foot: Foot) -> DVec2 {
        let span = &self.spans[foot.span];
        point(span, foot.t) + derivative(span, foot.t).normalize_or_zero().perp() * self.offset
    }

    /// The foot on `span` over which the equidistant is nearest to `center`, by dense sampling and
    /// golden sections.
    fn dense(&self, center: DVec2, span: usize) -> (f64, Foot) {
        let off = |t: f64| self.place(Foot { span, t }).distance(center);
        let (mut best, mut at) = (f64::INFINITY, 0.0);
        let (mut from, mut to) = (0.0, 1.0);
        // Beside a cusp two branches run close together: each level looks at both more finely.
        for _ in 0..LEVELS {
            let step = (to - from) / f64::from(DENSE);
            let samples: Vec<f64> = (0..=DENSE).map(|k| off(from + f64::from(k) * step)).collect();
            let middle = at;
            for (k, &here) in (0..).zip(&samples) {
                let beside = |k: usize| samples.get(k).copied().unwrap_or(f64::INFINITY);
                if here > beside(k + 1) || k > 0 && here > beside(k - 1) {
                    continue;
                }
                let t = from + k as f64 * step;
                let (mut low, mut high) = ((t - step).max(0.0), (t + step).min(1.0));
                for _ in 0..50 {
                    let third = (high - low) / 3.0;
                    if off(low + third) < off(high - third) {
                        high -= third;
                    } else {
                        low += third;
                    }
                }
                for t in [t, 0.5 * (low + high)] {
                    if off(t) < best {
                        (best, at) = (off(t), t);
                    }
                }
            }
            if best < self.doubt || at == middle {
                break;
            }
            (from, to) = ((at - 2.0 * step).max(0.0), (at + 2.0 * step).min(1.0));
        }
        (best, Foot { span, t: at })
    }

    /// The foot of a path's first point: the span over which the equidistant is nearest, from
    /// `from` on.
    pub(crate) fn find(&self, center: DVec2, from: usize, enough: f64) -> Foot {
        let count = self.spans.len();
        let (mut best, mut found) = (f64::INFINITY, Foot { span: from % count, t: 0.0 });
        for k in 0..count {
            let span = (from + k) % count;
            // The equidistant of a span is no farther from its ends than the tool and its length.
            let [a, b, c, d] = self.spans[span];
            let long = a.distance(b) + b.distance(c) + c.distance(d);
            if (a.distance(center) - self.offset.abs()).abs() > long + enough {
                continue;
            }
            let (off, foot) = self.dense(center, span);
            if off < best {
                (best, found) = (off, foot);
            }
            if best < enough {
                break;
            }
        }
        found
    }

    /// Largest distance [mm] of `samples` + 1 points of a piece from the equidistant; `foot` is that
    /// of a point before it, and becomes that of its end.
    pub(crate) fn error(&self, piece: &Bezier, samples: usize, foot: &mut Foot) -> f64 {
        let mut worst: f64 = 0.0;
        for k in 0..=samples {
            let u = k as f64 / samples as f64;
            let center = point(piece, u);
            let followed = self.follow(center, *foot);
            let mut off = followed.map_or(f64::INFINITY, |foot| self.distance_at(piece, u, foot));
            let mut next = followed.unwrap_or(*foot);
            if off > self.doubt {
                let count = self.spans.len();
                for k in 0..=2 * AROUND {
                    let (_, tried) = self.dense(center, (foot.span + count - AROUND + k) % count);
                    let distance = self.distance_at(piece, u, tried);
                    if distance < off {
                        (off, next) = (distance, tried);
                    }
                }
            }
            *foot = next;
            worst = worst.max(off);
        }
        worst
    }
}
