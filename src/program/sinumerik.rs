//! Names in SINUMERIK's programs: words of two letters and more, jumps to labels, dimensions by AC and
//! IC, tools with names, and the programmable frames.
//!
//! Siemens, SINUMERIK 840D sl / 828D Fundamentals, Programming Manual 10/2015: labels and GOTO in
//! section 2.15 of Job Planning; AC and IC in 7.2, frames (TRANS, ROT, SCALE, MIRROR) in 12 of
//! Fundamentals. Loops and subprograms are in `structures`, what has a name in `variables`, cycles
//! in `drilling`.

use glam::{DVec2, DVec3};

use super::axes::Axes;
use super::block::{Block, Word};
use super::coordinates::AXES;
use super::dialect::Dialect;
use super::expression::Fault;
use super::flow::Destination;
use super::frame::{Frame, polar_point, radians};
use super::interpret::Interpreter;
use super::lexer::{LineReader, quote};
use super::number::whole;
use super::parameters::{LAST, Target};
use super::spline_words::{ADDRESS_LETTERS, ADDRESSES, LETTERS, NAMES, VALUES, place_in};
use super::words::Words;

/// What moves no tool by itself: how the control follows the path, what it shows, what it waits for.
const WITHOUT_EFFECT: &str = "FFWON FFWOF SOFT BRISK DRIVE COMPON COMPCURV COMPCAD COMPSURF COMPOF \
    CFC CFTCP CFIN FGROUP UPATH SPATH STOPRE FNORM DIAMOF WALIMON WALIMOF WORKPIECE CYCLE832 SBLON SBLOF \
    DISPLOF ADIS ADISPOS LIMS SPOS SETMS TRAFOOF ORIWKS ORIMKS DYNNORM DYNPOS DYNROUGH DYNSEMIFIN \
    DYNFINISH CUT2D CUT2DF CDOF";

/// What the numbers of instructions that add to a frame are larger by than those of others.
const ADDS: f64 = 4.0;

