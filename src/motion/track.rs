//! Tracks: from moves to pieces that follow each other, corners rounded and joints told apart.
//!
//! A move becomes a piece by arc length. Where two of them meet, the joint is smooth, or a corner
//! between lines that a Pythagorean-hodograph curve rounds, or rough in another way and blended; what
//! cannot be rounded within the deviation is a stop. Each curve takes a leg of both its neighbours,
//! and what a piece has is shared: a leg may take half of it, and what the other joint does not want.

use glam::DVec3;

use super::blend::{Blend, Rough, SHARPEST};
use super::eased::{is_too_short, shortest_leg};
use super::pieces::{chords, pieces};
use super::{
    Corner, CornerCurve, CornerShape, CurvatureSteps, Eased, Fitted, Fitter, Joint, Limits, Mode,
    Piece, Straight,
};
use crate::contour::Move;

/// A piece in its place on a track.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The curve.
    pub piece: Piece,
    /// Number of the move it comes from, counted from 0; a rounded corner counts to the incoming one.
    /// Of a fitted piece, the first: see [`block_at`](Self::block_at).
    pub block: u32,
    /// Programmed feed [mm/s]; infinite for a rapid move and where none is programmed.
    pub feed: f64,
    /// Whether it is a rapid move, which no feed override concerns.
    pub rapid: bool,
    /// How it meets the next; the last one stops.
    pub end: Joint,
    /// What a blend stands for.
    legs: Option<Box<[Piece; 2]>>,
    /// Of a fitted piece, where on it each of its moves ends [mm] (on the last one, or after).
    ends: Vec<(f64, u32)>,
}

impl Placed {
    /// Whether it rounds the joint of two moves.
    #[must_use]
    pub fn is_corner(&self) -> bool {
        self.legs.is_some() || matches!(self.piece, Piece::Corner(_))
    }

    /// Number of the move that the piece follows at the arc length `s` [mm].
    #[must_use]
    pub fn block_at(&self, s: f64) -> u32 {
        let next = self.ends.partition_point(|(end, _)| *end < s);
        self.ends.get(next).or(self.ends.last()).map_or(self.block, |(_, block)| *block)
    }

    /// The two legs that a rounded corner stands for, in whose place the tool may stop between them.
    #[must_use]
    pub fn legs(&self) -> Option<[Piece; 2]> {
        match &self.piece {
            Piece::Corner(corner) => Some(corner.legs().map(Piece::Straight)),
            _ => self.legs.as_deref().cloned(),
        }
    }
}

/// A rest of a piece shorter than this is left out [mm].
const LEAST_REST: f64 = 1e-10;

/// Ends of successive moves farther apart than this are joined by a rapid move [mm].
const GAP: f64 = 1e-6;

/// The part of the deviation that may lie between a short arc and the chords by which it is fitted.
const CHORDS: f64 = 0.02;

/// The part of one feed that the other one is at least where they count as one.
const ALIKE: f64 = 0.9;

/// Makes a track of moves as they come; each piece is handed out when the next two moves are known.
#[expect(clippy::struct_excessive_bools, reason = "each tells of something else")]
#[derive(Debug, Clone)]
pub struct TrackBuilder {
    deviation: f64,
    corner: CornerCurve,
    steps: CurvatureSteps,
    limits: Limits,
    exact_stop: bool,
    /// Whether straight moves are fitted where corners are rounded, and whether they are now.
    may_fit: bool,
    fits: bool,
    /// How corners are passed from the next move on.
    blends: Option<(bool, f64)>,
    /// Whether the next move begins wherever it does.
    jumps: bool,
    block: u32,
    /// Whether the tool rests before the next move.
    rests: bool,
    /// Whether it rests before the next fitted piece.
    fit_rests: bool,
    /// Where the last move ends [mm].
    end: Option<DVec3>,
    incoming: Option<Stretch>,
    /// How the two meet.
    meets: Meeting,
    outgoing: Option<Stretch>,
    /// The last piece made, whose end is not yet told.
    last: Option<Placed>,
    /// Straight moves on their way, where they are fitted, and what has become of them.
    fitter: Option<Fitter>,
    fitted: Vec<Fitted>,
}

/// A whole piece of a move on its way.
#[derive(Debug, Clone)]
pub struct Stretch {
    /// The curve.
    pub piece: Piece,
    /// Number of the move it comes from.
    pub block: u32,
    /// Programmed feed [mm/s]; infinite for a rapid move and where none is programmed.
    pub feed: f64,
    /// Whether it is a rapid move.
    pub rapid: bool,
    /// Whether the tool rests before it.
    pub rests: bool,
    /// What the joint before it has taken [mm].
    taken: f64,
    /// How far it may be from the moves that it stands for [mm].
    off: f64,
    /// Where each of them ends on it [mm], if they are several.
    ends: Vec<(f64, u32)>,
}

