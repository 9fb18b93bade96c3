//! A spline of several blocks whose end is not known yet, and the shape that comes of it.

use glam::DVec2;

use super::g_words::Motion;
use super::rules::Rules;
use crate::contour::{Attributes, Shape, SplineShape};
use crate::diagnostic::Origin;
use crate::geometry::{EndCondition, MIN_LENGTH, Nurbs, NurbsError, Spline, SplineEnds, akima};

/// The finest tolerance of curves [mm]: cubics nearer than that differ from each other by rounding.
const FINEST: f64 = 1e-9;

/// What a SINUMERIK spline is like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Family {
    /// ASPLINE: Akima's curve through the points.
    Akima,
    /// BSPLINE: a NURBS curve of control points.
    Controls,
    /// CSPLINE: the C2 cubic spline through the points.
    Cubic,
}

/// How a SINUMERIK spline begins or ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Boundary {
    /// BAUTO, EAUTO: as the points alone tell.
    Auto,
    /// BNAT, ENAT: with curvature zero.
    Natural,
    /// BTAN, ETAN: tangent to the block beside it.
    #[default]
    Tangent,
}

/// What a point does to the spline that it belongs to.
pub(super) enum Added {
    /// It is one more point.
    Point,
    /// It repeats the point before it: the spline ends there, and the next one starts.
    Corner(Box<PendingSpline>),
    /// It repeats the point at which the spline starts, which is one already.
    Repeated,
}

/// A spline whose end is not known yet.
#[derive(Debug)]
pub(super) struct PendingSpline {
    /// The mode of its blocks.
    pub(super) motion: Motion,
    /// Where it starts [mm].
    start: DVec2,
    /// The points after the start [mm].
    points: Vec<DVec2>,
    /// The blocks of these points.
    origins: Vec<Origin>,
    /// Of its first block, but with the time of all of them.
    attributes: Attributes,
    /// Feed of its latest point that has one [mm/s].
    feed: Option<f64>,
    /// Of control points: the weight of the start, and of each point.
    pub(super) weights: Vec<f64>,
    /// Knots of a NURBS curve, or the intervals between those of a BSPLINE.
    pub(super) knots: Vec<f64>,
    /// Of control points: the degree plus one.
    pub(super) order: usize,
    /// How many blocks with nothing but a knot there were.
    pub(super) closing: usize,
    /// A G05.3 has ended it.
    pub(super) closed: bool,
    pub(super) boundaries: [Boundary; 2],
    /// Tangents at its ends, where they are known.
    pub(super) tangents: [Option<DVec2>; 2],
}

/// What comes of a spline.
pub(super) struct Finished {
    pub(super) start: DVec2,
    pub(super) shape: Shape,
    pub(super) attributes: Attributes,
    /// The blocks of its last pieces, or of all.
    pub(super) origins: Vec<Origin>,
    /// Why a straight line stands in its place.
    pub(super) fault: Option<NurbsError>,
    /// The tolerance of its cubics, where they are not the curve itself [mm].
    pub(super) within: Option<f64>,
}

impl PendingSpline {
    pub(super) fn new(motion: Motion, start: DVec2, attributes: Attributes) -> Self {
        Self {
            motion,
            start,
            points: Vec::new(),
            origins: Vec::new(),
            attributes,
            feed: attributes.feed,
            weights: vec![1.0],
            knots: Vec::new(),
            order: if motion == Motion::Controls { 3 } else { 4 },
            closing: 0,
            closed: false,
            boundaries: [Boundary::Tangent; 2],
            tangents: [None; 2],
        }
    }

    /// How many points it has after its start.
    pub(super) fn len(&self) -> usize {
        self.points.len() + self.knots.len()
    }

    /// Adds a point that the curve passes with what was programmed in its block.
    pub(super) fn add(&mut self, point: DVec2, attributes: Attributes) -> Added {
        let last = self.points.last().copied().unwrap_or(self.start);
        if point.distance(last) < MIN_LENGTH {
            if self.points.is_empty() || self.motion != Motion::TypePoints {
                return Added::Repeated;
            }
            let next = Self::new(self.motion, last, attributes);
            return Added::Corner(Box::new(std::mem::replace(self, next)));
        }
        self.push(point, attributes);
        Added::Point
    }

    /// Adds a control point.
    pub(super) fn add_control(&mut self, point: DVec2, weight: f64, attributes: Attributes) {
        self.push(point, attributes);
        self.weights.push(weight);
    }

    fn push(&mut self, point: DVec2, attributes: Attributes) {
        if self.points.is_empty() {
            self.attributes = attributes;
            self.feed = attributes.feed;
        } else if let (Some(time), Some(more)) = (&mut self.attributes.time, attributes.time) {
            *time += more;
        }
        self.points.push(point);
        self.origins.push(attributes.origin);
        self.attributes.feed = self.attributes.feed.or(attributes.feed);
        self.feed = attributes.feed.or(self.feed);
    }

    /// Whether it has no point besides its start.
    pub(super) fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Feed of its latest point that has one [mm/s].
    pub(super) fn feed(&self) -> Option<f64> {
        self.feed
    }

