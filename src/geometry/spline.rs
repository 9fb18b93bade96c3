//! The C2 cubic spline through type points.

use glam::DVec2;

use super::{
    Bounds, Cubic, CurveError, MIN_LENGTH, Nearest,
    curve::checked_point,
    tridiagonal::{Row, solve, solve_cyclic},
};

/// How an open spline ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EndCondition {
    /// Curvature zero.
    Natural,
    /// Tangent along the given direction, of any length but zero.
    Tangent(DVec2),
}

/// Both ends of a spline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SplineEnds {
    /// Two ends with a condition each.
    Open {
        /// Condition at the first type point.
        start: EndCondition,
        /// Condition at the last type point.
        end: EndCondition,
    },
    /// The last type point is the first, and the curve is C2 there too.
    Periodic,
}

impl SplineEnds {
    /// Natural at both ends.
    pub const NATURAL: Self =
        Self::Open { start: EndCondition::Natural, end: EndCondition::Natural };
}

/// How the curve's parameter is spaced between type points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Parameter {
    /// By their distance: the speed stays near one and the curve near its polygon.
    #[default]
    Chord,
    /// By the square root of their distance (Lee 1989): tighter where spacing jumps.
    Centripetal,
}

impl Parameter {
    pub(super) fn interval(self, chord: f64) -> f64 {
        match self {
            Self::Chord => chord,
            Self::Centripetal => chord.sqrt(),
        }
    }
}

/// Shortest parameter interval of a span, as a fraction of all: below it the difference of two
/// knots is made of rounding. Of a spline of a metre that is less than [`MIN_LENGTH`].
pub(super) const LEAST_INTERVAL: f64 = 1e-13;

/// The C2 cubic spline through type points.
///
/// # Guarantees
/// All type points are finite and at most 1e9 mm, successive
/// ones at least [`MIN_LENGTH`] and 1e-13 of the curve apart. There are at least two spans, or one with a tangent given
/// at an end. There is one cubic for each span, and they join with equal first and second
/// derivative by the spline's parameter. A periodic spline repeats its first type point as its
/// last.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    points: Vec<DVec2>,
    /// Parameter value of each type point, from 0 ascending.
    knots: Vec<f64>,
    pieces: Vec<Cubic>,
    ends: SplineEnds,
    parameter: Parameter,
}

