//! The other libraries, each with the input it understands.

use cavalier_contours::polyline::{PlineSource, PlineSourceMut, Polyline};
use clipper2_rust::{EndType, JoinType, PathsD, Point, inflate_paths_d};
use g41::geometry::{Cubic, Spline, flatten_cubic};
use glam::DVec2;
use kurbo::{BezPath, CubicBez, PathEl};

/// The cubics of a spline as kurbo's.
#[must_use]
pub fn kurbo_cubics(spline: &Spline) -> Vec<CubicBez> {
    let point = |p: DVec2| kurbo::Point::new(p.x, p.y);
    let cubic = |c: &Cubic| {
        let [a, b, c, d] = c.points.map(point);
        CubicBez::new(a, b, c, d)
    };
    spline.pieces().iter().map(cubic).collect()
}

/// kurbo's offsets of all cubics, not trimmed: how many pieces.
#[must_use]
pub fn kurbo_pieces(cubics: &[CubicBez], radius: f64, tolerance: f64) -> usize {
    let (mut pieces, mut path) = (0, BezPath::new());
    for cubic in cubics {
        path.truncate(0);
        kurbo::offset::offset_cubic(*cubic, radius, tolerance, &mut path);
        pieces += path.elements().len() - 1;
    }
    pieces
}

/// kurbo's offset of one cubic.
#[must_use]
pub fn kurbo_offset(cubic: CubicBez, radius: f64, tolerance: f64) -> Vec<Cubic> {
    let mut path = BezPath::new();
    kurbo::offset::offset_cubic(cubic, radius, tolerance, &mut path);
    let vector = |p: kurbo::Point| DVec2::new(p.x, p.y);
    let mut at = DVec2::ZERO;
    let mut pieces = Vec::new();
    for element in path.elements() {
        match *element {
            PathEl::MoveTo(p) => at = vector(p),
            PathEl::LineTo(p) => {
                let to = vector(p);
                pieces.push(Cubic::new(at, at.lerp(to, 1.0 / 3.0), at.lerp(to, 2.0 / 3.0), to));
                at = to;
            }
            PathEl::CurveTo(a, b, c) => {
                pieces.push(Cubic::new(at, vector(a), vector(b), vector(c)));
                at = vector(c);
            }
            PathEl::QuadTo(..) | PathEl::ClosePath => {}
        }
    }
    pieces
}

/// The biarcs of a spline within a tolerance: each span is halved until two arcs follow it, which
/// is checked at eight points.
#[must_use]
pub fn biarcs(spline: &Spline, closed: bool, tolerance: f64) -> Polyline<f64> {
    let mut polyline = if closed { Polyline::new_closed() } else { Polyline::new() };
    for piece in spline.pieces() {
        fit(piece, tolerance, 0, &mut polyline);
    }
    if !closed {
        let end = spline.end();
        polyline.add(end.x, end.y, 0.0);
    }
    polyline
}

/// Most halvings of a span.
const MAX_DEPTH: u32 = 20;

fn fit(piece: &Cubic, tolerance: f64, depth: u32, polyline: &mut Polyline<f64>) {
    let (start, end) = (piece.start(), piece.end());
    let (t0, t1) = (piece.tangent(0.0), piece.tangent(1.0));
    let (chord, both, gap) = (end - start, t0 + t1, 2.0 * (1.0 - t0.dot(t1)));
    let along = chord.dot(both);
    // Both handles of equal length d, such that |joint| is common to the two arcs:
    // gap d² + 2 (chord · both) d = chord².
    let d = if gap > 1e-12 {
        ((along * along + gap * chord.length_squared()).sqrt() - along) / gap
    } else {
        chord.length_squared() / (2.0 * along)
    };
    let joint = 0.5 * (start + t0 * d + end - t1 * d);
    let middle = (end - t1 * d - start - t0 * d).normalize_or_zero();
    let (first, second) = (arc(start, t0, joint), arc(joint, middle, end));
    let off = |k: u32| {
        let point = piece.point((f64::from(k) + 0.5) / 8.0);
        let side = if (point - joint).dot(middle) < 0.0 { &first } else { &second };
        side.off(point)
    };
    if depth < MAX_DEPTH && (0..8).map(off).fold(0.0, f64::max) > tolerance {
        let (left, right) = piece.split(0.5);
        fit(&left, tolerance, depth + 1, polyline);
        fit(&right, tolerance, depth + 1, polyline);
        return;
    }
    polyline.add(start.x, start.y, first.bulge);
    polyline.add(joint.x, joint.y, second.bulge);
}

/// An arc by its start, the tangent there, and its curvature.
struct Arc {
    start: DVec2,
    tangent: DVec2,
    curvature: f64,
    bulge: f64,
}

fn arc(start: DVec2, tangent: DVec2, end: DVec2) -> Arc {
    let chord = end - start;
    let area = tangent.perp_dot(chord);
    let bulge = area / (chord.length() + tangent.dot(chord));
    Arc { start, tangent, curvature: 2.0 * area / chord.length_squared(), bulge }
}

impl Arc {
    /// Distance of a point from the arc's circle, to first order where that is flat.
    fn off(&self, point: DVec2) -> f64 {
        let away = point - self.start;
        // |away − N/κ| − 1/κ without the cancellation of a large radius.
        let k = self.curvature;
        let inside = k * away.length_squared() - 2.0 * self.tangent.perp_dot(away);
        (inside / (1.0 + (1.0 + k * inside).max(0.0).sqrt())).abs()
    }
}

/// cavalier's trimmed offset to the left: how many segments.
#[must_use]
pub fn cavalier_pieces(polyline: &Polyline<f64>, radius: f64) -> usize {
    polyline.parallel_offset(radius).iter().map(PlineSource::segment_count).sum()
}

/// A spline as a polygon within a tolerance.
#[must_use]
pub fn polygon(spline: &Spline, closed: bool, tolerance: f64) -> PathsD {
    let mut path = vec![Point { x: spline.start().x, y: spline.start().y }];
    for piece in spline.pieces() {
        flatten_cubic(piece, tolerance, &mut |p| path.push(Point { x: p.x, y: p.y }));
    }
    if closed {
        path.pop();
    }
    vec![path]
}

/// Clipper2's trimmed offset with round joins: into a counter-clockwise polygon, on both sides of an
/// open one. How many vertices.
#[must_use]
pub fn clipper_vertices(paths: &PathsD, closed: bool, radius: f64, tolerance: f64) -> usize {
    let (delta, ends) = if closed { (-radius, EndType::Polygon) } else { (radius, EndType::Butt) };
    let offset = inflate_paths_d(paths, delta, JoinType::Round, ends, 2.0, 6, tolerance);
    offset.iter().map(Vec::len).sum()
}
