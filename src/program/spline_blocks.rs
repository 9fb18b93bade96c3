//! Blocks of splines that go on over several of them, and the words that come between.

use glam::DVec3;

use super::axes::Axes;
use super::bezier::Chained;
use super::block::Block;
use super::g_words::Motion;
use super::interpret::Interpreter;
use super::modes::Demands;
use super::number::whole;
use super::pending_spline::{Added, Boundary, Family, Finished, PendingSpline};
use super::type_points::{SplineWord, spline_word};
use super::words::Words;
use crate::contour::Attributes;
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Decimal, MIN_LENGTH};

/// What is kept from one block of curves to the next.
#[derive(Debug, Default)]
pub(super) struct Curves {
    /// The end of the G05 curve before.
    pub(super) chained: Option<Chained>,
    /// The tangent that G06.1 gives the start of its spline.
    tangent: Option<glam::DVec2>,
    /// How SINUMERIK splines begin and end.
    pub(super) boundaries: [Boundary; 2],
}

impl Interpreter {
    /// G05 and its namesakes, told apart by the words beside them.
    pub(super) fn spline_family(
        &mut self,
        block: &Block,
        tenths: u32,
        column: u32,
        words: &mut Words,
        demands: &mut Demands,
    ) {
        let motion = match spline_word(tenths, words) {
            SplineWord::TypePoint => Motion::TypePoints,
            SplineWord::Cubic => Motion::Cubic,
            SplineWord::Quadratic => Motion::Quadratic,
            SplineWord::Controls => Motion::Controls,
            SplineWord::Knots => Motion::Knots,
            SplineWord::Through => {
                self.start_tangent(words);
                Motion::Through
            }
            SplineWord::ControlsEnd => {
                match &mut self.spline {
                    Some(spline) if spline.motion == Motion::Controls => spline.closed = true,
                    _ => {
                        let at = block.origin_at(column);
                        let hint = "begin the curve with G05.2";
                        self.error("nurbs-not-open", "G05.3 without G05.2", at, hint);
                    }
                }
                self.modal.motion = None;
                return;
            }
            SplineWord::Setting(what) => {
                words.take_all("PQR");
                self.note(block, column, what);
                return;
            }
            SplineWord::Smoothing(what) => {
                words.take_all("PQRXYZ");
                self.report.warning(
                    "left-out",
                    format!("{what} is left out"),
                    block.origin_at(column),
                    "the path is the one programmed, not smoothed",
                );
                return;
            }
            SplineWord::NotSupported(what) => Motion::NotSupported(what),
        };
        if self.rules.is_strict && self.course.switched().is_some() {
            // LinuxCNC stops at some, and follows the others without compensation.
            let message = "a spline may not be while compensation is on";
            self.refuse(message, block.origin_at(column));
        }
        demands.motion = Some(motion);
        self.modal.motion = Some(motion);
        self.modal.cycle.end();
    }

    /// The axis words beside G06.1 are a vector.
    fn start_tangent(&mut self, words: &mut Words) {
        let vector = ['X', 'Y', 'Z'].map(|letter| words.take(letter).map_or(0.0, |w| w.value));
        let at = self.modal.frame.unmap(self.modal.position);
        let ahead = self.modal.frame.map(at + DVec3::from(vector)) - self.modal.position;
        let flat = self.modal.plane.split(ahead).0;
        // In a frame that turns, the way there and back leaves a rounding.
        self.curves.tangent = (flat.length() > MIN_LENGTH).then_some(flat);
        self.finish_spline();
    }

    /// Whether the block cannot continue the spline before it.
    pub(super) fn ends_spline(&self, demands: &Demands, words: &Words) -> bool {
        let Some(spline) = &self.spline else { return false };
        demands.no_move
            || demands.acts
            || demands.compensation.is_some()
            || words.has_any("D")
            || self.modal.motion != Some(spline.motion)
    }

    pub(super) fn finish_spline(&mut self) {
        if let Some(spline) = self.spline.take() {
            self.add_spline(spline);
        }
        self.release_words(false);
    }

