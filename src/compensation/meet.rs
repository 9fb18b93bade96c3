//! Where two moves meet, whatever they are.

use crate::contour::MoveCurve;
use crate::geometry::intersect::{
    Intersections, arc_arc, arc_cubic, cubic_cubic, involute_with, line_arc, line_cubic, line_line,
};

/// Where two moves meet in the plane.
pub(super) fn meet(a: &MoveCurve, b: &MoveCurve) -> Intersections {
    use MoveCurve::{Arc, Cubic, Involute, Line, Vertical};
    match (a, b) {
        (Vertical(_), _) | (_, Vertical(_)) => Intersections::Points(Vec::new()),
        (Line(a), Line(b)) => line_line(a, b),
        (Line(a), Arc(b)) => line_arc(a, b),
        (Arc(a), Line(b)) => line_arc(b, a).exchanged(),
        (Arc(a), Arc(b)) => arc_arc(a, b),
        (Line(a), Cubic(b)) => line_cubic(a, b),
        (Cubic(a), Line(b)) => line_cubic(b, a).exchanged(),
        (Arc(a), Cubic(b)) => arc_cubic(a, b),
        (Cubic(a), Arc(b)) => arc_cubic(b, a).exchanged(),
        (Cubic(a), Cubic(b)) => cubic_cubic(a, b),
        (Involute(a), b) => involute_with(a, &b.hull_bounds(), &|cubic| meet(&Cubic(*cubic), b)),
        (a, Involute(b)) => {
            involute_with(b, &a.hull_bounds(), &|cubic| meet(&Cubic(*cubic), a)).exchanged()
        }
    }
}
