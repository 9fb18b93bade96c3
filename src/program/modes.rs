//! The G words of a block: the modes that they set, and what else they ask for.

use glam::DVec3;

use super::auxiliary::{Auxiliary, append_word, rank, take_as_text, word as text_of};
use super::block::{Block, Word};
use super::coordinates::AXES;
use super::dialect::Dialect;
use super::g_words::{Act, Compensation, GWord, Motion, g_word};
use super::interpret::Interpreter;
use super::number::whole;
use super::words::{Words, tenths};
use crate::contour::Plane;
use crate::diagnostic::Diagnostic;
use crate::geometry::Decimal;

/// What the G words of a block ask for besides modes.
#[derive(Debug, Default)]
pub(super) struct Demands<'a> {
    /// A motion word was there.
    pub(super) motion: Option<Motion>,
    /// How the axis words of this block alone move the tool.
    pub(super) once: Option<Motion>,
    /// A word of the G05 family by ten times its number, and where it is.
    pub(super) family: Option<(u32, u32)>,
    pub(super) dwell: Option<&'a Word>,
    pub(super) compensation: Option<(Compensation, &'a Word)>,
    /// Words that act before the move are there.
    pub(super) acts: bool,
    /// The words leave the height under another number.
    pub(super) length: bool,
    /// The block cannot be turned into moves.
    pub(super) no_move: bool,
    groups: u32,
}

/// Stands among the groups of a block for a word that the axis words belong to, as they do to those of
/// motion.
const TAKES_AXES: u32 = 1 << 31;

/// And for one that was not understood.
const UNKNOWN: u32 = 1 << 30;

impl Demands<'_> {
    /// Whether a G word was not understood.
    pub(super) fn is_unknown(&self) -> bool {
        self.groups & UNKNOWN != 0
    }

    /// What becomes of words that are not understood.
    pub(super) fn hint(&self) -> &'static str {
        if self.no_move {
            "it has no effect, and its block moves nothing"
        } else {
            "it has no effect"
        }
    }
}

