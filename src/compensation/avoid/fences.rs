//! Where a tool beside the contour becomes too near to its other side, or to a free end of it.
//!
//! The places at the tool's radius on the other side, and round free ends, cut the raw path, but the
//! tool never follows them. Only what may be near to a path is looked at.

use glam::DVec2;

use super::tree::{Node, OrderTree, Range};
use super::units::{Kind, Workpiece, corner_arc, corner_of};
use crate::compensation::offset::{ArcOffset, offset_arc, offset_line, offset_span};
use crate::contour::{Corner, MoveCurve};
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
    // All are of one radius.
    let offset = work.jobs[0].tool.offset();
    let both = work.jobs.iter().any(|job| job.tool.offset() != offset);
    let meets = |node: &Node| {
        let beside = |offset: f64| open.meets(&beside(node, -offset));
        beside(offset) || both && beside(-offset)
    };
    tree.each(&meets, &mut |unit| {
        if work.units[unit].kind == Kind::Segment {
            let offset = work.jobs[work.units[unit].job as usize].tool.offset();
            curves.clear();
            other_side(work, unit, -offset, tolerance, &mut curves);
            curves.iter().for_each(&mut *visit);
        }
    });
    for (job, range) in work.jobs.iter().zip(&work.ranges) {
        let offset = job.tool.offset();
        for unit in range.from..range.to {
            if let Some(corner) = inside_corner(work, unit, *range)
                && open.meets(&Bounds::of([corner.point]).inflated(offset.abs()))
            {
                let [n1, n2] = [corner.incoming, corner.outgoing]
                    .map(|tangent| corner.point - perp(tangent) * offset);
                corner_arc(n1, n2, &corner, offset < 0.0).iter().for_each(&mut *visit);
            }
        }
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

/// A box around what lies by `offset` beside the contour of a node.
fn beside(node: &Node, offset: f64) -> Bounds {
    let normals = node.octants.left_normals();
    let (a, b) = (normals.min * offset, normals.max * offset);
    Bounds { min: node.contour.min + a.min(b), max: node.contour.max + a.max(b) }
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

/// The inside corner that a unit of a contour is: an outside corner seen from the other side.
fn inside_corner(work: &Workpiece, unit: usize, range: Range) -> Option<Corner> {
    let Range { from, to, closed } = range;
    if work.units[unit].kind != Kind::Break {
        return None;
    }
    let before = if unit > from { unit - 1 } else { closed.then(|| to - 1)? };
    let after = if unit + 1 < to { unit + 1 } else { closed.then_some(from)? };
    Some(corner_of(&work.curve(before)?, &work.curve(after)?))
}
