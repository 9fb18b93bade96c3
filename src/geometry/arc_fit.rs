//! Arcs and lines within a tolerance of a chain of cubics, for controllers without splines.
//!
//! The chain is cut greedily: each step takes the longest stretch that one line or one arc between
//! its ends can follow, found by doubling and then halving the stretch. Where the curvature changes
//! evenly such an arc crosses the curve in its middle, and arcs of one tolerance meet nearly without
//! a kink: each leaves the curve by as much as the next comes back. An arc of length l deviates by
//! κ' l³/125, one of a biarc, which keeps the tangents at its ends, by κ' l³/41: a biarc takes 1.46
//! times as many. Where the chain has a kink or a cusp a stretch ends.

use glam::DVec2;

use super::arc_proof::{distance_off, follows};
use super::{Arc, Cubic, Line, perp, turn};

/// An arc, or a line where an arc would be too flat to tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ArcOrLine {
    /// A circular arc of at most half a circle.
    Arc(Arc),
    /// A straight line.
    Line(Line),
}

impl ArcOrLine {
    /// Where it ends [mm].
    fn end(&self) -> DVec2 {
        match self {
            Self::Arc(arc) => arc.end(),
            Self::Line(line) => line.end(),
        }
    }

    /// Its length [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Arc(arc) => arc.length(),
            Self::Line(line) => line.length(),
        }
    }
}

/// Turn between successive cubics from which on they count as a kink [rad]. Joints of C2 splines
/// and of their offsets stay far below, corners of contours far above.
const KINK: f64 = 1e-4;

/// Share of the tolerance for the distance from an arc, and for the length that may be turned back
/// as seen from its centre, where the arc may be run past: together `√(0.98² + 0.19²) < 1`.
const SHARES: [f64; 2] = [0.98, 0.19];

/// Points of a stretch that its arc is chosen by, and that refuse most pieces that are too far off
/// before a proof is tried; odd, so that one is in the middle.
const SAMPLES: usize = 9;

/// Steps to the arc that is least far off: each weighs the two points that are farthest off against
/// each other, and from the second on they are mostly the same.
const STEPS: usize = 3;

/// Cubics up to which a stretch is looked for by its samples alone, and proved once it is found: on
/// more there may be something between the samples.
const SAMPLED: f64 = 4.0;

/// Share of the tolerance that samples of such a stretch may be off: mostly it is then proved.
const LIKELY: f64 = 0.97;

/// Part of a stretch that is tried where it cannot be proved.
const SHORTER: f64 = 0.95;

/// Largest radius written as an arc [mm]; flatter ones are lines if the tolerance allows. Controls
/// compute centres in single precision, which is good to half a micrometre here.
const MAX_RADIUS: f64 = 1e4;

/// Least tolerance as a share of a cubic's length, so that their number stays below a few
/// thousand a cubic; it is 0.1 µm for a metre.
const LEAST_SHARE: f64 = 1e-7;

/// Arcs and lines from the start to the end of `cubics`, each within `tolerance` [mm] of them.
///
/// The cubics must follow each other; each piece starts exactly where the one before it ends, the
/// first at the start, the last ends at the end. The Hausdorff distance of each piece and its part of
/// the cubics is proved from Bernstein coefficients; only a cubic finer than 1e-7 of its length may
/// be farther off, by as much.
#[must_use]
pub fn fit_arcs(cubics: &[Cubic], tolerance: f64) -> Vec<ArcOrLine> {
    let mut pieces = Vec::new();
    let Some(first) = cubics.first() else { return pieces };
    let mut at = first.start();
    let mut from = 0;
    while from < cubics.len() {
        let smooth = (from + 1..cubics.len())
            .find(|&i| turn(cubics[i - 1].tangent(1.0), cubics[i].tangent(0.0)).abs() > KINK)
            .unwrap_or(cubics.len());
        at = fit_smooth(&cubics[from..smooth], at, tolerance, &mut pieces);
        from = smooth;
    }
    pieces
}

/// A stretch of the chain from `from` to `to`, counted in cubics: 2.25 is a quarter into the third.
#[derive(Clone, Copy)]
struct Stretch<'a> {
    cubics: &'a [Cubic],
    from: f64,
    to: f64,
}

