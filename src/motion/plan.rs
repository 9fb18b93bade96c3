//! From moves to motion.

use glam::DVec3;

use super::sample::Sample;
use super::speed::{Course, Phase, Rates, cruise, law, law_from, length, ramp_time, textbook};
use super::{
    CornerCurve, Joint, Limits, LimitsError, MOST_SAMPLES, Mode, Motion, Piece, Placed,
    TrackBuilder,
};
use crate::contour::Move;

/// What of a run is planned together, so that what is held in memory, and the time until samples come,
/// stay bounded [s]. It comes to rest at its end, and what leads there is planned again with what
/// follows.
const WINDOW: f64 = 10.0;

/// What is planned again, at least, and in ramps between rest and the largest velocity [s].
const AGAIN: f64 = 1.0;
const RAMPS: f64 = 4.0;

/// How often it is tried to go on from a law that brakes, and how much farther on each time, in parts
/// of what is left of it.
const TRIES: usize = 4;
const FARTHER: f64 = 0.25;

/// What a run has on an even stretch beyond its ramp [s].
const LEAD: f64 = 0.1;

/// Even stretches shorter than this are planned with what is around them [s].
const EVEN_TIME: f64 = 1.0;

/// How fast an even stretch of an arc is at most, in parts of what its bend allows at all: cubed, it
/// is what it takes of the jerk.
const GENTLE: f64 = 0.5;

/// Plans the motion along moves, from rest to rest.
///
/// # Errors
/// [`LimitsError`] where a limit is not a positive number within reason.
pub fn plan(moves: &[Move], limits: &Limits) -> Result<Motion, LimitsError> {
    let mut planner = Planner::new(limits)?;
    let mut motion = Motion::default();
    for one in moves {
        planner.push(one, &mut motion);
    }
    planner.finish(&mut motion);
    Ok(motion)
}

/// Plans moves as they come, and hands out samples as soon as nothing to come can change them.
#[derive(Debug, Clone)]
pub struct Planner {
    limits: Limits,
    builder: TrackBuilder,
    /// Pieces that the builder handed out, and dwells before them [s].
    track: Vec<Placed>,
    course: Course,
    /// A long even stretch before the course, with where on it the run before ended, and its speed.
    even: Option<(Course, [f64; 2])>,
    /// What the last law had yet to go of the course, to rest at an arc length [mm].
    head: Vec<Phase>,
    head_end: f64,
    /// How long the course is to be before its beginning is handed out [s].
    wait: f64,
    /// How much of the end of a law is planned again [s].
    again: f64,
    /// Rests that are asked for: before which move, and for how long [s].
    dwells: Vec<(u32, f64)>,
    /// The number of moves so far.
    moves: u32,
    /// The time that the next run starts at [s].
    start: f64,
    /// The number of the next sample.
    next: u64,
    /// Where the tool rests, and the move that took it there.
    rest: Option<(DVec3, u32)>,
}

impl Planner {
    /// A planner at rest, at time 0.
    ///
    /// # Errors
    /// [`LimitsError`] where a limit is not a positive number within reason.
    pub fn new(limits: &Limits) -> Result<Self, LimitsError> {
        limits.check()?;
        let mut limits = *limits;
        if limits.mode == Mode::Textbook {
            limits.corner = CornerCurve::Ph13;
        }
        let rates = Rates::along(DVec3::ZERO, limits.velocity, &limits);
        let again = AGAIN.max(RAMPS * ramp_time(limits.velocity, &rates));
        Ok(Self {
            limits,
            builder: TrackBuilder::new(&limits),
            track: Vec::new(),
            course: Course::default(),
            even: None,
            head: Vec::new(),
            head_end: 0.0,
            wait: WINDOW.max(4.0 * again),
            again,
            dwells: Vec::new(),
            moves: 0,
            start: 0.0,
            next: 0,
            rest: None,
        })
    }

    /// Takes a move, and adds to `motion` the samples that are certain by now.
    pub fn push(&mut self, one: &Move, motion: &mut Motion) {
        self.builder.push(one, &mut self.track);
        self.moves += 1;
        self.advance(motion);
    }

    /// From the next corner on: stops at the end of each move (G61.1), or rounds corners within a
    /// deviation [mm] (G64 P); with 0 the path is kept exactly (G61).
    pub fn blend(&mut self, exact_stop: bool, corner_deviation: f64) {
        self.builder.blend(exact_stop, corner_deviation);
    }

