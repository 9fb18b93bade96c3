//! The tool path of a whole program: its contours compensated, everything else in its place.

use glam::{DVec2, DVec3};

use super::Tools;
use super::ahead::with_look_ahead;
use super::avoided::avoided;
use super::beside::Beside;
use super::changes::{cross_over, leave_out_last, start_from};
use super::judge::judge_laps;
use super::spline_blocks::name_blocks;
use super::walls::laps;
use crate::compensation::{
    GougePolicy, LeadStyle, Options, compensate_all, compensate_locally, refuse_gouges,
};
use crate::contour::{
    Attributes, AuxiliaryWords, Contour, EventKind, Move, MoveCurve, Reset, Role, Tool, ToolPath,
    Walls,
};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Arc, Decimal, Line, MIN_LENGTH};
use crate::gouge::check;
use crate::program::{
    ContourEnd, ContourStart, Interpretation, Item, ProgrammedContour, RadiusSource,
};

/// The path of the tool centre through a whole program, rapid moves and words included, with
/// what every stage found.
///
/// A contour whose tool has no radius is reported, and passes as if the radius were zero. With
/// [`GougePolicy::Stop`] one gouge leaves the whole program without a path: what follows it would
/// start from a place where the tool never came.
#[must_use]
pub fn compensate_program(
    interpretation: &Interpretation,
    tools: &Tools,
    options: &Options,
) -> ToolPath {
    let mut compensation = ProgramCompensation::new(interpretation, tools.clone(), options);
    while compensation.step(interpretation, usize::MAX) {}
    compensation.finish()
}

/// A program on its way to its path, a slice at a time.
#[derive(Debug)]
pub struct ProgramCompensation {
    course: Course,
    tools: Tools,
    /// As each contour is compensated: what is refused is the program as a whole.
    each: Options,
    is_refused: bool,
    /// The next of the items, and how many blocks were done of how many.
    next: usize,
    done: usize,
    total: usize,
}

impl ProgramCompensation {
    /// A program before its first block.
    #[must_use]
    pub fn new(interpretation: &Interpretation, tools: Tools, options: &Options) -> Self {
        let is_refused = options.gouge == GougePolicy::Stop;
        let gouge = if is_refused { GougePolicy::Report } else { options.gouge };
        let mut course = Course::default();
        course.path.diagnostics.clone_from(&interpretation.diagnostics);
        let mut total = 0;
        for item in &interpretation.items {
            total += blocks(item);
        }
        let each = Options { gouge, ..*options };
        Self { course, tools, each, is_refused, next: 0, done: 0, total }
    }

    /// Compensates about so many blocks of the `interpretation` it was made for, each contour as a
    /// whole; false once there are none left.
    pub fn step(&mut self, interpretation: &Interpretation, count: usize) -> bool {
        let until = self.done.saturating_add(count);
        while self.done < until && !self.course.is_stopped {
            let Some(item) = interpretation.items.get(self.next) else {
                return false;
            };
            self.course.item(item, &self.tools, &self.each);
            self.next += 1;
            self.done += blocks(item);
        }
        self.next < interpretation.items.len() && !self.course.is_stopped
    }

    /// How much of the program was compensated, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        if self.course.is_stopped { 1.0 } else { self.done as f64 / self.total.max(1) as f64 }
    }

    /// The path, as far as it was made.
    #[must_use]
    pub fn finish(mut self) -> ToolPath {
        if self.is_refused {
            refuse_gouges(&mut self.course.path);
        }
        self.course.path
    }
}

/// The path of a contour with what it cuts; `runs_in_or_out` tells that not all of it is wall.
fn reported(
    programmed: &ProgrammedContour,
    runs_in_or_out: bool,
    tool: Tool,
    options: &Options,
) -> ToolPath {
    let contour = &programmed.contour;
    let laps = laps(programmed, tool.side());
    if !runs_in_or_out && laps.len() == 1 {
        return compensate_all(&[(contour, tool)], options);
    }
    let mut path = compensate_locally(contour, tool, options);
    judge_laps(&mut path, programmed, &laps, tool, options.usable_tolerance());
    path
}

/// About how many blocks an item comes from.
fn blocks(item: &Item) -> usize {
    match item {
        Item::Contour(programmed) => programmed.contour.segments().len() + 1,
        Item::Free(_) | Item::Words { .. } => 1,
    }
}

