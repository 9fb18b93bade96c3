//! A handle of a contour that is edited.

use glam::DVec2;
use wasm_bindgen::prelude::wasm_bindgen;

use super::argument::BadArgument;
use super::contour_records::{read_contours, read_segment};
use super::names::Edit;
use super::numbering::Numbering;
use super::settings::Settings;
use super::tool_path::ToolPathHandle;
use crate::compensation::{EditError, LiveContour};
use crate::contour::Side;
use crate::simulation::Profile;

/// A contour that is edited; `LiveContour` of `types.d.ts` holds one.
#[wasm_bindgen]
#[derive(Debug)]
pub struct LiveHandle {
    live: LiveContour,
    /// What the contour says about its tool.
    own: (Option<Side>, Option<f64>),
}

#[wasm_bindgen]
impl LiveHandle {
    /// Takes the contour of `records` and the settings that `compensateContours` takes; the chords of
    /// polylines are within `chord` [mm] of their curves.
    ///
    /// # Errors
    /// Where a record is wrong, there is not one contour, or it is left without a side or a radius.
    #[wasm_bindgen(constructor)]
    pub fn new(records: &[f64], settings: Settings, chord: f64) -> Result<Self, BadArgument> {
        let (mut contours, _) = read_contours(records)?;
        let (Some(contour), true) = (contours.pop(), contours.is_empty()) else {
            return Err(BadArgument::new("contour", "be one contour"));
        };
        let own = (contour.side, contour.radius);
        let tool = settings.tool(own.0, own.1)?;
        let (described, closed) = contour.into_builder();
        let live = LiveContour::new(
            described,
            closed,
            tool,
            settings.into_options(Profile::default()),
            chord,
        );
        Ok(Self { live, own })
    }

    /// Changes the options.
    ///
    /// # Errors
    /// Where there is no side or no radius.
    pub fn set(&mut self, settings: Settings, chord: f64) -> Result<(), BadArgument> {
        let tool = settings.tool(self.own.0, self.own.1)?;
        self.live.set(tool, settings.into_options(Profile::default()), chord);
        Ok(())
    }

    /// Moves, inserts or removes a point, [mm]; the start and what is removed need no place of their
    /// own.
    ///
    /// # Errors
    /// Where there is none, or no place for one.
    pub fn edit(
        &mut self,
        edit: Edit,
        segment: usize,
        index: usize,
        x: f64,
        y: f64,
    ) -> Result<(), BadArgument> {
        let point = DVec2::new(x, y);
        match edit {
            Edit::MoveStart => self.live.move_start(point),
            Edit::MovePoint => self.live.move_point(segment, index, point)?,
            Edit::InsertPoint => self.live.insert_point(segment, index, point)?,
            Edit::RemovePoint => self.live.remove_point(segment, index)?,
        }
        Ok(())
    }

    /// Changes a segment into that of a record.
    ///
    /// # Errors
    /// Where the record is wrong, or there is no such segment.
    #[wasm_bindgen(js_name = setSegment)]
    pub fn set_segment(&mut self, segment: usize, record: &[f64]) -> Result<(), BadArgument> {
        Ok(self.live.set_segment(segment, read_segment(record)?)?)
    }

    /// Brings the polylines up to date, and tells where they are in memory: of the path the
    /// address and number of its vertices and of its starts, and the range of vertices that have
    /// changed; of the contour the same without starts.
    #[must_use]
    pub fn update(&mut self) -> Vec<u32> {
        let changed = self.live.update();
        let (points, starts) = (self.live.path_points(), self.live.path_starts());
        let outline = self.live.outline_points();
        let places = [
            points.as_ptr() as usize,
            points.len() / 2,
            starts.as_ptr() as usize,
            starts.len(),
            changed.path.start,
            changed.path.end,
            outline.as_ptr() as usize,
            outline.len() / 2,
            changed.outline.start,
            changed.outline.end,
        ];
        let mut list = Vec::with_capacity(places.len());
        for place in places {
            list.push(u32::try_from(place).unwrap_or(u32::MAX));
        }
        list
    }

    /// The tool path of the contour as it is now, computed afresh.
    #[must_use]
    pub fn path(&self) -> ToolPathHandle {
        ToolPathHandle::new(self.live.path(), Numbering::plain())
    }
}

impl From<EditError> for BadArgument {
    fn from(error: EditError) -> Self {
        let (path, must) = match error {
            EditError::NoSegment => ("segment", "be the index of a segment"),
            EditError::NoPoint => ("index", "be the index of a point of the segment"),
            EditError::NotASpline => ("segment", "be the index of a spline"),
            EditError::LastPoint => ("index", "leave the spline another point"),
        };
        Self::new(path, must)
    }
}
