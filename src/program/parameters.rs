//! The parameters of a running program: `#5`, `#<name>`, R5.

/// The highest number of a parameter.
pub(super) const LAST: u32 = 9_999;

/// The highest with FANUC's words, where Haas has more.
pub(super) const LAST_OF_HAAS: u32 = 10_999;

/// The highest in RS274/NGC, as `LinuxCNC` has it.
pub(super) const LAST_OF_NGC: u32 = 5_601;

/// Parameters that subprograms have of their own: #1 to #30 in RS274/NGC, to #33 with FANUC.
pub(super) const LOCALS: usize = 34;

/// Most named parameters at a time.
const MOST_NAMES: usize = 1_000;

/// Longest name [bytes].
const LONGEST_NAME: usize = 100;

/// Own parameters of a subprogram, by number.
pub(super) type Locals = [f64; LOCALS];

/// The value of a parameter that was never set, which for FANUC is a value: vacant.
pub(super) const UNSET: f64 = f64::NAN;

/// The value of a parameter whose assignment failed: whoever reads it fails, too.
pub(super) const FAILED: f64 = f64::INFINITY;

/// What an assignment sets.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Target {
    Number(u32),
    Name(String),
    /// Lets a name have whole numbers alone from here on (SINUMERIK's INT and BOOL).
    Whole(String),
}

/// An assignment, which takes effect once its whole block was read.
#[derive(Debug, Clone)]
pub(super) struct Setting {
    pub(super) target: Target,
    pub(super) value: f64,
    /// The column of the assignment.
    pub(super) column: u32,
}

#[derive(Debug)]
struct Named {
    name: String,
    /// The level of the subprogram that it belongs to; names that begin with `_` belong to all.
    level: u32,
    value: f64,
    is_whole: bool,
}

/// The parameters.
#[derive(Debug, Default)]
pub(super) struct Parameters {
    numbered: Vec<f64>,
    named: Vec<Named>,
    /// How deep in subprograms that have parameters of their own.
    pub(super) level: u32,
}

impl Parameters {
    /// A numbered one, [`UNSET`] or [`FAILED`].
    pub(super) fn number(&self, number: u32) -> f64 {
        self.numbered.get(number as usize).copied().unwrap_or(UNSET)
    }

    pub(super) fn set_number(&mut self, number: u32, value: f64) {
        let index = number.min(LAST_OF_HAAS) as usize;
        if self.numbered.len() <= index {
            self.numbered.resize(index + 1, UNSET);
        }
        if let Some(parameter) = self.numbered.get_mut(index) {
            *parameter = value;
        }
    }

    /// Whether none has a name.
    pub(super) fn is_nameless(&self) -> bool {
        self.named.is_empty()
    }

    fn index(&self, name: &str) -> Option<usize> {
        let level = self.level_of(name);
        self.named.iter().position(|named| named.level == level && named.name == name)
    }

    fn level_of(&self, name: &str) -> u32 {
        if name.starts_with('_') { 0 } else { self.level }
    }

    /// A named one; `None` where it does not exist.
    pub(super) fn name(&self, name: &str) -> Option<f64> {
        self.named.get(self.index(name)?).map(|named| named.value)
    }

    /// Sets a named one; false where there are too many of them, or the name is too long.
    pub(super) fn set_name(&mut self, name: String, value: f64) -> bool {
        if let Some(named) = self.index(&name).and_then(|index| self.named.get_mut(index)) {
            named.value = if named.is_whole { value.round() } else { value };
            return true;
        }
        let fits = self.named.len() < MOST_NAMES && name.len() <= LONGEST_NAME;
        if fits {
            let level = self.level_of(&name);
            self.named.push(Named { name, level, value, is_whole: false });
        }
        fits
    }

    /// Rounds a named one, now and whenever it is set.
    pub(super) fn make_whole(&mut self, name: &str) {
        if let Some(named) = self.index(name).and_then(|index| self.named.get_mut(index)) {
            (named.value, named.is_whole) = (named.value.round(), true);
        }
    }

    /// Enters a subprogram that has parameters of its own, the first `count` as given; returns what
    /// they were.
    pub(super) fn enter(&mut self, arguments: &Locals, count: usize) -> Box<Locals> {
        self.level += 1;
        let mut saved = Box::new([UNSET; LOCALS]);
        for (number, saved) in (0_u32..).zip(saved.iter_mut()) {
            *saved = self.number(number);
        }
        self.set_locals(arguments, count);
        saved
    }

    /// Sets #1 to #`count`.
    pub(super) fn set_locals(&mut self, locals: &Locals, count: usize) {
        for (number, value) in (0_u32..).zip(locals).take(count + 1).skip(1) {
            self.set_number(number, *value);
        }
    }

    /// Leaves a subprogram: its parameters are again what they were.
    pub(super) fn leave(&mut self, saved: &Locals, count: usize) {
        self.set_locals(saved, count);
        self.level = self.level.saturating_sub(1);
        let level = self.level;
        self.named.retain(|named| named.level <= level);
    }
}
