//! Contours as data: built, and run through their symmetries.

use g41::compensation::{Options, compensate};
use g41::contour::{
    Attributes, Contour, ContourBuilder, Lead, Shape, Side, SplineShape, Tool, ToolPath,
};
use g41::diagnostic::{Origin, Severity};
use g41::geometry::{Curve, RadiusForm};
use glam::DVec2;

/// A contour as described.
#[derive(Debug, Clone)]
pub(crate) struct Sketch {
    pub(crate) start: DVec2,
    pub(crate) shapes: Vec<Shape>,
    pub(crate) closed: bool,
    pub(crate) lead_in: Option<DVec2>,
    pub(crate) lead_out: Option<DVec2>,
}

pub(crate) fn line(to: DVec2) -> Shape {
    Shape::Line { to }
}

pub(crate) fn arc(to: DVec2, center: DVec2, clockwise: bool) -> Shape {
    Shape::Arc { to, center, clockwise }
}

pub(crate) fn spline(points: &[DVec2]) -> Shape {
    Shape::Spline(SplineShape { points: points.to_vec(), ..SplineShape::default() })
}

impl Sketch {
    pub(crate) fn open(start: DVec2, shapes: impl IntoIterator<Item = Shape>) -> Self {
        let shapes = shapes.into_iter().collect();
        Self { start, shapes, closed: false, lead_in: None, lead_out: None }
    }

    pub(crate) fn closed(start: DVec2, shapes: impl IntoIterator<Item = Shape>) -> Self {
        Self { closed: true, ..Self::open(start, shapes) }
    }

    pub(crate) fn led(mut self, lead_in: DVec2, lead_out: DVec2) -> Self {
        (self.lead_in, self.lead_out) = (Some(lead_in), Some(lead_out));
        self
    }

    /// The contour, which must be buildable without a complaint.
    #[track_caller]
    pub(crate) fn contour(&self) -> Contour {
        let mut builder = ContourBuilder::new(self.start);
        let attributes =
            |i: usize| Attributes::at(Origin::Segment(u32::try_from(i).expect("few segments")));
        for (i, shape) in self.shapes.iter().enumerate() {
            builder.segment(shape.clone(), attributes(i));
        }
        if let Some(point) = self.lead_in {
            builder.lead_in(Lead { point, attributes: attributes(0) });
        }
        if let Some(point) = self.lead_out {
            builder.lead_out(Lead { point, attributes: attributes(self.shapes.len() - 1) });
        }
        let built = builder.build(self.closed);
        let faults: Vec<_> =
            built.diagnostics.iter().filter(|d| d.severity > Severity::Info).collect();
        assert!(faults.is_empty(), "{self:?} has faults: {faults:?}");
        built.contour.expect("a contour without faults is there")
    }

    #[track_caller]
    pub(crate) fn compensated(&self, side: Side, radius: f64, options: &Options) -> ToolPath {
        compensate(&self.contour(), Tool::new(radius, side).expect("a valid radius"), options)
    }

    /// The image under an affine map; `mirrored` where it turns left into right.
    pub(crate) fn mapped(&self, mirrored: bool, map: impl Fn(DVec2) -> DVec2) -> Self {
        let vector = |v: DVec2| map(v) - map(DVec2::ZERO);
        let length = |l: f64| vector(DVec2::new(l, 0.0)).length();
        let shape = |shape: &Shape| match shape {
            Shape::Line { to } => line(map(*to)),
            Shape::Arc { to, center, clockwise } => {
                arc(map(*to), map(*center), *clockwise != mirrored)
            }
            Shape::ArcByRadius { to, radius, form, clockwise } => Shape::ArcByRadius {
                to: map(*to),
                radius: length(*radius),
                form: *form,
                clockwise: *clockwise != mirrored,
            },
            Shape::Spline(spline) => Shape::Spline(SplineShape {
                points: spline.points.iter().map(|p| map(*p)).collect(),
                start_tangent: spline.start_tangent.map(vector),
                end_tangent: spline.end_tangent.map(vector),
                ..spline.clone()
            }),
            Shape::Bezier { controls } => {
                Shape::Bezier { controls: controls.iter().map(|p| map(*p)).collect() }
            }
            Shape::Involute { to, center, radius, clockwise } => Shape::Involute {
                to: map(*to),
                center: map(*center),
                radius: length(*radius),
                clockwise: *clockwise != mirrored,
            },
        };
        Self {
            start: map(self.start),
            shapes: self.shapes.iter().map(shape).collect(),
            closed: self.closed,
            lead_in: self.lead_in.map(&map),
            lead_out: self.lead_out.map(&map),
        }
    }

