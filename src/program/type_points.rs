//! G05 and its namesakes: type points of a spline here, other things on other controls.

use glam::DVec2;

use super::words::Words;
use crate::contour::{Attributes, Shape, SplineShape};
use crate::diagnostic::Origin;
use crate::geometry::MIN_LENGTH;

/// What a word of the G05 and G06 families means by the words beside it.
pub(super) enum SplineWord {
    /// The block's axis words are a type point; without them only the mode begins.
    TypePoint,
    /// A setting of the control without motion; what it is.
    Setting(&'static str),
    /// Smoothing by the control that changes the path; what it is.
    Smoothing(&'static str),
    /// A curve that is not supported; what it is.
    NotSupported(&'static str),
}

/// Tells the family apart by ten times the number of the word, and the words not used yet.
pub(super) fn spline_word(tenths: u32, words: &Words) -> SplineWord {
    use SplineWord::{NotSupported, Setting, Smoothing, TypePoint};
    let axes = words.has_any("XYZ");
    match tenths {
        50 => match (axes, words.has_any("P"), words.has_any("Q"), words.has_any("IJ")) {
            (_, false, false, false) => TypePoint,
            (false, true, false, false) => Setting("FANUC's high-speed mode (G05 P)"),
            (true, true, true, _) => NotSupported("LinuxCNC's cubic Bézier curve (G05 I J P Q)"),
            _ => NotSupported(
                "G05 with I, J, P or Q that is neither a type point, LinuxCNC's Bézier curve nor \
                 FANUC's high-speed mode",
            ),
        },
        51 if words.has_any("Q") && !words.has_any("IJ") => {
            if words.find('Q').is_some_and(|word| word.value == 2.0) {
                Smoothing("FANUC's smooth interpolation (G05.1 Q2)")
            } else {
                Setting("FANUC's contour control (G05.1 Q)")
            }
        }
        51 if words.has_any("IJ") => NotSupported("LinuxCNC's quadratic Bézier curve (G05.1 I J)"),
        52 => NotSupported("LinuxCNC's NURBS curve (G05.2)"),
        53 => NotSupported("the end of LinuxCNC's NURBS curve (G05.3)"),
        61 => NotSupported("FANUC's spline (G06.1)"),
        62 => NotSupported("a NURBS curve (G06.2)"),
        _ => NotSupported("this form of G05"),
    }
}

/// What a type point does to the spline that it belongs to.
pub(super) enum Added {
    /// It is one more point.
    Point,
    /// It repeats the point before it: the spline ends there, and the next one starts.
    Corner(PendingSpline),
    /// It repeats the point at which the spline starts, which is one already.
    Repeated,
}

/// A spline whose end is not known yet.
#[derive(Debug)]
pub(super) struct PendingSpline {
    /// Where it starts [mm].
    start: DVec2,
    /// The type points after the start [mm].
    points: Vec<DVec2>,
    /// The blocks of these points.
    origins: Vec<Origin>,
    /// Of its first block, but with the time of all of them.
    attributes: Attributes,
    /// Feed of its latest type point that has one [mm/s].
    feed: Option<f64>,
}

impl PendingSpline {
    pub(super) fn new(start: DVec2, attributes: Attributes) -> Self {
        Self { start, points: Vec::new(), origins: Vec::new(), attributes, feed: None }
    }

    /// How many type points it has after its start.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// Adds a type point with what was programmed in its block.
    pub(super) fn add(&mut self, point: DVec2, attributes: Attributes) -> Added {
        let Some(&last) = self.points.last() else {
            if point.distance(self.start) < MIN_LENGTH {
                return Added::Repeated;
            }
            self.points.push(point);
            self.origins.push(attributes.origin);
            self.attributes = attributes;
            self.feed = attributes.feed;
            return Added::Point;
        };
        if point.distance(last) < MIN_LENGTH {
            return Added::Corner(std::mem::replace(self, Self::new(last, attributes)));
        }
        self.points.push(point);
        self.origins.push(attributes.origin);
        if let (Some(time), Some(more)) = (&mut self.attributes.time, attributes.time) {
            *time += more;
        }
        self.attributes.feed = self.attributes.feed.or(attributes.feed);
        self.feed = attributes.feed.or(self.feed);
        Added::Point
    }

    /// Whether it has no point besides its start.
    pub(super) fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Feed of its latest type point that has one [mm/s].
    pub(super) fn feed(&self) -> Option<f64> {
        self.feed
    }

    /// Where it starts, its shape and attributes, and the blocks of its points; `None` where it
    /// never got one.
    pub(super) fn finish(self) -> Option<(DVec2, Shape, Attributes, Vec<Origin>)> {
        if self.points.is_empty() {
            return None;
        }
        let shape = SplineShape { points: self.points, ..SplineShape::default() };
        Some((self.start, Shape::Spline(shape), self.attributes, self.origins))
    }
}
