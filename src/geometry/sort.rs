//! Sorting, in little code.
//!
//! The standard library's sorts are quicker still on long lists, but each type sorted takes three
//! kilobytes of WebAssembly; these take a few hundred bytes.

/// Sorts a list by a key, and keeps the order of equal ones.
///
/// For short lists, and for long ones that are nearly in order: others take a time that grows
/// with the square of their length.
pub fn sort_short<T, K: PartialOrd>(items: &mut [T], key: impl Fn(&T) -> K) {
    for i in 1..items.len() {
        let mut at = i;
        while at > 0 && key(&items[at - 1]) > key(&items[at]) {
            items.swap(at - 1, at);
            at -= 1;
        }
    }
}

/// Sorts a list of any length, where `before` tells which of two items comes first; equal ones come
/// in any order.
///
/// Heap sort: the largest of those that are left, on top of a heap, goes behind them.
pub fn sort_long<T>(items: &mut [T], before: impl Fn(&T, &T) -> bool) {
    let mut left = items.len();
    let mut root = left / 2;
    while left > 1 {
        if root > 0 {
            root -= 1;
        } else {
            left -= 1;
            items.swap(0, left);
        }
        let mut at = root;
        while 2 * at + 1 < left {
            let mut child = 2 * at + 1;
            if child + 1 < left && before(&items[child], &items[child + 1]) {
                child += 1;
            }
            if !before(&items[at], &items[child]) {
                break;
            }
            items.swap(at, child);
            at = child;
        }
    }
}

/// Sorts indices by what each has, and those that have the same by themselves.
#[inline(never)]
pub fn sort_pairs(list: &mut [(u32, usize)]) {
    sort_long(list, |a, b| a < b);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers in no order, some of them equal.
    fn mixed(count: u32) -> Vec<u32> {
        (0..count).map(|i| i.wrapping_mul(2_654_435_761) % 97).collect()
    }

    #[test]
    fn long_lists_are_sorted() {
        for count in [0, 1, 2, 3, 10, 1000, 4097] {
            for mut items in [mixed(count), (0..count).collect(), (0..count).rev().collect()] {
                let mut expected = items.clone();
                expected.sort_unstable();
                sort_long(&mut items, |a, b| a < b);
                assert_eq!(items, expected, "{count} items");
            }
        }
    }

    #[test]
    fn lists_are_sorted_and_equals_keep_their_order() {
        let mut items = [(3, 'a'), (1, 'b'), (3, 'c'), (2, 'd'), (1, 'e')];
        sort_short(&mut items, |item| item.0);
        assert_eq!(items, [(1, 'b'), (1, 'e'), (2, 'd'), (3, 'a'), (3, 'c')], "sorted");
        sort_short(&mut items[..0], |item| item.0);
    }
}
