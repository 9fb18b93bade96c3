//! Blocks of type points: the spline that they make, and the words that come between them.

use super::axes::Axes;
use super::block::Block;
use super::g_words::Motion;
use super::interpret::Interpreter;
use super::modes::Demands;
use super::type_points::{Added, PendingSpline, SplineWord, spline_word};
use super::words::Words;
use crate::contour::Attributes;
use crate::diagnostic::{Diagnostic, Origin};

use glam::DVec3;

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
            SplineWord::Setting(what) => {
                words.take_all("PQR");
                let message = format!("{what} is left out; it does not change the path");
                let at = block.origin_at(column);
                self.report.push(Diagnostic::info("noted", message).with_origin(at));
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
        demands.motion = Some(motion);
        self.modal.motion = Some(motion);
        self.modal.cycle.end();
    }

    /// Whether the block cannot continue the spline before it.
    pub(super) fn ends_spline(&self, demands: &Demands, words: &Words) -> bool {
        demands.no_move
            || demands.acts
            || demands.compensation.is_some()
            || words.has_any("D")
            || self.modal.motion != Some(Motion::TypePoints)
    }

    pub(super) fn finish_spline(&mut self) {
        if let Some(spline) = self.spline.take() {
            self.make_spline(spline);
        }
        self.release_words(false);
    }

    fn make_spline(&mut self, spline: PendingSpline) {
        if let Some((start, shape, attributes, origins)) = spline.finish() {
            self.course.curve(start, shape, attributes, &mut self.report);
            self.course.name_blocks(&origins);
        }
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

    /// G05 with axes alone.
    pub(super) fn type_point(&mut self, block: &Block, axes: &Axes, to: DVec3) {
        let plane = self.modal.plane;
        let [first, second, normal] = plane.axes();
        let ((from, height), (end, above)) = (plane.split(self.modal.position), plane.split(to));
        if let Some(word) = axes.words[normal]
            && above != height
        {
            self.error(
                "z-in-spline",
                "a spline through type points has one height",
                block.origin_at(word.column),
                &format!(
                    "the {} word has no effect; move along it before or after the spline",
                    word.letter
                ),
            );
        }
        if axes.words[first].or(axes.words[second]).is_none() {
            return;
        }
        let to = plane.place(end, height);
        let attributes = self.attributes(block, false, to);
        let spline = self.spline.get_or_insert_with(|| PendingSpline::new(from, attributes));
        let feed = spline.feed();
        let added = spline.add(end, attributes);
        match added {
            Added::Point if changes(feed, &attributes) => self.report.warning(
                "feed-in-spline",
                "the feed changes within a spline",
                block.start(),
                "the spline runs at the feed of its first block; end it with a repeated point to \
                 change the feed",
            ),
            Added::Point | Added::Repeated => {}
            Added::Corner(ended) => {
                self.make_spline(ended);
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
