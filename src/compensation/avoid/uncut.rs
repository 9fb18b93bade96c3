//! What the tool cannot reach: the material between the contour and the tool where it turns away.
//!
//! A gap between two stretches of a contour's raw path begins and ends at crossings, where the tool
//! touches the contour in two places. Its region runs along the contour from the first of them to
//! the second and back along the tool. At a bottleneck the tool turns away before it and comes from
//! beyond it, so two gaps, and the tool in two places, bound one region.

use glam::DVec2;

use super::cuts::{Stretch, following};
use super::units::Workpiece;
use crate::contour::{MoveCurve, Tool, Uncut};
use crate::geometry::{Arc, cross, flatten_arc, flatten_cubic, sort_pairs};

/// What was left out between two stretches of one contour that follow each other.
#[derive(Debug, Clone, Copy)]
struct Gap {
    /// The crossings where the tool leaves the contour and where it comes back.
    places: [u32; 2],
    /// The tool centres there [mm].
    centers: [DVec2; 2],
    /// The units that the tool touches there.
    units: [usize; 2],
}

/// A region in the making.
#[derive(Debug, Default)]
struct Region {
    outline: Vec<DVec2>,
    /// Contours and segments along it.
    segments: Vec<(u32, usize)>,
}

/// The regions that are not reached, as far as gaps bound them.
pub(super) fn uncut(
    work: &Workpiece,
    stretches: &[Stretch],
    tool: Tool,
    tolerance: f64,
) -> Vec<Uncut> {
    let gaps = gaps(work, stretches);
    let mut by_start = Vec::with_capacity(gaps.len());
    for (k, gap) in gaps.iter().enumerate() {
        by_start.push((gap.places[0], k));
    }
    sort_pairs(&mut by_start);
    let mut used = vec![false; gaps.len()];
    let mut regions = Vec::new();
    let mut region = Region::default();
    for first in 0..gaps.len() {
        if used[first] {
            continue;
        }
        region.outline.clear();
        region.segments.clear();
        let mut current = first;
        let begins = foot(work, &gaps[first], 0);
        let mut start = begins;
        let closed = loop {
            used[current] = true;
            let gap = &gaps[current];
            let end = follow(work, gap, start, tolerance, &mut region);
            let from = by_start.partition_point(|&(place, _)| place < gap.places[1]);
            let mut here = by_start[from..].iter().take_while(|(at, _)| *at == gap.places[1]);
            let Some(&(_, next)) = here.find(|&&(_, k)| !used[k] || k == first) else {
                break false;
            };
            start = if next == first { begins } else { foot(work, &gaps[next], 0) };
            along_tool(gap.centers[1], end, start.1, tool, tolerance, &mut region.outline);
            if next == first {
                break true;
            }
            current = next;
        };
        if closed {
            regions.extend(region.finished(work, tolerance));
        }
    }
    regions
}

/// The inside of a closed contour along which the tool fits nowhere.
pub(super) fn uncut_inside(work: &Workpiece, job: usize, tolerance: f64) -> Option<Uncut> {
    let range = work.ranges[job];
    let mut region = Region::default();
    region.outline.push(work.jobs[job].contour.start());
    for unit in range.from..range.to {
        region.along(work, unit, [0.0, 1.0], tolerance);
    }
    let is_inside = doubled_area(&region.outline) * work.jobs[job].tool.offset() > 0.0;
    if range.closed && is_inside { region.finished(work, tolerance) } else { None }
}

