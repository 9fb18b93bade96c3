//! Reads contours from numbers; the layout is that of `ContourRecords` in `types.d.ts`.

use glam::DVec2;

use super::argument::BadArgument;
use super::numbering::Numbering;
use crate::contour::{Attributes, Built, ContourBuilder, Lead, Shape, Side, SplineShape};
use crate::diagnostic::Origin;
use crate::geometry::Parameter;

/// A contour as described, and what it says about its tool.
#[derive(Debug)]
pub(super) struct Described {
    builder: ContourBuilder,
    closed: bool,
    lead_in: Option<DVec2>,
    lead_out: Option<DVec2>,
    /// Number of its first segment.
    first: u32,
    pub(super) side: Option<Side>,
    /// Tool radius [mm].
    pub(super) radius: Option<f64>,
}

impl Described {
    fn new(start: DVec2, closed: bool, first: u32) -> Self {
        let builder = ContourBuilder::new(start);
        let (lead_in, lead_out, side, radius) = (None, None, None, None);
        Self { builder, closed, lead_in, lead_out, first, side, radius }
    }

    fn add(&mut self, shape: Shape, number: u32) {
        self.builder.segment(shape, Attributes::at(Origin::Segment(number)));
    }

    /// Makes the contour.
    pub(super) fn build(self) -> Built {
        let (builder, closed) = self.into_builder();
        builder.build(closed)
    }

    /// What is described, and whether it is closed; its leads come from its first and its last
    /// segment.
    pub(super) fn into_builder(mut self) -> (ContourBuilder, bool) {
        let count = u32::try_from(self.builder.len()).unwrap_or(u32::MAX);
        let lead =
            |number, point| Lead { point, attributes: Attributes::at(Origin::Segment(number)) };
        if let Some(point) = self.lead_in {
            self.builder.lead_in(lead(self.first, point));
        }
        if let Some(point) = self.lead_out {
            self.builder.lead_out(lead(self.first + count.saturating_sub(1), point));
        }
        (self.builder, self.closed)
    }
}

/// All contours of `records`, their segments numbered through.
pub(super) fn read_contours(records: &[f64]) -> Result<(Vec<Described>, Numbering), BadArgument> {
    let mut reader = Reader { records, at: 0 };
    let mut contours: Vec<Described> = Vec::new();
    let mut firsts = Vec::new();
    let mut segments = 0;
    while reader.at < records.len() {
        let start_of_record = reader.at;
        let kind = reader.number()?;
        if kind == 0.0 {
            firsts.push(segments);
            let start = reader.point()?;
            contours.push(Described::new(start, reader.truth()?, segments));
            continue;
        }
        let Some(contour) = contours.last_mut() else {
            return Err(bad(start_of_record, "be 0: a contour begins with its start"));
        };
        if let Some(shape) = reader.shape(kind)? {
            contour.add(shape, segments);
            segments += 1;
        } else if kind == 4.0 {
            contour.lead_in = Some(reader.point()?);
        } else if kind == 5.0 {
            contour.lead_out = Some(reader.point()?);
        } else if kind == 6.0 {
            contour.side = Some(if reader.truth()? { Side::Right } else { Side::Left });
        } else if kind == 7.0 {
            contour.radius = Some(reader.number()?);
        } else {
            return Err(bad(start_of_record, "be the kind of a record, from 0 to 9"));
        }
    }
    Ok((contours, Numbering::of(firsts)))
}

/// The segment of one record.
pub(super) fn read_segment(record: &[f64]) -> Result<Shape, BadArgument> {
    let mut reader = Reader { records: record, at: 0 };
    let kind = reader.number()?;
    match reader.shape(kind)? {
        Some(shape) if reader.at == record.len() => Ok(shape),
        _ => Err(bad(0, "be the record of one segment")),
    }
}

