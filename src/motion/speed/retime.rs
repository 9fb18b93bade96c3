//! Making a law of motion faster: its time is stretched and shrunk until a limit holds everywhere.
//!
//! Let a law `s(u)` be given, by a parameter `u` that is about time, and with it the path `q(u)`.
//! Run at the rate `du/dt = √b(u)` the machine's acceleration is `b q'' + b' q'/2` and its jerk
//! `√b (b q''' + 3/2 b' q'' + b''/2 q')` (the chain rule): linear in `b` but for the root. So with
//! `b` a cubic spline the shortest time `∫ du/√b` within the limits is sought by an interior-point
//! method: barriers `−μ log(1 − g)` for each limit `g ≤ 1` at each knot, Newton's method with a
//! banded matrix, and a falling weight μ. That `b` is varied and not the velocity keeps stops out of
//! the way: there `q'` vanishes, and `b` stays regular.
//!
//! Where a limit is broken at the start it is widened, and drawn in while the iteration leaves room;
//! what is left is for the caller to judge.

use glam::DVec3;

use super::banded::{self, Rows};

/// The path at a knot. Each interval of the spline `b` has one at its start and one half-way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Knot {
    /// The derivatives `q'`, `q''` and `q'''` by the parameter.
    pub(super) path: [DVec3; 3],
    /// What `b` may be at most for the sake of velocity and chord error.
    pub(super) most: f64,
    /// Inverse squares of the shares of acceleration, jerk and snap that may be used.
    pub(super) strict: [f64; 3],
}

/// What the rates are held to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bounds {
    /// By what acceleration and jerk are multiplied, component by component, to have size 1 at their
    /// limits: for the vector, and for each axis that has limits.
    pub(super) scales: Vec<[DVec3; 2]>,
    /// Largest change of the jerk vector in time [mm/s⁴].
    pub(super) snap: f64,
}

/// Values, slopes and second derivatives of the four cubic B-splines that are not zero at a knot of
/// theirs, half-way to the next, and there, for a distance of 1 between them.
const BASIS: [[[f64; 4]; 3]; 3] = [
    [[1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0], [-0.5, 0.0, 0.5, 0.0], [1.0, -2.0, 1.0, 0.0]],
    [
        [1.0 / 48.0, 23.0 / 48.0, 23.0 / 48.0, 1.0 / 48.0],
        [-0.125, -0.625, 0.625, 0.125],
        [0.5, -0.5, -0.5, 0.5],
    ],
    [[0.0, 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0], [0.0, -0.5, 0.0, 0.5], [0.0, 1.0, -2.0, 1.0]],
];

/// How strongly the first and last coefficients are held together, so that `b` does not change while
/// the path stands still and nothing else decides on it.
const TIE: f64 = 1.0e3;

/// The weight of the barriers of limits that are broken: it draws `b` away from them.
const DRAWN: f64 = 5.0;

/// What the limits are widened by: velocity, acceleration and jerk, snap to the next knot.
type Slack = [f64; 3];

/// A stretch of knots to be run faster.
#[derive(Debug)]
pub(super) struct Retiming<'a> {
    knots: &'a [Knot],
    bounds: &'a Bounds,
    /// Distance of knots in the parameter [s].
    step: f64,
    basis: [[[f64; 4]; 3]; 3],
}

/// The rates at a knot, jerk over √b.
#[derive(Debug, Clone, Copy)]
struct Rates {
    b: f64,
    acceleration: DVec3,
    jerk: DVec3,
}

/// A limit at a knot: `g`, and its derivatives by the coefficients.
struct Term {
    g: f64,
    slopes: [f64; 4],
    /// `g` is `weight |value|²`, with these derivatives of the value.
    values: [DVec3; 4],
    weight: f64,
}

impl<'a> Retiming<'a> {
    pub(super) fn new(knots: &'a [Knot], bounds: &'a Bounds, step: f64) -> Self {
        let mut basis = BASIS;
        for [_, slopes, bends] in &mut basis {
            *slopes = slopes.map(|slope| slope / (2.0 * step));
            *bends = bends.map(|bend| bend / (4.0 * step * step));
        }
        Self { knots, bounds, step, basis }
    }

