//! Where a program goes on beside the contour before it: a control that looks ahead takes, when a tool
//! changes after G40, the place of the tool for that of the program.

use glam::{BVec3, DVec2, DVec3};

use super::passed_words::for_words;
use crate::contour::{Plane, Reset};
use crate::program::ProgrammedContour;

/// How the next move counts from where the tool is.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Beside {
    /// From where the program counts to be to where the tool is, in x, y and z [mm].
    offset: DVec3,
    /// Which of them the next move states, though they stay as they are.
    states: [bool; 3],
    /// Whether it is incremental.
    relative: bool,
}

impl Beside {
    /// The tool is so far from where the program counts to be, in a plane [mm].
    pub(super) fn begin(&mut self, offset: DVec2, plane: Plane) {
        self.offset = plane.place(offset, 0.0);
    }

    pub(super) fn offset_in(&self, plane: Plane) -> DVec2 {
        plane.split(self.offset).0
    }

    /// What a block says of the next move, or what its words do: a new number for the place of the
    /// tool is one for where it is.
    pub(super) fn note(&mut self, words: &str, reset: &Reset) {
        if words.is_empty() {
            self.states = reset.states;
            self.relative = self.states == [false; 3];
        } else if words.starts_with("G92 ") || words.starts_with("G10 L20") {
            for_words(words, &mut |letter, _| {
                if let b'X'..=b'Z' = letter {
                    self.offset[usize::from(letter - b'X')] = 0.0;
                }
            });
        }
    }

    /// The next move says nothing so far.
    pub(super) fn forget(&mut self) {
        (self.states, self.relative) = ([false; 3], false);
    }

    /// Where the tool goes as the program goes from `from` to `to`: an axis that changes is stated [mm].
    pub(super) fn place(&mut self, [from, to]: [DVec2; 2], plane: Plane) -> DVec2 {
        if !self.relative {
            let changed = plane.place(to, 0.0).cmpne(plane.place(from, 0.0));
            let stated = BVec3::from_array(self.states) | changed;
            self.offset = DVec3::select(stated, DVec3::ZERO, self.offset);
        }
        to + self.offset_in(plane)
    }

    /// A contour as the tool goes along it, which is at a place in the plane of its own, unless words
    /// have given that another number [mm].
    pub(super) fn contour(
        mut self,
        programmed: &ProgrammedContour,
        at: Option<DVec3>,
    ) -> ProgrammedContour {
        let mut moved = programmed.clone();
        let contour = &mut moved.contour;
        let plane = contour.segments()[0].attributes.plane;
        let mut last = contour.lead_in().map_or(contour.start(), |lead| lead.point);
        if let Some(at) = at {
            self.begin(plane.split(at).0 - last, plane);
        }
        let mut begins = true;
        contour.place(&mut |point| {
            // Where it begins no block has said anything yet.
            if std::mem::take(&mut begins) {
                return point + self.offset_in(plane);
            }
            self.place([std::mem::replace(&mut last, point), point], plane)
        });
        moved
    }
}
