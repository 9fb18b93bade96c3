//! What becomes of the corners and legs of a polygon: corners that stay, straight lines that stay,
//! and how fine a spline must be for the rest.

use glam::DVec3;

/// A corner of the thinned polygon.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vertex {
    /// Where it is [mm].
    pub(super) point: DVec3,
    /// Where it is along the polygon [mm]; not before the one before, though maybe at its place.
    pub(super) place: f64,
    /// The turn of the polygon there when looked at coarsely [rad]; 0 if it is not seen.
    pub(super) turn: f64,
    /// Whether the leg that ends here is a whole move as it was given.
    pub(super) exact: bool,
}

/// What becomes of a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A spline passes it.
    Smooth,
    /// It stays a corner, with straight legs on both sides by which it may be rounded.
    Corner,
    /// A spline cannot pass it: the path turns back.
    Reversal,
}

/// The distance between knots [tolerance] times the turn [rad] that a spline rounds there. Measured:
/// finer knots hardly make the spline smoother, coarser ones do not let it use all its room.
const FINENESS: f64 = 5.0;

/// By how much the distance between knots may grow per length: it is known at the corners, and
/// where it changes faster the spline's curvature shows it.
const GROWTH: f64 = 0.3;

/// The largest distance between knots [tolerance].
const COARSEST: f64 = 200.0;

/// How far a spline that rounds a corner must reach into a straight leg, in distances between knots.
const REACH: f64 = 4.0;

/// From this turn on a corner between straight legs stays one [rad].
const CORNER: f64 = 0.6;

/// From this turn on no spline passes [rad].
const REVERSAL: f64 = 2.3;

/// The leg that the rounding of a corner takes [tolerance] times its turn [rad].
const CORNER_LEG: f64 = 5.5;

/// To keep a corner, the spline next to it may be drawn together to this part.
const LEAST_ROOM: f64 = 0.25;

/// Below this turn two legs are one line [rad].
const COLLINEAR: f64 = 1e-9;

/// The plan for some vertices in a row; the first and the last of them are ends.
#[derive(Debug, Default)]
pub(super) struct Layout {
    /// Per vertex, what becomes of it.
    pub(super) kinds: Vec<Kind>,
    /// Per vertex, the distance between knots there [mm].
    pub(super) steps: Vec<f64>,
    /// Per leg from a vertex to the next, whether a part of it stays straight.
    pub(super) straight: Vec<bool>,
    /// Per vertex, the turn there [rad].
    pub(super) turns: Vec<f64>,
    /// The tolerance [mm].
    tolerance: f64,
}

impl Layout {
    /// Plans for the vertices.
    pub(super) fn new(vertices: &[Vertex], tolerance: f64) -> Self {
        let count = vertices.len();
        let mut layout = Self {
            kinds: vec![Kind::Smooth; count],
            steps: vec![COARSEST * tolerance; count],
            straight: vec![false; count],
            turns: vec![0.0; count],
            tolerance,
        };
        for i in 1..count - 1 {
            layout.turns[i] = turn(vertices, [i - 1, i, i + 1]);
            let need = layout.corner_leg(i);
            let legs = [length(vertices, i - 1), length(vertices, i)];
            if layout.turns[i] > CORNER && legs[0].min(legs[1]) > need {
                layout.kinds[i] = Kind::Corner;
            }
        }
        layout.see_turns(vertices);
        layout.grade(vertices);
        layout.settle(vertices);
        layout
    }

    /// How much of its legs the rounding of a corner takes [mm].
    fn corner_leg(&self, i: usize) -> f64 {
        CORNER_LEG * self.tolerance / self.turns[i]
    }

    /// How far a spline that passes a vertex must at least reach into a straight leg [mm].
    fn least_reach(&self, i: usize) -> f64 {
        let is_end = i == 0 || i + 1 == self.kinds.len();
        if self.kinds[i] != Kind::Smooth || is_end || self.turns[i] < COLLINEAR {
            return 0.0;
        }
        REACH * self.steps[i]
    }

    /// What the ends of a leg need at least before any of it is straight [mm].
    fn need(&self, leg: usize) -> f64 {
        let mut need = 0.0;
        for end in [leg, leg + 1] {
            need += match self.kinds[end] {
                Kind::Corner => self.corner_leg(end),
                Kind::Smooth | Kind::Reversal => self.least_reach(end),
            };
        }
        need
    }

