//! Telling the user where the tool does not fit: gouges with segment, point and depth.

use glam::DVec2;

use super::offset::Bend;
use crate::contour::{Gouge, GougeKind, MoveCurve, Segment, Tool, ToolPath};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::Decimal;

/// Places on each move at which its distance from the contour is measured.
const DEPTH_SAMPLES: usize = 16;

/// Reports a stretch that bends tighter than the tool.
pub(super) fn bend(path: &mut ToolPath, bend: &Bend, origin: Origin, tool: Tool) {
    let message = format!(
        "the contour bends to a radius of {} mm, tighter than the tool ({} mm); the path cuts {} mm too deep",
        Decimal::of(bend.radius),
        Decimal::of(tool.radius()),
        Decimal::of(bend.depth)
    );
    let hint = format!("use a tool radius of at most {} mm", Decimal::of(bend.radius));
    gouge(
        path,
        "curvature-gouge",
        message,
        hint,
        bend.at,
        bend.depth,
        GougeKind::Curvature,
        &[origin],
    );
}

/// A bend as `moves`, what corners have left of its offset, cut it: not at all where they have cut
/// it away, and deeper where they reach into a neighbour too.
pub(super) fn as_cut(
    bend: &Bend,
    moves: &[MoveCurve],
    segment: &Segment,
    around: &[&Segment],
    tool: Tool,
    tolerance: f64,
) -> Bend {
    let at_bend = |segment: &Segment| {
        let ends = [segment.curve.start(), segment.curve.end()];
        ends.into_iter().any(|end| end.distance(bend.at) <= 2.0 * tool.radius())
    };
    let mut cut = *bend;
    // Far from its ends nothing is cut away, and nothing else is near.
    if !at_bend(segment) {
        return cut;
    }
    let near = moves_near(moves, bend, tool);
    // The path is within the tolerance of the offset, and both are rounded.
    let touches = |piece: &MoveCurve| {
        piece.hull_bounds().distance(bend.center) <= 2.0 * tolerance
            && piece.nearest(bend.center).distance <= 2.0 * tolerance
    };
    if !near.iter().any(touches) {
        (cut.depth, cut.at) = depth_of(&near, &[segment], tool, bend.at);
    }
    for other in around.iter().filter(|other| at_bend(other)) {
        let (depth, at) = depth_of(&near, &[*other], tool, bend.at);
        if depth > cut.depth {
            (cut.depth, cut.at) = (depth, at);
        }
    }
    cut
}

/// A bend as the spline through moved type points cuts it: about as the true offset does.
pub(super) fn as_moved(bend: &Bend, moves: &[MoveCurve], segment: &Segment, tool: Tool) -> Bend {
    let (depth, at) = depth_of(&moves_near(moves, bend, tool), &[segment], tool, bend.at);
    Bend { at, depth, ..*bend }
}

/// The moves that the tool may make the cut of a bend from.
fn moves_near(moves: &[MoveCurve], bend: &Bend, tool: Tool) -> Vec<MoveCurve> {
    let mut near = Vec::new();
    for piece in moves {
        if piece.hull_bounds().distance(bend.center) <= tool.radius() {
            near.push(*piece);
        }
    }
    near
}

/// Reports an inside corner whose offsets do not meet.
pub(super) fn missed_corner(
    path: &mut ToolPath,
    corner: DVec2,
    segments: [&Segment; 2],
    near: &[MoveCurve],
    tool: Tool,
    tolerance: f64,
) {
    let origins = segments.map(|segment| segment.attributes.origin);
    let (depth, at) = depth_of(near, &segments, tool, corner);
    let hint = "use a smaller tool, or make the segments at this corner longer";
    if depth > tolerance {
        let message = format!(
            "the offsets of the inside corner do not meet; the path cuts {} mm too deep",
            Decimal::of(depth)
        );
        let code = "corner-gouge";
        gouge(path, code, message, hint.into(), at, depth, GougeKind::Curvature, &origins);
    } else {
        let message = "the offsets of the inside corner do not meet; the tool leaves material";
        path.diagnostics.push(
            Diagnostic::warning("corner-not-reached", message)
                .with_point(corner)
                .with_origin(origins[1])
                .with_hint(hint)
                .with_segments(origins),
        );
    }
}

/// Reports a segment whose offset runs backwards, as its corners cut off more than all of it.
pub(super) fn backwards(
    path: &mut ToolPath,
    segments: &[&Segment],
    middle: &Segment,
    moves: &[MoveCurve],
    tool: Tool,
    tolerance: f64,
) {
    let start = middle.curve.start();
    let (depth, at) = depth_of(moves, segments, tool, start);
    // A segment that only just vanishes turns around by a rounding.
    if depth <= tolerance {
        return;
    }
    let message = format!(
        "the segment is too short between its inside corners for the tool; the path cuts {} mm too deep",
        Decimal::of(depth)
    );
    let origins: Vec<Origin> = segments.iter().map(|s| s.attributes.origin).collect();
    let hint = "use a smaller tool".into();
    gouge(path, "segment-vanishes", message, hint, at, depth, GougeKind::Bottleneck, &origins);
}

/// Reports a place where the path comes too near to another part of the contour: the origin of the
/// move, and that of the segment that is cut.
pub(super) fn too_near(
    path: &mut ToolPath,
    kind: GougeKind,
    at: DVec2,
    depth: f64,
    [mover, into]: [Origin; 2],
) {
    let message = format!(
        "the tool does not fit between two parts of the contour; the path cuts {} mm too deep",
        Decimal::of(depth)
    );
    let hint = "use a smaller tool, or let gouges be avoided".into();
    let both = [into, mover];
    let segments = if mover == into { &both[..1] } else { &both[..] };
    gouge(path, "bottleneck-gouge", message, hint, at, depth, kind, segments);
}

/// How much nearer than r the moves come to the segments, and the point of the contour there.
///
/// From one place to another a depth changes by no more than their distance, so that of most places need
/// not be looked for.
fn depth_of(moves: &[MoveCurve], segments: &[&Segment], tool: Tool, place: DVec2) -> (f64, DVec2) {
    let mut deepest = (0.0, place);
    for segment in segments {
        let mut last = (DVec2::ZERO, f64::INFINITY);
        for piece in moves {
            for k in 0..=DEPTH_SAMPLES {
                let center = piece.point(k as f64 / DEPTH_SAMPLES as f64);
                if last.1 + last.0.distance(center) <= deepest.0 {
                    continue;
                }
                let nearest = segment.curve.nearest(center);
                let depth = tool.radius() - nearest.distance;
                last = (center, depth);
                if depth > deepest.0 {
                    deepest = (depth, nearest.point);
                }
            }
        }
    }
    deepest
}

#[expect(clippy::too_many_arguments, reason = "a gouge and its diagnostic say the same things")]
fn gouge(
    path: &mut ToolPath,
    code: &'static str,
    message: String,
    hint: String,
    at: DVec2,
    depth: f64,
    kind: GougeKind,
    segments: &[Origin],
) {
    path.diagnostics.push(
        Diagnostic::error(code, message)
            .with_hint(hint)
            .with_point(at)
            .with_depth(depth)
            .with_origin(segments[segments.len() / 2])
            .with_segments(segments),
    );
    path.gouges.push(Gouge { kind, at, depth, segments: segments.to_vec() });
}
