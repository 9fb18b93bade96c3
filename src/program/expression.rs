//! Expressions: numbers, parameters, operators and functions, evaluated as they are read.

use super::dialect::Dialect;
use super::functions::{FUNCTIONS, Function, Impossible, OPERATORS, Operator};
use super::lexer::LineReader;
use super::number::NumberError;
use super::parameters::{FAILED, LAST, LAST_OF_HAAS, LAST_OF_NGC, Target};

/// Deepest nesting of brackets, functions and signs.
const DEEPEST: u32 = 100;

/// How many assignments of the same block are looked through for a value, the last ones.
const MOST_SETTINGS: usize = 100;

/// How far an index of RS274/NGC may be from the whole number that it means.
const NEARLY_WHOLE: f64 = 1e-4;

/// Why there is no value, and where in the line.
#[derive(Debug)]
pub(super) struct Fault {
    pub(super) code: &'static str,
    pub(super) message: &'static str,
    /// The place [bytes].
    pub(super) at: usize,
}

pub(super) type Value = Result<f64, Fault>;

pub(super) fn fault<T>((code, message): Impossible, at: usize) -> Result<T, Fault> {
    Err(Fault { code, message, at })
}

const NOT_FINITE: Impossible = ("no-number", "the result is no number");
pub(super) const NO_NUMBER: Impossible = ("bad-expression", "a number is missing");
pub(super) const NO_BRACKET: Impossible = ("bad-expression", "a closing bracket is missing");
const NO_VALUE: Impossible = ("unset-parameter", "its assignment failed, so it has no value");
const NO_PARAMETER: Impossible = ("bad-parameter", "there is no such parameter");

