//! Golden-section search.

/// Part of a bracket that each step keeps.
const KEEP: f64 = 0.618_033_988_749_894_8;

/// Where in `range` the function is least, of the places that golden-section search looks at; the
/// ends are among them.
///
/// The search ends after `steps`, or when what the function takes at the ends of the bracket is
/// less than `enough` above the least: two inner values alone may be equal on both sides of a sharp
/// minimum. A function with several minima gets one of them.
pub fn least(
    [mut from, mut to]: [f64; 2],
    steps: usize,
    enough: f64,
    value: &mut dyn FnMut(f64) -> f64,
) -> f64 {
    let (mut left, mut right) = (to - KEEP * (to - from), from + KEEP * (to - from));
    let (mut at_from, mut at_left) = (value(from), value(left));
    let (mut at_right, mut at_to) = (value(right), value(to));
    for _ in 0..steps {
        if at_from.max(at_to) - at_left.min(at_right) < enough {
            break;
        }
        if at_left < at_right {
            (to, at_to) = (right, at_right);
            (right, at_right) = (left, at_left);
            left = to - KEEP * (to - from);
            at_left = value(left);
        } else {
            (from, at_from) = (left, at_left);
            (left, at_left) = (right, at_right);
            right = from + KEEP * (to - from);
            at_right = value(right);
        }
    }
    let nearer = |a: (f64, f64), b: (f64, f64)| if b.1 < a.1 { b } else { a };
    nearer(nearer((from, at_from), (left, at_left)), nearer((to, at_to), (right, at_right))).0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sharp_minimum_between_two_equal_values_is_found() {
        let t = least([0.0, 1.0], 40, 1e-6, &mut |t: f64| (t - 0.5).abs());
        assert!((t - 0.5).abs() < 1e-6, "found at {t}");
    }

    #[test]
    fn a_smooth_minimum_and_one_at_an_end_are_found() {
        let t = least([0.0, 4.0], 40, 1e-12, &mut |t: f64| (t - 3.0).powi(2));
        assert!((t - 3.0).abs() < 1e-5, "found at {t}");
        assert_eq!(least([0.0, 4.0], 40, 1e-9, &mut |t: f64| t), 0.0, "the start itself");
    }
}