/// The path as it grows.
#[derive(Debug, Default)]
struct Course {
    path: ToolPath,
    /// Whether the coordinates are others since the last move: the next one starts where it says.
    is_reset: bool,
    /// How far the tool is from where the program is since the last contour, in the plane [mm].
    beside: DVec2,
    /// The program counts from where the tool is, beside the last contour.
    goes_on: Option<Beside>,
    /// The control has refused to go on.
    is_stopped: bool,
}

impl Course {
    /// One step of the program.
    fn item(&mut self, item: &Item, tools: &Tools, options: &Options) {
        match item {
            Item::Free(free) => self.free(*free, options.lead == LeadStyle::LinuxCnc),
            Item::Words { words, reset, origin } => {
                let mut reset = *reset;
                // Moves that words make start where the tool is.
                let makes_none = |reset: &Reset| reset.moves == 0;
                self.is_reset |= reset.as_ref().is_some_and(makes_none) && !words.is_empty();
                if let (Some(beside), Some(reset)) = (&mut self.goes_on, &reset) {
                    beside.note(words, reset);
                }
                // Where only axes are to be stated the tool stays where it is, maybe beside the
                // contour.
                if let (Some(reset), Some(at), false) = (
                    reset.as_mut().filter(|reset| makes_none(reset)),
                    self.position(),
                    self.is_reset,
                ) {
                    reset.at = at;
                }
                self.path.words.push(AuxiliaryWords {
                    before: self.path.moves.len(),
                    words: words.clone(),
                    reset,
                    origin: *origin,
                });
            }
            Item::Contour(programmed) => self.contour(programmed, tools, options),
        }
    }

    /// Where the tool is, once it has moved [mm].
    fn position(&self) -> Option<DVec3> {
        let last = self.path.moves.last()?;
        Some(last.plane.place(last.curve.end(), last.heights[1]))
    }

    /// Where the tool is, in the plane of `next` and above it, if that is not where `next` starts
    /// in the plane.
    fn elsewhere(&mut self, next: &Move) -> Option<(DVec2, f64)> {
        let is_reset = std::mem::take(&mut self.is_reset);
        let (mut at, mut height) = next.plane.split(self.position()?);
        let beside = std::mem::take(&mut self.beside);
        let start = next.curve.start();
        if is_reset {
            let beside = self.goes_on.map_or(beside, |goes_on| goes_on.offset_in(next.plane));
            (at, height) = (start + beside, next.heights[0]);
        }
        (at.distance(start) > MIN_LENGTH).then_some((at, height))
    }

    /// A move without compensation. After a contour without a lead-out the tool is not where the
    /// program is, and goes on from there; along the normal of the plane only where the control does
    /// not go back to the program with it.
    fn free(&mut self, free: Move, goes_back: bool) {
        let Some((at, height)) = self.elsewhere(&free) else {
            self.goes_on = None;
            let climbs = free.heights[0] != free.heights[1];
            if climbs || !matches!(free.curve, MoveCurve::Vertical(_)) {
                self.path.moves.push(free);
            }
            return;
        };
        let [start, mut to] = [free.curve.start(), free.curve.end()];
        if let Some(beside) = &mut self.goes_on {
            beside.begin(at - start, free.plane);
            to = beside.place([start, to], free.plane);
            beside.forget();
        }
        let curve = match free.curve {
            MoveCurve::Vertical(_) if !goes_back => MoveCurve::Vertical(at),
            MoveCurve::Vertical(_) | MoveCurve::Line(_) => line_from(at, to),
            MoveCurve::Arc(_) | MoveCurve::Cubic(_) | MoveCurve::Involute(_) => {
                self.join((at, height), &free, Role::Free);
                self.path.moves.push(free);
                return;
            }
        };
        let heights = [height, free.heights[1]];
        self.path.moves.push(Move { curve, heights, ..free });
    }

