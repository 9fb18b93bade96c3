//! Words that a path passes on, read once more.

use crate::contour::ToolPath;
use crate::geometry::parse_decimal;
use crate::motion::Limits;

/// Calls `visit` with the letter and the number of each word of a text, comments apart.
pub(super) fn for_words(text: &str, visit: &mut dyn FnMut(u8, f64)) {
    let mut comment = false;
    for word in text.split(' ') {
        comment |= word.starts_with('(');
        if let (false, Some(&letter)) = (comment, word.as_bytes().first())
            && let Some(value) = word.get(1..).and_then(parse_decimal)
        {
            visit(letter, value);
        }
        comment &= !word.ends_with(')');
    }
}

/// The tools of a path by number, each with the index of the move from which on it is in the spindle:
/// from M6 on where the program has that word, else from the T word on.
#[must_use]
pub fn tool_changes(path: &ToolPath) -> Vec<(usize, f64)> {
    let (mut called, mut changed) = (Vec::new(), Vec::new());
    let mut tool = None;
    for words in &path.words {
        let mut command = 0.0;
        for_words(&words.words, &mut |letter, value| match letter {
            b'T' => {
                tool = Some(value);
                called.push((words.before, value));
            }
            b'M' => {
                command = value;
                if let (6.0, Some(number)) = (value, tool) {
                    changed.push((words.before, number));
                }
            }
            b'Q' if command == 61.0 => changed.push((words.before, value)),
            _ => {}
        });
    }
    if changed.is_empty() { called } else { changed }
}

/// The widest deviation that corners are rounded within [mm]: that of the limits, or of a G64 P.
pub(super) fn widest_deviation(path: &ToolPath, limits: &Limits) -> f64 {
    let mut widest = limits.corner_deviation;
    for words in &path.words {
        let mut command = 0.0;
        for_words(&words.words, &mut |letter, value| match letter {
            b'G' | b'M' => command = value,
            b'P' if command == 64.0 => widest = widest.max(value),
            _ => {}
        });
    }
    widest
}