impl LineReader<'_> {
    /// A name of two letters and more; false where there is none.
    pub(super) fn name_word(&mut self) -> bool {
        let from = self.cursor.at();
        let rest = self.cursor.rest().as_bytes();
        let is_name = match *rest {
            [b'$' | b'_', ..] | [b'R' | b'r', b'[', ..] => true,
            [b'L' | b'l', c, ..] => c.is_ascii_digit(),
            _ => false,
        };
        if !is_name && !rest.get(1).is_some_and(|c| c.is_ascii_alphabetic() || *c == b'_') {
            // A variable with the name of an address hides it.
            return !self.parameters.is_nameless() && self.assigns_variable(from);
        }
        if self.cursor.eat(b'$') {
            let hint = "the rest of the block is left out; set it on the machine";
            self.cursor.skip_all();
            self.warn("left-out", from, "only the machine has such variables", hint);
            return true;
        }
        if self.cursor.eat_all("MSG(") {
            let text = self.cursor.until(')');
            let shown: String = text.chars().filter(|c| !c.is_control() && *c != '"').collect();
            self.cursor.eat(b')');
            self.block.comments.push(format!("(MSG,{shown})"));
            return true;
        }
        let name = self.cursor.identifier();
        if let Some(place) = place_in(NAMES, name)
            && let (Some(&letter), Some(&value)) = (LETTERS.get(place), VALUES.get(place))
        {
            self.push(char::from(letter), f64::from(value), from);
            return true;
        }
        if let Some(place) = place_in(ADDRESSES, name)
            && let Some(&letter) = ADDRESS_LETTERS.get(place)
            && self.cursor.eat(b'=')
        {
            self.assigned(letter, from);
            return true;
        }
        if self.flow_name(name, from) {
            return true;
        }
        if self.drilling_cycle(name, from) || self.assigns_variable(from) {
            return true;
        }
        self.cursor.set(from + name.len());
        // A label.
        if self.block.words.is_empty() && self.cursor.eat(b':') {
            return true;
        }
        // Without arguments it swivels back.
        let swivels_back = name.eq_ignore_ascii_case("CYCLE800") && self.cursor.eat_all("()");
        if swivels_back || place_in(WITHOUT_EFFECT, name).is_some() {
            match self.cursor.peek() {
                Some(b'(') => {
                    self.cursor.until(')');
                    self.cursor.eat(b')');
                }
                Some(b'=') => {
                    self.cursor.skip();
                    // What it is, does not matter.
                    let _ = self.expression(1);
                }
                _ => {}
            }
            let column = self.cursor.column(from);
            self.interpreter.note(self.block, column, name);
            return true;
        }
        let column = self.cursor.column(from);
        if self.block.words.is_empty()
            && matches!(self.cursor.peek(), None | Some(b'(' | b'P' | b';'))
        {
            let behind = from + name.len();
            self.jump = Some((Destination::Program([from, behind]), column));
            // Its arguments are read where it is called.
            self.cursor.skip_all();
        } else {
            self.unknown_name(name, from);
        }
        true
    }

    /// SINUMERIK's addresses with a number and `=`, of which R is a parameter.
    pub(super) fn address(&mut self, letter: u8, number: f64, from: usize) {
        self.cursor.skip();
        match whole(number) {
            Some(number) if letter == b'R' && number <= LAST => {
                self.set(Target::Number(number), from);
            }
            Some(1) if matches!(letter, b'I'..=b'K') => {
                // The point between of CIP.
                let value = self.expression(1);
                self.accept_value(letter - b'I' + b'x', value, from);
            }
            // Words of the first spindle; others move no tool of this program.
            Some(1) if matches!(letter, b'M' | b'S') => self.assigned(letter, from),
            Some(_) if matches!(letter, b'M' | b'S') => {
                // What it is, does not matter.
                let _ = self.expression(1);
                let column = self.cursor.column(from);
                self.interpreter.note(self.block, column, self.cursor.since(from));
            }
            _ => {
                let value = self.expression(1);
                let unknown = Fault { code: "unknown-name", message: "it is not known", at: from };
                let fault = value.as_ref().err().unwrap_or(&unknown);
                self.report_fault(fault, from, "it is left out");
            }
        }
    }

    /// Whether a word leads back from a subprogram: M17, and there M2 and M30 too.
    pub(super) fn returns(&self, word: &Word) -> bool {
        self.dialect == Dialect::Sinumerik
            && word.letter == 'M'
            && match word.value {
                17.0 => true,
                2.0 | 30.0 => self.parameters.level > 0,
                _ => false,
            }
    }

    /// What stands behind `=`: a tool by its name, AC( ) and IC( ), or any expression.
    pub(super) fn assigned(&mut self, letter: u8, from: usize) {
        if self.dialect == Dialect::Sinumerik {
            if letter == b'T' && self.cursor.eat(b'"') {
                let tool = quote(self.cursor.until('"'));
                self.cursor.eat(b'"');
                self.block.comments.push(format!("(tool {tool})"));
                let hint = "give its radius for the D word, or one for all tools";
                return self.warn("tool-name", from, "only the machine knows tools by name", hint);
            }
            for (kind, absolute) in [("AC(", true), ("IC(", false)] {
                if self.cursor.eat_all(kind) {
                    let value = self.expression(1);
                    self.cursor.eat(b')');
                    let offset = self.dimension(letter, absolute);
                    return self.accept_value(letter, value.map(|value| value + offset), from);
                }
            }
        }
        let value = self.expression(1);
        self.accept_value(letter, value, from);
    }

    /// What a coordinate is to be larger by to mean in the mode of the block what it says itself.
    fn dimension(&mut self, letter: u8, absolute: bool) -> f64 {
        let modal = &self.interpreter.modal;
        let (axis, is_absolute) = match letter {
            b'X'..=b'Z' => {
                let mut relative = modal.relative;
                for word in &self.block.words {
                    if word.letter == 'G' && (word.value == 90.0 || word.value == 91.0) {
                        relative = word.value == 91.0;
                    }
                }
                (letter - b'X', !relative)
            }
            b'I'..=b'K' => (letter - b'I', modal.absolute_center),
            // An angle and a radius about the pole, which are absolute.
            b'j' if !absolute => return modal.polar.angle.to_degrees(),
            b'q' if !absolute => return modal.polar.radius / modal.unit(),
            _ => return 0.0,
        };
        if absolute == is_absolute {
            return 0.0;
        }
        let from = modal.frame.unmap(modal.position)[usize::from(axis)] / modal.unit();
        if absolute { -from } else { from }
    }

    /// Reports a name that is none.
    pub(super) fn unknown_name(&mut self, name: &str, from: usize) {
        let message = format!("{} is not known", quote(name));
        self.error("unknown-name", message, from, "the rest of the block is left out");
        self.cursor.skip_all();
    }
}

