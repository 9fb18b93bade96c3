//! Programs in Heidenhain's conversational language: numbered blocks of words for what is meant.
//!
//! `L` is a straight move, `CC` a centre and `C` the arc about it, `CP` a helix. FMAX, a rapid move,
//! holds for its block alone; the feed, and RL, RR or R0, which switch compensation, hold on.
//! After the user's manual of the iTNC 530, as are the cubics of SPL: their parameter runs from 1 to
//! 0, so that K3, K2 and K1 are powers about the end.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::block_writer::{AXES, BlockWriter};
use super::number::{push_scaled, push_word};
use super::passed::{Command, Passing, Token, find, tenths};
use crate::geometry::turn;

/// Most units of a number before its last decimal that need no exponent: coefficients are below 10.
const MOST_PLAIN: u64 = 100_000;

/// Units of the least angle in a degree: four decimals.
const ANGLE_SCALE: f64 = 1e4;

impl BlockWriter {
    /// The first or the last block of the program.
    pub(super) fn program_line(&mut self, word: &str) {
        self.start_block(word);
        self.text.push_str(" PGM ");
        push_scaled(&mut self.text, i64::from(self.program), 0);
        self.text.push_str(" MM\n");
    }

    /// RL, RR or R0 for the next straight move.
    fn radius_word(&mut self, word: &str) {
        self.prefix.clear();
        self.prefix.push_str(word);
    }

    /// A block that moves.
    pub(super) fn klartext(
        &mut self,
        motion: char,
        to: [i64; 3],
        mut says: [bool; 3],
        offsets: &[(char, i64)],
    ) {
        let [first, second, normal] = self.plane.axes();
        match (motion, offsets) {
            ('2' | '3', &[(_, a), (_, b), ..]) => {
                let center = [self.at[first] + a, self.at[second] + b];
                self.start_block("CC");
                self.length(AXES[first][0], center[0]);
                self.length(AXES[second][0], center[1]);
                self.text.push('\n');
                let rises = to[normal] != self.at[normal];
                self.start_block(if rises { "CP" } else { "C" });
                if rises {
                    self.turn_by(motion == '2', to, center);
                } else {
                    self.length(AXES[first][0], to[first]);
                    self.length(AXES[second][0], to[second]);
                }
                self.text.push_str(if motion == '2' { " DR-" } else { " DR+" });
                self.others();
                for i in [first, second] {
                    (self.known[i], self.written[i]) = (true, true);
                }
                self.feed();
            }
            ('5', &[(_, i), (_, j), (_, p), (_, q)]) => {
                self.start_block("SPL");
                self.length('X', to[0]);
                self.length('Y', to[1]);
                let ways = [self.at[0] - to[0], self.at[1] - to[1]];
                for (axis, (way, (from, before))) in
                    ['X', 'Y'].into_iter().zip(ways.into_iter().zip([i, j].into_iter().zip([p, q])))
                {
                    self.text.push_str(" ~\n");
                    let powers = [
                        3 * before - 3 * from - 2 * way,
                        3 * (way + from - 2 * before),
                        3 * before,
                    ];
                    for (power, value) in ["K3", "K2", "K1"].into_iter().zip(powers) {
                        self.space();
                        self.text.push_str(power);
                        self.text.push(axis);
                        self.coefficient(value);
                    }
                }
                self.feed();
            }
            _ => {
                let stated = std::mem::take(&mut self.states);
                self.start_block("L");
                for i in 0..3 {
                    says[i] |= stated[i];
                    if says[i] {
                        self.length(AXES[i][0], to[i]);
                        (self.known[i], self.written[i]) = (true, true);
                    }
                }
                self.others();
                if !self.prefix.is_empty() {
                    self.space();
                    self.text.push_str(&self.prefix);
                    self.prefix.clear();
                }
                if motion == '0' {
                    self.text.push_str(" FMAX");
                } else {
                    self.feed();
                }
            }
        }
        self.text.push('\n');
        self.at = to;
    }

    /// A straight move in the coordinates of the machine.
    fn machine_block(&mut self, parameters: &[Token], rapid: bool) {
        self.start_block("L");
        for token in parameters {
            if let Token::Word(letter, value) = *token
                && !matches!(letter, 'G' | 'F')
            {
                let value = self.units(value);
                self.length(letter, value);
            }
        }
        if rapid {
            self.text.push_str(" FMAX");
        } else if let Some(feed) = find(parameters, 'F') {
            self.set_feed(feed / 60.0);
            self.feed();
        }
        self.text.push_str(" M91\n");
    }

