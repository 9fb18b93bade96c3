//! Symmetric positive definite systems whose unknowns know only their five neighbours.

use glam::DVec3;

/// Row `i` holds the factors of the unknowns `i, i − 1, …, i − 5` of equation `i`.
pub(super) type Row = [f64; 6];

/// Adds `weight · v vᵀ` for the unknowns from the first row given on.
pub(super) fn add(rows: &mut [Row], values: &[f64], weight: f64) {
    for i in 0..values.len() {
        let value = weight * values[i];
        for j in 0..=i {
            rows[i][i - j] += value * values[j];
        }
    }
}

/// Gives the unknowns outside `[first, last)` the values on the right side.
pub(super) fn hold(rows: &mut [Row], right: &mut [DVec3], [first, last]: [usize; 2]) {
    for i in 0..rows.len() {
        for d in 1..6.min(i + 1) {
            let factor = rows[i][d];
            let [i_held, j_held] = [i, i - d].map(|index| index < first || index >= last);
            if i_held && !j_held {
                let held = right[i];
                right[i - d] -= held * factor;
            } else if j_held && !i_held {
                let held = right[i - d];
                right[i] -= held * factor;
            }
            if i_held || j_held {
                rows[i][d] = 0.0;
            }
        }
        if i < first || i >= last {
            rows[i][0] = 1.0;
        }
    }
}

/// Decomposes in place (Cholesky without roots, `L D Lᵀ`): the rows then hold `1/D` and `L`.
pub(super) fn decompose(rows: &mut [Row]) {
    for i in 0..rows.len() {
        let width = 5.min(i);
        let mut row = rows[i];
        // First L D, from the column farthest left on, then L.
        for d in (1..=width).rev() {
            for e in d + 1..=width {
                row[d] -= row[e] * rows[i - d][e - d];
            }
        }
        for d in 1..=width {
            let product = row[d];
            row[d] *= rows[i - d][0];
            row[0] -= product * row[d];
        }
        row[0] = 1.0 / row[0];
        rows[i] = row;
    }
}

/// Solves in place, given the decomposition: the solution is left on the right side.
pub(super) fn solve(rows: &[Row], right: &mut [DVec3]) {
    // Sums in this form: where code is small, `+=` on a point is a call.
    for (i, row) in rows.iter().enumerate() {
        let mut sum = right[i];
        for d in 1..6.min(i + 1) {
            sum = right[i - d] * -row[d] + sum;
        }
        right[i] = sum;
    }
    for i in (0..rows.len()).rev() {
        let mut sum = right[i] * rows[i][0];
        for d in 1..6.min(rows.len() - i) {
            sum = right[i + d] * -rows[i + d][d] + sum;
        }
        right[i] = sum;
    }
}