/// What the flags of a spline add up from.
mod flag {
    pub(super) const START_TANGENT: u8 = 1;
    pub(super) const END_TANGENT: u8 = 2;
    pub(super) const SMOOTH: u8 = 4;
    pub(super) const PERIODIC: u8 = 8;
    pub(super) const NOT_PERIODIC: u8 = 16;
    pub(super) const CENTRIPETAL: u8 = 32;
    pub(super) const ALL: u8 = 63;
}

struct Reader<'a> {
    records: &'a [f64],
    at: usize,
}

impl Reader<'_> {
    /// The segment of a record of this kind, if it is one.
    fn shape(&mut self, kind: f64) -> Result<Option<Shape>, BadArgument> {
        Ok(Some(if kind == 1.0 {
            Shape::Line { to: self.point()? }
        } else if kind == 2.0 || kind == 9.0 {
            let (to, center) = (self.point()?, self.point()?);
            let radius = if kind == 9.0 { self.number()? } else { 0.0 };
            let clockwise = self.truth()?;
            if kind == 2.0 {
                Shape::Arc { to, center, clockwise }
            } else {
                Shape::Involute { to, center, radius, clockwise }
            }
        } else if kind == 3.0 {
            Shape::Spline(self.spline()?)
        } else if kind == 8.0 {
            Shape::Bezier { controls: self.points()? }
        } else {
            return Ok(None);
        }))
    }

    fn spline(&mut self) -> Result<SplineShape, BadArgument> {
        let flags = self.flags()?;
        let is = |flag| flags & flag != 0;
        let start_tangent = self.tangent(is(flag::START_TANGENT))?;
        let end_tangent = self.tangent(is(flag::END_TANGENT))?;
        let points = self.points()?;
        let periodic = match (is(flag::PERIODIC), is(flag::NOT_PERIODIC)) {
            (true, _) => Some(true),
            (false, true) => Some(false),
            (false, false) => None,
        };
        let parameter =
            if is(flag::CENTRIPETAL) { Parameter::Centripetal } else { Parameter::Chord };
        let smooth = is(flag::SMOOTH);
        Ok(SplineShape { points, start_tangent, end_tangent, smooth, periodic, parameter })
    }

    fn number(&mut self) -> Result<f64, BadArgument> {
        let at = self.at;
        self.at += 1;
        match self.records.get(at) {
            Some(value) if value.is_finite() => Ok(*value),
            Some(_) => Err(bad(at, "be a finite number")),
            None => Err(bad(at, "be there: the last record is cut short")),
        }
    }

    fn point(&mut self) -> Result<DVec2, BadArgument> {
        Ok(DVec2::new(self.number()?, self.number()?))
    }

    fn truth(&mut self) -> Result<bool, BadArgument> {
        let at = self.at;
        let value = self.number()?;
        if value == 0.0 || value == 1.0 { Ok(value == 1.0) } else { Err(bad(at, "be 0 or 1")) }
    }

    fn flags(&mut self) -> Result<u8, BadArgument> {
        let at = self.at;
        let value = self.number()?;
        // The cast saturates, so nothing but a whole number in the range equals it.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let flags = value as u8;
        if f64::from(flags) == value && flags <= flag::ALL {
            Ok(flags)
        } else {
            Err(bad(at, "be a sum of flags"))
        }
    }

    fn points(&mut self) -> Result<Vec<DVec2>, BadArgument> {
        let count = self.count()?;
        let mut points = Vec::with_capacity(count);
        for _ in 0..count {
            points.push(self.point()?);
        }
        Ok(points)
    }

    /// A count of points that are there.
    fn count(&mut self) -> Result<usize, BadArgument> {
        let at = self.at;
        let value = self.number()?;
        let most = (self.records.len() - self.at) / 2;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let count = value as usize;
        if count as f64 == value && count <= most {
            Ok(count)
        } else {
            Err(bad(at, "be the number of points that follow"))
        }
    }

    /// A tangent, which takes its two numbers whether it is given or not.
    fn tangent(&mut self, given: bool) -> Result<Option<DVec2>, BadArgument> {
        let at = self.at;
        let tangent = self.point()?;
        if !given {
            return Ok(None);
        }
        // Scaled, since the square of a tiny or a huge length is no number.
        let largest = tangent.abs().max_element();
        if largest == 0.0 {
            return Err(bad(at, "be a tangent with a length"));
        }
        Ok(Some(tangent / largest))
    }
}

