//! The curves that are raced on: type points about 5 mm apart.

use std::f64::consts::TAU;

use g41::compensation::{Options, avoid};
use g41::contour::{Attributes, Contour, ContourBuilder, Shape, Side, SplineShape, Tool, ToolPath};
use g41::diagnostic::Origin;
use g41::geometry::{Curve, Parameter, Spline, SplineEnds};
use glam::DVec2;

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

/// A closed curve round a circle: `k = max(3, n / 20)` waves of 8 mm. No bend is tighter than 5 mm,
/// all are tighter than 60 mm.
#[must_use]
pub fn wave(n: usize) -> Sample {
    let (k, middle) = ((n / 20).max(3) as f64, 5.0 * n as f64 / TAU);
    let at = |i: usize| {
        let angle = TAU * i as f64 / n as f64;
        DVec2::from_angle(angle) * (middle + 8.0 * (k * angle).sin())
    };
    let mut points: Vec<DVec2> = (0..n).map(at).collect();
    points.push(points[0]);
    Sample { name: "wave", closed: true, points, count: n, radii: [5.0, 60.0] }
}

/// An open spiral whose turns are 40 mm apart: a tool of 25 mm does not fit between them.
#[must_use]
pub fn spiral(n: usize) -> Sample {
    let growth = 40.0 / TAU;
    let mut angle = TAU;
    let mut points = Vec::with_capacity(n);
    for _ in 0..n {
        let reach = growth * angle;
        points.push(DVec2::from_angle(angle) * reach);
        angle += 5.0 / reach.hypot(growth);
    }
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
        Curve::Line(_) | Curve::Arc(_) => None,
    }
}
