//! A contour that is edited while its tool path is looked at: each edit costs what it changes.
//!
//! Every segment is a part, a spline one of many spans (`part`). Parts are drawn in blocks of
//! some spans, each with its own room among all vertices (`slots`). An edit of a point solves the
//! spline around it afresh, marks the blocks whose spans have changed, and the corners that depend
//! on them (`joint`); `update` makes those anew and tells which vertices they are (`local`). Where
//! a contour cannot be followed segment by segment, because something about it is wrong, or where
//! what is asked for depends on the whole of it, everything is made anew.

mod blocks;
mod joint;
mod local;
mod part;
mod slots;
mod window;

use std::fmt;
use std::ops::Range;

use glam::DVec2;

use self::local::{Local, NotLocal};
use self::part::Pen;
use self::slots::Slots;
use super::policy::{compensate_all, looks_ahead};
use super::{GougePolicy, Options, Passes, SplineMethod};
use crate::contour::{Built, ContourBuilder, Segment, Shape, SplineShape, Tool, ToolPath};
use crate::geometry::{Curve, MIN_LENGTH};

/// Why an edit is not possible.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditError {
    /// There is no segment of this index.
    NoSegment,
    /// The segment has no point of this index.
    NoPoint,
    /// Points can be inserted into and removed from splines only.
    NotASpline,
    /// A spline keeps at least one point after its start.
    LastPoint,
}

impl fmt::Display for EditError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NoSegment => "there is no such segment",
            Self::NoPoint => "the segment has no such point",
            Self::NotASpline => "the segment is not a spline",
            Self::LastPoint => "the spline has no other point",
        })
    }
}

impl std::error::Error for EditError {}

/// What an update has changed: ranges of vertices.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Update {
    /// Of the tool path.
    pub path: Range<usize>,
    /// Of the contour itself.
    pub outline: Range<usize>,
}

/// A contour, its tool path as polylines, and edits that change no more of them than they must.
///
/// The path is what [`compensate_all`] gives, to within a hundredth of the tolerance, as polylines
/// within a chord tolerance of their own; vertices may be repeated. Where gouges are avoided a piece of
/// one point may stand where nothing is left, and an edit beside what a lead goes to, or beside a place
/// where a path got lost, makes everything anew. Gouges that are refused, and type points that are
/// moved, depend on the whole contour: with those every update does.
#[derive(Debug, Clone)]
pub struct LiveContour {
    described: ContourBuilder,
    closed: bool,
    tool: Tool,
    options: Options,
    chord: f64,
    local: Option<Local>,
    /// Whether everything is to be made anew by the next update.
    stale: bool,
    path: Slots,
    outline: Slots,
    /// Index of the first vertex of each piece of the path.
    starts: Vec<u32>,
}

impl LiveContour {
    /// Takes a contour as described, and the largest distance of a chord of its polylines from
    /// their curve [mm].
    #[must_use]
    pub fn new(
        described: ContourBuilder,
        closed: bool,
        tool: Tool,
        options: Options,
        chord: f64,
    ) -> Self {
        Self {
            described,
            closed,
            tool,
            options,
            chord,
            local: None,
            stale: true,
            path: Slots::default(),
            outline: Slots::default(),
            starts: Vec::new(),
        }
    }

    /// Changes tool and options, which makes everything anew.
    pub fn set(&mut self, tool: Tool, options: Options, chord: f64) {
        (self.tool, self.options, self.chord) = (tool, options, chord);
        self.stale = true;
    }

    /// The contour as it is described now.
    #[must_use]
    pub fn described(&self) -> &ContourBuilder {
        &self.described
    }

    /// Moves the start of the contour [mm], and with it the end of a closed one.
    pub fn move_start(&mut self, to: DVec2) {
        self.described.move_start(to);
        let last = self.described.len().saturating_sub(1);
        if self.closed {
            self.move_end(last, to);
        } else {
            self.refresh_around(0);
        }
    }