impl Stretch<'_> {
    /// The point at `at`.
    fn point(&self, at: f64) -> DVec2 {
        let (cubic, t) = self.locate(at);
        cubic.point(t)
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 ≤ at ≤ cubics.len()"
    )]
    fn locate(&self, at: f64) -> (&Cubic, f64) {
        let index = (at.floor() as usize).min(self.cubics.len() - 1);
        let t = at - index as f64;
        (&self.cubics[index], t)
    }

    /// Points evenly between its ends, apart from those.
    fn samples(&self) -> [DVec2; SAMPLES] {
        std::array::from_fn(|k| {
            let share = (k as f64 + 1.0) / (SAMPLES as f64 + 1.0);
            self.point(self.from + (self.to - self.from) * share)
        })
    }

    /// Whether the stretch is proved to be within `tolerance` [mm] of the piece, and the piece of it:
    /// every part of a cubic follows the piece, and they do not go round it once more.
    fn follows(&self, piece: &ArcOrLine, tolerance: f64) -> bool {
        let (off, mut turning) = (SHARES[0] * tolerance, SHARES[1] * tolerance);
        let (mut at, mut length) = (self.from, 0.0);
        while at < self.to {
            let (cubic, t) = self.locate(at);
            let rest = self.to - at + t;
            let part = cubic.part(t, rest.min(1.0));
            if !follows(&part, piece, off, &mut turning) {
                return false;
            }
            length += part.hull_length();
            at = if rest <= 1.0 { self.to } else { at.floor() + 1.0 };
        }
        match piece {
            ArcOrLine::Arc(arc) => length < (arc.radius() - tolerance) * (arc.sweep().abs() + 6.0),
            ArcOrLine::Line(_) => true,
        }
    }
}

/// Fits a chain without kinks from `at`, and returns where the pieces end.
fn fit_smooth(
    cubics: &[Cubic],
    mut at: DVec2,
    tolerance: f64,
    pieces: &mut Vec<ArcOrLine>,
) -> DVec2 {
    let end = cubics.len() as f64;
    let mut from = 0.0;
    let mut step = 1.0;
    while from < end {
        let attempt = |to: f64, proved: bool| {
            let stretch = Stretch { cubics, from, to };
            let least = LEAST_SHARE * stretch.locate(from).0.hull_length();
            fit_stretch(&stretch, at, tolerance.max(least), proved || to - from > SAMPLED)
        };
        let mut good: Option<(f64, Fit)> = None;
        let mut bad = None;
        // Doubling while it works, halving until it does.
        loop {
            let to = (from + step).min(end);
            match attempt(to, false) {
                Some(fit) => {
                    good = Some((to, fit));
                    if to >= end || bad.is_some() {
                        break;
                    }
                    step *= 2.0;
                }
                None if good.is_some() => {
                    bad = Some(to);
                    break;
                }
                None => {
                    bad = Some(to);
                    step *= 0.5;
                    if step < LEAST_SHARE {
                        break;
                    }
                }
            }
        }
        // Between the last that works and the first that does not.
        if let (Some((mut low, _)), Some(mut high)) = (good, bad) {
            for _ in 0..6 {
                let middle = 0.5 * (low + high);
                if let Some(fit) = attempt(middle, false) {
                    low = middle;
                    good = Some((middle, fit));
                } else {
                    high = middle;
                }
            }
        }
        // A stretch that short is a line within the least tolerance, so something is good, unless
        // the cubic is not made of numbers.
        let (mut to, fit) = good.unwrap_or(((from + 1.0).min(end), Fit::Nothing));
        let mut fit = if matches!(fit, Fit::Nothing) { Some(fit) } else { attempt(to, true) };
        while fit.is_none() && to - from > LEAST_SHARE {
            to = from + SHORTER * (to - from);
            fit = attempt(to, true);
        }
        let fit = fit.unwrap_or(Fit::Nothing);
        step = (to - from).max(LEAST_SHARE);
        if let Fit::Piece(piece) = fit {
            at = piece.end();
            pieces.push(piece);
        }
        from = to;
    }
    // What was too short to be a line of its own.
    let last = cubics[cubics.len() - 1].end();
    if let Ok(rest) = Line::new(at, last) {
        pieces.push(ArcOrLine::Line(rest));
        at = last;
    }
    at
}

/// What a stretch becomes.
#[derive(Clone, Copy)]
enum Fit {
    Piece(ArcOrLine),
    /// It is too short to be a line.
    Nothing,
}

/// The line or the arc from `start` that follows the stretch, if one is near enough.
///
/// That it follows is proved, or else only likely by the samples.
fn fit_stretch(stretch: &Stretch, start: DVec2, tolerance: f64, proved: bool) -> Option<Fit> {
    let Ok(chord) = Line::new(start, stretch.point(stretch.to)) else {
        let whole = stretch.locate(stretch.from).0;
        let length = whole.hull_length() * (stretch.to - stretch.from);
        return (length < tolerance).then_some(Fit::Nothing);
    };
    let samples = stretch.samples();
    for piece in [Some(ArcOrLine::Line(chord)), arc_along(&chord, &samples)].into_iter().flatten() {
        let limit = if proved { tolerance } else { LIKELY * tolerance };
        if samples.iter().all(|&point| distance_off(&piece, point) <= limit)
            && (!proved || stretch.follows(&piece, tolerance))
        {
            return Some(Fit::Piece(piece));
        }
    }
    None
}

