//! How segments of several contours are numbered through, and told apart again.

use crate::diagnostic::Origin;

/// The number of the first segment of each contour, where segments are numbered through all
/// contours given in one call.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Numbering {
    firsts: Vec<u32>,
}

/// The place of a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    /// Index of its contour, where there are several.
    pub(super) contour: Option<u32>,
    /// Index of the segment in its contour.
    pub(super) segment: u32,
}

impl Numbering {
    /// For one contour or a program: numbers stand as they are.
    #[must_use]
    pub fn plain() -> Self {
        Self::default()
    }

    /// For contours whose first segments have these numbers, ascending from 0.
    #[must_use]
    pub fn of(firsts: Vec<u32>) -> Self {
        Self { firsts }
    }

    /// Where the segment of a number is.
    pub(super) fn place(&self, number: u32) -> Place {
        if self.firsts.len() < 2 {
            return Place { contour: None, segment: number };
        }
        // Of contours without segments, which share a number, the last is followed by this one.
        let contour = self.firsts.partition_point(|&first| first <= number) - 1;
        let index = u32::try_from(contour).unwrap_or(u32::MAX);
        Place { contour: Some(index), segment: number - self.firsts[contour] }
    }

    /// Where an origin is, if it is a segment.
    pub(super) fn place_of(&self, origin: Origin) -> Option<Place> {
        match origin {
            Origin::Block { .. } => None,
            Origin::Segment(number) => Some(self.place(number)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_of_several_contours_are_told_apart() {
        let numbering = Numbering::of(vec![0, 2, 2, 5]);
        let place = |number| {
            let Place { contour, segment } = numbering.place(number);
            (contour.expect("there are several contours"), segment)
        };
        assert_eq!([0, 1, 2, 4, 5].map(place), [(0, 0), (0, 1), (2, 0), (2, 2), (3, 0)]);
    }

    #[test]
    fn segments_of_one_contour_need_no_contour() {
        assert_eq!(Numbering::of(vec![0]).place(3), Place { contour: None, segment: 3 });
    }
}
