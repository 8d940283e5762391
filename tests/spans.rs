//! Span lists against a bitmap: one bit for every cell of a small grid of parameters.
//!
//! A set of cells is a set of half-open intervals, so boolean operations on bits are the
//! regularised operations on intervals, and every list can be read back from the bits.

#![allow(clippy::unwrap_used, clippy::type_complexity)]

use proptest::collection::{btree_set, vec};
use proptest::prelude::*;
use scancsg::geom::{Ray, vec3};
use scancsg::solid::{Difference, Intersection, Shape, Slab, Solid, Union};
use scancsg::span::{Crossing, Face, Operation, Span, SpanList, merge};

/// Grid points are the whole numbers from `LOW` to `HIGH`; bit i is the cell from LOW + i on.
const LOW: i32 = -16;
const HIGH: i32 = 16;

type Interval = (i32, i32);

fn bits(intervals: &[Interval]) -> u32 {
    let cells = (LOW..HIGH).filter(|&c| intervals.iter().any(|&(a, b)| a <= c && c < b));
    cells.map(|c| 1u32 << (c - LOW)).sum()
}

/// The maximal runs of set bits.
fn intervals(bits: u32) -> Vec<Interval> {
    let inside = |t: i32| (LOW..HIGH).contains(&t) && bits >> (t - LOW) & 1 == 1;
    let starts = (LOW..=HIGH).filter(|&t| inside(t) && !inside(t - 1));
    let ends = (LOW..=HIGH).filter(|&t| !inside(t) && inside(t - 1));
    starts.zip(ends).collect()
}

/// Regularised lists of up to six intervals: any even number of different grid points, in order.
fn list() -> impl Strategy<Value = Vec<Interval>> {
    btree_set(LOW..=HIGH, 0..=12).prop_map(|points| {
        let points: Vec<i32> = points.into_iter().collect();
        points.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
    })
}

/// The intervals as spans; every crossing has a face of its own, counted from `first` on.
fn spans(intervals: &[Interval], first: u16) -> Vec<Span<f32>> {
    let at = |t: i32, face: usize| Crossing { t: t as f32, face: Face(first + face as u16) };
    let of =
        |(i, &(a, b)): (usize, &Interval)| Span { enter: at(a, 2 * i), exit: at(b, 2 * i + 1) };
    intervals.iter().enumerate().map(of).collect()
}

fn ends(spans: &[Span<f32>]) -> Vec<(f32, f32)> {
    spans.iter().map(|span| (span.enter.t, span.exit.t)).collect()
}

fn floats(intervals: &[Interval]) -> Vec<(f32, f32)> {
    intervals.iter().map(|&(a, b)| (a as f32, b as f32)).collect()
}

const OPERATIONS: [(Operation, fn(u32, u32) -> u32); 3] = [
    (Operation::UNION, |a, b| a | b),
    (Operation::INTERSECTION, |a, b| a & b),
    (Operation::DIFFERENCE, |a, b| a & !b),
];

fn merged(operation: Operation, parts: [&[Span<f32>]; 3]) -> Vec<Span<f32>> {
    let [below, left, right] = parts;
    let mut list = SpanList::<f32, 30>::new();
    let mut stack = list.stack();
    parts.concat().into_iter().for_each(|span| stack.push(span).unwrap());
    merge(operation, &mut stack, below.len(), below.len() + left.len()).unwrap();
    assert!(list.len() >= below.len(), "{operation:?} of {left:?} and {right:?} ate the stack");
    list.to_vec()
}

