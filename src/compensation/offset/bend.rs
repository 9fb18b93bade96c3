//! How deep a tool cuts in a bend that it does not fit into.
//!
//! Where `1 − δκ` is negative the offset runs backwards, between two cusps, and crosses itself
//! beside them: a swallowtail. The tool cuts too deep all along it, deepest somewhere on the tails.

use std::ops::Range;

use super::Bend;
use crate::geometry::{Cubic, Spline, least, perp};

/// A stretch of a span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub(super) span: usize,
    pub(super) from: f64,
    pub(super) to: f64,
}

/// Places of the tool examined on each span.
const SAMPLES: usize = 6;

/// Depth, as a part of the radius, below which a place counts as clear: rounding of the distance.
const CLEAR: f64 = 1e-9;

/// Steps of the search for the deepest place between three samples: each keeps 0.618 of it.
const SEARCH_STEPS: usize = 12;

/// Depth and place of the gouge of every bend.
pub(super) fn bends(spline: &Spline, offset: f64, tight: &[Stretch]) -> Vec<Bend> {
    // Stretches that continue over a type point are one bend.
    let mut found: Vec<Bend> = tight
        .chunk_by(|a, b| {
            (a.span == b.span && a.to == b.from)
                || (a.span + 1 == b.span && a.to == 1.0 && b.from == 0.0)
        })
        .map(|stretches| bend(spline, offset, stretches))
        .collect();
    // So are those before and behind the seam of a closed spline: the deeper of both places tells.
    let last = spline.pieces().len() - 1;
    if let ([first, .., end], true) = (tight, spline.is_periodic() && found.len() > 1)
        && (first.span, first.from, end.span, end.to) == (0, 0.0, last, 1.0)
        && let Some(other) = found.pop()
    {
        let radius = found[0].radius.min(other.radius);
        let deeper = if other.depth > found[0].depth { other } else { found[0] };
        found[0] = Bend { radius, ..deeper };
    }
    found
}

fn bend(spline: &Spline, offset: f64, tight: &[Stretch]) -> Bend {
    let core = tight[0].span..tight[tight.len() - 1].span + 1;
    let around = Around { pieces: spline.pieces(), offset, core };
    let window = around.window();
    let at = spline.pieces()[tight[0].span].point(tight[0].from);
    let mut deepest = Cut { depth: 0.0, at, center: at };
    let mut place = None;
    for span in window.clone() {
        for k in 0..SAMPLES {
            let t = (k as f64 + 0.5) / SAMPLES as f64;
            if let Some(cut) = around.cut(&window, span, t, deepest.depth) {
                deepest = cut;
                place = Some((span, t));
            }
        }
    }
    if let Some((span, t)) = place {
        around.refine(&window, span, t, &mut deepest);
    }
    let Cut { depth, at, center } = deepest;
    Bend { at, center, depth, radius: sharpest(spline, tight) }
}

/// A place of the contour, how deep it is cut, and the centre of the tool that does it [mm].
#[derive(Debug, Clone, Copy)]
struct Cut {
    depth: f64,
    at: glam::DVec2,
    center: glam::DVec2,
}

/// The spans of a spline around one bend, and the tool beside them.
struct Around<'a> {
    pieces: &'a [Cubic],
    offset: f64,
    /// The spans that bend too tightly.
    core: Range<usize>,
}

impl Around<'_> {
    /// The spans that the tool cuts, or cuts from, in this bend: grown on both sides until the tool
    /// beside the last ones is clear, and by half as much again.
    fn window(&self) -> Range<usize> {
        let (core, count) = (&self.core, self.pieces.len());
        let mut window = core.clone();
        loop {
            let grown = window.start.saturating_sub(1)..(window.end + 1).min(count);
            let cuts = [grown.start, grown.end - 1].into_iter().any(|span| {
                (0..SAMPLES).any(|k| {
                    let t = (k as f64 + 0.5) / SAMPLES as f64;
                    self.cut(&grown, span, t, self.offset.abs() * CLEAR).is_some()
                })
            });
            let beside = (core.start - grown.start).max(grown.end - core.end);
            if grown == window || (!cuts && beside > 2) {
                let more = beside / 2;
                return grown.start.saturating_sub(more)..(grown.end + more).min(count);
            }
            window = grown;
        }
    }

    /// The cut of the tool beside `t` of `span`, if it is deeper than `known` [mm].
    ///
    /// Beside the bend only what lies on it or beyond it counts: what the tool cuts on its own side
    /// belongs to another bend.
    fn cut(&self, window: &Range<usize>, span: usize, t: f64, known: f64) -> Option<Cut> {
        let facing = if span < self.core.start {
            self.core.start..window.end
        } else if span >= self.core.end {
            window.start..self.core.end
        } else {
            window.clone()
        };
        let r = self.offset.abs();
        let own = &self.pieces[span];
        let center = own.point(t) + perp(own.tangent(t)) * self.offset;
        let mut reach = r - known;
        let mut cut = None;
        for piece in &self.pieces[facing] {
            if piece.hull_bounds().distance(center) < reach {
                let nearest = piece.nearest(center);
                if nearest.distance < reach {
                    reach = nearest.distance;
                    cut = Some(Cut { depth: r - reach, at: nearest.point, center });
                }
            }
        }
        cut
    }

    /// Improves the deepest of some samples by golden-section search beside it.
    fn refine(&self, window: &Range<usize>, span: usize, t: f64, deepest: &mut Cut) {
        let step = 1.0 / SAMPLES as f64;
        let range = [(t - step).max(0.0), (t + step).min(1.0)];
        least(range, SEARCH_STEPS, 0.0, &mut |t| {
            let cut = self.cut(window, span, t, 0.0);
            if let Some(cut) = cut.filter(|cut| cut.depth > deepest.depth) {
                *deepest = cut;
            }
            -cut.map_or(0.0, |cut| cut.depth)
        });
    }
}

/// Smallest radius of curvature of some stretches [mm].
fn sharpest(spline: &Spline, tight: &[Stretch]) -> f64 {
    let mut curvature = 0.0_f64;
    for stretch in tight {
        for k in 0..=SAMPLES {
            let t = stretch.from + (stretch.to - stretch.from) * k as f64 / SAMPLES as f64;
            curvature = curvature.max(spline.pieces()[stretch.span].curvature(t).abs());
        }
    }
    1.0 / curvature
}
