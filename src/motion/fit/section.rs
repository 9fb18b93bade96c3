//! The fitted path section by section: straight lines, and splines between them.

use glam::{DVec3, DVec4, Vec4Swizzles};

use super::basis::{blend, powers, value, weights};
use super::layout::{Kind, Layout, Vertex};
use super::tube::Tube;
use super::{Fitted, Fitter, Mark};
use crate::motion::{ByLength, Piece, Quintic, Straight};

/// Knots that lie between what is handed out and where the window ends: over so many the influence
/// of what comes after dies away.
const GUARD: usize = 10;

/// The part of the window whose corners are certain: what becomes of them depends on those near.
const CERTAIN: f64 = 0.75;

/// How often a section is tried with finer knots where it left the tube.
const REFINEMENTS: usize = 3;

/// How often a section is tried at all: then each time with an end where it left the tube.
const ATTEMPTS: usize = 8;

/// By how much knots are drawn together then.
const REFINEMENT: f64 = 0.6;

/// How many tries may fail in a window, so that a path that no spline follows takes bounded time; then
/// the polygon is kept.
const BUDGET: usize = 16;

/// The fewest intervals of a spline between two straight lines: five control points lie on each.
const FEWEST: usize = 6;

/// How the fitted path goes on.
#[derive(Debug, Clone, Copy)]
pub(super) enum Start {
    /// From the first vertex; smoothly, if the leg before it is on the same line.
    Corner { smooth: bool },
    /// From a straight line, at this place on the first leg [mm].
    Flat(f64),
    /// From a spline with these last control points.
    Spline([DVec4; 5]),
}

/// How a section ends.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    /// In this vertex.
    Vertex(usize),
    /// In a straight line, at this place on the leg from this vertex [mm].
    Flat(usize, f64),
}

impl Layout {
    /// How the path goes on from a vertex whose legs are straight up to it.
    fn corner(&self, i: usize) -> Start {
        Start::Corner { smooth: i + 1 < self.kinds.len() && self.kinds[i] == Kind::Smooth }
    }
}

impl Fitter {
    /// Hands out what is certain; all of it, if this is the end.
    pub(super) fn advance(&mut self, all: bool, out: &mut Vec<Fitted>) {
        let last = self.vertices.len() - 1;
        if last == 0 {
            return;
        }
        let vertices = std::mem::take(&mut self.vertices);
        let mut marks = std::mem::take(&mut self.marks);
        let mut layout = Layout::new(&vertices, self.tolerance);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is small")]
        let certain = if all { last } else { (last as f64 * CERTAIN) as usize };
        let thinning = 2.0 * super::THINNING * self.tolerance;
        let tolerance = self.tolerance;
        let mut walk = Walk {
            vertices: &vertices,
            marks: &marks,
            mark: 0,
            tolerance,
            thinning,
            failures: 0,
            out,
        };
        let mut leg = 0;
        while leg < certain {
            if let Start::Corner { smooth } = self.start
                && layout.straight[leg]
            {
                let from = vertices[leg].place;
                let end = leg + 1;
                let reach = layout.reach(&vertices, leg, end);
                let to = vertices[end].place - reach;
                walk.straight(leg, [from, to], smooth);
                if reach > 0.0 {
                    self.start = Start::Flat(to);
                } else {
                    self.start = layout.corner(end);
                    leg = end;
                }
                continue;
            }
            let Some(next) = self.section(&mut layout, leg, certain, &mut walk) else {
                break;
            };
            leg = next;
        }
        let mark = walk.mark;
        if all && let (Some(fitted), Some(mark)) = (out.last_mut(), marks[mark..].last()) {
            // Blocks that go nowhere at the end end with it.
            fitted.blocks.push((fitted.piece.length(), mark.block));
        }
        marks.drain(..mark);
        self.marks = marks;
        self.vertices = vertices;
        self.vertices.drain(..leg);
        self.corner.0 = self.corner.0.saturating_sub(leg);
    }