    /// The curve that came of a spline.
    fn add_spline(&mut self, spline: PendingSpline) {
        let unclosed = spline.motion == Motion::Controls && !spline.closed;
        let Some(finished) = spline.finish(self.rules) else { return };
        let Finished { start, shape, attributes, origins, fault, within } = finished;
        let origin = attributes.origin;
        if let Some(fault) = fault {
            let hint = "a straight line stands in its place";
            self.error("bad-nurbs", fault.to_string(), origin, hint);
        } else if unclosed {
            let hint = "end it with G05.3; it ends here all the same";
            self.error("nurbs-not-closed", "the curve of G05.2 has no end", origin, hint);
        }
        if let Some(tolerance) = within {
            let message = format!(
                "the curve is read as cubics within {} mm of it",
                Decimal::new(tolerance, 9)
            );
            self.report.push(Diagnostic::info("approximated", message).with_origin(origin));
        }
        self.course.curve(start, shape, attributes, &mut self.report);
        self.course.name_blocks(&origins);
    }

    /// Words that move nothing. While it is open whether the spline goes on, they wait for that.
    pub(super) fn pass_on(&mut self, words: String, only_comments: bool, origin: Origin) {
        if words.is_empty() {
            return;
        }
        if self.spline.as_ref().is_some_and(|spline| !spline.is_empty()) {
            self.waiting.push((words, only_comments, origin));
        } else {
            self.course.words(words, origin);
        }
    }

    /// The words that waited: after the spline, or before it where it goes on.
    fn release_words(&mut self, goes_on: bool) {
        for (words, only_comments, origin) in std::mem::take(&mut self.waiting) {
            if goes_on && !only_comments {
                self.report.warning(
                    "words-in-spline",
                    "words between type points act before them",
                    origin,
                    "put them before or after the spline",
                );
            }
            self.course.words(words, origin);
        }
    }

    /// A block of a spline that goes on over several.
    pub(super) fn spline_point(
        &mut self,
        block: &Block,
        motion: Motion,
        stated: bool,
        words: &mut Words,
    ) {
        match motion {
            Motion::Controls => self.control_point(block, stated, words),
            Motion::Knots => self.knot(block, stated, words),
            _ => {
                let [weight, interval, degree] = ['w', 'l', 'd'].map(|letter| words.take(letter));
                let is_controls = motion == Motion::Named(Family::Controls);
                let Some((axes, to)) = self.flat_target(block, words) else { return };
                if !is_controls {
                    self.type_point(block, motion, &axes, to);
                    return;
                }
                let spline = self.pending(block, motion);
                match degree.map(|word| whole(word.value)) {
                    Some(Some(degree @ 1..=3)) => spline.order = degree as usize + 1,
                    None => {}
                    Some(_) => spline.order = 0,
                }
                spline.knots.extend(interval.map(|word| word.value));
                self.add_control(block, weight.map_or(1.0, |word| word.value), &axes, to);
            }
        }
    }

    /// The spline that the block belongs to.
    fn pending(&mut self, block: &Block, motion: Motion) -> &mut PendingSpline {
        let from = self.modal.plane.split(self.modal.position).0;
        // What else belongs to it comes with its first point.
        let attributes = Attributes::at(block.origin());
        let (boundaries, heading) = (self.curves.boundaries, self.course.heading);
        let tangent = self.curves.tangent.take();
        self.spline.get_or_insert_with(|| {
            let mut spline = PendingSpline::new(motion, from, attributes);
            spline.boundaries = boundaries;
            spline.tangents[0] = match motion {
                Motion::Through => tangent,
                Motion::Named(_) => heading,
                _ => None,
            };
            spline
        })
    }

