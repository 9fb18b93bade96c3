//! Moves that are passed on as words: of other axes than x, y and z, threads, probing, and those to
//! where the machine is the only one to know, as far as that can be told.

use glam::{BVec3, DVec3};

use super::auxiliary::{append_word, take_as_text, word as text_of};
use super::block::{Block, Word};
use super::coordinates::AXES;
use super::dialect::Dialect;
use super::g_words::Motion;
use super::interpret::{GEOMETRY, Interpreter, MINUTE};
use super::items::Item;
use super::words::Words;
use crate::contour::{Move, MoveCurve, Reset, Role};
use crate::diagnostic::Diagnostic;
use crate::geometry::Line;

/// The letters of the other axes: three that turn, three that go straight.
pub(super) const OTHERS: [char; 6] = ['A', 'B', 'C', 'U', 'V', 'W'];

impl Interpreter {
    /// The words of the other axes as text, absolute, and how far they move.
    pub(super) fn other_axes(&mut self, block: &Block, words: &mut Words) -> (String, f64) {
        let (mut text, mut way) = (String::new(), 0.0_f64);
        for (i, letter) in OTHERS.into_iter().enumerate() {
            let Some(word) = words.take(letter) else { continue };
            let mut to = if i < 3 { word.value } else { word.value * self.modal.unit() };
            let before = self.modal.others[i];
            if self.modal.relative {
                if before.is_none() {
                    self.unknown_start(block, word.column);
                }
                to += before.unwrap_or(0.0);
            }
            self.modal.others[i] = Some(to);
            way = way.hypot(to - before.unwrap_or(to));
            if text.is_empty() {
                text = text_of(letter, to);
            } else {
                append_word(&mut text, letter, to);
            }
        }
        (text, way)
    }

    /// A block that moves other axes alone. Their feed is in degrees, or lengths, a minute.
    pub(super) fn turn_others(&mut self, block: &Block, rapid: bool, others: &str, way: f64) {
        let mut text = String::from(if rapid { "G0 " } else { "G1 " });
        text.push_str(others);
        if !rapid {
            let turns = others.starts_with(['A', 'B', 'C']);
            let unit = if turns { self.modal.unit() } else { 1.0 };
            let feed = match self.feed_of_moves(block) {
                (_, Some(time)) => Some(way / time),
                (feed, None) => feed.map(|feed| feed / unit),
            };
            if let Some(feed) = feed.filter(|feed| *feed > 0.0) {
                append_word(&mut text, 'F', feed * MINUTE);
            }
        }
        self.course.words(text, block.origin());
    }

    /// The words of G92 for the other axes; whether there are any.
    pub(super) fn other_origins(&mut self, words: &mut Words, text: &mut String) -> bool {
        let mut any = false;
        for (i, letter) in OTHERS.into_iter().enumerate() {
            if let Some(word) = words.take(letter) {
                let value = if i < 3 { word.value } else { word.value * self.modal.unit() };
                self.modal.others[i] = Some(value);
                append_word(text, letter, value);
                any = true;
            }
        }
        any
    }

    /// The other axes are where only the machine knows.
    pub(super) fn forget_others(&mut self, words: &Words) {
        for (i, letter) in OTHERS.into_iter().enumerate() {
            if words.has_any(letter.encode_utf8(&mut [0; 4])) {
                self.modal.others[i] = None;
            }
        }
    }

    /// Threads, and probing, which may end anywhere before it ends.
    pub(super) fn passed_move(&mut self, block: &Block, tenths: u32, words: &mut Words) {
        let thread = tenths == 330 || tenths == 331;
        if self.course.switched().is_some() && words.has_any("XYZ") {
            let what = if thread { "a thread" } else { "probing" };
            let message = format!("{what} may not be while compensation is on");
            if self.rules.is_strict {
                self.refuse(&message, block.start());
            } else {
                let hint = "it is left out; switch compensation off with G40 before";
                self.error("not-while-on", message, block.start(), hint);
            }
            words.take_all(GEOMETRY);
            return;
        }
        let from = self.modal.position;
        let Some((axes, to)) = self.target(block, words, "") else { return };
        self.leave_contour(block, block.words.first().map_or(1, |w| w.column), "the feed", None);
        let mut text = text_of('G', f64::from(tenths) / 10.0);
        let mut named = [false; 3];
        for (i, letter) in AXES.into_iter().enumerate() {
            named[i] = axes.words[i].is_some() || to[i] != from[i];
            if named[i] {
                append_word(&mut text, letter, to[i]);
            }
        }
        let (others, _) = self.other_axes(block, words);
        if !others.is_empty() {
            text.push(' ');
            text.push_str(&others);
        }
        let mut feed = None;
        if thread && self.rules.is_strict {
            if self.modal.spindle.is_none() {
                self.refuse("a thread needs a spindle that turns", block.start());
            } else if block.words.iter().any(|word| word.letter == 'F') {
                self.refuse("a thread has its lead (K) and no feed (F)", block.start());
            }
        }
        if thread {
            let letter = if self.dialect == Dialect::Fanuc { 'F' } else { 'K' };
            if let Some(lead) = words.take(letter).map(|word| word.value * self.modal.unit()) {
                append_word(&mut text, 'K', lead);
                feed = self.modal.feed.speed().map(|speed| speed * lead);
            } else {
                let hint = "add it; the target will refuse the block";
                self.error("missing-lead", "the thread has no lead", block.start(), hint);
            }
        } else if let (Some(given), _) = self.feed_of_moves(block) {
            feed = Some(given);
            append_word(&mut text, 'F', given * MINUTE);
        }
        self.arrive(&axes, to);
        // A tap comes back.
        let ways = [to, from];
        let ways = &ways[..if tenths == 331 { 2 } else { 1 }];
        self.by_words(block, text, from, ways, false, feed);
        if !thread {
            self.forget(named);
        }
    }