    /// Where each shape starts, and where the last ends.
    pub(crate) fn joints(&self) -> Vec<DVec2> {
        let ends = self.shapes.iter().map(|shape| shape.end().expect("a shape has an end"));
        std::iter::once(self.start).chain(ends).collect()
    }

    /// The same contour run the other way.
    pub(crate) fn reversed(&self) -> Self {
        let joints = self.joints();
        let backwards = |i: usize| {
            let to = joints[i];
            match &self.shapes[i] {
                Shape::Line { .. } => line(to),
                Shape::Arc { center, clockwise, .. } => arc(to, *center, !clockwise),
                Shape::ArcByRadius { radius, form, clockwise, .. } => {
                    let (radius, form) = (*radius, *form);
                    Shape::ArcByRadius { to, radius, form, clockwise: !clockwise }
                }
                Shape::Spline(spline) => {
                    let mut points: Vec<DVec2> = spline.points.iter().rev().copied().collect();
                    points.remove(0);
                    points.push(to);
                    Shape::Spline(SplineShape {
                        points,
                        start_tangent: spline.end_tangent.map(|t| -t),
                        end_tangent: spline.start_tangent.map(|t| -t),
                        ..spline.clone()
                    })
                }
                Shape::Bezier { controls } => {
                    let mut controls: Vec<DVec2> = controls.iter().rev().copied().collect();
                    controls.remove(0);
                    controls.push(to);
                    Shape::Bezier { controls }
                }
                Shape::Involute { center, radius, clockwise, .. } => {
                    let (center, radius) = (*center, *radius);
                    Shape::Involute { to, center, radius, clockwise: !clockwise }
                }
            }
        };
        Self {
            start: joints[joints.len() - 1],
            shapes: (0..self.shapes.len()).rev().map(backwards).collect(),
            closed: self.closed,
            lead_in: self.lead_out,
            lead_out: self.lead_in,
        }
    }

    /// A closed contour begun at segment `first`.
    pub(crate) fn starting_at(&self, first: usize) -> Self {
        let mut shapes = self.shapes.clone();
        shapes.rotate_left(first);
        Self { start: self.joints()[first], shapes, ..self.clone() }
    }

    /// With segment `index` cut in two at `t`; `None` for a spline, whose parts are not splines
    /// through their own type points.
    pub(crate) fn split(&self, index: usize, t: f64) -> Option<Self> {
        let contour = self.contour();
        let middle = contour.segments()[index].curve.point(t);
        let first = match &contour.segments()[index].curve {
            Curve::Line(_) => line(middle),
            Curve::Arc(whole) => arc(middle, whole.center(), whole.is_clockwise()),
            Curve::Involute(whole) => Shape::Involute {
                to: middle,
                center: whole.center(),
                radius: whole.base_radius(),
                clockwise: whole.is_clockwise(),
            },
            Curve::Spline(_) => return None,
        };
        let second = match &self.shapes[index] {
            Shape::ArcByRadius { to, radius, clockwise, .. } => Shape::ArcByRadius {
                to: *to,
                radius: *radius,
                form: RadiusForm::Minor,
                clockwise: *clockwise,
            },
            shape => shape.clone(),
        };
        let mut split = self.clone();
        split.shapes.splice(index..=index, [first, second]);
        Some(split)
    }
}
