//! Outlines of glyphs and icons as contours, and as polygons for Clipper2.

use clipper2_rust::{
    EndType, FillRule, JoinType, PathD, PathsD, Point, area, inflate_paths_d, union_subjects_d,
};
use g41::compensation::{CornerStyle, Options, avoid_all};
use g41::contour::{Attributes, Contour, ContourBuilder, Shape, Side, SplineShape, Tool, ToolPath};
use g41::diagnostic::Origin;
use g41::geometry::{Curve, flatten_cubic};
use g41::gouge::check;
use glam::DVec2;
use kurbo::{BezPath, ParamCurve, ParamCurveDeriv, PathSeg, Shape as _};

/// Tolerance of the path, of the polygon, and of Clipper2's arcs [mm].
pub const TOLERANCE: f64 = 1e-3;

/// Spans of the spline that stands for one Bézier segment.
const SPANS: u32 = 8;

/// An outline: contours with the material on their right.
#[derive(Debug)]
pub struct Outline {
    pub name: String,
    pub contours: Vec<Contour>,
    pub polygon: PathsD,
}

/// What comes of offsetting an outline by g41 and by Clipper2.
#[derive(Debug, Clone, Copy)]
pub struct Compared {
    /// Areas of the offset regions [mm²].
    pub areas: [f64; 2],
    /// How much they may differ for the tolerances [mm²].
    pub allowed: f64,
    /// Pieces of the path that do not end where they start.
    pub open: usize,
    /// Depth of the deepest gouge that the judge finds [mm].
    pub gouge: f64,
}

/// Why an outline is not compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refused {
    /// There is nothing to offset: a space.
    Empty,
    /// Its contours cross or overlap, so that they are not the boundary of what is filled.
    Overlapping,
}

impl Outline {
    /// The outline of a path whose extent becomes `size` [mm].
    ///
    /// # Errors
    /// [`Refused`] where its contours are not the boundary of a region.
    pub fn new(name: &str, path: &BezPath, size: f64) -> Result<Self, Refused> {
        let bounds = path.bounding_box();
        let scale = size / bounds.width().max(bounds.height());
        if !scale.is_finite() {
            return Err(Refused::Empty);
        }
        let scaled = kurbo::Affine::scale(scale) * path.clone();
        let parts: Vec<BezPath> = subpaths(&scaled);
        let polygons: Vec<PathD> =
            parts.iter().filter_map(contour).map(|contour| polygon(&contour)).collect();
        let mut contours = Vec::new();
        for (index, part) in parts.iter().filter(|part| contour(part).is_some()).enumerate() {
            let here = &polygons[index];
            let inside =
                |(other, around): (usize, &PathD)| other != index && holds(around, here[0]);
            let is_hole = polygons.iter().enumerate().filter(|p| inside(*p)).count() % 2 == 1;
            // Material on the right: clockwise round it, counter-clockwise in holes.
            let turned = (area(here) > 0.0) != is_hole;
            let part = if turned { part.reverse_subpaths() } else { part.clone() };
            contours.extend(contour(&part));
        }
        let polygon: PathsD = contours.iter().map(polygon).collect();
        // With the area of the boundary on the wrong side the fill is not what the contours bound.
        let bounded = -polygon.iter().map(area).sum::<f64>();
        let filled = |rule| union_subjects_d(&polygon, rule, 6).iter().map(area).sum::<f64>();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-4 * (a.abs() + b.abs());
        if contours.is_empty() {
            return Err(Refused::Empty);
        }
        // In two ways: crossing contours may have the same area by chance in one of them.
        if !near(bounded, filled(FillRule::EvenOdd)) || !near(bounded, filled(FillRule::Negative)) {
            return Err(Refused::Overlapping);
        }
        Ok(Self { name: name.into(), contours, polygon })
    }

    /// Offset by `distance` [mm], away from the material where positive.
    #[must_use]
    pub fn compared(&self, distance: f64) -> Compared {
        let side = if distance > 0.0 { Side::Left } else { Side::Right };
        let tool = Tool::new(distance.abs(), side).expect("a radius");
        let options =
            Options { tolerance: TOLERANCE, corner: CornerStyle::Arc, ..Options::default() };
        let jobs: Vec<_> = self.contours.iter().map(|contour| (contour, tool)).collect();
        let path = avoid_all(&jobs, &options);
        let gouges = self
            .contours
            .iter()
            .flat_map(|contour| check(contour, &path, distance.abs(), TOLERANCE))
            .map(|gouge| gouge.depth);
        let (ours, around) = enclosed(&path);
        let outer: PathsD =
            self.polygon.iter().map(|path| path.iter().rev().copied().collect()).collect();
        let theirs =
            inflate_paths_d(&outer, distance, JoinType::Round, EndType::Polygon, 2.0, 6, TOLERANCE);
        let perimeter = theirs.iter().map(length).sum::<f64>().max(around);
        Compared {
            areas: [-ours, theirs.iter().map(area).sum()],
            // The path, its flattening, the polygon and Clipper2's arcs.
            allowed: 4.0 * TOLERANCE * perimeter + 1e-6,
            open: open_pieces(&path),
            gouge: gouges.fold(0.0, f64::max),
        }
    }
}