impl Region {
    /// Appends the contour along part of a unit.
    fn along(&mut self, work: &Workpiece, unit: usize, [from, to]: [f64; 2], tolerance: f64) {
        let of = &work.units[unit];
        let segment = (of.job, of.segment as usize);
        if self.segments.last() != Some(&segment) {
            self.segments.push(segment);
        }
        let outline = &mut self.outline;
        match work.curve(unit) {
            Some(MoveCurve::Line(line)) => outline.push(line.point(to)),
            Some(MoveCurve::Arc(arc)) => {
                let part =
                    Arc::from_sweep(arc.point(from), arc.center(), arc.sweep() * (to - from));
                if let Ok(part) = part {
                    flatten_arc(&part, tolerance, &mut |point| outline.push(point));
                }
            }
            Some(MoveCurve::Cubic(cubic)) => {
                flatten_cubic(&cubic.part(from, to), tolerance, &mut |point| outline.push(point));
            }
            Some(MoveCurve::Involute(_) | MoveCurve::Vertical(_)) | None => {}
        }
    }

    /// The region, unless it is thinner than the tolerance all along: nothing anybody would miss.
    fn finished(&mut self, work: &Workpiece, tolerance: f64) -> Option<Uncut> {
        let area = 0.5 * doubled_area(&self.outline).abs();
        let around: f64 = self.outline.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        if area <= 0.5 * tolerance * around {
            return None;
        }
        sort_pairs(&mut self.segments);
        let mut segments = Vec::new();
        let mut last = None;
        for &(job, segment) in &self.segments {
            if last != Some((job, segment)) {
                last = Some((job, segment));
                let segments_of = work.jobs[job as usize].contour.segments();
                segments.push(segments_of[segment].attributes.origin);
            }
        }
        Some(Uncut { outline: self.outline.clone(), area, segments })
    }
}

/// The gaps with a crossing at both ends, in order.
fn gaps(work: &Workpiece, stretches: &[Stretch]) -> Vec<Gap> {
    let mut gaps = Vec::new();
    let mut from = 0;
    for range in &work.ranges {
        let pieces = work.pieces_of_range(*range);
        let to = from + stretches[from..].partition_point(|s| s.piece < pieces.end);
        for k in from..to {
            let next = if k + 1 < to { k + 1 } else { from };
            if next <= k && !range.closed || following(work, stretches, k) == Some(next) {
                continue;
            }
            let (a, b) = (&stretches[k], &stretches[next]);
            if let (Some(leaves), Some(returns)) = (a.end, b.start) {
                let (last, first) = (&work.pieces[a.piece], &work.pieces[b.piece]);
                gaps.push(Gap {
                    places: [leaves, returns],
                    centers: [last.curve.point(a.to), first.curve.point(b.from)],
                    units: [last.unit as usize, first.unit as usize],
                });
            }
        }
        from = to;
    }
    gaps
}

/// Where the tool touches the contour at an end of a gap: parameter on the unit, and point.
fn foot(work: &Workpiece, gap: &Gap, end: usize) -> (f64, DVec2) {
    let center = gap.centers[end];
    work.curve(gap.units[end]).map_or((0.0, center), |curve| {
        let nearest = curve.nearest(center);
        (nearest.t, nearest.point)
    })
}

/// Appends the contour along a gap from the foot at its start; returns the one at its end.
fn follow(
    work: &Workpiece,
    gap: &Gap,
    (from, start): (f64, DVec2),
    tolerance: f64,
    region: &mut Region,
) -> DVec2 {
    let (to, end) = foot(work, gap, 1);
    let [first, last] = gap.units;
    let range = work.range_of(first);
    let mut unit = first;
    region.outline.push(start);
    // The end lies behind the start on the same unit: once round the contour.
    let mut round = first == last && to < from;
    let mut t = from;
    loop {
        let done = unit == last && !round;
        region.along(work, unit, [t, if done { to } else { 1.0 }], tolerance);
        if done {
            return end;
        }
        round = false;
        unit = if unit + 1 < range.to { unit + 1 } else { range.from };
        t = 0.0;
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

/// Twice the signed area of a closed outline [mm²] (shoelace formula).
fn doubled_area(outline: &[DVec2]) -> f64 {
    let Some(&origin) = outline.first() else { return 0.0 };
    outline.windows(2).map(|pair| cross(pair[0] - origin, pair[1] - origin)).sum()
}