    fn start_block(&mut self, word: &str) {
        self.begin();
        self.space();
        self.text.push_str(word);
    }

    /// How far a helix turns, and climbs.
    fn turn_by(&mut self, clockwise: bool, to: [i64; 3], center: [i64; 2]) {
        let [first, second, normal] = self.plane.axes();
        let arm = |place: [i64; 3]| {
            DVec2::new((place[first] - center[0]) as f64, (place[second] - center[1]) as f64)
        };
        let mut sweep = turn(arm(self.at), arm(to));
        if clockwise && sweep >= 0.0 {
            sweep -= TAU;
        } else if !clockwise && sweep <= 0.0 {
            sweep += TAU;
        }
        #[expect(clippy::cast_possible_truncation, reason = "at most 3600000")]
        let angle = (sweep * (180.0 / PI) * ANGLE_SCALE).round() as i64;
        self.text.push_str(" IPA");
        self.signed(angle);
        self.text.push_str(" I");
        self.text.push(AXES[normal][0]);
        self.signed(to[normal] - self.at[normal]);
    }

    /// A number with its sign.
    fn signed(&mut self, scaled: i64) {
        if scaled >= 0 {
            self.text.push('+');
        }
        push_scaled(&mut self.text, scaled, self.facts.decimals);
    }

    /// A coefficient of a cubic, below ten and with an exponent where it is more.
    fn coefficient(&mut self, scaled: i64) {
        let size = scaled.unsigned_abs();
        if size < MOST_PLAIN {
            return self.signed(scaled);
        }
        let (mut power, mut exponent) = (MOST_PLAIN, 1_u32);
        while size / 10 >= power {
            power *= 10;
            exponent += 1;
        }
        if scaled >= 0 {
            self.text.push('+');
        }
        push_scaled(&mut self.text, scaled, self.facts.decimals + exponent);
        self.text.push_str("E+");
        push_scaled(&mut self.text, i64::from(exponent), 0);
    }
}

impl Passing {
    /// A word that moves nothing, with the parameters that belong to it and what follows.
    pub(super) fn klartext(
        &mut self,
        out: &mut BlockWriter,
        letter: char,
        command: Command,
        ahead: &[Token],
    ) {
        let Command { value, parameters, origin } = command;
        // A tool is called with its speed.
        let called = ahead.iter().any(|token| token.is('M', 6.0));
        match (letter, tenths(value)) {
            ('G', 40) => {
                out.words("CYCL DEF 9.0 DWELL TIME");
                out.words(&with("CYCL DEF 9.1 DWELL", ' ', find(parameters, 'P')));
            }
            // They stand around G28, of which it is told.
            ('G', 900 | 910) => {}
            ('G', 400) => out.radius_word("R0"),
            ('G', 410 | 420) => {
                out.radius_word(if value == 41.0 { "RL" } else { "RR" });
                let radius = find(parameters, 'D');
                if radius != self.tool {
                    self.left_out('D', radius.unwrap_or(0.0), origin);
                }
            }
            ('G', 530) => {
                let rapid = parameters.iter().any(|token| token.is('G', 0.0));
                out.machine_block(parameters, rapid);
            }
            ('T', _) => {
                self.tool = Some(value);
                if !called {
                    out.words(&with("TOOL DEF", ' ', self.tool));
                }
            }
            ('S', _) => {
                self.spindle[1] = Some(value);
                if !called {
                    out.words(&with("TOOL CALL", 'S', self.spindle[1]));
                }
            }
            ('M', 60) => {
                let mut block = with("TOOL CALL", ' ', self.tool);
                block.push_str(" Z");
                if self.spindle[1].is_some() {
                    block = with(&block, 'S', self.spindle[1]);
                }
                out.words(&block);
            }
            ('M', _) if parameters.is_empty() => out.words(&with("", 'M', Some(value))),
            _ => self.left_out(letter, value, origin),
        }
    }
}

/// Words with a number behind them, maybe with a letter.
fn with(words: &str, letter: char, value: Option<f64>) -> String {
    let mut block = String::from(words);
    if letter != ' ' && !words.is_empty() {
        block.push(' ');
    }
    push_word(&mut block, letter, value.unwrap_or(0.0));
    block
}