    /// Moves a point of a segment [mm]: the end of anything but a spline, index 0, the centre of
    /// an arc or an involute, index 1, or a type point of a spline, its start not counted. The end of a closed contour
    /// takes its start along.
    ///
    /// # Errors
    /// [`EditError`], where there is no such point.
    pub fn move_point(&mut self, segment: usize, index: usize, to: DVec2) -> Result<(), EditError> {
        let shape = self.described.shape_mut(segment).ok_or(EditError::NoSegment)?;
        match shape {
            Shape::Arc { center, .. } | Shape::Involute { center, .. } if index == 1 => {
                *center = to;
                self.refresh_around(segment);
            }
            Shape::Line { .. }
            | Shape::Arc { .. }
            | Shape::ArcByRadius { .. }
            | Shape::Involute { .. } => {
                if index > 0 {
                    return Err(EditError::NoPoint);
                }
                self.move_end(segment, to);
            }
            Shape::Spline(SplineShape { points, .. }) | Shape::Bezier { controls: points } => {
                let count = points.len();
                let point = points.get_mut(index).ok_or(EditError::NoPoint)?;
                *point = to;
                if index + 1 == count {
                    self.move_end(segment, to);
                } else {
                    self.edit(&mut |local, _| local.move_type_point(segment, index + 1, to));
                }
            }
        }
        Ok(())
    }

    /// Inserts a type point [mm] into a spline before the one at `index`; behind the last, where
    /// there are as many, it is the new end.
    ///
    /// # Errors
    /// [`EditError`], where there is no such place.
    pub fn insert_point(
        &mut self,
        segment: usize,
        index: usize,
        point: DVec2,
    ) -> Result<(), EditError> {
        let points = self.type_points(segment)?;
        if index > points.len() {
            return Err(EditError::NoPoint);
        }
        let inner = index < points.len();
        points.insert(index, point);
        if inner {
            self.edit(&mut |local, _| local.insert_type_point(segment, index + 1, point));
        } else {
            self.new_end(segment, point);
        }
        Ok(())
    }

    /// Removes a type point from a spline; without its last the one before is its end.
    ///
    /// # Errors
    /// [`EditError`], where there is no such point, or no other.
    pub fn remove_point(&mut self, segment: usize, index: usize) -> Result<(), EditError> {
        let points = self.type_points(segment)?;
        if index >= points.len() {
            return Err(EditError::NoPoint);
        }
        if points.len() == 1 {
            return Err(EditError::LastPoint);
        }
        points.remove(index);
        let end = points[points.len() - 1];
        if index < points.len() {
            self.edit(&mut |local, _| local.remove_type_point(segment, index + 1));
        } else {
            self.new_end(segment, end);
        }
        Ok(())
    }

    /// Changes all of a segment. Its new end is the start of the next, and the end of a closed
    /// contour takes its start along.
    ///
    /// # Errors
    /// [`EditError::NoSegment`].
    pub fn set_segment(&mut self, segment: usize, shape: Shape) -> Result<(), EditError> {
        let end = shape.end();
        let own = self.described.shape_mut(segment).ok_or(EditError::NoSegment)?;
        let is_spline = |shape: &Shape| matches!(shape, Shape::Spline(_) | Shape::Bezier { .. });
        let splines = [is_spline(&shape), is_spline(own)];
        *own = shape;
        if let Some(end) = end {
            self.take_start_along(segment, end);
        }
        if splines == [false, false] {
            self.refresh_around(segment);
        } else {
            self.stale = true;
        }
        Ok(())
    }

    /// Makes the polylines what the contour is now, and tells which vertices have changed since
    /// the last time.
    pub fn update(&mut self) -> Update {
        match &mut self.local {
            Some(local) if !self.stale => {
                let slots = [&mut self.path, &mut self.outline];
                if local.update(slots, &mut self.starts).is_err() {
                    self.rebuild();
                }
            }
            None if !self.stale => {}
            _ => self.rebuild(),
        }
        Update { path: self.path.take_changed(), outline: self.outline.take_changed() }
    }

    /// x and y of each vertex of the tool path [mm], as of the last update.
    #[must_use]
    pub fn path_points(&self) -> &[f64] {
        self.path.points()
    }

    /// Index of the first vertex of each piece of the tool path.
    #[must_use]
    pub fn path_starts(&self) -> &[u32] {
        &self.starts
    }

    /// x and y of each vertex of the contour [mm], as of the last update.
    #[must_use]
    pub fn outline_points(&self) -> &[f64] {
        self.outline.points()
    }

    /// The tool path of the contour as it is now, computed afresh, with all that is to be said about
    /// it.
    #[must_use]
    pub fn path(&self) -> ToolPath {
        let Built { contour, diagnostics } = self.described.clone().build(self.closed);
        let mut path = ToolPath { diagnostics, ..ToolPath::default() };
        if let Some(contour) = &contour {
            path.append(compensate_all(&[(contour, self.tool)], &self.options));
        }
        path
    }

