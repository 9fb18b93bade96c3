//! Words that change coordinates, or move by those of the machine: G10, G28, G30, G52 to G59.3,
//! G92, scaling, mirroring, rotation and polar coordinates.
//!
//! Where the origins lie the machine knows, so these words are passed on. The tool gets another
//! number for the same place where the program tells which; else its number is assumed until a
//! block states it.

use glam::{DVec2, DVec3};

use super::auxiliary::{append_word, take_as_text, word as text_of};
use super::block::{Block, Word};
use super::dialect::Dialect;
use super::frame::{Frame, Polar, radians};
use super::g_words::{Act, GWord, g_word};
use super::interpret::Interpreter;
use super::number::whole;
use super::other_moves::pick;
use super::words::{Words, tenths};
use crate::contour::Reset;
use crate::diagnostic::Diagnostic;
use crate::geometry::{Decimal, MAX_COORDINATE, turn};

/// The letters of the axes.
pub(super) const AXES: [char; 3] = ['X', 'Y', 'Z'];

/// Scaling factors from here on are thousandths, as FANUC counts them without a decimal point.
const THOUSANDTHS: f64 = 10.0;

/// Smallest scaling factor: coordinates divided by it stay numbers.
const MIN_FACTOR: f64 = 1e-3;

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
}

impl Systems {
    pub(super) fn new() -> Self {
        Self {
            active: None,
            origins: [[None; 3]; 9],
            shift: [[Some(0.0); 3]; 2],
            lost: [false; 3],
            said: false,
        }
    }

    /// The active system, 0 being G54, if a word has said which.
    pub(super) fn active(&self) -> Option<usize> {
        self.active
    }

