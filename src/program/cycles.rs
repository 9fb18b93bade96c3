//! Canned cycles, expanded: G73, G74, G76 and G81 to G89 as `LinuxCNC` and FANUC document them.
//!
//! Numbers stay in effect from hole to hole until another motion word. Under G91, X and Y count
//! from hole to hole, R from the level at which the cycle began, and Z from R.

use glam::DVec3;

use super::arcs::CENTER;
use super::axes::Axes;
use super::block::{Block, Word};
use super::coordinates::AXES;
use super::dialect::Dialect;
use super::interpret::{GEOMETRY, Interpreter};
use super::number::whole;
use super::words::Words;
use crate::geometry::MIN_LENGTH;

/// How far a peck goes back (G73), and how far above the bottom the next one begins (G83) [mm]:
/// 0.01 inch, which `LinuxCNC` fixes and FANUC leaves to a parameter of the machine.
const PECK_CLEARANCE: f64 = 0.254;

/// Most holes of one block, and most pecks of one hole.
const MOST: u32 = 10_000;

/// The numbers of a cycle that stay in effect.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CycleNumbers {
    /// The cycle they were given for; none once it has ended.
    number: Option<u32>,
    /// Whether a block of a cycle was before.
    again: bool,
    /// The height at which the cycle began, as programmed [mm].
    initial: f64,
    /// R and the depth, as programmed [mm].
    retract: Option<f64>,
    depth: Option<f64>,
    /// P [s].
    dwell: Option<f64>,
    /// Q [mm].
    step: Option<f64>,
    /// I J K [mm].
    shift: [Option<f64>; 3],
}

/// One hole: points and heights as programmed [mm].
pub(super) struct Hole<'a> {
    pub(super) block: &'a Block,
    /// Where it is; its height does not count.
    pub(super) at: DVec3,
    pub(super) retract: f64,
    pub(super) bottom: f64,
    /// The height at which it is left.
    pub(super) clear: f64,
}

impl CycleNumbers {
    /// Another motion word, or G80, has ended the cycle.
    pub(super) fn end(&mut self) {
        self.number = None;
    }
}

impl Interpreter {
    /// A block of the cycle with this number.
    pub(super) fn cycle(&mut self, block: &Block, number: u32, words: &mut Words) {
        // LinuxCNC's G76 cuts a thread; FANUC's bores.
        let fanuc = self.dialect == Dialect::Fanuc;
        let strict = self.rules.is_strict;
        let cuts = strict || words.has_any("IJKE");
        if number == 76 && (self.dialect == Dialect::LinuxCnc || !fanuc && cuts) {
            return self.thread_cycle(block, words);
        }
        let normal = self.modal.plane.axes()[2];
        let hits = words.has_any("XYZ@^") || !strict && words.has_any("R");
        if strict && !hits {
            return;
        }
        let before = self.modal.cycle;
        if before.number.is_none() {
            let initial = self.modal.frame.unmap(self.modal.position)[normal];
            self.modal.cycle = CycleNumbers { initial, ..CycleNumbers::default() };
        } else if strict && before.number != Some(number) {
            let initial = before.initial;
            self.modal.cycle = CycleNumbers { initial, ..CycleNumbers::default() };
        }
        self.modal.cycle.number = Some(number);
        self.modal.cycle.again = before.number.is_some();
        let repeats = self.cycle_numbers(block, number, words);
        let depth = words.take(AXES[normal]);
        if let Some(depth) = depth {
            let length = self.modal.length_of(normal, depth.value);
            let numbers = &mut self.modal.cycle;
            // What FANUC keeps are places: G91 behind them adds nothing to them.
            let from = if fanuc && self.modal.relative { numbers.retract } else { Some(0.0) };
            numbers.depth = from.map(|from| from + length);
        }
        if !hits {
            return;
        }
        let compensates = self.course.switched().is_some();
        if compensates && self.rules.is_strict {
            self.refuse("a cycle may not be while compensation is on", block.start());
            return;
        }
        if compensates || self.modal.feed.is_inverse_time() {
            let what = if compensates { "with compensation on" } else { "under G93" };
            let at = block.start();
            self.error(
                "cycle-not-possible",
                format!("a cycle (G{number}) is not possible {what}"),
                at,
                "the hole is left out",
            );
            words.take_all(GEOMETRY);
            return;
        }
        let numbers = self.modal.cycle;
        let start = self.start_as_retract(block, number, normal);
        let (Some(retract), Some(bottom)) = (numbers.retract.or(start), numbers.depth) else {
            let missing = if numbers.retract.is_none() { 'R' } else { AXES[normal] };
            let at = block.start();
            self.error(
                "missing-depth",
                format!("the cycle (G{number}) has no {missing} word"),
                at,
                "give the level R and the depth; the hole is left out",
            );
            words.take_all(GEOMETRY);
            return;
        };
        let (retract, bottom) = if self.modal.relative && !fanuc {
            (numbers.initial + retract, numbers.initial + retract + bottom)
        } else {
            (retract, bottom)
        };
        if retract < bottom && (number != 87 || strict) {
            self.error(
                "retract-below-bottom",
                format!("the level R of the cycle (G{number}) is below its bottom"),
                block.start(),
                "the hole is left out",
            );
            words.take_all(GEOMETRY);
            return;
        }
        if !self.may_expand(block, repeats.saturating_mul(self.pecks_of(retract, bottom))) {
            words.take_all(GEOMETRY);
            return;
        }
        self.holes(block, number, [retract, bottom], repeats, words, depth);
        words.take_all("XYZ@^");
    }