impl Stretch {
    /// A piece of a move.
    #[must_use]
    pub fn new(piece: Piece, block: u32, feed: f64) -> Self {
        Self {
            piece,
            block,
            feed,
            rapid: false,
            rests: false,
            taken: 0.0,
            off: 0.0,
            ends: Vec::new(),
        }
    }
}

/// How two pieces meet, and the leg that rounding it wants.
#[derive(Debug, Clone, Copy)]
enum Meeting {
    As(Joint),
    Lines(CornerShape, f64),
    Rough(Rough, Joint),
}

impl Meeting {
    fn wants(&self) -> f64 {
        match self {
            Self::As(_) => 0.0,
            Self::Lines(_, leg) => *leg,
            Self::Rough(rough, _) => rough.leg,
        }
    }
}

impl TrackBuilder {
    /// A builder that rounds as the limits say.
    #[must_use]
    pub fn new(limits: &Limits) -> Self {
        Self {
            deviation: limits.corner_deviation,
            corner: limits.corner,
            steps: limits.curvature_steps,
            limits: *limits,
            exact_stop: limits.exact_stop,
            may_fit: limits.fit && limits.mode == Mode::Fast,
            fits: false,
            blends: Some((limits.exact_stop, limits.corner_deviation)),
            jumps: false,
            block: 0,
            rests: false,
            fit_rests: false,
            end: None,
            incoming: None,
            meets: Meeting::As(Joint::Stop),
            outgoing: None,
            last: None,
            fitter: None,
            fitted: Vec::new(),
        }
    }

    /// Takes a move, and adds to `track` the pieces that are certain by now.
    pub fn push(&mut self, one: &Move, track: &mut Vec<Placed>) {
        let block = self.block;
        self.block += 1;
        let feed = one.feed.filter(|_| !one.rapid).unwrap_or(f64::INFINITY);
        let chords = chords(one, CHORDS * self.deviation);
        let from = one.plane.place(one.curve.start(), one.heights[0]);
        let goes_on = self.fits && chords > 0 && !one.rapid && self.blends.is_none() && !self.rests;
        if !goes_on || !self.fitter.as_ref().is_some_and(|fitter| fitter.is_at(from)) {
            let rests = std::mem::take(&mut self.rests);
            self.end_fit(track);
            self.rests |= rests;
        }
        if let Some((exact_stop, deviation)) = self.blends.take() {
            self.exact_stop = exact_stop;
            self.deviation = deviation.max(0.0);
            self.fits = self.may_fit && !exact_stop && deviation > 0.0;
        }
        if std::mem::take(&mut self.jumps) {
            self.end = None;
        }
        if self.fits && chords > 0 && !one.rapid {
            if self.fitter.is_none() {
                self.fit_rests = std::mem::take(&mut self.rests);
            }
            let tolerance = (1.0 - CHORDS) * self.deviation;
            let fitter = self.fitter.get_or_insert_with(|| Fitter::new(from, tolerance));
            let [low, high] = one.heights;
            for k in 1..chords {
                let t = f64::from(k) / f64::from(chords);
                let to = one.plane.place(one.curve.point(t), low + (high - low) * t);
                fitter.line(to, block, feed, &mut self.fitted);
            }
            let to = one.plane.place(one.curve.end(), high);
            fitter.line(to, block, feed, &mut self.fitted);
            self.take_fitted(track);
            return;
        }
        for piece in pieces(one) {
            let mut stretch = Stretch::new(piece, block, feed);
            stretch.rapid = one.rapid;
            self.push_stretch(stretch, track);
        }
    }

    /// Ends the run of straight moves that are fitted.
    fn end_fit(&mut self, track: &mut Vec<Placed>) {
        if let Some(mut fitter) = self.fitter.take() {
            let rests = std::mem::take(&mut self.rests);
            fitter.finish(&mut self.fitted);
            self.take_fitted(track);
            self.rests = rests;
        }
    }

    /// Takes the pieces that have been fitted.
    fn take_fitted(&mut self, track: &mut Vec<Placed>) {
        let mut fitted = std::mem::take(&mut self.fitted);
        for one in fitted.drain(..) {
            let block = one.blocks.first().map_or(0, |(_, block)| *block);
            let mut stretch = Stretch::new(one.piece, block, one.feed);
            stretch.off = one.off;
            stretch.rests = std::mem::take(&mut self.fit_rests);
            if one.blocks.len() > 1 {
                stretch.ends = one.blocks;
            }
            self.push_stretch(stretch, track);
        }
        self.fitted = fitted;
    }

    /// Lets the tool rest before the next move.
    pub fn rest(&mut self) {
        self.rests = true;
    }