    /// Hands out the section from the leg on, or the certain part of it, and tells on which leg the
    /// fitted path is then; `None` if more must be known first.
    fn section(
        &mut self,
        layout: &mut Layout,
        leg: usize,
        certain: usize,
        walk: &mut Walk,
    ) -> Option<usize> {
        let vertices = walk.vertices;
        let last = vertices.len() - 1;
        for attempt in 0..=ATTEMPTS {
            let mut end = End::Vertex(last);
            for i in leg + 1..last {
                if layout.kinds[i] != Kind::Smooth {
                    end = End::Vertex(i);
                    break;
                }
                if layout.straight[i] {
                    end = End::Flat(i, vertices[i].place + layout.reach(vertices, i, i));
                    break;
                }
            }
            let (final_leg, end_place) = match end {
                End::Vertex(i) => (i - 1, vertices[i].place),
                End::Flat(i, place) => (i, place),
            };
            let open = match end {
                End::Vertex(i) => i > certain,
                End::Flat(i, _) => i >= certain,
            };
            let polygon = &vertices[leg..=final_leg + 1];
            let flat_end = matches!(end, End::Flat(..));
            let (controls, fixed) = self.controls(layout, leg, end_place, flat_end, walk);
            let tolerance = self.tolerance - walk.thinning;
            let mut tube = Tube { vertices: polygon, controls, fixed, tolerance };
            // Place at which the certain part ends.
            let limit = if open { vertices[certain].place } else { f64::INFINITY };
            let count = tube.count();
            let mut keep = if open { count.saturating_sub(GUARD) } else { count };
            while open && keep > 0 && tube.controls[keep + 2].w > limit {
                keep -= 1;
            }
            if keep == 0 {
                return None;
            }
            let mut broken = Vec::new();
            if walk.failures <= BUDGET && tube.smooth(&mut broken) {
                let smooth = !matches!(self.start, Start::Corner { smooth: false });
                for k in 0..keep {
                    walk.spline(&tube, k, smooth || k > 0);
                }
                if open {
                    let c = &tube.controls[keep..keep + 5];
                    self.start = Start::Spline([c[0], c[1], c[2], c[3], c[4]]);
                    let place = blend(&tube.controls[keep..], &weights(0.0)).w;
                    return Some(leg_of(vertices, place));
                }
                return Some(self.after(end, layout, walk, true));
            }
            walk.failures += 1;
            let off = broken.iter().filter(|broken| **broken).count();
            let hopeless = walk.failures > BUDGET || 2 * off > count;
            if attempt < REFINEMENTS && !hopeless {
                refine(layout, &tube.controls, &broken, vertices);
            } else if attempt < ATTEMPTS && !hopeless {
                layout.part(&tube.controls, &broken, vertices);
            } else {
                // The polygon itself, from where the path has come to.
                let end = if open { End::Vertex(certain.max(leg + 1)) } else { end };
                let from = match self.start {
                    Start::Corner { .. } => vertices[leg].place,
                    Start::Flat(place) => place,
                    Start::Spline(c) => {
                        blend(&[c[0], c[1], c[2], c[3], c[4], c[4]], &weights(0.0)).w
                    }
                };
                walk.polygon(leg, from, end, &self.start);
                return Some(self.after(end, layout, walk, false));
            }
        }
        None
    }

    /// Notes how the path goes on after a section, and on which leg.
    fn after(&mut self, end: End, layout: &Layout, walk: &mut Walk, smooth: bool) -> usize {
        match end {
            End::Vertex(i) => {
                self.start = Start::Corner { smooth: false };
                i
            }
            End::Flat(i, place) => {
                // The rest of the leg, up to where the next spline begins.
                let reach = layout.reach(walk.vertices, i, i + 1);
                let to = walk.vertices[i + 1].place - reach;
                walk.straight(i, [place, to], smooth);
                if reach > 0.0 {
                    self.start = Start::Flat(to);
                    i
                } else {
                    self.start = layout.corner(i + 1);
                    i + 1
                }
            }
        }
    }

