//! The textbook's way with splines: move the type points, and lay a spline through them.
//!
//! "Tool radius compensation algorithm of spline curve", 2.3: corners are treated on the polygon
//! of type points. Each inner point moves by exactly r along the bisecting transition vector of
//! its two legs; an end moves to the intersection of its leg's equidistant with that of the
//! neighbour (shortened, elongated) or to `P + r n` (inserted). The tool path is the spline
//! through the moved points: at distance r near the type points only, and how far off between
//! them is measured and reported.

use glam::DVec2;

use super::offset::offset_line;
use super::transition::Terminal;
use crate::contour::{MoveCurve, Tool};
use crate::geometry::{Arc, CurveError, Line, Spline, intersect::line_circle, perp};

/// Places on each cubic of the moved spline at which its distance from the contour is measured.
const DEVIATION_SAMPLES: usize = 8;

/// The polygon of a spline's type points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Polygon<'a> {
    spline: &'a Spline,
    tool: Tool,
}

impl<'a> Polygon<'a> {
    pub(super) fn new(spline: &'a Spline, tool: Tool) -> Self {
        Self { spline, tool }
    }

    /// Unit tangents of the first and the last leg; those of the curve for a periodic spline,
    /// which has no ends.
    pub(super) fn tangents(&self) -> [DVec2; 2] {
        if self.spline.is_periodic() {
            return [self.spline.tangent(0.0), self.spline.tangent(1.0)];
        }
        let points = self.spline.points();
        let last = points.len() - 1;
        [(points[1] - points[0]).normalize(), (points[last] - points[last - 1]).normalize()]
    }

    /// The equidistant of the leg at an end (0 start, 1 end), in program direction.
    pub(super) fn leg(&self, end: usize) -> Option<Line> {
        let points = self.spline.points();
        let last = points.len() - 1;
        let from = if end == 0 { 0 } else { last - 1 };
        let leg = Line::new(points[from], points[from + 1]).ok()?;
        offset_line(&leg, self.tool.offset())
    }

    /// The spline through the moved points, whose ends are given.
    pub(super) fn moved(&self, start: Terminal, end: Terminal) -> Result<Spline, CurveError> {
        let points = self.spline.points();
        let last = points.len() - 1;
        let offset = self.tool.offset();
        let direction = |leg: usize| (points[leg + 1] - points[leg]).normalize();
        let along_bisector = |before: DVec2, after: DVec2, point: DVec2| {
            // A polygon that doubles back has no bisector; the point then moves aside.
            let bisector = perp(before + after).normalize_or(perp(before));
            point + bisector * offset
        };
        let at_end = |terminal, point: DVec2, along: DVec2| match terminal {
            Terminal::To(point) | Terminal::Moved(point) => point,
            Terminal::Whole | Terminal::At(_) => point + perp(along) * offset,
        };
        let mut moved: Vec<DVec2> = Vec::with_capacity(points.len());
        for (i, &point) in points.iter().enumerate() {
            moved.push(if self.spline.is_periodic() && (i == 0 || i == last) {
                along_bisector(direction(last - 1), direction(0), point)
            } else if i == 0 {
                at_end(start, point, direction(0))
            } else if i == last {
                at_end(end, point, direction(last - 1))
            } else {
                along_bisector(direction(i - 1), direction(i), point)
            });
        }
        Spline::through(moved, self.spline.ends(), self.spline.parameter())
    }

    /// Largest difference between r and the distance of the moved spline from the contour [mm],
    /// and where it is.
    pub(super) fn deviation(&self, moved: &Spline) -> (f64, DVec2) {
        let mut worst = (0.0, self.spline.start());
        for (span, piece) in moved.pieces().iter().enumerate() {
            for k in 1..DEVIATION_SAMPLES {
                let point = piece.point(k as f64 / DEVIATION_SAMPLES as f64);
                // The span it was moved from and its neighbours: what is nearest elsewhere is no
                // error of the method.
                let near = span.saturating_sub(1)..(span + 2).min(self.spline.pieces().len());
                let distance = self.spline.pieces()[near]
                    .iter()
                    .map(|cubic| cubic.nearest(point).distance)
                    .fold(f64::INFINITY, f64::min);
                let deviation = (distance - self.tool.radius()).abs();
                if deviation > worst.0 {
                    worst = (deviation, point);
                }
            }
        }
        worst
    }

    /// Index of the first span that the move turns around: the tool does not fit between its type
    /// points.
    pub(super) fn turned_span(&self, moved: &Spline) -> Option<usize> {
        let (old, new) = (self.spline.points(), moved.points());
        (0..old.len() - 1).find(|&i| (old[i + 1] - old[i]).dot(new[i + 1] - new[i]) <= 0.0)
    }

    /// End conditions and type points as programmed.
    pub(super) fn spline(&self) -> &'a Spline {
        self.spline
    }
}

/// Where the equidistant of a leg meets the concentric circle of a neighbouring arc, both run on
/// without end: of two points, the one nearer to the corner.
pub(super) fn leg_meets_arc(leg: &Line, arc: &Arc, near: DVec2) -> Option<DVec2> {
    line_circle(leg, arc.center(), arc.radius())
        .into_iter()
        .map(|t| leg.point(t))
        .min_by(|a, b| a.distance_squared(near).total_cmp(&b.distance_squared(near)))
}

/// The parameter of `point` on `arc` run on beyond the given end, in `(-0.5, 1.5)` turns of it.
pub(super) fn parameter_beyond(arc: &Arc, point: DVec2, end: usize) -> f64 {
    let t = arc.parameter(point);
    let full_turn = std::f64::consts::TAU / arc.sweep().abs();
    // The way from the end in question, forwards or backwards, whichever is shorter.
    let center = if end == 0 { 0.0 } else { 1.0 };
    let mut way = t - center;
    if way > 0.5 * full_turn {
        way -= full_turn;
    } else if way < -0.5 * full_turn {
        way += full_turn;
    }
    center + way
}

/// The pieces of a spline as moves.
pub(super) fn as_moves(spline: &Spline) -> Vec<MoveCurve> {
    spline.pieces().iter().copied().map(MoveCurve::Cubic).collect()
}
