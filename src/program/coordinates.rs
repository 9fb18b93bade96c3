//! Words that change coordinates, or move by those of the machine: G10, G28, G30, G52 to G59.3 and
//! G92.
//!
//! Where the origins lie the machine knows, so these words are passed on. The tool gets another
//! number for the same place where the program tells which; else its number is assumed until a
//! block states it.

use glam::DVec3;

use super::assumed::{Assumed, turned};
use super::auxiliary::{append_word, take_as_text, word as text_of};
use super::block::{Block, Word};
use super::dialect::Dialect;
use super::frame::radians;
use super::g_words::{Act, GWord, g_word};
use super::interpret::{GEOMETRY, Interpreter, is_axis};
use super::number::whole;
use super::words::{Words, tenths};
use crate::contour::Reset;

/// The letters of the axes.
pub(super) const AXES: [char; 3] = ['X', 'Y', 'Z'];

/// The coordinate systems of the machine, as far as the program tells.
#[derive(Debug, Clone)]
pub(super) struct Systems {
    /// The active one, 0 being G54.
    active: Option<usize>,
    /// Origins that G10 set [mm].
    origins: [[Option<f64>; 3]; 9],
    /// What G92 has taken off the coordinates [mm], where it is known, and what G92.2 keeps of it.
    shift: [[Option<f64>; 3]; 2],
    /// Which coordinates have origins that the program has set without saying where.
    lost: [bool; 3],
    /// Whether it was said where the machine's zero is taken to be.
    pub(super) said: bool,
    /// Their numbers on a control that is strict.
    pub(super) assumed: Assumed,
    /// Where the tool is in the coordinates of the machine while words change those of the program
    /// [mm], on a control that is strict.
    pub(super) held: Option<DVec3>,
}

impl Systems {
    pub(super) fn new() -> Self {
        Self {
            active: None,
            origins: [[None; 3]; 9],
            shift: [[Some(0.0); 3]; 2],
            lost: [false; 3],
            said: false,
            assumed: Assumed::default(),
            held: None,
        }
    }

    /// The active system, 0 being G54, if a word has said which.
    pub(super) fn active(&self) -> Option<usize> {
        self.active
    }

    /// A coordinate of the origin of a system [mm], if the program has set it.
    pub(super) fn origin(&self, system: usize, axis: usize) -> Option<f64> {
        *self.origins.get(system)?.get(axis)?
    }
}

impl Interpreter {
    /// What the words of the block do before its move.
    pub(super) fn acts(&mut self, block: &Block, words: &mut Words) {
        for word in &block.words {
            if word.letter == 'G'
                && let Some(number) = tenths(word)
                && let Some(GWord::Act(act)) = g_word(number, self.rules.is_strict)
            {
                let Systems { active, assumed, .. } = self.modal.systems;
                let machine = assumed.machine(active, self.modal.position);
                self.modal.systems.held = self.rules.is_strict.then_some(machine);
                self.act(block, word, act, number, words);
            }
        }
    }

    fn act(&mut self, block: &Block, word: &Word, act: Act, number: u32, words: &mut Words) {
        let passed_on = text_of('G', word.value);
        match act {
            Act::System(index) => self.system(block, word, index, passed_on, words),
            Act::SetData => self.set_data(block, word, words),
            Act::Origin => self.origin(block, word, false, words),
            Act::Local if self.rules.is_strict => self.origin(block, word, true, words),
            // LinuxCNC waits for no G40 here, and does nothing.
            Act::OriginOff | Act::OriginOn
                if self.rules.is_strict && self.course.switched().is_some() =>
            {
                let message = format!("{passed_on} does nothing while compensation is on");
                let at = block.origin_at(word.column);
                self.report.warning("changed-while-on", message, at, "switch it off (G40) before");
            }
            Act::OriginOff => {
                let systems = &mut self.modal.systems;
                let shift = systems.shift[0];
                systems.assumed.shift = DVec3::ZERO;
                // G92.2 keeps it for G92.3.
                if number != 922 {
                    systems.shift[1] = [Some(0.0); 3];
                    systems.assumed.kept = DVec3::ZERO;
                }
                self.shift_by(block, word, shift, passed_on);
                self.modal.systems.shift[0] = [Some(0.0); 3];
            }
            Act::OriginOn => {
                let kept = self.modal.systems.shift[1];
                let mut added = [None; 3];
                for i in 0..3 {
                    if let (Some(shift), Some(kept)) = (self.modal.systems.shift[0][i], kept[i]) {
                        added[i] = Some(shift - kept);
                    }
                }
                self.modal.systems.assumed.shift = self.modal.systems.assumed.kept;
                self.shift_by(block, word, added, passed_on);
                self.modal.systems.shift[0] = kept;
            }
            Act::Home => self.home(block, word, number, words),
            Act::StoreHome => {
                self.not_while_on(block, word);
                if let Some(machine) = self.modal.systems.held {
                    self.modal.systems.assumed.homes[usize::from(number > 300)] = machine;
                }
                self.pass_reset(block, passed_on);
            }
            Act::Machine => self.machine(block, word, words),
            Act::Local => {
                // What is resolved here changes no coordinates of the machine's system.
                if self.course.switched().is_some() {
                    self.leave_contour(block, word.column, "the coordinate system", None);
                }
                for (i, letter) in AXES.into_iter().enumerate() {
                    if let Some(axis) = words.take(letter) {
                        self.modal.frame.local[i] = self.modal.length_of(i, axis.value);
                    }
                }
            }
            Act::Scale(_) | Act::Mirror(_) | Act::Rotate(_) | Act::Polar(_) => {
                self.transform(block, word, act, words);
            }
        }
    }

