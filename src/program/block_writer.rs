//! Writing blocks: only what changes, in as few digits as it needs.

use glam::DVec2;

use super::number::push_scaled;

/// Decimals of a coordinate: 0.1 µm, finer than any machine.
const DECIMALS: usize = 4;

/// Units of the last decimal in a millimetre.
pub(super) const SCALE: f64 = 1e4;

/// Decimals of a feed in mm/min.
const FEED_DECIMALS: usize = 3;

/// A point in units of the last decimal.
pub(super) fn units(point: DVec2) -> [i64; 2] {
    // Coordinates are at most 1e7 mm, and casts saturate.
    #[expect(clippy::cast_possible_truncation, reason = "at most 1e13")]
    [point.x, point.y].map(|value| (value * SCALE).round() as i64)
}

/// A program as it is written, with the modes of the control that will read it.
#[derive(Debug)]
pub(super) struct BlockWriter {
    text: String,
    /// Where the control is, in units of the last decimal.
    at: [i64; 3],
    /// Whether X and Y were ever written.
    stated: bool,
    /// The motion word in effect.
    motion: Option<char>,
    /// The F word in effect, and the one asked for: mm/min in units of the last decimal.
    feed: [Option<i64>; 2],
}

impl BlockWriter {
    /// A program that begins with the block `header`.
    pub(super) fn new(header: &str) -> Self {
        let text = format!("{header}\n");
        Self { text, at: [0; 3], stated: false, motion: None, feed: [None; 2] }
    }

    pub(super) fn finish(self) -> String {
        self.text
    }

    /// Where the control is in the plane.
    pub(super) fn position(&self) -> [i64; 2] {
        [self.at[0], self.at[1]]
    }

    /// Makes the next block say X and Y, even where they seem not to change.
    pub(super) fn state_position(&mut self) {
        self.stated = false;
    }

    /// Asks for a feed [mm/s] from the next feed move on.
    pub(super) fn set_feed(&mut self, feed: f64) {
        #[expect(clippy::cast_possible_truncation, reason = "casts saturate")]
        let scaled = (feed * 60.0 * 1e3).round() as i64;
        self.feed[1] = Some(scaled.max(1));
    }

    pub(super) fn has_feed(&self) -> bool {
        self.feed[1].is_some()
    }

    /// Words as they are.
    pub(super) fn words(&mut self, words: &str) {
        // They hold a motion word only where they state the first position.
        if let [b'G', motion @ (b'0' | b'1'), b' ', ..] = words.as_bytes() {
            self.motion = Some(char::from(*motion));
        }
        // Coordinate systems: the same numbers are another place now.
        if words.as_bytes().windows(2).any(|pair| pair == b"G5") {
            self.stated = false;
        }
        self.text.push_str(words);
        self.text.push('\n');
    }

    pub(super) fn rapid(&mut self, to: [i64; 2], z: i64) {
        self.block('0', to, z, None);
    }

    pub(super) fn line(&mut self, to: [i64; 2], z: i64) {
        self.block('1', to, z, None);
    }

    /// An arc to `to` about the point that is `center` away from where the control is; a full
    /// circle where `to` is where the control is.
    pub(super) fn arc(&mut self, clockwise: bool, to: [i64; 2], z: i64, center: [i64; 2]) {
        self.block(if clockwise { '2' } else { '3' }, to, z, Some(center));
    }

    fn block(&mut self, motion: char, [x, y]: [i64; 2], z: i64, center: Option<[i64; 2]>) {
        let to = [x, y, z];
        let in_plane = self.at[..2] != to[..2] || center.is_some();
        // The first block in the plane says both coordinates, as does a full circle.
        let both = !self.stated && (in_plane || motion == '0' && self.at == to)
            || center.is_some() && self.at[..2] == to[..2];
        if self.at == to && !both {
            return;
        }
        let mut words = WordsOfBlock(&mut self.text);
        if self.motion != Some(motion) {
            words.start();
            words.0.extend(['G', motion]);
            self.motion = Some(motion);
        }
        for (i, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
            if self.at[i] != to[i] || i < 2 && both {
                words.push(letter, to[i], DECIMALS);
            }
        }
        for (letter, value) in ['I', 'J'].into_iter().zip(center.into_iter().flatten()) {
            if value != 0 {
                words.push(letter, value, DECIMALS);
            }
        }
        let [in_effect, wanted] = self.feed;
        if motion != '0'
            && wanted != in_effect
            && let Some(feed) = wanted
        {
            words.push('F', feed, FEED_DECIMALS);
            self.feed[0] = wanted;
        }
        self.text.push('\n');
        self.stated |= in_plane || both;
        self.at = to;
    }
}

/// A block in the making.
struct WordsOfBlock<'a>(&'a mut String);

impl WordsOfBlock<'_> {
    /// A space before every word but the first.
    fn start(&mut self) {
        if !self.0.ends_with('\n') {
            self.0.push(' ');
        }
    }

    fn push(&mut self, letter: char, scaled: i64, decimals: usize) {
        self.start();
        self.0.push(letter);
        push_scaled(self.0, scaled, decimals);
    }
}
