//! What the tool cannot reach: the material between the contour and the tool where it turns away.
//!
//! A stretch of the contour whose offset was cut out begins and ends at crossings, where the tool
//! touches the contour in two places. Its region runs along the contour from the first of them to
//! the second and back along the tool. At a bottleneck the tool turns away before it and comes from
//! beyond it, so two stretches, and the tool in two places, bound one region.

use glam::DVec2;

use super::cuts::Arc as Cut;
use super::strands::Piece;
use crate::compensation::run::Run;
use crate::contour::{Tool, Uncut};
use crate::geometry::{Arc, Curve, cross, flatten_arc, flatten_cubic};

/// A stretch of successive arcs that were cut out.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    /// The crossings where the tool leaves the strand and where it comes back.
    places: [usize; 2],
    /// The tool centres there [mm].
    centers: [DVec2; 2],
    /// The runs that the tool touches there.
    runs: [usize; 2],
    /// The parameters of the places it touches, where they are corners.
    touches: [Option<f64>; 2],
}

/// The regions that are not reached, as far as the cut-out stretches bound them.
pub(super) fn uncut(
    runs: &[Run],
    pieces: &[Piece],
    arcs: &[Cut],
    clear: &[bool],
    tool: Tool,
    tolerance: f64,
) -> Vec<Uncut> {
    let stretches = stretches(pieces, arcs, clear);
    let mut used = vec![false; stretches.len()];
    let mut regions = Vec::new();
    for first in 0..stretches.len() {
        let mut region = Uncut { outline: Vec::new(), area: 0.0, segments: Vec::new() };
        let mut current = first;
        while !used[current] {
            used[current] = true;
            let stretch = &stretches[current];
            let feet = follow(runs, stretch, tolerance, &mut region);
            let Some(next) = stretches.iter().position(|s| s.places[0] == stretch.places[1]) else {
                break;
            };
            let ahead = foot(runs, &stretches[next], 0).1;
            along_tool(stretch.centers[1], feet, ahead, tool, tolerance, &mut region.outline);
            current = next;
        }
        region.area = area(&region.outline);
        // Thinner than the tolerance all along: nothing that anybody would miss.
        let around: f64 =
            region.outline.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>();
        if current == first && region.area > 0.5 * tolerance * around {
            regions.push(region);
        }
    }
    regions
}

/// The cut-out stretches with a crossing at both ends, in order.
fn stretches(pieces: &[Piece], arcs: &[Cut], clear: &[bool]) -> Vec<Stretch> {
    let count = arcs.len();
    let mut stretches = Vec::new();
    for k in 0..count {
        let before = if k > 0 { k - 1 } else { count - 1 };
        if clear[k] || !clear[before] {
            continue;
        }
        // From the first arc after a clear one to the last before the next clear one.
        let length = (0..count).take_while(|&n| !clear[(k + n) % count]).count();
        let last = (k + length - 1) % count;
        let (start, end) = (&arcs[k], &arcs[last]);
        if let (Some(from), Some(to)) = (start.start, end.end) {
            stretches.push(Stretch {
                places: [from, to],
                centers: [
                    pieces[start.piece].curve.point(start.from),
                    pieces[end.piece].curve.point(end.to),
                ],
                runs: [pieces[start.piece].run, pieces[end.piece].run],
                touches: [pieces[start.piece].touches, pieces[end.piece].touches],
            });
        }
    }
    stretches
}

/// Where the tool touches the contour at an end of a stretch: parameter and point.
fn foot(runs: &[Run], stretch: &Stretch, end: usize) -> (f64, DVec2) {
    let curve = &runs[stretch.runs[end]].segment.curve;
    if let Some(t) = stretch.touches[end] {
        return (t, curve.point(t));
    }
    let nearest = curve.nearest(stretch.centers[end]);
    (nearest.t, nearest.point)
}

/// Appends the contour along a stretch; returns the foot at its end.
fn follow(runs: &[Run], stretch: &Stretch, tolerance: f64, region: &mut Uncut) -> DVec2 {
    let [(from, start), (to, end)] = [foot(runs, stretch, 0), foot(runs, stretch, 1)];
    let mut run = stretch.runs[0];
    region.outline.push(start);
    let mut t = from;
    loop {
        let segment = runs[run].segment;
        if !region.segments.contains(&segment.attributes.origin) {
            region.segments.push(segment.attributes.origin);
        }
        let done = run == stretch.runs[1] && (to >= t || run != stretch.runs[0]);
        append(&segment.curve, t, if done { to } else { 1.0 }, tolerance, &mut region.outline);
        if done {
            return end;
        }
        (run, t) = ((run + 1) % runs.len(), 0.0);
    }
}

/// Appends points of a curve between two parameters, after the first.
fn append(curve: &Curve, from: f64, to: f64, tolerance: f64, outline: &mut Vec<DVec2>) {
    match curve {
        Curve::Line(line) => outline.push(line.point(to)),
        Curve::Arc(arc) => {
            let part = Arc::from_sweep(arc.point(from), arc.center(), arc.sweep() * (to - from));
            if let Ok(part) = part {
                flatten_arc(&part, tolerance, &mut |point| outline.push(point));
            }
        }
        Curve::Spline(spline) => {
            let ((first, t0), (last, t1)) = (spline.locate(from), spline.locate(to));
            for span in first..=last {
                let start = if span == first { t0 } else { 0.0 };
                let end = if span == last { t1 } else { 1.0 };
                let part = spline.pieces()[span].part(start, end);
                flatten_cubic(&part, tolerance, &mut |point| outline.push(point));
            }
        }
    }
}

/// Appends the side of the tool from one foot back to another, on the side of the contour.
fn along_tool(
    center: DVec2,
    from: DVec2,
    to: DVec2,
    tool: Tool,
    tolerance: f64,
    outline: &mut Vec<DVec2>,
) {
    // The contour runs counter-clockwise about a tool on its left, and the way back clockwise.
    let clockwise = tool.side().sign() > 0.0;
    if let Ok(arc) = Arc::from_center(from, to, center, clockwise, f64::INFINITY) {
        flatten_arc(&arc, tolerance, &mut |point| outline.push(point));
    }
}

/// Area of a closed outline [mm²] (shoelace formula).
fn area(outline: &[DVec2]) -> f64 {
    let Some(&origin) = outline.first() else { return 0.0 };
    let doubled: f64 =
        outline.windows(2).map(|pair| cross(pair[0] - origin, pair[1] - origin)).sum();
    0.5 * doubled.abs()
}