    /// How far the spline that passes one end of a straight leg reaches into it [mm]: up to twice
    /// what it must, if there is room.
    pub(super) fn reach(&self, vertices: &[Vertex], leg: usize, end: usize) -> f64 {
        let room = length(vertices, leg) / self.need(leg).max(f64::MIN_POSITIVE);
        self.least_reach(end) * room.min(2.0)
    }

    /// Sets how fine a spline must be, from how the polygon turns when looked at coarsely.
    fn see_turns(&mut self, vertices: &[Vertex]) {
        for at in 1..vertices.len() - 1 {
            let turn = vertices[at].turn;
            if turn == 0.0 || self.kinds[at] == Kind::Corner {
                continue;
            }
            self.steps[at] = self.steps[at].min(FINENESS * self.tolerance / turn);
            if turn > REVERSAL {
                // The point of the reversal is among the vertices nearby.
                let (mut tip, place) = (at, vertices[at].place);
                for (i, vertex) in vertices.iter().enumerate() {
                    let near = (vertex.place - place).abs() < self.tolerance;
                    if near && self.turns[i] > self.turns[tip] {
                        tip = i;
                    }
                }
                self.kinds[tip] = Kind::Reversal;
            }
        }
    }

    /// Lets the distance between knots grow slowly only.
    pub(super) fn grade(&mut self, vertices: &[Vertex]) {
        for i in 1..vertices.len() {
            self.steps[i] = self.steps[i].min(self.steps[i - 1] + GROWTH * length(vertices, i - 1));
        }
        for i in (1..vertices.len()).rev() {
            let step = self.steps[i] + GROWTH * length(vertices, i - 1);
            self.steps[i - 1] = self.steps[i - 1].min(step);
        }
    }

    /// Finds the legs that stay straight, and the corners that stay because both of theirs do.
    fn settle(&mut self, vertices: &[Vertex]) {
        loop {
            let mut settled = true;
            for i in 0..vertices.len() - 1 {
                self.straight[i] = length(vertices, i) > self.need(i);
            }
            for i in 1..vertices.len() - 1 {
                for leg in [i - 1, i] {
                    if self.kinds[i] == Kind::Corner && !self.straight[leg] {
                        let other = if leg == i { i + 1 } else { leg };
                        settled &= self.is_kept(vertices, i, leg, other);
                    }
                }
            }
            if settled {
                return;
            }
            self.grade(vertices);
        }
    }

    /// Gives up a corner for want of a straight leg, unless there is another way.
    fn is_kept(&mut self, vertices: &[Vertex], corner: usize, leg: usize, other: usize) -> bool {
        if self.kinds[other] == Kind::Corner && self.turns[other] < self.turns[corner] {
            // The other one is given up.
            return true;
        }
        let left = (length(vertices, leg) - self.corner_leg(corner)) / (1.001 * REACH);
        if self.kinds[other] == Kind::Smooth && left > LEAST_ROOM * self.steps[other] {
            self.steps[other] = self.steps[other].min(left);
        } else {
            self.kinds[corner] = Kind::Smooth;
            self.steps[corner] = FINENESS * self.tolerance / self.turns[corner];
        }
        false
    }

    /// The distance between knots at a place on the leg from a vertex [mm].
    pub(super) fn step(&self, vertices: &[Vertex], leg: usize, place: f64) -> f64 {
        let before = self.steps[leg] + GROWTH * (place - vertices[leg].place).max(0.0);
        before.min(self.steps[leg + 1] + GROWTH * (vertices[leg + 1].place - place).max(0.0))
    }
}

/// The length of the leg from a vertex [mm].
fn length(vertices: &[Vertex], leg: usize) -> f64 {
    vertices[leg + 1].place - vertices[leg].place
}

/// The angle between the lines from the first vertex to the second and from there to the third
/// [rad].
fn turn(vertices: &[Vertex], at: [usize; 3]) -> f64 {
    let [a, b, c] = at.map(|i| vertices[i].point);
    let (before, after) = (b - a, c - b);
    before.cross(after).length().atan2(before.dot(after))
}