    /// Words that themselves make straight moves by these points [mm]: rapid, or at a feed [mm/s] if
    /// that is known.
    pub(super) fn by_words(
        &mut self,
        block: &Block,
        text: String,
        mut from: DVec3,
        ways: &[DVec3],
        rapid: bool,
        feed: Option<f64>,
    ) {
        if self.is_refused {
            return;
        }
        let plane = self.modal.plane;
        let states = std::mem::take(&mut self.owed);
        let mut moves_back = states != [false; 3];
        let mut moves = Vec::with_capacity(ways.len());
        for &to in ways {
            let ((a, low), (b, high)) = (plane.split(from), plane.split(to));
            let curve = Line::new(a, b).map_or(MoveCurve::Vertical(a), MoveCurve::Line);
            let leads = !matches!(curve, MoveCurve::Vertical(_)) || low != high;
            // From beside a contour the first one leads back to the program.
            if leads || self.rules.is_strict && moves_back {
                moves.push(Move {
                    curve,
                    role: Role::Free,
                    rapid,
                    feed,
                    plane,
                    heights: [low, high],
                    origin: block.origin(),
                });
            }
            from = to;
            moves_back = false;
        }
        if !ways.is_empty() {
            self.modal.position = from;
        }
        let reset = Reset { at: self.modal.position, states, moves: moves.len() };
        self.course.reset(text, block.origin(), reset);
        self.course.items.extend(moves.into_iter().map(Item::Free));
    }

    /// The coordinates of the place that is `place` in those of the machine on the axes that are
    /// named, and `at` on the others [mm]: on a control whose origins, unless the program sets them,
    /// are taken to be at the machine's zero.
    pub(super) fn machine_place(
        &mut self,
        block: &Block,
        named: [bool; 3],
        place: DVec3,
        at: DVec3,
    ) -> Option<DVec3> {
        if !self.rules.is_strict {
            return None;
        }
        let systems = &self.modal.systems;
        let machine = systems.assumed.machine(systems.active(), at);
        let machine = DVec3::select(BVec3::from_array(named), place, machine);
        let place = systems.assumed.place(systems.active(), machine);
        if std::mem::replace(&mut self.modal.systems.said, true) {
            return Some(place);
        }
        let message = "the places of the machine are those where all origins are at its zero";
        self.report.push(
            Diagnostic::info("assumed-origins", message)
                .with_origin(block.origin())
                .with_hint("but for those that the program sets; reference points, lengths, too"),
        );
        Some(place)
    }

    /// `LinuxCNC`'s G76: a thread in several passes, which begins and ends where the tool is.
    pub(super) fn thread_cycle(&mut self, block: &Block, words: &mut Words) {
        if !words.has_any("Z") {
            return;
        }
        if self.rules.is_strict
            && !['P', 'I', 'J', 'K'].iter().all(|&word| words.find(word).is_some())
        {
            return self.refuse("the thread (G76) has not all of P, I, J and K", block.start());
        }
        let from = self.modal.position;
        let Some((_, to)) = self.target(block, words, "") else { return };
        if self.course.switched().is_some() {
            let message = "a thread may not be while compensation is on";
            if self.rules.is_strict {
                return self.refuse(message, block.start());
            }
            let hint = "it is left out; switch compensation off with G40 before";
            self.error("not-while-on", message, block.start(), hint);
            return words.take_all(GEOMETRY);
        }
        let unit = self.modal.unit();
        let mut text = String::from("G76");
        append_word(&mut text, 'Z', to.z);
        for letter in ['P', 'I', 'J', 'K', 'E'] {
            if let Some(word) = words.take(letter) {
                append_word(&mut text, letter, word.value * unit);
            }
        }
        take_as_text(words, "RQHL", &mut text);
        self.by_words(block, text, from, &[], true, None);
    }

    /// G53: a straight move in the coordinates of the machine.
    pub(super) fn machine(&mut self, block: &Block, word: &Word, words: &mut Words) {
        if self.rules.is_strict && self.modal.relative {
            return self.refuse("G53 may not be incremental", block.origin_at(word.column));
        }
        if !self.rules.is_strict && !words.has_any("XYZABCUVW") {
            // Safe starts name it without a place to go to.
            return;
        }
        let motion = match self.modal.motion {
            Some(Motion::Rapid) => "G0",
            Some(Motion::Linear) => "G1",
            _ => {
                self.error(
                    "no-motion-mode",
                    "machine coordinates (G53) need G00 or G01",
                    block.origin_at(word.column),
                    "put one of them into the block",
                );
                words.take_all("XYZABCUVWIJKR");
                return;
            }
        };
        self.leave_contour(block, word.column, "the coordinate system", None);
        let mut text = format!("G53 {motion}");
        let (mut named, mut place) = ([false; 3], DVec3::ZERO);
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(axis) = words.take(letter) {
                named[i] = true;
                place[i] = self.modal.length_of(i, axis.value);
                append_word(&mut text, letter, place[i]);
            }
        }
        let rotary = words.has_any("ABCUVW");
        self.forget_others(words);
        take_as_text(words, "ABCUVW", &mut text);
        let mut feed = None;
        if motion == "G1"
            && let (Some(given), _) = self.feed_of_moves(block)
        {
            append_word(&mut text, 'F', given * MINUTE);
            feed = Some(given);
        }
        if rotary || named != [false; 3] {
            self.forget(named);
            let from = self.modal.position;
            let to = self.machine_place(block, named, place, from);
            self.by_words(block, text, from, to.as_slice(), motion == "G0", feed);
        }
    }
}