    /// The number of the machine's zero in the active system [mm], where the origins that no block
    /// sets lie there.
    pub(super) fn machine_zero(&self, axis: usize) -> Option<f64> {
        let origin = self.origin(self.active.unwrap_or(0), axis).unwrap_or(0.0);
        self.shift[0][axis].filter(|_| !self.lost[axis]).map(|shift| -shift - origin)
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
                && let Some(GWord::Act(act)) = g_word(number)
            {
                self.act(block, word, act, number, words);
            }
        }
    }

    fn act(&mut self, block: &Block, word: &Word, act: Act, number: u32, words: &mut Words) {
        let passed_on = text_of('G', word.value);
        match act {
            Act::System(index) => self.system(block, word, index, passed_on, words),
            Act::SetData => self.set_data(block, word, words),
            Act::Origin => self.origin(block, word, words),
            Act::OriginOff => {
                let shift = self.modal.systems.shift[0];
                self.modal.systems.shift[1] = if number == 922 { shift } else { [Some(0.0); 3] };
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
                self.shift_by(block, word, added, passed_on);
                self.modal.systems.shift[0] = kept;
            }
            Act::Home => self.home(block, word, words),
            Act::StoreHome => self.pass_reset(block, passed_on),
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
    fn pass_reset(&mut self, block: &Block, text: String) {
        if self.is_refused {
            return;
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
        if index.is_none() {
            take_as_text(words, "P", &mut text);
        }
        let before = self.modal.systems.active;
        if index.is_some() && before == index {
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

    /// G92: the place of the tool gets the numbers in the block.
    fn origin(&mut self, block: &Block, word: &Word, words: &mut Words) {
        let mut text = text_of('G', word.value);
        let mut programmed = self.modal.frame.unmap(self.modal.position);
        let mut given = [false; 3];
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(axis) = words.take(letter) {
                programmed[i] = self.modal.length_of(i, axis.value);
                given[i] = true;
            }
        }
        let others = self.other_origins(words, &mut text);
        if given == [false; 3] && !others {
            return;
        }
        self.leave_contour(block, word.column, "the coordinate system", None);
        let to = self.modal.frame.map(programmed);
        if self.leads_too_far(block, word.column, to) {
            return;
        }
        for i in 0..3 {
            if given[i] {
                let shift = &mut self.modal.systems.shift[0][i];
                let known = self.modal.stated[i];
                *shift = shift.filter(|_| known).map(|s| s + self.modal.position[i] - to[i]);
                self.modal.position[i] = to[i];
                self.modal.stated[i] = true;
                append_word(&mut text, AXES[i], to[i]);
            }
        }
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
        let number = number.and_then(|number| whole(number.value));
        if let Some(number) = number {
            append_word(&mut text, 'P', f64::from(number));
        }
        // Only in these is R an angle.
        let is_origin = kind == 2 || kind == 20;
        let radius_unit = if is_origin { 1.0 } else { unit };
        if let Some(radius) = radius {
            append_word(&mut text, 'R', radius.value * radius_unit);
        }
        let mut given = [None; 3];
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(axis) = words.take(letter) {
                given[i] = Some(self.modal.length_of(i, axis.value));
                append_word(&mut text, letter, self.modal.length_of(i, axis.value));
            }
        }
        take_as_text(words, "ABCUVWQIJ", &mut text);
        if is_origin {
            self.leave_contour(block, word.column, "the coordinate system", None);
            // P0 is the active one; on FANUC it shifts all of them.
            let active = self.modal.systems.active;
            let system = match number {
                Some(0) | None => active,
                Some(number) => Some(number as usize - 1),
            };
            let concerns_all = radius.is_some() || fanuc && (number == Some(0) || kind == 20);
            self.origins(kind == 20, system, given, concerns_all);
        } else if let (Some(number), Some(radius)) = (number, radius)
            && match kind {
                1 | 10 | 11 => !fanuc,
                12 => true,
                _ => false,
            }
        {
            self.modal.set_radius(number, radius.value * unit);
        }
        self.pass_reset(block, text);
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
    fn home(&mut self, block: &Block, word: &Word, words: &mut Words) {
        self.leave_contour(block, word.column, "the reference point", None);
        let mut text = text_of('G', word.value);
        let mut named = [false; 3];
        let from = self.modal.position;
        let mut via = self.modal.frame.unmap(from);
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(axis) = words.take(letter) {
                named[i] = true;
                let length = self.modal.length_of(i, axis.value);
                via[i] = if self.modal.relative { via[i] + length } else { length };
                append_word(&mut text, letter, length);
            }
        }
        let rotary = words.has_any("ABCUVW");
        self.forget_others(words);
        take_as_text(words, "ABCUVWP", &mut text);
        let relative = self.modal.relative && (rotary || named != [false; 3]);
        if relative {
            text = format!("G91 {text}");
        }
        if named == [false; 3] && !rotary {
            named = [true; 3];
        }
        self.forget(named);
        let via = self.modal.frame.map(via);
        let zero = self.machine_zero(block, named);
        let home = zero.map(|zero| pick(named, zero, via));
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

    /// G15, G16, G50, G51, G50.1, G51.1, G68 and G69.
    fn transform(&mut self, block: &Block, word: &Word, act: Act, words: &mut Words) {
        let plane = self.modal.plane;
        let before = self.modal.frame.clone();
        let mut at = before.unmap(self.modal.position);
        let mut given = [false; 3];
        if matches!(act, Act::Scale(true) | Act::Mirror(_) | Act::Rotate(true)) {
            for (i, letter) in AXES.into_iter().enumerate() {
                if let Some(axis) = words.take(letter) {
                    at[i] = self.modal.length_of(i, axis.value);
                    given[i] = true;
                }
            }
        }
        if self.leads_too_far(block, word.column, at) {
            return;
        }
        let frame = &mut self.modal.frame;
        let what = match act {
            Act::Polar(on) => {
                let (pole, angle) = if self.modal.relative {
                    (plane.split(at).0, 0.0)
                } else {
                    let flat = plane.split(at).0;
                    (DVec2::ZERO, turn(DVec2::X, flat))
                };
                frame.polar = on.then_some(Polar { pole, angle });
                return;
            }
            Act::Rotate(false) => {
                frame.rotation = None;
                "the rotation"
            }
            Act::Rotate(true) => {
                let Some(angle) = words.take('R') else {
                    let at = block.origin_at(word.column);
                    self.error("missing-angle", "the rotation (G68) has no angle", at, "add R");
                    return;
                };
                frame.rotation = Some((plane, plane.split(at).0, radians(angle.value)));
                "the rotation"
            }
            Act::Mirror(on) => {
                for i in 0..3 {
                    if given[i] || !on && given == [false; 3] {
                        frame.mirror[i] = on.then_some(at[i]);
                    }
                }
                "the mirror"
            }
            _ => {
                let Some(factors) = self.factors(block, word, act, words) else { return };
                self.modal.frame.factors = factors;
                self.modal.frame.fixed = at;
                "the scale"
            }
        };
        if self.course.switched().is_some() && differs(&before, &self.modal.frame) {
            self.leave_contour(block, word.column, what, None);
        }
    }

    /// The factors of G51, or those of G50.
    fn factors(
        &mut self,
        block: &Block,
        word: &Word,
        act: Act,
        words: &mut Words,
    ) -> Option<DVec3> {
        if act == Act::Scale(false) {
            return Some(DVec3::ONE);
        }
        let all = words.take('P');
        let (mut factors, mut thousandths) = (DVec3::ONE, None);
        for (i, letter) in ['I', 'J', 'K'].into_iter().enumerate() {
            let Some(found) = words.take(letter).or(all) else { continue };
            factors[i] = found.value;
            if found.value.abs() >= THOUSANDTHS {
                factors[i] /= 1000.0;
                thousandths = Some(found);
            }
        }
        if let Some(found) = thousandths {
            let message = format!(
                "{}{} counts thousandths, as FANUC does",
                found.letter,
                Decimal::of(found.value)
            );
            let at = block.origin_at(found.column);
            self.report.push(Diagnostic::info("scale-in-thousandths", message).with_origin(at));
        }
        let usable = factors.abs().min_element() >= MIN_FACTOR;
        if !usable || factors.abs().max_element() > MAX_COORDINATE {
            let at = block.origin_at(word.column);
            self.error("bad-scale", "the scale (G51) is no usable factor", at, "it has no effect");
            return None;
        }
        Some(factors)
    }
}

/// Whether the frames map points otherwise.
fn differs(a: &Frame, b: &Frame) -> bool {
    a.mirror != b.mirror || a.factors != b.factors || a.rotation != b.rotation
}