impl Interpreter {
    /// G110, G111 and G112: the pole of AP and RP counts from where the program is, from the origin, or
    /// from the pole before.
    pub(super) fn pole(&mut self, number: u32, words: &mut Words) {
        let plane = self.modal.plane;
        let before = self.modal.polar.pole;
        let from = match number {
            1100 => plane.split(self.modal.frame.unmap(self.modal.position)).0,
            1110 => DVec2::ZERO,
            _ => before,
        };
        let mut way = DVec3::ZERO;
        for (i, letter) in AXES.into_iter().enumerate() {
            way[i] = words.take(letter).map_or(0.0, |word| self.modal.length_of(i, word.value));
        }
        let (radius, angle) = (words.take('q'), words.take('j'));
        let radius = radius.map_or(0.0, |word| word.value * self.modal.unit());
        let angle = angle.map_or(0.0, |word| radians(word.value));
        self.modal.polar.pole = from + plane.split(way).0 + polar_point(DVec2::ZERO, radius, angle);
    }

    /// AP and RP: an angle and a radius about the pole; the one that is left out stays.
    pub(super) fn about_pole<'a>(
        &mut self,
        words: &mut Words<'a>,
        axes: &mut Axes<'a>,
        to: &mut DVec3,
    ) {
        let (radius, angle) = (words.take('q'), words.take('j'));
        let Some(word) = radius.or(angle) else { return };
        let (plane, unit) = (self.modal.plane, self.modal.unit());
        let [first, second, normal] = plane.axes();
        let polar = &mut self.modal.polar;
        polar.radius = radius.map_or(polar.radius, |word| word.value * unit);
        polar.angle = angle.map_or(polar.angle, |word| radians(word.value));
        *to = plane.place(polar_point(polar.pole, polar.radius, polar.angle), to[normal]);
        axes.words[first] = Some(word);
        axes.words[second] = Some(word);
    }

    /// TRANS, ROT, SCALE and MIRROR, which take the place of what there was, and ATRANS, AROT, ASCALE
    /// and AMIRROR, which act on the coordinates that there were.
    ///
    /// A frame mirrors, scales, turns and shifts, in this order. What comes to act before it can be
    /// carried behind it: a shift is as long as the frame makes it, and a turn goes the other way round
    /// where the frame mirrors.
    pub(super) fn programmable_frame(&mut self, block: &Block, words: &mut Words) {
        let Some(word) = words.take('n') else { return };
        self.finish_spline();
        let (plane, before) = (self.modal.plane, self.modal.frame.clone());
        let kind = word.value;
        let adds = kind >= ADDS;
        let given = AXES.map(|letter| words.take(letter));
        let mut values = DVec3::ZERO;
        for i in 0..3 {
            values[i] = given[i].map_or(0.0, |word| word.value);
        }
        let mut frame = if adds { before.clone() } else { Frame::new() };
        frame.polar = before.polar;
        match kind % ADDS {
            0.0 => frame.local = frame.map(values * self.modal.unit()),
            1.0 => {
                let [first, second, normal] = plane.axes();
                let angle = words.take('p').or(given[normal]);
                let fits = frame.factor(plane).is_some();
                if given[first].is_some() || given[second].is_some() || !fits {
                    let what = "a rotation out of the plane, or of unequal scales";
                    return self.not_supported(block, word.column, what);
                }
                let angle = radians(angle.map_or(0.0, |word| word.value));
                let turned = frame.rotation.map_or(0.0, |(.., angle)| angle);
                let angle = if frame.flips(plane) { -angle } else { angle };
                frame.rotation = Some((plane, DVec2::ZERO, turned + angle));
            }
            2.0 => {
                for (i, word) in given.into_iter().enumerate() {
                    frame.factors[i] *= word.map_or(1.0, |word| word.value);
                }
                if !self.is_usable_scale(block, word.column, frame.factors) {
                    return;
                }
            }
            _ => {
                for (mirror, _) in
                    frame.mirror.iter_mut().zip(given).filter(|(_, given)| given.is_some())
                {
                    *mirror = if mirror.is_some() { None } else { Some(0.0) };
                }
            }
        }
        self.modal.frame = frame;
        if self.course.switched().is_some() {
            self.leave_contour(block, word.column, "the coordinate system", None);
        }
    }
}
