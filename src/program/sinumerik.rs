//! Names in SINUMERIK's programs: words of two letters and more, jumps to labels, dimensions by AC and
//! IC, tools with names, and the programmable frames.
//!
//! Siemens, SINUMERIK 840D sl / 828D Fundamentals, Programming Manual 10/2015: labels and GOTO in
//! section 2.15 of Job Planning; AC and IC in 7.2, frames (TRANS, ROT, SCALE, MIRROR) in 12 of
//! Fundamentals. Cycles, variables with names and loops are not read.

use glam::{DVec2, DVec3};

use super::block::Block;
use super::coordinates::AXES;
use super::dialect::Dialect;
use super::flow::{Destination, Search};
use super::frame::{Frame, radians};
use super::interpret::Interpreter;
use super::lexer::{LineReader, quote};
use super::spline_words::{ADDRESSES, NAMES};
use super::words::Words;

/// What moves no tool by itself: how the control follows the path, what it shows, what it waits for.
const WITHOUT_EFFECT: &str = "FFWON FFWOF SOFT BRISK DRIVE COMPON COMPCURV COMPCAD COMPSURF COMPOF \
    CFC CFTCP CFIN FGROUP UPATH SPATH STOPRE DIAMOF WALIMON WALIMOF WORKPIECE CYCLE832 SBLON SBLOF \
    DISPLOF ADIS ADISPOS LIMS SPOS SETMS TRAFOOF ORIWKS ORIMKS DYNNORM DYNPOS DYNROUGH DYNSEMIFIN \
    DYNFINISH CUT2D CUT2DF CDOF RET";

/// What the numbers of instructions that add to a frame are larger by than those of others.
const ADDS: f64 = 4.0;

impl LineReader<'_> {
    /// A name of two letters and more; false where there is none.
    pub(super) fn name_word(&mut self) -> bool {
        let from = self.cursor.at();
        let rest = self.cursor.rest().as_bytes();
        if !rest.get(1).is_some_and(|c| c.is_ascii_alphabetic() || *c == b'_') {
            return false;
        }
        if self.cursor.eat_all("CR=") {
            // The radius of an arc, with the sign that tells which.
            let value = self.expression(1);
            self.accept_value(b'R', value, from);
            return true;
        }
        if self.cursor.eat_all("MSG(") {
            let text = self.cursor.take_while(&|c: char| c != ')');
            let shown: String = text.chars().filter(|c| !c.is_control() && *c != '"').collect();
            self.cursor.eat(b')');
            self.block.comments.push(format!("(MSG,{shown})"));
            return true;
        }
        let name = self.cursor.identifier();
        for (known, letter, value) in NAMES {
            if name.eq_ignore_ascii_case(known) {
                self.push(letter, value, from);
                return true;
            }
        }
        for (known, letter) in ADDRESSES {
            if name.eq_ignore_ascii_case(known) && self.cursor.eat(b'=') {
                let value = self.expression(1);
                self.accept_value(letter, value, from);
                return true;
            }
        }
        for (known, search) in
            [("GOTOF", Search::Down), ("GOTOB", Search::Up), ("GOTO", Search::DownThenUp)]
        {
            if name.eq_ignore_ascii_case(known) {
                self.cursor.peek();
                let column = self.cursor.column(from);
                self.jump =
                    Some((Destination::Label(self.cursor.identifier().to_owned(), search), column));
                return true;
            }
        }
        if name.eq_ignore_ascii_case("IF") {
            // What follows counts only where it is true.
            if !self.holds() {
                self.cursor.skip_all();
            }
            return true;
        }
        // A label.
        if self.block.words.is_empty() && self.cursor.eat(b':') {
            return true;
        }
        // Without arguments it swivels back.
        let swivels_back = name.eq_ignore_ascii_case("CYCLE800") && self.cursor.eat_all("()");
        if swivels_back || WITHOUT_EFFECT.split(' ').any(|known| name.eq_ignore_ascii_case(known)) {
            match self.cursor.peek() {
                Some(b'(') => {
                    self.cursor.take_while(&|c: char| c != ')');
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
        self.unknown_name(name, from);
        true
    }

    /// What stands behind `=`: a tool by its name, AC( ) and IC( ), or any expression.
    pub(super) fn assigned(&mut self, letter: u8, from: usize) {
        if self.dialect == Dialect::Sinumerik {
            if letter == b'T' && self.cursor.eat(b'"') {
                let tool = quote(self.cursor.take_while(&|c: char| c != '"'));
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