fn bad(at: usize, must: &str) -> BadArgument {
    BadArgument::new(format!("[{at}]"), must)
}

#[cfg(test)]
mod tests {
    use super::*;

    const START: [f64; 4] = [0.0, 0.0, 0.0, 0.0];

    fn described(records: &[&[f64]]) -> Vec<Described> {
        read_contours(&records.concat()).expect("the records are right").0
    }

    fn fault(records: &[&[f64]]) -> BadArgument {
        read_contours(&records.concat()).expect_err("the records are wrong")
    }

    #[test]
    fn every_record_is_read() {
        let contours = described(&[
            &[0.0, 1.0, 2.0, 0.0],
            &[6.0, 1.0],
            &[7.0, 3.5],
            &[4.0, -5.0, 2.0],
            &[1.0, 10.0, 2.0],
            &[2.0, 10.0, 12.0, 10.0, 7.0, 1.0],
            &[3.0, 37.0, 1e-200, 0.0, 9.0, 9.0, 2.0, 12.0, 13.0, 14.0, 12.0],
            &[5.0, 20.0, 12.0],
            &[0.0, 0.0, 0.0, 1.0],
        ]);
        assert_eq!(contours.len(), 2, "contours");
        let [first, second] = contours.try_into().expect("there are two");
        assert_eq!((first.side, first.radius), (Some(Side::Right), Some(3.5)), "tool");
        assert_eq!((second.side, second.radius), (None, None), "tool");
        assert!(second.closed && !first.closed, "only the second is closed");
        let contour = first.build().contour.expect("it can be made");
        assert_eq!(contour.segments().len(), 3, "segments");
        assert_eq!(contour.start(), DVec2::new(1.0, 2.0), "start");
        assert_eq!(contour.end(), DVec2::new(14.0, 12.0), "end");
        let tangent = contour.segments()[2].curve.tangent(0.0);
        assert!(tangent.distance(DVec2::X) < 1e-12, "a tiny tangent counts: {tangent}");
        let lead = |lead: Option<&Lead>| lead.map(|lead| (lead.point, lead.attributes.origin));
        let segment = Origin::Segment;
        assert_eq!(lead(contour.lead_in()), Some((DVec2::new(-5.0, 2.0), segment(0))), "lead-in");
        assert_eq!(
            lead(contour.lead_out()),
            Some((DVec2::new(20.0, 12.0), segment(2))),
            "lead-out"
        );
    }

    #[test]
    fn a_wrong_number_is_named_by_its_index() {
        for (records, path) in [
            (&[&[1.0, 2.0, 3.0][..]][..], "[0]"),
            (&[&START, &[10.0, 1.0]], "[4]"),
            (&[&START, &[8.0, 2.0, 1.0, 1.0]], "[5]"),
            (&[&START, &[1.5, 1.0, 1.0]], "[4]"),
            (&[&START, &[1.0, f64::NAN, 1.0]], "[5]"),
            (&[&START, &[1.0, 1.0, f64::INFINITY]], "[6]"),
            (&[&START, &[1.0, 1.0]], "[6]"),
            (&[&[0.0, 1.0, 1.0, 2.0]], "[3]"),
            (&[&START, &[3.0, 64.0]], "[5]"),
            (&[&START, &[3.0, -1.0]], "[5]"),
            (&[&START, &[3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e300]], "[10]"),
            (&[&START, &[3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 1.0, 1.0]], "[10]"),
            (&[&START, &[3.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0]], "[6]"),
        ] {
            assert_eq!(fault(records).path, path, "{records:?}");
        }
    }
}