/// Everything that a merge promises, for one pair of lists and any spans below them.
fn check(below: &[Interval], left: &[Interval], right: &[Interval]) {
    let (low, l, r) = (spans(below, 200), spans(left, 0), spans(right, 100));
    for (operation, of_bits) in OPERATIONS {
        let stack = merged(operation, [&low, &l, &r]);
        let (untouched, result) = stack.split_at(low.len());
        assert_eq!(untouched, low, "{operation:?} touched the spans below");

        let want = floats(&intervals(of_bits(bits(left), bits(right))));
        assert_eq!(ends(result), want, "{operation:?} of {left:?} and {right:?}");

        for crossing in result.iter().flat_map(|span| [span.enter, span.exit]) {
            let operands = l.iter().chain(&r).flat_map(|span| [span.enter, span.exit]);
            assert!(
                operands.into_iter().any(|c| c == crossing),
                "{operation:?} of {left:?} and {right:?}: no operand has {crossing:?}"
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn merges_agree_with_bitmaps(below in list(), left in list(), right in list()) {
        check(&below, &left, &right);
    }
}

/// On five cells every pair of lists can be tried: each way two lists can share ends is among
/// them, also those that a random draw meets once in a million.
#[test]
fn all_pairs_of_lists_on_five_cells() {
    for (left, right) in (0..32u32).flat_map(|l| (0..32u32).map(move |r| (l, r))) {
        check(&[], &intervals(left << 14), &intervals(right << 14));
    }
}

/// The model has to tell wrong lists from right ones: touching intervals are one, and an empty
/// one is none.
#[test]
fn the_model_is_regularised() {
    assert_eq!(intervals(bits(&[(0, 2), (2, 3)])), [(0, 3)]);
    assert_eq!(intervals(bits(&[(0, 2), (1, 3), (5, 5), (6, 7)])), [(0, 3), (6, 7)]);
    assert_eq!(intervals(bits(&[(LOW, HIGH)])), [(LOW, HIGH)]);
}

/// Ends at infinity tie with each other as all other ends do: naive code that compares with
/// a sentinel leaves a span from −∞ to −∞.
#[test]
fn whole_lines_cancel() {
    let whole = [Span::whole_line(Face(0))];
    let some = spans(&[(1, 2), (4, 5)], 10);
    let infinity = f32::INFINITY;
    let around = [(-infinity, 1.0), (2.0, 4.0), (5.0, infinity)];
    assert_eq!(ends(&merged(Operation::DIFFERENCE, [&[], &whole, &some])), around);
    assert_eq!(ends(&merged(Operation::DIFFERENCE, [&[], &whole, &whole])), []);
    assert_eq!(ends(&merged(Operation::DIFFERENCE, [&[], &some, &whole])), []);
    assert_eq!(ends(&merged(Operation::UNION, [&[], &some, &whole])), [(-infinity, infinity)]);
    assert_eq!(merged(Operation::INTERSECTION, [&[], &some, &whole]), some);
}

// Trees of slabs, seen by a ray along x: intervals on a line, with the types' own capacities.

type Leaf = Slab<f64>;

fn leaf(interval: Interval) -> Leaf {
    Slab::<f64>::along_x(interval.0.into(), interval.1.into()).unwrap()
}

fn interval() -> impl Strategy<Value = Interval> {
    (LOW..HIGH).prop_flat_map(|a| (Just(a), a + 1..=HIGH))
}

/// A tree as a type, its value made of leaves, and the same expression on bits. The list has the
/// capacity that the type asks for and not one span more.
macro_rules! tree {
    ($name:ident, $Tree:ty, $count:literal, |$s:ident| $solid:expr, |$b:ident| $bits:expr) => {
        proptest! {
            #[test]
            fn $name(leaves in vec(interval(), $count), start in -20i32..=20) {
                let ($s, $b): (Vec<Leaf>, Vec<u32>) =
                    leaves.iter().map(|&i| (leaf(i), bits(&[i]))).unzip();
                let tree: $Tree = $solid;
                let want = intervals($bits);
                let mut list = SpanList::<f64, { <$Tree as Shape>::STACK }>::new();
                for direction in [1, -1] {
                    let origin = vec3(f64::from(start), 0.25, -3.0);
                    let ray = Ray::new(origin, vec3(f64::from(direction), 0.0, 0.0)).unwrap();
                    let mut got: Vec<Interval> = tree
                        .trace(&ray, &mut list)
                        .iter()
                        .map(|span| [span.enter.t, span.exit.t].map(|t| start + direction * t as i32))
                        .map(|[a, b]| (a.min(b), a.max(b)))
                        .collect();
                    got.sort_unstable();
                    prop_assert_eq!(&got, &want);
                    prop_assert!(got.len() <= <$Tree as Shape>::SPANS);
                }
            }
        }
    };
}

tree!(
    union_minus_intersection,
    Difference<Union<Leaf, Leaf>, Intersection<Leaf, Leaf>>,
    4,
    |s| (s[0] | s[1]) - (s[2] & s[3]),
    |b| (b[0] | b[1]) & !(b[2] & b[3])
);
tree!(
    differences_nested_to_the_right,
    Difference<Leaf, Difference<Leaf, Difference<Leaf, Difference<Leaf, Leaf>>>>,
    5,
    |s| s[0] - (s[1] - (s[2] - (s[3] - s[4]))),
    |b| b[0] & !(b[1] & !(b[2] & !(b[3] & !b[4])))
);
tree!(
    intersections_nested_to_the_right,
    Intersection<Leaf, Intersection<Leaf, Intersection<Leaf, Intersection<Leaf, Leaf>>>>,
    5,
    |s| s[0] & (s[1] & (s[2] & (s[3] & s[4]))),
    |b| b[0] & b[1] & b[2] & b[3] & b[4]
);
tree!(
    differences_nested_to_the_left,
    Difference<Difference<Difference<Difference<Leaf, Leaf>, Leaf>, Leaf>, Leaf>,
    5,
    |s| s[0] - s[1] - s[2] - s[3] - s[4],
    |b| b[0] & !b[1] & !b[2] & !b[3] & !b[4]
);
tree!(
    intersection_of_unions,
    Intersection<Union<Union<Leaf, Leaf>, Leaf>, Union<Leaf, Leaf>>,
    5,
    |s| (s[0] | s[1] | s[2]) & (s[3] | s[4]),
    |b| (b[0] | b[1] | b[2]) & (b[3] | b[4])
);
tree!(
    group_minus_group,
    Difference<[Leaf; 4], [Leaf; 6]>,
    10,
    |s| Difference::new([s[0], s[1], s[2], s[3]], [s[4], s[5], s[6], s[7], s[8], s[9]]),
    |b| (b[0] | b[1] | b[2] | b[3]) & !(b[4] | b[5] | b[6] | b[7] | b[8] | b[9])
);
tree!(
    groups_of_composed_solids,
    Difference<[Difference<Leaf, Leaf>; 3], [Intersection<Leaf, Leaf>; 2]>,
    10,
    |s| Difference::new([s[0] - s[1], s[2] - s[3], s[4] - s[5]], [s[6] & s[7], s[8] & s[9]]),
    |b| (b[0] & !b[1] | b[2] & !b[3] | b[4] & !b[5]) & !(b[6] & b[7] | b[8] & b[9])
);
tree!(
    a_group_of_groups_on_the_right,
    Union<Leaf, Intersection<Leaf, [[Leaf; 3]; 2]>>,
    8,
    |s| s[0] | (s[1] & [[s[2], s[3], s[4]], [s[5], s[6], s[7]]]),
    |b| b[0] | b[1] & (b[2] | b[3] | b[4] | b[5] | b[6] | b[7])
);
tree!(
    a_balanced_tree,
    Intersection<
        Union<Difference<Leaf, Leaf>, Difference<Leaf, Leaf>>,
        Difference<Union<Leaf, Leaf>, Intersection<Leaf, Leaf>>,
    >,
    8,
    |s| ((s[0] - s[1]) | (s[2] - s[3])) & ((s[4] | s[5]) - (s[6] & s[7])),
    |b| (b[0] & !b[1] | b[2] & !b[3]) & ((b[4] | b[5]) & !(b[6] & b[7]))
);

/// Counts the spans along x; a solid that outgrew its type's capacity would panic in `push`.
fn count<T: Solid<Scalar = f64>, const N: usize>(solid: &T, mut list: SpanList<f64, N>) -> usize {
    let ray = Ray::new(vec3(-20.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0)).unwrap();
    solid.trace(&ray, &mut list).len()
}

/// Nothing overlaps, so every span of both operands reaches the result, all at once.
#[test]
fn a_union_reaches_all_of_its_spans() {
    type Comb = Union<[Leaf; 3], [Leaf; 3]>;
    let comb = Comb::new([(0, 1), (4, 5), (8, 9)].map(leaf), [(2, 3), (6, 7), (10, 11)].map(leaf));
    assert_eq!(Comb::SPANS, 6);
    assert_eq!(count(&comb, SpanList::<_, { Comb::STACK }>::new()), 6);
}

/// Every hole splits a span: as many pieces as both operands have spans.
#[test]
fn a_difference_reaches_all_of_its_spans() {
    type Drilled = Difference<[Leaf; 2], [Leaf; 3]>;
    let drilled = Drilled::new([(0, 10), (12, 15)].map(leaf), [(1, 2), (4, 5), (7, 8)].map(leaf));
    assert_eq!(Drilled::SPANS, 5);
    assert_eq!(count(&drilled, SpanList::<_, { Drilled::STACK }>::new()), 5);
}

/// Two chains that overlap link by link have a piece for every link but one.
#[test]
fn an_intersection_reaches_all_of_its_spans() {
    type Chain = Intersection<[Leaf; 3], [Leaf; 3]>;
    let chain =
        Chain::new([(0, 3), (4, 7), (8, 11)].map(leaf), [(2, 5), (6, 9), (10, 13)].map(leaf));
    assert_eq!(Chain::SPANS, 5);
    assert_eq!(count(&chain, SpanList::<_, { Chain::STACK }>::new()), 5);
}

/// The last element of a group is merged while all others are in memory, and so is the result.
#[test]
fn a_group_reaches_all_of_its_spans() {
    type Comb = [Leaf; 4];
    let comb = [(0, 1), (2, 3), (4, 5), (6, 7)].map(leaf);
    assert_eq!(Comb::SPANS, 4);
    assert_eq!(count(&comb, SpanList::<_, { Comb::STACK }>::new()), 4);
}

/// The right operand is worked out above the left one's finished spans, and needs its whole
/// working memory there: a capacity of only the results' sizes overflows.
#[test]
fn worst_cases_nest() {
    type Comb = Union<[Leaf; 2], [Leaf; 2]>;
    type Nest = Union<[Leaf; 2], Difference<[Leaf; 1], Comb>>;
    let comb = Comb::new([(1, 2), (5, 6)].map(leaf), [(3, 4), (7, 8)].map(leaf));
    let nest = Nest::new([(-6, -5), (-3, -2)].map(leaf), Difference::new([(0, 9)].map(leaf), comb));
    assert_eq!(Nest::SPANS, 7);
    assert_eq!(count(&nest, SpanList::<_, { Nest::STACK }>::new()), 7);
}