    /// Passes words on after which the next move starts where it says.
    pub(super) fn pass_reset(&mut self, block: &Block, text: String) {
        if self.is_refused {
            return;
        }
        let systems = &mut self.modal.systems;
        if let Some(machine) = systems.held {
            self.modal.position = systems.assumed.place(systems.active, machine);
        }
        let states = std::mem::take(&mut self.owed);
        let reset = Reset { at: self.modal.position, states, moves: 0 };
        self.course.reset(text, block.origin(), reset);
    }

    /// G54 to G59.3.
    fn system(
        &mut self,
        block: &Block,
        word: &Word,
        index: Option<usize>,
        mut text: String,
        words: &mut Words,
    ) {
        let mut index = index;
        if index.is_none() || !self.rules.is_strict && !words.has_any("XYZR") && words.has_any("P")
        {
            // G54 P1 is G54.1 P1, too.
            index = None;
            take_as_text(words, "P", &mut text);
        }
        let before = self.modal.systems.active;
        if index.is_some() && before == index {
            self.not_while_on(block, word);
            return;
        }
        self.leave_contour(block, word.column, "the coordinate system", None);
        let systems = &self.modal.systems;
        let origin = |system: Option<usize>, i: usize| {
            system.and_then(|system| systems.origins.get(system)).and_then(|origin| origin[i])
        };
        for i in 0..3 {
            match (origin(before, i), origin(index, i)) {
                (Some(old), Some(new)) => self.modal.position[i] += old - new,
                _ => self.modal.stated[i] = false,
            }
        }
        self.modal.systems.active = index;
        self.pass_reset(block, text);
    }

    /// Gives the place of the tool numbers that are larger by `added` [mm].
    fn shift_by(&mut self, block: &Block, word: &Word, added: [Option<f64>; 3], text: String) {
        self.leave_contour(block, word.column, "the coordinate system", None);
        for (i, added) in added.into_iter().enumerate() {
            match added {
                Some(added) => self.modal.position[i] += added,
                None => self.modal.stated[i] = false,
            }
        }
        self.pass_reset(block, text);
    }

