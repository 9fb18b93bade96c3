//! A stretch of the involute of a circle, outward or inward, of either hand.
//!
//! The end of a taut thread draws it that unwinds from the base circle, of radius `R` about `C`. Once
//! the angle φ, the *roll*, has come off, the thread leaves the circle at the angle
//! `a = φ0 + hφ`, where the hand h is 1 for a thread that comes off counter-clockwise and −1 for the
//! other. With the unit vector `u(a)` its end is
//! `P = C + R (u − hφ perp(u))`, so that `dP/dφ = R φ u`: the tangent is u, the radius of curvature
//! is the thread's length Rφ, and the arc length from the base circle is `R φ² / 2`.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec2;

use super::curve::checked_point;
use super::{Bounds, Cubic, CurveError, MIN_LENGTH, Nearest, Spline, cross, perp, sin_cos, turn};

/// Smallest radius of a base circle [mm]: the rolls of longer threads would lose their digits.
const MIN_BASE_RADIUS: f64 = 1e-3;

/// Largest roll at an end [rad]: 100 turns, as FANUC controls allow.
const MAX_ROLL: f64 = 100.0 * TAU;

/// The base radius takes up what the ends are off by while it changes by less than this part.
const MAX_STRETCH: f64 = 0.1;

/// Newton steps to that radius, the first of which is nearly there.
const STRETCH_STEPS: usize = 4;

/// Most cubics or chords one involute is cut into; reached only by tolerances that rounding eats up.
const MAX_PIECES: f64 = 1e5;

/// A stretch of the involute of a circle.
///
/// # Guarantees
/// All numbers are finite; the base radius is at least 5e-4 mm, and the length at least [`MIN_LENGTH`].
/// Neither end is inside the base circle, and their rolls differ. Start and end are those given to
/// within a tenth of [`MIN_LENGTH`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Involute {
    center: DVec2,
    radius: f64,
    /// 1 where the thread comes off counter-clockwise, else −1.
    hand: f64,
    /// Angle at which the thread leaves the circle for the start [rad].
    angle: f64,
    /// Roll at the start and at the end [rad].
    rolls: [f64; 2],
}

impl Involute {
    /// The involute of the circle of `radius` about `center` from `start` to `end` [mm], as G02.2
    /// (`clockwise`) and G03.2 state it.
    ///
    /// Programs round coordinates, so the end may be off the involute through the start by up to
    /// `tolerance` [mm], and both may be inside the base circle by as much. The base radius is then
    /// the one whose involute through the start meets the end; the change of the curve grows evenly
    /// with its roll up to what the end was off. Where no radius near the given one does that, the
    /// curve is turned and stretched a little about its start.
    ///
    /// # Errors
    /// [`CurveError::OutOfRange`], [`CurveError::ZeroLength`], [`CurveError::NoBaseCircle`],
    /// [`CurveError::InsideBaseCircle`] or [`CurveError::OffInvolute`].
    pub fn new(
        start: DVec2,
        end: DVec2,
        center: DVec2,
        radius: f64,
        clockwise: bool,
        tolerance: f64,
    ) -> Result<Self, CurveError> {
        for point in [start, end, center] {
            checked_point(point)?;
        }
        if start.distance(end) < MIN_LENGTH {
            return Err(CurveError::ZeroLength);
        }
        let far = [start.distance(center), end.distance(center)];
        let least = far[0].min(far[1]);
        if radius.is_nan()
            || radius < MIN_BASE_RADIUS
            || roll(far[0].max(far[1]), radius) > MAX_ROLL
        {
            return Err(CurveError::NoBaseCircle { radius });
        }
        if least < radius - tolerance {
            return Err(CurveError::InsideBaseCircle { distance: least, radius });
        }
        let outward = far[1] > far[0];
        let hand = if outward == clockwise { -1.0 } else { 1.0 };
        let to_start = start - center;
        let swept = turn(to_start, end - center);
        // The angle between the starts, on the base circle, of the involutes through both points.
        let apart = |radius: f64| {
            let rolls = [roll(far[0], radius), roll(far[1], radius)];
            let between = swept + hand * (unrolled(rolls[0]) - unrolled(rolls[1]));
            (rolls, between - TAU * (between / TAU).round())
        };
        let (_, off) = apart(radius);
        let off = (radius * off).abs();
        if off > tolerance || far[0] == far[1] {
            return Err(CurveError::OffInvolute { off });
        }
        let mut base = radius;
        if off > 0.1 * MIN_LENGTH {
            for _ in 0..STRETCH_STEPS {
                // d(φ − atan φ)/dR = −φ/R, as dφ/dR = −(1 + φ²)/(Rφ).
                let (rolls, between) = apart(base);
                base -= base * between / (hand * (rolls[1] - rolls[0]));
                let range = [radius * (1.0 - MAX_STRETCH), least.min(radius * (1.0 + MAX_STRETCH))];
                base = base.min(range[1]).max(range[0]);
            }
        }
        let (rolls, _) = apart(base);
        let angle = to_start.y.atan2(to_start.x) + hand * rolls[0].atan();
        let found = Self { center, radius: base, hand, angle, rolls };
        if found.start().distance(start).max(found.end().distance(end)) <= 0.1 * MIN_LENGTH {
            return Ok(found);
        }
        found.between(start, end).ok_or(CurveError::OffInvolute { off })
    }

