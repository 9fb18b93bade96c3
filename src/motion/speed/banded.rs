//! Symmetric positive definite equations whose matrix is a band.

/// Entries beside the diagonal on either side.
pub(super) const WIDTH: usize = 3;

/// The lower half of a symmetric band matrix: `rows[i][d]` is the entry `(i, i - d)`.
pub(super) type Rows = Vec<[f64; WIDTH + 1]>;

/// Solves in place: `rows` becomes the factor, `right` the solution. `false` where a pivot is not
/// positive.
pub(super) fn solve(rows: &mut [[f64; WIDTH + 1]], right: &mut [f64]) -> bool {
    // Cholesky's rule, row by row: L L' = A.
    for i in 0..rows.len() {
        let reach = i.min(WIDTH);
        let mut sum_right = right[i];
        for d in (0..=reach).rev() {
            let column = i - d;
            let mut sum = rows[i][d];
            for e in d + 1..=reach {
                // Entries (i, i - e) and (column, i - e).
                if e - d <= WIDTH {
                    sum -= rows[i][e] * rows[column][e - d];
                }
            }
            if d == 0 {
                if sum <= 0.0 || !sum.is_finite() {
                    return false;
                }
                rows[i][0] = 1.0 / sum.sqrt();
            } else {
                rows[i][d] = sum * rows[column][0];
                sum_right -= rows[i][d] * right[column];
            }
        }
        right[i] = sum_right * rows[i][0];
    }
    for i in (0..rows.len()).rev() {
        let mut sum = right[i];
        for d in 1..=WIDTH {
            if i + d < rows.len() {
                sum -= rows[i + d][d] * right[i + d];
            }
        }
        right[i] = sum * rows[i][0];
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_band_is_solved() {
        let full = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 5.0 + i as f64,
            1 => -1.5,
            2 => 0.5,
            3 => 0.25,
            _ => 0.0,
        };
        let n = 9;
        let mut rows: Rows = (0..n)
            .map(|i| [0, 1, 2, 3].map(|d| if d <= i { full(i, i - d) } else { 0.0 }))
            .collect();
        let meant: Vec<f64> = (0..n).map(|i| (i as f64 - 3.0) * 0.7).collect();
        let mut right: Vec<f64> =
            (0..n).map(|i| (0..n).map(|j| full(i, j) * meant[j]).sum()).collect();
        assert!(solve(&mut rows, &mut right), "the matrix is positive definite");
        for (found, meant) in right.iter().zip(&meant) {
            assert!((found - meant).abs() < 1e-12, "{found} is {meant}");
        }
    }

    #[test]
    fn an_indefinite_band_is_refused() {
        let mut rows: Rows = vec![[1.0, 0.0, 0.0, 0.0], [1.0, 2.0, 0.0, 0.0]];
        assert!(!solve(&mut rows, &mut [1.0, 1.0]), "its determinant is negative");
    }
}
