//! Where a tool beside the contour becomes too near to its other side, or to a free end of it.
//!
//! The places at the tool's radius on the other side, and round free ends, cut the raw path, but the
//! tool never follows them. Only what may be near to a path is looked at.

use glam::DVec2;

use super::tree::{OrderTree, Range};
use super::units::{Kind, Workpiece, corner_arc, corner_of};
use crate::compensation::offset::{ArcOffset, offset_arc, offset_line, offset_span};
use crate::contour::MoveCurve;
use crate::geometry::{Arc, Bounds, BoxTree, perp};

/// Calls `visit` with every fence that may meet a box of `open`; those of splines are off by at most
/// `tolerance` [mm].
pub(super) fn each_fence(
    work: &Workpiece,
    tree: &OrderTree,
    open: &BoxTree,
    tolerance: f64,
    visit: &mut dyn FnMut(&MoveCurve),
) {
    let mut curves = Vec::new();
    for unit in 0..work.units.len() {
        if work.units[unit].kind != Kind::Segment {
            continue;
        }
        let node = tree.unit(unit);
        let offset = work.jobs[work.units[unit].job as usize].tool.offset();
        let beside = node.octants.left_normals();
        let (a, b) = (beside.min * -offset, beside.max * -offset);
        let around = Bounds { min: node.contour.min + a.min(b), max: node.contour.max + a.max(b) };
        if open.meets(&around) {
            curves.clear();
            other_side(work, unit, -offset, tolerance, &mut curves);
            curves.iter().for_each(&mut *visit);
        }
        for corner in corners_beside(work, unit) {
            let circle = Bounds::of([corner.point]).inflated(offset.abs());
            if open.meets(&circle) {
                let [n1, n2] = [corner.incoming, corner.outgoing]
                    .map(|tangent| corner.point - perp(tangent) * offset);
                corner_arc(n1, n2, &corner, offset < 0.0).iter().for_each(&mut *visit);
            }
        }
    }
    for (job, range) in work.jobs.iter().zip(&work.ranges) {
        // The walls of a contour that runs over meet.
        if range.closed || job.runs_over() {
            continue;
        }
        let radius = job.tool.radius();
        for end in [job.contour.start(), job.contour.end()] {
            let from = end + DVec2::X * radius;
            if open.meets(&Bounds::of([end]).inflated(radius))
                && let Ok(circle) = Arc::from_sweep(from, end, std::f64::consts::TAU)
            {
                visit(&MoveCurve::Arc(circle));
            }
        }
    }
}

/// The offset of a unit to its other side.
fn other_side(
    work: &Workpiece,
    unit: usize,
    offset: f64,
    tolerance: f64,
    curves: &mut Vec<MoveCurve>,
) {
    match work.curve(unit) {
        Some(MoveCurve::Line(line)) => {
            curves.extend(offset_line(&line, offset).map(MoveCurve::Line));
        }
        Some(MoveCurve::Arc(arc)) => match offset_arc(&arc, offset) {
            ArcOffset::Arc(arc) | ArcOffset::Reversed(arc, _) => {
                curves.push(MoveCurve::Arc(arc));
            }
            ArcOffset::Point => {}
        },
        Some(MoveCurve::Cubic(cubic)) => {
            offset_span(&cubic, offset, tolerance, None, curves, &mut |_, _| {});
        }
        Some(MoveCurve::Involute(_) | MoveCurve::Vertical(_)) | None => {}
    }
}

/// The inside corners at both ends of a unit: outside corners seen from the other side.
fn corners_beside(work: &Workpiece, unit: usize) -> Vec<crate::contour::Corner> {
    let Range { from, to, closed } = work.range_of(unit);
    let is_break = |at: usize| work.units[at].kind == Kind::Break;
    let after = |at: usize| if at + 1 < to { Some(at + 1) } else { closed.then_some(from) };
    let before = |at: usize| if at > from { Some(at - 1) } else { closed.then(|| to - 1) };
    let mut corners = Vec::new();
    for ahead in [true, false] {
        let step = |at: usize| if ahead { after(at) } else { before(at) };
        if let Some(gap) = step(unit).filter(|&at| is_break(at))
            && let Some(other) = step(gap)
            && let [Some(incoming), Some(outgoing)] =
                (if ahead { [unit, other] } else { [other, unit] }).map(|at| work.curve(at))
        {
            corners.push(corner_of(&incoming, &outgoing));
        }
    }
    corners
}
