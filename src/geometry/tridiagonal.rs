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
        let pivot = row.diagonal - row.lower * previous_upper;
        upper.push(row.upper / pivot);
        solution.push((row.right - previous * row.lower) / pivot);
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
    let mut changed = rows.to_vec();
    changed[0].lower = 0.0;
    changed[0].diagonal -= gamma;
    changed[last].upper = 0.0;
    changed[last].diagonal -= corner_down * corner_up / gamma;
    let solution = solve(&changed);
    for row in &mut changed {
        row.right = DVec2::ZERO;
    }
    changed[0].right = DVec2::splat(gamma);
    changed[last].right = DVec2::splat(corner_down);
    let correction = solve(&changed);
    // Both components of `correction` are equal: it solves one scalar system.
    let fraction = corner_up / gamma;
    let factor = (solution[0] + solution[last] * fraction)
        / (1.0 + correction[0].x + fraction * correction[last].x);
    solution.iter().zip(&correction).map(|(x, z)| *x - factor * z.x).collect()
}
