//! Non-uniform rational B-splines, taken apart into cubics.
//!
//! Between two knots a B-spline is a Bézier curve, whose control points are values of its blossom
//! (Ramshaw 1987): de Boor's algorithm with another argument at each level. Without weights, and up
//! to the third degree, those are cubics exactly. Otherwise each Bézier curve `N/W` is halved until
//! the cubic `H` with its end points and end derivatives is near enough: `N − W H` is a polynomial
//! whose Bernstein coefficients bound it, and `|N/W − H|` is at most that over the least weight.

use std::fmt;

use glam::{DVec2, DVec3};

use super::{Cubic, curve::checked_point, nth_root};

/// Highest order of a curve: controls stop at 6 or 7, and a higher one is a slip.
const MOST_ORDER: usize = 16;

/// Halvings of a Bézier curve until its cubic is taken as it is: 2⁻¹⁶ of a span, where an error of
/// the fourth order is down at the rounding of coordinates.
const DEEPEST: usize = 16;

/// Most cubics of one curve, and for each of its control points as many more: a quarter of a circle
/// of a metre takes 400 at a nanometre and 20 at a tenth of a micrometre.
const MOST_CUBICS: usize = 2000;
const MORE_CUBICS: usize = 50;

/// Weights below this fraction of the largest count as zero at an end, where the curve would be
/// nowhere.
const LEAST_WEIGHT: f64 = 1e-9;

/// Why numbers make no NURBS curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NurbsError {
    /// A coordinate, knot or weight is no number or too large.
    OutOfRange,
    /// The order is not between 2 and 16.
    Order,
    /// There are fewer control points than the order.
    TooFewPoints,
    /// There are not as many knots as control points and the order together.
    KnotCount,
    /// A knot is less than the one before it.
    KnotOrder,
    /// The first knots, or the last ones, are not equal, as many as the order.
    KnotEnds,
    /// More inner knots than the order allows are equal: the curve would be torn.
    KnotRepeated,
    /// A weight is negative, or zero where a span ends.
    Weight,
    /// It takes more than 2000 cubics, and 50 more for each control point, to be within the
    /// tolerance.
    TooFine,
}

impl fmt::Display for NurbsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OutOfRange => "the NURBS curve has a number out of range",
            Self::Order => "the order of the NURBS curve is not between 2 and 16",
            Self::TooFewPoints => "the NURBS curve has fewer control points than its order",
            Self::KnotCount => {
                "the NURBS curve needs as many knots as control points and its order together"
            }
            Self::KnotOrder => "a knot of the NURBS curve is less than the one before it",
            Self::KnotEnds => {
                "the first and the last knots of the NURBS curve are not equal, as many as its order"
            }
            Self::KnotRepeated => "too many inner knots of the NURBS curve are equal",
            Self::Weight => "a weight of the NURBS curve is not positive",
            Self::TooFine => "the NURBS curve has too many cubics within the tolerance",
        })
    }
}

impl std::error::Error for NurbsError {}

/// A NURBS curve.
///
/// # Guarantees
/// Its knots ascend, the first and the last as many times as the order (clamped), so that it begins
/// at its first control point and ends at its last. No other knot is repeated as often.
#[derive(Debug, Clone, PartialEq)]
pub struct Nurbs {
    order: usize,
    knots: Vec<f64>,
    /// Control points times their weights, and the weights.
    controls: Vec<DVec3>,
    /// Whether all weights are equal.
    polynomial: bool,
}

