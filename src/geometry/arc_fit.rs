//! Arcs and lines within a tolerance of a chain of cubics, for controllers without splines.
//!
//! The chain is cut greedily: each step takes the longest stretch that one biarc (two arcs that
//! share a tangent where they meet) can follow, found by doubling and then halving the stretch.
//! Where the chain has a kink or a cusp a stretch ends.

use glam::DVec2;

use super::arc_proof::{distance_off, follows};
use super::{Arc, Cubic, Line, cross, turn};

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
/// as seen from its centre, where the arc may be run past: together `√(0.95² + 0.3²) < 1`.
const SHARES: [f64; 2] = [0.95, 0.3];

/// Bisections for the place beside a joint: to 2⁻³² of a stretch, which is far below any tolerance.
const BISECTIONS: usize = 32;

/// Points that refuse most pieces that are too far off before a proof is tried.
const SAMPLES: usize = 7;

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
    /// Point and tangent at `at`.
    fn frame(&self, at: f64) -> (DVec2, DVec2) {
        let (cubic, t) = self.locate(at);
        (cubic.point(t), cubic.tangent(t))
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

    /// Whether the stretch is proved to be within `tolerance` [mm] of the pieces, and they of it.
    fn is_near(&self, pieces: &[ArcOrLine], tolerance: f64) -> bool {
        let off_at = |k: usize| {
            let share = (k as f64 + 0.5) / SAMPLES as f64;
            let (point, _) = self.frame(self.from + (self.to - self.from) * share);
            pieces.iter().map(|piece| distance_off(piece, point)).fold(f64::INFINITY, f64::min)
        };
        if (0..SAMPLES).any(|k| off_at(k) > tolerance) {
            return false;
        }
        let mut from = self.from;
        for (k, piece) in pieces.iter().enumerate() {
            let to = if k + 1 == pieces.len() { self.to } else { self.beside(piece) };
            if !self.part_follows(from, to, piece, tolerance) {
                return false;
            }
            from = to;
        }
        true
    }

    /// Where the stretch crosses the normal at the end of a piece, by bisection.
    fn beside(&self, piece: &ArcOrLine) -> f64 {
        let (end, along) = match piece {
            ArcOrLine::Arc(arc) => (arc.end(), arc.tangent(1.0)),
            ArcOrLine::Line(line) => (line.end(), line.tangent()),
        };
        let (mut low, mut high) = (self.from, self.to);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if (self.frame(middle).0 - end).dot(along) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// Whether every part of a cubic between two places follows the piece, and they do not go round
    /// it once more.
    fn part_follows(&self, from: f64, to: f64, piece: &ArcOrLine, tolerance: f64) -> bool {
        let [off, mut turning] = SHARES.map(|share| share * tolerance);
        let (mut at, mut length) = (from, 0.0);
        while at < to {
            let (cubic, t) = self.locate(at);
            let rest = to - at + t;
            let part = cubic.part(t, rest.min(1.0));
            if !follows(&part, piece, off, &mut turning) {
                return false;
            }
            length += part.hull_length();
            at = if rest <= 1.0 { to } else { at.floor() + 1.0 };
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
        let attempt = |to: f64| {
            let stretch = Stretch { cubics, from, to };
            let least = LEAST_SHARE * stretch.locate(from).0.hull_length();
            fit_stretch(&stretch, at, tolerance.max(least))
        };
        let mut good: Option<(f64, Vec<ArcOrLine>)> = None;
        let mut bad = None;
        // Doubling while it works, halving until it does.
        loop {
            let to = (from + step).min(end);
            match attempt(to) {
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
        if let (Some((mut low, _)), Some(mut high)) = (good.clone(), bad) {
            for _ in 0..6 {
                let middle = 0.5 * (low + high);
                if let Some(fit) = attempt(middle) {
                    low = middle;
                    good = Some((middle, fit));
                } else {
                    high = middle;
                }
            }
        }
        // A stretch that short is a line within the least tolerance, so something is good, unless
        // the cubic is not made of numbers.
        let (to, fit) = good.unwrap_or_else(|| ((from + 1.0).min(end), Vec::new()));
        step = (to - from).max(LEAST_SHARE);
        for piece in fit {
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

/// The line or biarc from `start` that follows the stretch, if one is near enough; nothing at all
/// for a stretch too short to be a line.
fn fit_stretch(stretch: &Stretch, start: DVec2, tolerance: f64) -> Option<Vec<ArcOrLine>> {
    let (_, start_tangent) = stretch.frame(stretch.from);
    let (end, end_tangent) = stretch.frame(stretch.to);
    let near = |pieces: Vec<ArcOrLine>| stretch.is_near(&pieces, tolerance).then_some(pieces);
    let Ok(chord) = Line::new(start, end) else {
        let whole = stretch.locate(stretch.from).0;
        return (whole.hull_length() * (stretch.to - stretch.from) < tolerance).then(Vec::new);
    };
    if let Some(line) = near(vec![ArcOrLine::Line(chord)]) {
        return Some(line);
    }
    near(biarc(start, start_tangent, end, end_tangent)?)
}

/// The biarc from `start` to `end` with the given unit tangents whose two control legs at the
/// ends are equally long (Bolton 1975); `None` where it would turn by half a circle or more.
fn biarc(start: DVec2, t0: DVec2, end: DVec2, t1: DVec2) -> Option<Vec<ArcOrLine>> {
    let v = end - start;
    let sum = t0 + t1;
    // |end − leg t1 − (start + leg t0)| = 2 leg, a quadratic in the leg.
    let (a, b, c) = (4.0 - sum.length_squared(), 2.0 * v.dot(sum), -v.length_squared());
    let discriminant = (b * b - 4.0 * a * c).max(0.0).sqrt();
    // The positive root in the form without cancellation.
    let leg = if b + discriminant > 0.0 { -2.0 * c / (b + discriminant) } else { return None };
    let joint = (start + t0 * leg).midpoint(end - t1 * leg);
    let first = tangent_arc(start, t0, joint)?;
    // The second arc ends with t1: the same construction backwards.
    let second = match tangent_arc(end, -t1, joint)? {
        ArcOrLine::Arc(arc) => ArcOrLine::Arc(arc.reversed()),
        ArcOrLine::Line(line) => ArcOrLine::Line(line.reversed()),
    };
    Some(vec![first, second])
}

/// The arc from `start` along the unit tangent to `end`, a line where it is flat; `None` from
/// half a circle on.
fn tangent_arc(start: DVec2, tangent: DVec2, end: DVec2) -> Option<ArcOrLine> {
    let line = Line::new(start, end).ok()?;
    let chord = line.vector();
    let (along, across) = (tangent.dot(chord), cross(tangent, chord));
    if along <= 0.0 {
        return None;
    }
    // Radius from the tangent–chord angle: |chord| = 2 R sin a, sin a = across / |chord|.
    let radius = chord.length_squared() / (2.0 * across.abs());
    if radius > MAX_RADIUS {
        return Some(ArcOrLine::Line(line));
    }
    let center = start + super::perp(tangent) * radius * across.signum();
    let arc = Arc::from_center(start, end, center, across < 0.0, f64::INFINITY).ok()?;
    Some(ArcOrLine::Arc(arc))
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