impl Spline {
    /// The spline through `points` [mm], the first of which is its start.
    ///
    /// A periodic spline must repeat its first point as its last.
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`], [`CurveError::TooFewPoints`] (three are needed; two will do
    /// where a tangent is given; four for a periodic one), [`CurveError::CoincidentPoints`] or
    /// [`CurveError::NotClosed`].
    pub fn through(
        points: Vec<DVec2>,
        ends: SplineEnds,
        parameter: Parameter,
    ) -> Result<Self, CurveError> {
        let least = match ends {
            SplineEnds::Open { start: EndCondition::Natural, end: EndCondition::Natural } => 3,
            SplineEnds::Open { .. } => 2,
            SplineEnds::Periodic => 4,
        };
        if points.len() < least {
            return Err(CurveError::TooFewPoints { count: points.len(), least });
        }
        for &point in &points {
            checked_point(point)?;
        }
        for (i, pair) in points.windows(2).enumerate() {
            if pair[0].distance(pair[1]) < MIN_LENGTH {
                return Err(CurveError::CoincidentPoints { index: i + 1 });
            }
        }
        let intervals: Vec<f64> =
            points.windows(2).map(|pair| parameter.interval(pair[0].distance(pair[1]))).collect();
        let total: f64 = intervals.iter().sum();
        if let Some(i) = intervals.iter().position(|&h| h <= LEAST_INTERVAL * total) {
            return Err(CurveError::CoincidentPoints { index: i + 1 });
        }
        let derivatives = match ends {
            SplineEnds::Open { start, end } => open_derivatives(&points, &intervals, start, end),
            SplineEnds::Periodic => {
                if points[0].distance(points[points.len() - 1]) >= MIN_LENGTH {
                    return Err(CurveError::NotClosed);
                }
                periodic_derivatives(&points, &intervals)
            }
        };
        let (knots, pieces) = spans_of(&points, &intervals, &derivatives);
        Ok(Self { points, knots, pieces, ends, parameter })
    }

    /// The spline of some spans, given by their points, parameter intervals and derivatives there,
    /// which are those of a spline already.
    pub(super) fn of_spans(
        points: &[DVec2],
        intervals: &[f64],
        derivatives: &[DVec2],
        parameter: Parameter,
    ) -> Self {
        let (knots, pieces) = spans_of(points, intervals, derivatives);
        let ends = SplineEnds::Open {
            start: EndCondition::Tangent(derivatives[0]),
            end: EndCondition::Tangent(derivatives[intervals.len()]),
        };
        Self { points: points.to_vec(), knots, pieces, ends, parameter }
    }

    /// The type points [mm], start and end among them.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The cubics between successive type points.
    #[must_use]
    pub fn pieces(&self) -> &[Cubic] {
        &self.pieces
    }

    /// How it ends.
    #[must_use]
    pub fn ends(&self) -> SplineEnds {
        self.ends
    }

    /// How its parameter is spaced.
    #[must_use]
    pub fn parameter(&self) -> Parameter {
        self.parameter
    }

    /// Whether its end is smoothly its start.
    #[must_use]
    pub fn is_periodic(&self) -> bool {
        self.ends == SplineEnds::Periodic
    }

    /// The first type point [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.points[0]
    }

    /// The last type point [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        self.points[self.points.len() - 1]
    }

    /// The span that holds `t` in `[0, 1]`, and the parameter on its cubic.
    #[must_use]
    pub fn locate(&self, t: f64) -> (usize, f64) {
        let last = self.pieces.len() - 1;
        let u = t * self.knots[last + 1];
        let span = self.knots[1..=last].partition_point(|&knot| knot <= u);
        let h = self.knots[span + 1] - self.knots[span];
        (span, ((u - self.knots[span]) / h).clamp(0.0, 1.0))
    }

    /// The parameter in `[0, 1]` of the whole spline that is `local` on the cubic of `span`.
    #[must_use]
    pub fn parameter_at(&self, span: usize, local: f64) -> f64 {
        let (from, to) = (self.knots[span], self.knots[span + 1]);
        (from + (to - from) * local) / self.knots[self.knots.len() - 1]
    }

    /// The point at `t` [mm].
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        let (span, local) = self.locate(t);
        self.pieces[span].point(local)
    }

    /// First derivative by `t` in `[0, 1]` [mm].
    #[must_use]
    pub fn derivative(&self, t: f64) -> DVec2 {
        let (span, local) = self.locate(t);
        self.pieces[span].derivative(local) * self.stretch(span)
    }

    /// Second derivative by `t` in `[0, 1]` [mm].
    #[must_use]
    pub fn second_derivative(&self, t: f64) -> DVec2 {
        let (span, local) = self.locate(t);
        self.pieces[span].second_derivative(local) * self.stretch(span).powi(2)
    }

    /// Change of a span's own parameter by `t`.
    fn stretch(&self, span: usize) -> f64 {
        self.knots[self.knots.len() - 1] / (self.knots[span + 1] - self.knots[span])
    }

    /// Unit tangent at `t`.
    #[must_use]
    pub fn tangent(&self, t: f64) -> DVec2 {
        let (span, local) = self.locate(t);
        self.pieces[span].tangent(local)
    }

    /// Curvature at `t` [1/mm], positive to the left.
    #[must_use]
    pub fn curvature(&self, t: f64) -> f64 {
        let (span, local) = self.locate(t);
        self.pieces[span].curvature(local)
    }

    /// Arc length [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(Cubic::length).sum()
    }

    /// The smallest box around the curve.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.pieces.iter().map(Cubic::bounds).fold(Bounds::EMPTY, Bounds::union)
    }

    /// The point of the curve nearest to `point`.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> Nearest {
        let mut best = Nearest::new(0.0, self.start(), point);
        for (span, piece) in self.pieces.iter().enumerate() {
            if piece.hull_bounds().distance(point) < best.distance {
                let found = piece.nearest(point);
                if found.distance < best.distance {
                    best = Nearest { t: self.parameter_at(span, found.t), ..found };
                }
            }
        }
        best
    }

    /// The same curve run the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let flip = |end| match end {
            EndCondition::Natural => EndCondition::Natural,
            EndCondition::Tangent(tangent) => EndCondition::Tangent(-tangent),
        };
        let total = self.knots[self.knots.len() - 1];
        Self {
            points: self.points.iter().rev().copied().collect(),
            knots: self.knots.iter().rev().map(|knot| total - knot).collect(),
            pieces: self.pieces.iter().rev().map(Cubic::reversed).collect(),
            ends: match self.ends {
                SplineEnds::Open { start, end } => {
                    SplineEnds::Open { start: flip(end), end: flip(start) }
                }
                SplineEnds::Periodic => SplineEnds::Periodic,
            },
            parameter: self.parameter,
        }
    }

    /// Both parts of the curve cut at `t`, strictly inside `(0, 1)`; exactly the same curve, so a
    /// part is in general not the spline through its type points alone.
    ///
    /// # Errors
    /// [`CurveError::ZeroLength`] where the cut is within [`MIN_LENGTH`] of an end.
    pub fn split(&self, t: f64) -> Result<(Self, Self), CurveError> {
        let middle = self.point(t);
        let ahead = self.derivative(t);
        if middle.distance(self.start()) < MIN_LENGTH && t < 0.5
            || middle.distance(self.end()) < MIN_LENGTH && t > 0.5
            || t <= 0.0
            || t >= 1.0
        {
            return Err(CurveError::ZeroLength);
        }
        let (span, local) = self.locate(t);
        let knot = self.knots[span] + (self.knots[span + 1] - self.knots[span]) * local;
        let (start, end) = match self.ends {
            SplineEnds::Open { start, end } => (start, end),
            SplineEnds::Periodic => {
                let tangent = EndCondition::Tangent(self.tangent(0.0));
                (tangent, tangent)
            }
        };
        let cut = EndCondition::Tangent(ahead);
        // A cut on a type point adds no span of its own.
        let on_start = middle.distance(self.points[span]) < MIN_LENGTH;
        let on_end = middle.distance(self.points[span + 1]) < MIN_LENGTH;
        let (left, right) = self.pieces[span].split(local);
        let before = if on_start { span } else { span + 1 };
        let mut first = Self {
            points: self.points[..before].to_vec(),
            knots: self.knots[..before].to_vec(),
            pieces: self.pieces[..span].to_vec(),
            ends: SplineEnds::Open { start, end: cut },
            parameter: self.parameter,
        };
        first.points.push(middle);
        first.knots.push(knot);
        if !on_start {
            first.pieces.push(left);
        }
        let after = if on_end { span + 2 } else { span + 1 };
        let mut second = Self {
            points: vec![middle],
            knots: vec![0.0],
            pieces: Vec::new(),
            ends: SplineEnds::Open { start: cut, end },
            parameter: self.parameter,
        };
        if !on_end {
            second.pieces.push(right);
        }
        second.points.extend_from_slice(&self.points[after..]);
        second.knots.extend(self.knots[after..].iter().map(|k| k - knot));
        second.pieces.extend_from_slice(&self.pieces[span + 1..]);
        Ok((first, second))
    }
}

/// Parameter values of the type points, and the cubics between them.
fn spans_of(points: &[DVec2], intervals: &[f64], derivatives: &[DVec2]) -> (Vec<f64>, Vec<Cubic>) {
    let mut knots = Vec::with_capacity(points.len());
    let mut pieces = Vec::with_capacity(intervals.len());
    knots.push(0.0);
    for (i, &h) in intervals.iter().enumerate() {
        knots.push(knots[i] + h);
        let (d0, d1) = (derivatives[i] * h, derivatives[i + 1] * h);
        pieces.push(Cubic::hermite(points[i], d0, points[i + 1], d1));
    }
    (knots, pieces)
}

/// The row that makes the second derivative continuous at a type point with the span `before`
/// behind and the span `after` ahead of it (de Boor, A Practical Guide to Splines, ch. IV).
pub(super) fn continuity_row(before: (DVec2, f64), after: (DVec2, f64)) -> Row {
    let ((chord0, h0), (chord1, h1)) = (before, after);
    Row {
        lower: h1,
        diagonal: 2.0 * (h0 + h1),
        upper: h0,
        right: (chord0 * (h1 / h0) + chord1 * (h0 / h1)) * 3.0,
    }
}

/// Chord and parameter interval of span `i`.
fn span(points: &[DVec2], intervals: &[f64], i: usize) -> (DVec2, f64) {
    (points[i + 1] - points[i], intervals[i])
}

/// Derivatives at the type points of an open spline.
fn open_derivatives(
    points: &[DVec2],
    intervals: &[f64],
    start: EndCondition,
    end: EndCondition,
) -> Vec<DVec2> {
    let last = points.len() - 1;
    let mut rows = Vec::with_capacity(points.len());
    for i in 0..=last {
        rows.push(if i == 0 {
            let (chord, h) = span(points, intervals, 0);
            end_row(start, chord, h, false)
        } else if i == last {
            let (chord, h) = span(points, intervals, last - 1);
            end_row(end, chord, h, true)
        } else {
            continuity_row(span(points, intervals, i - 1), span(points, intervals, i))
        });
    }
    solve(&rows)
}

/// The row of an end's condition.
pub(super) fn end_row(condition: EndCondition, chord: DVec2, h: f64, at_end: bool) -> Row {
    match condition {
        EndCondition::Natural => Row {
            lower: if at_end { 1.0 } else { 0.0 },
            diagonal: 2.0,
            upper: if at_end { 0.0 } else { 1.0 },
            right: chord * (3.0 / h),
        },
        // The speed of the chord: the given direction bends the curve, its length does not.
        EndCondition::Tangent(tangent) => Row {
            lower: 0.0,
            diagonal: 1.0,
            upper: 0.0,
            right: tangent.normalize_or(chord.normalize()) * (chord.length() / h),
        },
    }
}

/// Derivatives at the type points of a periodic spline, the first repeated as the last.
fn periodic_derivatives(points: &[DVec2], intervals: &[f64]) -> Vec<DVec2> {
    let spans = points.len() - 1;
    let rows: Vec<Row> = (0..spans)
        .map(|i| {
            let before = if i == 0 { spans - 1 } else { i - 1 };
            continuity_row(span(points, intervals, before), span(points, intervals, i))
        })
        .collect();
    let mut derivatives = solve_cyclic(&rows);
    derivatives.push(derivatives[0]);
    derivatives
}