    /// What comes of it; `None` where it never got a point.
    pub(super) fn finish(mut self, rules: Rules) -> Option<Finished> {
        let &to = self.points.last()?;
        let (start, attributes) = (self.start, self.attributes);
        let mut origins = std::mem::take(&mut self.origins);
        let (mut fault, mut within) = (None, None);
        let shape = match self.motion {
            Motion::Controls | Motion::Knots | Motion::Named(Family::Controls) => {
                // Control points have no pieces of their own; the last piece ends at the last.
                origins = origins.split_off(origins.len() - 1);
                match self.nurbs(rules.curve_tolerance.max(FINEST)) {
                    Ok((shape, tolerance)) => {
                        within = tolerance;
                        shape
                    }
                    Err(error) => {
                        fault = Some(error);
                        Shape::Line { to }
                    }
                }
            }
            Motion::Named(Family::Akima) => {
                self.points.insert(0, start);
                bezier(&akima(&self.points, self.ends()))
            }
            Motion::Named(Family::Cubic) => self.cubic(rules),
            _ => Shape::Spline(SplineShape {
                points: self.points,
                start_tangent: self.tangents[0],
                parameter: rules.parameter,
                ..SplineShape::default()
            }),
        };
        Some(Finished { start, shape, attributes, origins, fault, within })
    }

    /// How a SINUMERIK spline ends.
    fn ends(&self) -> [EndCondition; 2] {
        [0, 1].map(|end| match (self.boundaries[end], self.tangents[end]) {
            (Boundary::Auto, _) => EndCondition::NotAKnot,
            (Boundary::Tangent, Some(tangent)) => EndCondition::Tangent(tangent),
            (Boundary::Natural | Boundary::Tangent, _) => EndCondition::Natural,
        })
    }

    /// CSPLINE: a spline through type points where its ends allow for one.
    fn cubic(mut self, rules: Rules) -> Shape {
        if self.boundaries.contains(&Boundary::Auto) {
            let [start, end] = self.ends();
            let mut points = vec![self.start];
            points.extend_from_slice(&self.points);
            let ends = SplineEnds::Open { start, end };
            if let Ok(spline) = Spline::through(points, ends, rules.parameter) {
                return bezier(spline.pieces());
            }
        }
        for (tangent, boundary) in self.tangents.iter_mut().zip(self.boundaries) {
            *tangent = tangent.filter(|_| boundary == Boundary::Tangent);
        }
        let [start_tangent, end_tangent] = self.tangents;
        let parameter = rules.parameter;
        // Two points without a tangent are the line between them.
        match self.points[..] {
            [to] if start_tangent.or(end_tangent).is_none() => Shape::Line { to },
            _ => Shape::Spline(SplineShape {
                points: self.points,
                start_tangent,
                end_tangent,
                parameter,
                ..SplineShape::default()
            }),
        }
    }

    /// The cubics of a NURBS curve, and their tolerance [mm] where they are not the curve itself.
    fn nurbs(&mut self, tolerance: f64) -> Result<(Shape, Option<f64>), NurbsError> {
        let mut controls = vec![(self.start, self.weights[0])];
        for (point, weight) in self.points.iter().zip(&self.weights[1..]) {
            controls.push((*point, *weight));
        }
        let uniform = Nurbs::uniform_knots(self.order, controls.len());
        let knots = match self.motion {
            Motion::Knots => {
                // The first block may leave out its knot, which is that of the second.
                if let [first, second, ..] = &mut self.knots[..]
                    && first.is_nan()
                {
                    *first = *second;
                }
                std::mem::take(&mut self.knots)
            }
            Motion::Named(_) => intervals(uniform, self.order, &self.knots),
            _ => uniform,
        };
        let curve = Nurbs::new(self.order, knots, &controls)?;
        let cubics = curve.cubics(tolerance)?;
        Ok((bezier(&cubics), (!curve.is_cubic()).then_some(tolerance)))
    }
}

/// Evenly spaced knots, spaced by the given intervals instead where those are as many: zero
/// intervals belong to the repeated knots at the ends.
fn intervals(mut knots: Vec<f64>, order: usize, given: &[f64]) -> Vec<f64> {
    let spans = (knots.len() + 1).saturating_sub(2 * order);
    let mut sum = 0.0;
    let mut count = 0;
    for &interval in given.iter().filter(|interval| **interval > 0.0).take(spans) {
        sum += interval;
        count += 1;
        knots[order - 1 + count] = sum;
    }
    if count < spans {
        return Nurbs::uniform_knots(order, knots.len().saturating_sub(order));
    }
    for knot in knots.iter_mut().rev().take(order) {
        *knot = sum;
    }
    knots
}

/// Bézier curves as described.
fn bezier(cubics: &[crate::geometry::Cubic]) -> Shape {
    let mut controls = Vec::with_capacity(3 * cubics.len());
    for cubic in cubics {
        controls.extend_from_slice(&cubic.points[1..]);
    }
    Shape::Bezier { controls }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_space_the_inner_knots() {
        let knots = |given: &[f64]| intervals(Nurbs::uniform_knots(3, 5), 3, given);
        assert_eq!(knots(&[]), [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0], "even without any");
        assert_eq!(knots(&[2.0, 1.0]), Nurbs::uniform_knots(3, 5), "even where some are missing");
        let given = [0.0, 2.0, 1.0, 4.0, 0.0];
        assert_eq!(knots(&given), [0.0, 0.0, 0.0, 2.0, 3.0, 7.0, 7.0, 7.0], "as given");
    }
}
