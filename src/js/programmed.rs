//! What is programmed, as JSON: contours in the shape in which JavaScript gives them.

use super::json::{Object, list};
use super::names::side_name;
use super::numbering::Numbering;
use super::report::write_origin;
use crate::contour::Segment;
use crate::geometry::{Curve, EndCondition, Parameter, Spline, SplineEnds};
use crate::program::{ProgrammedContour, RadiusSource};

/// `ProgrammedContour[]` of `types.d.ts` as JSON.
#[must_use]
pub fn contours_json<'a>(contours: impl IntoIterator<Item = &'a ProgrammedContour>) -> String {
    list(contours, |object, programmed| {
        let ProgrammedContour { contour, side, radius, blocks, .. } = programmed;
        object.point("start", contour.start());
        object.list("segments", contour.segments(), write_segment);
        object.truth("closed", contour.is_closed());
        object.text("side", side_name(*side));
        match radius {
            RadiusSource::Tool(number) => object.number("tool", (*number).into()),
            RadiusSource::Given(radius) => object.number("radius", *radius),
        }
        if let Some(lead) = contour.lead_in() {
            object.point("leadIn", lead.point);
        }
        if let Some(lead) = contour.lead_out() {
            object.point("leadOut", lead.point);
        }
        object.numbers("blocks", [f64::from(blocks[0]), f64::from(blocks[1])]);
    })
}

fn write_segment(object: &mut Object<'_>, segment: &Segment) {
    match &segment.curve {
        Curve::Line(line) => {
            object.text("kind", "line");
            object.point("to", line.end());
        }
        Curve::Arc(arc) => {
            object.text("kind", "arc");
            object.point("to", arc.end());
            object.point("center", arc.center());
            object.truth("clockwise", arc.is_clockwise());
        }
        Curve::Involute(involute) => {
            object.text("kind", "involute");
            object.point("to", involute.end());
            object.point("center", involute.center());
            object.number("baseRadius", involute.base_radius());
            object.truth("clockwise", involute.is_clockwise());
        }
        Curve::Spline(spline) if spline.is_through_points() => write_spline(object, spline),
        Curve::Spline(spline) => {
            object.text("kind", "bezier");
            let mut controls = Vec::with_capacity(3 * spline.pieces().len());
            for cubic in spline.pieces() {
                controls.extend_from_slice(&cubic.points[1..]);
            }
            object.points("controls", &controls);
        }
    }
    let origin = segment.attributes.origin;
    object.object("origin", |inner| write_origin(inner, origin, &Numbering::plain()));
}

fn write_spline(object: &mut Object<'_>, spline: &Spline) {
    object.text("kind", "spline");
    object.points("points", &spline.points()[1..]);
    match spline.ends() {
        SplineEnds::Periodic => object.truth("periodic", true),
        SplineEnds::Open { start, end } => {
            for (name, end) in [("startTangent", start), ("endTangent", end)] {
                match end {
                    // Such a spline is made by programs only, which state its cubics.
                    EndCondition::Natural | EndCondition::NotAKnot => {}
                    EndCondition::Tangent(tangent) => object.point(name, tangent.normalize()),
                }
            }
        }
    }
    match spline.parameter() {
        Parameter::Chord => {}
        Parameter::Centripetal => object.text("parameter", "centripetal"),
    }
}