/// Area of the offset region by counting the points of a grid: the third opinion where two differ.
#[must_use]
pub fn counted(outline: &Outline, distance: f64) -> f64 {
    const STEP: f64 = 0.1;
    let edges: Vec<[DVec2; 2]> = outline
        .polygon
        .iter()
        .flat_map(|path| path.iter().zip(path.iter().skip(1).chain(path.first())))
        .map(|(a, b)| [DVec2::new(a.x, a.y), DVec2::new(b.x, b.y)])
        .collect();
    let low = edges.iter().fold(DVec2::INFINITY, |low, [a, _]| low.min(*a)) - distance.abs();
    let high = edges.iter().fold(DVec2::NEG_INFINITY, |high, [a, _]| high.max(*a)) + distance.abs();
    let mut count = 0_u32;
    let mut y = low.y + 0.37 * STEP;
    while y < high.y {
        let mut x = low.x + 0.61 * STEP;
        while x < high.x {
            let point = DVec2::new(x, y);
            let inside =
                outline.polygon.iter().filter(|path| holds(path, Point { x, y })).count() % 2 == 1;
            let is_far = |reach: f64| {
                edges.iter().all(|[a, b]| {
                    let along = *b - *a;
                    let t = ((point - *a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                    point.distance_squared(*a + along * t) > reach * reach
                })
            };
            let within = if distance > 0.0 {
                inside || !is_far(distance)
            } else {
                inside && is_far(-distance)
            };
            count += u32::from(within);
            x += STEP;
        }
        y += STEP;
    }
    f64::from(count) * STEP * STEP
}

fn open_pieces(path: &ToolPath) -> usize {
    let mut open = 0;
    let Some(first) = path.moves.first() else { return 0 };
    let mut start = first.curve.start();
    for (index, one) in path.moves.iter().enumerate() {
        let end = one.curve.end();
        let next = path.moves.get(index + 1).map(|next| next.curve.start());
        if next.is_none_or(|next| next.distance(end) > 1e-6) {
            open += usize::from(end.distance(start) > TOLERANCE);
            start = next.unwrap_or(end);
        }
    }
    open
}

/// Signed area and length of a path, from its pieces.
fn enclosed(path: &ToolPath) -> (f64, f64) {
    let (mut doubled, mut around) = (0.0, 0.0);
    for one in &path.moves {
        let mut from = one.curve.start();
        one.curve.flatten(TOLERANCE, &mut |to| {
            doubled += from.perp_dot(to);
            around += from.distance(to);
            from = to;
        });
    }
    (0.5 * doubled, around)
}

fn length(path: &PathD) -> f64 {
    let ends = path.iter().skip(1).chain(path.first());
    path.iter().zip(ends).map(|(a, b)| (b.x - a.x).hypot(b.y - a.y)).sum()
}

/// Whether a point is inside a polygon, by the crossings of a ray.
fn holds(polygon: &PathD, point: Point<f64>) -> bool {
    let ends = polygon.iter().skip(1).chain(polygon.first());
    let crosses = |(a, b): &(&Point<f64>, &Point<f64>)| {
        (a.y > point.y) != (b.y > point.y)
            && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)
    };
    polygon.iter().zip(ends).filter(crosses).count() % 2 == 1
}

fn subpaths(path: &BezPath) -> Vec<BezPath> {
    let mut parts: Vec<BezPath> = Vec::new();
    for element in path.elements() {
        if matches!(element, kurbo::PathEl::MoveTo(_)) {
            parts.push(BezPath::new());
        }
        if let Some(part) = parts.last_mut() {
            part.push(*element);
        }
    }
    for part in &mut parts {
        if !matches!(part.elements().last(), Some(kurbo::PathEl::ClosePath)) {
            part.close_path();
        }
    }
    parts
}

/// A closed contour of one subpath: lines, and splines through points of its curves.
fn contour(path: &BezPath) -> Option<Contour> {
    let vector = |p: kurbo::Point| DVec2::new(p.x, p.y);
    let first = path.segments().next().map(|segment| vector(segment.start()))?;
    let mut builder = ContourBuilder::new(first);
    let mut at = first;
    let mut index = 0;
    for segment in path.segments() {
        let mut to = vector(segment.end());
        // The end may miss the start by rounding.
        if to.distance(first) < 1e-6 {
            to = first;
        }
        let control_length = segment.to_cubic().p1.distance(segment.start())
            + segment.to_cubic().p2.distance(segment.end());
        if at.distance(to) < 1e-6 && control_length < 1e-6 {
            continue;
        }
        let shape = match segment {
            PathSeg::Line(_) => Shape::Line { to },
            PathSeg::Quad(_) | PathSeg::Cubic(_) => {
                let cubic = segment.to_cubic();
                let mut points: Vec<DVec2> = (1..SPANS)
                    .map(|k| vector(cubic.eval(f64::from(k) / f64::from(SPANS))))
                    .collect();
                points.push(to);
                let ahead = |t: f64| {
                    let derivative = vector(cubic.deriv().eval(t).to_vec2().to_point());
                    (derivative.length() > 1e-6).then_some(derivative)
                };
                let (start_tangent, end_tangent) = (ahead(0.0), ahead(1.0));
                Shape::Spline(SplineShape {
                    points,
                    start_tangent,
                    end_tangent,
                    ..SplineShape::default()
                })
            }
        };
        builder.segment(shape, Attributes::at(Origin::Segment(index)));
        (at, index) = (to, index + 1);
    }
    let built = builder.build(true).contour?;
    (built.is_closed() && index > 1).then_some(built)
}

/// A contour as a polygon within the tolerance.
fn polygon(contour: &Contour) -> PathD {
    let mut points = vec![contour.start()];
    for segment in contour.segments() {
        match &segment.curve {
            Curve::Line(line) => points.push(line.end()),
            Curve::Spline(spline) => {
                for piece in spline.pieces() {
                    flatten_cubic(piece, TOLERANCE, &mut |point| points.push(point));
                }
            }
            Curve::Arc(_) | Curve::Involute(_) => {}
        }
    }
    points.pop();
    points.into_iter().map(|p| Point { x: p.x, y: p.y }).collect()
}