impl Interpreter {
    /// Sets the modes, and collects what else the G words ask for.
    pub(super) fn g_words<'a>(
        &mut self,
        block: &'a Block,
        words: &mut Words<'a>,
        auxiliary: &mut Auxiliary,
    ) -> Demands<'a> {
        let mut demands = Demands::default();
        for (index, word) in block.words.iter().enumerate() {
            if word.letter != 'G' {
                continue;
            }
            if self.corner_word(block, word, words, &mut demands) {
                words.use_up(index);
                continue;
            }
            let meaning = tenths(word)
                .and_then(|number| Some((number, g_word(number, self.rules.is_strict)?)));
            let Some(meaning) = meaning else {
                demands.groups |= UNKNOWN;
                continue;
            };
            words.use_up(index);
            self.g_word(block, word, meaning, words, auxiliary, &mut demands);
        }
        if demands.is_unknown() && self.rules.is_strict {
            self.not_understood(block, words, "");
        }
        // Its axis words are not those of the motion that is in effect: a cycle's depth is no move there.
        let known = demands.once.or(demands.motion).is_some() || demands.family.is_some();
        demands.no_move |= demands.is_unknown() && !known && demands.groups & TAKES_AXES == 0;
        let both = demands.groups & TAKES_AXES != 0 && demands.motion.is_some();
        if both && self.rules.is_strict {
            self.refuse("two words of the block use its axes", block.start());
        }
        demands
    }

    /// G98 and G99, which are for cycles; a lathe of FANUC's counts its feeds by them.
    fn retract(&mut self, block: &Block, word: &Word, to_r: bool) {
        self.modal.retract_to_r = to_r;
        let cycle = |word: &Word| {
            word.letter == 'G' && matches!(whole(word.value), Some(73..=79 | 81..=89))
        };
        let lathe = to_r && self.modal.plane == Plane::Zx && self.dialect == Dialect::Fanuc;
        if lathe && !block.words.iter().any(cycle) {
            self.report.warning(
                "doubtful-feed",
                "G99 in G18: a lathe takes F by the revolution, here it stays by the minute",
                block.origin_at(word.column),
                "write G95 for feeds by the revolution",
            );
        }
    }

    fn g_word<'a>(
        &mut self,
        block: &Block,
        word: &'a Word,
        (number, meaning): (u32, GWord),
        words: &mut Words<'a>,
        auxiliary: &mut Auxiliary,
        demands: &mut Demands<'a>,
    ) {
        let strict = self.rules.is_strict;
        if let Some(group) = meaning.group(strict) {
            let same = |other: &&Word| other.letter == 'G' && other.value == word.value;
            let repeats = !strict && block.words.iter().filter(same).count() > 1;
            if demands.groups >> group & 1 == 1 && !repeats {
                self.error(
                    "conflicting-words",
                    format!(
                        "G{} excludes a G word before it in the block",
                        Decimal::of(word.value)
                    ),
                    block.origin_at(word.column),
                    "the later one counts; put them into blocks of their own",
                );
            }
            demands.groups |= 1 << group;
        }
        if let GWord::Length(_) | GWord::RetractToR(_) | GWord::PassedOn(_) = meaning
            && !block.words.iter().any(|word| word.letter == 'G' && word.value == 40.0)
        {
            // G40 in the same block comes first.
            self.not_while_on(block, word);
        }
        let modal = &mut self.modal;
        match meaning {
            GWord::Motion(motion) => {
                demands.motion = Some(motion);
                demands.family = None;
                if !matches!(motion, Motion::Cycle(_)) {
                    modal.cycle.end();
                } else if !matches!(modal.motion, Some(Motion::Cycle(_))) {
                    modal.before_cycle = modal.motion;
                }
                modal.motion = Some(motion);
            }
            GWord::Once(motion) => {
                demands.once = Some(motion);
                if motion == Motion::Rapid {
                    let message = "G60 is left out: the tool comes from any side";
                    let at = block.origin_at(word.column);
                    self.report.push(Diagnostic::info("noted", message).with_origin(at));
                }
            }
            GWord::PolarInterpolation(on) => self.polar_interpolation(block, word, on),
            GWord::SplineFamily => demands.family = Some((number, word.column)),
            GWord::EndOfCycle => {
                // Another motion word in the block is what counts. FANUC's cycles leave the one before
                // them in effect.
                let cycle = matches!(modal.motion, Some(Motion::Cycle(_)));
                modal.motion = match demands.motion {
                    None if self.dialect == Dialect::Fanuc && cycle => modal.before_cycle,
                    None if self.dialect == Dialect::Fanuc => modal.motion,
                    stated => stated,
                };
                modal.cycle.end();
            }
            GWord::Dwell => demands.dwell = Some(word),
            GWord::Plane(plane) => self.plane(block, word, plane),
            GWord::Inches(inches) => modal.set_inches(inches, self.rules.is_strict),
            GWord::Relative(relative) => modal.relative = relative,
            GWord::AbsoluteCenter(absolute) => modal.absolute_center = absolute,
            GWord::Diameter(diameter) => modal.diameter = diameter,
            GWord::RetractToR(to_r) => self.retract(block, word, to_r),
            GWord::FeedMode(mode) => modal.feed.set_mode(mode, strict),
            GWord::SurfaceSpeed(on) => {
                // With D the same word sets another limit.
                if modal.feed.set_surface_speed(on) || on {
                    let mut text = text_of('G', word.value);
                    if on {
                        take_as_text(words, "D", &mut text);
                    }
                    auxiliary.text(rank::SPEED, text);
                }
            }
            GWord::Compensation(compensation) => demands.compensation = Some((compensation, word)),
            GWord::Length(on) => {
                // G49 in the first lines of a program ends what was never begun.
                if on || modal.length || modal.systems.assumed.tool != DVec3::ZERO {
                    let text = self.tool_length(word, number, words);
                    demands.length = true;
                    auxiliary.text(rank::LENGTH, text);
                }
            }
            GWord::Act(act) => {
                demands.acts = true;
                // Motion words stand before or behind it.
                if matches!(act, Act::SetData | Act::Home | Act::Origin | Act::Local) {
                    demands.groups |= TAKES_AXES;
                }
            }
            GWord::Harmless => {}
            GWord::Noted(letters) => {
                words.take_all(letters);
                let text = text_of('G', word.value);
                self.note(block, word.column, &text);
            }
            GWord::PassedOn(letters) => {
                let text = self.lengths(word, letters, words);
                auxiliary.text(rank::CONTROL, text);
            }
            GWord::NotSupported(what) => {
                self.not_supported(block, word.column, what);
                demands.no_move = true;
            }
        }
    }

    /// G43 and its like, and G49.
    fn tool_length(&mut self, word: &Word, number: u32, words: &mut Words) -> String {
        let mut text = text_of('G', word.value);
        let systems = &self.modal.systems;
        let machine = systems.assumed.machine(systems.active(), self.modal.position);
        if number == 431 {
            for (i, letter) in AXES.into_iter().enumerate() {
                if let Some(axis) = words.take(letter) {
                    let length = self.modal.length_of(i, axis.value);
                    self.modal.systems.assumed.tool[i] = length;
                    append_word(&mut text, letter, length);
                }
            }
        } else {
            self.modal.systems.assumed.tool = DVec3::ZERO;
            self.modal.length = true;
        }
        if number != 490 || !self.rules.is_strict {
            take_as_text(words, "H", &mut text);
        }
        if self.rules.is_strict {
            let systems = &self.modal.systems;
            self.modal.position = systems.assumed.place(systems.active(), machine);
        }
        text
    }

    /// Tells that a word is left out, and nothing lost.
    pub(super) fn note(&mut self, block: &Block, column: u32, what: &str) {
        let message = format!("{what} is left out; it does not change the path");
        let at = block.origin_at(column);
        self.report.push(Diagnostic::info("noted", message).with_origin(at));
    }

    /// A G word with lengths.
    fn lengths(&self, word: &Word, letters: &str, words: &mut Words) -> String {
        let mut text = text_of('G', word.value);
        for letter in letters.chars() {
            if let Some(length) = words.take(letter) {
                append_word(&mut text, letter, length.value * self.modal.unit());
            }
        }
        text
    }

    /// G12.1, whose moves are not made, and G13.1.
    fn polar_interpolation(&mut self, block: &Block, word: &Word, on: bool) {
        if on {
            self.not_supported(block, word.column, "polar coordinate interpolation (G12.1)");
        } else if self.modal.polar_interpolation {
            self.forget([true, true, false]);
        }
        self.modal.polar_interpolation = on;
    }

    /// Some controls stop at this word while compensation is on; others do not mind.
    pub(super) fn not_while_on(&mut self, block: &Block, word: &Word) {
        if self.rules.is_strict && self.course.switched().is_some() {
            let text = text_of(word.letter, word.value);
            let message = format!("{text} may not be while compensation is on");
            self.refuse(&message, block.origin_at(word.column));
        }
    }

    fn plane(&mut self, block: &Block, word: &Word, plane: Plane) {
        if self.modal.plane == plane {
            return;
        }
        self.finish_spline();
        self.leave_contour(block, word.column, "the plane", Some(plane));
        self.modal.plane = plane;
        self.modal.cycle.end();
    }

    /// Ends the contour where something changes that cannot while compensation is on; it goes on
    /// as another one.
    pub(super) fn leave_contour(
        &mut self,
        block: &Block,
        column: u32,
        what: &str,
        plane: Option<Plane>,
    ) {
        self.finish_spline();
        if self.rules.is_strict && self.course.switched().is_some() {
            let message = format!("{what} may not change while compensation is on");
            self.refuse(&message, block.origin_at(column));
            return;
        }
        if self.course.is_free() {
            return;
        }
        let plane_after = plane.unwrap_or(self.modal.plane);
        let (at, _) = plane_after.split(self.modal.position);
        if self.course.switched().is_none() {
            // The lead-out would have led from beside the contour back to where the program is.
            if plane.is_none() {
                let [first, second, _] = self.modal.plane.axes();
                self.owed[first] = true;
                self.owed[second] = true;
            }
            self.course.break_off(at, &mut self.report);
            return;
        }
        self.error(
            "changed-while-on",
            format!("{what} changes while compensation is on"),
            block.origin_at(column),
            "the contour ends here; switch compensation off with G40 before",
        );
        self.course.break_off(at, &mut self.report);
    }
}
