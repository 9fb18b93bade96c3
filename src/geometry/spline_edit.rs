//! A C2 spline that is edited point by point: each edit solves its neighbourhood afresh.
//!
//! The derivatives at the type points solve a tridiagonal system whose diagonal is twice the sum
//! of the rest of its row. What changes at one point so changes its neighbour by less than half as
//! much (0.268 times for even spacing). Beyond [`WINDOW`] points nothing is left of it, and the
//! rows in between, held at both rims by the derivatives that are known there, give what solving
//! the whole system gives. Every edit forgets what rounding those before it have left in its
//! window, so that errors do not add up.

use glam::DVec2;

use super::spline::LEAST_INTERVAL;
use super::spline_rows::{continuity_row, end_row};
use super::tridiagonal::{Row, solve, solve_cyclic};
use super::{Cubic, CurveError, MIN_LENGTH, Parameter, Spline, SplineEnds};

/// Points on each side of an edit that are solved again: 2⁻⁵⁶ of a change is below its rounding.
const WINDOW: usize = 56;

/// Spans that an edit has changed; those of a periodic spline go on from the last to the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ChangedSpans {
    /// Index of the first.
    pub first: usize,
    /// How many.
    pub count: usize,
}

/// What counts as a change of a span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Least {
    /// How far a parallel curve that follows the spline is from it [mm].
    pub beside: f64,
    /// How far a point of that curve must move [mm].
    pub by: f64,
}

/// A C2 cubic spline whose type points can be moved, inserted and removed.
///
/// # Guarantees
/// Those of [`Spline`]; in particular, a periodic one repeats its first type point as its last.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineEdit {
    points: Vec<DVec2>,
    /// Parameter interval of each span.
    intervals: Vec<f64>,
    /// Derivative by the parameter at each type point.
    derivatives: Vec<DVec2>,
    /// What each was when its spans were last told to have changed, so that what edits leave below
    /// the threshold does not add up.
    told: Vec<DVec2>,
    /// Sum of the intervals.
    total: f64,
    ends: SplineEnds,
    parameter: Parameter,
}

impl SplineEdit {
    /// The same spline, to be edited.
    #[must_use]
    pub fn new(spline: &Spline) -> Self {
        let points = spline.points().to_vec();
        let parameter = spline.parameter();
        let intervals: Vec<f64> =
            points.windows(2).map(|pair| parameter.interval(pair[0].distance(pair[1]))).collect();
        let total = intervals.iter().sum();
        let (ends, derivatives) = (spline.ends(), vec![DVec2::ZERO; points.len()]);
        let told = Vec::new();
        let mut edit = Self { points, intervals, derivatives, told, total, ends, parameter };
        edit.solve_all();
        edit.told.clone_from(&edit.derivatives);
        edit
    }

    /// The type points [mm], start and end among them.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Number of spans.
    #[must_use]
    pub fn spans(&self) -> usize {
        self.intervals.len()
    }

    /// How it ends.
    #[must_use]
    pub fn ends(&self) -> SplineEnds {
        self.ends
    }

    /// The cubic of a span.
    #[must_use]
    pub fn cubic(&self, span: usize) -> Cubic {
        let h = self.intervals[span];
        let (d0, d1) = (self.derivatives[span] * h, self.derivatives[span + 1] * h);
        Cubic::hermite(self.points[span], d0, self.points[span + 1], d1)
    }

    /// The spans from `first` on as a spline of their own, exactly the same curve.
    #[must_use]
    pub fn part(&self, first: usize, count: usize) -> Spline {
        let (spans, points) = (first..first + count, first..=first + count);
        Spline::of_spans(
            &self.points[points.clone()],
            &self.intervals[spans],
            &self.derivatives[points],
            self.parameter,
        )
    }