    /// Comes to rest, and begins the next move wherever it does, at once: the coordinates are others.
    pub fn jump(&mut self) {
        self.builder.jump();
    }

    /// Comes to rest after the moves so far, and stays there for a time [s], which may be 0; adds to
    /// `motion` the samples that are certain by now.
    pub fn pause(&mut self, seconds: f64, motion: &mut Motion) {
        self.builder.rest();
        if seconds > 0.0 {
            self.dwells.push((self.moves, seconds));
        }
        self.advance(motion);
    }

    /// Comes to rest, and adds the last samples.
    pub fn finish(&mut self, motion: &mut Motion) {
        self.builder.finish(&mut self.track);
        self.advance(motion);
        self.run(motion);
        self.dwell(u32::MAX, motion);
        if let Some((point, block)) = self.rest {
            motion.push(Sample { time: self.start, point, rates: [0.0; 4], block });
        }
        motion.duration = self.start;
    }

    /// Plans the runs that are complete.
    fn advance(&mut self, motion: &mut Motion) {
        let mut track = std::mem::take(&mut self.track);
        for placed in track.drain(..) {
            if self.course.is_empty() {
                self.dwell(placed.block, motion);
            }
            let stops = placed.end == Joint::Stop;
            let fast = self.limits.mode == Mode::Fast;
            let placed = if fast { self.cut(placed, motion) } else { placed };
            self.course.push(placed, &self.limits);
            if stops {
                self.run(motion);
            } else if fast && self.course.time > self.wait {
                self.run_on(motion);
            }
        }
        self.track = track;
    }

    /// Cuts a long even stretch out of a piece: the run so far ends on it, the next one begins on it,
    /// and between them nothing is to be planned. Returns what is left.
    fn cut(&mut self, placed: Placed, motion: &mut Motion) -> Placed {
        let mut even = Course::default();
        even.push(placed.clone(), &self.limits);
        let rates = even_rates(&even, &self.limits);
        let ramp = rates.velocity * ramp_time(rates.velocity, &rates);
        let lead = 0.5 * ramp + LEAD * rates.velocity;
        let is_even = match &placed.piece {
            Piece::Straight(_) => true,
            // On an arc an axis has its own limits at each place.
            Piece::Helix(_) if self.limits.axes.is_some() => false,
            Piece::Helix(_) => rates.velocity < GENTLE * even.slowest(&self.limits),
            _ => false,
        };
        let length = placed.piece.length();
        if !is_even || length < 2.0 * lead + ramp + EVEN_TIME * rates.velocity {
            return placed;
        }
        let mut head = placed.clone();
        head.piece = placed.piece.part(0.0, lead);
        head.end = Joint::Smooth;
        self.course.push(head, &self.limits);
        self.course.moving[1] = true;
        self.run(motion);
        let mut middle = placed.clone();
        middle.piece = placed.piece.part(lead, length - lead);
        if let Some((even, _)) = &mut self.even {
            even.push(middle, &self.limits);
        }
        self.course.moving[0] = true;
        let mut tail = placed;
        tail.piece = tail.piece.part(length - lead, length);
        tail
    }

    /// Stays at rest for the dwells up to a move.
    fn dwell(&mut self, block: u32, motion: &mut Motion) {
        let mut done = 0;
        while done < self.dwells.len() && self.dwells[done].0 <= block {
            let end = self.start + self.dwells[done].1;
            done += 1;
            if let Some((point, block)) = self.rest {
                while self.next as f64 * self.limits.period < end && motion.len() < MOST_SAMPLES {
                    let time = self.next as f64 * self.limits.period;
                    motion.push(Sample { time, point, rates: [0.0; 4], block });
                    self.next += 1;
                }
                self.start = end;
            }
        }
        self.dwells.drain(..done);
    }

    /// The law of the run at hand, to rest at its end.
    fn law(&mut self, motion: &mut Motion) -> Vec<Phase> {
        if self.limits.mode == Mode::Textbook {
            return textbook(&self.course, &self.limits);
        }
        for left in (0..TRIES).rev() {
            if self.head.is_empty() {
                break;
            }
            if let Some(law) = law_from(&self.course, &self.limits, &self.head) {
                self.head.clear();
                return law;
            }
            // What was planned before is sure. It brakes: farther on there is more freedom, and at
            // last it rests where that ends.
            let part = if left > 0 { length(&self.head) * FARTHER } else { f64::INFINITY };
            let (mut time, mut cut) = (0.0, 0);
            while cut < self.head.len() && time < part {
                time += self.head[cut].duration;
                cut += 1;
            }
            let rest = self.head.split_off(cut);
            let sure = std::mem::replace(&mut self.head, rest);
            self.hand_out(&sure, motion);
            self.forget();
        }
        law(&self.course, &self.limits)
    }

