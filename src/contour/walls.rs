//! Which part of an open contour is the wall of a part, and which only runs in or out.
//!
//! Programs come to a part along an arc that touches it and leave it along another, or begin before a
//! corner and end behind it. What lies before the place where the contour closes, and what lies
//! behind it, is air to be cut.

use std::ops::Range;

use glam::DVec2;

use super::{Contour, Segment, Side};
use crate::geometry::intersect::{arc_arc, line_arc, line_line};
use crate::geometry::{Bounds, Curve, Line, MIN_LENGTH};

/// Chords of the closed part, as a part of its size.
const CHORD: f64 = 1e-4;

/// A place on a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    segment: usize,
    /// Parameter on it, in `[0, 1]`.
    t: f64,
}

/// From where to where an open contour is wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walls {
    from: Place,
    to: Place,
}

impl Walls {
    /// The most segments that run in, and the most that run out.
    pub const MOST: usize = 3;

    /// How near ends that are meant to touch come to each other [mm]: programs round to a micrometre
    /// or to a ten thousandth of an inch, and arcs to what their centres make of that.
    pub const TOUCH: f64 = 0.01;

    /// The walls of a contour whose tool is on a side; `None` where all of it is wall.
    ///
    /// One of its first and one of its last segments must meet; what then lies before and behind must
    /// lie where the tool is. What lies on the side of the part is a loop of the contour, and wall.
    #[must_use]
    pub fn of(contour: &Contour, side: Side) -> Option<Self> {
        let segments = contour.segments();
        if contour.is_closed() {
            return None;
        }
        // The shortest ways in and out first.
        for more in 0..2 * Self::MOST - 1 {
            for first in 0..=more {
                let (first, last) = (first, (segments.len() - 1).checked_sub(more - first)?);
                if first >= last {
                    continue;
                }
                let near = first < Self::MOST && more - first < Self::MOST;
                for [t, u] in near.then(|| meetings(segments, first, last)).into_iter().flatten() {
                    let from = Place { segment: first, t };
                    let walls = Self { from, to: Place { segment: last, t: u } };
                    if walls.is_beside_air(segments, side) {
                        return Some(walls);
                    }
                }
            }
        }
        None
    }

    /// The walls alone.
    #[must_use]
    pub fn alone(&self, contour: &Contour) -> Contour {
        let (whole, range) = self.split(contour.clone());
        Contour::of_segments(whole.segments[range].to_vec(), false, [None, None])
    }

    /// The first lap of an open contour that goes on along itself behind its start, as programs do so
    /// that no mark stays there; `None` where it ends at its start, or does not come by it.
    #[must_use]
    pub fn of_lap(contour: &Contour) -> Option<Self> {
        let segments = contour.segments();
        if contour.is_closed() || contour.end().distance(contour.start()) <= MIN_LENGTH {
            return None;
        }
        for (segment, last) in segments.iter().enumerate().rev().take(Self::MOST) {
            let nearest = last.curve.nearest(contour.start());
            if nearest.distance <= Self::TOUCH && (segment > 0 || nearest.t > 0.0) {
                let from = Place { segment: 0, t: 0.0 };
                return Some(Self { from, to: Place { segment, t: nearest.t } });
            }
        }
        None
    }

    /// The walls alone as a closed contour, with a line where their ends only touch.
    #[must_use]
    pub fn closed(&self, contour: &Contour) -> Contour {
        let mut closed = self.alone(contour);
        if let Ok(line) = Line::new(closed.end(), closed.start())
            && let Some(last) = closed.segments.last()
        {
            let attributes = last.attributes;
            closed.segments.push(Segment { curve: Curve::Line(line), attributes });
        }
        closed.closed = true;
        closed
    }

    /// The contour cut where its walls begin and end, and which of its segments are walls then.
    #[must_use]
    pub fn split(&self, contour: Contour) -> (Contour, Range<usize>) {
        let Self { from, to } = *self;
        let mut whole = contour;
        let mut range = from.segment + usize::from(from.t >= 1.0)..to.segment;
        if to.t > 0.0 {
            whole.cut(to);
            range.end += 1;
        }
        if from.t > 0.0 && from.t < 1.0 && whole.cut(from) {
            range = range.start + 1..range.end + 1;
        }
        (whole, range)
    }

    /// Whether what lies before and behind is something, and lies where the tool is.
    fn is_beside_air(&self, segments: &[Segment], side: Side) -> bool {
        let Self { from, to } = *self;
        let runs_in = from.segment > 0 || from.t > 0.0;
        let runs_out = to.segment + 1 < segments.len() || to.t < 1.0;
        if !runs_in && !runs_out {
            return false;
        }
        let outline = self.outline(segments);
        let is_round = 2.0 * signed_area(&outline);
        let in_air = |point: DVec2| {
            let inside = is_inside(&outline, point);
            inside == ((is_round > 0.0) == (side == Side::Left))
        };
        is_round != 0.0
            && (!runs_in || in_air(segments[0].curve.start()))
            && (!runs_out || in_air(segments[segments.len() - 1].curve.end()))
    }

