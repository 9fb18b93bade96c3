//! Symmetric positive definite equations whose matrix is a band.

/// Entries beside the diagonal on either side.
pub(super) const WIDTH: usize = 3;

/// The lower half of a symmetric band matrix: `rows[i][d]` is the entry `(i, i - d)`.
pub(super) type Rows = Vec<[f64; WIDTH + 1]>;

/// Solves in place: `rows` becomes the factor, `right` the solution. `false` where a pivot is not
/// positive.
pub(super) fn solve(rows: &mut [[f64; WIDTH + 1]], right: &mut [f64]) -> bool {
    // Cholesky's rule, row by row: L L' = A, with the diagonal inverted. Of the three rows before the
    // first one the diagonals are 0, which takes out what is outside.
    let (mut a, mut b, mut c) = ([0.0; WIDTH + 1], [0.0; WIDTH + 1], [0.0; WIDTH + 1]);
    let (mut ya, mut yb, mut yc) = (0.0, 0.0, 0.0);
    for (row, right) in rows.iter_mut().zip(right.iter_mut()) {
        let [diagonal, first, second, third] = *row;
        let third = third * c[0];
        let second = (second - third * b[1]) * b[0];
        let first = (first - third * a[2] - second * a[1]) * a[0];
        let pivot = diagonal - first * first - second * second - third * third;
        if pivot <= 0.0 || !pivot.is_finite() {
            return false;
        }
        let inverse = 1.0 / pivot.sqrt();
        let y = (*right - first * ya - second * yb - third * yc) * inverse;
        *row = [inverse, first, second, third];
        *right = y;
        (a, b, c) = (*row, a, b);
        (ya, yb, yc) = (y, ya, yb);
    }
    // The same backwards, of which the rows behind have no part in what is before them.
    (a, b, c) = ([0.0; WIDTH + 1], [0.0; WIDTH + 1], [0.0; WIDTH + 1]);
    for (row, right) in rows.iter().zip(right.iter_mut()).rev() {
        let x = (*right - a[1] * ya - b[2] * yb - c[3] * yc) * row[0];
        *right = x;
        (a, b, c) = (*row, a, b);
        (ya, yb, yc) = (x, ya, yb);
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
