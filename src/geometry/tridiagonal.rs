//! Tridiagonal and cyclic tridiagonal systems with a dominant diagonal.

use glam::DVec2;

/// One row of a system: `lower · x[i-1] + diagonal · x[i] + upper · x[i+1] = right`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub(super) lower: f64,
    pub(super) diagonal: f64,
    pub(super) upper: f64,
    pub(super) right: DVec2,
}

/// Solves a tridiagonal system (Thomas' algorithm); stable as the diagonal dominates.
pub(super) fn solve(rows: &[Row]) -> Vec<DVec2> {
    let mut upper = Vec::with_capacity(rows.len());
    let mut solution: Vec<DVec2> = Vec::with_capacity(rows.len());
    for (i, row) in rows.iter().enumerate() {
        let (previous_upper, previous) =
            if i == 0 { (0.0, DVec2::ZERO) } else { (upper[i - 1], solution[i - 1]) };
        let per_pivot = 1.0 / (row.diagonal - row.lower * previous_upper);
        upper.push(row.upper * per_pivot);
        solution.push((row.right - previous * row.lower) * per_pivot);
    }
    for i in (0..rows.len().saturating_sub(1)).rev() {
        let next = solution[i + 1];
        solution[i] -= next * upper[i];
    }
    solution
}

/// Solves a cyclic system of at least three rows: the first row's `lower` belongs to the last
/// unknown, the last row's `upper` to the first (Sherman–Morrison).
pub(super) fn solve_cyclic(rows: &[Row]) -> Vec<DVec2> {
    let last = rows.len() - 1;
    let (corner_up, corner_down) = (rows[0].lower, rows[last].upper);
    // Any non-zero gamma works; minus the diagonal keeps the changed diagonal dominant.
    let gamma = -rows[0].diagonal;
    // Of each row: what is left of `upper`, of the right side, and of that of the scalar system
    // which the correction solves.
    let mut reduced: Vec<(f64, DVec2, f64)> = Vec::with_capacity(rows.len());
    let mut before = (0.0, DVec2::ZERO, 0.0);
    for (i, row) in rows.iter().enumerate() {
        let (mut diagonal, mut upper, mut corner) = (row.diagonal, row.upper, 0.0);
        if i == 0 {
            (diagonal, corner) = (diagonal - gamma, gamma);
        } else if i == last {
            (diagonal, upper) = (diagonal - corner_down * corner_up / gamma, 0.0);
            corner = corner_down;
        }
        let lower = if i == 0 { 0.0 } else { row.lower };
        let per_pivot = 1.0 / (diagonal - lower * before.0);
        before = (
            upper * per_pivot,
            (row.right - before.1 * lower) * per_pivot,
            (corner - before.2 * lower) * per_pivot,
        );
        reduced.push(before);
    }
    let mut next = (DVec2::ZERO, 0.0);
    for (upper, right, corner) in reduced.iter_mut().rev() {
        *right -= next.0 * *upper;
        *corner -= next.1 * *upper;
        next = (*right, *corner);
    }
    let fraction = corner_up / gamma;
    let (first, end) = (reduced[0], reduced[last]);
    let factor = (first.1 + end.1 * fraction) / (1.0 + first.2 + fraction * end.2);
    reduced.iter().map(|(_, right, corner)| *right - factor * *corner).collect()
}
