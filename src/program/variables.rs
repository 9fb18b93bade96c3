//! SINUMERIK's variables: R parameters, those that DEF and PROC give a name, fields of them.
//!
//! Siemens, SINUMERIK 840D sl / 828D, Programming Manual Job Planning 10/2015: user variables in
//! section 1.1, arguments of subprograms in 1.24. That assignments of one block act from left to right
//! is this package's reading, and told where it matters.

use super::expression::{Fault, NO_BRACKET, NO_NUMBER, fault};
use super::lexer::LineReader;
use super::number::whole;
use super::parameters::{Setting, Target, UNSET};
use super::spline_words::place_in;

/// The name under which a variable is kept; those of other dialects never begin with a point.
fn key(name: &str) -> String {
    let mut key = String::from(".");
    key.push_str(name);
    key.make_ascii_lowercase();
    key
}

impl LineReader<'_> {
    /// A variable: R5, R[…], one with a name, or an element of a field.
    pub(super) fn variable(&mut self) -> Result<Target, Fault> {
        let at = self.cursor.at();
        if matches!(self.cursor.rest().as_bytes(), [b'R' | b'r', b'0'..=b'9' | b'[', ..]) {
            self.cursor.skip();
            if self.cursor.peek() == Some(b'[') {
                return self.target();
            }
            if let Some(number) = self.cursor.digits() {
                return Ok(Target::Number(number));
            }
        }
        if self.cursor.peek() == Some(b'$') {
            return fault(("unknown-parameter", "only the machine knows this parameter"), at);
        }
        let name = self.cursor.identifier();
        if !name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
            return fault(NO_NUMBER, at);
        }
        let mut name = key(name);
        if self.cursor.eat(b'[') {
            loop {
                name.push('[');
                let index = self.expression(1)?.round();
                name.push_str(&whole(index).unwrap_or(u32::MAX).to_string());
                if !self.cursor.eat(b',') {
                    break;
                }
            }
            if !self.cursor.eat(b']') {
                return fault(NO_BRACKET, self.cursor.at());
            }
        }
        Ok(Target::Name(name))
    }

    fn keep(&mut self, name: String, value: f64, from: usize) {
        let column = self.cursor.column(from);
        self.settings.push(Setting { target: Target::Name(name), value, column });
    }

    /// `NAME=…`; false where there is no such variable, and nothing was read.
    pub(super) fn assigns_variable(&mut self, from: usize) -> bool {
        self.cursor.set(from);
        if let Ok(target) = self.variable() {
            let is_known = match &target {
                Target::Number(_) => true,
                Target::Name(name) | Target::Whole(name) => {
                    let base = name.split('[').next().unwrap_or_default();
                    self.parameters.name(base).is_some()
                }
            };
            if is_known && self.cursor.eat(b'=') {
                self.set(target, from);
                return true;
            }
        }
        self.cursor.set(from);
        false
    }

    /// DEF and the kind behind it: the variables that follow.
    pub(super) fn define(&mut self) {
        loop {
            self.cursor.peek();
            let from = self.cursor.at();
            let kind = self.cursor.identifier();
            if place_in("NCK CHAN", kind).is_some() {
                continue;
            }
            let Some(is_whole) = is_whole(kind) else { return self.unknown_name(kind, from) };
            loop {
                self.declare(is_whole, 0.0);
                if !self.cursor.eat(b',') {
                    return;
                }
            }
        }
    }

    /// The name of a new variable, and its value if it says so.
    fn declare(&mut self, is_whole: bool, value: f64) {
        self.cursor.peek();
        let from = self.cursor.at();
        let name = key(self.cursor.identifier());
        if !name.as_bytes().get(2).is_some_and(|c| c.is_ascii_alphabetic() || *c == b'_') {
            let hint = "with = it is the variable; controls ask for two letters";
            self.warn("short-name", from, "the name of the variable is that of an address", hint);
        }
        if self.cursor.eat(b'[') {
            self.cursor.until(']');
            self.cursor.eat(b']');
        }
        self.keep(name.clone(), value, from);
        if self.cursor.eat(b'=') {
            self.set(Target::Name(name.clone()), from);
        }
        if is_whole {
            let column = self.cursor.column(from);
            self.settings.push(Setting { target: Target::Whole(name), value: 0.0, column });
        }
    }

    /// What stands behind PROC: the name, and the variables that get the arguments of the call.
    pub(super) fn procedure(&mut self) {
        self.cursor.peek();
        self.cursor.identifier();
        if self.cursor.eat(b'(') {
            let mut number = 0;
            while !matches!(self.cursor.peek(), None | Some(b')' | b';')) {
                let from = self.cursor.at();
                let kind = self.cursor.identifier();
                let Some(is_whole) = is_whole(kind) else { return self.unknown_name(kind, from) };
                number += 1;
                let value = self.parameters.name(&argument(number)).unwrap_or(UNSET);
                self.declare(is_whole, value);
                self.cursor.eat(b',');
            }
            self.cursor.eat(b')');
        }
        // SAVE, DISPLOF and their like.
        self.cursor.until(';');
    }

    /// The arguments in brackets, with [`UNSET`] for those that are left out.
    pub(super) fn call_arguments(&mut self) -> Result<Vec<f64>, Fault> {
        let mut values = Vec::new();
        if !self.cursor.eat(b'(') {
            return Ok(values);
        }
        while self.cursor.peek() != Some(b')') {
            let left_out = self.cursor.peek() == Some(b',');
            values.push(if left_out { UNSET } else { self.expression(1)? });
            if !self.cursor.eat(b',') {
                break;
            }
        }
        if self.cursor.eat(b')') { Ok(values) } else { fault(NO_BRACKET, self.cursor.at()) }
    }
}

/// Whether variables of a kind are whole numbers; none where they are no numbers.
fn is_whole(kind: &str) -> Option<bool> {
    Some(place_in("REAL INT BOOL", kind)? > 0)
}

/// The name under which an argument of a call is kept.
pub(super) fn argument(number: usize) -> String {
    key(&number.to_string())
}