    fn type_points(&mut self, segment: usize) -> Result<&mut Vec<DVec2>, EditError> {
        match self.described.shape_mut(segment) {
            Some(Shape::Spline(spline)) => Ok(&mut spline.points),
            Some(_) => Err(EditError::NotASpline),
            None => Err(EditError::NoSegment),
        }
    }

    /// Moves the end of a segment.
    fn move_end(&mut self, segment: usize, end: DVec2) {
        if let Some(shape) = self.described.shape_mut(segment) {
            match shape {
                Shape::Line { to }
                | Shape::Arc { to, .. }
                | Shape::ArcByRadius { to, .. }
                | Shape::Involute { to, .. } => {
                    *to = end;
                }
                Shape::Spline(SplineShape { points, .. }) | Shape::Bezier { controls: points } => {
                    if let Some(last) = points.last_mut() {
                        *last = end;
                    }
                }
            }
        }
        self.take_start_along(segment, end);
        self.refresh_around(segment);
    }

    /// A spline has got another end point.
    fn new_end(&mut self, segment: usize, end: DVec2) {
        self.take_start_along(segment, end);
        self.stale = true;
    }

    /// Lets a closed contour start where its last segment ends.
    fn take_start_along(&mut self, segment: usize, end: DVec2) {
        if self.closed && segment + 1 == self.described.len() {
            self.described.move_start(end);
        }
    }

    /// Takes over a change of a segment that is not a spline, or of the end of any.
    fn refresh_around(&mut self, segment: usize) {
        self.edit(&mut |local, described| local.refresh(described, segment));
    }

    /// Makes an edit where it is, or leaves it to the next update to make everything anew.
    fn edit(&mut self, edit: &mut dyn FnMut(&mut Local, &ContourBuilder) -> Result<(), NotLocal>) {
        if self.local.as_mut().is_none_or(|local| edit(local, &self.described).is_err()) {
            (self.local, self.stale) = (None, true);
        }
    }

    /// Makes everything anew.
    fn rebuild(&mut self) {
        (self.stale, self.local) = (false, None);
        let Built { contour, diagnostics } = self.described.clone().build(self.closed);
        self.starts.clear();
        let Some(contour) = contour else {
            self.show(&[], &[]);
            return;
        };
        let Options { gouge, spline, passes, .. } = self.options;
        let is_local = match gouge {
            GougePolicy::Report => spline == SplineMethod::Exact && passes == Passes::One,
            GougePolicy::Avoid => passes == Passes::One,
            GougePolicy::Stop => false,
        };
        // Given cubics have no type points to solve for, and a kink makes several segments of one;
        // involutes are followed as a whole.
        let has_given = contour.segments().iter().any(|segment| match &segment.curve {
            Curve::Spline(spline) => !spline.is_through_points(),
            Curve::Involute(_) => true,
            Curve::Line(_) | Curve::Arc(_) => false,
        });
        let is_local = is_local && !has_given && !looks_ahead(&contour, &self.options);
        if is_local && diagnostics.is_empty() {
            let slots = [&mut self.path, &mut self.outline];
            let local =
                Local::new(&contour, self.closed, self.tool, &self.options, self.chord, slots);
            if gouge == GougePolicy::Avoid {
                local.update_starts(&self.path, &mut self.starts);
            } else {
                self.starts.push(0);
            }
            self.local = Some(local);
            return;
        }
        let mut outline = Pen { chord: self.chord, vertices: Vec::new() };
        for Segment { curve, .. } in contour.segments() {
            outline.programmed(curve);
        }
        let path = compensate_all(&[(&contour, self.tool)], &self.options);
        let mut pen = Pen { chord: self.chord, vertices: Vec::new() };
        let mut end = None;
        for step in &path.moves {
            let start = step.curve.start();
            if end.is_none_or(|end: DVec2| end.distance(start) > 2.0 * MIN_LENGTH) {
                self.starts.push(u32::try_from(pen.vertices.len()).unwrap_or(u32::MAX));
                pen.vertices.push(start);
            }
            pen.curve(&step.curve);
            end = Some(step.curve.end());
        }
        self.show(&pen.vertices, &outline.vertices);
    }

    /// Shows polylines that are no blocks.
    fn show(&mut self, path: &[DVec2], outline: &[DVec2]) {
        for (slots, vertices) in [(&mut self.path, path), (&mut self.outline, outline)] {
            slots.clear();
            if !vertices.is_empty() {
                slots.push(vertices);
            }
        }
    }
}