    /// The same curve turned, stretched and moved so that it runs between these ends [mm]; `None`
    /// where its own are in one place, or it leaves the range of coordinates.
    #[must_use]
    pub fn between(&self, start: DVec2, end: DVec2) -> Option<Self> {
        let (own, wanted) = (self.end() - self.start(), end - start);
        // The quotient as complex numbers: its angle turns, its length stretches.
        let by = DVec2::new(own.dot(wanted), cross(own, wanted)) / own.length_squared();
        let center = start + by.rotate(self.center - self.start());
        let (radius, angle) = (self.radius * by.length(), self.angle + by.y.atan2(by.x));
        let is_one = checked_point(center).is_ok() && radius >= 0.5 * MIN_BASE_RADIUS;
        is_one.then_some(Self { center, radius, angle, ..*self })
    }

    /// Centre of the base circle [mm].
    #[must_use]
    pub fn center(&self) -> DVec2 {
        self.center
    }

    /// Radius of the base circle [mm].
    #[must_use]
    pub fn base_radius(&self) -> f64 {
        self.radius
    }

    /// The rolls at start and end [rad]: the angles by which the thread has come off. They grow
    /// outward.
    #[must_use]
    pub fn rolls(&self) -> [f64; 2] {
        self.rolls
    }

    /// Whether it leads away from the base circle.
    #[must_use]
    pub fn is_outward(&self) -> bool {
        self.rolls[1] > self.rolls[0]
    }

    /// Whether it turns clockwise, about its centre and about that of its curvature, as G02.2 does.
    #[must_use]
    pub fn is_clockwise(&self) -> bool {
        self.is_outward() == (self.hand < 0.0)
    }

    /// The angle that its tangent turns by [rad], positive counter-clockwise; it does so evenly with
    /// the roll.
    #[must_use]
    pub fn turn(&self) -> f64 {
        self.hand * (self.rolls[1] - self.rolls[0])
    }