    /// The control points of a section before it is fitted, and how many at each end are given.
    fn controls(
        &self,
        layout: &Layout,
        leg: usize,
        end: f64,
        flat_end: bool,
        walk: &Walk,
    ) -> (Vec<DVec4>, [usize; 2]) {
        let vertices = walk.vertices;
        let (from, mut controls) = match self.start {
            Start::Corner { .. } => (vertices[leg].place, Vec::new()),
            Start::Flat(place) => (place, Vec::new()),
            Start::Spline(given) => (given[4].w, given.to_vec()),
        };
        let given = controls.len();
        // Steps of the wanted size, then drawn together a little to fit.
        let mut places = vec![from];
        let (mut place, mut at) = (from, leg);
        while place < end {
            while at + 2 < vertices.len() && vertices[at + 1].place < place {
                at += 1;
            }
            let step = layout.step(vertices, at, place);
            place += layout.step(vertices, at, place + 0.5 * step);
            places.push(place);
        }
        let count = places.len() - 1;
        let scale = (end - from) / (place - from).max(f64::MIN_POSITIVE);
        for place in &mut places {
            *place = from + (*place - from) * scale;
        }
        if given == 0 && count < FEWEST {
            places.clear();
            for i in 0..=FEWEST {
                places.push(from + (end - from) * i as f64 / FEWEST as f64);
            }
        }
        let count = places.len() - 1;
        if given == 0 {
            places[1] = 0.5 * (places[0] + places[2]);
            let step = places[1] - places[0];
            for i in [2.0, 1.0] {
                controls.push(DVec3::ZERO.extend(from - i * step));
            }
            controls.push(DVec3::ZERO.extend(from));
        }
        if count > 2 {
            places[count - 1] = 0.5 * (places[count] + places[count - 2]);
        }
        let step = if count > 0 { places[count] - places[count - 1] } else { layout.steps[leg] };
        for &place in &places[1..] {
            controls.push(DVec3::ZERO.extend(place));
        }
        for i in [1.0, 2.0] {
            controls.push(DVec3::ZERO.extend(end + i * step));
        }
        let mut fixed = [given, 0];
        let number = controls.len();
        if matches!(self.start, Start::Flat(_)) {
            fixed[0] = 5;
            for control in &mut controls[..5] {
                *control = walk.on_leg(leg, control.w).extend(control.w);
            }
        }
        if flat_end {
            fixed[1] = 5;
            let leg = leg_of(vertices, end);
            for control in &mut controls[number - 5..] {
                *control = walk.on_leg(leg, control.w).extend(control.w);
            }
        }
        (controls, fixed)
    }
}

/// Draws the knots together where the spline left the tube.
fn refine(layout: &mut Layout, controls: &[DVec4], broken: &[bool], vertices: &[Vertex]) {
    let mut scaled = usize::MAX;
    for (k, _) in broken.iter().enumerate().filter(|(_, broken)| **broken) {
        // Of the vertices on the interval and its neighbours, and the next ones, each once.
        let [first, last] = [controls[k + 1].w, controls[k + 4].w].map(|at| leg_of(vertices, at));
        for i in first..=last + 1 {
            if scaled == usize::MAX || i > scaled {
                layout.steps[i] *= REFINEMENT;
                scaled = i;
            }
        }
    }
    layout.grade(vertices);
}

impl Layout {
    /// Ends the spline in the sharpest corner next to where it first left the tube.
    fn part(&mut self, controls: &[DVec4], broken: &[bool], vertices: &[Vertex]) {
        let Some(k) = broken.iter().position(|broken| *broken) else { return };
        let [first, last] = [controls[k + 1].w, controls[k + 4].w].map(|at| leg_of(vertices, at));
        let first = first.max(1);
        let mut sharpest = first;
        for i in first..=last.min(vertices.len() - 3) + 1 {
            if self.turns[i] > self.turns[sharpest] {
                sharpest = i;
            }
        }
        self.kinds[sharpest] = Kind::Reversal;
    }
}

/// The leg that a place is on.
fn leg_of(vertices: &[Vertex], place: f64) -> usize {
    let after = vertices.partition_point(|vertex| vertex.place <= place);
    after.clamp(1, vertices.len() - 1) - 1
}

/// Hands out pieces along the polygon.
struct Walk<'a> {
    vertices: &'a [Vertex],
    marks: &'a [Mark],
    /// The block that the path is in.
    mark: usize,
    /// How far the path may be from the given one [mm], and the polygon of it.
    tolerance: f64,
    thinning: f64,
    /// Tries that failed so far.
    failures: usize,
    out: &'a mut Vec<Fitted>,
}

