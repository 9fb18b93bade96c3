//! The words that switch compensation on and off, and the D word: whose radius it is.

use super::block::{Block, Word};
use super::course::SwitchOn;
use super::g_words::Compensation;
use super::interpret::Interpreter;
use super::items::{OrientationSource, RadiusSource};
use super::number::whole;
use super::words::Words;
use crate::contour::{Plane, Side};
use crate::diagnostic::Origin;
use crate::geometry::Decimal;

impl Interpreter {
    /// G40, G41, G42 and the D word.
    pub(super) fn compensation(
        &mut self,
        block: &Block,
        demand: Option<(Compensation, &Word)>,
        words: &mut Words,
    ) {
        let number = words.take('D');
        let offset = words.take('o');
        if let Some(word) = offset {
            self.modal.allowance = word.value * self.modal.unit();
        }
        let allowance = self.modal.allowance;
        let origin = block.origin_at(demand.map(|(_, w)| w).or(number).map_or(1, |w| w.column));
        let switches_on =
            matches!(demand, Some((Compensation::Tool(_) | Compensation::Diameter(_), _)));
        if self.rules.is_strict && (switches_on || number.is_some()) {
            let fault = if !switches_on {
                Some("D belongs to G41 or G42")
            } else if self.course.switched().is_some() {
                Some("compensation is on already")
            } else if self.modal.plane == Plane::Yz {
                Some("in the plane G19 nothing is compensated")
            } else {
                None
            };
            if let Some(fault) = fault {
                self.refuse(fault, origin);
                return;
            }
        }
        if self.rules.spindle_tool {
            self.modal.radius_number = None;
        }
        let at = self.modal.plane.split(self.modal.position).0;
        // What is mirrored has the tool on its other side.
        let flips = self.modal.frame.flips(self.modal.plane);
        let seen = |side: Side| if flips { side.opposite() } else { side };
        let unit = self.modal.unit();
        let switched = match demand {
            Some((Compensation::Off, _)) => {
                self.read_radius_number(block, number);
                self.wall(words);
                let [_, y, z] = self.modal.stated;
                if self.course.switched().is_some() && self.modal.plane == Plane::Xy && z && !y {
                    // Controls of lathes begin in G18, and their programs do not say so.
                    self.report.warning(
                        "doubtful-plane",
                        "compensated in the plane of x and y, though no block has stated Y",
                        origin,
                        "where it is for a lathe, put G18 into the first block",
                    );
                }
                self.course.switch_off(origin);
                return;
            }
            Some((Compensation::Diameter(side), _)) => {
                let Some(diameter) = number else {
                    let message = "G41.1 and G42.1 need the diameter as a D word";
                    self.error("missing-diameter", message, origin, "compensation stays off");
                    return;
                };
                let radius = RadiusSource::Given(0.5 * diameter.value * unit);
                let orientation = self.orientation(block, words.take('L'));
                let orientation = OrientationSource::Given(orientation);
                Some(SwitchOn { side: seen(side), radius, allowance, orientation, unit, origin })
            }
            Some((Compensation::Tool(side), _)) => {
                self.read_radius_number(block, number);
                if self.rules.is_strict {
                    // It says something beside G41.1 alone.
                    words.take('L');
                }
                let (radius, orientation) = self.tool_of(origin);
                Some(SwitchOn { side: seen(side), radius, allowance, orientation, unit, origin })
            }
            None if number.or(offset).is_some() => {
                self.read_radius_number(block, number);
                self.course.switched().map(|before| {
                    let (radius, orientation) = self.tool_of(origin);
                    SwitchOn { side: before.side, radius, allowance, orientation, unit, origin }
                })
            }
            None => None,
        };
        if let Some(switched) = switched {
            self.course.switch_on(switched, at, &mut self.report);
        }
    }

    fn read_radius_number(&mut self, block: &Block, word: Option<&Word>) {
        let Some(word) = word else { return };
        match whole(word.value) {
            Some(number) => self.modal.radius_number = Some(number),
            None => self.error(
                "bad-tool-number",
                format!("D{} is not the number of a tool", Decimal::of(word.value)),
                block.origin_at(word.column),
                "with a diameter use G41.1 or G42.1; the active tool is taken",
            ),
        }
    }

    /// Which way the tip of a lathe tool points (L).
    fn orientation(&mut self, block: &Block, word: Option<&Word>) -> u8 {
        let Some(word) = word else { return 0 };
        if self.modal.plane != Plane::Zx && self.rules.is_strict {
            let message = "only in the plane G18 has a tool an orientation (L)";
            self.refuse(message, block.origin_at(word.column));
            return 0;
        }
        let number = whole(word.value).and_then(|number| u8::try_from(number).ok());
        if let Some(number) = number.filter(|number| *number <= 9) {
            return number;
        }
        let message = format!("L{} is no orientation of a lathe tool", Decimal::of(word.value));
        let at = block.origin_at(word.column);
        self.error("bad-orientation", message, at, "it is a whole number from 0 to 9");
        0
    }

    /// Radius and orientation of the tool that G41 and G42 ask for: those that G10 gave it, or else
    /// those of the table.
    fn tool_of(&mut self, origin: Origin) -> (RadiusSource, OrientationSource) {
        let number = self.tool_number(origin);
        let Some(number) = number else {
            return (RadiusSource::Given(0.0), OrientationSource::Given(0));
        };
        let (radius, tip) = (self.modal.radii.of(number), self.modal.tips.of(number));
        let wear = self.modal.wears.of(number).unwrap_or(0.0);
        if radius.is_none() && wear != 0.0 {
            let message = "the tool has a wear (G10 L13) and no radius to add it to";
            self.error("missing-radius", message, origin, "give the radius by G10 L12, too");
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 9")]
        let given = |tip: f64| OrientationSource::Given(tip as u8);
        (
            radius.map_or(RadiusSource::Tool(number), |radius| RadiusSource::Given(radius + wear)),
            tip.map_or(OrientationSource::Tool(number), given),
        )
    }

    /// The number of that tool; `None` for D0 where it means no radius.
    fn tool_number(&mut self, origin: Origin) -> Option<u32> {
        if self.rules.spindle_tool {
            let number = self.modal.radius_number.filter(|number| *number > 0);
            return Some(number.unwrap_or(self.modal.loaded_tool()));
        }
        match self.modal.radius_number {
            Some(0) => {
                self.report.warning(
                    "no-radius",
                    "D0 means no radius: nothing is compensated",
                    origin,
                    "give the number of the tool as a D word",
                );
                None
            }
            number => Some(number.unwrap_or(self.modal.active_tool())),
        }
    }
}