    /// Where it begins [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.at(self.rolls[0])
    }

    /// Where it ends [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        self.at(self.rolls[1])
    }

    /// The roll at `t` in `[0, 1]`, the part of the arc length up to there [rad].
    fn roll_at(&self, t: f64) -> f64 {
        let [from, to] = self.rolls;
        if t == 0.0 || t == 1.0 {
            return if t == 0.0 { from } else { to };
        }
        // The arc length is R φ² / 2.
        (from * from + t * (to - from) * (to + from)).max(0.0).sqrt()
    }

    /// The part of the arc length up to a roll.
    fn part_to(&self, roll: f64) -> f64 {
        let [from, to] = self.rolls;
        ((roll - from) * (roll + from) / ((to - from) * (to + from))).clamp(0.0, 1.0)
    }

    /// The part of the arc length up to the place where the tangent has turned by the part `share`
    /// of [`turn`](Self::turn).
    #[must_use]
    pub fn length_share(&self, share: f64) -> f64 {
        let [from, to] = self.rolls;
        self.part_to(from + (to - from) * share)
    }

    /// The unit vector along which the curve leads outward at a roll.
    fn outward(&self, roll: f64) -> DVec2 {
        let (sin, cos) = sin_cos(self.angle + self.hand * (roll - self.rolls[0]));
        DVec2::new(cos, sin)
    }

    /// The point at a roll [mm].
    fn at(&self, roll: f64) -> DVec2 {
        let u = self.outward(roll);
        self.center + (u - perp(u) * (self.hand * roll)) * self.radius
    }

    /// The point at `t` [mm]. The parameter is the part of the arc length up to there, so equal steps
    /// of it are equal ways along the curve.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        self.at(self.roll_at(t))
    }

    /// Unit tangent at `t`.
    #[must_use]
    pub fn tangent(&self, t: f64) -> DVec2 {
        let u = self.outward(self.roll_at(t));
        if self.is_outward() { u } else { -u }
    }

    /// Curvature at `t` [1/mm], positive where it turns left; infinite on the base circle.
    #[must_use]
    pub fn curvature(&self, t: f64) -> f64 {
        let sense = if self.is_clockwise() { -1.0 } else { 1.0 };
        sense / (self.radius * self.roll_at(t))
    }

    /// Arc length [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        let [from, to] = self.rolls;
        0.5 * self.radius * ((to - from) * (to + from)).abs()
    }

    /// The smallest box around it.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let [inner, outer] = [self.rolls[0].min(self.rolls[1]), self.rolls[0].max(self.rolls[1])];
        let mut bounds = Bounds::of([self.start(), self.end()]);
        // Farthest along an axis where the tangent is across it, and the last turn is the widest.
        let inner = inner.max(outer - TAU);
        let a = self.angle + self.hand * (inner - self.rolls[0]);
        let b = a + self.hand * (outer - inner);
        let (low, high) = (a.min(b), a.max(b));
        let mut quarter = (low / FRAC_PI_2).ceil();
        while quarter * FRAC_PI_2 <= high {
            let roll = self.rolls[0] + self.hand * (quarter * FRAC_PI_2 - self.angle);
            bounds.add(self.at(roll.max(0.0)));
            quarter += 1.0;
        }
        bounds
    }

    /// The point of it that is nearest to `point`.
    ///
    /// Its normals are the tangents of the base circle, of which two pass through a point outside.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> Nearest {
        let mut best =
            Nearest::new(0.0, self.start(), point).or_nearer(Nearest::new(1.0, self.end(), point));
        let away = point - self.center;
        let distance = away.length();
        // From inside the base circle the inner end is nearest.
        if distance < self.radius {
            return best;
        }
        let thread = roll(distance, self.radius);
        let direction = away.y.atan2(away.x);
        let [inner, outer] = [self.rolls[0].min(self.rolls[1]), self.rolls[0].max(self.rolls[1])];
        for side in [1.0, -1.0] {
            // The point is at the roll `side thread` of the involute of this hand through it.
            let angle = direction + self.hand * side * thread.atan();
            let first = self.rolls[0] + self.hand * (angle - self.angle);
            let wanted = (side * thread).max(inner).min(outer);
            let before = first + TAU * ((wanted - first) / TAU).floor();
            for roll in [before, before + TAU] {
                if roll >= inner && roll <= outer {
                    let found = Nearest::new(self.part_to(roll), self.at(roll), point);
                    best = best.or_nearer(found);
                }
            }
        }
        best
    }

    /// The same curve run the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [from, to] = self.rolls;
        Self { angle: self.angle + self.turn(), rolls: [to, from], ..*self }
    }

    /// The part between two parameters, the first of which is the smaller; `None` where it has no
    /// length.
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Option<Self> {
        self.stretch([self.roll_at(from), self.roll_at(to)])
    }

    /// The stretch of the same involute between two rolls, those before the base circle included:
    /// there it is the mirrored one.
    fn stretch(&self, [from, to]: [f64; 2]) -> Option<Self> {
        let angle = self.angle + self.hand * (from - self.rolls[0]);
        // P depends on hφ alone.
        let sign = if from + to < 0.0 { -1.0 } else { 1.0 };
        let rolls = [(sign * from).max(0.0), (sign * to).max(0.0)];
        let part = Self { angle, rolls, hand: sign * self.hand, ..*self };
        (part.length() >= MIN_LENGTH).then_some(part)
    }

    /// Calls `add` with the curve moved by `offset` [mm] to its left, in one piece or in two that
    /// meet in a cusp on the base circle.
    ///
    /// The normals stay tangents of the base circle, so the offset is an involute of it too, whose
    /// threads are shorter or longer by the offset. Where that leaves less than nothing the tool does
    /// not fit, and the offset runs against the curve.
    pub fn offset(&self, offset: f64, add: &mut dyn FnMut(Self)) {
        let outward = if self.is_outward() { 1.0 } else { -1.0 };
        // The left normal is perp(±u), along the thread or against it.
        let shift = self.hand * outward * offset / self.radius;
        let [from, to] = [self.rolls[0] - shift, self.rolls[1] - shift];
        let base = Self { rolls: [from, to], ..*self };
        // A cusp where the thread has no length left.
        let cusp = if from * to < 0.0 { 0.0 } else { to };
        for rolls in [[from, cusp], [cusp, to]] {
            if let Some(part) = base.stretch(rolls) {
                add(part);
            }
        }
    }

    /// Calls `add` with points along it after its start, up to and with its end, whose chords are
    /// within `tolerance` [mm] of it; between them the tangent turns evenly.
    pub fn flatten(&self, tolerance: f64, add: &mut dyn FnMut(DVec2)) {
        // By the roll it is |P''| = R √(1 + φ²), and a chord over h of it is off by h² |P''| / 8.
        let [from, to] = self.rolls;
        let bend = self.radius * from.max(to).hypot(1.0);
        let chords = ((to - from).abs() * (bend / (8.0 * tolerance)).sqrt()).ceil();
        let chords = chords.clamp(1.0, MAX_PIECES);
        let mut i = 1.0;
        while i < chords {
            add(self.at(from + (to - from) * (i / chords)));
            i += 1.0;
        }
        add(self.end());
    }

    /// Cubics along it that are proved to be within `tolerance` [mm] of it, and it of them. They
    /// share its tangent where they join, and none stands still at an end.
    ///
    /// The Hermite cubic of an interval h is off by at most `h⁴ max|P⁗| / 384`, and by the roll it is
    /// `P⁗ = −R (3u + φ perp(u))` but for the hand. Near the base circle, where the curve all but
    /// stands still, one cubic lies with it in the triangle of the chord and both end tangents, whose
    /// height is at most `R φ³ / 9`.
    #[must_use]
    pub fn cubics(&self, tolerance: f64) -> Vec<Cubic> {
        let [from, to] = self.rolls;
        let [inner, outer] = [from.min(to), from.max(to)];
        // φ = x^(3/8) is less than x^(1/3).
        let x = (4.0 * tolerance / self.radius).min(1.0);
        let blunt = (x.sqrt().sqrt() * x.sqrt().sqrt().sqrt()).min(outer);
        let regular = if inner < blunt { blunt } else { inner };
        let first = if regular > inner { 1.0 } else { 0.0 };
        let steepest = self.radius * outer.hypot(3.0);
        let steps = (outer - regular) * (steepest / (384.0 * tolerance)).sqrt().sqrt();
        let steps = steps.ceil().min(MAX_PIECES);
        let count = first + steps;
        let knot = |k: f64| {
            if k == 0.0 || k == count {
                return if k == 0.0 { inner } else { outer };
            }
            regular + (outer - regular) * ((k - first) / steps)
        };
        let mut cubics = Vec::new();
        let (mut before, mut start) = (from, self.at(from));
        let mut i = 1.0;
        while i <= count {
            let next = knot(if self.is_outward() { i } else { count - i });
            let end = self.at(next);
            let step = next - before;
            // A third of the derivatives by the roll, or of the chord.
            let chord = start.distance(end).copysign(step);
            let is_blunt = before.min(next) < regular;
            let third = |roll: f64| {
                let length = if is_blunt { chord } else { self.radius * roll * step };
                self.outward(roll) * (length / 3.0)
            };
            cubics.push(Cubic::new(start, start + third(before), end - third(next), end));
            (before, start) = (next, end);
            i += 1.0;
        }
        cubics
    }

    /// Its [`cubics`](Self::cubics) as a spline.
    #[must_use]
    pub fn spline(&self, tolerance: f64) -> Spline {
        Spline::joined(&self.cubics(tolerance))
    }
}

/// The roll of a point so far from the centre; zero inside the base circle.
fn roll(distance: f64, radius: f64) -> f64 {
    ((distance - radius) * (distance + radius)).max(0.0).sqrt() / radius
}

/// The angle by which the thread of a roll has come off beyond the point at its end: the involute
/// function of the pressure angle [rad].
fn unrolled(roll: f64) -> f64 {
    roll - roll.atan()
}