    /// Reads the words besides the axes; returns how many holes the block makes.
    fn cycle_numbers(&mut self, block: &Block, number: u32, words: &mut Words) -> u32 {
        let unit = self.modal.unit();
        if let Some(word) = words.take('R') {
            let normal = self.modal.plane.axes()[2];
            let length = self.modal.length_of(normal, word.value);
            let fanuc = self.dialect == Dialect::Fanuc && self.modal.relative;
            let from = if fanuc { self.modal.cycle.initial } else { 0.0 };
            self.modal.cycle.retract = Some(from + length);
        }
        // What a control that is strict has no use for is left, and said not to be understood.
        let strict = self.rules.is_strict;
        if !(strict && matches!(number, 73 | 81 | 83 | 85 | 87))
            && let Some(word) = words.take('P')
        {
            self.modal.cycle.dwell = Some(self.seconds(block, word));
        }
        if (!strict || matches!(number, 73 | 83))
            && let Some(word) = words.take('Q')
        {
            self.modal.cycle.step = Some(word.value * unit);
        }
        // K repeats on newer FANUC controls; in other cycles than G76 and G87 it is nothing else.
        let mut repeats = if strict && number == 74 { None } else { words.take('L') };
        if matches!(number, 76 | 87) {
            for (i, axis) in self.modal.plane.axes().into_iter().enumerate() {
                if let Some(word) = words.take(CENTER[axis]) {
                    self.modal.cycle.shift[i] = Some(word.value * unit);
                }
            }
        } else if !strict {
            repeats = repeats.or_else(|| words.take('K'));
        }
        let least = u32::from(strict);
        match repeats {
            None => 1,
            Some(word) => {
                whole(word.value).filter(|n| (least..=MOST).contains(n)).unwrap_or_else(|| {
                    self.bad_repeats(block, word);
                    1
                })
            }
        }
    }

    /// Whether a control that is strict misses the dwell, the step or the feed.
    fn lacks_words(&mut self, block: &Block, number: u32) -> bool {
        let numbers = self.modal.cycle;
        let lacks = match number {
            82 | 86 | 88 | 89 => numbers.dwell.is_none(),
            73 | 83 => numbers.step.is_none_or(|step| step <= 0.0),
            _ => false,
        };
        if lacks {
            let letter = if matches!(number, 73 | 83) { 'Q' } else { 'P' };
            self.refuse(&format!("the cycle (G{number}) has no {letter} word"), block.start());
        }
        self.feed_of_moves(block);
        self.is_refused
    }

    /// Without R a cycle of Haas' begins where the tool is: none of the way down is rapid.
    fn start_as_retract(&mut self, block: &Block, number: u32, normal: usize) -> Option<f64> {
        let numbers = self.modal.cycle;
        if self.dialect != Dialect::Fanuc
            || numbers.retract.is_some()
            || numbers.depth.is_none()
            || !self.modal.stated[normal]
        {
            return None;
        }
        let message = format!("the cycle (G{number}) has no R word");
        let hint =
            "it begins at the height where the tool is, as Haas has it; others may refuse it";
        self.report.warning("no-retract", message, block.start(), hint);
        Some(numbers.initial)
    }

    fn bad_repeats(&mut self, block: &Block, word: &Word) {
        self.error(
            "bad-repeats",
            "no such number of holes",
            block.origin_at(word.column),
            "it is a whole number up to 10000; one hole is made",
        );
    }

