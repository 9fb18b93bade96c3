//! Moves without compensation, as items of a program.

use glam::DVec2;

use super::course::Course;
use super::items::Item;
use super::open::builder_at;
use super::report::Report;
use crate::contour::{Attributes, Move, MoveCurve, Role, Shape};
use crate::geometry::{Curve, Line};

impl Course {
    pub(super) fn free_line(&mut self, from: DVec2, to: DVec2, attributes: &Attributes) {
        if let Ok(line) = Line::new(from, to) {
            self.free(MoveCurve::Line(line), attributes);
        }
    }

    /// The moves of one free curve, made as a contour of its own.
    pub(super) fn free_curve(
        &mut self,
        from: DVec2,
        shape: Shape,
        attributes: Attributes,
        report: &mut Report,
    ) {
        let mut builder = builder_at(from, self.rules);
        builder.segment(shape, attributes);
        let built = builder.build(false);
        // Why there is no segment is said by the diagnostic before.
        report.extend(built.diagnostics.into_iter().filter(|found| found.code != "empty-contour"));
        let Some(contour) = built.contour else { return };
        let mut attributes = attributes;
        if let Some(time) = attributes.time.take() {
            let mut length = 0.0;
            for segment in contour.segments() {
                length += segment.curve.length();
            }
            let [start, end] = attributes.heights;
            attributes.feed = Some(length.hypot(end - start) / time);
        }
        for segment in contour.segments() {
            match &segment.curve {
                Curve::Line(line) => self.free(MoveCurve::Line(*line), &attributes),
                Curve::Arc(arc) => self.free(MoveCurve::Arc(*arc), &attributes),
                Curve::Involute(involute) => {
                    self.free(MoveCurve::Involute(*involute), &attributes);
                }
                Curve::Spline(spline) => {
                    for cubic in spline.pieces() {
                        self.free(MoveCurve::Cubic(*cubic), &attributes);
                    }
                }
            }
        }
    }

    pub(super) fn free(&mut self, curve: MoveCurve, attributes: &Attributes) {
        let feed = match attributes.time {
            Some(time) => {
                let [start, end] = attributes.heights;
                Some(curve.length().hypot(end - start) / time)
            }
            None => attributes.feed,
        };
        self.items.push(Item::Free(Move {
            curve,
            role: Role::Free,
            rapid: attributes.rapid,
            feed,
            plane: attributes.plane,
            heights: attributes.heights,
            origin: attributes.origin,
        }));
    }
}