    /// The walls as a polygon.
    fn outline(&self, segments: &[Segment]) -> Vec<DVec2> {
        let Self { from, to } = *self;
        let mut bounds = Bounds::EMPTY;
        for segment in &segments[from.segment..=to.segment] {
            bounds = bounds.union(segment.curve.bounds());
        }
        let chord = (CHORD * bounds.size().length()).max(MIN_LENGTH);
        let mut outline = vec![segments[from.segment].curve.point(from.t)];
        for (index, segment) in segments.iter().enumerate().take(to.segment + 1).skip(from.segment)
        {
            // Of the ends of the walls the points between are enough.
            let starts = if index == from.segment { from.t } else { 0.0 };
            let ends = if index == to.segment { to.t } else { 1.0 };
            if let Some(curve) = part(&segment.curve, starts, ends) {
                curve.flatten(chord, &mut |at| outline.push(at));
            }
        }
        outline
    }
}

impl Contour {
    /// Cuts a segment in two; whether it was.
    fn cut(&mut self, at: Place) -> bool {
        let Place { segment, t } = at;
        let halves = (
            part(&self.segments[segment].curve, 0.0, t),
            part(&self.segments[segment].curve, t, 1.0),
        );
        let (Some(first), Some(second)) = halves else { return false };
        let mut attributes = self.segments[segment].attributes;
        let [low, high] = attributes.heights;
        let share = first.length() / (first.length() + second.length());
        let middle = low + share * (high - low);
        attributes.heights = [middle, high];
        self.segments[segment].attributes.heights = [low, middle];
        self.segments[segment].curve = first;
        self.segments.insert(segment + 1, Segment { curve: second, attributes });
        for event in &mut self.events {
            event.before += usize::from(event.before > segment);
        }
        true
    }
}

/// Part of a curve; `None` where nothing is left of it.
fn part(curve: &Curve, from: f64, to: f64) -> Option<Curve> {
    if from >= to {
        return None;
    }
    let curve = if to >= 1.0 { curve.clone() } else { split(curve, to)?[0].clone() };
    if from <= 0.0 { Some(curve) } else { split(&curve, from / to.min(1.0)).map(|[_, last]| last) }
}

fn split(curve: &Curve, t: f64) -> Option<[Curve; 2]> {
    Some(match curve {
        Curve::Line(line) => {
            let (a, b) = line.split(t).ok()?;
            [Curve::Line(a), Curve::Line(b)]
        }
        Curve::Arc(arc) => {
            let (a, b) = arc.split(t).ok()?;
            [Curve::Arc(a), Curve::Arc(b)]
        }
        Curve::Spline(spline) => {
            let (a, b) = spline.split(t).ok()?;
            [Curve::Spline(a), Curve::Spline(b)]
        }
        Curve::Involute(involute) => {
            let (a, b) = (involute.part(0.0, t)?, involute.part(t, 1.0)?);
            [Curve::Involute(a), Curve::Involute(b)]
        }
    })
}

/// Where two segments meet: the parameters on both, by crossing or by touching at an end.
fn meetings(segments: &[Segment], first: usize, last: usize) -> Vec<[f64; 2]> {
    let (a, b) = (&segments[first].curve, &segments[last].curve);
    // Ends that meet come first: arcs that go on in each other may cross anywhere near.
    let mut places: Vec<[f64; 2]> = Vec::new();
    for t in [1.0, 0.0] {
        let nearest = b.nearest(a.point(t));
        if nearest.distance <= Walls::TOUCH {
            places.push([t, nearest.t]);
        }
    }
    for u in [0.0, 1.0] {
        let nearest = a.nearest(b.point(u));
        if nearest.distance <= Walls::TOUCH {
            places.push([nearest.t, u]);
        }
    }
    let crossings = match (a, b) {
        (Curve::Line(a), Curve::Line(b)) => line_line(a, b).points(),
        (Curve::Line(a), Curve::Arc(b)) => line_arc(a, b).points(),
        (Curve::Arc(a), Curve::Line(b)) => line_arc(b, a).exchanged().points(),
        (Curve::Arc(a), Curve::Arc(b)) => arc_arc(a, b).points(),
        _ => Vec::new(),
    };
    for crossing in crossings {
        places.push([crossing.t, crossing.u]);
    }
    for place in &mut places {
        // Nothing shorter than what counts as a touch is cut off.
        for (at, length) in place.iter_mut().zip([a.length(), b.length()]) {
            if *at * length <= Walls::TOUCH {
                *at = 0.0;
            } else if (1.0 - *at) * length <= Walls::TOUCH {
                *at = 1.0;
            }
        }
    }
    // Where one follows the other they meet anyway.
    places.retain(|place| last > first + 1 || *place != [1.0, 0.0]);
    places
}

fn signed_area(polygon: &[DVec2]) -> f64 {
    let mut area = 0.0;
    let mut before = polygon[polygon.len() - 1] - polygon[0];
    for &point in polygon {
        let point = point - polygon[0];
        area += 0.5 * before.perp_dot(point);
        before = point;
    }
    area
}

/// Whether a point lies in a polygon, by the crossings of a ray along x.
fn is_inside(polygon: &[DVec2], at: DVec2) -> bool {
    let mut inside = false;
    let mut before = polygon[polygon.len() - 1];
    for &point in polygon {
        if (before.y > at.y) != (point.y > at.y) {
            let x = before.x + (at.y - before.y) / (point.y - before.y) * (point.x - before.x);
            inside ^= x > at.x;
        }
        before = point;
    }
    inside
}
