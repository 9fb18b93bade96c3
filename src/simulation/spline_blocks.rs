//! The blocks of a spline's pieces, for the moves along them.

use crate::contour::{Move, Role};
use crate::geometry::Curve;
use crate::program::ProgrammedContour;

/// Gives the moves along splines of several blocks the blocks that they come from; a spline's segment
/// has the first of them alone.
///
/// The equidistant passes from one piece to the next on the normal between them.
pub(super) fn name_blocks(moves: &mut [Move], programmed: &ProgrammedContour) {
    let mut segments = programmed.contour.segments().iter();
    let mut steps = moves.iter_mut().peekable();
    for blocks in &programmed.curves {
        let Some(&first) = blocks.first() else { continue };
        let pieces = segments.find_map(|segment| match &segment.curve {
            Curve::Spline(spline) if segment.attributes.origin == first => Some(spline.pieces()),
            _ => None,
        });
        // Control points have no pieces of their own.
        let Some(pieces) = pieces.filter(|pieces| pieces.len() == blocks.len()) else { continue };
        while steps.next_if(|step| step.origin != first || step.role != Role::Segment).is_some() {}
        let mut at = 0;
        while let Some(step) =
            steps.next_if(|step| step.origin == first && step.role == Role::Segment)
        {
            let middle = step.curve.point(0.5);
            while let (Some(piece), true) = (pieces.get(at), at + 1 < pieces.len())
                && (middle - piece.end()).dot(piece.tangent(1.0)) > 0.0
            {
                at += 1;
            }
            if let Some(block) = blocks.get(at) {
                step.origin = *block;
            }
        }
    }
}
