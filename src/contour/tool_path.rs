//! The path of the tool centre: moves, and what was found on the way.

use glam::{DVec2, DVec3};

use super::{Attributes, Event, EventKind, Plane, Transition};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{
    Arc, Bounds, Cubic, Curve, Involute, Line, Nearest, flatten_arc, flatten_cubic,
};

/// The plane curve of a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MoveCurve {
    /// A straight line.
    Line(Line),
    /// A circular arc; a helix where the heights differ.
    Arc(Arc),
    /// A cubic Bézier curve.
    Cubic(Cubic),
    /// An involute of a circle.
    Involute(Involute),
    /// No motion in the plane: the tool moves along its normal at this point [mm].
    Vertical(DVec2),
}

impl MoveCurve {
    /// A span of a spline, or the whole of another curve.
    #[inline(never)]
    #[must_use]
    pub(crate) fn of(curve: &Curve, span: usize) -> Self {
        match curve {
            Curve::Line(line) => Self::Line(*line),
            Curve::Arc(arc) => Self::Arc(*arc),
            Curve::Involute(involute) => Self::Involute(*involute),
            Curve::Spline(spline) => Self::Cubic(spline.pieces()[span]),
        }
    }

    /// Where it begins [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        match self {
            Self::Line(line) => line.start(),
            Self::Arc(arc) => arc.start(),
            Self::Cubic(cubic) => cubic.start(),
            Self::Involute(involute) => involute.start(),
            Self::Vertical(at) => *at,
        }
    }

    /// Where it ends [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        match self {
            Self::Line(line) => line.end(),
            Self::Arc(arc) => arc.end(),
            Self::Cubic(cubic) => cubic.end(),
            Self::Involute(involute) => involute.end(),
            Self::Vertical(at) => *at,
        }
    }

    /// The point at `t` in `[0, 1]` [mm].
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        match self {
            Self::Line(line) => line.point(t),
            Self::Arc(arc) => arc.point(t),
            Self::Cubic(cubic) => cubic.point(t),
            Self::Involute(involute) => involute.point(t),
            Self::Vertical(at) => *at,
        }
    }

    /// Unit tangent at `t` in the direction of motion; zero for a move along z.
    #[must_use]
    pub fn tangent(&self, t: f64) -> DVec2 {
        match self {
            Self::Line(line) => line.tangent(),
            Self::Arc(arc) => arc.tangent(t),
            Self::Cubic(cubic) => cubic.tangent(t),
            Self::Involute(involute) => involute.tangent(t),
            Self::Vertical(_) => DVec2::ZERO,
        }
    }

    /// Arc length in the plane [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Line(line) => line.length(),
            Self::Arc(arc) => arc.length(),
            Self::Cubic(cubic) => cubic.length(),
            Self::Involute(involute) => involute.length(),
            Self::Vertical(_) => 0.0,
        }
    }

    /// The smallest box around it.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::Line(line) => line.bounds(),
            Self::Arc(arc) => arc.bounds(),
            Self::Cubic(cubic) => cubic.bounds(),
            Self::Involute(involute) => involute.bounds(),
            Self::Vertical(at) => Bounds::of([*at]),
        }
    }

    /// A quick box around it, not smaller than [`bounds`](Self::bounds).
    #[must_use]
    pub fn hull_bounds(&self) -> Bounds {
        match self {
            Self::Cubic(cubic) => cubic.hull_bounds(),
            Self::Line(_) | Self::Arc(_) | Self::Involute(_) | Self::Vertical(_) => self.bounds(),
        }
    }

    /// A quick box around several.
    #[must_use]
    pub fn hulls(curves: &[Self]) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        for curve in curves {
            bounds = bounds.union(curve.hull_bounds());
        }
        bounds
    }

    /// Its point nearest to `point`.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> Nearest {
        match self {
            Self::Line(line) => line.nearest(point),
            Self::Arc(arc) => arc.nearest(point),
            Self::Cubic(cubic) => cubic.nearest(point),
            Self::Involute(involute) => involute.nearest(point),
            Self::Vertical(at) => Nearest::new(0.0, *at, point),
        }
    }

    /// Calls `add` with points after its start, up to and with its end, whose chords are within
    /// `tolerance` [mm] of it.
    pub fn flatten(&self, tolerance: f64, add: &mut dyn FnMut(DVec2)) {
        match self {
            Self::Line(line) => add(line.end()),
            Self::Arc(arc) => flatten_arc(arc, tolerance, add),
            Self::Cubic(cubic) => flatten_cubic(cubic, tolerance, add),
            Self::Involute(involute) => involute.flatten(tolerance, add),
            Self::Vertical(at) => add(*at),
        }
    }
}

/// What a move is there for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// It follows a segment of the contour at the tool radius.
    Segment,
    /// It joins two offsets at a corner.
    Transition,
    /// It switches compensation on.
    LeadIn,
    /// It switches compensation off.
    LeadOut,
    /// It is not compensated.
    Free,
    /// It leads from one pass to the next, down as the tool is.
    Link,
}

/// One move of the tool centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Its curve in the plane.
    pub curve: MoveCurve,
    /// What it is there for.
    pub role: Role,
    /// Whether it is a rapid move (G00).
    pub rapid: bool,
    /// Programmed feed [mm/s].
    pub feed: Option<f64>,
    /// The plane that its curve lies in.
    pub plane: Plane,
    /// Height above the plane at its start and at its end [mm]; it changes evenly along the curve.
    pub heights: [f64; 2],
    /// The segment or block it comes from.
    pub origin: Origin,
}

