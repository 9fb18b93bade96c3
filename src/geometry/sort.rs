//! Sorting short lists.

/// Sorts a list by a key, and keeps the order of equal ones.
///
/// For short lists, and for long ones that are nearly in order: others take a time that grows
/// with the square of their length. The standard library's sort has no such limit, but each type
/// sorted takes several kilobytes of WebAssembly.
pub fn sort_short<T, K: PartialOrd>(items: &mut [T], key: impl Fn(&T) -> K) {
    for i in 1..items.len() {
        let mut at = i;
        while at > 0 && key(&items[at - 1]) > key(&items[at]) {
            items.swap(at - 1, at);
            at -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_sorted_and_equals_keep_their_order() {
        let mut items = [(3, 'a'), (1, 'b'), (3, 'c'), (2, 'd'), (1, 'e')];
        sort_short(&mut items, |item| item.0);
        assert_eq!(items, [(1, 'b'), (1, 'e'), (2, 'd'), (3, 'a'), (3, 'c')], "sorted");
        sort_short(&mut items[..0], |item| item.0);
    }
}
