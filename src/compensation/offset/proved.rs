//! The offset of a spline piece by piece, each with the proof of its error.

use super::spline::{Tolerances, each_piece};
use crate::contour::MoveCurve;
use crate::geometry::{MIN_LENGTH, Spline};

/// A piece of the offset of a spline, and how far it is proved to be off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProvedPiece {
    /// The span of the spline it belongs to, counted from 0.
    pub span: usize,
    /// Where on the span's cubic it begins, in `[0, 1]`.
    pub from: f64,
    /// Where on the span's cubic it ends; `from` for an arc about a cusp of the spline.
    pub to: f64,
    /// The piece.
    pub curve: MoveCurve,
    /// Its largest error [mm].
    ///
    /// Proved, rounding included, from Bernstein coefficients of the two cubics: the Hausdorff
    /// distance between the piece and the true offset `C + δN` over `from..to` is at most this.
    /// Where the tool fits (`1 − δκ > 0`), the distance of no point of the piece from `C` over
    /// `from..to` differs from `|δ|` by more either. Infinite where nothing is proved: where the
    /// spline all but stands still.
    pub bound: f64,
}

/// The pieces that [`compensate`](crate::compensation::compensate) makes of the offset of a spline by
/// `offset` [mm] to its left, within `tolerance` [mm] and rounding, each with a proved bound of its
/// error.
///
/// The bounds are sharper than those that the pieces were accepted by, and take longer.
#[must_use]
pub fn proved_offset(spline: &Spline, offset: f64, tolerance: f64) -> Vec<ProvedPiece> {
    let mut pieces: Vec<ProvedPiece> = Vec::with_capacity(spline.pieces().len());
    let mut before = None;
    for (span, cubic) in spline.pieces().iter().enumerate() {
        each_piece(
            cubic,
            offset,
            Tolerances::even(tolerance),
            before,
            &mut |_, _| {},
            &mut |source, range, curve| {
                let bound = match &curve {
                    MoveCurve::Cubic(_) if offset.abs() <= MIN_LENGTH => offset.abs(),
                    MoveCurve::Cubic(piece) => {
                        let compared = source.compared(piece);
                        compared.sharp().min(source.by_length(piece)) + compared.rounding()
                    }
                    // About a cusp it is the offset.
                    _ => 0.0,
                };
                before = Some(curve.end());
                pieces.push(ProvedPiece { span, from: range[0], to: range[1], curve, bound });
            },
        );
    }
    pieces
}