/// The arc over a chord whose largest distance from the points is least, to first order; `None`
/// where it would turn by half a circle or more, or is too flat to be one.
fn arc_along(chord: &Line, points: &[DVec2; SAMPLES]) -> Option<ArcOrLine> {
    let half = 0.5 * chord.length();
    let (along, middle) = (chord.tangent(), chord.start().midpoint(chord.end()));
    let up = perp(along);
    let local = |point: DVec2| DVec2::new((point - middle).dot(along), (point - middle).dot(up));
    // The bulge of the circle through both ends and the point (x, y) as seen from the middle of the
    // chord: with its centre at height c, x² + (y − c)² = half² + c², and the bulge is c ± radius.
    let DVec2 { x, y } = local(points[SAMPLES / 2]);
    if y == 0.0 {
        return None;
    }
    let center = (x * x + y * y - half * half) / (2.0 * y);
    let bulge = center + half.hypot(center).copysign(y);
    // How far the points are above that arc, and how far they come down to it as its bulge grows.
    let radius = half.hypot(center).copysign(y);
    let above = points.map(|point| {
        let DVec2 { x, y } = local(point);
        let share = (x / half).clamp(-1.0, 1.0);
        (x.hypot(y - center).copysign(radius) - radius, 1.0 - share * share)
    });
    // Until the highest and the lowest of them are as far off.
    let mut more = 0.0;
    for _ in 0..STEPS {
        let (mut high, mut low) = ((f64::NEG_INFINITY, 1.0), (f64::INFINITY, 1.0));
        for (above, share) in above {
            let off = above - more * share;
            if off > high.0 {
                high = (off, share);
            }
            if off < low.0 {
                low = (off, share);
            }
        }
        more += (high.0 + low.0) / (high.1 + low.1);
    }
    let bulge = bulge + more;
    let radius = (half * half + bulge * bulge) / (2.0 * bulge.abs());
    if bulge.abs() >= half || radius.is_nan() || radius > MAX_RADIUS {
        return None;
    }
    let center = middle + up * (bulge - radius.copysign(bulge));
    let arc = Arc::from_center(chord.start(), chord.end(), center, bulge > 0.0, f64::INFINITY);
    arc.ok().map(ArcOrLine::Arc)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::MIN_LENGTH;

    fn start(piece: &ArcOrLine) -> DVec2 {
        match piece {
            ArcOrLine::Arc(arc) => arc.start(),
            ArcOrLine::Line(line) => line.start(),
        }
    }

    fn assert_in_one_piece(cubics: &[Cubic], tolerance: f64) -> Vec<ArcOrLine> {
        let pieces = fit_arcs(cubics, tolerance);
        let mut at = cubics[0].start();
        for piece in &pieces {
            assert_eq!(start(piece), at, "{cubics:?} at {tolerance}");
            at = piece.end();
        }
        let gap = at.distance(cubics[cubics.len() - 1].end());
        assert!(gap < MIN_LENGTH, "{cubics:?} at {tolerance} ends {gap} mm short");
        pieces
    }

    #[test]
    fn pieces_follow_each_other_without_gaps_even_round_cusps_and_tiny_cubics() {
        let p = DVec2::new;
        let cusp = Cubic::new(p(0.0, 0.0), p(30.0, 20.0), p(0.0, 20.0), p(30.0, 0.0));
        let still = Cubic::new(p(30.0, 0.0), p(30.0, 0.0), p(30.0, 0.0), p(30.0, 0.0));
        let tiny = Cubic::new(p(30.0, 0.0), p(30.0, 1e-6), p(30.0, 2e-6), p(30.0, 3e-6));
        let back = Cubic::new(p(30.0, 3e-6), p(40.0, 3e-6), p(40.0, 9.0), p(30.0, 9.0));
        for tolerance in [1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5] {
            assert_in_one_piece(&[cusp], tolerance);
            assert_in_one_piece(&[cusp, still, tiny, back], tolerance);
            assert_in_one_piece(&[still], tolerance);
            assert_in_one_piece(&[tiny], tolerance);
        }
    }

    #[test]
    fn a_huge_cubic_and_one_without_numbers_come_to_an_end() {
        let p = DVec2::new;
        let huge = Cubic::new(p(-1e7, 0.0), p(0.0, 1e7), p(0.0, -1e7), p(1e7, 0.0));
        let pieces = assert_in_one_piece(&[huge], 1e-5);
        assert!(pieces.len() < 5000, "{} pieces", pieces.len());
        let none = Cubic::new(p(0.0, 0.0), p(f64::NAN, 1.0), p(1.0, 1.0), p(2.0, 0.0));
        assert!(fit_arcs(&[none], 1e-3).len() < 100, "it ends");
    }

    #[test]
    fn a_tenth_of_the_tolerance_costs_few_more_pieces() {
        // A biarc deviates by the third power of its length: a tenth of the tolerance takes
        // 10^(1/3) = 2.2 times as many.
        let p = DVec2::new;
        let s = Cubic::new(p(0.0, 0.0), p(20.0, 25.0), p(10.0, -25.0), p(30.0, 5.0));
        let counts: Vec<usize> =
            [0.1, 0.01, 0.001, 1e-4].iter().map(|&t| assert_in_one_piece(&[s], t).len()).collect();
        for pair in counts.windows(2) {
            assert!(pair[1] <= 3 * pair[0], "{counts:?}");
        }
    }
}