    /// The number of coefficients: those of knot `k` are four from `k / 2` on.
    pub(super) fn coefficients(&self) -> usize {
        (self.knots.len() - 1) / 2 + 3
    }

    /// The first coefficient and the basis at a knot.
    fn basis(&self, k: usize) -> (usize, &[[f64; 4]; 3]) {
        if k.is_multiple_of(2) && k + 1 == self.knots.len() {
            (k / 2 - 1, &self.basis[2])
        } else {
            (k / 2, &self.basis[k % 2])
        }
    }

    /// `b`, `b'` and `b''` at a knot.
    pub(super) fn at(&self, c: &[f64], k: usize) -> [f64; 3] {
        let (first, basis) = self.basis(k);
        let mut found = [0.0; 3];
        for (found, row) in found.iter_mut().zip(basis) {
            for i in 0..4 {
                *found += row[i] * c[first + i];
            }
        }
        found
    }

    fn rates(&self, c: &[f64], k: usize) -> Rates {
        let [b, slope, bend] = self.at(c, k);
        let [first, second, third] = self.knots[k].path;
        Rates {
            b,
            acceleration: second * b + first * (0.5 * slope),
            jerk: third * b + second * (1.5 * slope) + first * (0.5 * bend),
        }
    }

    /// The constant of at most 1 that `b` is to be multiplied by for every limit to hold.
    pub(super) fn even(&self, c: &[f64]) -> f64 {
        let mut least = 1.0_f64;
        self.each(c, &mut |_, _, power, g| {
            if g > 1.0 {
                least = least.min(match power {
                    1 => 1.0 / g,
                    2 => 1.0 / g.sqrt(),
                    3 => 1.0 / g.cbrt(),
                    _ => 1.0 / g.sqrt().sqrt(),
                });
            }
        });
        least
    }

    /// Improves the coefficients of `b`; `true` where every limit holds.
    pub(super) fn improve(&self, c: &mut [f64], [start, end]: [f64; 2], rounds: usize) -> bool {
        let n = c.len();
        let mut rows: Rows = vec![[0.0; 4]; n];
        let mut right = vec![0.0; n];
        let mut gradient = vec![0.0; n];
        let mut trial = vec![0.0; n];
        let mut slack = vec![[f64::INFINITY; 3]; self.knots.len()];
        let mut weight = start;
        let mut feasible = false;
        let mut size = 1.0;
        let mut now = [f64::INFINITY; 3];
        for round in 0..rounds {
            // What holds once is never broken again: the barriers see to it.
            if !feasible {
                feasible = self.widen(c, &mut slack);
                if feasible && round > 0 {
                    weight = weight.max(start);
                }
                now = self.merit(c, &slack);
            }
            self.assemble(c, &slack, weight, &mut rows, &mut right);
            gradient.copy_from_slice(&right);
            if !banded::solve(&mut rows, &mut right) {
                break;
            }
            let mut descent = 0.0;
            for i in 0..n {
                descent += gradient[i] * right[i];
            }
            let mut accepted = false;
            size = (2.0_f64 * size).min(1.0);
            while size > 1.0e-4 {
                for i in 0..n {
                    trial[i] = c[i] + size * right[i];
                }
                let then = self.merit(&trial, &slack);
                if sum(then, weight) <= sum(now, weight) - 0.1 * size * descent {
                    accepted = true;
                    now = then;
                    break;
                }
                size *= 0.5;
            }
            if accepted {
                c.copy_from_slice(&trial);
            }
            let small = descent < 0.5 * weight * self.knots.len() as f64;
            if feasible && (!accepted || small || size > 0.5) {
                if weight <= end && (small || !accepted) {
                    break;
                }
                weight = (weight * if small { 0.1 } else { 0.3 }).max(end);
            } else if !accepted {
                break;
            }
        }
        feasible || self.widen(c, &mut slack)
    }

    /// Widens limits that are broken, and draws in those that were; `true` where none is wide.
    fn widen(&self, c: &[f64], slack: &mut [Slack]) -> bool {
        let mut found = vec![[0.0_f64; 3]; slack.len()];
        self.each(c, &mut |k, group, _, g| found[k][group] = found[k][group].max(g));
        let mut feasible = true;
        for (wide, found) in slack.iter_mut().zip(&found) {
            for (wide, g) in wide.iter_mut().zip(found) {
                let now = (1.1 * g).max(1.0);
                *wide = if *g < 1.0 { 1.0 } else { wide.min(now) };
                feasible &= *wide <= 1.0;
            }
        }
        feasible
    }