    /// G92: the place of the tool gets the numbers in the block; or, `by_shift`, those that it has
    /// where they are what is taken off (G52 of `LinuxCNC`, which is passed on as G92).
    fn origin(&mut self, block: &Block, word: &Word, by_shift: bool, words: &mut Words) {
        let mut text = String::from("G92");
        let mut programmed = self.modal.frame.unmap(self.modal.position);
        let mut given = [false; 3];
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(axis) = words.take(letter) {
                let length = self.modal.length_of(i, axis.value);
                let kept = self.modal.position[i] + self.modal.systems.assumed.shift[i];
                programmed[i] = if by_shift { kept - length } else { length };
                given[i] = true;
            }
        }
        let others = self.other_origins(words, &mut text);
        if given == [false; 3] && !others {
            if self.rules.is_strict {
                self.error(
                    "missing-axes",
                    "the word has no axes",
                    block.origin_at(word.column),
                    "",
                );
            }
            return;
        }
        self.leave_contour(block, word.column, "the coordinate system", None);
        let to = self.modal.frame.map(programmed);
        if self.leads_too_far(block, word.column, to) {
            return;
        }
        for i in 0..3 {
            if given[i] {
                let added = self.modal.position[i] - to[i];
                let systems = &mut self.modal.systems;
                let shift = &mut systems.shift[0][i];
                let known = self.modal.stated[i];
                *shift = shift.filter(|_| known).map(|shift| shift + added);
                systems.assumed.shift[i] += added;
                self.modal.position[i] = to[i];
                self.modal.stated[i] = true;
                append_word(&mut text, AXES[i], to[i]);
            }
        }
        let systems = &mut self.modal.systems;
        systems.shift[1] = systems.shift[0];
        systems.assumed.kept = systems.assumed.shift;
        self.pass_reset(block, text);
    }

    /// G10: origins, and the radii of tools.
    fn set_data(&mut self, block: &Block, word: &Word, words: &mut Words) {
        let unit = self.modal.unit();
        let (kind, number, radius) = (words.take('L'), words.take('P'), words.take('R'));
        let fanuc = self.dialect == Dialect::Fanuc;
        let Some(kind) = kind.and_then(|kind| whole(kind.value)) else {
            words.take_all("XYZABCUVWQIJ");
            self.not_supported(block, word.column, "G10 without an L word");
            return;
        };
        let mut text = format!("G10 L{kind}");
        let strict = self.rules.is_strict;
        let rounded = |number: f64| if strict { number.round() } else { number };
        let number = number.and_then(|number| whole(rounded(number.value)));
        if strict {
            let message = match (kind, number) {
                (2 | 20, Some(0..=9)) | (0 | 1 | 10 | 11, Some(_)) => "",
                (2 | 20, _) => "P is no coordinate system (0 to 9)",
                (1 | 10 | 11, None) => "P is no tool",
                _ => "L is none of 1, 2, 10, 11 and 20",
            };
            if !message.is_empty() {
                return self.refuse(message, block.origin_at(word.column));
            }
        }
        if let Some(number) = number {
            append_word(&mut text, 'P', f64::from(number));
        }
        // Only in these is R an angle.
        let is_origin = kind == 2 || kind == 20;
        let mut size = radius.map(|radius| radius.value * if is_origin { 1.0 } else { unit });
        if fanuc && self.modal.relative && (is_origin || size.is_some()) {
            // What is given is added to what is there.
            let there = match kind {
                12 => number.and_then(|number| self.modal.radii.of(number)),
                13 => number.and_then(|number| self.modal.wears.of(number)),
                _ => None,
            };
            let Some(there) = there else {
                words.take_all(GEOMETRY);
                let what = "G10 with G91, to add to what only the machine knows,";
                return self.not_supported(block, word.column, what);
            };
            size = size.map(|size| size + there);
        }
        if let Some(size) = size {
            append_word(&mut text, 'R', size);
        }
        let mut given = [None; 3];
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(axis) = words.take(letter) {
                given[i] = Some(self.modal.length_of(i, axis.value));
                append_word(&mut text, letter, self.modal.length_of(i, axis.value));
            }
        }
        let tip = words.find('Q').and_then(|word| whole(word.value)).filter(|tip| *tip <= 9);
        take_as_text(words, "ABCUVWQIJ", &mut text);
        if is_origin {
            // P0 is the active one; on FANUC it shifts all of them.
            let active = self.modal.systems.active;
            let system = match number {
                Some(0) | None => active,
                Some(number) => Some(number as usize - 1),
            };
            if !self.rules.is_strict || system.is_none_or(|one| one == active.unwrap_or(0)) {
                self.leave_contour(block, word.column, "the coordinate system", None);
            }
            let concerns_all = radius.is_some() || fanuc && (number == Some(0) || kind == 20);
            self.assume(kind == 20, system.unwrap_or(0), given, radius.map(|word| word.value));
            self.origins(kind == 20, system, given, concerns_all);
        } else if let Some(number) = number
            && match kind {
                1 | 10 | 11 => !fanuc,
                12 | 13 => true,
                _ => false,
            }
        {
            if let Some(size) = size {
                let worn = kind == 13;
                let table = if worn { &mut self.modal.wears } else { &mut self.modal.radii };
                table.set(number, size);
            }
            if let Some(tip) = tip {
                self.modal.tips.set(number, f64::from(tip));
            }
        }
        self.pass_reset(block, text);
    }

    /// The same for the numbers of a control that is strict.
    fn assume(
        &mut self,
        by_place: bool,
        system: usize,
        given: [Option<f64>; 3],
        angle: Option<f64>,
    ) {
        let Systems { active, assumed, held, .. } = &mut self.modal.systems;
        let Some(machine) = held else { return };
        if by_place {
            return assumed.set_by_place(system, *machine, given);
        }
        let shift = assumed.shift;
        let Some((origin, turns)) = assumed.origins.get_mut(system) else { return };
        if let Some(angle) = angle.map(radians) {
            // It turns the number of the place alone, not also what G92 takes off.
            if system == active.unwrap_or(0) {
                *machine += turned(shift, angle) - turned(shift, *turns);
            }
            *turns = angle;
        }
        for (origin, given) in origin.as_mut().iter_mut().zip(given) {
            *origin = given.unwrap_or(*origin);
        }
    }

    /// New origins of a coordinate system [mm], or new numbers for the place of the tool in it.
    fn origins(
        &mut self,
        by_place: bool,
        system: Option<usize>,
        given: [Option<f64>; 3],
        concerns_all: bool,
    ) {
        let modal = &mut self.modal;
        if concerns_all {
            modal.stated = [false; 3];
            modal.systems.origins = [[None; 3]; 9];
            modal.systems.lost = [true; 3];
            return;
        }
        let is_active = system == modal.systems.active;
        for (i, given) in given.into_iter().enumerate() {
            let Some(given) = given else { continue };
            let origin = system.and_then(|s| modal.systems.origins.get_mut(s)).map(|o| &mut o[i]);
            let before = origin.as_ref().and_then(|origin| **origin);
            modal.systems.lost[i] |= by_place;
            let value = if by_place {
                None
            } else if modal.relative && !self.rules.is_strict {
                before.map(|before| before + given)
            } else {
                Some(given)
            };
            if let Some(origin) = origin {
                *origin = value;
            }
            // Before any G54 the active system is not known, and may be this one.
            if is_active && by_place {
                modal.position[i] = given;
                modal.stated[i] = true;
            } else if is_active || modal.systems.active.is_none() {
                match before.zip(value) {
                    Some((before, value)) if is_active => modal.position[i] += before - value,
                    _ => modal.stated[i] = false,
                }
            }
        }
    }

    /// G28 and G30: by way of a point to where only the machine knows.
    fn home(&mut self, block: &Block, word: &Word, number: u32, words: &mut Words) {
        self.leave_contour(block, word.column, "the reference point", None);
        let mut text = text_of('G', word.value);
        let mut named = [false; 3];
        let from = self.modal.position;
        let mut via = self.modal.frame.unmap(from);
        let bare = words.unused().any(|(_, word)| is_axis(word) && word.value.is_nan());
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(axis) = words.take(letter) {
                named[i] = true;
                let length = if bare { 0.0 } else { self.modal.length_of(i, axis.value) };
                via[i] = if bare || self.modal.relative { via[i] + length } else { length };
                append_word(&mut text, letter, length);
            }
        }
        let rotary = words.has_any("ABCUVW");
        self.forget_others(words);
        take_as_text(words, "ABCUVWP", &mut text);
        let relative = (bare || self.modal.relative) && (rotary || named != [false; 3]);
        if relative {
            text = format!("G91 {text}");
        }
        if named == [false; 3] && !rotary {
            named = [true; 3];
        }
        self.forget(named);
        let via = self.modal.frame.map(via);
        let place = self.modal.systems.assumed.homes[usize::from(number == 300)];
        let home = self.machine_place(block, named, place, via);
        let ways = home.map(|home| [via, home]);
        let ways = ways.as_ref().map_or(&[][..], |ways| ways);
        self.by_words(block, text, from, ways, true, None);
        if relative {
            self.course.words("G90".into(), block.origin());
        }
    }

    /// From here on the numbers of these axes are only assumed.
    pub(super) fn forget(&mut self, axes: [bool; 3]) {
        for (stated, forgotten) in self.modal.stated.iter_mut().zip(axes) {
            *stated &= !forgotten;
        }
    }
}