impl Walk<'_> {
    /// The point of a leg, or of its line before and after it, at a place [mm].
    fn on_leg(&self, leg: usize, place: f64) -> DVec3 {
        let [from, to] = [self.vertices[leg], self.vertices[leg + 1]];
        from.point + (to.point - from.point) * ((place - from.place) / (to.place - from.place))
    }

    /// Hands out a part of a leg, in pieces of the same feed.
    fn straight(&mut self, leg: usize, [from, to]: [f64; 2], smooth: bool) {
        let (mut from, mut smooth) = (from, smooth);
        while from < to {
            let end = self.same_feed(from, to);
            if let Some(piece) = Straight::between(self.on_leg(leg, from), self.on_leg(leg, end)) {
                let off = if self.vertices[leg + 1].exact { 0.0 } else { self.thinning };
                self.hand_out(Piece::Straight(piece), [from, end], off, smooth);
                smooth = true;
            }
            from = end;
        }
    }

    /// How far the path keeps the feed [mm].
    fn same_feed(&self, from: f64, to: f64) -> f64 {
        let (mut end, mut feed) = (from, 0.0);
        for mark in &self.marks[self.mark..] {
            if end > from && mark.feed != feed {
                return end;
            }
            if mark.place >= to {
                break;
            }
            (end, feed) = (mark.place, mark.feed);
        }
        to
    }

    /// Hands out the polygon from a place on.
    fn polygon(&mut self, leg: usize, from: f64, end: End, start: &Start) {
        let (last, to) = match end {
            End::Vertex(i) => (i - 1, self.vertices[i].place),
            End::Flat(i, place) => (i, place),
        };
        let mut from = from;
        let mut first = leg;
        if let Start::Spline(c) = start {
            // From the end of the spline, which is beside its leg.
            let point = blend(&[c[0], c[1], c[2], c[3], c[4], c[4]], &weights(0.0)).xyz();
            let next = self.vertices[leg + 1];
            if let Some(piece) = Straight::between(point, next.point) {
                let off = self.tolerance;
                self.hand_out(Piece::Straight(piece), [from, next.place], off, false);
            }
            from = next.place;
            first += 1;
        }
        for i in first..=last {
            let end = self.vertices[i + 1].place.min(to);
            self.straight(i, [from, end], i == first && matches!(start, Start::Flat(_)));
            from = end;
        }
    }

    /// Hands out an interval of a spline.
    fn spline(&mut self, tube: &Tube, k: usize, smooth: bool) {
        let powers = powers(&tube.controls[k..]);
        let places = [powers[0].w, value(&powers, 1.0).w];
        let curve = powers.map(Vec4Swizzles::xyz);
        let off = tube.farthest(k) + self.thinning;
        // Where the spline all but turns back, its own measure of length is not good enough.
        let piece = match Quintic::of_even_powers(curve) {
            Some(quintic) => Piece::Quintic(Box::new(quintic)),
            None => Piece::Curve(Box::new(ByLength::of_polynomial(curve.to_vec()))),
        };
        self.hand_out(piece, places, off, smooth);
    }

    /// Hands out the piece from a place to another, with the blocks that it stands for.
    fn hand_out(&mut self, piece: Piece, [from, to]: [f64; 2], off: f64, smooth: bool) {
        let length = piece.length();
        let scale = length / (to - from);
        let mut blocks = Vec::new();
        let mut feed = f64::INFINITY;
        while let Some(mark) = self.marks.get(self.mark) {
            // A block that ends within rounding of the piece's end ends with it.
            let over = (mark.place - to) * scale > -1e-9;
            let at = if over { length } else { (mark.place - from).max(0.0) * scale };
            let ends = mark.place <= to;
            feed = feed.min(mark.feed);
            blocks.push((at, mark.block));
            if !ends {
                break;
            }
            self.mark += 1;
            if over {
                break;
            }
        }
        self.out.push(Fitted { piece, blocks, feed, off, smooth });
    }
}