    /// G05.2: the weight of the start and the order, or a control point.
    fn control_point(&mut self, block: &Block, stated: bool, words: &mut Words) {
        if !stated && !words.has_any("XYZPL") {
            return;
        }
        let [weight, order] = ['P', 'L'].map(|letter| words.take(letter));
        let target = self.flat_target(block, words);
        let spline = self.pending(block, Motion::Controls);
        if let Some(order) = order {
            // LinuxCNC takes no order below the third for what it says.
            spline.order = whole(order.value).map_or(0, |order| order.max(3) as usize);
        }
        let empty = spline.is_empty();
        match (target, weight) {
            (Some((axes, to)), _) => {
                self.add_control(block, weight.map_or(1.0, |word| word.value), &axes, to);
            }
            (None, Some(weight)) if empty => spline.weights[0] = weight.value,
            (None, Some(weight)) => {
                let at = block.origin_at(weight.column);
                let hint = "only the first control point, the start, has none";
                self.error("bad-nurbs", "a weight without a control point", at, hint);
            }
            (None, None) => {}
        }
    }

    /// G06.2: a control point with its knot, or one of the knots at the end.
    fn knot(&mut self, block: &Block, stated: bool, words: &mut Words) {
        if !stated && !words.has_any("XYZKR") {
            return;
        }
        let [order, knot, weight] = ['P', 'K', 'R'].map(|letter| words.take(letter));
        // How LinuxCNC is to keep the feed along the curve.
        words.take('Q');
        let weight = weight.map_or(1.0, |word| word.value);
        let knot = knot.map(|word| word.value);
        let target = self.flat_target(block, words);
        let first = self.spline.is_none();
        let bare = target.is_none();
        match target {
            Some((axes, to)) if first => {
                // The first control point is where the tool is, or it goes there.
                if self.modal.position.distance(to) > MIN_LENGTH {
                    self.report.warning(
                        "nurbs-start",
                        "the curve does not start where the tool is",
                        block.start(),
                        "a straight line leads to its first control point",
                    );
                    let attributes = self.attributes(block, false, to);
                    self.line(&axes, to, attributes);
                }
                self.arrive(&axes, to);
            }
            Some((axes, to)) => self.add_control(block, weight, &axes, to),
            None => {}
        }
        let spline = self.pending(block, Motion::Knots);
        if first {
            spline.weights[0] = weight;
            spline.order = order.map_or(4, |word| whole(word.value).unwrap_or(0) as usize);
            spline.knots.push(knot.unwrap_or(f64::NAN));
        } else {
            spline.knots.extend(knot);
            spline.closing += usize::from(bare && knot.is_some());
            if spline.closing == spline.order {
                self.finish_spline();
            }
        }
    }

    fn add_control(&mut self, block: &Block, weight: f64, axes: &Axes, to: DVec3) {
        let attributes = self.attributes(block, false, to);
        self.release_words(true);
        if let Some(spline) = &mut self.spline {
            spline.add_control(attributes.plane.split(to).0, weight, attributes);
        }
        self.arrive(axes, to);
    }

    /// A point that the curve passes.
    pub(super) fn type_point(&mut self, block: &Block, motion: Motion, axes: &Axes, to: DVec3) {
        let plane = self.modal.plane;
        let [first, second, _] = plane.axes();
        if axes.words[first].or(axes.words[second]).is_none() {
            return;
        }
        let attributes = self.attributes(block, false, to);
        let spline = self.pending(block, motion);
        let feed = spline.feed();
        let is_first = spline.is_empty();
        let added = spline.add(plane.split(to).0, attributes);
        match added {
            Added::Point if !is_first && changes(feed, &attributes) => self.report.warning(
                "feed-in-spline",
                "the feed changes within a spline",
                block.start(),
                "the spline runs at the feed of its first block; end it with a repeated point to \
                 change the feed",
            ),
            Added::Point | Added::Repeated => {}
            Added::Corner(ended) => {
                self.add_spline(*ended);
                self.release_words(false);
            }
        }
        self.release_words(true);
        self.arrive(axes, to);
    }
}

/// Whether the feed in the attributes is another than that before.
fn changes(feed: Option<f64>, attributes: &Attributes) -> bool {
    feed.is_some() && feed != attributes.feed
}