    fn contour(&mut self, programmed: &ProgrammedContour, tools: &Tools, options: &Options) {
        let origin = Origin::Block { line: programmed.blocks[0], number: None, column: None };
        let avoids = options.gouge == GougePolicy::Avoid;
        let looks_ahead = options.lead == LeadStyle::LinuxCnc && !avoids;
        let tool = self.tool(programmed, tools, origin, looks_ahead);
        if self.is_stopped {
            return;
        }
        let at = self.position().filter(|_| !self.is_reset);
        let moved = self.goes_on.take().map(|beside| beside.contour(programmed, at));
        let programmed = moved.as_ref().unwrap_or(programmed);
        let before = self.path.moves.len();
        let contour = &programmed.contour;
        let walls = Walls::of(contour, tool.side());
        let mut compensated = if looks_ahead {
            let orientation = tools.orientation_of(programmed);
            let (path, finished) = with_look_ahead(programmed, tool, orientation, options, origin);
            self.is_stopped = !finished;
            path
        } else {
            let mut path = if avoids {
                avoided(programmed, walls.as_ref(), tool, options)
            } else {
                reported(programmed, walls.is_some(), tool, options)
            };
            set_feeds(&mut path, contour);
            path
        };
        if programmed.end == ContourEnd::Tapers
            && let Some(last) = programmed.contour.segments().last()
        {
            leave_out_last(&mut compensated.moves, last.attributes.origin);
        }
        if let (Some(last), Some(first)) =
            (self.path.moves.last_mut(), compensated.moves.first_mut())
        {
            match programmed.begins {
                ContourStart::Anew => {}
                ContourStart::Tapers => start_from(first, last.curve.end()),
                ContourStart::Crosses => cross_over(last, first),
            }
        }
        name_blocks(&mut compensated.moves, programmed);
        let follows_a_contour = self.path.moves.last().is_some_and(|last| last.role != Role::Free);
        if let Some(first) = compensated.moves.first_mut()
            && let Some((at, height)) = self.elsewhere(first)
        {
            match Line::new(at, first.curve.end()) {
                Ok(line) if looks_ahead => {
                    first.curve = match first.curve {
                        MoveCurve::Arc(arc) => {
                            let turned = arc.is_clockwise();
                            Arc::winding(at, arc.end(), arc.center(), turned)
                                .map_or(first.curve, MoveCurve::Arc)
                        }
                        _ => MoveCurve::Line(line),
                    };
                }
                // Without a lead-out before it the tool leads in from beside that contour: on the
                // contour, where the program is, it would cut into the part.
                Ok(line) if follows_a_contour && first.role == Role::LeadIn => {
                    first.curve = MoveCurve::Line(line);
                }
                // What was avoided may begin anywhere: the tool crosses to there.
                _ if avoids && first.role != Role::LeadIn => {}
                _ => self.join((at, height), first, Role::Transition),
            }
        }
        if programmed.end == ContourEnd::Beside
            && let Some(last) = compensated.moves.last()
        {
            let mut beside = Beside::default();
            beside.begin(last.curve.end() - contour.end(), last.plane);
            self.goes_on = Some(beside);
        }
        let own = compensated.moves.len();
        self.path.append(compensated);
        if looks_ahead
            && programmed.end == ContourEnd::Off
            && contour.lead_out().is_none()
            && let Some(at) = self.path.moves.last()
        {
            self.beside = at.curve.end() - contour.end();
        }
        self.path.contours.push([before, self.path.moves.len()]);
        if avoids {
            let joins = self.path.moves.len() - own;
            let alone = walls.map(|walls| walls.alone(contour));
            let walls = alone.as_ref().unwrap_or(contour);
            self.judge_leads(walls, [before, joins], tool, options);
        }
    }

    /// Says where a way to or from an avoided path cuts: leads are as programmed, and the tool may
    /// have been `before` where it needs a `join` to the first piece.
    fn judge_leads(
        &mut self,
        contour: &Contour,
        [before, own]: [usize; 2],
        tool: Tool,
        options: &Options,
    ) {
        for index in before..self.path.moves.len() {
            let step = self.path.moves[index];
            let is_lead = matches!(step.role, Role::LeadIn | Role::LeadOut);
            if !is_lead && index >= own {
                continue;
            }
            let alone = ToolPath { moves: vec![step], ..ToolPath::default() };
            let gouges = check(contour, &alone, tool.radius(), options.usable_tolerance());
            for gouge in gouges {
                let way = match step.role {
                    Role::LeadOut => "lead-out from",
                    _ => "way to",
                };
                let message = format!(
                    "the {way} what the tool reaches cuts {} mm too deep",
                    Decimal::of(gouge.depth)
                );
                self.path.diagnostics.push(
                    Diagnostic::error("lead-gouge", message)
                        .with_origin(step.origin)
                        .with_point(gouge.at)
                        .with_depth(gouge.depth)
                        .with_segments(gouge.segments.as_slice())
                        .with_hint("begin and end the contour where the tool fits"),
                );
                self.path.gouges.push(gouge);
            }
        }
    }