/// Where the tool cuts into material that should stay.
#[derive(Debug, Clone, PartialEq)]
pub struct Gouge {
    /// Which kind.
    pub kind: GougeKind,
    /// The place [mm]: the point of the contour that is cut deepest.
    pub at: DVec2,
    /// How deep [mm].
    pub depth: f64,
    /// The segments concerned.
    pub segments: Vec<Origin>,
}

/// The two kinds of gouge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GougeKind {
    /// Local: a bend tighter than the tool, or an inside corner whose offsets do not meet.
    Curvature,
    /// Between distant segments: the path comes nearer than the radius to another segment.
    Bottleneck,
}

/// Material that should go but that the tool cannot reach.
#[derive(Debug, Clone, PartialEq)]
pub struct Uncut {
    /// Its outline: along the contour, and back along the tool where it comes nearest [mm].
    pub outline: Vec<DVec2>,
    /// Its area [mm²].
    pub area: f64,
    /// The segments that the tool does not reach all of.
    pub segments: Vec<Origin>,
}

/// One loop of a path in several passes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PathLoop {
    /// Index of its first move.
    pub first_move: usize,
    /// Index behind its last move.
    pub moves_end: usize,
    /// Which pass it is part of, the one along the contour being 0.
    pub pass: u32,
    /// Index of the loop of the pass before that lies round it; none in the first pass, and where
    /// no single loop does.
    pub parent: Option<usize>,
}

/// How passed-on words leave the coordinates, where they give places other numbers (G54, G92) or
/// move the tool to where the program's numbers do not tell (G28, G53).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reset {
    /// Where the tool counts as being after them [mm]: the next move starts here.
    pub at: DVec3,
    /// Which of x, y and z the next move is to state even where they stay as they are: its block
    /// says them, and until now they were only assumed. An axis that no block states is not
    /// written.
    pub states: [bool; 3],
    /// How many moves, from the next one on, are those that the words themselves make: they are not
    /// written beside them.
    pub moves: usize,
}

/// Words to be passed through in their place.
#[derive(Debug, Clone, PartialEq)]
pub struct AuxiliaryWords {
    /// Index of the move before which they stand; the number of moves for the end.
    pub before: usize,
    /// The words in mm, with a space between: M, S, T and G words, comments. Maybe none, beside a
    /// reset.
    pub words: String,
    /// What they do to the coordinates.
    pub reset: Option<Reset>,
    /// The block they come from.
    pub origin: Origin,
}

/// The path of the tool centre after compensation.
///
/// Moves follow each other without gaps within a piece; a new piece (another contour) may start
/// elsewhere.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ToolPath {
    /// The moves, in order.
    pub moves: Vec<Move>,
    /// The transitions at corners, in order.
    pub transitions: Vec<Transition>,
    /// What was found on the way.
    pub diagnostics: Vec<Diagnostic>,
    /// Local gouges of the path.
    pub gouges: Vec<Gouge>,
    /// What the tool cannot reach, where that was looked for.
    pub uncut: Vec<Uncut>,
    /// Where the path is one of a program: the first move of each contour, and behind its last.
    pub contours: Vec<[usize; 2]>,
    /// Its loops, where several passes were asked for.
    pub loops: Vec<PathLoop>,
    /// Words to be passed through.
    pub words: Vec<AuxiliaryWords>,
}

impl ToolPath {
    /// Lets happen what is programmed between two segments, where the tool is; `start` [mm] if it is
    /// nowhere yet.
    pub(crate) fn happen(&mut self, event: &Event, start: DVec2) {
        match &event.kind {
            EventKind::Words(words) => self.words.push(AuxiliaryWords {
                before: self.moves.len(),
                words: words.clone(),
                reset: None,
                origin: event.origin,
            }),
            EventKind::Stop => {}
            EventKind::Vertical(attributes) => {
                let Attributes { origin, feed, rapid, plane, heights, .. } = *attributes;
                let at = self.moves.last().map_or(start, |last| last.curve.end());
                let (curve, role) = (MoveCurve::Vertical(at), Role::Segment);
                self.moves.push(Move { curve, role, rapid, feed, plane, heights, origin });
            }
        }
    }

    /// Appends another path after this one.
    pub fn append(&mut self, mut other: Self) {
        for words in &mut other.words {
            words.before += self.moves.len();
        }
        for [first, end] in &mut other.contours {
            *first += self.moves.len();
            *end += self.moves.len();
        }
        let loops = self.loops.len();
        for one in &mut other.loops {
            one.first_move += self.moves.len();
            one.moves_end += self.moves.len();
            one.parent = one.parent.map(|parent| parent + loops);
        }
        if self.moves.is_empty() {
            // Nothing is copied.
            std::mem::swap(&mut self.moves, &mut other.moves);
        }
        self.moves.append(&mut other.moves);
        self.transitions.append(&mut other.transitions);
        self.diagnostics.append(&mut other.diagnostics);
        self.gouges.append(&mut other.gouges);
        self.uncut.append(&mut other.uncut);
        self.contours.append(&mut other.contours);
        self.loops.append(&mut other.loops);
        self.words.append(&mut other.words);
    }
}
