//! The curves that are raced on: type points about 5 mm apart.

use g41::compensation::{Options, avoid};
use g41::contour::{Attributes, Contour, ContourBuilder, Shape, Side, SplineShape, Tool, ToolPath};
use g41::diagnostic::Origin;
use g41::geometry::{Curve, Parameter, Spline, SplineEnds};
use glam::DVec2;

use crate::type_points;

/// A curve of a family, with its type points.
#[derive(Debug, Clone)]
pub struct Sample {
    pub name: &'static str,
    pub closed: bool,
    /// The first is repeated as the last where the curve is closed.
    pub points: Vec<DVec2>,
    /// Number of type points.
    pub count: usize,
    /// Tool radius [mm] without loops, and with.
    pub radii: [f64; 2],
}

/// The closed wave: 5 mm is nowhere too much for its bends, 60 mm everywhere.
#[must_use]
pub fn wave(n: usize) -> Sample {
    let points = type_points::wave(n);
    Sample { name: "wave", closed: true, points, count: n, radii: [5.0, 60.0] }
}

/// The open spiral: a tool of 25 mm does not fit between its turns.
#[must_use]
pub fn spiral(n: usize) -> Sample {
    let points = type_points::spiral(n);
    Sample { name: "spiral", closed: false, points, count: n, radii: [5.0, 25.0] }
}

impl Sample {
    /// The contour of one spline through the type points.
    #[must_use]
    pub fn contour(&self) -> Contour {
        let mut builder = ContourBuilder::new(self.points[0]);
        let shape = SplineShape { points: self.points[1..].to_vec(), ..SplineShape::default() };
        builder.segment(Shape::Spline(shape), Attributes::at(Origin::Segment(0)));
        builder.build(self.closed).contour.expect("the curves are splines")
    }

    /// The spline itself.
    #[must_use]
    pub fn spline(&self) -> Spline {
        let ends = if self.closed { SplineEnds::Periodic } else { SplineEnds::NATURAL };
        Spline::through(self.points.clone(), ends, Parameter::Chord)
            .expect("the curves are splines")
    }

    /// From raw type points to the path without loops.
    #[must_use]
    pub fn avoided(&self, radius: f64, tolerance: f64) -> ToolPath {
        avoid(&self.contour(), tool(radius), &options(tolerance))
    }
}

/// A tool on the left: inside the wave, and on the inner side of the spiral.
#[must_use]
pub fn tool(radius: f64) -> Tool {
    Tool::new(radius, Side::Left).expect("a valid radius")
}

#[must_use]
pub fn options(tolerance: f64) -> Options {
    Options { tolerance, ..Options::default() }
}

/// The cubics of a contour of one spline.
#[must_use]
pub fn spline_of(contour: &Contour) -> Option<&Spline> {
    match &contour.segments().first()?.curve {
        Curve::Spline(spline) => Some(spline),
        Curve::Line(_) | Curve::Arc(_) | Curve::Involute(_) => None,
    }
}