    /// Moves type point `index` to `to` [mm]; both ends of a periodic spline move together.
    ///
    /// # Errors
    /// [`CurveError::CoincidentPoints`], where it would fall on a neighbour; nothing is changed.
    pub fn move_point(
        &mut self,
        index: usize,
        to: DVec2,
        least: Least,
    ) -> Result<ChangedSpans, CurveError> {
        let last = self.spans();
        let both = self.is_periodic() && (index == 0 || index == last);
        let index = if both { 0 } else { index };
        let before = if both { last.checked_sub(1) } else { index.checked_sub(1) };
        let checked = |neighbour: usize| self.checked(self.points[neighbour], to, index);
        let interval_before = before.map(checked).transpose()?;
        let interval_after = (index < last).then(|| checked(index + 1)).transpose()?;
        self.points[index] = to;
        if both {
            self.points[last] = to;
        }
        for (span, interval) in [(before, interval_before), (Some(index), interval_after)] {
            if let Some((span, interval)) = span.zip(interval) {
                self.total += interval - self.intervals[span];
                self.intervals[span] = interval;
            }
        }
        Ok(self.solve_around(index, least))
    }

    /// Inserts a type point [mm] before the one at `index`, which is not the first.
    ///
    /// # Errors
    /// [`CurveError::CoincidentPoints`], where it would fall on a neighbour; nothing is changed.
    pub fn insert_point(
        &mut self,
        index: usize,
        point: DVec2,
        least: Least,
    ) -> Result<ChangedSpans, CurveError> {
        let before = self.checked(self.points[index - 1], point, index)?;
        let after = self.checked(self.points[index], point, index)?;
        self.total += before + after - self.intervals[index - 1];
        self.points.insert(index, point);
        self.intervals[index - 1] = before;
        self.intervals.insert(index, after);
        self.derivatives.insert(index, DVec2::ZERO);
        self.told.insert(index, DVec2::ZERO);
        Ok(self.solve_around(index, least))
    }

    /// Removes an inner type point, of more than the fewest that there must be.
    ///
    /// # Errors
    /// [`CurveError::CoincidentPoints`], where its neighbours coincide; nothing is changed.
    pub fn remove_point(&mut self, index: usize, least: Least) -> Result<ChangedSpans, CurveError> {
        let interval = self.checked(self.points[index - 1], self.points[index + 1], index)?;
        self.total += interval - self.intervals[index - 1] - self.intervals[index];
        self.points.remove(index);
        self.derivatives.remove(index);
        self.told.remove(index);
        self.intervals.remove(index);
        self.intervals[index - 1] = interval;
        Ok(self.solve_around(index, least))
    }

    /// Changes how an open spline ends; `None` where both ends stay as they are.
    pub fn set_ends(&mut self, ends: SplineEnds, least: Least) -> Option<ChangedSpans> {
        if ends == self.ends {
            return None;
        }
        self.ends = ends;
        let (first, last) =
            (self.solve_around(0, least), self.solve_around(self.points.len() - 1, least));
        // Whatever lies between is small, or is done again without need.
        let start = first.first.min(last.first);
        let end = (first.first + first.count).max(last.first + last.count);
        Some(ChangedSpans { first: start, count: end - start })
    }

    fn is_periodic(&self) -> bool {
        self.ends == SplineEnds::Periodic
    }

    /// The interval between two points that are to be neighbours; `index` is that of one of them.
    fn checked(&self, a: DVec2, b: DVec2, index: usize) -> Result<f64, CurveError> {
        let chord = a.distance(b);
        let interval = self.parameter.interval(chord);
        if chord < MIN_LENGTH || interval <= LEAST_INTERVAL * (self.total + interval) {
            return Err(CurveError::CoincidentPoints { index });
        }
        Ok(interval)
    }

    /// Number of unknown derivatives.
    fn unknowns(&self) -> usize {
        if self.is_periodic() { self.spans() } else { self.points.len() }
    }

