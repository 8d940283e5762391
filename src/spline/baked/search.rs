//! A search without a jump, in binary trees whose leaves are the elements of a list.
//!
//! The root is node 1, and the children of node n are 2n and 2n + 1: a step doubles the number and adds
//! the result of a comparison. Leaves are numbered on, from 2^levels, and the elements have the last ones.
//! A key before that of the first element belongs to the leaf in front of it, which has none.
//!
//! (Eytzinger's order of a table: Khuong and Morin, *Array Layouts for Comparison-Based Searching*, 2017.)

/// How many levels of nodes there are for so many elements and the leaf before them.
pub(in crate::spline) const fn levels(count: usize) -> u32 {
    usize::BITS - count.leading_zeros()
}

/// The leaf of the first element.
pub(super) const fn first(count: usize) -> usize {
    (2 << levels(count)) - count
}

/// The element that begins to the right of a node, of so many.
pub(in crate::spline) const fn element(node: usize, count: usize) -> Option<usize> {
    let (level, levels) = (node.ilog2(), levels(count));
    let leaf = (2 * node + 1) << (levels - 1 - level);
    leaf.checked_sub(first(count))
}

/// The element that a key belongs to: the last one that begins there or before.
#[inline(always)]
pub(super) fn find<'a, K: Ord, T>(nodes: &[K], elements: &'a [T], key: &K) -> Option<&'a T> {
    let mut node = 1;
    for _ in 0..levels(elements.len()) {
        node = 2 * node + 1 - usize::from(nodes.get(node).is_none_or(|node| key < node));
    }
    elements.get(node.wrapping_sub(first(elements.len())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_element_that_begins_there_or_before() {
        for count in 1..70 {
            // Elements begin at 1, 3, 5 …
            let mut nodes = [0; 128];
            let nodes = &mut nodes[..1 << levels(count)];
            assert!(nodes.len() <= 2 * count);
            for (node, key) in nodes.iter_mut().enumerate().skip(1) {
                *key = element(node, count).map_or(0, |element| 2 * element + 1);
            }
            let elements: [usize; 70] = core::array::from_fn(|i| i);
            let elements = &elements[..count];
            assert_eq!(find(nodes, elements, &0), None);
            for key in 1..2 * count + 2 {
                let expected = ((key - 1) / 2).min(count - 1);
                assert_eq!(find(nodes, elements, &key), Some(&expected), "{key} of {count}");
            }
        }
    }
}