impl Nurbs {
    /// The curve of an order (the degree plus one) with these knots, and control points [mm] with a
    /// weight each.
    ///
    /// # Errors
    /// [`NurbsError`].
    pub fn new(
        order: usize,
        knots: Vec<f64>,
        controls: &[(DVec2, f64)],
    ) -> Result<Self, NurbsError> {
        let count = controls.len();
        if !(2..=MOST_ORDER).contains(&order) {
            return Err(NurbsError::Order);
        }
        if count < order {
            return Err(NurbsError::TooFewPoints);
        }
        if knots.len() != count + order {
            return Err(NurbsError::KnotCount);
        }
        // A NaN is in no range.
        let finite = knots.iter().all(|knot| knot.abs() <= 1e12)
            && controls
                .iter()
                .all(|(point, weight)| checked_point(*point).is_ok() && weight.abs() <= 1e9);
        if !finite {
            return Err(NurbsError::OutOfRange);
        }
        if knots.windows(2).any(|pair| pair[1] < pair[0]) {
            return Err(NurbsError::KnotOrder);
        }
        if knots[0] != knots[order - 1] || knots[count] != knots[count + order - 1] {
            return Err(NurbsError::KnotEnds);
        }
        if (1..count).any(|i| knots[i] == knots[i + order - 1]) {
            return Err(NurbsError::KnotRepeated);
        }
        let largest = controls.iter().fold(0.0_f64, |most, (_, weight)| most.max(*weight));
        let is_end = |i: usize| i == 0 || i == count - 1;
        for (i, (_, weight)) in controls.iter().enumerate() {
            if *weight < 0.0 || (is_end(i) && *weight <= LEAST_WEIGHT * largest) {
                return Err(NurbsError::Weight);
            }
        }
        let polynomial = controls.iter().all(|(_, weight)| *weight == controls[0].1);
        // Only ratios of weights count.
        let scaled = |&(point, weight): &(DVec2, f64)| {
            let weight = if polynomial { 1.0 } else { weight / largest };
            (point * weight).extend(weight)
        };
        let controls = controls.iter().map(scaled).collect();
        Ok(Self { order, knots, controls, polynomial })
    }

    /// The knots of a curve whose inner knots are evenly spaced, and simple.
    #[must_use]
    pub fn uniform_knots(order: usize, count: usize) -> Vec<f64> {
        // No curve has a higher order: whatever knots it is given, it is refused.
        let order = order.min(MOST_ORDER);
        let first = order.saturating_sub(1);
        (0..count + order).map(|i| (i.clamp(first, count.max(first)) - first) as f64).collect()
    }

    /// Whether [`cubics`](Self::cubics) are the curve itself.
    #[must_use]
    pub fn is_cubic(&self) -> bool {
        self.polynomial && self.order <= 4
    }

    /// Cubics that follow each other: the curve itself, or within `tolerance` [mm] of it.
    ///
    /// # Errors
    /// [`NurbsError::Weight`], where weights make the curve run to infinity, and
    /// [`NurbsError::TooFine`].
    pub fn cubics(&self, tolerance: f64) -> Result<Vec<Cubic>, NurbsError> {
        let most = MOST_CUBICS + MORE_CUBICS * self.controls.len();
        let mut cubics = Vec::new();
        let mut bezier = vec![DVec3::ZERO; self.order];
        for span in self.order - 1..self.controls.len() {
            if self.knots[span] < self.knots[span + 1] {
                for (i, control) in bezier.iter_mut().enumerate() {
                    *control = self.blossom(span, i);
                }
                let ends = [bezier[0].z, bezier[self.order - 1].z];
                if ends.into_iter().any(|weight| weight <= LEAST_WEIGHT) {
                    return Err(NurbsError::Weight);
                }
                if self.is_cubic() {
                    cubics.push(elevated(&bezier));
                } else {
                    approximate(&mut bezier.clone(), tolerance, [DEEPEST, most], &mut cubics);
                }
                if cubics.len() >= most {
                    return Err(NurbsError::TooFine);
                }
            }
        }
        Ok(cubics)
    }

