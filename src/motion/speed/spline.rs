//! Cubic splines whose intervals differ, at their borders and half-way between them.

/// The values, and halves of the slopes and second derivatives, of the four B-splines that are not zero
/// at a knot.
pub(super) type Basis = [[f64; 3]; 4];

/// The basis at each knot of a spline: at the borders of its intervals [s], and half-way.
pub(super) fn bases(borders: &[f64]) -> Vec<Basis> {
    let last = borders.len() - 1;
    // Beyond the ends the intervals go on as the first and the last.
    let border = |k: usize| match k {
        0 | 1 => borders[0] - (2 - k) as f64 * (borders[1] - borders[0]),
        _ if k - 2 > last => {
            borders[last] + (k - 2 - last) as f64 * (borders[last] - borders[last - 1])
        }
        _ => borders[k - 2],
    };
    let mut bases = Vec::with_capacity(2 * last + 1);
    for k in 0..=2 * last {
        let interval = (k / 2).min(last - 1);
        let t: [f64; 6] = std::array::from_fn(|i| border(interval + i));
        bases.push(basis(
            &t,
            if k % 2 == 1 { f64::midpoint(t[2], t[3]) } else { t[2 + k / 2 - interval] },
        ));
    }
    bases
}

/// The basis at `u` between the third and the fourth of six borders: Cox and de Boor's recursion, of
/// which the last steps give the derivatives (each is the difference of two of one degree less).
fn basis(t: &[f64; 6], u: f64) -> Basis {
    let mut values = [0.0, 0.0, 0.0, 1.0];
    let mut found = [[0.0; 3]; 4];
    let mut squares = [0.0; 4];
    for degree in 1..4 {
        let mut next = [0.0; 4];
        let mut slopes = [0.0; 4];
        for i in 3 - degree..4 {
            // Of the function from border `i` of degree one less, and of the one after it.
            let mut part = |value: f64, from: usize, rises: bool| {
                let (low, high) = (t[from], t[from + degree]);
                let width = high - low;
                next[i] += value * if rises { u - low } else { high - u } / width;
                slopes[i] += if rises { value } else { -value } * degree as f64 / width;
            };
            if i > 3 - degree {
                part(values[i], i - 1, true);
            }
            if i < 3 {
                part(values[i + 1], i, false);
            }
        }
        if degree == 2 {
            squares = slopes;
        }
        values = next;
        for i in 0..4 {
            found[i] = [values[i], 0.5 * slopes[i], 0.0];
        }
    }
    // Of the slopes of the squares the second derivatives are differences.
    for i in 0..4 {
        let rise = if i > 0 { squares[i] / (t[i + 2] - t[i - 1]) } else { 0.0 };
        let fall = if i < 3 { squares[i + 1] / (t[i + 3] - t[i]) } else { 0.0 };
        found[i][2] = 1.5 * (rise - fall);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_basis_gives_back_lines_and_parabolas_at_uneven_borders() {
        let borders = [0.0, 1.0, 2.0, 2.5, 3.0, 3.25, 3.5, 4.0, 5.0];
        let bases = bases(&borders);
        let beyond = |k: usize| match k {
            0 | 1 => k as f64 - 2.0,
            _ if k - 2 < borders.len() => borders[k - 2],
            _ => 5.0 + (k - 1 - borders.len()) as f64,
        };
        for (k, basis) in bases.iter().enumerate() {
            let first = if k + 1 == bases.len() { k / 2 - 1 } else { k / 2 };
            let u = if k % 2 == 0 {
                borders[k / 2]
            } else {
                0.5 * (borders[k / 2] + borders[k / 2 + 1])
            };
            // Marsden's identity: the coefficients of 1, u and u² are symmetric means of the borders.
            let mut found = [[0.0; 3]; 3];
            for (i, row) in basis.iter().enumerate() {
                let [a, b, c] = [0, 1, 2].map(|j| beyond(first + i + j));
                let sums = [1.0, (a + b + c) / 3.0, (a * b + b * c + c * a) / 3.0];
                for (found, sum) in found.iter_mut().zip(sums) {
                    for (found, (value, times)) in
                        found.iter_mut().zip(row.iter().zip([1.0, 2.0, 2.0]))
                    {
                        *found += value * times * sum;
                    }
                }
            }
            let meant = [[1.0, 0.0, 0.0], [u, 1.0, 0.0], [u * u, 2.0 * u, 2.0]];
            for (power, (found, meant)) in found.iter().zip(meant).enumerate() {
                for (order, (found, meant)) in found.iter().zip(meant).enumerate() {
                    assert!(
                        (found - meant).abs() < 1e-12,
                        "knot {k}, power {power}, order {order}: {found} is {meant}"
                    );
                }
            }
        }
    }
}