    /// Calls with the knot, the kind of limit, the power of an even `b` that it grows with, and `g`.
    fn each(&self, c: &[f64], call: &mut dyn FnMut(usize, usize, u8, f64)) {
        let mut next = self.rates(c, 0);
        for (k, knot) in self.knots.iter().enumerate() {
            let rates = next;
            let [strict_a, strict_j, strict_s] = knot.strict;
            call(k, 0, 1, rates.b / knot.most);
            for [a, j] in &self.bounds.scales {
                call(k, 1, 2, (rates.acceleration * *a).length_squared() * strict_a);
                call(k, 1, 3, rates.b * (rates.jerk * *j).length_squared() * strict_j);
            }
            if k + 1 < self.knots.len() {
                next = self.rates(c, k + 1);
                let change =
                    next.jerk * next.b.max(0.0).sqrt() - rates.jerk * rates.b.max(0.0).sqrt();
                let per = self.bounds.snap * self.step;
                let size = change.length_squared() / (per * per);
                call(k, 2, 4, 0.5 * (rates.b + next.b) * size * strict_s);
            }
        }
    }

    /// The time in steps, and what the barriers of limits that hold and of those that do not add at
    /// weight 1; infinite outside the limits.
    fn merit(&self, c: &[f64], slack: &[Slack]) -> [f64; 3] {
        let mut found = [0.0; 3];
        for (i, tied) in ties(c.len()) {
            found[0] += 0.5 * TIE * (c[i] - c[tied]) * (c[i] - c[tied]);
        }
        // Logarithms are dear: one for many factors.
        let mut products = [1.0_f64; 2];
        let mut inside = true;
        self.each(c, &mut |k, group, power, g| {
            // The first kind is b over what it may be at most.
            if power == 1 {
                let b = g * self.knots[k].most;
                inside &= b > 0.0;
                found[0] += 1.0 / b.sqrt();
            }
            let wide = usize::from(slack[k][group] > 1.0);
            let room = 1.0 - g / slack[k][group];
            inside &= room > 0.0;
            products[wide] *= room;
            if products[wide] < 1.0e-100 {
                found[wide + 1] -= products[wide].ln();
                products[wide] = 1.0;
            }
        });
        if !inside {
            return [f64::INFINITY; 3];
        }
        found[1] -= products[0].ln();
        found[2] -= products[1].ln();
        found
    }