    /// The holes of one block, `repeats` times what its axis words say.
    fn holes(
        &mut self,
        block: &Block,
        number: u32,
        [retract, bottom]: [f64; 2],
        repeats: u32,
        words: &Words,
        depth: Option<&Word>,
    ) {
        let plane = self.modal.plane;
        let normal = plane.axes()[2];
        let start = self.modal.frame.unmap(self.modal.position);
        let words = *words;
        let known = self.rules.is_strict || self.modal.stated[normal];
        if !known {
            self.modal.cycle.initial = retract;
        }
        let initial = self.modal.cycle.initial;
        let clear = if self.modal.retract_to_r { retract } else { initial.max(retract) };
        let back = number == 87 && !self.rules.is_strict;
        let mut down = Axes::default();
        down.words[normal] = depth.or(block.words.first());
        let mut height = start[normal];
        // A control that is strict goes straight from hole to hole, whatever the height of both.
        let again = self.rules.is_strict && self.modal.cycle.again;
        if !known {
            self.report.warning(
                "unknown-start",
                "a cycle begins before the program says how high the tool is",
                block.start(),
                "its holes are left at R; state the height before",
            );
        } else if (if again { initial } else { height }) < retract && !back {
            // Never across below the level R.
            height = retract;
            self.cycle_to(block, &down, start, height, true);
        }
        if again && height <= retract {
            height = clear;
        }
        if self.rules.is_strict && self.lacks_words(block, number) {
            return;
        }
        for repeat in 0..repeats {
            // Under G91 each hole lies farther on.
            let mut again = words;
            let mut at = self.modal.frame.unmap(self.modal.position);
            let mut axes = Axes::default();
            if again.has_any("XYZ@^") {
                let Some((found, to)) = self.target(block, &mut again, "") else { break };
                axes = found;
                at = self.modal.frame.unmap(to);
            }
            if repeat > 0 {
                height = clear;
            }
            self.cycle_to(block, &axes, at, height, true);
            if !back {
                self.cycle_to(block, &down, at, retract, true);
            }
            self.hole(number, &Hole { block, at, retract, bottom, clear });
        }
    }

    /// The moves and words of one hole, from the level R.
    fn hole(&mut self, number: u32, hole: &Hole) {
        let fanuc = self.dialect == Dialect::Fanuc;
        let &Hole { bottom, clear, retract, .. } = hole;
        let spindle = self.modal.spindle;
        let turns = match number {
            74 => spindle == Some(4),
            84 => spindle == Some(3),
            86..=88 => spindle.is_some(),
            _ => true,
        };
        if self.rules.is_strict && !turns {
            let message = format!("the cycle (G{number}) needs the spindle to turn its way");
            return self.refuse(&message, hole.block.start());
        }
        match number {
            73 | 83 => self.pecks(hole, number == 83),
            _ if number != 87 => self.go(hole, bottom, false),
            _ => {}
        }
        match number {
            74 | 84 => {
                let [forward, back] = if number == 84 { [3, 4] } else { [4, 3] };
                self.say(hole, "M5");
                self.restart(hole, Some(back));
                self.pause(hole);
                self.go(hole, if fanuc { retract } else { clear }, false);
                self.say(hole, "M5");
                self.restart(hole, Some(forward));
            }
            76 => {
                let shift = self.shift();
                self.pause(hole);
                self.say(hole, "M19");
                self.go(&Hole { at: hole.at + shift, ..*hole }, bottom, true);
                self.go(&Hole { at: hole.at + shift, ..*hole }, clear, true);
                self.go(hole, clear, true);
                self.restart(hole, spindle);
            }
            82 => self.pause(hole),
            85 => self.go(hole, retract, false),
            86 => {
                self.pause(hole);
                self.say(hole, "M5");
            }
            87 => return self.back_bore(hole),
            88 => {
                self.pause(hole);
                self.say(hole, "M5");
                self.say(hole, "M0");
            }
            89 => {
                self.pause(hole);
                self.go(hole, if fanuc { retract } else { clear }, false);
            }
            _ => {}
        }
        self.go(hole, clear, true);
        if matches!(number, 86 | 88) {
            self.restart(hole, spindle);
        }
    }

    /// How many steps of Q there are from R to the depth; one where they are no use.
    fn pecks_of(&self, retract: f64, bottom: f64) -> u32 {
        let count = ((retract - bottom) / self.modal.cycle.step.unwrap_or(0.0)).ceil();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
        if count >= 1.0 && count <= f64::from(MOST) { count as u32 } else { 1 }
    }

