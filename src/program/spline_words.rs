//! SINUMERIK's words for splines, and the tangents of the blocks beside one.
//!
//! The reader gives these words small letters: `s` for ASPLINE, BSPLINE and CSPLINE, `b` and `e`
//! for how they begin and end, `w` for PW, `l` for PL and `d` for SD; `k` for NORM and KONT and `v`
//! for DISC, `o` for OFFN, which are no words for splines (`corner_words`), and `r`, `m`, `c`, `f`,
//! `g` and `h` for RND, RNDM, CHR, CHF, FRC and FRCM (`corner_cuts`), `n` and `p` for the programmable
//! frames and RPL, `j` and `q` for AP and RP (`sinumerik`), `i` for cycles (`drilling`), `a`, `t`, `x`, `y` and `z` for AR, TURN, I1, J1 and K1 (`arcs`); CT and
//! CIP are an `s`, too.

use glam::{DVec2, DVec3};

use super::coordinates::AXES;
use super::g_words::Motion;
use super::interpret::Interpreter;
use super::modes::Demands;
use super::pending_spline::{Boundary, Family};
use super::words::Words;
use crate::contour::Shape;
use crate::geometry::{RadiusForm, perp};

/// Words without a number. For one block no frame counts by SUPA, as by G53.
pub(super) const NAMES: &str = "SUPA TRANS ROT SCALE MIRROR ATRANS AROT ASCALE AMIRROR NORM KONT \
    KONTT KONTC ASPLINE BSPLINE CSPLINE CT CIP BAUTO BNAT BTAN EAUTO ENAT ETAN";

/// Their letters, and the numbers that stand for them.
pub(super) const LETTERS: &[u8; 24] = b"Gnnnnnnnnkkkksssssbbbeee";
pub(super) const VALUES: &[u8; 24] = b"\x35\x00\x01\x02\x03\x04\x05\x06\x07\x00\x01\x02\x03\x00\x01\x02\x03\x04\x00\x01\x02\x00\x01\x02";

/// Words with a value behind `=`.
pub(super) const ADDRESSES: &str =
    "CR PW PL SD DISC OFFN RPL AR AP RP TURN RND RNDM CHR CHF FRC FRCM";

/// Their letters. The radius of an arc has the sign that tells which.
pub(super) const ADDRESS_LETTERS: &[u8; 17] = b"Rwldvopajqtrmcfgh";

/// Which of the names in a list a name is.
pub(super) fn place_in(names: &str, name: &str) -> Option<usize> {
    names.split(' ').position(|known| known.eq_ignore_ascii_case(name))
}

impl Interpreter {
    /// The modes that the words set.
    pub(super) fn spline_words(&mut self, words: &mut Words, demands: &mut Demands) {
        for (i, letter) in ['b', 'e'].into_iter().enumerate() {
            if let Some(word) = words.take(letter) {
                let boundary = match word.value {
                    0.0 => Boundary::Auto,
                    1.0 => Boundary::Natural,
                    _ => Boundary::Tangent,
                };
                self.curves.boundaries[i] = boundary;
                // The end is told where the spline begins, or with its last points.
                if let (1, Some(spline)) = (i, &mut self.spline) {
                    spline.boundaries[1] = boundary;
                }
            }
        }
        if let Some(word) = words.take('s') {
            let motion = Some(match word.value {
                0.0 => Motion::Named(Family::Akima),
                1.0 => Motion::Named(Family::Controls),
                2.0 => Motion::Named(Family::Cubic),
                3.0 => Motion::Tangent,
                _ => Motion::ByPoint,
            });
            (demands.motion, self.modal.motion) = (motion, motion);
            self.modal.cycle.end();
        }
    }

    /// Before a spline ends at a block: where that block leads to is its tangent, if it asks for
    /// that.
    pub(super) fn look_ahead(&mut self, words: &Words) {
        let heading = match &self.spline {
            Some(spline) if matches!(spline.motion, Motion::Named(_)) => self.heading_of(words),
            _ => return,
        };
        if let Some(spline) = &mut self.spline {
            spline.tangents[1] = heading;
        }
    }

    /// The direction in which the move of a block begins.
    fn heading_of(&self, words: &Words) -> Option<DVec2> {
        let plane = self.modal.plane;
        let start = self.modal.frame.unmap(self.modal.position);
        let flat = |point: DVec3| plane.split(self.modal.frame.map(point)).0;
        let (mut to, mut center) = (start, start);
        for (i, letter) in AXES.into_iter().enumerate() {
            if let Some(word) = words.find(letter) {
                let value = self.modal.length_of(i, word.value);
                to[i] = if self.modal.relative { to[i] + value } else { value };
            }
        }
        for (i, letter) in ['I', 'J', 'K'].into_iter().enumerate() {
            let word = words.find(letter);
            center[i] += word.map_or(0.0, |word| word.value * self.modal.unit());
        }
        let (from, to) = (plane.split(self.modal.position).0, flat(to));
        let heading = match self.modal.motion? {
            Motion::Rapid | Motion::Linear => to - from,
            Motion::Arc { clockwise } => {
                let clockwise = clockwise != self.modal.frame.flips(plane);
                if let Some(word) = words.find('R') {
                    let form = if word.value < 0.0 { RadiusForm::Major } else { RadiusForm::Minor };
                    let radius =
                        word.value.abs() * self.modal.unit() * self.modal.frame.factor(plane)?;
                    let shape = Shape::ArcByRadius { to, radius, form, clockwise };
                    shape.curve(from, None).ok()?.tangent(0.0)
                } else {
                    let along = perp(from - flat(center));
                    if clockwise { -along } else { along }
                }
            }
            _ => return None,
        };
        heading.try_normalize()
    }
}

/// The direction in which a shape ends.
pub(super) fn end_heading(from: DVec2, shape: &Shape) -> Option<DVec2> {
    let heading = match shape {
        Shape::Line { to } => *to - from,
        Shape::Bezier { controls } => match controls[..] {
            [.., before, to] => to - before,
            _ => return None,
        },
        Shape::Spline(_) => return None,
        _ => shape.curve(from, None).ok()?.tangent(1.0),
    };
    heading.try_normalize()
}