impl LineReader<'_> {
    /// A value as words and assignments have it: a number, a parameter, a function, or an
    /// expression in brackets.
    pub(super) fn value(&mut self) -> Value {
        let Some(c) = self.cursor.peek() else { return fault(NO_NUMBER, self.cursor.at()) };
        let at = self.cursor.at();
        if self.depth == DEEPEST {
            return fault(("bad-expression", "it is nested too deep"), at);
        }
        self.depth += 1;
        let value = match c {
            b'-' | b'+' => {
                self.cursor.skip();
                self.value().map(|value| if c == b'-' { -value } else { value })
            }
            b'[' => self.bracketed(),
            b'(' if self.parentheses() => self.bracketed(),
            b'#' => {
                self.cursor.skip();
                self.target().and_then(|target| self.parameter(&target, at))
            }
            b'0'..=b'9' | b'.' => match self.cursor.number(false) {
                Ok(value) if self.parentheses() && self.cursor.eat_all("EX") => {
                    match self.cursor.number(true) {
                        Ok(power) if power.abs() <= 300.0 =>
                        {
                            #[expect(clippy::cast_possible_truncation, reason = "checked")]
                            Ok(value * 10.0_f64.powi(power as i32))
                        }
                        _ => fault(("garbled-number", "it is no number"), at),
                    }
                }
                Ok(value) => Ok(value),
                Err(NumberError::TooLarge) => fault(("number-too-large", "it is beyond 1e9"), at),
                Err(_) => fault(("garbled-number", "it is no number"), at),
            },
            b'N' if self.parentheses() && self.cursor.eat_all("NOT") => {
                self.value().map(|value| f64::from(u8::from(value == 0.0)))
            }
            _ => match self.function_name() {
                Some(function) => self.function(function, at),
                None if self.parentheses() => {
                    self.variable().and_then(|target| self.parameter(&target, at))
                }
                None => fault(NO_NUMBER, at),
            },
        };
        self.depth -= 1;
        value
    }

    /// Whether parentheses group instead of opening a comment.
    pub(super) fn parentheses(&self) -> bool {
        self.dialect == Dialect::Sinumerik
    }

    /// The name of a function, if it and a bracket come next.
    pub(super) fn function_name(&mut self) -> Option<Function> {
        let from = self.cursor.at();
        for (name, function) in FUNCTIONS {
            if self.cursor.eat_all(name) {
                let opens = match self.cursor.peek() {
                    Some(b'[') => true,
                    Some(b'(') => self.parentheses(),
                    _ => false,
                };
                if opens {
                    return Some(function);
                }
                self.cursor.set(from);
            }
        }
        None
    }

    /// An expression in brackets.
    fn bracketed(&mut self) -> Value {
        let value = self.opened()?;
        self.close()?;
        Ok(value)
    }

    /// An expression up to its closing bracket or to a comma.
    fn opened(&mut self) -> Value {
        self.cursor.skip();
        self.expression(1)
    }

    fn close(&mut self) -> Result<(), Fault> {
        if self.cursor.eat(b']') || self.parentheses() && self.cursor.eat(b')') {
            return Ok(());
        }
        fault(NO_BRACKET, self.cursor.at())
    }

    /// Values and operators that bind at least as tightly as `least`, those of one rank from left
    /// to right. What is no number may be compared on the way, but does not come out.
    pub(super) fn expression(&mut self, least: u8) -> Value {
        let from = self.cursor.at();
        let mut left = self.value()?;
        loop {
            self.cursor.peek();
            let at = self.cursor.at();
            let Some(operator) = self.operator() else { break };
            let rank = operator.rank(self.dialect);
            if rank < least {
                self.cursor.set(at);
                break;
            }
            // Not deeper than there are ranks.
            let right = self.expression(rank + 1)?;
            match operator.apply(left, right, self.dialect) {
                Ok(value) => left = value,
                Err(impossible) => return fault(impossible, at),
            }
        }
        if least == 1 && !left.is_finite() && self.dialect != Dialect::Fanuc {
            return fault(NOT_FINITE, from);
        }
        Ok(left)
    }

    fn operator(&mut self) -> Option<Operator> {
        // Most values are followed by a bracket, and few letters begin an operator.
        let first = self.cursor.peek()?;
        if matches!(first, b'<' | b'=' | b'>') && self.dialect != Dialect::Sinumerik {
            return None;
        }
        let begins = |(text, _): &&(&str, Operator)| text.as_bytes().first() == Some(&first);
        let mut candidates = OPERATORS.iter().filter(begins);
        candidates.find(|(text, _)| self.cursor.eat_all(text)).map(|(_, operator)| *operator)
    }

    fn function(&mut self, function: Function, at: usize) -> Value {
        if function == Function::Exists {
            return self.exists(at);
        }
        let argument = self.opened()?;
        let second = if self.cursor.eat(b',') { Some(self.expression(1)?) } else { None };
        self.close()?;
        let second = match second {
            None if function == Function::ArcTangent && self.cursor.eat(b'/') => {
                if self.cursor.peek() != Some(b'[') {
                    return fault(
                        ("bad-expression", "ATAN[ ] / needs a bracket"),
                        self.cursor.at(),
                    );
                }
                Some(self.bracketed()?)
            }
            second => second,
        };
        let needs_two = function == Function::ArcTangent && self.dialect == Dialect::LinuxCnc;
        let result = match second {
            Some(second) if matches!(function, Function::ArcTangent | Function::Power) => {
                function.apply_to_two(argument, second, self.dialect)
            }
            None if !needs_two => function.apply(argument, self.dialect),
            _ => Err(("bad-expression", "the function has other arguments")),
        };
        result.or_else(|impossible| fault(impossible, at))
    }

    /// `EXISTS[#<name>]`; those with numbers are always there.
    fn exists(&mut self, at: usize) -> Value {
        self.cursor.skip();
        if !self.cursor.eat(b'#') {
            return fault(("bad-expression", "EXISTS asks for a parameter"), at);
        }
        let known = match self.target()? {
            Target::Name(name) => self.named(&name).is_some(),
            Target::Number(number) => (1..=LAST_OF_NGC).contains(&number),
            Target::Whole(_) => false,
        };
        self.close()?;
        Ok(f64::from(u8::from(known)))
    }

    /// What stands after `#`.
    pub(super) fn target(&mut self) -> Result<Target, Fault> {
        self.cursor.peek();
        let at = self.cursor.at();
        let index = match self.cursor.peek() {
            Some(b'<') => {
                return match self.cursor.name() {
                    Some(name) => Ok(Target::Name(name)),
                    None => fault(("bad-parameter", "the name of the parameter has no end"), at),
                };
            }
            Some(b'0'..=b'9' | b'#' | b'[') => self.value()?,
            _ => return fault(("bad-parameter", "# has no number"), at),
        };
        let whole = index.round();
        let fanuc = self.dialect == Dialect::Fanuc;
        let strict = self.interpreter.rules.is_strict;
        let [first, last] = match (strict, fanuc) {
            (true, _) => [1, LAST_OF_NGC],
            (_, true) => [0, LAST_OF_HAAS],
            _ => [0, LAST],
        };
        if !(f64::from(first)..=f64::from(last)).contains(&whole)
            || !fanuc && (index - whole).abs() > NEARLY_WHOLE
        {
            return fault(NO_PARAMETER, at);
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
        Ok(Target::Number(whole as u32))
    }

    /// The value of a parameter with a name, if there is one.
    fn named(&self, name: &str) -> Option<f64> {
        // An element that was never set is 0, as its field is.
        let field = || name.split_once('[').and_then(|(field, _)| self.parameters.name(field));
        self.parameters.name(name).or_else(field).or_else(|| self.interpreter.system_name(name))
    }

    /// The value of a parameter.
    pub(super) fn parameter(&mut self, target: &Target, at: usize) -> Value {
        let unknown = ("unknown-parameter", "only the machine knows this parameter");
        // A line without end is not searched without end.
        let mut latest = self.settings.iter().rev().take(MOST_SETTINGS);
        let latest = if self.parentheses() { latest.find(|s| s.target == *target) } else { None };
        if let Some(setting) = latest {
            let value = setting.value;
            let hint = "it counts with its new value; use a block of its own to be sure";
            self.warn("order-of-assignments", at, "its value is set in the same block", hint);
            return if value == FAILED { fault(NO_VALUE, at) } else { Ok(value) };
        }
        let value = match target {
            Target::Name(name) | Target::Whole(name) => match self.named(name) {
                Some(value) => value,
                None if name.starts_with('_') => return fault(unknown, at),
                None => return fault(("unset-parameter", "the parameter was never set"), at),
            },
            Target::Number(number)
                if is_system(*number, self.dialect) && self.parameters.number(*number).is_nan() =>
            {
                match self.interpreter.system_number(*number, self.dialect) {
                    Some(value) => value,
                    None => return fault(unknown, at),
                }
            }
            Target::Number(number) => self.parameters.number(*number),
        };
        if value == FAILED {
            return fault(NO_VALUE, at);
        }
        if value.is_nan() && self.dialect != Dialect::Fanuc {
            self.warn(
                "unset-parameter",
                at,
                "the parameter was never set",
                "it counts as 0, as on a control that was just switched on",
            );
            return Ok(0.0);
        }
        Ok(value)
    }
}

/// Whether a parameter tells or sets the state of the control.
pub(super) fn is_system(number: u32, dialect: Dialect) -> bool {
    match dialect {
        Dialect::Auto | Dialect::LinuxCnc => (5_001..10_000).contains(&number),
        Dialect::Fanuc => (1_000..10_000).contains(&number),
        Dialect::Sinumerik => false,
    }
}