    /// From the next joint on, stops at the end of each move, or rounds within a deviation [mm].
    pub fn blend(&mut self, exact_stop: bool, deviation: f64) {
        self.blends = Some((exact_stop, deviation));
    }

    /// Lets the tool rest, and the next move begin wherever it does: the coordinates are others.
    pub fn jump(&mut self) {
        self.rests = true;
        self.jumps = true;
    }

    /// Takes a piece. One that begins elsewhere than the last ended is reached by a rapid move, from
    /// rest to rest.
    pub fn push_stretch(&mut self, mut stretch: Stretch, track: &mut Vec<Placed>) {
        let start = stretch.piece.frame(0.0).point;
        stretch.rests |= self.rests;
        self.rests = false;
        if let Some(end) = self.end
            && end.distance(start) > GAP
            && let Some(line) = Straight::between(end, start)
        {
            let between = Stretch {
                piece: Piece::Straight(line),
                block: stretch.block,
                feed: f64::INFINITY,
                rapid: true,
                rests: true,
                taken: 0.0,
                off: 0.0,
                ends: Vec::new(),
            };
            stretch.rests = true;
            self.take(between, track);
        }
        self.end = Some(stretch.piece.frame(stretch.piece.length()).point);
        self.take(stretch, track);
    }

    /// Ends the track at rest, and hands out what is left of it.
    pub fn finish(&mut self, track: &mut Vec<Placed>) {
        self.end_fit(track);
        if self.outgoing.is_some() {
            self.resolve(0.0, track);
        }
        if let Some(stretch) = self.incoming.take() {
            self.emit(&stretch, 0.0, Joint::Stop, track);
        }
        track.extend(self.last.take());
        self.end = None;
    }

    /// Takes a piece that begins where the last one ended.
    fn take(&mut self, next: Stretch, track: &mut Vec<Placed>) {
        let Some(before) = self.outgoing.as_ref().or(self.incoming.as_ref()) else {
            self.incoming = Some(next);
            return;
        };
        let meets = self.meeting(before, &next);
        if self.outgoing.is_some() {
            self.resolve(meets.wants(), track);
        }
        self.meets = meets;
        self.outgoing = Some(next);
    }

    /// How a piece meets the next.
    fn meeting(&self, before: &Stretch, next: &Stretch) -> Meeting {
        let deviation = self.deviation - before.off.max(next.off);
        if next.rests || self.exact_stop {
            return Meeting::As(Joint::Stop);
        }
        let end = before.piece.frame(before.piece.length());
        let start = next.piece.frame(0.0);
        let joint = Joint::between(&end, &start);
        if joint == Joint::Smooth {
            return Meeting::As(joint);
        }
        let is_turn = joint == Joint::Stop;
        let turn = (start.tangent - end.tangent).length();
        if is_turn && let (Piece::Straight(_), Piece::Straight(_)) = (&before.piece, &next.piece) {
            return match CornerShape::between(self.corner, end.tangent, start.tangent) {
                Some(shape) if deviation > 0.0 && shape.half_cosine() >= SHARPEST => {
                    let leg = deviation / shape.deviation_per_leg();
                    Meeting::Lines(shape, leg.min(self.enough(before, next, turn)))
                }
                _ => Meeting::As(Joint::Stop),
            };
        }
        let kept = match self.steps {
            CurvatureSteps::Stop if joint.is_step_of_curvature() => Joint::Stop,
            _ => joint,
        };
        if !is_turn && self.steps != CurvatureSteps::Round || deviation <= 0.0 {
            return Meeting::As(kept);
        }
        let feed = self.slower(before, next);
        let as_is = joint.or_slight_turn(&end, &start, feed, &self.limits);
        let enough = self.enough(before, next, turn);
        // Rounding what is slow enough as it is would only take longer.
        if !is_turn && enough.is_finite() && feed <= as_is.speed(&self.limits) {
            return Meeting::As(as_is);
        }
        let most = if is_turn { enough } else { f64::INFINITY };
        match Rough::of(&end, &start, most, deviation) {
            Some(rough) => Meeting::Rough(rough, as_is),
            None => Meeting::As(as_is),
        }
    }

    /// The slower feed of two pieces, with its override [mm/s].
    fn slower(&self, before: &Stretch, next: &Stretch) -> f64 {
        before.feed.min(next.feed) * self.limits.feed_override
    }

    /// The longest leg that is of use between two pieces [mm]: with another feed on either side the
    /// slower one holds on all of it, and longer than that takes it is only slow.
    fn enough(&self, before: &Stretch, next: &Stretch, turn: f64) -> f64 {
        let slower = self.slower(before, next);
        let faster = before.feed.max(next.feed).min(self.limits.velocity);
        if self.limits.mode == Mode::Fast && ALIKE * faster > slower {
            shortest_leg(turn, slower, &self.limits)
        } else {
            f64::INFINITY
        }
    }

