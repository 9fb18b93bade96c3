//! Scaling, mirroring, rotation and polar coordinates: G15, G16, G50, G51, G50.1, G51.1, G68 and G69.

use glam::{DVec2, DVec3};

use super::block::{Block, Word};
use super::coordinates::AXES;
use super::frame::{Frame, Polar, radians};
use super::g_words::Act;
use super::interpret::Interpreter;
use super::words::Words;
use crate::diagnostic::Diagnostic;
use crate::geometry::{Decimal, MAX_COORDINATE, turn};

/// Scaling factors from here on are thousandths, as FANUC counts them without a decimal point.
const THOUSANDTHS: f64 = 10.0;

/// Smallest scaling factor: coordinates divided by it stay numbers.
const MIN_FACTOR: f64 = 1e-3;

impl Interpreter {
    /// G15, G16, G50, G51, G50.1, G51.1, G68 and G69.
    pub(super) fn transform(&mut self, block: &Block, word: &Word, act: Act, words: &mut Words) {
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
        self.is_usable_scale(block, word.column, factors).then_some(factors)
    }

    /// Whether coordinates divided by the factors stay numbers; told where not.
    pub(super) fn is_usable_scale(&mut self, block: &Block, column: u32, factors: DVec3) -> bool {
        let usable = factors.abs().min_element() >= MIN_FACTOR
            && factors.abs().max_element() <= MAX_COORDINATE;
        if !usable {
            let at = block.origin_at(column);
            self.error("bad-scale", "the scale is no usable factor", at, "it has no effect");
        }
        usable
    }
}

/// Whether the frames map points otherwise.
fn differs(a: &Frame, b: &Frame) -> bool {
    a.mirror != b.mirror || a.factors != b.factors || a.rotation != b.rotation
}