    /// Forgets what of the course is before the head, or all of its way where it is empty.
    fn forget(&mut self) {
        let on = self.head.first().map_or(self.head_end, |phase| phase.at(0.0)[0]);
        let gone = self.course.forget(on);
        for phase in &mut self.head {
            phase.powers[0] -= gone;
        }
        self.head_end -= gone;
    }

    /// Plans the run at hand, and samples what does not depend on how it goes on.
    fn run_on(&mut self, motion: &mut Motion) {
        let mut phases = self.law(motion);
        let (mut left, mut cut) = (0.0, phases.len());
        while cut > 0 && left < self.again {
            cut -= 1;
            left += phases[cut].duration;
        }
        self.head_end = self.course.length;
        self.head = phases.split_off(cut);
        self.hand_out(&phases, motion);
        if !self.head.is_empty() {
            self.forget();
        }
        self.wait = self.course.time + WINDOW.max(4.0 * self.again);
    }

    /// Samples a law, and the even stretch before it.
    fn hand_out(&mut self, phases: &[Phase], motion: &mut Motion) {
        let Some(first) = phases.first() else { return };
        if let Some((even, [from, speed])) = self.even.take() {
            let [on, next, ..] = first.at(0.0);
            let rates = even_rates(&even, &self.limits);
            let cruise = cruise(from, even.length + on - from, [speed, next], &rates);
            self.sample(&even, &cruise, motion);
        }
        let course = std::mem::take(&mut self.course);
        self.sample(&course, phases, motion);
        self.course = course;
    }

    /// Plans and samples the run at hand, to its end.
    fn run(&mut self, motion: &mut Motion) {
        if self.course.is_empty() {
            return;
        }
        let phases = self.law(motion);
        self.hand_out(&phases, motion);
        if self.course.moving[1] {
            let last = phases.last().map_or([0.0; 4], |phase| phase.at(phase.duration));
            self.even = Some((Course::default(), [last[0] - self.course.length, last[1]]));
        }
        let mut at = 0;
        let end = self.course.frame(self.course.length, &mut at);
        self.rest = Some((end.point, self.course.block(at)));
        self.course.clear();
        self.wait = WINDOW.max(4.0 * self.again);
    }

    /// Takes samples of a law.
    fn sample(&mut self, course: &Course, phases: &[Phase], motion: &mut Motion) {
        let mut at = 0;
        for phase in phases {
            let end = self.start + phase.duration;
            loop {
                let time = self.next as f64 * self.limits.period;
                if time >= end || motion.len() >= MOST_SAMPLES {
                    break;
                }
                let [s, v, a, j] = phase.at(time - self.start);
                let frame = course.frame(s, &mut at);
                let square = v * v;
                let acceleration = frame.tangent * a + frame.curvature * square;
                let jerk = frame.tangent * j
                    + frame.curvature * (3.0 * v * a)
                    + frame.sharpness * (square * v);
                let pace = frame.tangent.length();
                let along = acceleration.dot(frame.tangent) / pace;
                let across = (acceleration.length_squared() - along * along).max(0.0).sqrt();
                let rates = [v * pace, along, across, jerk.length()];
                let block = course.block(at);
                motion.push(Sample { time, point: frame.point, rates, block });
                self.next += 1;
            }
            self.start = end;
        }
    }
}

/// What is left to the speed along an even stretch: half the limits where it bends gently.
///
/// There `v³κ² ≤ J/8` and `3 v a κ ≤ J/2`, and with `j ≤ J/2` the jerk is below `0.81 J`.
fn even_rates(even: &Course, limits: &Limits) -> Rates {
    let frame = even.frame(0.0, &mut 0);
    let mut rates = Rates::along(frame.tangent, 0.999 * even.cap(), limits);
    let turning = 3.0 * rates.velocity * frame.curvature.length();
    rates.acceleration = rates.acceleration.min(rates.jerk / turning.max(1.0e-9));
    Rates { velocity: rates.velocity, ..rates.by(0.5) }
}