    /// The row of the system that belongs to type point `i`.
    fn row(&self, i: usize) -> Row {
        let span = |i: usize| (self.points[i + 1] - self.points[i], self.intervals[i]);
        match self.ends {
            SplineEnds::Open { start, .. } if i == 0 => {
                end_row(start, span(0), (self.spans() > 2).then(|| span(1)), false)
            }
            SplineEnds::Open { end, .. } if i == self.spans() => {
                end_row(end, span(i - 1), (self.spans() > 2).then(|| span(i - 2)), true)
            }
            SplineEnds::Open { .. } => continuity_row(span(i - 1), span(i)),
            SplineEnds::Periodic => {
                let before = if i == 0 { self.spans() - 1 } else { i - 1 };
                continuity_row(span(before), span(i))
            }
        }
    }

    /// Solves the whole system.
    fn solve_all(&mut self) {
        let rows: Vec<Row> = (0..self.unknowns()).map(|i| self.row(i)).collect();
        if self.is_periodic() {
            self.derivatives = solve_cyclic(&rows);
            self.derivatives.push(self.derivatives[0]);
        } else {
            self.derivatives = solve(&rows);
        }
    }

    /// Solves the system around type point `index`, the row of which and those beside it have
    /// changed, and tells which spans are different now.
    fn solve_around(&mut self, index: usize, least: Least) -> ChangedSpans {
        let unknowns = self.unknowns();
        let periodic = self.is_periodic();
        let index = if periodic { index % unknowns } else { index };
        let whole = periodic && unknowns < 2 * WINDOW + 3;
        let (first, count) = if whole {
            (0, unknowns)
        } else if periodic {
            ((index + unknowns - WINDOW) % unknowns, 2 * WINDOW + 1)
        } else {
            let first = index.saturating_sub(WINDOW);
            (first, (index + WINDOW + 1).min(unknowns) - first)
        };
        let place = |k: usize| (first + k) % unknowns;
        if whole {
            self.solve_all();
        } else {
            let mut rows: Vec<Row> = (0..count).map(|k| self.row(place(k))).collect();
            // At the rims the derivatives are known; the row of an end has nothing beyond it.
            if periodic || first > 0 {
                let known = self.derivatives[(first + unknowns - 1) % unknowns];
                let lower = std::mem::take(&mut rows[0].lower);
                rows[0].right -= known * lower;
            }
            if periodic || first + count < unknowns {
                let last = &mut rows[count - 1];
                last.right -= self.derivatives[place(count)] * last.upper;
                last.upper = 0.0;
            }
            for (k, derivative) in solve(&rows).into_iter().enumerate() {
                self.derivatives[place(k)] = derivative;
            }
            if periodic {
                self.derivatives[unknowns] = self.derivatives[0];
            }
        }
        let at = (index + unknowns - first) % unknowns;
        let changed = |k: usize| {
            let change = self.derivatives[place(k)].distance(self.told[place(k)]);
            change * self.lever(place(k), least.beside) > least.by
        };
        let low = (0..at).find(|&k| changed(k)).unwrap_or(at);
        let high = (at..count).rev().find(|&k| changed(k)).unwrap_or(at);
        for k in low..=high {
            self.told[place(k)] = self.derivatives[place(k)];
        }
        // A derivative belongs to the spans on both sides; those beside the point itself differ
        // even where no derivative does.
        let spans = self.spans();
        if periodic {
            let count = (high + 2 - low).min(spans);
            return ChangedSpans { first: (place(low) + spans - 1) % spans, count };
        }
        let start = place(low).saturating_sub(1);
        ChangedSpans { first: start, count: (place(high) + 1).min(spans) - start }
    }

    /// How far a change of the derivative at type point `i` moves a curve `beside` the spline, at
    /// most: the spans themselves by less than their interval, and their normals, which turn by the
    /// change over the speed.
    fn lever(&self, i: usize, beside: f64) -> f64 {
        let lever = |span: usize| {
            let h = self.intervals[span];
            let speed = (self.points[span + 1] - self.points[span]).length() / h;
            h + beside / speed
        };
        let before = if i > 0 { lever(i - 1) } else { 0.0 };
        let after = if i < self.spans() { lever(i) } else { 0.0 };
        before.max(after)
    }
}