    /// A straight move to where `next` starts.
    fn join(&mut self, (from, height): (DVec2, f64), next: &Move, role: Role) {
        if let Ok(line) = Line::new(from, next.curve.start()) {
            let heights = [height, next.heights[0]];
            self.path.moves.push(Move { curve: MoveCurve::Line(line), role, heights, ..*next });
        }
    }

    /// The tool of a contour; one without radius where it is not known. A control that looks ahead
    /// stops there, unless there is no tool at all.
    fn tool(
        &mut self,
        programmed: &ProgrammedContour,
        tools: &Tools,
        origin: Origin,
        looks_ahead: bool,
    ) -> Tool {
        let radius = tools.radius_of(programmed);
        let known = radius.and_then(|radius| Tool::new(radius, programmed.side));
        known.unwrap_or_else(|| {
            let without = Tool::new(0.0, programmed.side).expect("zero is a radius");
            if looks_ahead && radius.is_none() {
                if programmed.radius == RadiusSource::Tool(0) {
                    let message = "no tool is in the spindle: nothing is compensated";
                    self.path.diagnostics.push(
                        Diagnostic::warning("no-tool", message)
                            .with_origin(origin)
                            .with_hint("change to a tool (T M6) before, or name one by D"),
                    );
                    return without;
                }
                self.is_stopped = true;
            }
            let message = match programmed.radius {
                RadiusSource::Tool(number) if radius.is_none() => {
                    format!("the radius of tool {number} is not known")
                }
                _ => format!("{} mm is no radius of a tool", Decimal::of(radius.unwrap_or(f64::NAN))),
            };
            self.path.diagnostics.push(
                Diagnostic::error("missing-radius", message)
                    .with_origin(origin)
                    .with_point(programmed.contour.start())
                    .with_hint("give the radius of the tool, or one for all tools; until then nothing is compensated"),
            );
            without
        })
    }
}

/// A straight move, or one along the normal of the plane where it leads nowhere else [mm].
fn line_from(at: DVec2, to: DVec2) -> MoveCurve {
    Line::new(at, to).map_or(MoveCurve::Vertical(at), MoveCurve::Line)
}

/// Lets the moves of each block of a contour take the time that is programmed for it (G93).
fn set_feeds(path: &mut ToolPath, contour: &Contour) {
    let mut blocks = Vec::new();
    if let Some(lead) = contour.lead_in() {
        note(&mut blocks, &lead.attributes);
    }
    let mut events = contour.events().iter().peekable();
    let segments = contour.segments().iter().map(Some).chain([None]);
    for (index, segment) in segments.enumerate() {
        while let Some(event) = events.next_if(|event| segment.is_none() || event.before <= index) {
            if let EventKind::Vertical(attributes) = &event.kind {
                note(&mut blocks, attributes);
            }
        }
        if let Some(segment) = segment {
            note(&mut blocks, &segment.attributes);
        }
    }
    if let Some(lead) = contour.lead_out() {
        note(&mut blocks, &lead.attributes);
    }
    if blocks.iter().all(|(_, time)| time.is_none()) {
        return;
    }
    let mut blocks = blocks.iter();
    for moves in path.moves.chunk_by_mut(|a, b| a.origin == b.origin) {
        let origin = moves[0].origin;
        let Some((_, Some(time))) = blocks.find(|(block, _)| *block == origin) else { continue };
        let mut length = 0.0;
        for step in moves.iter() {
            length += step.curve.length().hypot(step.heights[1] - step.heights[0]);
        }
        for step in moves {
            step.feed = Some(length / time);
        }
    }
}

#[inline(never)]
fn note(blocks: &mut Vec<(Origin, Option<f64>)>, attributes: &Attributes) {
    blocks.push((attributes.origin, attributes.time));
}