    /// Control point `i` of the Bézier curve between knots `span` and `span + 1`: the blossom at
    /// `i` times the second of them and else the first.
    fn blossom(&self, span: usize, i: usize) -> DVec3 {
        let degree = self.order - 1;
        let mut points = self.controls[span - degree..=span].to_vec();
        for level in 1..=degree {
            let at = self.knots[if level <= i { span + 1 } else { span }];
            for k in (level..=degree).rev() {
                let from = self.knots[span - degree + k];
                let to = self.knots[span + 1 + k - level];
                points[k] = points[k - 1].lerp(points[k], (at - from) / (to - from));
            }
        }
        points[degree]
    }
}

/// The point of a weighted point [mm].
fn projected(point: DVec3) -> DVec2 {
    point.truncate() / point.z
}

/// The cubic that a Bézier curve of lower degree without weights is.
fn elevated(bezier: &[DVec3]) -> Cubic {
    let mut points = bezier.to_vec();
    while points.len() < 4 {
        let degree = points.len();
        points.push(points[degree - 1]);
        for i in (1..degree).rev() {
            points[i] = points[i].lerp(points[i - 1], i as f64 / degree as f64);
        }
    }
    Cubic::new(
        points[0].truncate(),
        points[1].truncate(),
        points[2].truncate(),
        points[3].truncate(),
    )
}

/// Appends cubics within `tolerance` of a rational Bézier curve, halved so often and not more of them
/// in all.
fn approximate(
    bezier: &mut [DVec3],
    tolerance: f64,
    [depth, most]: [usize; 2],
    cubics: &mut Vec<Cubic>,
) {
    if cubics.len() >= most {
        return;
    }
    let last = bezier.len() - 1;
    // The same curve by another parameter, with equal weights at its ends (Farin 1983).
    let ratio = nth_root(bezier[0].z / bezier[last].z, u32::try_from(last).unwrap_or(u32::MAX));
    let mut scale = 1.0;
    for point in bezier.iter_mut() {
        *point *= scale;
        scale *= ratio;
    }
    let (start, end) = (projected(bezier[0]), projected(bezier[last]));
    // (N/W)' at an end: the degree times the difference of weighted points, less what W takes.
    let degree = last as f64;
    let at_start = (bezier[1].truncate() - start * bezier[1].z) * (degree / bezier[0].z);
    let before = bezier[last - 1];
    let at_end = (end * before.z - before.truncate()) * (degree / bezier[last].z);
    let cubic = Cubic::hermite(start, at_start, end, at_end);
    if depth == 0 || error(bezier, &cubic) <= tolerance {
        cubics.push(cubic);
        return;
    }
    // De Casteljau's halves, the first left behind in the points that each round fixes.
    let mut first = vec![bezier[0]];
    for count in (1..=last).rev() {
        for k in 0..count {
            bezier[k] = (bezier[k] + bezier[k + 1]) * 0.5;
        }
        first.push(bezier[0]);
    }
    approximate(&mut first, tolerance, [depth - 1, most], cubics);
    approximate(bezier, tolerance, [depth - 1, most], cubics);
}

/// A bound of the distance of a rational Bézier curve from a cubic at the same parameter [mm].
fn error(bezier: &[DVec3], cubic: &Cubic) -> f64 {
    let mut sums = vec![(DVec2::ZERO, 0.0); bezier.len() + 3];
    let mut binomial = 1.0;
    let mut least = f64::INFINITY;
    for (i, weighted) in bezier.iter().enumerate() {
        for (j, (point, other)) in cubic.points.iter().zip([1.0, 3.0, 3.0, 1.0]).enumerate() {
            let (sum, total) = &mut sums[i + j];
            *sum += (weighted.truncate() - *point * weighted.z) * (binomial * other);
            *total += binomial * other;
        }
        least = least.min(weighted.z);
        binomial *= (bezier.len() - 1 - i) as f64 / (i + 1) as f64;
    }
    let largest = sums.iter().map(|(sum, total)| sum.length() / total).fold(0.0, f64::max);
    if least > 0.0 { largest / least } else { f64::INFINITY }
}