    /// Down in steps of Q: G83 goes back to R after each, G73 only so far that the chip breaks.
    fn pecks(&mut self, hole: &Hole, out: bool) {
        let step = self.modal.cycle.step.unwrap_or(0.0);
        let count = (hole.retract - hole.bottom) / step;
        if step > 0.0 && count <= f64::from(MOST) {
            let mut depth = hole.retract - step;
            // What rounding leaves above the depth LinuxCNC takes for one step more.
            let exact = self.rules.is_strict && !self.modal.inches;
            let least = if exact { 0.0 } else { MIN_LENGTH };
            while depth > hole.bottom + least {
                self.go(hole, depth, false);
                if out {
                    self.go(hole, hole.retract, true);
                }
                self.go(hole, depth + PECK_CLEARANCE, true);
                depth -= step;
            }
        } else {
            self.error(
                "bad-peck",
                "the step Q of the cycle is missing, not positive or far too small",
                hole.block.start(),
                "the hole is made in one step",
            );
        }
        self.go(hole, hole.bottom, false);
    }

    /// G87: from below. `LinuxCNC` bores from the depth up to K, FANUC from R up to the depth.
    fn back_bore(&mut self, hole: &Hole) {
        let spindle = self.modal.spindle;
        let numbers = self.modal.cycle;
        let shift = self.shift();
        let aside = Hole { at: hole.at + shift, ..*hole };
        let (low, high) = match numbers.shift[2] {
            Some(top) if self.modal.relative => (hole.bottom, hole.bottom + top),
            Some(top) => (hole.bottom, top),
            None => (hole.retract.min(hole.bottom), hole.bottom.max(hole.retract)),
        };
        let normal = self.modal.plane.axes()[2];
        let level = self.modal.frame.unmap(self.modal.position)[normal];
        let clear = hole.clear.max(level);
        self.say(hole, "M19");
        self.go(&aside, level, true);
        self.go(&aside, low, true);
        self.go(hole, low, true);
        self.restart(hole, spindle);
        self.go(hole, high, false);
        self.pause(hole);
        self.go(hole, low, false);
        self.say(hole, "M19");
        self.go(&aside, low, true);
        self.go(&aside, clear, true);
        self.go(hole, clear, true);
        self.restart(hole, spindle);
    }

    /// How far aside boring cycles move in the plane: I J, or Q along its first axis, as FANUC
    /// does it unless a parameter says otherwise.
    fn shift(&self) -> DVec3 {
        let numbers = self.modal.cycle;
        let [first, second, _] = self.modal.plane.axes();
        let mut shift = DVec3::ZERO;
        if numbers.shift[0].or(numbers.shift[1]).is_some() {
            shift[first] = numbers.shift[0].unwrap_or(0.0);
            shift[second] = numbers.shift[1].unwrap_or(0.0);
        } else {
            shift[first] = numbers.step.unwrap_or(0.0);
        }
        shift
    }

    fn pause(&mut self, hole: &Hole) {
        self.wait(hole, self.modal.cycle.dwell.unwrap_or(0.0));
    }

    /// Lets the spindle turn as before.
    fn restart(&mut self, hole: &Hole, spindle: Option<u32>) {
        if let Some(number) = spindle {
            self.say(hole, &format!("M{number}"));
        }
    }

    pub(super) fn say(&mut self, hole: &Hole, words: &str) {
        self.course.words(words.into(), hole.block.origin());
    }

    pub(super) fn go(&mut self, hole: &Hole, height: f64, rapid: bool) {
        self.cycle_to(hole.block, &Axes::default(), hole.at, height, rapid);
    }

    /// A straight move to a point and a height as programmed [mm].
    pub(super) fn cycle_to(
        &mut self,
        block: &Block,
        axes: &Axes,
        at: DVec3,
        height: f64,
        rapid: bool,
    ) {
        let mut to = at;
        to[self.modal.plane.axes()[2]] = height;
        let to = self.modal.frame.map(to);
        if self.leads_too_far(block, 1, to) {
            return;
        }
        if to.distance(self.modal.position) < MIN_LENGTH
            && (0..3).all(|i| axes.words[i].is_none() || self.modal.stated[i])
        {
            return;
        }
        let attributes = self.attributes(block, rapid, to);
        self.line(axes, to, attributes);
        self.arrive(axes, to);
    }
}
