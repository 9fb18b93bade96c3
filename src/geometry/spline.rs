//! Cubic splines: the C2 one through type points, and chains of cubics given as they are.

use glam::DVec2;

use super::{
    Bounds, Cubic, CurveError, MIN_LENGTH, Nearest,
    curve::checked_point,
    spline_rows::{open_derivatives, periodic_derivatives, spans_of},
    turn,
};

/// How an open spline ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EndCondition {
    /// Curvature zero.
    Natural,
    /// Tangent along the given direction, of any length but zero.
    Tangent(DVec2),
    /// The two spans at the end are one cubic (not-a-knot); of fewer than three spans, the one at
    /// the end is a parabola.
    NotAKnot,
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

/// Largest turn between two cubics of one spline [rad]: rounding of the coordinates that cubics are
/// given by. What turns more is a corner between two splines.
const SMOOTH: f64 = 1e-10;

/// A cubic spline: the C2 one through type points, or cubics given as they are.
///
/// # Guarantees
/// All points are finite and at most 1e9 mm. There is one cubic for each span between successive
/// points, and the cubics join with one tangent.
///
/// Through type points: successive ones are at least [`MIN_LENGTH`] and 1e-13 of the curve apart.
/// There are at least two spans, or one with a tangent given at an end. The cubics join with equal
/// first and second derivative by the spline's parameter. A periodic spline repeats its first type
/// point as its last.
///
/// Of given cubics: the control polygon of each is at least [`MIN_LENGTH`] and 1e-13 of all long.
/// Curvature may jump where they join.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    /// Where the spans join, start and end among them.
    points: Vec<DVec2>,
    /// Parameter value of each type point, from 0 ascending.
    knots: Vec<f64>,
    pieces: Vec<Cubic>,
    ends: SplineEnds,
    parameter: Parameter,
    /// Whether it is the C2 spline through its points, as `ends` and `parameter` tell.
    through_points: bool,
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
            SplineEnds::Open { start: EndCondition::Tangent(_), .. }
            | SplineEnds::Open { end: EndCondition::Tangent(_), .. } => 2,
            SplineEnds::Open { .. } => 3,
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
        Ok(Self { points, knots, pieces, ends, parameter, through_points: true })
    }

    /// Splines of cubics that follow each other [mm], as they are: a new one begins wherever they
    /// turn a corner.
    ///
    /// Each cubic is taken to start where the one before it ends. One whose control polygon has no
    /// length is left out; one that ends where it starts is cut in half.
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`], or [`CurveError::ZeroLength`] where nothing is left.
    pub fn of_cubics(cubics: &[Cubic]) -> Result<Vec<Self>, CurveError> {
        let mut total = 0.0;
        for cubic in cubics {
            for point in cubic.points {
                checked_point(point)?;
            }
            total += cubic.hull_length();
        }
        let least = MIN_LENGTH.max(LEAST_INTERVAL * total);
        let mut splines: Vec<Self> = Vec::new();
        let mut at = None;
        for cubic in cubics {
            if cubic.hull_length() < least {
                continue;
            }
            let mut cubic = *cubic;
            cubic.points[0] = at.unwrap_or(cubic.start());
            at = Some(cubic.end());
            if cubic.start().distance(cubic.end()) < least {
                let (first, second) = cubic.split(0.5);
                append(&mut splines, first);
                append(&mut splines, second);
            } else {
                append(&mut splines, cubic);
            }
        }
        for spline in &mut splines {
            let [start, end] = [0.0, 1.0].map(|t| EndCondition::Tangent(spline.tangent(t)));
            spline.ends = SplineEnds::Open { start, end };
        }
        if splines.is_empty() { Err(CurveError::ZeroLength) } else { Ok(splines) }
    }

    /// The spline of cubics that follow each other with one tangent, whatever rounding makes of it.
    pub(super) fn joined(cubics: &[Cubic]) -> Self {
        let mut spline = one_cubic(cubics[0]);
        for cubic in &cubics[1..] {
            spline.push(*cubic);
        }
        let [start, end] = [0.0, 1.0].map(|t| EndCondition::Tangent(spline.tangent(t)));
        Self { ends: SplineEnds::Open { start, end }, ..spline }
    }

    /// Appends a cubic that goes on from the last one.
    fn push(&mut self, cubic: Cubic) {
        self.points.push(cubic.end());
        self.knots.push(self.knots[self.pieces.len()] + cubic.hull_length());
        self.pieces.push(cubic);
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
        Self { points: points.to_vec(), knots, pieces, ends, parameter, through_points: true }
    }

    /// Whether it is a spline through its points, and not one of cubics given as they are.
    #[must_use]
    pub fn is_through_points(&self) -> bool {
        self.through_points
    }

    /// The type points, or where given cubics join, start and end among them [mm].
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The cubics between successive points.
    #[must_use]
    pub fn pieces(&self) -> &[Cubic] {
        &self.pieces
    }

    /// How it ends; one of given cubics with its own tangents.
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

    /// Its first point [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.points[0]
    }

    /// Its last point [mm].
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
            EndCondition::Natural | EndCondition::NotAKnot => end,
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
            ..*self
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
            ..*self
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
            ..*self
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

/// Appends a cubic to the last of some splines, or to a new one where it turns a corner.
fn append(splines: &mut Vec<Spline>, cubic: Cubic) {
    if let Some(last) = splines.last_mut() {
        let before = last.pieces[last.pieces.len() - 1].tangent(1.0);
        if turn(before, cubic.tangent(0.0)).abs() <= SMOOTH {
            last.push(cubic);
            return;
        }
    }
    splines.push(one_cubic(cubic));
}

/// The spline of one given cubic, its ends not yet told.
fn one_cubic(cubic: Cubic) -> Spline {
    Spline {
        points: vec![cubic.start(), cubic.end()],
        knots: vec![0.0, cubic.hull_length()],
        pieces: vec![cubic],
        ends: SplineEnds::NATURAL,
        parameter: Parameter::Chord,
        through_points: false,
    }
}
