//! Parameters that tell the state of the control: position, modes, tool.
//!
//! What only the machine knows, or the table of tools, has no value here.

use glam::DVec3;

use super::dialect::Dialect;
use super::feed::FeedMode;
use super::g_words::Motion;
use super::interpret::Interpreter;
use super::items::RadiusSource;
use crate::contour::{Plane, Side};

impl Interpreter {
    /// A programmed coordinate of the position in the unit of the program, if it was stated.
    fn programmed(&self, axis: usize) -> Option<f64> {
        let modal = &self.modal;
        let stated = self.rules.is_strict || modal.stated.get(axis).copied().unwrap_or_default();
        let position = modal.frame.unmap(modal.position).to_array();
        position.get(axis).filter(|_| stated).map(|value| value / modal.unit())
    }

    /// Ten times the G word of the active coordinate system.
    fn system_word(&self) -> Option<f64> {
        const WORDS: [f64; 9] = [540.0, 550.0, 560.0, 570.0, 580.0, 590.0, 591.0, 592.0, 593.0];
        WORDS.get(self.modal.systems.active()?).copied()
    }

    /// A numbered parameter of the control.
    pub(super) fn system_number(&self, number: u32, dialect: Dialect) -> Option<f64> {
        let axis = |first: u32| usize::try_from(number - first).ok();
        let unit = self.modal.unit();
        if dialect == Dialect::Fanuc {
            return match number {
                4003 => Some(if self.modal.relative { 91.0 } else { 90.0 }),
                4006 => Some(if self.modal.inches { 20.0 } else { 21.0 }),
                4109 => self.modal.feed.word(unit),
                4120 => Some(f64::from(self.modal.active_tool())),
                // The end of the block before, and where the tool is then.
                5001..=5003 => self.programmed(axis(5001)?),
                5041..=5043 => self.programmed(axis(5041)?),
                _ => None,
            };
        }
        let (modal, assumed) = (&self.modal, &self.modal.systems.assumed);
        match number {
            5161..=5163 if self.rules.is_strict => Some(assumed.homes[0][axis(5161)?]),
            5181..=5183 if self.rules.is_strict => Some(assumed.homes[1][axis(5181)?]),
            5210 if self.rules.is_strict => Some(f64::from(u8::from(assumed.shift != DVec3::ZERO))),
            5211..=5213 if self.rules.is_strict => Some(assumed.kept[axis(5211)?]),
            5220 if self.rules.is_strict => Some(1.0 + modal.systems.active().unwrap_or(0) as f64),
            5221..=5390 if self.rules.is_strict => {
                let number = axis(5221)?;
                let (origin, angle) = assumed.origins.get(number / 20)?;
                match number % 20 {
                    axis @ 0..=2 => Some(origin[axis]),
                    9 => Some(angle.to_degrees()),
                    _ => Some(0.0),
                }
            }
            5220 => self.modal.systems.active().map(|active| 1.0 + active as f64),
            5221..=5383 => {
                let number = axis(5221)?;
                self.modal.systems.origin(number / 20, number % 20).map(|origin| origin / unit)
            }
            5401..=5403 if self.rules.is_strict => Some(assumed.tool[axis(5401)?]),
            5400 => Some(f64::from(self.modal.active_tool())),
            5420..=5422 => self.programmed(axis(5420)?),
            // Whether DEBUG comments are shown.
            5599 => Some(1.0),
            _ => None,
        }
    }

    /// A named parameter of the control, which begins with `_`.
    pub(super) fn system_name(&self, name: &str) -> Option<f64> {
        let modal = &self.modal;
        let truth = |value: bool| Some(f64::from(u8::from(value)));
        match name {
            // Before a subprogram has returned; SINUMERIK's FALSE, with the point of its names.
            "_value" | "_value_returned" | ".false" => Some(0.0),
            ".true" => Some(1.0),
            "_x" => self.programmed(0),
            "_y" => self.programmed(1),
            "_z" => self.programmed(2),
            "_metric" => truth(!modal.inches),
            "_imperial" => truth(modal.inches),
            "_absolute" => truth(!modal.relative),
            "_incremental" => truth(modal.relative),
            "_ijk_absolute_mode" => truth(modal.absolute_center),
            "_units_per_minute" => truth(modal.feed.mode() == FeedMode::PerMinute),
            "_inverse_time" => truth(modal.feed.mode() == FeedMode::InverseTime),
            "_units_per_rev" => truth(modal.feed.mode() == FeedMode::PerRevolution),
            "_feed" => modal.feed.word(modal.unit()),
            "_plane" => Some(match modal.plane {
                Plane::Xy => 170.0,
                Plane::Zx => 180.0,
                Plane::Yz => 190.0,
            }),
            "_coord_system" => self.system_word(),
            "_ccomp" => Some(match self.course.switched() {
                None => 400.0,
                Some(on) => {
                    let side = if on.side == Side::Left { 410.0 } else { 420.0 };
                    let given = matches!(on.radius, RadiusSource::Given(_));
                    side + f64::from(u8::from(given))
                }
            }),
            "_current_tool" => Some(f64::from(modal.active_tool())),
            "_motion_mode" => Some(match modal.motion {
                Some(Motion::Rapid) => 0.0,
                Some(Motion::Linear) => 10.0,
                Some(Motion::Arc { clockwise: true }) => 20.0,
                Some(Motion::Arc { clockwise: false }) => 30.0,
                Some(Motion::Cycle(number)) => 10.0 * f64::from(number),
                None => 800.0,
                Some(Motion::TypePoints | Motion::Cubic) => 50.0,
                Some(Motion::Quadratic) => 51.0,
                Some(Motion::Controls) => 52.0,
                Some(Motion::Through) => 61.0,
                Some(Motion::Knots) => 62.0,
                Some(Motion::Passed(number)) => f64::from(number),
                // Those that other controls alone have.
                Some(_) => return None,
            }),
            _ => None,
        }
    }
}