    /// Writes the equations of Newton's step.
    fn assemble(
        &self,
        c: &[f64],
        slack: &[Slack],
        weight: f64,
        rows: &mut Rows,
        right: &mut [f64],
    ) {
        rows.fill([1.0e-9, 0.0, 0.0, 0.0]);
        right.fill(0.0);
        let mut system = System { rows, right, weight };
        let mut next = self.local(0);
        let mut next_rates = self.rates(c, 0);
        for (k, knot) in self.knots.iter().enumerate() {
            let (local, rates) = (next, next_rates);
            let (b, root) = (rates.b, rates.b.sqrt());
            let [strict_a, strict_j, strict_s] = knot.strict;
            let (at, values) = (local.first, local.values);
            system.time(at, &values, b, root);
            let most = 1.0 / knot.most;
            let slopes = values.map(|value| value * most);
            let none = [DVec3::ZERO; 4];
            let velocity = Term { g: b * most, slopes, values: none, weight: 0.0 };
            system.add(at, slack[k][0], &velocity);
            for [a, j] in &self.bounds.scales {
                let value = rates.acceleration * *a;
                let values = local.accelerations.map(|one| one * *a);
                let slopes = values.map(|one| 2.0 * strict_a * one.dot(value));
                let g = value.length_squared() * strict_a;
                system.add(at, slack[k][1], &Term { g, slopes, values, weight: strict_a });
                let value = rates.jerk * *j;
                let values = local.jerks.map(|one| one * *j);
                let size = value.length_squared();
                let mut slopes = [0.0; 4];
                for i in 0..4 {
                    slopes[i] =
                        strict_j * (size * local.values[i] + 2.0 * b * values[i].dot(value));
                }
                let g = b * size * strict_j;
                system.add(at, slack[k][1], &Term { g, slopes, values, weight: strict_j * b });
            }
            if k + 1 == self.knots.len() {
                break;
            }
            next = self.local(k + 1);
            next_rates = self.rates(c, k + 1);
            let next_root = next_rates.b.sqrt();
            let change = next_rates.jerk * next_root - rates.jerk * root;
            let per = self.bounds.snap * self.step;
            let per = strict_s / (per * per);
            let mean = 0.5 * (b + next_rates.b);
            let size = change.length_squared();
            // Both knots are in one interval of the spline, whose coefficients are those of `at`.
            let shift = next.first - at;
            let mut values = [DVec3::ZERO; 4];
            let mut slopes = [0.0; 4];
            for i in 0..4 {
                values[i] -= local.jerks[i] * root + rates.jerk * (local.values[i] / (2.0 * root));
                slopes[i] += 0.5 * local.values[i] * size * per;
                if i + shift < 4 {
                    let more = next_rates.jerk * (next.values[i] / (2.0 * next_root));
                    values[i + shift] += next.jerks[i] * next_root + more;
                    slopes[i + shift] += 0.5 * next.values[i] * size * per;
                }
            }
            for i in 0..4 {
                slopes[i] += 2.0 * mean * per * values[i].dot(change);
            }
            let g = mean * size * per;
            system.add(at, slack[k][2], &Term { g, slopes, values, weight: mean * per });
        }
        for (i, tied) in ties(c.len()) {
            let gap = c[i] - c[tied];
            system.right[i] -= TIE * gap;
            system.right[tied] += TIE * gap;
            system.rows[i][0] += TIE;
            system.rows[tied][0] += TIE;
            system.rows[i][1] -= TIE;
        }
    }

    /// The derivatives of the rates at a knot by its coefficients.
    fn local(&self, k: usize) -> Local {
        let (first, [values, slopes, bends]) = self.basis(k);
        let [tangent, second, third] = self.knots[k].path;
        let mut local = Local { first, values: *values, ..Local::default() };
        for i in 0..4 {
            local.accelerations[i] = second * values[i] + tangent * (0.5 * slopes[i]);
            local.jerks[i] =
                third * values[i] + second * (1.5 * slopes[i]) + tangent * (0.5 * bends[i]);
        }
        local
    }
}

/// The merit: the time with the barriers at their weights.
fn sum([time, held, broken]: [f64; 3], weight: f64) -> f64 {
    time + weight * held + weight.max(DRAWN) * broken
}

/// The derivatives of the rates at a knot by its coefficients.
#[derive(Debug, Clone, Copy, Default)]
struct Local {
    first: usize,
    values: [f64; 4],
    accelerations: [DVec3; 4],
    jerks: [DVec3; 4],
}

/// The coefficients that are held together: each, and the one before it.
fn ties(n: usize) -> [(usize, usize); 6] {
    [1, 2, 3, n - 3, n - 2, n - 1].map(|i| (i, i - 1))
}

/// Newton's equations while they are put together.
struct System<'a> {
    rows: &'a mut Rows,
    right: &'a mut [f64],
    weight: f64,
}

impl System<'_> {
    /// Adds the time `1/√b`.
    fn time(&mut self, first: usize, values: &[f64; 4], b: f64, root: f64) {
        let slope = 0.5 / (b * root);
        let bend = 1.5 * slope / b;
        for i in 0..4 {
            self.right[first + i] += slope * values[i];
            for j in 0..=i {
                self.rows[first + i][i - j] += bend * values[i] * values[j];
            }
        }
    }

    /// Adds a barrier; of its second derivative, the part that is never negative.
    fn add(&mut self, first: usize, slack: f64, term: &Term) {
        let weight = if slack > 1.0 { self.weight.max(DRAWN) } else { self.weight };
        let one = weight / (slack - term.g);
        let two = one / (slack - term.g);
        let bend = 2.0 * one * term.weight;
        for i in 0..4 {
            self.right[first + i] -= one * term.slopes[i];
            let row = &mut self.rows[first + i];
            for j in 0..=i {
                row[i - j] += two * term.slopes[i] * term.slopes[j]
                    + bend * term.values[i].dot(term.values[j]);
            }
        }
    }
}