    /// Settles how the two pieces at hand meet, the second of which is to leave `wanted` [mm] to the
    /// joint at its end, or half of it, and hands out the first.
    fn resolve(&mut self, wanted: f64, track: &mut Vec<Placed>) {
        let (Some(incoming), Some(mut outgoing)) = (self.incoming.take(), self.outgoing.take())
        else {
            return;
        };
        let length = outgoing.piece.length();
        let most =
            (incoming.piece.length() - incoming.taken).min((length - wanted).max(0.5 * length));
        let (mut joint, mut leg, mut rounded) = (Joint::Stop, 0.0, None);
        let feed = self.slower(&incoming, &outgoing);
        match &self.meets {
            Meeting::As(as_is) => joint = *as_is,
            Meeting::Lines(shape, wanted) => {
                let tangents = [&incoming, &outgoing].map(|one| one.piece.frame(0.0).tangent);
                let at = outgoing.piece.frame(0.0).point;
                leg = wanted.min(most);
                let (a, b) = (&incoming.piece, &outgoing.piece);
                let legs = [a.part(a.length() - leg, a.length()), b.part(0.0, leg)];
                if is_too_short(shape.difference(), leg, feed, &self.limits) {
                    leg = 0.0;
                } else if shape.curve() == CornerCurve::Eased {
                    joint = Joint::Smooth;
                    let curve = Piece::Eased(Eased::with_leg(at, tangents, leg));
                    rounded = Some((curve, Some(Box::new(legs))));
                } else if let Some(corner) = Corner::with_leg(shape.curve(), at, tangents, leg) {
                    joint = Joint::Smooth;
                    if self.corner == CornerCurve::Ph5 {
                        let sharpness = corner.frame(0.0).sharpness.length();
                        joint = Joint::Step { curvature: 0.0, sharpness };
                    }
                    rounded = Some((Piece::Corner(corner), None));
                } else {
                    leg = 0.0;
                }
            }
            Meeting::Rough(rough, as_is) => {
                let (a, b) = (&incoming.piece, &outgoing.piece);
                let deviation = self.deviation - incoming.off.max(outgoing.off);
                let blend = rough.blend(a, b, most, deviation);
                let is_eased = |blend: &Blend| match as_is {
                    Joint::Stop => {
                        !is_too_short(rough.shape.difference(), blend.leg, feed, &self.limits)
                    }
                    _ => as_is.is_eased_by(blend.piece.length(), &self.limits),
                };
                if let Some(blend) = blend.filter(is_eased) {
                    leg = blend.leg;
                    joint = Joint::Smooth;
                    let legs = [a.part(a.length() - leg, a.length()), b.part(0.0, leg)];
                    rounded = Some((blend.piece, Some(Box::new(legs))));
                } else {
                    joint = *as_is;
                }
            }
        }
        outgoing.taken = leg;
        self.emit(&incoming, leg, joint, track);
        if let Some((piece, legs)) = rounded {
            let rapid = incoming.rapid && outgoing.rapid;
            let feed = incoming.feed.min(outgoing.feed);
            let block = incoming.ends.last().map_or(incoming.block, |(_, block)| *block);
            let corner = Placed { piece, block, feed, rapid, end: joint, legs, ends: Vec::new() };
            track.extend(self.last.replace(corner));
        }
        self.incoming = Some(outgoing);
    }

    /// Hands out what is left of a piece, `leg` [mm] of whose end is taken.
    fn emit(&mut self, stretch: &Stretch, leg: f64, end: Joint, track: &mut Vec<Placed>) {
        let to = stretch.piece.length() - leg;
        if to - stretch.taken > LEAST_REST {
            let whole = leg == 0.0 && stretch.taken == 0.0;
            let piece =
                if whole { stretch.piece.clone() } else { stretch.piece.part(stretch.taken, to) };
            let Stretch { block, feed, rapid, .. } = *stretch;
            let mut ends = stretch.ends.clone();
            for end in &mut ends {
                end.0 -= stretch.taken;
            }
            let placed = Placed { piece, block, feed, rapid, end, legs: None, ends };
            track.extend(self.last.replace(placed));
        } else if let Some(last) = &mut self.last
            && end != Joint::Smooth
        {
            last.end = end;
        }
    }
}

/// The whole track of moves.
#[must_use]
pub fn track(moves: &[Move], limits: &Limits) -> Vec<Placed> {
    let mut builder = TrackBuilder::new(limits);
    let mut track = Vec::new();
    for one in moves {
        builder.push(one, &mut track);
    }
    builder.finish(&mut track);
    track
}
